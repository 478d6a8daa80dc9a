"""The start pose of each run of a car: set by hand, so known within a spread beforehand, and entered exactly.

A path P that begins at F, started (x, y) aside and turned by psi, is F + (x + iy) + (P - F) e^(i psi). For every path
the most likely pose is found in closed form (Kabsch 1976, in the plane). About it a pose is linear, so the residual of
the turned path plus that pose's share of the columns is what linear freedoms, with their spread about zero, explain.
"""

from dataclasses import dataclass
from math import radians

import numpy as np
from numpy.typing import NDArray
from scipy.stats import chi2

from cadgen.arrays import Array
from cadgen.inference.measurement.record import Record
from cadgen.inference.measurement.remarks import said_of_runs

# A car set by hand against a line, where no file says how: mm and rad, standard deviations.
BY_HAND_MM, BY_HAND_RAD = 5.0, radians(0.5)
NUMBERS = (("start_x_mm", "mm"), ("start_y_mm", "mm"), ("start_heading_deg", "deg"))
# Starts that scatter so much by chance are none that were set as the file says.
CHANCE = 1e-3
_NUMBER = r"([0-9.]*[0-9])"


@dataclass(frozen=True)
class Setting:
    """How a start was set: standard deviations of its place, mm, and heading, rad, and whether a file says so."""

    place: float
    heading: float
    stated: bool

    @property
    def spread(self) -> Array:
        """Of x, y and heading, shape (3,)."""
        return np.array([self.place, self.place, self.heading])

    def __str__(self) -> str:
        source = "as the file says" if self.stated else "no file says how it was set"
        return f"{self.place:g} mm and {np.degrees(self.heading):.3g}°, {source}"


Settings = tuple[Setting, ...]  # one for each run


def settings(record: Record) -> Settings:
    """How each run was set: by its file's remark `start set to 3 mm and 0.15 deg`, or as by hand."""
    pattern = rf"\bstart\b.*?\b{_NUMBER} *mm\b.*?\b{_NUMBER} *deg\b"
    return tuple(
        Setting(float(stated[0]), radians(float(stated[1])), True)
        if stated and min(map(float, stated)) > 0
        else Setting(BY_HAND_MM, BY_HAND_RAD, False)
        for stated in said_of_runs(record, pattern)[: record.runs]
    )


def held(used: Settings) -> str:
    """Spreads that the start poses are held to, in words; runs of several files each by its own."""
    groups = _alike(used)
    if len(groups) == 1:
        return f"held to {used[0]}"
    return "held to " + "; ".join(f"{setting} ({_runs(runs)})" for setting, runs in groups.items())


def _alike(stated: Settings) -> dict[Setting, list[int]]:
    """Numbers of the runs that were set alike."""
    groups: dict[Setting, list[int]] = {}
    for run, setting in enumerate(stated):
        groups.setdefault(setting, []).append(run)
    return groups


def _runs(runs: list[int]) -> str:
    """Runs in words, counted from 1."""
    if len(runs) == 1:
        return f"run {runs[0] + 1}"
    if runs == list(range(runs[0], runs[-1] + 1)):
        return f"runs {runs[0] + 1} to {runs[-1] + 1}"
    return f"runs {', '.join(str(run + 1) for run in runs)}"


