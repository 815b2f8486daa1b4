// Arrows that one switches on: their numbers come from a motion of their own, integrated when somebody looks at them.
import type { Group } from "three";
import type { Head, Shape } from "./head.ts";
import type { Motion } from "./motion.ts";
import { extremes } from "./numbers.ts";
import { drawn as made, vector, type Drawn, type Sizes } from "./shapes.ts";

export type Vectors = NonNullable<Head["vectors"]>;

/** Kinds with the words of their switches, in the order of these. */
export const SWITCHES: [kind: string, words: string, title: string][] = [
  ["velocity", "v", "Velocities of masses"],
  ["acceleration", "a", "Accelerations of masses"],
  ["admissible", "∂r/∂q", "Admissible motions of masses: each coordinate alone"],
  ["reaction", "reactions", "Forces and torques of joints, rods and wires"],
  ["constraint", "constraints", "Forces of constraints on masses"],
  ["friction", "friction", "Dry friction: its forces, and whether it sticks or slides"],
];
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
  readonly shown = new Set<string>();
  readonly coordinates: string[];
  coordinate = ""; // whose admissible motions are shown; all of them where it is empty
  private readonly scales = new Map<string, Sizes>();
  private readonly frictions: Shape[];
  private motion: Motion | null = null;
  private row = 0; // of the motion: the last one so far
  private largest = 0; // force of friction along the motion
  private numbers = new Float64Array(0);

  constructor(private readonly vectors: Vectors, private readonly sizes: Sizes, place: Group) {
    this.coordinates = [...new Set(vectors.shapes.flatMap((shape) => shape.texts.coordinate ?? []))];
    this.frictions = vectors.shapes.filter(({ kind }) => kind === "friction");
    for (const shape of vectors.shapes.filter(hasPlace)) {
      const index = this.coordinates.indexOf(shape.texts.coordinate ?? "");
      if (index >= 0) for (const part of shape.parts) part.color = PALETTE[index % PALETTE.length];
      const own = this.scales.get(scaleOf(shape)) ?? { ...sizes, first: vectors.first, scales: {} };
      this.scales.set(scaleOf(shape), own);
      const drawn = made(shape, own);
      drawn.object.traverse((object) => (object.userData.shape = shape));
      drawn.object.visible = false;
      this.drawn.push(drawn);
      place.add(drawn.object);
    }
  }

  has(kind: string): boolean {
    return this.vectors.shapes.some((shape) => switchOf(shape) === kind);
  }

  /** The longest arrow of each kind is a part of the machine, along the whole motion. */
  take(motion: Motion): void {
    this.motion = motion;
    this.numbers = new Float64Array(motion.width);
    const { first } = this.vectors;
    const most = new Map<string, number>();
    for (const shape of this.vectors.shapes.filter(hasPlace)) {
      const [x, y, z] = [0, 1, 2].map((k) => motion.column(first + shape.numbers.vector + k));
      const [, size] = extremes(x.map((part, row) => Math.hypot(part, y[row], z[row])), 0, most.get(scaleOf(shape)) ?? 0);
      most.set(scaleOf(shape), size);
    }
    const sizes = this.frictions.flatMap(({ numbers, texts }) =>
      Array.from({ length: Number(texts.components) }, (_, k) => motion.largest(first + numbers.value + k)));
    this.largest = Math.max(0, ...sizes);
    for (const [kind, own] of this.scales) {
      const largest = most.get(kind) ?? 0;
      // A torque that is the rounding of forces at the size of the machine is none.
      const arm = kind.startsWith("reaction torque") ? this.sizes.length * (most.get("reaction N") ?? 0) : 0;
      const longest = largest > ROUNDING * arm ? (LONGEST * this.sizes.length) / largest : 0;
      own.scales = { force: longest, torque: TURNING * longest };
    }
  }

  pose(t: number): void {
    if (this.motion !== null && this.motion.count > 0) {
      const until = Math.min(t, this.motion.last);
      this.motion.state(until, this.numbers);
      this.row = this.motion.rowAt(until);
    }
    for (const drawn of this.drawn) {
      const chosen = this.coordinate === "" || (drawn.shape.texts.coordinate ?? this.coordinate) === this.coordinate;
      drawn.object.visible = this.shown.has(switchOf(drawn.shape)) && chosen && this.motion !== null;
      if (drawn.object.visible) drawn.update({ numbers: this.numbers, first: this.vectors.first });
      drawn.object.updateMatrixWorld(true);
    }
  }

  /** The value behind an arrow, with its unit. */
  value(shape: Shape): string {
    return shape.kind === "friction" ? this.rubs(shape) : `${sizeText(vector(shape.numbers, "vector", { numbers: this.numbers, first: this.vectors.first }).length())} ${unitOf(shape)}`;
  }

  /** The value that the longest arrow of each switched kind stands for; what each friction does now. */
  legend(): string[] {
    const lines: string[] = [];
    const moving: string[] = [];
    for (const [kind, own] of this.scales) {
      const shape = this.vectors.shapes.find((each) => scaleOf(each) === kind);
      if (shape === undefined || !this.shown.has(switchOf(shape)) || own.scales.force === 0) continue;
      const unit = unitOf(shape) === "1" ? "" : ` ${unitOf(shape)}`;
      const size = `${sizeText((LONGEST * this.sizes.length) / own.scales.force)}${unit}`;
      if (shape.kind === "admissible") moving.push(...this.movedIn(unitOf(shape)).map((name) => `∂r/∂${this.greek(name)}: ${size}`));
      else lines.push(`${shape.kind}: longest ${size}`);
    }
    if (moving.length > 0) lines.unshift(`longest ${moving.join(", ")}`);
    if (!this.shown.has("friction") || this.motion === null) return lines;
    const told = [...new Set(this.frictions.map((shape) => `${shape.name}: ${this.rubs(shape)}`))];
    return [...lines, ...told.slice(0, MOST_TOLD), ...(told.length > MOST_TOLD ? [`and ${told.length - MOST_TOLD} more`] : [])];
  }

  /** A name whose words of Greek letters are these letters. */
  private greek(name: string): string {
    return name.replace(/[a-z]+/g, (word) => this.vectors.letters[word] ?? word);
  }

  /** Shown coordinates whose admissible motions have this unit. */
  private movedIn(unit: string): string[] {
    const own = this.vectors.shapes.filter((shape) => shape.kind === "admissible" && unitOf(shape) === unit);
    const names = [...new Set(own.flatMap((shape) => shape.texts.coordinate ?? []))];
    return names.filter((name) => this.coordinate === "" || name === this.coordinate);
  }

  /** Mode and force of friction: the mode of the last row, for between two rows it is neither. */
  private rubs(shape: Shape): string {
    const { first } = this.vectors;
    const mode = MODES[this.motion?.at(this.row, first + shape.numbers.mode) ?? 0] ?? "";
    if (mode === "open") return mode;
    const at = first + shape.numbers.value;
    const size = Math.hypot(...this.numbers.subarray(at, at + Number(shape.texts.components)));
    return `${mode}, ${sizeText(size > ROUNDING * this.largest ? size : 0)} ${unitOf(shape)}`;
  }
}

/** False for friction that acts at no place, as a clutch: it has a value alone. */
function hasPlace(shape: Shape): boolean {
  return "vector" in shape.numbers;
}

export function unitOf(shape: Shape): string {
  return shape.texts.unit ?? UNITS[shape.kind] ?? "N";
}

export function sizeText(value: number): string {
  return Number(value.toPrecision(3)).toString();
}

function switchOf(shape: Shape): string {
  return shape.kind === "reaction torque" ? "reaction" : shape.kind;
}

function scaleOf(shape: Shape): string {
  return `${shape.kind} ${unitOf(shape)}`;
}
