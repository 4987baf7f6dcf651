"""Checks of the user's integrand, a `wp.func`, and its conversion to the signature that the kernels call."""

from collections.abc import Callable, Iterator
from ctypes import Structure
from dataclasses import dataclass
from hashlib import sha256
from inspect import signature
from typing import Any

import numpy as np
import warp as wp

from warpsample.estimate.source.content import function_content
from warpsample.estimate.source.definitions import NUMBERS, latest, names_in, naming_function, returned
from warpsample.host.arguments import quote
from warpsample.host.arrays import cpu
from warpsample.host.device_memory import Loan, at_home
from warpsample.host.locks import once
from warpsample.host.neighbours import describe_type

WANTED = "a wp.func (w: wp.vec3[, lobe: funcs.Lobe[, data: the struct of `data`]]) -> float or wp.vec3, annotated"


@wp.struct
class Lobe:
    """Surface point and ray density, passed to a user-defined integrand as the second argument.

    normal: Unit normal in world coordinates.
    row: Row of the point in the call.
    point: Global id of the point.
    pdf: Density of the direction, in the distribution's measure. The mean of f / pdf over the lobe is the integral of f.
    """

    normal: wp.vec3
    row: wp.int32
    point: wp.uint64
    pdf: wp.float32


@once
def density_setter(reads_pdf: bool) -> wp.Function:
    """Build the Warp function that sets `Lobe.pdf` to the density of a direction, if the user's integrand reads `pdf`."""
    if reads_pdf:

        @wp.func
        def with_pdf(lobe: Lobe, pdf: wp.float32):
            """Return a copy of the integrand's argument `lobe` with the field `pdf` set to the density of a direction."""
            own = lobe
            own.pdf = pdf
            return own

    else:

        @wp.func
        def with_pdf(lobe: Lobe, pdf: wp.float32):
            """Return the integrand's argument `lobe` unchanged, for integrands that do not read its field `pdf`."""
            return lobe

    return with_pdf


@wp.struct
class NoData:
    """Empty struct, passed as `data` to integrands without data."""

    nothing: wp.int32


_DIGITS = 16  # hexadecimal digits of the content in the name of a function, which enters Warp's hash of a kernel


@dataclass(frozen=True)
class Integrand:
    """User-defined function to integrate over directions, checked, together with the data that it reads.

    Attributes:
        function: Warp function (direction, Lobe, data) -> weight of an unoccluded ray, a vec3.
        channels: Number of components of the vec3 that are used, 1 or 3.
        data: Third argument of the function: an instance of `struct`, or its ctypes structure.
        struct: Type of the data, a wp.struct.
        constant: Whether the function is (1, 0, 0) everywhere.
        binary: Whether the function is (1, 0, 0) or 0 everywhere.
        reads_pdf: Whether the function reads the density `Lobe.pdf`.
        sparse: Whether the function is 0 where the cosine to the normal is below 2^-12, which holds for many rays.
        arrays: (name, array) pairs of the data's fields that hold addresses of NumPy arrays.
    """

    function: wp.Function
    channels: int
    data: Any
    struct: Any
    constant: bool = False
    binary: bool = False
    reads_pdf: bool = False
    sparse: bool = False
    arrays: tuple[tuple[str, np.ndarray], ...] = ()

    def data_for(self, loan: Loan) -> Any:
        """Return the integrand's data as a kernel argument, with all arrays copied to the kernel's device if necessary."""
        if not isinstance(self.data, Structure):
            return (self.data if loan.memory.in_place else with_arrays(self.data, loan.clone)).__ctype__()
        data = type(self.data).from_buffer_copy(self.data)
        for name, array in self.arrays:
            setattr(data, name, loan.lend(array))
        return data


def integrand_of(function: Any, data: Any = None, argument: str = "integrand", device: wp.Device | None = None) -> Integrand:
    """Check a user's function and data, and return the `Integrand` for a device, by default the CPU.

    Later changes of the function's globals or of the data's fields do not change the `Integrand`.

    Raises:
        TypeError: the function or the data cannot be integrated; the message names the argument.
        ValueError: an array in the data is neither on the CPU nor on the device, or is not set.
    """
    data, struct = _own(data, device or cpu())
    if not isinstance(function, wp.Function) or function.func is None:
        raise TypeError(f"{argument}: got {quote(function)}, want {WANTED}")
    function = latest(function)
    names = list(signature(function.func).parameters)
    missing = [name for name in names if name not in function.input_types]
    if missing:
        raise TypeError(f"{argument}: got a function whose {missing[0]} has no type, want {WANTED}")
    known = [wp.vec3, Lobe] if data is None else [wp.vec3, Lobe, struct]
    given = list(function.input_types.values())
    if not given or given != known[: len(given)]:
        shown = ", ".join(f"{name}: {_name(kind)}" for name, kind in function.input_types.items())
        most = ", ".join(_name(kind) for kind in known)
        if given[:2] == known[:2] and len(given) == 3:
            got, wants = "None" if data is None else _name(struct), _name(given[2])
            if got == wants:
                wants = f"the {wants} that {argument} takes; define the struct, the function and the data again"
                raise TypeError(f"data: got a struct {got} of another definition, want {wants}")
            raise TypeError(f"data: got {got}, want {wants}, which {argument} takes")
        raise TypeError(f"{argument}: got a function of ({shown}), want {WANTED}; here ({most})")
    if data is not None and len(given) < len(known):
        raise TypeError(
            f"data: got {_name(struct)} for a function that takes none, want a function with a third argument for the "
            "data, or None"
        )
    if data is not None:
        _check_arrays_are_set(data, names_in(function))
    colour = _returns_colour(function, argument)
    with naming_function(argument):
        content = sha256(repr(function_content(function)).encode()).hexdigest()
    form = _in_one_form(function, struct, len(given), colour, content)
    reads_pdf = len(given) > 1 and "pdf" in names_in(function)
    return Integrand(form, 3 if colour else 1, NoData() if data is None else data, struct, reads_pdf=reads_pdf)


