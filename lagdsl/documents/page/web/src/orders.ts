// What the page and its worker say to each other.

export interface Setup {
  wasm: ArrayBuffer;
  tape: ArrayBuffer;
  start: number;
  stop: number;
  rows: number;
  tolerance: number;
  lasting: number[];
  by: number[]; // parameters and, behind them, inputs that the end of the motion is differentiated by
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
  derivatives: Float64Array; // of the last row by each of Setup.by, a row each; empty where there are none
}

/** The status of a motion that the model ended, */
export const STOPPED = 9;
/** and that of one that took longer than one waits. */
export const INTERRUPTED = -1;
