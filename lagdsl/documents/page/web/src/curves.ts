// Curves over time and the energy, with a common cursor.
import uPlot from "uplot";
import { axis, edged, INKS, upright, WIDE } from "./axis.ts";
import { make } from "./dom.ts";
import type { Column, Occurrence, Head } from "./head.ts";
import type { Motion } from "./motion.ts";
import { apart, density, written } from "./numbers.ts";
import { Portrait } from "./portrait.ts";

const AT_FIRST = 4;

interface Chart {
  plot: uPlot;
  data(motion: Motion): uPlot.AlignedData;
}

export class Curves {
  private readonly charts: Chart[] = [];
  private readonly chosen: Set<number>;
  private readonly board: HTMLElement;
  private readonly portrait: Portrait;
  private motion: Motion;
  private events: Occurrence[];
  private family: Motion[] = [];
  private time = 0;
  private seen = false;

  constructor(
    private readonly head: Head,
    motion: Motion,
    place: HTMLElement,
    private readonly sought: (time: number) => void,
  ) {
    this.motion = motion;
    this.events = head.events;
    const columns = this.columns();
    const own = columns.filter(({ column }) => head.curves.includes(column.name));
    const first = own.length > 0 ? own : columns.filter(({ column }) => column.kind === "coordinate").slice(0, AT_FIRST);
    this.chosen = new Set((first.length > 0 ? first : columns.slice(0, AT_FIRST)).map(({ index }) => index));
    const choices = columns.map(({ column, index }) => this.choice(column, index));
    this.board = make("div");
    place.append(make("details", {}, make("summary", { textContent: "Choose curves" }), ...choices), this.board);
    this.portrait = new Portrait(head, motion, place);
    new ResizeObserver(([{ contentRect }]) => {
      this.seen = contentRect.width > 0;
      this.resize();
    }).observe(place);
    window.addEventListener("beforeprint", () => {
      this.seen = true;
      this.point(this.time);
    });
    this.rebuild();
  }

  /** All columns but the time and those of the scene. */
  private columns(): { column: Column; index: number }[] {
    return this.head.columns.map((column, index) => ({ column, index })).slice(1, this.head.scene.first);
  }

  private choice(column: Column, index: number): HTMLElement {
    const box = make("input", { type: "checkbox", checked: this.chosen.has(index) });
    box.onchange = () => {
      if (box.checked) this.chosen.add(index);
      else this.chosen.delete(index);
      this.rebuild();
    };
    const unit = column.display.unit ? ` [${column.display.unit}]` : "";
    return make("label", { className: "choice", title: column.doc ?? "" }, box, `${column.name}${unit}`);
  }

  /** A chart for each unit among the chosen columns, one of the energy. */
  private rebuild(): void {
    for (const chart of this.charts) chart.plot.destroy();
    this.charts.length = 0;
    const byUnit = new Map<string, number[]>();
    for (const index of [...this.chosen].sort((a, b) => a - b)) {
      const unit = this.head.columns[index].display.unit;
      byUnit.set(unit, [...(byUnit.get(unit) ?? []), index]);
    }
    for (const [unit, members] of byUnit) this.overTime(unit, members);
    const energy = this.head.scene.first + this.head.scene.count;
    const titled = { name: "energy", display: { unit: "J", scale: 1, shift: 0 } };
    this.add("J", [titled.name], (motion) => [motion.column(0), motion.column(energy)]);
    this.point(this.time);
  }

  private value(motion: Motion, index: number): Float64Array {
    const { scale, shift } = this.head.columns[index].display;
    return motion.column(index).map((si) => si * scale + shift);
  }

  private overTime(unit: string, members: number[]): void {
    const names = members.map((index) => this.head.columns[index].name);
    const values = (motion: Motion): Float64Array[] => members.map((index) => this.value(motion, index));
    this.add(unit, names, (motion) => [motion.column(0), ...values(motion)]);
  }

