// What a page is told: the JSON of lagdsl/documents/page/head.py, and the arrays that come with it.
import { bytesOf, inflate } from "./packed.ts";

/** shown = si * scale + shift */
export type Display = { unit: string; scale: number; shift: number };

export interface Column {
  name: string;
  kind: "time" | "coordinate" | "rate" | "state" | "discrete" | "output";
  unit: string;
  display: Display;
  doc: string | null;
}

export interface Quantity {
  name: string;
  doc: string | null;
  display: Display;
  value: number; // SI
  minimum: number | null; // SI, too
  maximum: number | null;
  kind: "Real" | "Integer" | "Boolean" | "Enumeration" | "String";
  group: "parameter" | "start" | "input";
  angle: boolean;
}

/** Lines and columns, from 1. */
export type Span = { first: [number, number]; last: [number, number] };

export interface Shape {
  kind: string;
  name: string;
  numbers: Record<string, number>; // role: column of the scene
  parts: Part[];
  texts: Record<string, string>;
  span: Span | null;
  mesh?: number; // of Head.meshes
}

/** A primitive: what the fields mean stands in lagdsl/derivation/scene/shapes.py. */
export interface Part {
  primitive: "surface" | "line" | "trace" | "label";
  numbers: Record<string, number>;
  color: string;
  form?: string;
  sizes?: [factor: number, column: number, relative: boolean][];
  shade?: number;
  opacity?: number;
  scale?: string;
  still?: boolean;
  offset?: number;
  count?: number;
  board?: number;
}

export interface PackedMesh {
  points: number;
  triangles: number;
  low: number[]; // in units of the file
  step: number[];
  data: string;
}

export interface Head {
  name: string;
  doc: string | null;
  version: string;
  source: string;
  planar: boolean;
  stage: {
    axes: [number, number, number][]; // right, up, back: as one first sees the machine
    center: [number, number, number];
    length: number;
    scales: Record<string, number>;
    boards: number[][]; // places of gauges, column by column
    coil: number[][]; // points of a unit coil
    forms: Record<string, PackedMesh>;
  };
  start: number;
  stop: number;
  tolerance: number;
  columns: Column[]; // of a row; the scene, the energy and two residuals follow
  scene: { first: number; count: number; shapes: Shape[] };
  meshes: PackedMesh[];
  vectors?: { first: number; shapes: Shape[]; letters: Record<string, string> } | null; // arrows, on a tape of their own
  rows: number; // of the recorded motion
  events: Occurrence[];
  parameters: Quantity[]; // as the tape counts them
  inputs: Quantity[];
  lasting: number[]; // rows of constraints that come and go
  differentiable: boolean; // the motion has derivatives by its quantities
  sliders: string[]; // parameters and inputs that the page begins with
  curves: string[]; // none: the first coordinates
  inks: string; // of each character of the source, the letter of its kind
  words: Record<string, string>; // why a run ended, by status; names of `blamed` for braces
  blamed: Record<string, string[]>;
  event_names: { kind: string; names: string[] }[]; // by kinds of events as the runtime counts them
  said: string; // of the recorded motion
  sources: (Span | null)[]; // statements of the text that terms of the equations come from
  // Pages with several motions, one after the other in the data.
  live?: boolean; // false: nothing is integrated
  runs?: Run[];
  modes?: Mode[];
  levels?: string[]; // amplitudes of modes: as many runs for each mode
  stability?: string;
  locus?: Locus | null;
}

export type Occurrence = { time: number; name: string; kind: string };

export interface Run {
  label: string;
  rows: number;
  start: number;
  stop: number;
  pace: number; // seconds of the motion in a second
  said: string;
  parameters: number[] | null;
  events: Occurrence[];
}

export interface Mode {
  eigenvalue: [number, number]; // [1/s]
  frequency: number; // [Hz], 0 without oscillation
  damping: number | null;
  constant: number | null; // [s]
  shape: { name: string; size: number; phase: number }[]; // [deg]
}

export interface Locus {
  name: string;
  unit: string;
  values: number[];
  eigenvalues: ([number, number] | null)[][];
  thresholds: { value: number; kind: string; frequency: number; unstable_above: boolean }[];
}

const text = (id: string): string => document.getElementById(id)?.textContent ?? "";

export const readHead = (): Head => JSON.parse(text("head")) as Head;

export const inflated = (id: string): Promise<Uint8Array<ArrayBuffer>> => inflate(text(id));

/** The font of formulas: with many others brackets do not stretch. */
export async function loadFont(): Promise<void> {
  document.fonts.add(await new FontFace("lagdsl Math", bytesOf(text("font"))).load());
}

/** Words of a status, with the names of what is to blame. */
export function why(head: Head, status: number, blamed: number[]): string {
  const words = head.words[status] ?? `The run ended with status ${status}.`;
  return words.replace(/\{(\w+)\}/g, (_, table: string) => [...new Set(blamed.map((k) => head.blamed[table][k]))].join(", "));
}
