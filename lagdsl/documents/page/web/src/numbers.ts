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
  const far = most >= 1e6 || step < 1e-4;
  const digits = far ? Math.ceil(Math.log10(most / step) - 1e-9) : (`${Number(step.toPrecision(6))}`.split(".")[1] ?? "").length;
  const maximumFractionDigits = Math.min(Math.max(digits, 0), 15);
  const minimumFractionDigits = far ? 0 : digits;
  const form = new Intl.NumberFormat("en-US", { notation: far ? "scientific" : "standard", minimumFractionDigits, maximumFractionDigits });
  return values.map((value) => form.format(value || 0).replace(/E0$/, "").replace("E", "e"));
}

/** The least of 1, 2, 5 times a power of ten that is not below a positive number. */
export function above(value: number): number {
  const ten = 10 ** Math.floor(Math.log10(value));
  return ([1, 2, 5].find((part) => part * ten >= value * (1 - 1e-9)) ?? 10) * ten;
}
