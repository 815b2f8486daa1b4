// Arrows that one switches on: their numbers come from a motion of their own, integrated when somebody looks at them.
import type { Group } from "three";
import type { Head, Shape } from "./head.ts";
import type { Motion } from "./motion.ts";
import { written } from "./numbers.ts";
import { drawn as made, vector, type Drawn, type Numbers, type Sizes } from "./shapes.ts";

export type Vectors = NonNullable<Head["vectors"]>;

/** Words of switches with the kinds of shapes that they show, in the order of their buttons; ghosts are of all kinds. */
export const SWITCHES: { words: string; title: string; kinds: string[]; key?: string }[] = [
  { words: "forces", title: "Arrows of loads", kinds: ["force", "torque"] },
  { words: "v", title: "Velocities of masses", kinds: ["velocity"], key: "v" },
  { words: "a", title: "Accelerations of masses", kinds: ["acceleration"] },
  { words: "∂r/∂q", title: "Admissible motions of masses: each coordinate alone", kinds: ["admissible"] },
  { words: "reactions", title: "Forces and torques of joints, rods and wires", kinds: ["reaction", "reaction torque"] },
  { words: "constraints", title: "Forces of constraints on masses", kinds: ["constraint"] },
  { words: "friction", title: "Dry friction: its forces, and whether it sticks or slides", kinds: ["friction"] },
  { words: "frames", title: "Axes of frames", kinds: ["frame"] },
  { words: "ghosts", title: "Pale postures of several instants (key g)", kinds: [], key: "g" },
];
const SWITCH_OF = new Map(SWITCHES.flatMap(({ words, kinds }) => kinds.map((kind) => [kind, words])));

/** Whether shapes of a kind are seen while these switches are on. */
export function seen(kind: string, on: ReadonlySet<string>): boolean {
  const words = SWITCH_OF.get(kind);
  return words === undefined || on.has(words);
}

const UNITS: Record<string, string> = { velocity: "m/s", acceleration: "m/s²", "reaction torque": "N·m", torque: "N·m" }; // of others: N
const PALETTE = ["#db2777", "#7c3aed", "#0891b2", "#65a30d", "#ca8a04", "#dc2626", "#2563eb", "#0d9488"];
const LONGEST = 0.3; // of the machine
const TURNING = 0.4; // of the longest arrow: the radius of one of a torque
const MOST_TOLD = 8;
const ROUNDING = 1e-10;
/** By number, as lagdsl/derivation/scene/vectors.py tells them. */
const MODES = ["open", "slides", "sticks"];

export class Overlay {
  readonly drawn: Drawn[] = [];
  readonly coordinates: string[];
  coordinate = ""; // whose admissible motions are shown; all of them where it is empty
  private readonly groups = new Map<string, { sizes: Sizes; shapes: Shape[] }>(); // of one scale each
  private readonly frictions: Shape[];
  private motion: Motion | null = null;
  private row = 0; // of the motion: the last one so far
  private largest = 0; // force of friction along the motion
  private numbers: Float64Array = new Float64Array(0);

  constructor(readonly vectors: Vectors, private readonly sizes: Sizes, private readonly on: ReadonlySet<string>, place: Group) {
    this.coordinates = [...new Set(vectors.shapes.flatMap((shape) => shape.texts.coordinate ?? []))];
    this.frictions = vectors.shapes.filter(({ kind }) => kind === "friction");
    // Friction that acts at no place, as that of a clutch, has a value alone.
    for (const shape of vectors.shapes.filter(({ numbers }) => "vector" in numbers)) {
      const index = this.coordinates.indexOf(shape.texts.coordinate ?? "");
      if (index >= 0) for (const part of shape.parts) part.color = PALETTE[index % PALETTE.length];
      const scale = `${shape.kind} ${unitOf(shape)}`;
      const group = this.groups.get(scale) ?? { sizes: { ...sizes, first: vectors.first, scales: {} }, shapes: [] };
      this.groups.set(scale, group);
      group.shapes.push(shape);
      const drawn = made(shape, group.sizes);
      drawn.object.visible = false;
      this.drawn.push(drawn);
      place.add(drawn.object);
    }
  }

