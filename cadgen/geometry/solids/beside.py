"""A process that has loaded the CAD kernel, beside this one, since that takes as long as to plan a train."""

from contextlib import AbstractContextManager
from importlib import import_module

from cadgen.aside import Ready, Standby

_KERNEL = Standby("kernel")


def kernel_beside(*, wanted: bool = True) -> AbstractContextManager[Ready]:
    """Load the kernel in a process of its own, beside a block; a block within it gets the same process.

    Args:
        wanted: whether the kernel will be needed at all.
    """
    return _KERNEL.ready(_load, wanted=wanted)


def kernel_process() -> Ready | None:
    """The process that has loaded the kernel, or is loading it, beside this block; None if there is none."""
    return _KERNEL.current


def _load() -> None:
    for module in ("gear_text", "train"):
        import_module(f"cadgen.geometry.solids.{module}")
