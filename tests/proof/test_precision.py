"""The laws compute in double precision, so their verdicts are the same on every processor."""

import ast
import re
import subprocess
import sys

import numpy as np
import pytest
import scipy.special

import warpsample as ws
from warpsample.proof import laws, verify
from warpsample.statistics.charts import DISK, PLANE, SPHERE

SINGLE = np.array([0.25, 0.5], np.float32)
# Of angles and probabilities in float64: loops of NumPy 1 round by where an array begins, and p-values of n directions add n
# roundings. float32 would leave 1e-7 of an angle, and 1e-9 of the least sensitive p-value.
ROUNDING = 1e-11
# What stands and falls with NumPy's loops, in half a minute.
JUDGES = ("proof/test_precision", "maths/test_numerics", "proof/test_harness", "test_distributions")
AMONG_THEM = "precision or numerics or charts or quadrature or cdf or every_law and Uniform"


@pytest.mark.parametrize(
    "compute",
    [
        lambda: np.sin(SINGLE),
        lambda: np.sin(SINGLE, out=np.zeros(2)),
        lambda: np.sin(SINGLE[0]),
        lambda: np.exp(SINGLE.astype(np.float16)),
        lambda: np.log2(np.arange(2, 4, dtype=np.int16)),
        lambda: np.tanh(SINGLE.astype(np.float64), dtype=np.float32, casting="same_kind"),
        lambda: np.arctan2(SINGLE, 1.0),
        lambda: np.power(SINGLE, 3),
        lambda: np.hypot(SINGLE, SINGLE),
        lambda: np.logaddexp.reduce(SINGLE),
        lambda: np.power.outer(SINGLE, SINGLE),
        lambda: np.exp(1j * SINGLE),
        lambda: np.abs(1j * SINGLE),
        lambda: np.sinc(SINGLE),
        lambda: scipy.special.erf(SINGLE),
    ],
)
def test_single_precision_is_refused(compute):
    refusal = r"test_precision.py:\d+: .* in (float16|float32|complex64), .*: convert to float64"
    with pytest.raises(AssertionError, match=refusal):
        compute()


def test_double_precision_and_what_rounds_alike_everywhere_are_not():
    wide = SINGLE.astype(np.float64)
    assert np.sin(wide).dtype == np.arctan2(SINGLE, wide).dtype == np.float_power(SINGLE, 3).dtype == np.float64
    assert np.sqrt(SINGLE).dtype == np.abs(SINGLE).dtype == np.radians(SINGLE).dtype == np.float32
    assert (np.power(3, 2), np.exp(0), np.log2(np.arange(1, 3)).tolist()) == (9, 1.0, [0.0, 1.0])


def test_what_stands_for_a_ufunc_acts_as_one():
    out = np.full(2, 7.0)
    assert np.sin(np.zeros(2), out=out, where=[True, False]) is out
    assert out.tolist() == [0.0, 7.0]
    assert isinstance(np.sin, np.ufunc)
    assert (np.power.nin, np.sin.__name__) == (2, "sin")
    assert np.logaddexp.reduce(np.zeros(4)) == pytest.approx(np.log(4.0))
    with pytest.raises(TypeError, match="not supported for the input types"):
        np.sin("text")


def test_others_may_compute_as_they_like():
    theirs = eval(compile("lambda: np.sin(x)", "/elsewhere/library.py", "eval"), {"np": np, "x": SINGLE})
    assert theirs().dtype == np.float32


@pytest.mark.parametrize("case", [c for c in verify.cases() if c.symmetric], ids=repr)
def test_judges_of_float32_are_those_of_the_same_numbers_in_float64(case):
    w = case.sample(ws.sample_square("independent", 1, 1000, seed=1)[0])
    wide = w.astype(np.float64)
    chart = {"per steradian": SPHERE, "per unit area": DISK, "per radian": PLANE}[case.measure]
    for judge in (chart.polar, chart.azimuth, laws.azimuth_p_value, laws.azimuth_gap_p_value, laws.length_error):
        assert np.abs(judge(w) - judge(wide)).max() <= ROUNDING
    angles = chart.polar(w).astype(np.float32)
    assert case.cdf(angles).dtype == np.float64
    for judge in (case.cdf, laws.uniform_p_value):
        assert np.abs(judge(angles) - judge(angles.astype(np.float64))).max() <= ROUNDING


def is_literal(node):
    kinds = (ast.Constant, ast.UnaryOp, ast.BinOp, ast.operator, ast.unaryop)
    return all(isinstance(part, kinds) for part in ast.walk(node))


def unseen_powers(source):
    """Powers that the operator or `pow` takes and no wrapper sees: of arrays, maybe, by more than squares and roots.

    What a literal is raised to are counts and exponents, Python's numbers.
    """
    for node in ast.walk(ast.parse(source)):
        match node:
            case ast.BinOp(base, ast.Pow(), exponent):
                rounded_alike = isinstance(exponent, ast.Constant) and exponent.value in (2, 0.5)
                if not (is_literal(base) or rounded_alike):
                    yield ast.unparse(node)
            case ast.AugAssign(_, ast.Pow()) | ast.Call(ast.Name("pow")):
                yield ast.unparse(node)


def test_no_power_is_taken_where_nobody_sees_it(repository):
    files = [file for folder in ("warpsample", "tests", "viz") for file in sorted((repository / folder).rglob("*.py"))]
    assert len(files) >= 100
    found = [(file.name, power) for file in files for power in unseen_powers(file.read_text("utf-8"))]
    assert found == []  # np.float_power computes in float64, np.power is watched
    assert len(list(unseen_powers("a**3; b **= 2; pow(c, 2); d**e; -f**0.25; 2**g; 2.0**-24; h**2; i**0.5"))) == 5


@pytest.mark.thorough
@pytest.mark.parametrize("without", ["AVX-512", "all"])
def test_verdicts_hold_on_lesser_processors(without, repository, child_environment):
    umath = pytest.importorskip("numpy._core._multiarray_umath", reason="NumPy 1 keeps it elsewhere")
    usable = [name for name in umath.__cpu_dispatch__ if umath.__cpu_features__[name]]
    disabled = [name for name in usable if without == "all" or "512" in name or name == "X86_V4"]
    if not disabled:
        pytest.skip("this processor has none of these features, or NumPy does not use them")
    environment = {name: value for name, value in child_environment.items() if not name.startswith(("PYTEST_", "COV_"))}
    files = [f"tests/{name}.py" for name in JUDGES]
    done = subprocess.run(
        [*(sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", "-k", AMONG_THEM), *files],
        cwd=repository,
        env={**environment, "NPY_DISABLE_CPU_FEATURES": " ".join(disabled)},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stdout[-3000:] + done.stderr[-1000:]
    assert int(re.search(r"(\d+) passed", done.stdout)[1]) >= 100
