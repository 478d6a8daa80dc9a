"""Results of a study from the journals of its shards."""

from collections.abc import Sequence
from pathlib import Path

from cadgen.errors import FileError, brief
from cadgen.exploration.journal import ENDING, Journal
from cadgen.exploration.read import study_of
from cadgen.exploration.results import Results
from cadgen.version import __version__


def merged(folders: Sequence[Path]) -> Results:
    """Results of the shards' journals in some folders.

    Args:
        folders: folders with journals, or journals.

    Raises:
        FileError: no journal, journals of several studies or versions, or designs without a result.
    """
    files = [file for folder in folders for file in _journals(folder)]
    if not files:
        raise FileError("there is no journal of cadgen explore in these folders: name those of the shards")
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
                f"{brief(str(journal.file))} is of another study than {brief(str(journals[0].file))}: name the folders "
                "of one study"
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
