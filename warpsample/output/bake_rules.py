"""Checks that the options of a `warpsample bake` command fit together, before any file is read."""

from collections.abc import Callable, Iterator
from typing import Any

from warpsample.estimate.quantities.record import Quantity
from warpsample.output.bake_table import (
    CITY,
    FILES,
    MATRIX_FILES,
    MEAN_FILES,
    MESH,
    OPTIONS,
    RASTER,
    STORE,
    TEXTURE,
    describe_scope,
    join_words,
)
from warpsample.output.baked import BakeRun
from warpsample.output.quantities import check_options, quantities, quantity_of
from warpsample.texture.materials import OCCLUSION, THICKNESS, slot_for_quantity

_SHARES = (0.0, 1.0)
"""Range of the values that a .png can hold as a texture."""


def check_table(run: BakeRun) -> None:
    """Check that the source, the output, the quantity and all options of a `warpsample bake` run are compatible.

    Raises:
        ValueError: a combination that the table excludes; the message names the option and what it applies to.
    """
    quantity = quantity_of(run.quantity)
    _check_output(run, quantity)
    for name, value in run.arguments.items():
        _check_option(run, quantity, name, value)
    check_options(quantity, run.options)
    for flaw in _flaws(run, quantity):
        raise ValueError(flaw)


def can_hold(quantity: Quantity, source: str, suffix: str) -> bool:
    """Return whether a file with this suffix can hold a quantity, computed on a mesh, a city, a raster or a texture."""
    if suffix not in FILES[source]:
        return False
    if source == RASTER:
        return bool(quantity.on_rasters)
    if quantity.is_matrix or suffix == ".mtx":
        return quantity.is_matrix and source != TEXTURE and suffix in MATRIX_FILES
    if suffix == STORE:
        return quantity.in_stores
    return source != TEXTURE or suffix in (".exr", ".npz") or _fits_picture(quantity, suffix)


def _fits_picture(quantity: Quantity, suffix: str) -> bool:
    """Return whether a texture of 8 or 16 bits can show a quantity: a direction, a thickness in glTF, or a share."""
    slot = slot_for_quantity(quantity.name)
    is_thickness = slot is THICKNESS and suffix != ".png"
    return slot.directed or is_thickness or getattr(quantity.result, "possible", None) == _SHARES


def _check_output(run: BakeRun, quantity: Quantity) -> None:
    """Raise a ValueError if the output's suffix is unknown, or its file cannot hold the quantity."""
    source, suffix = run.kind, run.output.suffix
    if can_hold(quantity, source, suffix):
        return
    if files := [each for each in FILES[source] if can_hold(quantity, source, each)]:
        what = {MESH: "", TEXTURE: " for --texture"}.get(source, f" for {source}")
        what = f" for {quantity.name}" if suffix in FILES[source] else what
        ends = f"{' '.join(files)}, in lower case" if suffix.lower() in files and suffix not in files else " ".join(files)
        raise ValueError(f"--output: got {str(run.output)!r}{what}, want a file that ends in one of {ends}")
    names = [name for name, other in quantities().items() if any(can_hold(other, source, each) for each in FILES[source])]
    raise ValueError(f"--quantity: got {quantity.name!r} for {source}, want one of {', '.join(names)}")


def _check_option(run: BakeRun, quantity: Quantity, name: str, value: Any) -> None:
    """Raise a ValueError if an option does not apply to the source, the output or the quantity of a run."""
    option, source = OPTIONS[name], run.kind
    given = f"--{name.replace('_', '-')}: got {value} for"
    if source not in option.where:
        what = "--texture" if source == TEXTURE else run.mesh.name
        if source == MESH and MESH in OPTIONS[name].where:
            what = run.output.name
        raise ValueError(f"{given} {what}; the option applies only to {describe_scope(name)}")
    if run.output.suffix not in option.where[source]:
        raise ValueError(f"{given} {run.output.name}; the option applies only to {describe_scope(name, source)}")
    if option.needs and not quantity.takes(option.needs):
        names = join_words(each for each, other in quantities().items() if other.takes(option.needs))
        raise ValueError(f"{given} {quantity.name}; the option applies only to {names}")


