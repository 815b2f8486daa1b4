// Values that somebody sets: those that the model takes, and words on the others.
import type { Quantity } from "./head.ts";
import { written } from "./numbers.ts";

/** Bounds are read in the units that are shown, and come out of them with rounding. */
const ROUNDING = 1e-12;
const DIGITS = 12;

/** Parameters and whole numbers have no meaning outside; a start value or an input may lie there, as W0328 says. */
function strict(quantity: Quantity): boolean {
  return quantity.group === "parameter" || quantity.kind !== "Real";
}

/** A value in SI units, without the rounding by which it misses a bound. */
export function snapped({ minimum, maximum, display }: Quantity, si: number): number {
  const near = (bound: number): boolean =>
    Math.abs(si - bound) <= ROUNDING * (Math.abs(bound) + Math.abs(display.shift / display.scale));
  return [minimum, maximum].find((bound) => bound !== null && near(bound)) ?? si;
}

/** Nothing, or why it is a value that the model does not expect. */
function fault(quantity: Quantity, si: number): string {
  const { minimum, maximum } = quantity;
  if (Number.isNaN(si)) return "this is no number";
  const value = told(quantity, si);
  if (!Number.isFinite(si)) return `${value} is not finite`;
  if (quantity.kind !== "Real" && !Number.isSafeInteger(si)) return `${value} is no whole number below 2^53`;
  if (minimum !== null && si < minimum) return `${value} is below min = ${told(quantity, minimum)}`;
  if (maximum !== null && si > maximum) return `${value} is above max = ${told(quantity, maximum)}`;
  return "";
}

/** Whether the model takes a value, and what there is to say of it. */
export function judged(quantity: Quantity, si: number, before: number): { taken: boolean; words: string } {
  const words = fault(quantity, si);
  const taken = Number.isFinite(si) && (words === "" || !strict(quantity));
  if (words === "") return { taken, words };
  return { taken, words: taken ? `${words}; the run takes it` : `${words}; the value stays ${told(quantity, before)}` };
}

function told({ display }: Quantity, si: number): string {
  return `${written(si * display.scale + display.shift, DIGITS)} ${display.unit}`.trim();
}
