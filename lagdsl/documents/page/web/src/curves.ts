// Curves over time and the energy, with a common cursor.
import uPlot from "uplot";
import { axis, curve, edged, INKS, inside, sizeIn, upright } from "./axis.ts";
import { make } from "./dom.ts";
import type { Occurrence, Head } from "./head.ts";
import type { Motion } from "./motion.ts";
import { apart, density, extremes, written } from "./numbers.ts";
import { Portrait } from "./portrait.ts";

const AT_FIRST = 4;
const HEIGHT = 190;
const MARKS = 7; // height of marks of events
const PALE = "rgb(148 163 184 / 45%)";

type Chart = [plot: uPlot, data: (motion: Motion) => Float64Array[]]; // time, then the curves

export class Curves {
  private charts: Chart[] = [];
  private readonly chosen: Set<number>; // columns
  private readonly board = make("div");
  private readonly portrait: Portrait;
  private events: Occurrence[];
  private family: Motion[] = [];
  private time = 0;
  private seen = false;

  constructor(private readonly head: Head, private motion: Motion, place: HTMLElement, private readonly sought: (time: number) => void) {
    this.events = head.events;
    const all = [...head.columns.keys()].slice(1, head.scene.first); // but the time, and those of the scene
    const own = all.filter((index) => head.curves.includes(head.columns[index].name));
    const coordinates = all.filter((index) => head.columns[index].kind === "coordinate");
    this.chosen = new Set(own.length > 0 ? own : (coordinates.length > 0 ? coordinates : all).slice(0, AT_FIRST));
    const choices = all.map((index) => this.choice(index));
    place.append(make("details", {}, make("summary", { textContent: "Choose curves" }), ...choices), this.board);
    this.portrait = new Portrait(head, motion, place);
    new ResizeObserver(([{ contentRect }]) => {
      this.seen = contentRect.width > 0;
      for (const [plot] of this.charts) plot.setSize(sizeIn(this.board, HEIGHT));
      this.portrait.resize();
      queueMicrotask(() => this.point(this.time)); // plots take their new sizes in a microtask, too
    }).observe(place);
    window.addEventListener("beforeprint", () => {
      this.seen = true;
      this.point(this.time);
    });
    this.rebuild();
  }

  private choice(index: number): HTMLElement {
    const { name, doc, display: { unit } } = this.head.columns[index];
    const box = make("input", { type: "checkbox", checked: this.chosen.has(index) });
    box.onchange = () => {
      if (box.checked) this.chosen.add(index);
      else this.chosen.delete(index);
      this.rebuild();
    };
    return make("label", { className: "choice", title: doc ?? "" }, box, unit ? `${name} [${unit}]` : name);
  }

  /** A chart for each unit among the chosen columns, one of the energy. */
  private rebuild(): void {
    for (const [plot] of this.charts) plot.destroy();
    this.charts = [];
    const { columns, scene } = this.head;
    const chosen = [...this.chosen].sort((a, b) => a - b);
    for (const unit of new Set(chosen.map((index) => columns[index].display.unit))) {
      const members = chosen.filter((index) => columns[index].display.unit === unit);
      this.add(unit, members.map((index) => columns[index].name), (motion) =>
        [motion.column(0), ...members.map((index) => motion.shown(columns, index))]);
    }
    this.add("J", ["energy"], (motion) => [motion.column(0), motion.column(scene.first + scene.count)]);
    this.point(this.time);
  }

  /** Ticks of events below, other runs behind. */
  private underlay(plot: uPlot, data: Chart[1]): void {
    for (const [times, ...columns] of this.family.map(data)) for (const column of columns) curve(plot, times, column, PALE, 1);
    const { bbox: { left, top, width, height }, scales: { x: { min: start = 0, max: stop = 1 } } } = plot;
    const high = MARKS * window.devicePixelRatio;
    const often = density(this.events, start, stop);
    inside(plot, (pen) => {
      pen.fillStyle = "#64748b";
      often.forEach((part, k) => {
        pen.globalAlpha = 0.5 * part;
        pen.fillRect(left + (width * k) / often.length, top + height - high, width / often.length, high);
      });
      pen.globalAlpha = 1;
      pen.fillStyle = "#dc2626";
      for (const { time } of apart(this.events, start, stop)) {
        pen.fillRect(plot.valToPos(time, "x", true), top + height - high, window.devicePixelRatio, high);
      }
    });
  }

  private add(unit: string, names: string[], data: Chart[1]): void {
    /** The range of all runs. */
    const range = (_: uPlot, low: number | null, high: number | null): [number, number] =>
      edged(...this.family.flatMap((other) => data(other).slice(1)).reduce<[number, number]>(
        (ends, column) => extremes(column, ...ends), [low ?? 0, high ?? 1]));
    const curves = names.map((label, i) => ({
      label, stroke: INKS[i % INKS.length], width: 1.5, value: (_: uPlot, x: number | null) => told(x, unit),
    }));
    const seek = (plot: uPlot): void => {
      if (plot.cursor.left !== undefined && plot.cursor.left >= 0) this.sought(plot.posToVal(plot.cursor.left, "x"));
    };
    const plot = new uPlot(
      {
        ...sizeIn(this.board, HEIGHT),
        scales: { x: { time: false }, y: { range } },
        axes: [{ ...axis("t [s]"), size: 40 }, upright(unit === "" ? "" : `[${unit}]`)],
        cursor: { sync: { key: "time" }, drag: { x: false, y: false } },
        series: [{ label: "t", value: (_, t) => told(t, "s") }, ...curves],
        hooks: {
          ready: [(made) => made.over.addEventListener("click", () => seek(made))],
          drawAxes: [(made) => this.underlay(made, data)],
        },
      },
      data(this.motion) as uPlot.AlignedData,
      this.board,
    );
    this.charts.push([plot, data]);
  }

  /** Another motion with its events. */
  show(motion: Motion, events: Occurrence[]): void {
    this.motion = motion;
    this.events = events;
    for (const [plot, data] of this.charts) plot.setData(data(motion) as uPlot.AlignedData);
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
    for (const [plot] of this.charts) plot.setCursor({ left: plot.valToPos(time, "x"), top: -10 }, false);
    this.portrait.point(time);
  }
}

/** A value with its unit, as the cursor reads it. */
function told(value: number | null, unit: string): string {
  return value === null || !Number.isFinite(value) ? "–" : `${written(value, 5)} ${unit}`;
}
