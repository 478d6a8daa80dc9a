"""Plug-ins without an installation: a folder with a distribution's facts, which is put on the path."""

from collections.abc import Mapping
from pathlib import Path


def install(folder: Path, name: str, version: str, points: Mapping[str, Mapping[str, str]]) -> None:
    """Write the facts of a distribution into a folder that is to be on the path.

    Args:
        folder: the folder.
        name: name of the distribution.
        version: its version.
        points: value of each entry point, by group and name.
    """
    facts = folder / f"{name.replace('-', '_')}-{version}.dist-info"
    facts.mkdir(parents=True)
    (facts / "METADATA").write_text(f"Metadata-Version: 2.1\nName: {name}\nVersion: {version}\n")
    groups = (
        f"[{group}]\n" + "".join(f"{key} = {value}\n" for key, value in of.items()) for group, of in points.items()
    )
    (facts / "entry_points.txt").write_text("\n".join(groups))