  /** Ticks of events below, other runs behind. */
  private underlay(plot: uPlot, data: Chart["data"]): void {
    const { ctx, bbox } = plot;
    ctx.save();
    ctx.beginPath();
    ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
    ctx.clip();
    ctx.lineWidth = window.devicePixelRatio;
    ctx.strokeStyle = "rgb(148 163 184 / 45%)";
    for (const other of this.family) {
      const [times, ...columns] = data(other) as Float64Array[];
      for (const column of columns) {
        ctx.beginPath();
        times.forEach((time, i) => ctx.lineTo(plot.valToPos(time, "x", true), plot.valToPos(column[i], "y", true)));
        ctx.stroke();
      }
    }
    const { min: start = 0, max: stop = 1 } = plot.scales.x;
    const high = 7 * window.devicePixelRatio;
    const often = density(this.events, start, stop);
    ctx.fillStyle = "#64748b";
    often.forEach((part, k) => {
      ctx.globalAlpha = 0.5 * part;
      ctx.fillRect(bbox.left + (bbox.width * k) / often.length, bbox.top + bbox.height - high, bbox.width / often.length, high);
    });
    ctx.globalAlpha = 1;
    ctx.strokeStyle = "#dc2626";
    for (const { time } of apart(this.events, start, stop)) {
      const x = plot.valToPos(time, "x", true);
      ctx.beginPath();
      ctx.moveTo(x, bbox.top + bbox.height);
      ctx.lineTo(x, bbox.top + bbox.height - high);
      ctx.stroke();
    }
    ctx.restore(); // the alpha, too
  }

  /** The range of all runs. */
  private range(data: Chart["data"], low: number | null, high: number | null): [number, number] {
    let [least, most] = [low ?? 0, high ?? 1];
    for (const other of this.family) {
      for (const column of (data(other) as Float64Array[]).slice(1)) {
        for (const value of column) if (Number.isFinite(value)) [least, most] = [Math.min(least, value), Math.max(most, value)];
      }
    }
    return edged(least, most);
  }

  private add(unit: string, names: string[], data: Chart["data"]): void {
    const plot = new uPlot(
      {
        ...this.size(),
        scales: { x: { time: false }, y: { range: (_, low, high) => this.range(data, low, high) } },
        axes: [{ ...axis("t [s]"), size: 40 }, upright(unit === "" ? "" : `[${unit}]`)],
        cursor: { sync: { key: "time" }, drag: { x: false, y: false } },
        series: [
          { label: "t", value: (_, t) => told(t, "s") },
          ...names.map((label, i) => ({ label, stroke: INKS[i % INKS.length], width: 1.5, value: (_: uPlot, x: number | null) => told(x, unit) })),
        ],
        hooks: {
          ready: [(made) => made.over.addEventListener("click", () => this.seek(made))],
          drawAxes: [(made) => this.underlay(made, data)],
        },
      },
      data(this.motion),
      this.board,
    );
    this.charts.push({ plot, data });
  }

  private seek(plot: uPlot): void {
    if (plot.cursor.left !== undefined && plot.cursor.left >= 0) this.sought(plot.posToVal(plot.cursor.left, "x"));
  }

  /** Another motion with its events. */
  show(motion: Motion, events: Occurrence[]): void {
    this.motion = motion;
    this.events = events;
    for (const { plot, data } of this.charts) plot.setData(data(motion));
    this.portrait.show(motion);
  }

  /** Other runs, which stand pale behind the one that is shown. */
  behind(family: Motion[]): void {
    this.family = family;
    this.rebuild();
  }

  /** The cursor of all charts over time. */
  point(time: number): void {
    this.time = time;
    if (!this.seen) return;
    for (const { plot } of this.charts) plot.setCursor({ left: plot.valToPos(time, "x"), top: -10 }, false);
    this.portrait.point(time);
  }

  private size(): { width: number; height: number } {
    return { width: Math.max(this.board.clientWidth || WIDE, 240), height: 190 };
  }

  private resize(): void {
    for (const { plot } of this.charts) plot.setSize(this.size());
    this.portrait.resize();
    queueMicrotask(() => this.point(this.time)); // plots take their new sizes in a microtask, too
  }
}

/** A value with its unit, as the cursor reads it. */
function told(value: number | null, unit: string): string {
  return value === null || !Number.isFinite(value) ? "–" : `${written(value, 5)} ${unit}`;
}
