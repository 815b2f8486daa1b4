// Marks of events along a time, as more of them than pixels can show become: one for each part of it, of clocks a density.
import { make } from "./dom.ts";
import type { Occurrence } from "./head.ts";

const MARKS = 400; // more than that are a line of color
const PARTS = 100;

export function ticks(events: readonly Occurrence[], start: number, stop: number): HTMLElement[] {
  const partOf = (time: number, parts: number): number =>
    Math.min(Math.max(Math.floor((parts * (time - start)) / (stop - start || 1)), 0), parts - 1);
  const counts = new Array<number>(PARTS).fill(0);
  const first = new Map<number, Occurrence>(); // of each part
  for (const event of events) {
    const part = partOf(event.time, MARKS);
    if (event.kind === "tick") ++counts[partOf(event.time, PARTS)];
    else if (!first.has(part)) first.set(part, event);
  }
  const most = Math.max(...counts);
  const often = most > 0 ? counts.map((count) => make("b", { style: `opacity: ${(0.5 * count) / most}` } as object)) : [];
  const marks = [...first.values()].map(({ time, name, kind }) =>
    make("i", { title: `${name} ${kind}`, className: kind, style: `left: ${(100 * (time - start)) / (stop - start || 1)}%` } as object));
  return [...often, ...marks];
}
