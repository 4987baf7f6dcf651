"""Base class of lobes of light that a rough surface scatters: directions that follow from a lobe of normals and a view."""

from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np

from warpsample.distributions.by_point.rows import copy_views
from warpsample.distributions.maps import Maps
from warpsample.distributions.parameters import MOST_NUMBERS
from warpsample.distributions.record import Distribution
from warpsample.host.arguments import quote
from warpsample.host.arrays import as_unit, as_view

_WANTS = "a distribution of normals in space, such as VisibleGGX(alpha=0.3)"


@dataclass(frozen=True)
class ScatteredLight(Distribution):
    """Base class of lobes of scattered light, with a nested lobe of normals `lobe` and a direction `view` to the viewer.

    Subclasses build their functions in `bound_maps`, from those of the nested lobe.
    """

    lobe: Distribution
    view: tuple[float, float, float]

    support = "sphere"
    parameters: ClassVar[tuple[str, ...]] = ("view",)
    symmetric = False
    polar = False
    below = False
    """Whether a view may come from below the surface."""

    def __post_init__(self) -> None:
        """Check the nested lobe and the view, and normalise the view."""
        if not isinstance(self.lobe, Distribution) or self.lobe.width != 3:
            raise TypeError(f"lobe: got {quote(self.lobe)}, want {_WANTS}")
        super().__post_init__()
        if not (isinstance(self.view, np.ndarray) and self.view.ndim == 2):
            object.__setattr__(self, "view", (as_unit if self.below else as_view)(self.view, "view"))
        if self.size > MOST_NUMBERS:
            raise ValueError(f"lobe: got {self.size} numbers with those of all nested lobes, want at most {MOST_NUMBERS}")

    def _dimensions(self, i: int) -> int:
        """Return the number of dimensions of a constant for parameter i: 1 for the view (first), 0 for scalars."""
        return 1 if i == 0 else 0

    def _copy_rows(self, name: str, rows: np.ndarray) -> np.ndarray:
        """Return a copy of the values by point of parameter `name`, with views of unit length.

        Views that equal those of the nested lobe share the memory of the nested lobe's views.
        """
        if name != "view":
            return super()._copy_rows(name, rows)
        return copy_views(rows, self.below, same=getattr(self.lobe, "view", None))

    @property
    def maps(self) -> Maps:  # type: ignore[override]
        """The `wp.func`s of the distribution for kernels, with arguments (u or w, Parameters)."""
        return self.bound_maps()

    @property
    def variates(self) -> int:  # type: ignore[override]
        """Number of coordinates of u that the map uses: that of the nested lobe."""
        return self.lobe.variates

    @property
    def view_of_kernels(self) -> Any:
        """The view as the kernels round it, (3,) float64."""
        return np.array(self.view, np.float32).astype(np.float64)
