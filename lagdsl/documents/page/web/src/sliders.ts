// Sliders for parameters, start values and inputs: values that the model takes, and words on the others.
import { make } from "./dom.ts";
import type { Display, Head, Quantity } from "./head.ts";
import type { Motion } from "./motion.ts";
import { above, written } from "./numbers.ts";

const GROUPS: [Quantity["group"], string][] = [
  ["start", "More start values"],
  ["parameter", "More parameters"],
  ["input", "More inputs"],
];
const STEPS = 1000;
/** Bounds are read in the units that are shown, and come out of them with rounding. */
const ROUNDING = 1e-12;
const DIGITS = 12;

/** The range of a slider in SI units: declared, or a decade around the value; that of a start value holds the motion, too,
 * which reaches so far as `most`; an angle goes all around. */
function range(quantity: Quantity, most: number): [number, number] {
  const { minimum, maximum, display } = quantity;
  const value = Math.min(Math.max(quantity.value, minimum ?? -Infinity), maximum ?? Infinity);
  let [low, high] = value === 0 ? [-1, 1] : [value / Math.sqrt(10), value * Math.sqrt(10)];
  if (quantity.angle) [low, high] = [Math.min(-Math.PI, value), Math.max(Math.PI, value)];
  else if (quantity.group !== "parameter") {
    const size = above((Math.max(2 * Math.abs(value), most) || 1) * display.scale) / display.scale;
    [low, high] = [-size, size];
  }
  if (low > high) [low, high] = [high, low];
  return [minimum ?? low, maximum ?? high];
}

/** Four digits are what people read. */
export function shown({ display }: { display: Display }, si: number, digits = 4): string {
  return written(si * display.scale + display.shift, digits);
}

/** A name that may go on in another line behind its dots and lines, and before its indices. */
function breakable(name: string): (string | HTMLElement)[] {
  return name.split(/(?<=[._])|(?=\[)/).flatMap((part) => [part, make("wbr")]);
}

/** A value in SI units, without the rounding by which it misses a bound. */
function snapped({ minimum, maximum, display }: Quantity, si: number): number {
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

/** Whether the model takes a value, and what there is to say of it: parameters and whole numbers have no meaning outside
 * of their bounds; a start value or an input may lie there, as W0328 says. */
function judged(quantity: Quantity, si: number, before: number): { taken: boolean; words: string } {
  const words = fault(quantity, si);
  const taken = Number.isFinite(si) && (words === "" || (quantity.group !== "parameter" && quantity.kind === "Real"));
  const then = taken ? "the run takes it" : `the value stays ${told(quantity, before)}`;
  return { taken, words: words && `${words}; ${then}` };
}

function told(quantity: Quantity, si: number): string {
  return `${shown(quantity, si, DIGITS)} ${quantity.display.unit}`.trim();
}

export class Sliders {
  private readonly values: Map<Quantity, number>; // of parameters and, behind them, of inputs
  private readonly rows: (() => void)[] = []; // each shows its value anew

  constructor(
    private readonly head: Head,
    private readonly motion: Motion,
    place: HTMLElement,
    private readonly changed: () => void,
  ) {
    const all = [...head.parameters, ...head.inputs];
    this.values = new Map(all.map((quantity) => [quantity, quantity.value]));
    const chosen = head.sliders.flatMap((name) => all.filter((quantity) => quantity.name === name));
    place.append(...chosen.map((quantity) => this.row(quantity)));
    for (const [group, title] of GROUPS) {
      const others = all.filter((quantity) => quantity.group === group && !chosen.includes(quantity)).map((quantity) => this.row(quantity));
      if (others.length > 0) place.append(make("details", { open: chosen.length === 0 }, make("summary", { textContent: title }), ...others));
    }
    const reset = (): void => {
      this.take(({ value }) => value);
      changed();
    };
    place.append(make("button", { textContent: "Reset all", onclick: reset }));
  }

  /** Other values of quantities, by their place among all; undefined keeps that which is. */
  take(wanted: (quantity: Quantity, index: number) => number | undefined): void {
    [...this.values].forEach(([quantity, before], i) => this.values.set(quantity, wanted(quantity, i) ?? before));
    for (const reread of this.rows) reread();
  }

  /** Values of parameters and of inputs. */
  get given(): [parameters: Float64Array, inputs: Float64Array] {
    const all = Float64Array.from(this.values.values());
    return [all.slice(0, this.head.parameters.length), all.slice(this.head.parameters.length)];
  }

  /** The largest size of a quantity along the recorded motion; of one that rests, that of all of its kind and unit. */
  private largest(name: string): number {
    const own = this.head.columns.find((column) => column.name === name);
    const sizes = this.head.columns.map((column, index) =>
      own !== undefined && column.kind === own.kind && column.unit === own.unit ? this.motion.largest(index) : 0);
    const [most, all] = [own === undefined ? 0 : sizes[this.head.columns.indexOf(own)], Math.max(...sizes)];
    return most > 1e-9 * all ? most : all;
  }

  private row(quantity: Quantity): HTMLElement {
    const title = quantity.group === "start" ? quantity.name.replace(/\.start$/, "") : quantity.name;
    const [low, high] = range(quantity, quantity.group === "start" ? this.largest(title) : 0);
    const whole = quantity.kind !== "Real";
    const { unit } = quantity.display;
    const bar = make("input", { type: "range", min: "0", max: `${STEPS}`, step: whole ? "any" : "1", ariaLabel: quantity.name });
    const field = make("input", { type: "number", step: "any", ariaLabel: `${quantity.name} in ${unit || "SI units"}` });
    const fault = make("span", { className: "fault", ariaLive: "polite" });
    const present = (): number => this.values.get(quantity) ?? quantity.value;
    const reread = (words = judged(quantity, present(), present()).words): void => {
      bar.value = `${(STEPS * (present() - low)) / (high - low || 1)}`;
      field.value = shown(quantity, present());
      fault.textContent = words;
      field.ariaInvalid = `${words !== ""}`;
    };
    const set = (wanted: number): void => {
      const si = snapped(quantity, wanted);
      const { taken, words } = judged(quantity, si, present());
      if (taken) {
        this.values.set(quantity, si);
        this.changed();
      }
      reread(words);
    };
    bar.oninput = () => {
      const si = low + ((high - low) * Number(bar.value)) / STEPS;
      set(whole ? Math.round(si) : si);
    };
    field.onchange = () => set((field.valueAsNumber - quantity.display.shift) / quantity.display.scale);
    this.rows.push(reread);
    const name = make("span", {}, ...breakable(title));
    const label = make("label", { title: quantity.doc ?? "" }, name, bar, field, make("span", { className: "unit", textContent: unit }), fault);
    label.ondblclick = () => set(quantity.value);
    reread();
    return label;
  }
}