class Starts:
    """Start poses of measured runs.

    Attributes:
        columns: response to x, y and heading of each run, shape (n, 3 runs).
    """

    def __init__(self, run: NDArray[np.intp], axis: NDArray[np.intp], measured: Array) -> None:
        """Take the rows of a track.

        Args:
            run, axis: of each row, shape (n,); rows hold first the x and then the y of a run.
            measured: coordinates, shape (n,), mm.
        """
        runs = range(int(run.max()) + 1)
        self._rows = [tuple(np.flatnonzero((run == k) & (axis == a)) for a in (0, 1)) for k in runs]
        self._measured = [measured[x] + 1j * measured[y] for x, y in self._rows]
        self.columns = np.zeros((len(run), 3 * len(self._rows)))
        for k, ((x, y), measured_run) in enumerate(zip(self._rows, self._measured, strict=True)):
            across = 1j * (measured_run - measured_run[0])
            self.columns[x, 3 * k], self.columns[y, 3 * k + 1] = 1.0, 1.0
            self.columns[x, 3 * k + 2], self.columns[y, 3 * k + 2] = across.real, across.imag

    def residual(self, place: NDArray[np.complex128]) -> Array:
        """Measured less expected coordinates, linear in the start poses, shape (n,), mm.

        Args:
            place: of the car as started by design at each row, x + iy, shape (n,), mm.
        """
        out = np.empty(len(place))
        for (x, y), measured in zip(self._rows, self._measured, strict=True):
            path = place[x] - place[x[0]]
            turned = _turned(path, measured)
            left = measured - place[x[0]] - path * np.exp(1j * turned) + 1j * turned * (measured - measured[0])
            out[x], out[y] = left.real, left.imag
        return out

    def poses(self, place: NDArray[np.complex128]) -> Array:
        """The most likely pose of each run against a path, shape (runs, 3), mm and rad."""
        out = []
        for (x, _), measured in zip(self._rows, self._measured, strict=True):
            path = place[x] - place[x[0]]
            turned = _turned(path, measured)
            aside = np.mean(measured - place[x[0]] - path * np.exp(1j * turned))
            out.append((aside.real, aside.imag, turned))
        return np.array(out)


def _turned(path: NDArray[np.complex128], measured: NDArray[np.complex128]) -> float:
    """By which a path is turned so that it comes nearest to what was measured, rad."""
    return float(np.angle(np.vdot(path - path.mean(), measured - measured.mean())))


def scattered(poses: Array, stated: Settings) -> Settings:
    """The setting that runs show which were set alike, where they scatter by more than was stated; else that.

    Args:
        poses: of each run, shape (runs, 3). What all runs share, such as an effect's, is left out.
        stated: of each run by its file.
    """
    used = list(stated)
    for setting, runs in _alike(stated).items():
        if len(runs) > 1:
            shown = _scattered(poses[runs], setting)
            for run in runs:
                used[run] = shown
    return tuple(used)


def _scattered(poses: Array, stated: Setting) -> Setting:
    spread, freedom = np.std(poses, axis=0, ddof=1), len(poses) - 1
    beyond = spread > stated.spread * np.sqrt(chi2.isf(CHANCE, freedom) / freedom)
    place = float(spread[:2].max()) if beyond[:2].any() else stated.place
    return Setting(place, float(spread[2]) if beyond[2] else stated.heading, stated.stated)


def doubts(used: Settings, stated: Settings, values: Array, sigmas: Array) -> tuple[str, ...]:
    """Warnings about the starts: runs that scatter by more than was stated, or start off together.

    Args:
        used: settings that the runs were judged with.
        stated: of their files.
        values, sigmas: start poses as fitted and their standard deviations, shape (runs, 3), mm and rad.
    """
    found, groups = [], _alike(stated)
    for setting, runs in groups.items():
        here, shown = "" if len(groups) == 1 else f" of {_runs(runs)}", used[runs[0]]
        if shown != setting:
            found.append(
                f"the starts{here} scatter by {shown.place:.3g} mm and {np.degrees(shown.heading):.3g}°, not by "
                f"{setting}: they were judged with the scatter that they show; set the car against a stop"
            )
        mean = values[runs].mean(axis=0)
        error = np.sqrt((shown.spread**2 + np.mean(sigmas[runs] ** 2, axis=0)) / len(runs))
        if chi2.sf(np.sum((mean / error) ** 2), 3) < CHANCE:
            which = "all runs" if len(groups) == 1 else _runs(runs)
            starts = "start off together" if len(runs) > 1 else "starts off"
            found.append(
                f"{which if len(values) > 1 else 'the run'} {starts}, by ({mean[0]:.1f}, {mean[1]:.1f}) mm and "
                f"{np.degrees(mean[2]):.2f}°, where {shown.place:.3g} mm and {np.degrees(shown.heading):.3g}° were "
                "expected: make sure of the camera's frame, and of the line from which the car starts"
            )
    return tuple(found)