  /** The longest arrow of each kind is a part of the machine, along the whole motion. */
  take(motion: Motion): void {
    this.motion = motion;
    const largest = (shapes: Shape[] = [], role = "vector"): number =>
      Math.max(0, ...shapes.map(({ numbers, texts }) =>
        motion.largest(this.vectors.first + numbers[role], role === "vector" ? 3 : Number(texts.components))));
    this.largest = largest(this.frictions, "value");
    for (const [scale, { sizes, shapes }] of this.groups) {
      const most = largest(shapes);
      // A torque that is the rounding of forces at the size of the machine is none.
      const arm = scale.startsWith("reaction torque") ? this.sizes.length * largest(this.groups.get("reaction N")?.shapes) : 0;
      const longest = most > ROUNDING * arm ? (LONGEST * this.sizes.length) / most : 0;
      sizes.scales = { force: longest, torque: TURNING * longest };
    }
  }

  pose(t: number): void {
    if (this.motion !== null && this.motion.count > 0) {
      const until = Math.min(t, this.motion.last);
      this.numbers = this.motion.state(until);
      this.row = this.motion.rowAt(until);
    }
    for (const drawn of this.drawn) {
      const chosen = this.coordinate === "" || (drawn.shape.texts.coordinate ?? this.coordinate) === this.coordinate;
      drawn.object.visible = seen(drawn.shape.kind, this.on) && chosen && this.motion !== null;
      if (drawn.object.visible) drawn.update(this.values);
      drawn.object.updateMatrixWorld(true);
    }
  }

  /** The value behind an arrow, with its unit. */
  value(shape: Shape): string {
    return shape.kind === "friction" ? this.rubs(shape) : lengthOf(shape, this.values);
  }

  /** The numbers of the arrows. */
  private get values(): Numbers {
    return this.numbers.subarray(this.vectors.first);
  }

  /** The value that the longest arrow of each switched kind stands for; what each friction does now. */
  legend(): string[] {
    const lines: string[] = [];
    const moving: string[] = [];
    for (const { sizes: { scales }, shapes } of this.groups.values()) {
      const [{ kind }] = shapes;
      if (!seen(kind, this.on) || scales.force === 0) continue;
      const unit = unitOf(shapes[0]) === "1" ? "" : ` ${unitOf(shapes[0])}`;
      const size = `${written((LONGEST * this.sizes.length) / scales.force, 3)}${unit}`;
      const names = [...new Set(shapes.flatMap(({ texts }) => texts.coordinate ?? []))].filter((name) => ["", name].includes(this.coordinate));
      if (kind === "admissible") moving.push(...names.map((name) => `∂r/∂${this.greek(name)}: ${size}`));
      else lines.push(`${kind}: longest ${size}`);
    }
    if (moving.length > 0) lines.unshift(`longest ${moving.join(", ")}`);
    if (!seen("friction", this.on) || this.motion === null) return lines;
    const told = [...new Set(this.frictions.map((shape) => `${shape.name}: ${this.rubs(shape)}`))];
    return [...lines, ...told.slice(0, MOST_TOLD), ...(told.length > MOST_TOLD ? [`and ${told.length - MOST_TOLD} more`] : [])];
  }

  /** A name whose words of Greek letters are these letters. */
  private greek(name: string): string {
    return name.replace(/[a-z]+/g, (word) => this.vectors.letters[word] ?? word);
  }

  /** Mode and force of friction: the mode of the last row, for between two rows it is neither. */
  private rubs(shape: Shape): string {
    const { first } = this.vectors;
    const mode = MODES[this.motion?.at(this.row, first + shape.numbers.mode) ?? 0] ?? "";
    if (mode === "open") return mode;
    const at = first + shape.numbers.value;
    const size = Math.hypot(...this.numbers.subarray(at, at + Number(shape.texts.components)));
    return `${mode}, ${written(size > ROUNDING * this.largest ? size : 0, 3)} ${unitOf(shape)}`;
  }
}

function unitOf(shape: Shape): string {
  return shape.texts.unit ?? UNITS[shape.kind] ?? "N";
}

/** The length of the vector behind an arrow, with its unit. */
export function lengthOf(shape: Shape, row: Numbers): string {
  return `${written(vector(shape.numbers, "vector", row).length(), 3)} ${unitOf(shape)}`;
}
