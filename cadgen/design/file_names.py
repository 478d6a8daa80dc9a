"""Names that files can have on every system."""

import re
from unicodedata import normalize

from cadgen.messages import Message

_PLAIN = re.compile(r"[^\W_][\w.-]*")  # letters of any script
_LONGEST = 64  # letters; of three bytes each in a file system, with the ending, some 200 of the 255 that it allows
# What Windows keeps for devices, in capitals or not, with whatever follows a first dot.
_DEVICES = re.compile(r"(con|prn|aux|nul|com[0-9¹²³]|lpt[0-9¹²³])(\..*)?", re.IGNORECASE)


def name_fault(name: str) -> str:
    """Fault of a name for files, as a clause after "it must"; empty if the name has no fault.

    Args:
        name: name of a design or a part, without the ending of a file.
    """
    if not _PLAIN.fullmatch(name) or len(name) > _LONGEST or normalize("NFC", name) != name:
        return Message("be 1 to 64 letters, digits, dots, dashes and underscores, and begin with a letter or digit")
    if _DEVICES.fullmatch(name):
        return Message(
            "be another one, for on Windows {device} is a device: add to it, such as {name}_1",
            device=name.partition(".")[0],
            name=name[:3],
        )
    if name.endswith("."):
        return Message("not end in a dot, which Windows takes off: remove it")
    return ""


def usable_name(text: str) -> str:
    """The nearest name without a fault: of a design that has none of its own, after its file.

    Args:
        text: any, such as a file's name without its ending.
    """
    name = re.sub(r"[^\w.-]+", "_", normalize("NFC", text)).lstrip("._-")[:64].rstrip(".") or "design"
    return f"design_{name}"[:64].rstrip(".") if name_fault(name) else name
