// What the page and its worker say to each other.

export interface Setup {
  wasm: ArrayBuffer;
  tape: ArrayBuffer;
  start: number;
  stop: number;
  rows: number;
  tolerance: number;
  lasting: number[];
}
export interface Order {
  number: number;
  parameters: Float64Array;
  inputs: Float64Array;
}
export interface Answer {
  number: number;
  rows: Float64Array;
  status: number;
  time: number; // at which the motion ended [s]
  took: number; // [ms]
}

/** The status of a motion that took longer than one waits. */
export const INTERRUPTED = -1;
