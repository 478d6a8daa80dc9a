"""Lift of a valve lobe as a dial measures it: a known motion with 2 um of noise, in docs/tutorial/lobe.csv."""

from pathlib import Path

import numpy as np

LIFT = 7.5  # mm
HALF = 65  # degrees from the base circle to the nose
NOISE = 2e-3  # mm, standard deviation of a reading
_BEFORE = 20  # degrees of base circle on either side


def true_lift(angle: "np.ndarray") -> "np.ndarray":
    """Lift by the angle from the nose, mm: the polynomial 4-5-6-7 on either side."""
    u = np.clip(1 - np.abs(angle) / HALF, 0.0, 1.0)
    return LIFT * u**4 * (35 - 84 * u + 70 * u**2 - 20 * u**3)


def lobe_file() -> str:
    """Text of the table, as its maker wrote it."""
    angle = np.arange(0.0, 2 * (HALF + _BEFORE) + 1)
    reading = true_lift(angle - HALF - _BEFORE) + np.random.default_rng(7).normal(0.0, NOISE, angle.size)
    rows = "".join(f"{a:.0f},{lift:.4f}\n" for a, lift in zip(angle, reading, strict=True))
    return "# lobe of an engine, dial of 1 um on the tappet\ncam angle [deg],lift [mm]\n" + rows


if __name__ == "__main__":
    (Path(__file__).parent / "lobe.csv").write_text(lobe_file(), encoding="utf-8")
