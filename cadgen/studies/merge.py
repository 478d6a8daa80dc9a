"""Results of a study from the journals of its shards."""

import sys
from collections.abc import Sequence
from pathlib import Path

from cadgen.errors import FileError, brief
from cadgen.studies.journal import ENDING, Journal
from cadgen.studies.read import study_of
from cadgen.studies.results import Results
from cadgen.version import __version__

_OTHER_FILES = 64  # that a process holds open besides the journals


def merged(folders: Sequence[Path]) -> Results:
    """Results of the shards' journals in some folders.

    Args:
        folders: folders with journals, or journals.

    Raises:
        FileError: no journal, journals of several studies or versions, or designs without a result.
    """
    files = list(dict.fromkeys(file for folder in folders for file in _journals(folder)))
    if not files:
        raise FileError("there is no journal of cadgen explore in these folders: name those of the shards")
    _allow_open(len(files))
    journals = tuple(Journal.read(file) for file in files)
    first = journals[0].header
    for journal in journals:
        if journal.header.version != __version__:
            raise FileError(
                f"{brief(str(journal.file))} was written by cadgen {journal.header.version}, and this is "
                f"{__version__}: merge with that version"
            )
        if journal.header.fingerprint != first.fingerprint:
            raise FileError(
                f"{brief(str(journal.file))} is of another study than {brief(str(journals[0].file))}: name the "
                "folders, or the journals, of one study"
            )
    study = study_of(first.study, first.text, first.source, first.name)
    count = sum(journal.count for journal in journals) if study.searches else study.count
    results = Results(study, journals, count)
    missing = list(results.missing)
    if missing:
        raise FileError(
            f"{len(missing)} of {count} designs have no result yet, the first is number {missing[0]}: run the "
            f"shards on that are not done ({_shards(journals, missing[0])})"
        )
    return results


def _shards(journals: Sequence[Journal], number: int) -> str:
    parts = journals[0].header.shard[1]
    return f"--shard {number % parts + 1}/{parts}" if parts > 1 else "cadgen explore"


def _journals(folder: Path) -> list[Path]:
    return sorted(folder.glob(f"*{ENDING}")) if folder.is_dir() else [folder]


def _allow_open(count: int) -> None:
    """Have this process allowed to hold so many journals open at once: many systems begin with 1024 files.

    Raises:
        FileError: this computer does not allow so many.
    """
    if sys.platform == "win32":
        return
    import resource

    usual, most = resource.getrlimit(resource.RLIMIT_NOFILE)
    needed = count + _OTHER_FILES
    if usual == resource.RLIM_INFINITY or needed <= usual:
        return
    if most != resource.RLIM_INFINITY and needed > most:
        raise FileError(
            f"these are {count} journals, and this computer lets a program open {most} files at once: raise that limit "
            "(ulimit -n), or take fewer shards"
        )
    resource.setrlimit(resource.RLIMIT_NOFILE, (needed, most))
