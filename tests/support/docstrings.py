"""What a docstring says by its sections, what it lacks, and whether its example prints what it says."""

import doctest
import inspect
import re

import numpy as np
import warp as wp

import warpsample as ws

EXAMPLE = "Example of one to five lines, with what it prints"
SECTIONS = re.compile(r"^(Args|Returns|Raises|Warns|Attributes|Example|Source):", re.MULTILINE)


def sections(function):
    """{heading: text} of a docstring."""
    _, *parts = SECTIONS.split(inspect.getdoc(function))
    return dict(zip(parts[::2], parts[1::2], strict=True))


def failures(name, text):
    """What a doctest says of an example; "" if each line prints what it says."""
    test = doctest.DocTestParser().get_doctest(text, {"ws": ws, "np": np, "wp": wp}, name, None, None)
    said = []
    doctest.DocTestRunner(verbose=False).run(test, out=said.append)
    return "".join(said)


def flaws(function):
    """What a docstring lacks."""
    found, signature = sections(function), inspect.signature(function)
    taken = [str(p).split(":")[0].split("=")[0].strip() for key, p in signature.parameters.items() if key != "self"]
    lacking = [f"Args: {key}" for key in taken if f"\n    {key}: " not in found.get("Args", "")]
    if signature.return_annotation not in (None, inspect.Signature.empty) and "Returns" not in found:
        lacking.append("Returns")
    example = doctest.DocTestParser().get_examples(found.get("Example", ""))
    if not 1 <= len(example) <= 5 or not any(line.want for line in example):
        lacking.append(EXAMPLE)
    return lacking
