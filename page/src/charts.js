// Curves over the cam angle, one under the other, with one cursor; the slider's place is a line across all of them.
import uPlot from "uplot";
import { MANY } from "./transport.js";
import { pick, translated } from "./words.js";

const TURN = 360;
const BESIDE = 2.2; // a limit so many times as far off as the curve itself would press it flat, and is only named
const css = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
const colours = () => [css("--curve-1"), css("--curve-2"), css("--curve-3")];

/** The curves; `use` draws those of a model, and later those of another one. */
export function drawCharts(choose) {
  const sync = uPlot.sync("cam-angle");
  let charts = [];
  let width = 0;
  const fit = (forced) => {
    const room = document.querySelector(".charts .plot")?.clientWidth ?? 0;
    if (room && (forced || room !== width)) {
      width = room;
      for (const chart of charts) chart.draw(room);
    }
  };
  new ResizeObserver(() => fit(false)).observe(document.querySelector(".charts"));
  translated(() => charts.forEach((chart) => chart.name()));
  return {
    use(data, motion) {
      for (const chart of charts) chart.plot?.destroy();
      charts = data.charts.map((chart) => new Drawn(chart, data.marks, motion, sync, choose));
      fit(true);
      for (const chart of charts) chart.name();
    },
    show: (state) => charts.forEach((chart) => chart.show(state)),
    redraw: () => fit(true),
    print: (on) => {
      for (const chart of charts) chart.draw(on ? 640 : width);
    },
  };
}

class Drawn {
  constructor(chart, marks, motion, sync, choose) {
    Object.assign(this, { chart, marks, motion, sync, choose });
    this.box = document.getElementById(`chart-${chart.code}`);
    this.now = this.box.querySelector(".now");
    this.data = [chart.angle, ...chart.curves.map(({ values }) => (values.some(Number.isNaN) ? Array.from(values, (v) => (Number.isNaN(v) ? null : v)) : values))];
    this.hovered = null;
    this.angle = 0;
  }

  draw(width) {
    this.plot?.destroy();
    const { chart } = this;
    const [ink, muted, grid] = [css("--ink"), css("--muted"), css("--line")];
    const colour = colours();
    const axis = { stroke: muted, grid: { stroke: grid, width: 1 }, ticks: { stroke: grid, width: 1, size: 4 }, font: "11px system-ui" };
    const phone = width < 480;
    this.plot = new uPlot(
      {
        width,
        height: phone ? 132 : 150,
        cursor: { sync: { key: this.sync.key }, drag: { x: false, y: false }, points: { size: 6 } },
        legend: { show: false },
        padding: [10, 18, 0, 0],
        scales: { x: { time: false, range: [0, TURN] }, y: { range: (_, low, high) => this.range(low, high) } },
        axes: [
          { ...axis, size: 26, incrs: phone ? [60, 90] : [30, 60, 90], values: (_, places) => places.map((v) => `${v}°`) },
          { ...axis, size: 52, space: 26, values: (_, places) => places.map((v) => String(Number(v.toPrecision(3)))) },
        ],
        series: [
          {},
          ...chart.curves.map((curve, i) => ({ stroke: colour[i], width: 1.6, dash: curve.dashed ? [5, 4] : undefined, points: { show: false } })),
        ],
        hooks: {
          drawClear: [(plot) => this.backdrop(plot)],
          drawAxes: [(plot) => this.limits(plot, ink)],
          setCursor: [(plot) => this.hover(plot)],
        },
      },
      this.data,
      this.box.querySelector(".plot"),
    );
    this.line = Object.assign(document.createElement("div"), { className: "here" });
    this.plot.over.append(this.line);
    this.plot.over.addEventListener("click", (event) => {
      const x = event.clientX - this.plot.over.getBoundingClientRect().left;
      this.choose(this.plot.posToVal(x, "x"));
    });
    this.place();
  }

