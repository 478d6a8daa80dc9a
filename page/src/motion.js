// Where everything stands at a motor position: the page computes no mechanics, it reads tables between their entries.
const TURN = 2 * Math.PI;

/** Angle by which an arm has turned about its pivot since cam angle 0, by the way of its follower's middle, rad. */
export function swung(pivot, [x, y], { ahead, across }) {
  return Math.atan2(y + across - pivot[1], x + ahead - pivot[0]) - Math.atan2(y - pivot[1], x - pivot[0]);
}

export class Motion {
  constructor(scene, charts) {
    this.scene = scene;
    this.goings = Object.fromEntries(scene.goings.map((going) => [going.code, going]));
    this.pressure = charts.find((chart) => chart.code === "pressure");
    const { goings } = this;
    // Of a cam without a car there is no run: it stands where the motor does.
    this.withPlay = goings.played ?? null;
    this.withoutPlay = goings.free ?? null;
    this.planned = goings.planned ?? this.withoutPlay;
    this.arcs = new Map();
  }

  /** Lift and motion at a cam angle, rad: on a car the motion is the tangent of the steering angle. */
  lift(theta) {
    const { lift, travel, second } = this.scene;
    if (lift.lift.length === 0) return { lift: NaN, tan: 0 }; // gears without a cam
    const place = ((((theta % TURN) + TURN) % TURN) / TURN) * (lift.lift.length - 1);
    const left = Math.min(Math.floor(place), lift.lift.length - 2);
    const share = place - left;
    const between = (values) => values[left] + share * (values[left + 1] - values[left]);
    const along = (ways) => ways && { ahead: between(ways.ahead), across: between(ways.across), turned: between(ways.turned) };
    return { lift: between(lift.lift), tan: between(lift.tan), way: along(travel), secondWay: along(second?.travel) };
  }

  /** State of a run at a motor position, rad. */
  at(going, phi) {
    if (!going) return { theta: phi, share: 0, x: 0, y: 0, heading: 0 };
    const { motor, lead, x, y, heading, play } = going;
    const end = motor.length - 1;
    const here = Math.min(Math.max(phi, motor[0]), motor[end]);
    let low = 0;
    let high = end;
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (motor[middle] <= here) low = middle;
      else high = middle;
    }
    const wide = motor[high] - motor[low];
    const share = wide > 0 ? (here - motor[low]) / wide : 0;
    const between = (values) => values[low] + share * (values[high] - values[low]);
    const ahead = phi > motor[end] ? 0 : between(lead);
    return {
      theta: phi + ahead,
      share: play > 0 ? Math.min(Math.max(ahead / play, 0), 1) : 0,
      x: between(x),
      y: between(y),
      heading: between(heading),
    };
  }

  /** Everything that the page shows at a motor position. */
  state(phi, play) {
    const going = play && this.withPlay ? this.withPlay : this.withoutPlay;
    const here = this.at(going, phi);
    const { lift, tan, way, secondWay } = this.lift(here.theta);
    const planned = this.at(this.planned, phi);
    return {
      ...here,
      going,
      phi,
      lift,
      tan,
      way,
      secondWay,
      planned,
      plannedTan: this.lift(planned.theta).tan,
      off: Math.hypot(here.x - planned.x, here.y - planned.y),
      pressure: this.chart(this.pressure, 0, here.theta),
      run: going ? this.travel(going, phi) : NaN,
    };
  }

  /** Value of a chart's curve at a cam angle, rad. */
  chart(chart, curve, theta) {
    if (!chart) return NaN;
    const values = chart.curves[curve].values;
    const place = ((((theta % TURN) + TURN) % TURN) / TURN) * (values.length - 1);
    const left = Math.min(Math.floor(place), values.length - 2);
    return values[left] + (place - left) * (values[left + 1] - values[left]);
  }

  /** Way of the drive wheel up to a motor position, mm. */
  travel(going, phi) {
    if (!this.arcs.has(going)) {
      const sums = new Float64Array(going.motor.length);
      for (let i = 1; i < sums.length; i++) {
        sums[i] = sums[i - 1] + Math.hypot(going.x[i] - going.x[i - 1], going.y[i] - going.y[i - 1]);
      }
      this.arcs.set(going, sums);
    }
    const sums = this.arcs.get(going);
    return sums[sums.length - 1] * Math.min(phi / going.motor[going.motor.length - 1], 1);
  }

  /** Angle of a shaft, rad. */
  shaft(index, state) {
    const shaft = this.scene.shafts[index];
    if (index === 0) return -state.theta;
    return shaft.angle + shaft.rate * state.phi + shaft.lead * state.share;
  }

  /** Place of a shaft's axis, mm: that of a planet goes round with its carrier. */
  place(index, state) {
    const { axis, round } = this.scene.shafts[index];
    if (round === null) return axis;
    const { axis: middle, rate, lead } = this.scene.shafts[round];
    const turn = rate * state.phi + lead * state.share;
    const [x, y] = [axis[0] - middle[0], axis[1] - middle[1]];
    const [c, s] = [Math.cos(turn), Math.sin(turn)];
    return [middle[0] + c * x - s * y, middle[1] + s * x + c * y];
  }
}
