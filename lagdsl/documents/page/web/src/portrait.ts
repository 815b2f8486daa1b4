// One column against another: a phase portrait, or a path.
import uPlot from "uplot";
import { axis, curve, edged, INKS, sizeIn, upright } from "./axis.ts";
import { choice, make } from "./dom.ts";
import type { Head } from "./head.ts";
import type { Motion } from "./motion.ts";
import { extremes } from "./numbers.ts";

const LONGEST_NAME = 20;
const HEIGHT = 240;

export class Portrait {
  private plot: uPlot | null = null;
  private readonly board = make("div");
  private readonly dot = make("i", { className: "dot" });
  private readonly choices: HTMLSelectElement[]; // what goes to the right, what goes upward

  constructor(private readonly head: Head, private motion: Motion, place: HTMLElement) {
    const columns = head.columns.slice(0, head.scene.first);
    const count = columns.filter((column) => column.kind === "coordinate").length;
    const first = count > 0 ? [1, 1 + count] : [Math.min(1, columns.length - 1), columns.length - 1];
    this.choices = ["to the right", "upward"].map((way, k) =>
      choice(`Column of the portrait, ${way}`, columns.map(({ name }) => name), first[k], () => this.rebuild()));
    if (columns.length < 2) return;
    place.append(make("p", { className: "portrait" }, this.choices[1], " over ", this.choices[0]), this.board);
    this.rebuild();
  }

  private get data(): [Float64Array, Float64Array] {
    return this.choices.map(({ selectedIndex }) => this.motion.shown(this.head.columns, selectedIndex)) as [Float64Array, Float64Array];
  }

  private get told(): uPlot.AlignedData {
    return [null, this.data] as unknown as uPlot.AlignedData;
  }

  private rebuild(): void {
    this.plot?.destroy();
    const [right, up] = this.choices.map(({ selectedIndex }) => {
      const { name, display } = this.head.columns[selectedIndex];
      const unit = `[${display.unit || "1"}]`;
      return name.length <= LONGEST_NAME ? `${name} ${unit}` : unit; // the choices tell the name, too
    });
    const limits = (k: 0 | 1) => (): [number, number] => {
      const [low, high] = extremes(this.data[k]);
      return high > low ? edged(low, high) : edged((Number.isFinite(low) ? low : 0) - 1, (Number.isFinite(high) ? high : 0) + 1);
    };
    const paths = (plot: uPlot): null => {
      curve(plot, ...this.data, INKS[0], 1.5);
      return null;
    };
    this.plot = new uPlot(
      {
        ...sizeIn(this.board, HEIGHT),
        mode: 2,
        scales: { x: { time: false, range: limits(0) }, y: { range: limits(1) } },
        axes: [{ ...axis(right), size: 40 }, upright(up)],
        cursor: { show: false },
        legend: { show: false },
        series: [{}, { facets: [{ scale: "x", auto: true }, { scale: "y", auto: true }], paths } as uPlot.Series],
      },
      this.told,
      this.board,
    );
    this.plot.over.append(this.dot);
  }

  show(motion: Motion): void {
    this.motion = motion;
    this.plot?.setData(this.told);
  }

  /** The present moment. */
  point(time: number): void {
    if (this.plot === null || this.motion.count === 0 || this.board.clientWidth === 0) return;
    const row = this.motion.rowAt(time);
    const [x, y] = this.data.map((values) => values[row]);
    this.dot.style.left = `${this.plot.valToPos(x, "x")}px`;
    this.dot.style.top = `${this.plot.valToPos(y, "y")}px`;
  }

  resize(): void {
    this.plot?.setSize(sizeIn(this.board, HEIGHT));
  }
}
