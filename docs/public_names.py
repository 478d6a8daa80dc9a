"""Public names of the package with what each is, in both languages, for the pages `reference/python`.

What is said is the first line of a docstring; its Chinese stands in the catalogue as that of every text does.
"""

import inspect
from collections.abc import Iterator

import cadgen
from cadgen.figures import JobResult
from cadgen.messages import Message, shown
from cadgen.output.report.notebook import Plotted, Viewed

_OF_RESULTS = (JobResult, Plotted, Viewed)


def first_line(thing: object) -> str:
    """First line of the docstring of a class, a function or a property."""
    return (inspect.getdoc(thing) or "").partition("\n")[0]


def names() -> Iterator[tuple[str, object]]:
    """Full names of all that is public: a class before its methods and properties, own and inherited.

    What every result has stands once, at the end.
    """
    public = [getattr(cadgen, name) for name in cadgen.__all__ if not name.startswith("_")]
    for thing in (*public, *_OF_RESULTS):
        yield f"{thing.__module__}.{thing.__name__}", thing
        for kind in inspect.getmro(thing) if inspect.isclass(thing) else ():
            if kind is thing or (kind.__module__.startswith("cadgen") and kind not in _OF_RESULTS):
                for name, member in vars(kind).items():
                    if not name.startswith("_") and _is_said(member):
                        yield f"{kind.__module__}.{kind.__name__}.{name}", member


def _is_said(member: object) -> bool:
    """Whether a member is a method or a property that says what it is; a field is said with its class."""
    kind = inspect.isroutine(member) or inspect.isdatadescriptor(member) or hasattr(member, "func")
    return kind and bool(first_line(member))


def page(language: str) -> str:
    """Definition list of all names, each leading to its place in the reference, in Markdown.

    Args:
        language: code of the language.
    """
    lines: list[str] = []
    for full, thing in names():
        said = shown(Message(first_line(thing)), language)
        last = full.rpartition(".")[2]
        if inspect.isclass(thing) or (inspect.isfunction(thing) and last in cadgen.__all__):
            lines += ["", f"{{py:obj}}`{last} <{full}>`", f": {said}", ""]
        else:
            lines.append(f"  - {{py:obj}}`{last} <{full}>`{shown(': ', language)}{said}")
    return "\n".join(lines)
