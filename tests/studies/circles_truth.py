"""Cars with declared and undeclared effects, stepped by hand: shares no code with the models under test.

The rod is let down on the points of the outline (`tests.inference.measurement.synthetic`);
the camshaft stands behind gears that run out, and walks downhill in their play, where friction lets it;
the car goes by short arcs. On its way it meets what no catalogue has.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from cadgen.inference.measurement.kinds import LIFT, TRACK, TRANSMISSION
from cadgen.inference.measurement.record import Record
from tests.inference.measurement.synthetic import DEG, TURN, Bench, form_error, profile_record
from tests.inference.measurement.synthetic import Car as Bed
from tests.inference.measurement.synthetic import drawn_form as form_and_variance
from tests.studies.friction_truth import holding

CELLS = 7200
STEP = TURN / CELLS
WAY = np.concatenate([np.arange(341.0), np.arange(340.0, -1, -1)])  # cam angles that a dial is read at, degrees
MOTOR = np.concatenate([np.arange(361), np.arange(359, -1, -1)]) * 45.0  # of the encoders, degrees


@dataclass(frozen=True)
class Car:
    """A car as it is; at rest it is the design's.

    Attributes:
        zero, phase, play: rad; the play a whole number of cells.
        friction: between rod and disc.
        gain, radius: factors.
        bore: of the disc off centre, mm; stays with the car, as run-out of its shaft.
        runs_out: cosine and sine of a gear three turns of which go on one of the cam, rad.
        slope: of the floor, x and y; the car creeps by it along and across.
        understeer: of the steering's tangent, for each unit of its square.
        drifting: zero at the end of the turn, less that at its start, rad.
        wear: of the wheel at the end of the turn, relative.
        bends: rod that gives more to one side, of the tangent where it is negative.
        creeps: across its heading, for each mm of travel.
        rubs: slope of the lift, of its greatest, below which friction holds the cam at the end of the turn; it grows
            from nothing at the start.
        flank: lift's tangent that a worn edge takes on rises, at the end of the turn.
        cogs: of the motor, three of its turns' parts, rad of the camshaft.
        tooth: push of a damaged one, once a turn of a shaft that turns nine times, rad of the camshaft.
        bounce: of the lift's tangent, behind each top.
        dent: depth of one in the outline, mm; and its polar angle.
        spiral: by which the cutter has worn at the end of the outline, mm.
        offset, lobe: of the outline, mm; only to find the size of what feigns them.
        edge: width of the broken edges of the disc, mm; the rod then touches so much farther in.
        wobble: of the disc on its shaft, mm along it, and the cam angle at which it stands outermost.
        camera: factor of the camera's scale.
        square, stylus: of the measuring machine, rad and mm.
        lag: of the reading of dial or encoder, rad, half of it either way.
    """

    zero: float = 0.0
    phase: float = 0.0
    play: int = 0
    friction: float = 0.0
    gain: float = 1.0
    radius: float = 1.0
    bore: tuple[float, float] = (0.0, 0.0)
    runs_out: tuple[float, float] = (0.0, 0.0)
    slope: tuple[float, float] = (0.0, 0.0)
    understeer: float = 0.0
    drifting: float = 0.0
    wear: float = 0.0
    bends: float = 0.0
    creeps: float = 0.0
    rubs: float = 0.0
    flank: float = 0.0
    cogs: float = 0.0
    tooth: float = 0.0
    bounce: float = 0.0
    dent: tuple[float, float] = (0.0, 0.0)
    spiral: float = 0.0
    offset: float = 0.0
    lobe: float = 0.0
    edge: float = 0.0
    wobble: tuple[float, float] = (0.0, 0.0)
    camera: float = 1.0
    square: float = 0.0
    stylus: float = 0.0
    lag: float = 0.0


class World:
    """A disc on the road: its outline, and the car's nominal dimensions and path."""

    def __init__(self, built: Any, bed: Bed, form: np.ndarray) -> None:
        self.built, self.bed, self.form = built, bed, form
        self._lifts: dict[Any, np.ndarray] = {}
        self._holds: dict[Any, np.ndarray] = {}

    def bench(self, car: Car) -> Bench:
        """The disc: bore, form error, and what has happened to its outline."""
        spiral = car.spiral * np.arange(len(self.form)) / len(self.form)
        dent = (car.dent[1], 3 * DEG, car.dent[0])
        return Bench(
            shift=car.bore,
            form=self.form + spiral,
            dent=dent,
            offset=car.offset,
            lobes=(2, car.lobe, TURN / 8),
            edge=car.edge,
            wobble=car.wobble,
        )

    def lift(self, car: Car) -> np.ndarray:
        """tan(beta) of the rod on each cell of the turn."""
        disc = _disc(car)
        if disc not in self._lifts:
            table = self.bed.steering(self.bench(car), np.arange(0, CELLS, 5) * STEP)
            self._lifts[disc] = np.interp(np.arange(CELLS), np.arange(0, CELLS + 5, 5), np.append(table, table[0]))
        return self._lifts[disc]

    def holds(self, car: Car) -> np.ndarray:
        """Friction above which each cell holds the cam where the lift falls; -1 where it rises."""
        disc = _disc(car)
        if disc not in self._holds:
            T = self.lift(car)
            slope = (np.roll(T, -1) - T) * CELLS / TURN
            middle = (T + np.roll(T, -1)) / 2
            self._holds[disc] = np.where(slope < 0, holding(self.built.follower, middle, slope), -1.0)
        return self._holds[disc]

    def asked(self, car: Car, motor: np.ndarray) -> np.ndarray:
        """Cam angle that the gears ask for; set on its shaft at the start."""
        c, s = car.runs_out
        tooth = car.tooth * np.clip(1 - np.abs((9 * motor + 2) % TURN - np.pi) / (18 * DEG), 0, 1)
        return motor + c * (np.cos(3 * motor) - 1) + s * np.sin(3 * motor) + car.cogs * np.sin(135 * motor) + tooth

    def path(self, car: Car) -> np.ndarray:
        """Places of the drive wheel at the ends of all cells of the motor's turn, as x + iy."""
        lift = self.lift(car)
        table, fall = lift.tolist(), lift - np.roll(lift, -1)
        steepest = float(fall.max())
        free = (self.holds(car) > car.friction).tolist() if car.friction else (fall > 0).tolist()
        motor = np.arange(CELLS + 1)
        pushed = np.ceil(self.asked(car, motor * STEP) / STEP - 1e-9).astype(int).tolist()
        cam, now, shift = np.empty(CELLS + 1), pushed[0], round(car.phase / STEP)  # the disc stands ahead of its shaft
        for i, least in enumerate(pushed):
            now, held = max(now, least), car.rubs * steepest * i / CELLS
            while now < least + car.play:
                at = (now + shift) % CELLS
                if not free[at] or table[at] - table[(at + 1) % CELLS] <= held:
                    break
                now += 1
            cam[i] = now
        exact = self.asked(car, motor * STEP) / STEP
        cam = np.where(cam == pushed, exact, cam + exact - np.array(pushed)) + car.phase / STEP
        shape = lift + car.bounce * _behind_tops(lift) if car.bounce else lift
        T = np.interp(cam, np.arange(-CELLS, 2 * CELLS), np.tile(shape, 3))
        rises = np.interp(cam, np.arange(-CELLS, 2 * CELLS), np.tile(fall < 0, 3))
        T = T - car.flank * rises * motor / CELLS
        T = T * car.gain * (1 - car.understeer * T**2) * np.where(T < 0, 1 + car.bends, 1.0)
        beta = np.arctan(T) + car.zero + car.drifting * motor / CELLS
        L, A1 = self.built.car.wheelbase, self.built.car.drive_wheel_offset
        bend = -np.tan(beta) / (L + A1 * np.tan(beta))
        travel = self.built.track.length * car.radius / CELLS * (1 - car.wear * (motor[:-1] + 0.5) / CELLS)
        swing = (bend[:-1] + bend[1:]) / 2 * travel
        x, y = self.built.track.position(0.0)
        heading = float(self.built.track.heading(np.array([0.0]))[0]) + np.cumsum(swing) - swing / 2
        way = np.exp(1j * heading)
        down = complex(*car.slope)
        creep = (down * way.conj()).imag * 1j * way + 0.3 * (down * way.conj()).real * way
        creep = creep + 1j * car.creeps * way
        return complex(float(x), float(y)) + np.concatenate(
            [[0], np.cumsum(travel * (way * np.sinc(swing / TURN) + creep))]
        )

    def track(
        self,
        car: Car,
        rng: np.random.Generator,
        *,
        runs: int = 4,
        noise_mm: float = 3.0,
        start: tuple[float, float] = (3.0, 0.15),
    ) -> Record:
        """Camera's rows every two degrees, started by hand within so many mm and degrees."""
        degrees = np.arange(0, 361, 2)
        rows = []
        for _ in range(runs):
            clean = self.path(car)[degrees * CELLS // 360] * car.camera
            turned = clean[0] + (clean - clean[0]) * np.exp(1j * rng.normal(0, start[1]) * DEG)
            noise = rng.normal(0, noise_mm, (2, len(degrees)))
            rows.append(turned + rng.normal(0, start[0]) + 1j * rng.normal(0, start[0]) + noise[0] + 1j * noise[1])
        place = np.concatenate(rows)
        columns = {
            "cam_angle_deg": np.tile(degrees * 1.0, runs),
            "x_mm": np.round(place.real, 1),
            "y_mm": np.round(place.imag, 1),
        }
        return _record(TRACK, columns, runs)

    def dial(self, car: Car, rng: np.random.Generator, *, runs: int = 3) -> Record:
        """A lift by a dial at the inner face, every degree to 340 and back; the phase is set by a divider."""
        way, clean = WAY, self.shown(car)
        readings = [np.round(clean + rng.normal(0, 0.02) + rng.normal(0, 4e-3, len(way)), 3) for _ in range(runs)]
        columns = {
            "direction": np.tile(np.repeat(["forward", "reverse"], 341), runs),
            "cam_angle_deg": np.tile(way, runs),
            "lift_mm": np.concatenate(readings),
        }
        return _record(LIFT, columns, runs)

    def shown(self, car: Car) -> np.ndarray:
        """Readings of the dial on `WAY` but for noise, mm."""
        lagging = WAY - np.repeat([0.5, -0.5], 341) * car.lag / DEG
        table = self.lift(car)
        return self.built.follower.inner * np.interp(lagging / 360 * CELLS, np.arange(CELLS), table, period=CELLS)

    def train(self, car: Car, rng: np.random.Generator, *, runs: int = 3) -> Record:
        """Angles at both ends of the train, one turn of the cam forward and back, the rod lifted."""
        motor, clean = MOTOR, self.turned(car)
        readings = [np.round(clean + rng.normal(0, 0.05) + rng.normal(0, 0.03, len(motor)), 2) for _ in range(runs)]
        columns = {"motor_angle_deg": np.tile(motor, runs), "cam_angle_deg": np.concatenate(readings)}
        return _record(TRANSMISSION, columns, runs)

    def turned(self, car: Car) -> np.ndarray:
        """Angle of the camshaft at `MOTOR` as its encoder shows it but for noise, degrees."""
        asked = self.asked(car, MOTOR * DEG / 45)
        cam, out = asked[0], np.empty(len(asked))
        half = car.play * STEP / 2
        for i, angle in enumerate(asked):
            cam = min(max(cam, angle - half), angle + half)
            out[i] = cam
        return (out - np.repeat([0.5, -0.5], [361, 360]) * car.lag) / DEG

    def profile(self, car: Car, rng: np.random.Generator) -> Record:
        """The outline on a measuring machine, 3 um of noise."""
        bench = replace(self.bench(car), offset=car.stylus)
        record = profile_record(self.bed, bench, rng, noise_um=3.0)
        x, y = (np.asarray(record.columns[name]) for name in ("x_mm", "y_mm"))
        return replace(record, columns={"x_mm": np.round(x + y * np.sin(car.square), 4), "y_mm": y})


def _disc(car: Car) -> tuple[Any, ...]:
    """State of the disc, by which lifts are kept."""
    return (car.bore, car.dent, car.spiral, car.offset, car.lobe, car.edge, car.wobble)


def _behind_tops(lift: np.ndarray) -> np.ndarray:
    """Half a sine over eight degrees behind each top of the lift."""
    out, width = np.zeros(CELLS), round(8 * DEG / STEP)
    smooth = np.array([lift[np.arange(i - 40, i + 41) % CELLS].max() for i in range(CELLS)])
    for top in np.flatnonzero(lift == smooth):
        out[(top + np.arange(width)) % CELLS] = np.sin(np.pi * np.arange(width) / width)
    return out


def _record(kind: Any, columns: dict[str, Any], runs: int) -> Record:
    rows = len(next(iter(columns.values()))) // runs
    run = np.repeat(np.arange(runs), rows)
    return Record(kind=kind, columns=columns, run=run, remarks=(), source=f"made {kind.code}")


def declared(rng: np.random.Generator, count: int, second: str) -> dict[str, Any]:
    """Some effects that the catalogue has and a cam takes out, among them one that the second kind of data shows."""
    draws = {
        "zero": lambda: rng.choice([-1, 1]) * rng.uniform(0.1, 0.8) * DEG,
        "play": lambda: int(rng.integers(10, 20)),
        "gain": lambda: 1 + rng.choice([-1, 1]) * rng.uniform(0.005, 0.03),
        "radius": lambda: 1 + rng.choice([-1, 1]) * rng.uniform(0.004, 0.015),
        "bore": lambda: tuple(rng.uniform(0.015, 0.05) * np.array([np.cos(a := rng.uniform(0, TURN)), np.sin(a)])),
    }
    first = "play" if second == "transmission" else "bore"
    others = [name for name in draws if name != first]
    names = [first, *rng.choice(others, count - 1, replace=False)] if count else []
    return {str(name): draws[str(name)]() for name in names}


@dataclass(frozen=True)
class Undeclared:
    """An effect that no one declared.

    Attributes:
        put: changes of the car by its size.
        most: greatest size.
        feigns: changes of the car that an instrument's error looks like, whose move of the end counts for its size.
        seconds: second kinds of data that it can be in.
        stays: whether the car on a new cam still has it; a dent goes with the old disc, an instrument stays at home.
    """

    put: Callable[[float], dict[str, Any]]
    most: float
    feigns: Callable[[float], dict[str, Any]] | None = None
    seconds: tuple[str, ...] = ("lift", "transmission", "profile")
    stays: bool = True


UNDECLARED = {
    "floor slope": Undeclared(lambda k: {"slope": (0.6 * k, -0.8 * k)}, 0.01),
    "creep": Undeclared(lambda k: {"creeps": k}, 0.01),
    "understeer": Undeclared(lambda k: {"understeer": k}, 2.0),
    "drifting zero": Undeclared(lambda k: {"drifting": k}, 1.0 * DEG),
    "wheel wear": Undeclared(lambda k: {"wear": k}, 0.02),
    "growing friction": Undeclared(lambda k: {"rubs": abs(k)}, 1.0),
    "edge worn on one flank": Undeclared(lambda k: {"flank": k}, 0.02),
    "cogging": Undeclared(lambda k: {"cogs": k}, 0.5 * DEG),
    "damaged tooth": Undeclared(lambda k: {"tooth": k}, 2.0 * DEG),
    "bounce": Undeclared(lambda k: {"bounce": abs(k)}, 0.05),
    "bent rod": Undeclared(lambda k: {"bends": k}, 0.1),
    "broken edges": Undeclared(lambda k: {"edge": abs(k)}, 0.15),
    "wobble": Undeclared(lambda k: {"wobble": (k, 40 * DEG)}, 0.3),
    "camera scale": Undeclared(lambda k: {"camera": 1 + k}, 0.003, lambda k: {"radius": 1 + k}, stays=False),
    "dent": Undeclared(lambda k: {"dent": (abs(k), 130 * DEG)}, 0.3, stays=False),
    "spiral tool wear": Undeclared(lambda k: {"spiral": k}, 0.1),
    "squareness": Undeclared(
        lambda k: {"square": k / 15}, 0.06, lambda k: {"lobe": k}, seconds=("profile",), stays=False
    ),
    "stylus": Undeclared(
        lambda k: {"stylus": abs(k)}, 0.5, lambda k: {"offset": abs(k)}, seconds=("profile",), stays=False
    ),
    "lag": Undeclared(
        lambda k: {"lag": abs(k)},
        1.0 * DEG,
        lambda k: {"play": round(abs(k) / STEP)},
        seconds=("lift", "transmission"),
        stays=False,
    ),
}


FORM = 2e-3  # mm rms, of each disc


def drawn_form(rng: np.random.Generator, shop: np.ndarray | None = None) -> np.ndarray:
    """A form error of a disc, with the spectrum of a shop, or one of its own."""
    return form_error(rng, FORM, shop)


def drawn_shop(rng: np.random.Generator) -> tuple[np.ndarray, np.ndarray]:
    """A form error of a disc, and the spectrum that discs of the shop have."""
    return form_and_variance(rng, FORM)
