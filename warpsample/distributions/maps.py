"""Record of the `wp.func`s of a distribution that kernels call: the map, the density and the inverse."""

from dataclasses import dataclass

import warp as wp

from warpsample.distributions.parameters import bind_parameters

_VECTORS = {2: wp.vec2, 3: wp.vec3}


@dataclass(frozen=True)
class Maps:
    """Record of a distribution's `wp.func`s for kernels; `sample`, `pdf` and `invert` take the parameters last.

    The functions of a lobe that is made from another lobe take the struct `Parameters` in place of the parameters.

    Attributes:
        sample: map of u (vec2 in [0, 1)^2) to a direction w about +z (vec3 of unit length; in the plane, vec2 about +y).
        pdf: density of w in the distribution's measure; 0 outside the support.
        invert: inverse of `sample`, from w to u; None if `sample` maps several u to one w.
        about: (unit normal n, u, Parameters) -> (world direction, pdf), for a method that needs no tangent frame; None
            otherwise.
        redraw: replacement for `about`, with the same signature, where the pdf from `about` is below `redraw_below` and
            `about` is imprecise; None if never needed.
        redraw_below: pdf below which `redraw` replaces `about`.
        draw: map of u to (w, density) as a vec4, where the density is more precise with the numbers that `sample` computes
            than from w alone; None if `pdf` is as precise.
        per_cosine: density of a visible normal m, divided by the cosine between m and the view, D(m) / σ(v); 0 below the
            surface. None for distributions of other directions.
    """

    sample: wp.Function
    pdf: wp.Function
    invert: wp.Function | None = None
    about: wp.Function | None = None
    redraw: wp.Function | None = None
    redraw_below: float = 0.0
    draw: wp.Function | None = None
    per_cosine: wp.Function | None = None

    def bound(self, count: int, width: int, start: int) -> "Maps":
        """Return versions of the functions that read the distribution's parameters from a `Parameters` value.

        The versions have the arguments (u, parameters) or (w, parameters).

        Args:
            count: number of parameters.
            width: number of components of w.
            start: index of the first number of the parameters.
        """
        kinds = {"sample": 2, "pdf": width, "invert": width, "draw": 2, "per_cosine": width}
        functions = {name: (getattr(self, name), _VECTORS[size]) for name, size in kinds.items()}
        return Maps(**{name: f and bind_parameters(f, kind, count, start) for name, (f, kind) in functions.items()})
