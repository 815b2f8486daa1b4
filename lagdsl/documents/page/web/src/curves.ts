// Charts of columns: over time, with a common cursor, and one over another, as a phase portrait or a path.
import uPlot from "uplot";
import { axis, curve, edged, INKS, sizeIn, upright } from "./axis.ts";
import { choice, make } from "./dom.ts";
import type { Column, Head, Occurrence } from "./head.ts";
import type { Motion } from "./motion.ts";
import { written } from "./numbers.ts";
import { ticks } from "./ticks.ts";

const AT_FIRST = 4;
const LONGEST_NAME = 20;
const HEIGHT = 190;
const HEIGHT_OF_PORTRAIT = 240;
const PALE = "rgb(148 163 184 / 45%)";

/** Of what goes to the right and upward. */
type Chart = { plot: uPlot; data: (motion: Motion) => Float64Array[] };

export class Curves {
  private charts: Chart[] = []; // the portrait is the last one
  private readonly columns: Pick<Column, "name" | "display">[];
  private readonly chosen: Set<number>; // columns over time
  private readonly board = make("div");
  private readonly portrait = make("div");
  private readonly across: HTMLSelectElement[]; // columns of the portrait: to the right, and upward
  private events: Occurrence[];
  private family: Motion[] = []; // other runs, which stand pale behind the one that is shown
  private time = 0;
  private seen = false;

  constructor(head: Head, private motion: Motion, place: HTMLElement, private readonly sought: (time: number) => void) {
    this.events = head.events;
    const energy = head.scene.first + head.scene.count;
    const all = [...head.columns.keys()].slice(1, head.scene.first); // but the time, and those of the scene
    this.columns = [...head.columns];
    this.columns[energy] = { name: "energy", display: { unit: "J", scale: 1, shift: 0 } };
    const own = all.filter((index) => head.curves.includes(head.columns[index].name));
    const coordinates = all.filter((index) => head.columns[index].kind === "coordinate");
    this.chosen = new Set([energy, ...(own.length > 0 ? own : (coordinates.length > 0 ? coordinates : all).slice(0, AT_FIRST))]);
    const choices = all.map((index) => this.choice(index, head.columns[index].doc ?? ""));
    const [right, up] = coordinates.length > 0 ? [1, 1 + coordinates.length] : [Math.min(1, all.length), all.length];
    const names = [0, ...all].map((index) => head.columns[index].name);
    this.across = [["to the right", right] as const, ["upward", up] as const].map(([way, first]) =>
      choice(`Column of the portrait, ${way}`, names, first, () => this.rebuild()));
    place.append(
      make("details", {}, make("summary", { textContent: "Choose curves" }), ...choices), this.board,
      make("p", { className: "portrait", hidden: all.length === 0 }, this.across[1], " over ", this.across[0]), this.portrait);
    new ResizeObserver(([{ contentRect }]) => {
      this.seen = contentRect.width > 0;
      for (const { plot } of this.charts) plot.setSize(sizeIn(this.board, plot.height));
      queueMicrotask(() => this.point(this.time)); // plots take their new sizes in a microtask, too
    }).observe(place);
    window.addEventListener("beforeprint", () => {
      this.seen = true;
      this.point(this.time);
    });
    this.rebuild();
  }

  private choice(index: number, title: string): HTMLElement {
    const { name, display: { unit } } = this.columns[index];
    const box = make("input", { type: "checkbox", checked: this.chosen.has(index) });
    box.onchange = () => {
      if (!this.chosen.delete(index)) this.chosen.add(index);
      this.rebuild();
    };
    return make("label", { className: "choice", title }, box, unit ? `${name} [${unit}]` : name);
  }

  /** A chart for each unit among the chosen columns, and the portrait. */
  private rebuild(): void {
    for (const { plot } of this.charts) plot.destroy();
    const chosen = [...this.chosen].sort((a, b) => a - b);
    const unit = (index: number): string => this.columns[index].display.unit;
    const units = [...new Set(chosen.map(unit))];
    const [right, up] = this.across.map(({ selectedIndex }) => selectedIndex);
    this.charts = [...units.map((each) => this.chart(0, chosen.filter((index) => unit(index) === each))), this.chart(right, [up], true)];
    this.show(this.motion, this.events);
    this.point(this.time);
  }

  private chart(right: number, up: number[], portrait = false): Chart {
    const data = (motion: Motion): Float64Array[] => [right, ...up].map((index) => motion.shown(this.columns, index));
    const label = (index: number): string => {
      const { name, display } = this.columns[index];
      const unit = `[${display.unit || "1"}]`;
      return portrait && name.length <= LONGEST_NAME ? `${name} ${unit}` : unit; // legend and choices tell the name, too
    };
    /** Of all runs. */
    const range = (from: number, to?: number) => (plot: uPlot): [number, number] =>
      edged([plot.data, ...this.family.map(data)].flatMap((columns) => (columns as Float64Array[]).slice(from, to)));
    const series = [right, ...up].map((index, i): uPlot.Series => ({
      label: this.columns[index].name,
      stroke: INKS[(i + INKS.length - 1) % INKS.length],
      width: 1.5,
      value: (_, value: number | null) => `${written(value ?? NaN, 5)} ${this.columns[index].display.unit}`,
      ...(portrait && { paths: () => null }),
    }));
    const draw = (plot: uPlot): void => {
      for (const [x, ...columns] of this.family.map(data)) for (const column of columns) curve(plot, x, column, PALE, 1);
      if (portrait) curve(plot, ...(plot.data as unknown as [Float64Array, Float64Array]), INKS[0], 1.5);
    };
    const plot = new uPlot(
      {
        ...sizeIn(this.board, portrait ? HEIGHT_OF_PORTRAIT : HEIGHT),
        scales: { x: { time: false, ...(portrait && { range: range(0, 1) }) }, y: { range: range(1) } },
        axes: [{ ...axis(portrait ? label(right) : "t [s]"), size: 40 }, upright(label(up[0]))],
        cursor: portrait
          ? { x: false, y: false, dataIdx: () => this.motion.rowAt(this.time), points: { size: 9, fill: "#dc2626" } }
          : { sync: { key: "time" }, drag: { x: false, y: false } },
        legend: { show: !portrait },
        series,
        hooks: { drawAxes: [draw] },
      },
      data(this.motion) as uPlot.AlignedData,
      portrait ? this.portrait : this.board,
    );
    if (!portrait) plot.over.append(make("div", { className: "ticks" }));
    plot.over.onclick = () => this.sought(plot.posToVal(plot.cursor.left ?? 0, "x"));
    return { plot, data };
  }

  /** Another motion with its events. */
  show(motion: Motion, events: Occurrence[]): void {
    this.motion = motion;
    this.events = events;
    for (const { plot, data } of this.charts) plot.setData(data(motion) as uPlot.AlignedData);
    if (motion.count === 0) return;
    for (const place of this.board.querySelectorAll(".ticks")) place.replaceChildren(...ticks(events, motion.at(0, 0), motion.last));
  }

  behind(family: Motion[]): void {
    this.family = family;
    this.rebuild();
  }

  /** The present moment. */
  point(time: number): void {
    this.time = time;
    if (!this.seen) return;
    const over = this.charts.slice(0, -1);
    for (const { plot } of over) plot.setCursor({ left: plot.valToPos(time, "x"), top: -10 }, false);
    this.charts.at(-1)?.plot.setCursor({ left: 0, top: 0 }, false);
  }
}
