// Curves over time, a phase portrait, the energy.
import uPlot from "uplot";
import type { Column, Head } from "./head.ts";
import type { Motion } from "./motion.ts";

const INKS = ["#2563eb", "#dc2626", "#16a34a", "#d97706", "#7c3aed", "#0891b2", "#db2777", "#65a30d"];
const AT_FIRST = 4;

interface Chart {
  plot: uPlot;
  data(motion: Motion): uPlot.AlignedData;
}

export class Curves {
  private readonly charts: Chart[] = [];
  private readonly chosen: Set<number>;
  private readonly board: HTMLElement;
  private motion: Motion;

  constructor(
    private readonly head: Head,
    motion: Motion,
    place: HTMLElement,
    private readonly sought: (time: number) => void,
  ) {
    this.motion = motion;
    const columns = this.columns();
    const first = columns.filter(({ column }) => column.kind === "coordinate").slice(0, AT_FIRST);
    this.chosen = new Set((first.length > 0 ? first : columns.slice(0, AT_FIRST)).map(({ index }) => index));
    const list = document.createElement("details");
    const summary = document.createElement("summary");
    summary.textContent = "Choose curves";
    list.append(summary, ...columns.map(({ column, index }) => this.choice(column, index)));
    this.board = document.createElement("div");
    place.append(list, this.board);
    new ResizeObserver(() => this.resize()).observe(place);
    this.rebuild();
  }

  /** All columns but the time and those of the scene. */
  private columns(): { column: Column; index: number }[] {
    return this.head.columns.map((column, index) => ({ column, index })).slice(1, this.head.scene.first);
  }

  private choice(column: Column, index: number): HTMLElement {
    const label = document.createElement("label");
    label.className = "choice";
    const box = document.createElement("input");
    box.type = "checkbox";
    box.checked = this.chosen.has(index);
    box.onchange = () => {
      if (box.checked) this.chosen.add(index);
      else this.chosen.delete(index);
      this.rebuild();
    };
    label.append(box, `${column.name}${column.display.unit ? ` [${column.display.unit}]` : ""}`);
    label.title = column.doc ?? "";
    return label;
  }

  /** A chart for each unit among the chosen columns, one of the energy, one of the phase plane. */
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
    const [q] = [...this.chosen].filter((index) => this.head.columns[index].kind === "coordinate");
    if (q !== undefined) this.phase(q);
  }

  private value(motion: Motion, index: number): Float64Array {
    const { scale, shift } = this.head.columns[index].display;
    return motion.column(index).map((si) => si * scale + shift);
  }

  private overTime(unit: string, members: number[]): void {
    const names = members.map((index) => this.head.columns[index].name);
    this.add(unit, names, (motion) => [motion.column(0), ...members.map((index) => this.value(motion, index))]);
  }

  private add(unit: string, names: string[], data: Chart["data"]): void {
    const plot = new uPlot(
      {
        ...this.size(),
        scales: { x: { time: false } },
        axes: [{ ...axis("t [s]"), size: 40 }, { ...axis(unit === "" ? "" : `[${unit}]`), size: 64 }],
        cursor: { sync: { key: "time" }, drag: { x: false, y: false } },
        series: [{ label: "t [s]" }, ...names.map((label, i) => ({ label, stroke: INKS[i % INKS.length], width: 1.5 }))],
        hooks: { ready: [(made) => made.over.addEventListener("click", () => this.seek(made))] },
      },
      data(this.motion),
      this.board,
    );
    this.charts.push({ plot, data });
  }

  private seek(plot: uPlot): void {
    if (plot.cursor.left !== undefined && plot.cursor.left >= 0) this.sought(plot.posToVal(plot.cursor.left, "x"));
  }

  private phase(q: number): void {
    const count = this.head.columns.filter((column) => column.kind === "coordinate").length;
    const [position, rate] = [this.head.columns[q], this.head.columns[q + count]];
    const data = (motion: Motion): uPlot.AlignedData => {
      const pair: [Float64Array, Float64Array] = [this.value(motion, q), this.value(motion, q + count)];
      return [null, pair] as unknown as uPlot.AlignedData;
    };
    const title = (column: Column): string => `${column.name} [${column.display.unit || "1"}]`;
    const draw = (plot: uPlot): null => {
      const [x, y] = plot.data[1] as unknown as [Float64Array, Float64Array];
      const { ctx } = plot;
      ctx.save();
      ctx.beginPath();
      ctx.rect(plot.bbox.left, plot.bbox.top, plot.bbox.width, plot.bbox.height);
      ctx.clip();
      ctx.beginPath();
      x.forEach((value, i) => ctx.lineTo(plot.valToPos(value, "x", true), plot.valToPos(y[i], "y", true)));
      ctx.strokeStyle = INKS[0];
      ctx.lineWidth = 1.5 * window.devicePixelRatio;
      ctx.stroke();
      ctx.restore();
      return null;
    };
    const limits = (k: 0 | 1) => (plot: uPlot): [number, number] => {
      const values = ((plot.data?.[1] as unknown as Float64Array[] | undefined)?.[k] ?? new Float64Array([0, 1])) as Float64Array;
      let [low, high] = [Infinity, -Infinity];
      for (const value of values) if (Number.isFinite(value)) [low, high] = [Math.min(low, value), Math.max(high, value)];
      if (!(high > low)) [low, high] = [low - 1, low + 1];
      return [low - 0.06 * (high - low), high + 0.06 * (high - low)];
    };
    const plot = new uPlot(
      {
        ...this.size(),
        mode: 2,
        scales: { x: { time: false, range: limits(0) }, y: { range: limits(1) } },
        axes: [{ ...axis(title(position)), size: 40 }, { ...axis(title(rate)), size: 64 }],
        cursor: { show: false },
        legend: { show: false },
        series: [{}, { facets: [{ scale: "x", auto: true }, { scale: "y", auto: true }], paths: draw } as uPlot.Series],
      },
      data(this.motion),
      this.board,
    );
    this.charts.push({ plot, data });
  }

  show(motion: Motion): void {
    this.motion = motion;
    for (const { plot, data } of this.charts) plot.setData(data(motion));
  }

  /** The cursor of all charts over time. */
  point(time: number): void {
    const chart = this.charts[0]?.plot;
    if (chart !== undefined) chart.setCursor({ left: chart.valToPos(time, "x"), top: -10 });
  }

  private size(): { width: number; height: number } {
    return { width: Math.max(this.board.clientWidth, 240), height: 190 };
  }

  private resize(): void {
    for (const { plot } of this.charts) plot.setSize(this.size());
  }
}

function axis(label: string): uPlot.Axis {
  const style = getComputedStyle(document.documentElement);
  const ink = style.getPropertyValue("--ink-soft").trim();
  const grid = { stroke: style.getPropertyValue("--line").trim(), width: 1 };
  return { label, stroke: ink, grid, ticks: grid, labelSize: 18, font: "11px system-ui", labelFont: "11px system-ui" };
}
