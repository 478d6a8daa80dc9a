"""`manifest.json`: list of the files in an output folder, with their hashes and what was measured on them."""

import hashlib
import json
import stat
from collections.abc import Container, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, Self

from cadgen.errors import brief
from cadgen.figures import Facts
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

    def entry(self) -> Facts:
        """Name, source, overrides and hash of the design, as in a manifest's entry."""
        return Facts(design=self.name, source=self.source, overrides=self.overrides, design_sha256=self.content_hash)


def file_hash(file: Path) -> str:
    """SHA-256 of a file's bytes, hexadecimal."""
    with file.open("rb") as stream:
        return hashlib.file_digest(stream, "sha256").hexdigest()


def file_facts(file: Path) -> Facts:
    """Size (bytes) and hash of a file, as in a manifest's entry."""
    return Facts(bytes=file.stat().st_size, sha256=file_hash(file))


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


def write_manifest(staging: Path, part: str, entry: Facts) -> dict[str, Any]:
    """Write the entry of a run's part into its staging folder; `publishing` adds those of earlier parts.

    Args:
        staging: folder with the files.
        part: name of the part, the key of its entry.
        entry: facts of the part; its `files` map the name of every staged file to facts with a `sha256`. It gets
            `plugins` with their versions if kinds of plug-ins were used.

    Returns:
        The entry as plain values.
    """
    if plugins := used_plugins():
        entry |= Facts(plugins=plugins)
    content = entry.json()
    (staging / NAME).write_text(manifest_text({part: content}), encoding="utf-8")
    return content


def manifest_text(parts: Mapping[str, object]) -> str:
    """Text of a manifest with these parts."""
    return json.dumps({"format": FORMAT, "parts": parts}, indent=2, allow_nan=False) + "\n"


_MADE_FROM = (".step", ".stl", ".3mf", ".dxf", ".nc", ".xyz", ".pdf")
_TABLE = ".csv"


@dataclass(frozen=True)
class ManifestEntry:
    """Entry of a part in a manifest that was read.

    Attributes:
        content: entry as JSON has it, to be written again.
        design_sha256: hash of the design that the part was made from; empty where it states none.
        hashes: SHA-256 of each file that it lists, by name; empty where it states none.
    """

    content: Any
    design_sha256: str
    hashes: Mapping[str, str]

    @classmethod
    def from_json(cls, content: Any) -> Self | None:
        """Entry from plain values; None for values that list no files."""
        files = content.get("files") if isinstance(content, dict) else None
        if not isinstance(files, dict) or not all(isinstance(facts, dict) for facts in files.values()):
            return None
        hashes = {name: str(facts.get("sha256", "")) for name, facts in files.items()}
        return cls(content, str(content.get("design_sha256", "")), hashes)

    @property
    def is_sound(self) -> bool:
        """Whether all names are those of files, and it can be written again; JSON as read here may hold NaN."""
        try:
            json.dumps(self.content, allow_nan=False)
        except ValueError:
            return False
        return all(map(is_plain_name, self.hashes))

    def without(self, names: Container[str]) -> Self:
        """The entry without some of its files."""
        files = {name: facts for name, facts in self.content["files"].items() if name not in names}
        hashes = {name: self.hashes[name] for name in files}
        return replace(self, content={**self.content, "files": files}, hashes=hashes)


def sound_parts(manifest: Path) -> dict[str, ManifestEntry]:
    """Sound entries of a manifest; none if the file is damaged or was not written by cadgen."""
    try:
        entries = read_parts(manifest)
    except (OSError, ValueError):
        return {}
    return {name: entry for name, entry in entries.items() if entry is not None and entry.is_sound}


def older_files(parts: Mapping[str, ManifestEntry]) -> dict[str, str]:
    """Files of parts that are of an earlier version of their design than parts written after them, with its name.

    A table is of an earlier version only, and makes nothing else so: tables of changes with `--set` come after parts.

    Args:
        parts: entries of a manifest by their parts, the last written last.
    """
    older: dict[str, str] = {}
    last: dict[str, str] = {}  # hash of each design by its parts written after those that are looked at
    for entry in reversed(list(parts.values())):
        design = entry.content.get("design")
        if not entry.design_sha256 or not isinstance(design, str):
            continue
        made = [name for name in entry.hashes if Path(name).suffix in _MADE_FROM]
        if made:
            last.setdefault(design, entry.design_sha256)
        if last.get(design, entry.design_sha256) != entry.design_sha256:
            tables = [name for name in entry.hashes if Path(name).suffix == _TABLE]
            older |= dict.fromkeys([*made, *tables], design)
    return {name: of for entry in parts.values() for name in entry.hashes if (of := older.get(name))}


def read_parts(manifest: Path) -> dict[str, ManifestEntry | None]:
    """Entries of a manifest by their parts; None for an entry that lists no files.

    Raises:
        OSError: the file cannot be read.
        ValueError: the file is no manifest of this format.
    """
    try:
        content = json.loads(read_regular(manifest, MOST_BYTES).decode("utf-8"))
        if content["format"] != FORMAT:
            raise ValueError(f"its format is {brief(str(content['format']), 40)}, not {FORMAT}")
        return {name: ManifestEntry.from_json(entry) for name, entry in content["parts"].items()}
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


def unchanged(file: Path, digest: str) -> bool:
    """Whether a file is there with a hash, SHA-256, hexadecimal."""
    try:
        return is_file(file) and file_hash(file) == digest
    except (OSError, ValueError):  # it cannot be read, or no file can have that name
        return False
