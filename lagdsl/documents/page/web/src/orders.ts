// What the page and its worker say to each other.

export interface Setup {
  wasm: ArrayBuffer;
  tape: ArrayBuffer;
  start: number;
  stop: number;
  rows: number;
  tolerance: number;
  longest: number; // [ms] of integration; motions beyond that end early, which the page tells
  lasting: number[];
  by: number[]; // parameters and, behind them, inputs that the end of the motion is differentiated by
  entries: number; // discrete variables
}
export interface Order {
  parameters: Float64Array;
  inputs: Float64Array;
  pull: Pull | null; // first find starts
}

/** A place of the machine that is pulled to another one, as seen on the screen: both axes of that in `across`. */
export interface Pull {
  parts: [column: number, weight: number, across?: number][]; // the place is the sum of these vectors of a row, or of their products with others
  goal: number[];
  across: number[][];
  starts: { parameter: number; column: number; size: number }[]; // that may change
}
export interface Answer {
  rows: Float64Array;
  parameters: Float64Array;
  events: [time: number, kind: number, which: number][];
  blamed: number[];
  status: number;
  time: number; // at which the motion ended [s]
  took: number; // [ms]
  derivatives: Float64Array; // of the last row by each of Setup.by, a row each; empty where there are none
}

/** The place that is pulled, in a row. */
export function placeIn(row: ArrayLike<number>, parts: Pull["parts"]): [number, number, number] {
  const place: [number, number, number] = [0, 0, 0];
  for (const [column, weight, across] of parts) {
    for (let k = 0; k < 3; ++k) {
      const [i, j] = [(k + 1) % 3, (k + 2) % 3];
      place[k] += weight * (across === undefined ? row[column + k] : row[column + i] * row[across + j] - row[column + j] * row[across + i]);
    }
  }
  return place;
}

/** The status of a motion that the model ended, */
export const STOPPED = 9;
/** and that of one that took longer than one waits. */
export const INTERRUPTED = -1;
