"""Do the tests notice a wrong line? `python -m tests.studies.mutations --cases 40 --record`.

Each mutation is one line of the program written wrongly in a copy of the source, and the test that must fail by it. The
test passes on the unchanged copy first. A mutation that survives is a gap in the tests: write the test that kills it.
"""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from tests.studies.command import PAGES, options, tell

ROOT = Path(__file__).parents[2]
_LONGEST_S = 400.0
_LEFT_OUT = shutil.ignore_patterns(".*", "node_modules", "__pycache__", "exports", "build", "dist")

FOLDER = "tests/output/files/test_folder.py"
TRIAL = "tests/inference/adjustment/test_trial.py"
POINTS = "tests/inference/records/test_points.py"
STUDY = "tests/exploration/test_study.py"
NEW = "tests/cli/test_new_command.py"
COMMANDS = "tests/cli/test_commands.py"
MISUSE = "tests/api/test_misuse.py"


@dataclass(frozen=True)
class Mutation:
    """A line that is written wrongly.

    Attributes:
        file: file of the program.
        old: text that stands in it exactly once.
        new: text in its place.
        test: test that must fail, as pytest names it.
    """

    file: str
    old: str
    new: str
    test: str


MUTATIONS = (
    Mutation(
        "cadgen/output/files/lock.py",
        "if os.path.samestat(os.fstat(descriptor), os.stat(file, follow_symlinks=False)):",
        "if os.stat(file, follow_symlinks=False):",
        f"{FOLDER}::test_a_lock_on_a_file_that_was_removed_meanwhile_is_none",
    ),
    Mutation(
        "cadgen/output/files/lock.py",
        "os.fchmod(descriptor, 0o666)",
        "os.fchmod(descriptor, 0o600)",
        f"{FOLDER}::test_the_lock_leaves_the_mode_of_a_file_that_it_did_not_make",
    ),
    Mutation(
        "cadgen/inference/adjustment.py",
        "+= self.head if settings.head",
        "+= -self.head if settings.head",
        f"{TRIAL}::test_the_heads_error_adds_to_the_base_radius_until_the_head_is_turned",
    ),
    Mutation(
        "cadgen/inference/adjustment.py",
        "least = np.minimum.accumulate(total)",
        "least = total",
        f"{TRIAL}::test_points_in_order_go_to_stations_in_order",
    ),
    Mutation(
        "cadgen/output/files/folder.py",
        "if not sure or not _is_own(folder):",
        "if not _is_own(folder):",
        f"{FOLDER}::test_without_locks_nothing_of_another_run_is_undone_or_removed",
    ),
    Mutation(
        "cadgen/output/files/folder.py",
        "if sure and _is_own(folder):",
        "if _is_own(folder):",
        f"{FOLDER}::test_without_locks_nothing_of_another_run_is_undone_or_removed",
    ),
    Mutation(
        "cadgen/output/files/folder.py",
        "_store(prepared / _RECORD, json.dumps(files))",
        '(prepared / _RECORD).write_text(json.dumps(files), encoding="utf-8")',
        f"{FOLDER}::test_the_record_is_on_the_disk_before_anything_is_moved",
    ),
    Mutation(
        "cadgen/output/files/folder.py",
        "if name in aside or (name, digest) not in kept}",
        "}",
        f"{FOLDER}::test_a_damaged_record_of_a_half_done_move_is_healed",
    ),
    Mutation(
        "cadgen/output/files/folder.py",
        "if os.path.lexists(replaced / name) and not os.path.lexists(target):",
        "if os.path.lexists(replaced / name):",
        f"{FOLDER}::test_what_others_have_put_in_place_of_a_half_moved_file_stays",
    ),
    Mutation(
        "cadgen/output/files/manifest.py",
        "json.dumps(self.content, allow_nan=False)",
        "json.dumps(self.content)",
        f"{FOLDER}::test_an_entry_of_true_files_with_no_number_is_dropped",
    ),
    Mutation(
        "cadgen/writing.py",
        "                file.unlink()",
        "                pass",
        f"{NEW}::test_on_a_full_disk_nothing_is_left",
    ),
    Mutation(
        "cadgen/writing.py",
        "                folder.rmdir()",
        "                pass",
        f"{NEW}::test_on_a_full_disk_nothing_is_left",
    ),
    Mutation(
        "cadgen/writing.py",
        "            staging.unlink()",
        "            pass",
        f"{NEW}::test_on_a_full_disk_nothing_is_left",
    ),
    Mutation(
        "cadgen/design/begin.py",
        "_number(gate_radius / weight)",
        "_number(gate_radius * weight)",
        f"{NEW}::test_points_become_waypoints_and_gates_by_their_weights",
    ),
    Mutation(
        "cadgen/design/begin.py",
        "round(sum(map(float, offsets)) / 2, 4)",
        "round(sum(map(float, offsets)) / 3, 4)",
        f"{NEW}::test_points_become_waypoints_and_gates_by_their_weights",
    ),
    Mutation(
        "cadgen/inference/records/points.py",
        "except Exception as error:",
        "except ValueError as error:",
        f"{POINTS}::test_a_damaged_drawing_is_one_sentence",
    ),
    Mutation(
        "cadgen/inference/records/points.py",
        "6: 1000.0",
        "6: 100.0",
        f"{POINTS}::test_a_polyline_is_read_in_its_unit_beside_closed_ones",
    ),
    Mutation(
        "cadgen/inference/records/points.py",
        "path.flattening(_SAG / unit)",
        "path.flattening(100 * _SAG / unit)",
        f"{POINTS}::test_an_arc_of_a_polyline_is_followed_within_a_millimetre",
    ),
    Mutation(
        "cadgen/inference/records/load.py",
        "key=radians(key)",
        "key=key",
        f"{TRIAL}::test_settings_are_read_as_they_are_written",
    ),
    Mutation(
        "cadgen/inference/records/load.py",
        "np.exp(-1j * start.heading)",
        "np.exp(1j * start.heading)",
        f"{TRIAL}::test_points_stand_in_the_frame_of_the_start",
    ),
    Mutation(
        "cadgen/inference/records/load.py",
        "keep = motor <= end + 1e-9",
        "keep = motor <= end + 1e9",
        f"{TRIAL}::test_points_with_cam_angles_end_where_the_run_ends",
    ),
    Mutation(
        "cadgen/studies/journal.py",
        "if not 0 <= seconds < inf or self._turn(row.number) is None:",
        "if self._turn(row.number) is None:",
        f"{STUDY}::test_a_line_with_a_true_checksum_that_is_no_result_is_named",
    ),
    Mutation(
        "cadgen/studies/journal.py",
        "self.header.fingerprint != study.fingerprint or not self.widths <= {width}",
        "self.header.fingerprint != study.fingerprint",
        f"{STUDY}::test_a_journal_with_rows_or_a_study_of_others_is_named",
    ),
    Mutation(
        "cadgen/studies/journal.py",
        "self.header.fingerprint != study.fingerprint or not self.widths <= {width}",
        "not self.widths <= {width}",
        f"{STUDY}::test_a_journal_with_rows_or_a_study_of_others_is_named",
    ),
    Mutation(
        "cadgen/studies/design_row.py",
        "0 <= number < _NUMBERS and",
        "number < _NUMBERS and",
        f"{STUDY}::test_a_line_with_a_true_checksum_that_is_no_result_is_named",
    ),
    Mutation(
        "cadgen/reading.py",
        "if not stat.S_ISREG(mode):",
        "if stat.S_ISSOCK(mode):",
        f"{STUDY}::test_a_pipe_or_device_is_no_journal_and_nobody_waits_for_it",
    ),
    Mutation(
        "cadgen/api/values.py",
        "least <= radians(number) <= most",
        "least <= number <= most",
        f"{MISUSE}::test_what_is_misunderstood_is_refused_in_one_sentence",
    ),
    Mutation(
        "cadgen/design/override.py",
        'option = "" if isinstance(text, KeyChange) else "--set "',
        'option = "--set "',
        f"{MISUSE}::test_refused_changes_of_a_program_name_the_key_and_no_option",
    ),
    Mutation(
        "cadgen/design/schema.py",
        "    unused = OF_A_CAR if schema is MotionFile else ()",
        "    unused = ()",
        "tests/cam/test_roller.py::test_a_design_of_a_motion_comes_back_from_pickle",
    ),
    Mutation(
        "cadgen/cli/options.py",
        "if len(own) != 1:",
        "if not own:",
        f"{COMMANDS}::test_without_a_name_beside_one_design_the_one_that_is_taken_is_said_first_and_last",
    ),
    Mutation(
        "cadgen/cli/options.py",
        "context.call_on_close(lambda: tell(shown(said)))",
        "tell(shown(said))",
        f"{COMMANDS}::test_without_a_name_beside_one_design_the_one_that_is_taken_is_said_first_and_last",
    ),
    Mutation(
        "cadgen/gears/tolerances.py",
        "return 0.3 * (m + 0.4 * np.sqrt(d)) + 4",
        "return 0.3 * (m + 0.4 * np.sqrt(d)) + 5",
        "tests/gears/test_tolerances.py::test_rules_of_iso_1328_give_the_printed_tables",
    ),
    Mutation(
        "cadgen/gears/tolerances.py",
        "np.floor(value / unit + 0.5)",
        "np.floor(value / unit)",
        "tests/gears/test_tolerances.py::test_rules_of_iso_1328_give_the_printed_tables",
    ),
    Mutation(
        "cadgen/gears/tooth.py",
        "return tan(angle) - angle",
        "return tan(angle)",
        "tests/gears/test_tooth.py::test_the_involute_function_is_that_of_the_tables",
    ),
    Mutation(
        "cadgen/gears/backlash.py",
        "return aim - (E_sns - T_sn / 2)",
        "return aim - (E_sns + T_sn / 2)",
        "tests/gears/test_thinning.py",
    ),
    Mutation(
        "cadgen/car/steering.py",
        "return (geared + zero) / (1.0 - geared * zero)",
        "return (geared + zero) / (1.0 + geared * zero)",
        "tests/car/test_steering.py",
    ),
)


