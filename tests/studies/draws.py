"""Cards of settings: every spacing driven by code that shares nothing with the program, and sought by brute force.

Two planned designs, an S course of 700 to 1300 mm and a lap of a figure 8 of 300 to 500 mm. For each spacing the card's
setting is driven on points of the disc; errors and room must be those of the card. Then settings about it are tried by
thousands, each at its divisions, from the card's setting and from random ones, for one that has less error.

    python -m tests.studies.draws [--step 10] [--tries 4000] [--seed 1] [--record]
"""

import argparse
import sys
import tomllib
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

import numpy as np

from tests.studies import draws_truth as truth

DATA = Path(__file__).parents[1] / "data" / "draws"
PAGE = Path(__file__).parents[2] / "docs" / "studies" / "draws.md"
NAMES = ("s_course", "eight")
_PLACES = np.array([-1.0, 0.0, 1.0])
_ABOUT = (0.6, 0.06)  # mm about the card's disc and head, within which the steering is interpolated


@dataclass
class Judge:
    """A card's row, judged.

    Attributes:
        values: the design file, as it is written.
        points: points of the disc, about the camshaft, mm.
        path: cam angle -> planned point x + iy at the stated spacing, mm.
        row: row of the card.
    """

    values: dict
    points: np.ndarray
    path: object
    row: dict

    @property
    def factor(self):
        spacing = self.values["course"]["spacing"]
        return self.row["spacing_mm"] / ((spacing["from_mm"] + spacing["to_mm"]) / 2)

    @cached_property
    def angles(self):
        """Cam angles of the run, an odd number, up to where the path ends."""
        step = np.radians(360 / truth.STEPS)
        count = int(np.floor(self.row["finish_rad"] / step))
        return np.arange(count + 1 - count % 2) * step

    @cached_property
    def wanted(self):
        return self.factor * self.path(self.angles[::2])

    @property
    def car(self):
        return self.values["car"]["wheelbase_mm"], self.values["car"]["drive_wheel_offset_mm"]

    def tangent(self, disc, head):
        """Steering with the disc's middle and the base radius, mm."""
        half = self.values["cam"]["thickness_mm"] / 2
        return truth.steering(
            self.points, head, self.values["follower"]["radius_mm"], (disc - half, disc + half), self.angles
        )

    def driven(self, tangent, radius, x, y, heading):
        """Drive wheel, heading, and distances from the scaled path."""
        offset = self.values["path"]["offset_mm"]
        travel = 2 * np.pi * radius * self.row["ratio"]
        start = x + 1j * y + 1j * offset * np.exp(1j * heading)
        wheel, turned = truth.run(tangent, self.angles[1], travel, (start, heading), self.car)
        return wheel, turned, np.abs(wheel - 1j * offset * np.exp(1j * turned) - self.wanted)

    def settings(self):
        """The row's settings: disc, head, radius, x, y, heading (rad)."""
        row = self.row
        return np.array(
            [
                row["disc_middle_mm"],
                row["base_radius_mm"],
                row["wheel_radius_mm"],
                row["start_x_mm"],
                row["start_y_mm"],
                np.radians(row["start_heading_deg"]),
            ]
        )

    def checked(self):
        """Error and least room of the row's setting to posts and edge, and in gates, driven independently."""
        disc, head, *rest = self.settings()
        wheel, heading, off = self.driven(self.tangent(disc, head), *rest)
        course, body = self.values["course"], self.values["car"]["outline"]
        car = self.values["car"]
        middle = (car["drive_wheel_offset_mm"] - car["idle_wheel_offset_mm"]) / 2
        front = body["front_overhang_mm"]
        outline = front, front - body["length_mm"], middle + body["width_mm"] / 2, middle - body["width_mm"] / 2
        posts = [self.factor * complex(*post["at_mm"]) for post in course["posts"]]
        low = complex(*course["field"]["corner_mm"])
        apart, edge = truth.gaps(
            wheel, heading, self.car, outline, posts, (low, low + complex(*course["field"]["size_mm"]))
        )
        sizes = np.array([post["radius_mm"] for post in course["posts"]])
        room = min((apart - sizes).min(), edge) - course["margin_mm"]
        track = wheel - 1j * self.values["path"]["offset_mm"] * np.exp(1j * heading)
        ends = [
            (self.factor * complex(*g["from_mm"]), self.factor * complex(*g["to_mm"])) for g in course.get("gates", ())
        ]
        return float(off.max()), float(min([room, *(truth.passed(track, each) for each in ends)]))

    def steps(self):
        given = self.values["settings"]
        return np.array(
            [
                given["disc_step_mm"],
                given["head_step_mm"],
                given["wheel_step_mm"],
                given["start_step_mm"],
                given["start_step_mm"],
                np.radians(given["start_heading_step_deg"]),
            ]
        )

    def brute(self, tries, random):
        """Least error of settings about the card's, by random moves of several divisions that are kept if they help."""
        steps, middle = self.steps(), self.settings()
        nodes = [middle[k] + _PLACES * _ABOUT[k] for k in range(2)]
        table = np.array([[self.tangent(d, h) * d for h in nodes[1]] for d in nodes[0]])

        def weights(k, value):
            t = (value - middle[k]) / _ABOUT[k]
            return np.array([t * (t - 1) / 2, 1 - t**2, t * (t + 1) / 2])

        def error(values):
            tangent = np.einsum("i,j,ijk->k", weights(0, values[0]), weights(1, values[1]), table) / values[0]
            return float(self.driven(tangent, *values[2:])[2].max())

        card = best = error(middle)
        for number in range(3):
            # From the card's setting, and from others some divisions away.
            here = middle + (random.integers(-4, 5, 6) * steps if number else 0.0)
            least = error(here)
            for _ in range(tries // 3):
                width = random.choice([1, 1, 2, 4])
                move = random.integers(-width, width + 1, 6) * (random.random(6) < 0.5)
                moved = here + move * steps
                if np.any(np.abs(moved[:2] - middle[:2]) > _ABOUT):
                    continue
                value = error(moved)
                if value < least:
                    here, least = moved, value
            best = min(best, least)
        return card, best


def judges(name, spacings=None):
    """Rows of a card to be judged, of all its spacings or of some."""
    from cadgen import Design
    from cadgen.arrays import TURN

    overrides = [] if spacings is None else [f"course.spacing.step_mm={spacings:g}"]
    card = Design.load(DATA / f"{name}.toml", overrides).card("actual")
    cam = card.computed.cam
    values = tomllib.loads((DATA / f"{name}.toml").read_text())
    points = cam.curve.outline(0.01).points
    turn = cam.car.track.turn

    def path(angle):
        return cam.car.track.planned(angle / TURN * turn) @ [1, 1j]

    rows = [{**row, "finish_rad": cam.car.steering.blend_start} for row in card.settings]
    return card, [Judge(values, points, path, row) for row in rows]


def judged(name, step, tries, seed):
    """Rows of a table: spacing, the card's error, that of the independent run, room, and the brute force's error."""
    card, rows = judges(name, step)
    random = np.random.default_rng(seed)
    table = []
    for judge in rows:
        error, room = judge.checked()
        own, best = judge.brute(tries, random)
        row = judge.row
        table.append((row["spacing_mm"], row["error_mm"], error, row["room_mm"], room, own, best, row["kept"]))
    return name, card.sentences, table


def main() -> None:
    """Judge both cards and print or record the result."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--step", type=float, default=10.0)
    parser.add_argument("--tries", type=int, default=3000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--processes", type=int, default=2)
    parser.add_argument("--record", action="store_true")
    given = parser.parse_args()
    lines = [
        *HEAD,
        "",
        f"    python -m tests.studies.draws --step {given.step:g} --tries {given.tries} --seed {given.seed}",
    ]
    with ProcessPoolExecutor(given.processes) as pool:
        results = [pool.submit(judged, name, given.step, given.tries, given.seed) for name in NAMES]
        for result in results:
            name, said, table = result.result()
            lines += ["", f"## {name}", "", *(f"{line[0].upper()}{line[1:]}." for line in said), ""]
            lines += summary(table)
    text = "\n".join(lines) + "\n"
    print(text)
    if given.record:
        PAGE.write_text(text, encoding="utf-8")
    sys.exit(0)


HEAD = [
    "# Cards of settings",
    "",
    "Two planned designs, an S course with posts 700 to 1300 mm apart and a lap of a figure 8 with posts 300 to 500 mm",
    "apart (`tests/data/draws`): the setting of every spacing driven by code that shares nothing with the program, and",
    "settings about it tried by brute force, at the same divisions, for less error.",
]


def summary(table):
    """Lines on all rows, and a table of every fifth."""
    rows = np.array([row[:7] for row in table], float)
    off, ratio = np.abs(rows[:, 1] - rows[:, 2]).max(), rows[:, 5] / np.maximum(rows[:, 6], 1e-9)
    kept = [row[7] for row in table]
    wrong = [row[0] for row in table if row[7] and row[4] < -0.1]
    worst = rows[:, 5].max() / rows[:, 6].max()
    lines = [
        f"{len(table)} spacings, {sum(kept)} of them kept; of these the independent sweep finds {len(wrong)} not kept.",
        f"Errors differ from those of the card by {off:.2f} mm at most, room by "
        f"{np.abs(rows[:, 3] - rows[:, 4]).max():.2f} mm.",
        f"Worst error by the worst of the brute force: {worst:.3f}; at each spacing at most {ratio.max():.3f}, "
        f"{(rows[:, 5] - rows[:, 6]).max():.2f} mm.",
        "",
        "| posts apart, mm | error, mm | driven independently | room, mm | swept independently | brute force |",
        "|---|---|---|---|---|---|",
    ]
    shown = table[:: max(len(table) // 12, 1)]
    return lines + [f"| {r[0]:g} | {r[1]:.2f} | {r[2]:.2f} | {r[3]:.2f} | {r[4]:.2f} | {r[6]:.2f} |" for r in shown]


if __name__ == "__main__":
    main()
