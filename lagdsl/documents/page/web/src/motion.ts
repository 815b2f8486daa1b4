// Rows of a motion, recorded or integrated here.
import type { Column, Head } from "./head.ts";
import { extremes } from "./numbers.ts";

export class Motion {
  readonly count: number;
  constructor(
    readonly width: number,
    readonly values: Float32Array | Float64Array, // row by row
  ) {
    this.count = Math.floor(values.length / width);
  }

  at(row: number, column: number): number {
    return this.values[row * this.width + column];
  }

  /** The numbers of a row, as they stand. */
  row(row: number): Float32Array | Float64Array {
    return this.values.subarray(row * this.width, (row + 1) * this.width);
  }

  get last(): number {
    return this.count > 0 ? this.at(this.count - 1, 0) : 0;
  }

  /** The last row that is not after t. */
  rowAt(t: number): number {
    let [low, high] = [0, this.count - 1];
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (this.at(middle, 0) <= t) low = middle;
      else high = middle - 1;
    }
    return low;
  }

  /** All numbers at time t, between two rows on the line through them. */
  state(t: number): Float64Array {
    const row = this.rowAt(t);
    const next = Math.min(row + 1, this.count - 1);
    const length = this.at(next, 0) - this.at(row, 0);
    const part = length > 0 ? Math.min(Math.max((t - this.at(row, 0)) / length, 0), 1) : 0;
    const [a, b] = [this.row(row), this.row(next)];
    return Float64Array.from({ length: this.width }, (_, i) => a[i] + part * (b[i] - a[i]));
  }

  /** The largest size in a column, or of a vector in several ones. */
  largest(index: number, count = 1): number {
    return extremes(Array.from({ length: this.count }, (_, row) => Math.hypot(...this.row(row).subarray(index, index + count))), 0, 0)[1];
  }

  /** A column in the unit that is shown. */
  shown(columns: readonly Pick<Column, "display">[], index: number): Float64Array {
    const { scale, shift } = columns[index].display;
    return Float64Array.from({ length: this.count }, (_, row) => this.at(row, index) * scale + shift);
  }
}

/** The recorded motions: of each columns of single precision, one after the other. */
export function recorded(head: Head, bytes: Uint8Array<ArrayBuffer>): Motion[] {
  const numbers = new Float32Array(bytes.buffer);
  const lengths = head.runs?.map((run) => run.rows) ?? [head.rows];
  const width = numbers.length / lengths.reduce((sum, rows) => sum + rows, 0);
  let from = 0;
  return lengths.map((rows) => {
    const values = new Float32Array(rows * width);
    for (let column = 0; column < width; ++column) {
      for (let row = 0; row < rows; ++row) values[row * width + column] = numbers[from + column * rows + row];
    }
    from += rows * width;
    return new Motion(width, values);
  });
}

/** All rows of several motions, for what looks at their extent only. */
export function together(motions: Motion[]): Motion {
  if (motions.length === 1) return motions[0];
  const values = Float32Array.from(motions.flatMap((motion) => [...motion.values]));
  return new Motion(motions[0].width, values);
}
