"""Directive `.. command:: bake`: description, arguments and options of a command."""

import re
from typing import Any, Literal, get_args, get_origin

import typer
from docutils import nodes
from docutils.parsers.rst import Directive
from docutils.statemachine import StringList

from warpsample.cli.commands import app

_CODE = re.compile(r"(--[a-z][a-z-]*|tcp://\S*\w)")


def commands() -> dict[str, Any]:
    """Return all commands of `warpsample`, keyed by name."""
    return dict(typer.main.get_command(app).commands)


class Command(Directive):
    """Directive that inserts the description, arguments and options of a command, from its help."""

    required_arguments = 1

    def run(self) -> list[nodes.Node]:
        """Return the document nodes of a command: its text, and its options as targets of links and of the search."""
        command = commands()[self.arguments[0]]
        lines = [*(command.help or "").splitlines(), "", f".. program:: warpsample {self.arguments[0]}", ""]
        for parameter in command.params:
            lines += [f".. option:: {', '.join(parameter.opts)}", "", f"   {_describe_parameter(parameter)}", ""]
        made = nodes.container()
        self.state.nested_parse(StringList(lines, source=self.arguments[0]), self.content_offset, made)
        return made.children


def _describe_parameter(parameter: Any) -> str:
    """Return the help text of a command's option, with its choices and its default."""
    words = get_args(parameter.type_descriptor.annotation) if _is_choice(parameter) else ()
    default = parameter.default
    parts = [_CODE.sub(r"``\1``", " ".join((parameter.help or "").replace("*", r"\*").replace("`", "").split()))]
    parts += ["One of " + ", ".join(f"``{word}``" for word in words) + "."] if words else []
    parts += ["Required."] if parameter.required else []
    parts += [f"By default ``{default}``."] if isinstance(default, int | float | str) and default not in (False, "") else []
    return " ".join(parts)


def _is_choice(parameter: Any) -> bool:
    return get_origin(parameter.type_descriptor.annotation) is Literal
