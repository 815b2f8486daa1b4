// Axes and inks of all charts.
import type uPlot from "uplot";
import { extremes, ticks } from "./numbers.ts";

export const INKS = ["#2563eb", "#dc2626", "#16a34a", "#d97706", "#7c3aed", "#0891b2", "#db2777", "#65a30d"];

const WIDE = 600; // [pixels] of a chart whose panel is hidden: on paper it is seen so
const NARROW = 240;

export function sizeIn(board: HTMLElement, height: number): { width: number; height: number } {
  return { width: Math.max(board.clientWidth || WIDE, NARROW), height };
}

/** Draws inside of a chart, in its own pixels: what is set for the pen holds as long. */
export function inside(plot: uPlot, draw: (pen: CanvasRenderingContext2D) => void): void {
  const { ctx: pen, bbox } = plot;
  pen.save();
  pen.beginPath();
  pen.rect(bbox.left, bbox.top, bbox.width, bbox.height);
  pen.clip();
  draw(pen);
  pen.restore();
}

export function curve(plot: uPlot, x: ArrayLike<number>, y: ArrayLike<number>, ink: string, width: number): void {
  inside(plot, (pen) => {
    pen.beginPath();
    for (let i = 0; i < x.length; ++i) pen.lineTo(plot.valToPos(x[i], "x", true), plot.valToPos(y[i], "y", true));
    pen.strokeStyle = ink;
    pen.lineWidth = width * window.devicePixelRatio;
    pen.stroke();
  });
}

export function axis(label: string): uPlot.Axis {
  const style = getComputedStyle(document.documentElement);
  const grid = { stroke: style.getPropertyValue("--line"), width: 1 };
  return {
    label,
    stroke: style.getPropertyValue("--ink-soft"),
    grid,
    ticks: grid,
    labelSize: 18,
    font: "11px system-ui",
    labelFont: "11px system-ui",
    values: (_, splits, __, ___, step) => ticks(splits, step),
  };
}

/** An axis upward, as wide as its numbers. */
export function upright(label: string): uPlot.Axis {
  const size: uPlot.Axis.Size = (_, values) => Math.max(64, 36 + 6.5 * Math.max(0, ...(values ?? []).map((text) => text.length)));
  return { ...axis(label), size };
}

/** The range of columns, with an edge. Round-off fills no chart: ticks closer than the digits of a number cannot be placed. */
export function edged(columns: readonly ArrayLike<number>[]): [number, number] {
  const [low, high] = columns.reduce<[number, number]>((ends, column) => extremes(Array.from(column), ...ends), [Infinity, -Infinity]);
  if (low > high) return [0, 1];
  const size = Math.max(Math.abs(low), Math.abs(high));
  const edge = Math.max(0.06 * (high - low), high - low < 1e-6 * size ? 1e-3 * size : 0) || 1;
  return [low - edge, high + edge];
}
