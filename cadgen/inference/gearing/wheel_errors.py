"""Lines at the order of a shaft, traced to what sits on the shaft: run-out of its wheels, pitch, or its encoder.

With forward and other flanks measured, a line has two complex amplitudes F and G. Run-out A of a wheel with the lean λ
(`train_orders`) has F = A exp(iλ), G = A exp(−iλ); what shows alike on both flanks, F = G = C. Two of these explain any
line, so each alone is tried first, and the likelier one is taken: what lies within 4 of it, in units of χ² with 12 for
each part more, stays a rival.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import combinations
from math import cos, pi, sqrt

import numpy as np

from cadgen.inference.gearing.train_orders import SeenShaft, SeenWheel
from cadgen.inference.gearing.transmission_error import OrderLine

_RIVAL = 4.0
_EACH = 12.0  # χ² that a further part must explain: 2 numbers, and a chance of 0.25 %


@dataclass(frozen=True, kw_only=True)
class RunOut:
    """Wheel whose teeth are off its axis.

    Attributes:
        wheel: wheel.
        line: complex amplitude of its line, rad at the output.
        sigma: standard deviation of either part, rad.
    """

    wheel: SeenWheel
    line: complex
    sigma: float

    @property
    def eccentricity(self) -> float:
        """Distance of the middle of its teeth from its axis, mm; the run-out F_r is twice that."""
        return abs(self.line) * self.wheel.lever

    @property
    def eccentricity_sigma(self) -> float:
        """Standard deviation of the eccentricity, mm."""
        return self.sigma * self.wheel.lever

    @property
    def high(self) -> float | None:
        """Angle of its shaft at which its high side points at the other axis, rad; None where that is not known."""
        if self.wheel.high is None:
            return None
        return float((self.wheel.high - np.angle(self.line) - pi / 2) % (2 * pi))


@dataclass(frozen=True, kw_only=True)
class PitchOrEncoder:
    """Error alike on both flanks: long pitch error of a wheel, or an encoder off its axis; rad at the output."""

    line: complex
    sigma: float


@dataclass(frozen=True, kw_only=True)
class ShaftErrors:
    """Causes of a line once a turn of a shaft.

    Attributes:
        shaft: shaft.
        line: line.
        parts: what it is; empty where one side alone was measured.
        rivals: other sets of parts that explain it as well.
    """

    shaft: SeenShaft
    line: OrderLine
    parts: tuple[RunOut | PitchOrEncoder, ...]
    rivals: tuple[tuple[RunOut | PitchOrEncoder, ...], ...]

    @property
    def named(self) -> bool:
        """Whether one set of parts is left."""
        return bool(self.parts) and not self.rivals


def shaft_errors(shaft: SeenShaft, line: OrderLine, *, both: bool) -> ShaftErrors:
    """Parts that a line once a turn of a shaft is traced to.

    Args:
        shaft: shaft.
        line: its line.
        both: whether both flanks were measured.
    """
    if not both:
        return ShaftErrors(shaft=shaft, line=line, parts=(), rivals=())
    data = np.array([line.forward, line.backward])
    # Standard deviations of F and G: parts of mean and half difference are alike.
    sigma = line.sigma
    shapes: list[tuple[SeenWheel | None, np.ndarray]] = [
        (wheel, np.exp(1j * wheel.lean * np.array([1.0, -1.0]))) for wheel in shaft.wheels
    ]
    shapes.append((None, np.ones(2, dtype=complex)))
    found = []
    for count in (1, 2):
        for some in combinations(shapes, count):
            matrix = np.stack([shape for _, shape in some], axis=1)
            if count == 2 and abs(np.linalg.det(matrix)) < 1e-6:
                continue
            values = np.linalg.lstsq(matrix, data, rcond=None)[0]
            rest = data - matrix @ values
            cost = float(np.sum(np.abs(rest) ** 2)) / sigma**2 + _EACH * count
            spread = np.linalg.pinv(matrix)
            parts = tuple(
                RunOut(wheel=wheel, line=complex(value), sigma=sigma * float(np.linalg.norm(row)))
                if wheel is not None
                else PitchOrEncoder(line=complex(value), sigma=sigma * float(np.linalg.norm(row)))
                for (wheel, _), value, row in zip(some, values, spread, strict=True)
            )
            found.append((cost, parts))
    found.sort(key=lambda each: each[0])
    least, best = found[0]
    names = {_name(part) for part in best}
    rivals = [
        parts for cost, parts in found[1:] if cost <= least + _RIVAL and not names < {_name(part) for part in parts}
    ]
    return ShaftErrors(shaft=shaft, line=line, parts=best, rivals=tuple(rivals))


def _name(part: RunOut | PitchOrEncoder) -> str:
    return str(part.wheel.name) if isinstance(part, RunOut) else ""


@dataclass(frozen=True, kw_only=True)
class Turning:
    """Wheel turned against the other one of its shaft, so that their run-out cancels best.

    Attributes:
        wheel: driven wheel, which is turned.
        other: wheel that stays.
        angle: angle by which it is turned, in the sense of its own forward motion, rad.
        before, after: amplitude of the line, the greater one of both sides, rad at the output.
    """

    wheel: SeenWheel
    other: SeenWheel
    angle: float
    before: float
    after: float


def best_turning(errors: ShaftErrors) -> Turning | None:
    """Turn of a shaft's driven wheel against its driver at which their run-out cancels best; None without both.

    The mean square over both sides is |A|² + |B|² + 2 cos(λ_A − λ_B) Re(A B*). It is least where A points against B if
    the leans differ by less than a right angle, and along it if by more. A wheel that is put on its shaft turned
    forward by δ has its line by δ earlier: A exp(iδ).

    Args:
        errors: run-out on a shaft.
    """
    outs = [part for part in errors.parts if isinstance(part, RunOut)]
    if len(outs) != 2:
        return None
    one, two = sorted(outs, key=lambda part: part.wheel.driver)
    turned = cos(one.wheel.lean - two.wheel.lean)
    against = pi if turned > 0 else 0.0
    angle = against - float(np.angle(one.line / two.line))
    angle = (angle + pi) % (2 * pi) - pi
    size, other = abs(one.line), abs(two.line)
    after = sqrt(max(size**2 + other**2 - 2 * abs(turned) * size * other, 0.0))
    return Turning(wheel=one.wheel, other=two.wheel, angle=angle, before=errors.line.size, after=after)
