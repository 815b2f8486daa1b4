// Numbers as people read them.

/** So many digits; very large and very small ones as 3.986e14. */
export function written(value: number, digits: number): string {
  if (!Number.isFinite(value)) return "–";
  const rounded = Number(value.toPrecision(digits));
  const size = Math.abs(rounded);
  return size !== 0 && (size >= 1e6 || size < 1e-4) ? power(rounded.toExponential()) : `${rounded}`;
}

function power(text: string): string {
  return text.replace("e+", "e");
}

/** Of the ticks of an axis, so that two of them differ. */
export function ticks(values: readonly number[], step: number): string[] {
  const most = Math.max(...values.map(Math.abs));
  if (most >= 1e6 || step < 1e-4) {
    const digits = Math.max(Math.ceil(Math.log10(most / step) - 1e-9), 0);
    return values.map((value) => (value === 0 ? "0" : power(value.toExponential(Math.min(digits, 15)).replace(/\.?0+e/, "e"))));
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

/** One event for each part of a bar, no tick of a clock if there is another: more marks than that are a line of color. */
export function apart<Event extends { time: number; kind: string }>(events: readonly Event[], start: number, stop: number): Event[] {
  const parts = 400;
  const found = new Map<number, Event>();
  for (const event of events) {
    const part = Math.floor((parts * (event.time - start)) / (stop - start || 1));
    if ((found.get(part)?.kind ?? "tick") === "tick") found.set(part, event);
  }
  return [...found.values()];
}