@dataclass(frozen=True)
class Outcome:
    """Outcome of a mutation: `killed`, `survived`, or why it could not be judged."""

    mutation: Mutation
    said: str


def chosen(count: int, seed: int) -> tuple[Mutation, ...]:
    """So many mutations, at random places of the list, in its order."""
    places = np.random.default_rng(seed).permutation(len(MUTATIONS))[:count]
    return tuple(MUTATIONS[place] for place in sorted(places.tolist()))


def judged(mutations: tuple[Mutation, ...]) -> list[Outcome]:
    """Outcomes of mutations, one after the other, each in the same copy of the source."""
    with tempfile.TemporaryDirectory() as folder:
        copy = Path(folder) / "copy"
        shutil.copytree(ROOT, copy, ignore=_LEFT_OUT)
        return [Outcome(each, _said(copy, each)) for each in mutations]


def _said(copy: Path, mutation: Mutation) -> str:
    file = copy / mutation.file
    text = file.read_text(encoding="utf-8")
    if text.count(mutation.old) != 1:
        return "its text does not stand there once"
    if (code := _tested(copy, mutation.test)) != 0:
        return f"its test does not pass without it (pytest {code})"
    file.write_text(text.replace(mutation.old, mutation.new), encoding="utf-8")
    try:
        code = _tested(copy, mutation.test)
    finally:
        file.write_text(text, encoding="utf-8")
    return {0: "survived", 1: "killed"}.get(code, f"pytest {code}")


