// Numbers as people read them.

/** So many digits; very large and very small ones as 3.986e14. */
export function written(value: number, digits: number): string {
  if (!Number.isFinite(value)) return "–";
  const rounded = Number(value.toPrecision(digits));
  const size = Math.abs(rounded);
  return size !== 0 && (size >= 1e6 || size < 1e-4) ? rounded.toExponential().replace("e+", "e") : `${rounded}`;
}

/** The least and the largest of finite numbers, and of `low` and `high`. */
export function extremes(values: Iterable<number>, low = Infinity, high = -Infinity): [number, number] {
  for (const value of values) if (Number.isFinite(value)) [low, high] = [Math.min(low, value), Math.max(high, value)];
  return [low, high];
}

/** Of the ticks of an axis, so that two of them differ. */
export function ticks(values: readonly number[], step: number): string[] {
  const most = Math.max(...values.map(Math.abs));
  if (most >= 1e6 || step < 1e-4) {
    const digits = Math.max(Math.ceil(Math.log10(most / step) - 1e-9), 0);
    return values.map((value) => (value === 0 ? "0" : value.toExponential(Math.min(digits, 15)).replace(/(\.?0+)?e\+?/, "e")));
  }
  let digits = 0;
  while (Math.abs(step * 10 ** digits - Math.round(step * 10 ** digits)) > 1e-6) ++digits;
  const form = { minimumFractionDigits: digits, maximumFractionDigits: digits };
  return values.map((value) => (value === 0 ? 0 : value).toLocaleString("en-US", form));
}

/** The least of 1, 2, 5 times a power of ten that is not below a positive number. */
export function above(value: number): number {
  const ten = 10 ** Math.floor(Math.log10(value));
  return ([1, 2, 5].find((part) => part * ten >= value * (1 - 1e-9)) ?? 10) * ten;
}

/** One event for each part of a bar that is no tick of a clock: more marks than that are a line of color. */
export function apart<Event extends { time: number; kind: string }>(events: readonly Event[], start: number, stop: number): Event[] {
  const found = events.filter(({ kind }) => kind !== "tick").map((event) => [partOf(event.time, start, stop, 400), event] as const);
  return [...new Map(found.reverse()).values()].reverse();
}

const PARTS = 100;

/** How often clocks tick in equal parts of the time, as parts of the most often. */
export function density(events: readonly { time: number; kind: string }[], start: number, stop: number): number[] {
  const counts = new Array<number>(PARTS).fill(0);
  for (const { time, kind } of events) if (kind === "tick") ++counts[partOf(time, start, stop, PARTS)];
  const most = Math.max(...counts);
  return most > 0 ? counts.map((count) => count / most) : [];
}

function partOf(time: number, start: number, stop: number, parts: number): number {
  return Math.min(Math.max(Math.floor((parts * (time - start)) / (stop - start || 1)), 0), parts - 1);
}