def _own(data: Any, device: wp.Device) -> tuple[Any, Any]:
    """Return a shallow copy of the user's struct instance, and its wp.struct type."""
    if data is None:
        return None, NoData
    struct = getattr(data, "_cls", None)  # the type that annotates a kernel's argument
    if struct is None or not hasattr(data, "__ctype__"):
        raise TypeError(f"data: got {quote(data)}, want an instance of a wp.struct, or None")
    own = data._cls()
    own.assign(data)
    for name, array in _arrays_in(own):
        if array is not None and not (array.device.is_cpu or array.device == device):
            wants = "cpu" if device.is_cpu else f"cpu or {device}"
            raise ValueError(f"data: got an array {name} on {array.device}, want an array on {wants}")
        if not isinstance(array, wp.array | None) and not at_home(device):
            raise TypeError(f"data: got {describe_type(array)} as {name}, want a wp.array for {device}")
    return own, struct


def _check_arrays_are_set(data: Any, names: set[str]) -> None:
    """Raise ValueError if an array field in `names` is not set: a kernel would read from address 0."""
    for name, array in _arrays_in(data):
        if array is None and name.rpartition(".")[2] in names:
            raise ValueError(
                f"data: got {_name(data._cls)} whose array {name} is not set, want an array, which may be empty"
            )


def _arrays_in(data: Any, within: str = "") -> Iterator[tuple[str, Any]]:
    """Yield the (name, array) pairs of a struct and its nested structs; an unset array is None."""
    for name in data._cls.vars:
        value = getattr(data, name)
        if hasattr(value, "_cls"):
            yield from _arrays_in(value, f"{within}{name}.")
        elif value is None or isinstance(getattr(value, "device", None), wp.Device):  # NumPy scalars have device "cpu"
            yield within + name, value


def with_arrays(data: Any, take: Callable[[wp.array], wp.array]) -> Any:
    """Return a copy of a struct and its nested structs with each array replaced by `take(array)`."""
    made = data._cls()
    for name in data._cls.vars:
        value = getattr(data, name)
        if hasattr(value, "_cls"):
            value = with_arrays(value, take)
        setattr(made, name, take(value) if isinstance(value, wp.array) else value)
    return made


def _returns_colour(function: wp.Function, argument: str) -> bool:
    """Return True if a user's integrand returns a vec3, False if it returns a number; raise TypeError otherwise.

    A function without a return annotation is called once.
    """
    kind = returned(function)
    if kind is None:
        try:
            kind = type(function(wp.vec3(0.0, 0.0, 1.0)))
        except Exception as error:  # any error of the user's code; and parts of Warp, as wp.where, work in kernels alone
            raise TypeError(
                f"{argument}: got a function without a return type that cannot be called with a direction "
                f"({error}), want {WANTED}"
            ) from error
    if kind not in (wp.vec3, *NUMBERS):
        raise TypeError(f"{argument}: got a function that returns {_name(kind)}, want {WANTED}")
    return kind is wp.vec3


def _name(kind: Any) -> str:
    name = getattr(kind, "key", None) or getattr(kind, "__name__", str(kind))
    return "vec3" if kind is wp.vec3 else name


@wp.func
def _as_vector(x: wp.vec3) -> wp.vec3:
    return x


@wp.func
def _number_as_vector(x: Any) -> wp.vec3:
    return wp.vec3(wp.float32(x), 0.0, 0.0)


@once
def _in_one_form(function: wp.Function, struct: Any, count: int, colour: bool, content: str) -> wp.Function:
    """Wrap an integrand of 1 to 3 arguments that returns a number or a vec3 as a function (w, lobe, data) -> vec3.

    A number becomes (number, 0, 0). The wrapper's name contains `content`, so that changed functions get another kernel.
    """
    name, vector = f"integrand_{content[:_DIGITS]}", _as_vector if colour else _number_as_vector
    if count == 1:

        @wp.func(name=name)
        def value(w: wp.vec3, lobe: Lobe, data: struct):
            return vector(function(w))

    elif count == 2:

        @wp.func(name=name)
        def value(w: wp.vec3, lobe: Lobe, data: struct):
            return vector(function(w, lobe))

    else:

        @wp.func(name=name)
        def value(w: wp.vec3, lobe: Lobe, data: struct):
            return vector(function(w, lobe, data))

    return value
