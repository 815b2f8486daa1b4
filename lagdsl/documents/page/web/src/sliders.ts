// Sliders for parameters, start values and inputs.
import { judged, snapped } from "./bounds.ts";
import type { Head, Quantity } from "./head.ts";
import type { Motion } from "./motion.ts";
import { above, written } from "./numbers.ts";

const GROUPS: [Quantity["group"], string][] = [
  ["start", "Start values"],
  ["parameter", "Parameters"],
  ["input", "Inputs"],
];
const STEPS = 1000;

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
export function shown(quantity: { display: { scale: number; shift: number } }, si: number): string {
  return written(si * quantity.display.scale + quantity.display.shift, 4);
}

/** A name that may go on in another line behind its dots and lines, and before its indices. */
function breakable(name: string): (string | HTMLElement)[] {
  return name.split(/(?<=[._])|(?=\[)/).flatMap((part) => [part, document.createElement("wbr")]);
}

export class Sliders {
  readonly values: Map<Quantity, number>;

  constructor(
    private readonly head: Head,
    private readonly motion: Motion,
    private readonly place: HTMLElement,
    private readonly changed: () => void,
  ) {
    this.values = new Map([...head.parameters, ...head.inputs].map((quantity) => [quantity, quantity.value]));
    for (const [group, title] of GROUPS) {
      const members = [...this.values.keys()].filter((quantity) => quantity.group === group);
      if (members.length === 0) continue;
      const details = document.createElement("details");
      details.open = members.length <= 24;
      const summary = document.createElement("summary");
      summary.textContent = title;
      details.append(summary, ...members.map((quantity) => this.row(quantity)));
      place.append(details);
    }
    const reset = document.createElement("button");
    reset.textContent = "Reset all";
    reset.onclick = () => {
      for (const quantity of this.values.keys()) this.values.set(quantity, quantity.value);
      place.querySelectorAll("input").forEach((input) => input.dispatchEvent(new Event("reread")));
      changed();
    };
    place.append(reset);
  }

  get parameters(): Float64Array {
    return Float64Array.from(this.head.parameters, (quantity) => this.values.get(quantity) ?? quantity.value);
  }

  get inputs(): Float64Array {
    return Float64Array.from(this.head.inputs, (quantity) => this.values.get(quantity) ?? quantity.value);
  }

  /** The parameters of a run. */
  take(parameters: number[]): void {
    this.head.parameters.forEach((quantity, i) => this.values.set(quantity, parameters[i]));
    this.place.querySelectorAll("input").forEach((input) => input.dispatchEvent(new Event("reread")));
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
    const label = document.createElement("label");
    label.title = quantity.doc ?? "";
    const name = document.createElement("span");
    name.append(...breakable(title));
    const bar = document.createElement("input");
    const whole = quantity.kind !== "Real";
    Object.assign(bar, { type: "range", min: "0", max: `${STEPS}`, step: whole ? "any" : "1" });
    bar.setAttribute("aria-label", quantity.name);
    const field = document.createElement("input");
    Object.assign(field, { type: "number", step: "any" });
    field.setAttribute("aria-label", `${quantity.name} in ${quantity.display.unit || "SI units"}`);
    const unit = document.createElement("span");
    unit.className = "unit";
    unit.textContent = quantity.display.unit;
    const fault = document.createElement("span");
    fault.className = "fault";
    fault.setAttribute("aria-live", "polite");
    const tell = (words: string): void => {
      fault.textContent = words;
      fault.hidden = words === "";
      field.setAttribute("aria-invalid", `${words !== ""}`);
    };
    const present = (): number => this.values.get(quantity) ?? quantity.value;
    const reread = (): void => {
      const si = present();
      bar.value = `${(STEPS * (si - low)) / (high - low || 1)}`;
      field.value = shown(quantity, si);
      tell(judged(quantity, si, si).words);
    };
    const set = (wanted: number): void => {
      const si = snapped(quantity, wanted);
      const { taken, words } = judged(quantity, si, present());
      if (taken) {
        this.values.set(quantity, si);
        this.changed();
      }
      reread();
      tell(words);
    };
    bar.oninput = () => {
      const si = low + ((high - low) * Number(bar.value)) / STEPS;
      set(whole ? Math.round(si) : si);
    };
    field.onchange = () => set((field.valueAsNumber - quantity.display.shift) / quantity.display.scale);
    bar.addEventListener("reread", reread);
    label.ondblclick = () => set(quantity.value);
    reread();
    label.append(name, bar, field, unit, fault);
    return label;
  }
}
