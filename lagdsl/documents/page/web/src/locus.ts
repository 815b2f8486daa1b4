// Eigenvalues over a parameter: the root locus, and real parts and frequencies with their thresholds.
import type { Locus } from "./head.ts";

const WIDTH = 420;
const HEIGHT = 200;
const EDGE = { left: 62, right: 10, top: 8, bottom: 34 };
const NS = "http://www.w3.org/2000/svg";

interface Dot {
  x: number;
  y: number;
  part: number; // of the range of the parameter: its color
  words: string;
}

export function locus(data: Locus): HTMLElement {
  const board = document.createElement("div");
  board.className = "locus";
  const unit = data.unit && data.unit !== "1" ? ` [${data.unit}]` : "";
  const [first, last] = [Math.min(...data.values), Math.max(...data.values)];
  const dots = (x: (v: number, s: [number, number]) => number, y: (s: [number, number]) => number): Dot[] =>
    data.values.flatMap((value, k) =>
      data.eigenvalues[k].flatMap((s) =>
        s === null
          ? []
          : [{ x: x(value, s), y: y(s), part: (value - first) / (last - first || 1), words: `${data.name} = ${value.toPrecision(4)}` }],
      ),
    );
  const marks = data.thresholds.map((threshold) => threshold.value);
  board.append(
    chart(dots((_, s) => s[0], (s) => s[1]), "real part [1/s]", "imaginary part [1/s]", [], true),
    chart(dots((value) => value, (s) => s[0]), `${data.name}${unit}`, "real part [1/s]", marks, false),
    chart(dots((value) => value, (s) => Math.abs(s[1]) / (2 * Math.PI)), `${data.name}${unit}`, "frequency [Hz]", marks, false),
  );
  const list = document.createElement("ul");
  for (const { value, kind, frequency, unstable_above } of data.thresholds) {
    const item = document.createElement("li");
    const at = frequency > 0 ? ` at ${frequency.toPrecision(4)} Hz` : "";
    item.textContent = `${kind}${at} ${unstable_above ? "above" : "below"} ${data.name} = ${value.toPrecision(6)} ${data.unit}`;
    list.append(item);
  }
  if (data.thresholds.length > 0) board.append(list);
  return board;
}

function made(name: string, given: Record<string, string | number>, text = ""): SVGElement {
  const element = document.createElementNS(NS, name);
  for (const [key, value] of Object.entries(given)) element.setAttribute(key, `${value}`);
  if (text !== "") element.textContent = text;
  return element;
}

function range(values: number[]): [number, number] {
  const [low, high] = [Math.min(...values), Math.max(...values)];
  const edge = high > low ? 0.06 * (high - low) : 1;
  return [low - edge, high + edge];
}

function chart(dots: Dot[], across: string, upward: string, marks: number[], axis: boolean): SVGElement {
  const svg = made("svg", { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, role: "img", "aria-label": `${upward} over ${across}` });
  const [x0, x1] = range([...dots.map((dot) => dot.x), ...(axis ? [0] : [])]);
  const [y0, y1] = range([...dots.map((dot) => dot.y), 0]);
  const x = (value: number): number => EDGE.left + ((value - x0) / (x1 - x0)) * (WIDTH - EDGE.left - EDGE.right);
  const y = (value: number): number => HEIGHT - EDGE.bottom - ((value - y0) / (y1 - y0)) * (HEIGHT - EDGE.top - EDGE.bottom);
  const line = (a: [number, number], b: [number, number], kind: string): void =>
    void svg.append(made("line", { x1: a[0], y1: a[1], x2: b[0], y2: b[1], class: kind }));
  line([x(x0), y(0)], [x(x1), y(0)], "axis");
  if (axis) line([x(0), y(y0)], [x(0), y(y1)], "axis");
  for (const mark of marks) line([x(mark), y(y0)], [x(mark), y(y1)], "threshold");
  for (const dot of dots) {
    const circle = made("circle", { cx: x(dot.x).toFixed(2), cy: y(dot.y).toFixed(2), r: 2, fill: `hsl(${(230 - 190 * dot.part).toFixed(0)} 70% 50%)` });
    circle.append(made("title", {}, dot.words));
    svg.append(circle);
  }
  const ends: [number, number, string, string][] = [
    [x(x0), HEIGHT - 20, "start", x0.toPrecision(3)],
    [x(x1), HEIGHT - 20, "end", x1.toPrecision(3)],
    [EDGE.left - 4, y(y0), "end", y0.toPrecision(3)],
    [EDGE.left - 4, y(y1) + 9, "end", y1.toPrecision(3)],
  ];
  for (const [at, up, anchor, text] of ends) svg.append(made("text", { x: at, y: up, "text-anchor": anchor }, text));
  svg.append(made("text", { x: (EDGE.left + WIDTH) / 2, y: HEIGHT - 6, "text-anchor": "middle" }, across));
  svg.append(made("text", { x: -HEIGHT / 2 + 10, y: 12, "text-anchor": "middle", transform: "rotate(-90)" }, upward));
  return svg;
}
