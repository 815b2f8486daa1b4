// One column against another: a phase portrait, or a path.
import uPlot from "uplot";
import { axis, edged, INKS, upright, WIDE } from "./axis.ts";
import { make } from "./dom.ts";
import type { Column, Head } from "./head.ts";
import type { Motion } from "./motion.ts";

const LONGEST_NAME = 20;

export class Portrait {
  private plot: uPlot | null = null;
  private readonly board = make("div");
  private readonly dot = make("i", { className: "dot" });
  private readonly choices: [HTMLSelectElement, HTMLSelectElement];

  constructor(
    private readonly head: Head,
    private motion: Motion,
    place: HTMLElement,
  ) {
    const columns = head.columns.slice(0, head.scene.first);
    const count = columns.filter((column) => column.kind === "coordinate").length;
    const across = count > 0 ? 1 : Math.min(1, columns.length - 1);
    const upward = count > 0 ? 1 + count : columns.length - 1;
    this.choices = [this.choice("to the right", columns, across), this.choice("upward", columns, upward)];
    if (columns.length < 2) return;
    place.append(make("p", { className: "portrait" }, this.choices[1], " over ", this.choices[0]), this.board);
    this.rebuild();
  }

  private choice(way: string, columns: Column[], chosen: number): HTMLSelectElement {
    const select = make("select", { ariaLabel: `Column of the portrait, ${way}` });
    columns.forEach(({ name }, i) => select.append(new Option(name, `${i}`, i === chosen, i === chosen)));
    select.onchange = () => this.rebuild();
    return select;
  }

  private values(k: 0 | 1): Float64Array {
    const index = Number(this.choices[k].value);
    const { scale, shift } = this.head.columns[index].display;
    return this.motion.column(index).map((si) => si * scale + shift);
  }

  private get data(): uPlot.AlignedData {
    return [null, [this.values(0), this.values(1)]] as unknown as uPlot.AlignedData;
  }

  private rebuild(): void {
    this.plot?.destroy();
    const [right, up] = this.choices.map((choice) => {
      const { name, display } = this.head.columns[Number(choice.value)];
      const unit = `[${display.unit || "1"}]`;
      return name.length <= LONGEST_NAME ? `${name} ${unit}` : unit; // the choices tell the name, too
    });
    const limits = (k: 0 | 1) => (): [number, number] => {
      let [low, high] = [Infinity, -Infinity];
      for (const value of this.values(k)) if (Number.isFinite(value)) [low, high] = [Math.min(low, value), Math.max(high, value)];
      if (!(high > low)) [low, high] = [(Number.isFinite(low) ? low : 0) - 1, (Number.isFinite(high) ? high : 0) + 1];
      return edged(low, high);
    };
    this.plot = new uPlot(
      {
        ...this.size(),
        mode: 2,
        scales: { x: { time: false, range: limits(0) }, y: { range: limits(1) } },
        axes: [{ ...axis(right), size: 40 }, upright(up)],
        cursor: { show: false },
        legend: { show: false },
        series: [{}, { facets: [{ scale: "x", auto: true }, { scale: "y", auto: true }], paths: path } as uPlot.Series],
      },
      this.data,
      this.board,
    );
    this.plot.over.append(this.dot);
  }

  show(motion: Motion): void {
    this.motion = motion;
    this.plot?.setData(this.data);
  }

  /** The present moment. */
  point(time: number): void {
    if (this.plot === null || this.motion.count === 0 || this.board.clientWidth === 0) return;
    const row = this.motion.rowAt(time);
    const [x, y] = this.choices.map((choice) => {
      const index = Number(choice.value);
      const { scale, shift } = this.head.columns[index].display;
      return this.motion.at(row, index) * scale + shift;
    });
    this.dot.style.left = `${this.plot.valToPos(x, "x")}px`;
    this.dot.style.top = `${this.plot.valToPos(y, "y")}px`;
  }

  private size(): { width: number; height: number } {
    return { width: Math.max(this.board.clientWidth || WIDE, 240), height: 240 };
  }

  resize(): void {
    this.plot?.setSize(this.size());
  }
}

function path(plot: uPlot): null {
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
}
