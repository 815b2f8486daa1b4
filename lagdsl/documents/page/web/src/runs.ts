// Several motions: a slider over the runs of a sweep; modes by frequency, with amplitudes; eigenvalues over a parameter.
import { choice, drawn, make } from "./dom.ts";
import type { Head, Locus, Mode } from "./head.ts";
import { extremes } from "./numbers.ts";

const [WIDTH, HEIGHT] = [420, 200];
const EDGE = { left: 62, right: 10, top: 8, bottom: 34 };

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

/** With zero upward, and to the right where that is an `axis`, too. */
function chart(dots: Dot[], across: string, upward: string, marks: number[], axis: boolean): SVGElement {
  const svg = drawn("svg", { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, role: "img", "aria-label": `${upward} over ${across}` });
  const [[x0, x1], [y0, y1]] = ([0, 1] as const).map((k) => {
    const [low, high] = extremes([...dots.map(({ at }) => at[k]), ...(axis || k === 1 ? [0] : [])]);
    const edge = high > low ? 0.06 * (high - low) : 1;
    return [low - edge, high + edge];
  });
  const x = (value: number): number => EDGE.left + ((value - x0) / (x1 - x0)) * (WIDTH - EDGE.left - EDGE.right);
  const y = (value: number): number => HEIGHT - EDGE.bottom - ((value - y0) / (y1 - y0)) * (HEIGHT - EDGE.top - EDGE.bottom);
  const line = (from: Point, to: Point, kind: string): void =>
    svg.append(drawn("line", { x1: x(from[0]), y1: y(from[1]), x2: x(to[0]), y2: y(to[1]), class: kind }));
  const write = (text: string, given: Record<string, string | number>): void => svg.append(drawn("text", given, text));
  line([x0, 0], [x1, 0], "axis");
  if (axis) line([0, y0], [0, y1], "axis");
  for (const mark of marks) line([mark, y0], [mark, y1], "threshold");
  for (const { at, part, words } of dots) {
    const fill = `hsl(${(230 - 190 * part).toFixed(0)} 70% 50%)`;
    const circle = drawn("circle", { cx: x(at[0]).toFixed(2), cy: y(at[1]).toFixed(2), r: 2, fill });
    circle.append(drawn("title", {}, words));
    svg.append(circle);
  }
  for (const [end, anchor] of [[x0, "start"], [x1, "end"]] as const) write(end.toPrecision(3), { x: x(end), y: HEIGHT - 20, "text-anchor": anchor });
  for (const [end, off] of [[y0, 0], [y1, 9]]) write(end.toPrecision(3), { x: EDGE.left - 4, y: y(end) + off, "text-anchor": "end" });
  write(across, { x: (EDGE.left + WIDTH) / 2, y: HEIGHT - 6, "text-anchor": "middle" });
  write(upward, { x: -HEIGHT / 2 + 10, y: 12, "text-anchor": "middle", transform: "rotate(-90)" });
  return svg;
}