def _flaws(run: BakeRun, quantity: Quantity) -> Iterator[str]:
    """Yield an error message for each pair of options, or option and quantity, that exclude each other."""
    for is_wrong, describe in _PAIRS:
        if is_wrong(run, quantity):
            yield describe(run, quantity)


def is_by_parts(run: BakeRun) -> bool:
    """Return whether a `warpsample bake` command writes means over parts of the mesh instead of values at points."""
    is_mean = run.kind == CITY and run.output.suffix in MEAN_FILES[CITY] and (run.output.suffix != ".png" or run.at is None)
    return run.by is not None or is_mean


def _places(run: BakeRun) -> list[str]:
    """Return the given options among --cluster, --processes and --workers, which exclude each other for stores."""
    given = {name: run.arguments.get(name) for name in ("cluster", "processes", "workers")}
    return [f"--{name} {value}" for name, value in given.items() if value is not None]


def _other_city(run: BakeRun) -> bool:
    """Return whether one of source and output is a .json and the other a .jsonl, the two kinds of CityJSON files."""
    cities = set(MEAN_FILES[CITY]) - set(MEAN_FILES[MESH]) - {".png"}
    return {run.mesh.suffix, run.output.suffix} == cities


_PAIRS: tuple[tuple[Callable[[BakeRun, Quantity], bool], Callable[[BakeRun, Quantity], str]], ...] = (
    (
        lambda run, _: "refine" in run.arguments and run.reflectance is None,
        lambda run, _: (
            f"--refine: got {run.arguments['refine']} without --reflectance, want both; only light that faces reflect needs "
            "parts of faces"
        ),
    ),
    (
        lambda run, _: run.points is not None and run.at is not None,
        lambda run, _: f"--points: got {run.points} together with --at {run.at}, want only one of the two",
    ),
    (
        lambda run, _: run.at == "vertices" and is_by_parts(run),
        lambda run, _: f"--at: got {run.at} for means over parts, want faces, or --points",
    ),
    (
        lambda run, _: _other_city(run),
        lambda run, _: (
            f"--output: got {run.output.name!r} for {run.mesh.name!r}, want a file that ends in {run.mesh.suffix}, too"
        ),
    ),
    (
        lambda run, quantity: quantity.is_matrix and run.report is not None,
        lambda run, quantity: f"--report: got {run.report} for {quantity.name}, want a quantity with a few values per point",
    ),
    (
        lambda run, _: run.kind == MESH and run.output.suffix == STORE and len(_places(run)) > 1,
        lambda run, _: f"{_places(run)[0]}: got it together with {_places(run)[1]}, want one of the two",
    ),
    (
        lambda run, _: ("high" in run.arguments) != ("cage" in run.arguments),
        lambda *_: (
            "--high: got one of --high and --cage, want both: the finer mesh, and its largest distance from the first mesh"
        ),
    ),
    (
        lambda run, _: (
            run.kind == TEXTURE
            and run.output.suffix in (".glb", ".gltf")
            and run.mesh.suffix.lower() not in (".glb", ".gltf")
        ),
        lambda run, _: (
            f"--output: got {run.output.name!r} for {run.mesh.name!r}, want .png, .exr or .npz; only a glTF input becomes a "
            f"{run.output.suffix}"
        ),
    ),
    (
        lambda run, quantity: run.arguments.get("normals") == "lifted" and slot_for_quantity(quantity.name) is THICKNESS,
        lambda *_: "--normals: got lifted for thickness, want face or smooth: its rays start beneath the face",
    ),
    (
        lambda run, quantity: "strength" in run.arguments and slot_for_quantity(quantity.name) is not OCCLUSION,
        lambda run, quantity: (
            f"--strength: got {run.arguments['strength']} for {quantity.name}; the option applies only to "
            "occlusion in a .glb"
        ),
    ),
    (
        lambda run, quantity: run.arguments.get("depth", "8") != "8" and slot_for_quantity(quantity.name).directed,
        lambda run, quantity: f"--depth: got {run.arguments['depth']} for {quantity.name}, want 8, or an .exr",
    ),
)
"""Pairs that do not go together: (test of a run and its quantity, function that returns the message)."""
