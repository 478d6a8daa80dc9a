"""`manifest.json`: list of the files in an output folder, with their hashes and what was measured on them."""

import hashlib
import json
import stat
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from cadgen.errors import brief
from cadgen.reading import read_regular
from cadgen.registry import used_plugins
from cadgen.version import __version__

if TYPE_CHECKING:
    from cadgen.design.schema import TrainDesign

NAME = "manifest.json"
FORMAT = 1
MOST_BYTES = 64_000_000  # of a manifest: thousands of parts
_LIBRARIES = (
    "build123d",
    "cadquery-ocp-novtk",
    "ezdxf",
    "lib3mf",
    "manifold3d",
    "matplotlib",
    "numpy",
    "scipy",
    "trimesh",
)


@dataclass(frozen=True)
class Origin:
    """Design that something was computed from.

    Attributes:
        name: name of the design.
        source: name of the file that it was read from, without its folder.
        overrides: changes by `--set`, in order.
        content_hash: SHA-256 of its values, hexadecimal.
    """

    name: str
    source: str
    overrides: tuple[str, ...]
    content_hash: str

    @classmethod
    def of(cls, design: "TrainDesign") -> "Origin":
        """Origin of what is computed from a design."""
        return cls(design.name, design.source, design.overrides, design.content_hash)

    def facts(self) -> dict[str, Any]:
        """Name, source, overrides and hash of the design, as in a manifest's entry."""
        return {
            "design": self.name,
            "source": self.source,
            "overrides": list(self.overrides),
            "design_sha256": self.content_hash,
        }


def file_hash(file: Path) -> str:
    """SHA-256 of a file's bytes, hexadecimal."""
    with file.open("rb") as stream:
        return hashlib.file_digest(stream, "sha256").hexdigest()


def file_facts(file: Path) -> dict[str, Any]:
    """Size (bytes) and hash of a file, as in a manifest's entry."""
    return {"bytes": file.stat().st_size, "sha256": file_hash(file)}


def versions() -> dict[str, str]:
    """This program's version and those of the libraries that make and read the files."""
    from importlib.metadata import PackageNotFoundError, version  # a twentieth of a second that most commands save

    installed = {"cadgen": __version__}
    for name in _LIBRARIES:
        try:
            installed[name] = version(name)
        except PackageNotFoundError:
            continue
    return installed


def write_manifest(staging: Path, part: str, entry: dict[str, Any]) -> None:
    """Write the entry of a run's part into its staging folder; `publishing` adds those of earlier parts.

    Args:
        staging: folder with the files.
        part: name of the part, the key of its entry.
        entry: facts of the part; `entry["files"]` maps the name of every staged file to facts with a `sha256`. It
            gets a key `plugins` with their versions if kinds of plug-ins were used.
    """
    if plugins := used_plugins():
        entry["plugins"] = dict(plugins)
    (staging / NAME).write_text(manifest_text({part: entry}), encoding="utf-8")


def manifest_text(parts: Mapping[str, Any]) -> str:
    """Text of a manifest with these parts."""
    return json.dumps({"format": FORMAT, "parts": dict(parts)}, indent=2, allow_nan=False) + "\n"


def sound_parts(manifest: Path) -> dict[str, Any]:
    """Sound entries of a manifest; none if the file is damaged or was not written by cadgen."""
    try:
        return {name: part for name, part in read_parts(manifest).items() if _sound(part)}
    except (OSError, ValueError):
        return {}


def read_parts(manifest: Path) -> dict[str, Any]:
    """Entries of a manifest, unchecked.

    Raises:
        OSError: the file cannot be read.
        ValueError: the file is no manifest of this format.
    """
    try:
        content = json.loads(read_regular(manifest, MOST_BYTES).decode("utf-8"))
        if content["format"] != FORMAT:
            raise ValueError(f"its format is {brief(str(content['format']), 40)}, not {FORMAT}")
        return dict(content["parts"].items())
    except (KeyError, TypeError, AttributeError, RecursionError):
        raise ValueError("it is no manifest of cadgen") from None


def is_plain_name(name: str) -> bool:
    """Whether a name is that of a file in the folder itself, without a path."""
    return name not in ("", ".", "..") and not set(name) & {"/", "\\", "\0"} and Path(name).name == name


def is_file(file: Path) -> bool:
    """Whether this is a file itself, not a link to one, a pipe or a device."""
    try:
        return stat.S_ISREG(file.lstat().st_mode)
    except ValueError:  # no file can have that name
        return False


def unchanged(file: Path, facts: dict[str, Any]) -> bool:
    """Whether a file is there with the hash that its entry has."""
    try:
        return is_file(file) and file_hash(file) == facts.get("sha256")
    except (OSError, ValueError):  # it cannot be read, or no file can have that name
        return False


def _sound(part: Any) -> bool:
    """Whether an entry has the facts of its files and can be written again; JSON as read here may hold NaN."""
    try:
        json.dumps(part, allow_nan=False)
    except ValueError:
        return False
    files = part.get("files") if isinstance(part, dict) else None
    return isinstance(files, dict) and all(
        is_plain_name(name) and isinstance(facts, dict) for name, facts in files.items()
    )
