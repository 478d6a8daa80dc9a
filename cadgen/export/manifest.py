"""`manifest.json`: what stands in an output folder, and what was measured on it."""

import hashlib
import json
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from typing import Any

from cadgen import __version__

NAME = "manifest.json"
FORMAT = 1
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


def file_hash(file: Path) -> str:
    """SHA-256 of a file's bytes, hexadecimal."""
    return hashlib.sha256(file.read_bytes()).hexdigest()


def file_facts(file: Path) -> dict[str, Any]:
    """Size and hash of a file, as entries have them."""
    return {"bytes": file.stat().st_size, "sha256": file_hash(file)}


def versions() -> dict[str, str]:
    """This program's version and those of the libraries that make and read the files."""
    found = {"cadgen": __version__}
    for name in _LIBRARIES:
        try:
            found[name] = version(name)
        except PackageNotFoundError:
            continue
    return found


def write_manifest(staging: Path, out: Path, part: str, entry: dict[str, Any]) -> None:
    """Write the folder's manifest into the staging folder.

    Parts made earlier keep their entries as long as all their files are still there unchanged.

    Args:
        staging: where the new files are.
        out: where they will go, with the manifest of earlier parts.
        part: name of the new part, the key of its entry.
        entry: its facts; `entry["files"]` maps file names to facts with a `sha256`.
    """
    kept = {
        name: earlier
        for name, earlier in _earlier_parts(out / NAME).items()
        if name != part
        and not set(earlier["files"]) & set(entry["files"])
        and all(_unchanged(out / file, facts) for file, facts in earlier["files"].items())
    }
    content = {"format": FORMAT, "parts": {**kept, part: entry}}
    (staging / NAME).write_text(json.dumps(content, indent=2, allow_nan=False) + "\n", encoding="utf-8")


def _earlier_parts(manifest: Path) -> dict[str, Any]:
    """The sound entries of an earlier manifest; a file that is not ours, or is damaged, has none."""
    try:
        content = json.loads(manifest.read_text(encoding="utf-8"))
        parts = content["parts"] if content["format"] == FORMAT else {}
        return {name: part for name, part in parts.items() if _sound(part)}
    except (OSError, ValueError, KeyError, TypeError, AttributeError, RecursionError):
        return {}


def _sound(part: Any) -> bool:
    """Whether an entry has the facts of its files, and could be written again: JSON as read here may hold NaN."""
    try:
        json.dumps(part, allow_nan=False)
    except ValueError:
        return False
    files = part.get("files") if isinstance(part, dict) else None
    return isinstance(files, dict) and all(isinstance(facts, dict) for facts in files.values())


def _unchanged(file: Path, facts: dict[str, Any]) -> bool:
    try:
        return file.is_file() and file_hash(file) == facts.get("sha256")
    except (OSError, ValueError):  # it cannot be read, or no file can have that name
        return False