def _tested(copy: Path, test: str) -> int:
    """Exit code of pytest: 0 for tests that pass, 1 for one that fails."""
    command = [sys.executable, "-m", "pytest", "-q", "-x", "-p", "no:cacheprovider", "-m", "", test]
    environment = {**os.environ, "PYTHONPATH": str(copy), "PYTHONDONTWRITEBYTECODE": "1", "CI": "1"}
    run = subprocess.run(command, cwd=copy, env=environment, capture_output=True, timeout=_LONGEST_S)
    return run.returncode


def page(outcomes: list[Outcome], command: str) -> str:
    """Page of the study."""
    rows = [
        f"| `{each.mutation.file}` | `{each.mutation.old.strip()}` | `{each.mutation.new.strip()}` "
        f"| `{each.mutation.test.partition('::')[2] or each.mutation.test}` | {each.said} |".replace("||", "|")
        for each in outcomes
    ]
    killed = sum(each.said == "killed" for each in outcomes)
    return "\n".join(
        [
            "# Do the tests notice a wrong line?",
            "",
            (__doc__ or "").partition("\n\n")[2].strip(),
            "",
            f"`{command}`",
            "",
            f"{killed} of {len(outcomes)} killed; the list has {len(MUTATIONS)}.",
            "",
            "| file | line | written wrongly | test that must fail | outcome |",
            "|---|---|---|---|---|",
            *rows,
        ]
    )


def main() -> int:
    """Judge mutations; exit code 1 if one is not killed."""
    asked = options(__doc__, cases=len(MUTATIONS))
    outcomes = judged(chosen(asked.cases, asked.seed))
    command = f"python -m tests.studies.mutations --cases {asked.cases} --seed {asked.seed} --record"
    tell(page(outcomes, command), PAGES / "mutations.md" if asked.record else None)
    return 0 if all(each.said == "killed" for each in outcomes) else 1


if __name__ == "__main__":
    raise SystemExit(main())
