// Several motions: a slider over the runs of a sweep; modes by frequency, with amplitudes; eigenvalues over a parameter.
import uPlot from "uplot";
import { axis as axisOf, curve, edged, inside, sizeIn, upright } from "./axis.ts";
import { choice, make } from "./dom.ts";
import type { Head, Locus, Mode } from "./head.ts";
import { extremes, written } from "./numbers.ts";

const HEIGHT = 200;

type Point = [number, number];
interface Dot {
  at: Point;
  part: number; // of the range of the parameter: its color
  words: string;
}

/** The controls of the page's runs, if it has several; `chosen` is told the number of the one to show. */
export function runs(head: Head, place: HTMLElement, chosen: (run: number) => void): void {
  const board = make("section", { id: "runs" });
  place.prepend(board);
  if (head.modes !== undefined) modes(head, board, head.modes, chosen);
  else if (head.runs !== undefined && head.runs.length > 1) sweep(board, head.runs.map((run) => run.label), chosen);
}

function sweep(board: HTMLElement, labels: string[], chosen: (run: number) => void): void {
  const bar = make("input", { type: "range", min: "0", max: `${labels.length - 1}`, step: "1", value: "0", ariaLabel: "Run" });
  const words = make("output");
  const tell = (): void => {
    const run = Number(bar.value);
    words.textContent = bar.ariaValueText = `Run ${run + 1} of ${labels.length}: ${labels[run]}`;
  };
  bar.oninput = () => {
    tell();
    chosen(Number(bar.value));
  };
  tell();
  board.append(make("label", {}, words, bar));
}

function modes(head: Head, board: HTMLElement, all: Mode[], chosen: (run: number) => void): void {
  const levels = head.levels ?? [""];
  const shown = { mode: 0, level: Math.min(1, levels.length - 1) };
  const shape = make("table", { className: "shape" });
  const title = make("tr", {}, ...["shape", "size", "phase"].map((textContent) => make("th", { scope: "col", textContent })));
  const show = (change: Partial<typeof shown>): void => {
    const { mode, level } = Object.assign(shown, change);
    buttons.forEach((button, i) => (button.ariaPressed = `${i === mode}`));
    const rows = all[mode].shape.map(({ name, size, phase }) => {
      const texts = [name, size.toPrecision(3), size > 1e-9 ? `${phase.toFixed(0)}°` : ""];
      return make("tr", {}, ...texts.map((textContent) => make("td", { textContent })));
    });
    shape.replaceChildren(title, ...rows);
    chosen(mode * levels.length + level);
  };
  const buttons = all.map((each, i) => make("button", { textContent: `${i + 1}: ${told(each)}`, onclick: () => show({ mode: i }) }));
  const size = choice("Amplitude", levels.map((name) => `amplitude: ${name}`), shown.level, (number) => show({ level: number }));
  board.append(make("p", { textContent: head.stability ?? "" }), make("div", { className: "modes" }, ...buttons), size, shape);
  if (head.locus != null) board.append(locus(head.locus));
  show({});
}

function told(mode: Mode): string {
  const { eigenvalue: [real], frequency, damping, constant } = mode;
  const parts = [frequency > 0 ? `${frequency.toPrecision(4)} Hz` : `${real.toPrecision(4)} 1/s`];
  if (frequency > 0 && damping !== null && Math.abs(damping) > 1e-7) parts.push(`damping ${damping.toPrecision(3)}`);
  if (constant !== null) parts.push(`${constant > 0 ? "falls" : "grows"} in ${Math.abs(constant).toPrecision(3)} s`);
  return parts.join(", ");
}

/** Eigenvalues over a parameter: the root locus, and real parts and frequencies with their thresholds. */
function locus(data: Locus): HTMLElement {
  const { name, values, eigenvalues, thresholds } = data;
  const unit = data.unit === "1" ? "" : data.unit;
  const [first, last] = extremes(values);
  const dots = (at: (value: number, s: Point) => Point): Dot[] =>
    values.flatMap((value, k) => eigenvalues[k].filter((s) => s !== null).map((s) =>
      ({ at: at(value, s), part: (value - first) / (last - first || 1), words: `${name} = ${value.toPrecision(4)}` })));
  const marks = thresholds.map(({ value }) => value);
  const across = unit ? `${name} [${unit}]` : name;
  const list = thresholds.map(({ value, kind, frequency, unstable_above }) => {
    const at = frequency > 0 ? ` at ${frequency.toPrecision(4)} Hz` : "";
    const textContent = `${kind}${at} ${unstable_above ? "above" : "below"} ${name} = ${value.toPrecision(6)} ${data.unit}`;
    return make("li", { textContent });
  });
  return make("div", { className: "locus" },
    chart(dots((_, s) => s), "real part [1/s]", "imaginary part [1/s]", [], true),
    chart(dots((value, [real]) => [value, real]), across, "real part [1/s]", marks, false),
    chart(dots((value, [, omega]) => [value, Math.abs(omega) / (2 * Math.PI)]), across, "frequency [Hz]", marks, false),
    ...(list.length > 0 ? [make("ul", {}, ...list)] : []));
}

/** With zero upward, and to the right where that is an `axis`, too. The legend tells the dot next to the pointer. */
function chart(dots: Dot[], across: string, upward: string, marks: number[], axis: boolean): HTMLElement {
  const board = make("div", { role: "img", ariaLabel: `${upward} over ${across}` });
  const [xs, ys] = ([0, 1] as const).map((k) => Float64Array.from(dots, ({ at }) => at[k]));
  const next = ({ cursor: { left = 0, top = 0 }, valToPos }: uPlot): number => {
    const away = dots.map(({ at: [x, y] }) => Math.hypot(valToPos(x, "x") - left, valToPos(y, "y") - top));
    return away.indexOf(Math.min(...away));
  };
  const draw = (plot: uPlot): void => {
    const [x, y] = [plot.scales.x, plot.scales.y].map(({ min = 0, max = 1 }) => [min, max]);
    for (const mark of marks) curve(plot, [mark, mark], y, "#d97706", 1.5);
    curve(plot, x, [0, 0], "#64748b", 1);
    if (axis) curve(plot, [0, 0], y, "#64748b", 1);
    inside(plot, (pen) => {
      for (const { at: [right, up], part } of dots) {
        pen.fillStyle = `hsl(${230 - 190 * part} 70% 50%)`;
        pen.beginPath();
        pen.arc(plot.valToPos(right, "x", true), plot.valToPos(up, "y", true), 2 * window.devicePixelRatio, 0, 2 * Math.PI);
        pen.fill();
      }
    });
  };
  const plot = new uPlot(
    {
      ...sizeIn(board, HEIGHT),
      scales: { x: { time: false, range: () => edged([xs, ...(axis ? [[0]] : [])]) }, y: { range: () => edged([ys, [0]]) } },
      axes: [{ ...axisOf(across), size: 40 }, upright(upward)],
      cursor: { x: false, y: false, drag: { x: false }, dataIdx: next },
      series: [
        { label: "at", value: (_, __, ___, dot) => (dot === null ? "–" : dots[dot].words) },
        { label: upward, paths: () => null, value: (_, value: number | null) => written(value ?? NaN, 4) },
      ],
      hooks: { drawAxes: [draw] },
    },
    [xs, ys],
    board,
  );
  new ResizeObserver(() => plot.setSize(sizeIn(board, HEIGHT))).observe(board);
  return board;
}