  range(low, high) {
    if (low === null) return [-1, 1];
    const size = Math.max(Math.abs(low), Math.abs(high), 1e-9);
    for (const { value } of this.chart.limits) {
      if (Math.abs(value) <= BESIDE * size) [low, high] = [Math.min(low, value), Math.max(high, value)];
    }
    const room = 0.08 * (high - low || 1);
    return [low >= 0 ? Math.min(low, 0) : low - room, high <= 0 ? 0 : high + room];
  }

  /** The blend as a grey field, and a faint line at each peak and valley. */
  backdrop({ ctx, bbox, valToPos }) {
    ctx.save();
    for (const { kind, angle } of this.marks) {
      const x = valToPos((angle * 180) / Math.PI, "x", true);
      if (kind === "blend") {
        ctx.fillStyle = css("--field");
        ctx.fillRect(x, bbox.top, bbox.left + bbox.width - x, bbox.height);
      } else {
        ctx.fillStyle = css("--muted");
        const up = kind === "peak" ? -1 : 1;
        const [half, y] = [(this.marks.length > MANY ? 2 : 4) * devicePixelRatio, bbox.top - 1];
        ctx.beginPath();
        ctx.moveTo(x - half, y - (up < 0 ? 0 : half * 1.4));
        ctx.lineTo(x + half, y - (up < 0 ? 0 : half * 1.4));
        ctx.lineTo(x, y - (up < 0 ? half * 1.4 : 0));
        ctx.fill();
        ctx.globalAlpha = 0.35;
        ctx.fillRect(Math.round(x), bbox.top, 1, bbox.height);
        ctx.globalAlpha = 1;
      }
    }
    ctx.restore();
  }

  limits({ ctx, bbox, valToPos, scales }) {
    ctx.save();
    ctx.strokeStyle = css("--bad");
    ctx.setLineDash([8, 5]);
    ctx.lineWidth = devicePixelRatio;
    for (const { value } of this.chart.limits) {
      if (value < scales.y.min || value > scales.y.max) continue;
      const y = Math.round(valToPos(value, "y", true));
      ctx.beginPath();
      ctx.moveTo(bbox.left, y);
      ctx.lineTo(bbox.left + bbox.width, y);
      ctx.stroke();
    }
    ctx.restore();
  }

  hover(plot) {
    const { left } = plot.cursor;
    this.hovered = left === undefined || left < 0 ? null : plot.posToVal(left, "x");
    this.values();
  }

  show(state) {
    this.angle = (state.phi * 180) / Math.PI;
    this.theta = state.theta;
    this.place();
    this.values();
  }

  place() {
    if (this.line) this.line.style.transform = `translateX(${this.plot.valToPos(this.angle, "x")}px)`;
  }

  /** Names of the curves and limits, made once for a language. */
  name() {
    const { curves, limits } = this.chart;
    this.now.replaceChildren();
    this.texts = curves.map((curve, i) => {
      const item = document.createElement("span");
      item.className = `curve c${i + 1}${curve.dashed ? " dashed" : ""}`;
      const value = document.createElement("b");
      item.append(`${pick(curve.label)} `, value);
      this.now.append(item);
      return value;
    });
    for (const { label, value } of limits) {
      const item = document.createElement("span");
      item.className = "limit";
      item.textContent = `${pick(label)} ${Number(value.toPrecision(4))}`;
      this.now.append(item);
    }
    this.values();
  }

  values() {
    if (!this.texts) return;
    const angle = this.hovered ?? ((this.theta ?? 0) * 180) / Math.PI;
    this.texts.forEach((node, i) => {
      const value = this.motion.chart(this.chart, i, (angle * Math.PI) / 180);
      const text = Number.isFinite(value) ? value.toFixed(Math.abs(value) >= 100 ? 1 : 2).replace(/^-(0\.?0*)$/, "$1") : "–";
      if (node.textContent !== text) node.textContent = text;
    });
  }
}
