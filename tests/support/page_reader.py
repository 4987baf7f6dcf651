"""A reader who types the blocks of a page."""

from types import ModuleType

_SET_UP = ["python3 -m venv .venv && . .venv/bin/activate", "pip install '.[viz]'"]  # .ci/run


class Reader:
    """Reader who types the blocks of a page in one folder: Python into one file, and commands.

    They run in this process, which has loaded the kernels already.
    """

    def __init__(self, name, folder, call):
        self.module = ModuleType(f"page_{name.replace('/', '_')}")
        self.file, self.call = folder / f"{self.module.__name__}.py", call

    def python(self, code, capsys):
        written = self.file.read_text() if self.file.exists() else ""
        self.file.write_text(f"{written}{code}")
        exec(compile("\n" * written.count("\n") + code, str(self.file), "exec"), vars(self.module))
        return capsys.readouterr().out

    def sh(self, code, capsys):
        said = []
        for line in code.splitlines():
            if line not in _SET_UP:
                program, *words = line.split()
                assert program == "warpsample", line
                status, out, err = self.call(*words)
                assert status == 0, err
                said.append(out)
        return "".join(said)
