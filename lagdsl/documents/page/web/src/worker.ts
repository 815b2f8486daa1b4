// Integrates motions with the runtime of lagdsl as WebAssembly. One motion a message; the newest message counts.
import { INTERRUPTED, placeIn, STOPPED, type Answer, type Order, type Pull, type Setup } from "./orders.ts";

/** Functions of lag/tape.h and lag/session.h: addresses and numbers. */
type Names = "tape_check" | "tape_model" | "tape_start" | `session_${
  "size" | "place" | "parameters" | "inputs" | "lasting" | "begin" | "to" | "row" | "width" | "sensitivities_size" | "differentiate" |
  "derivatives" | "events" | "fault" | "guilty"}`;
type Lag = Record<`lag_${Names}`, (...given: number[]) => number> & {
  memory: WebAssembly.Memory;
  __heap_base: WebAssembly.Global;
  _initialize(): void;
};

const LOOKED = 5; // the status of more steps than a look allows
const STEPS = 2000; // between looks at the clock, fewer where each of them has derivatives
const KEPT = 64; // LAG_SESSION_EVENTS
const MOST_EVENTS = 20000;
const PULLS = 4; // steps of Gauss and Newton towards the pointer
const LEAST_CHANGE = 1e-6;
const LARGEST_CHANGE = 0.5; // of a start in one step
const LEAST_PART = 0.05; // of a step

class Session {
  private readonly lag: Lag;
  private end: number;
  private readonly session: number;
  readonly width: number;

  constructor(private readonly setup: Setup) {
    const instance = new WebAssembly.Instance(new WebAssembly.Module(setup.wasm), {});
    this.lag = instance.exports as unknown as Lag;
    this.lag._initialize();
    this.end = this.lag.__heap_base.value as number;
    const bytes = new Uint8Array(setup.tape);
    const tape = this.take(bytes.length);
    new Uint8Array(this.memory).set(bytes, tape);
    const needed = this.take(4);
    if (this.lag.lag_tape_check(tape, bytes.length, needed) !== 0) throw new Error("the tape is damaged");
    const room = new Uint32Array(this.memory, needed, 1)[0];
    const model = this.lag.lag_tape_model(tape, bytes.length, this.take(room));
    const start = this.lag.lag_tape_start(model);
    const block = this.take(this.lag.lag_session_size(model, start));
    this.session = this.lag.lag_session_place(block, model, start, setup.tolerance, setup.stop - setup.start);
    this.width = this.lag.lag_session_width(this.session);
    const lasting = this.lag.lag_session_lasting(this.session);
    for (const row of setup.lasting) this.numbers(lasting + 8 * row, 1)[0] = 0;
    const count = setup.by.length;
    if (count === 0) return;
    const which = this.take(4 * count);
    const derivatives = this.take(this.lag.lag_session_sensitivities_size(model, count));
    new Uint32Array(this.memory, which, count).set(setup.by);
    this.lag.lag_session_differentiate(this.session, derivatives, count, which);
  }

  private get memory(): ArrayBuffer {
    return this.lag.memory.buffer; // another one when the memory has grown
  }

  private numbers(address: number, count: number): Float64Array {
    return new Float64Array(this.memory, address, count);
  }

  private get row(): Float64Array {
    return this.numbers(this.lag.lag_session_row(this.session), this.width);
  }

  /** Addresses from __heap_base on are ours; the memory grows as it is needed. */
  private take(size: number): number {
    const start = Math.ceil(this.end / 16) * 16;
    this.end = start + size;
    const missing = Math.ceil((this.end - this.memory.byteLength) / 65536);
    if (missing > 0) this.lag.memory.grow(missing);
    return start;
  }

  run({ parameters, inputs, pull }: Order): Answer {
    const began = performance.now();
    const { start, stop, rows, by, longest } = this.setup;
    const steps = Math.ceil(STEPS / (1 + by.length));
    const values = new Float64Array(rows * this.width);
    this.numbers(this.lag.lag_session_inputs(this.session), inputs.length).set(inputs);
    if (pull !== null) this.pulled(pull, parameters);
    let status = this.begin(parameters);
    const events: Answer["events"] = [];
    this.note(events);
    let count = 0;
    let time = start;
    while (status === 0 && count < rows) {
      const goal = count + 1 === rows ? stop : start + ((stop - start) * count) / (rows - 1);
      if (count > 0) {
        status = this.lag.lag_session_to(this.session, goal, steps);
        this.note(events);
      }
      const late = performance.now() - began > longest;
      if (status === LOOKED) {
        status = late ? INTERRUPTED : 0;
        if (!late) continue;
      }
      const { row } = this;
      time = row[0];
      if (status === 0 || (status === STOPPED && time > values[Math.max(count - 1, 0) * this.width])) values.set(row, count++ * this.width);
      if (status === 0 && late) status = INTERRUPTED;
    }
    const address = status === 0 && by.length > 0 ? this.lag.lag_session_derivatives(this.session) : 0;
    const derivatives = this.numbers(address, address === 0 ? 0 : by.length * this.width).slice();
    const took = performance.now() - began;
    const blamed = status > 0 ? this.blamed(status) : [];
    return { rows: values.slice(0, count * this.width), parameters, events, blamed, status, time, took, derivatives };
  }

  private begin(parameters: Float64Array): number {
    this.numbers(this.lag.lag_session_parameters(this.session), parameters.length).set(parameters);
    return this.lag.lag_session_begin(this.session, this.setup.start);
  }

  private note(events: Answer["events"]): void {
    const at = this.lag.lag_session_events(this.session);
    const [count] = this.numbers(at, 1);
    const found = this.numbers(at + 8, 3 * Math.min(count, KEPT));
    for (let k = 0; k < found.length && events.length < MOST_EVENTS; k += 3) events.push([found[k], found[k + 1], found[k + 2]]);
  }

  /** Numbers of what is to blame for a status. */
  private blamed(status: number): number[] {
    const which = this.lag.lag_session_fault(this.session, status);
    if (which >= 0) return [which];
    const guilty = this.numbers(this.lag.lag_session_guilty(this.session), this.setup.entries);
    return [...guilty.keys()].filter((k) => guilty[k] !== 0);
  }

  /** Starts with which a place is nearest to where it is pulled, by the least change of them: Gauss and Newton, with halved steps. */
  private pulled({ parts, goal, across, starts }: Pull, parameters: Float64Array): void {
    const off = (): [number, number] | null => {
      if (this.begin(parameters) !== 0) return null;
      const place = placeIn(this.row, parts);
      return across.map((way) => way.reduce((sum, part, k) => sum + part * (goal[k] - place[k]), 0)) as [number, number];
    };
    for (let k = 0; k < PULLS; ++k) {
      const from = starts.map(({ parameter }) => parameters[parameter]);
      const now = off();
      if (now === null) return;
      const slopes = starts.map(({ parameter, size }, i) => {
        parameters[parameter] = from[i] + LEAST_CHANGE * size;
        const next = off() ?? now;
        parameters[parameter] = from[i];
        return [(now[0] - next[0]) / LEAST_CHANGE, (now[1] - next[1]) / LEAST_CHANGE]; // by size
      });
      const sum = (i: number, j: number): number => slopes.reduce((whole, slope) => whole + slope[i] * slope[j], 0);
      const small = 1e-9 * (sum(0, 0) + sum(1, 1));
      const [a, b, d] = [sum(0, 0) + small, sum(0, 1), sum(1, 1) + small];
      const det = a * d - b * b;
      if (!(det > 0)) return;
      const [u, v] = [(d * now[0] - b * now[1]) / det, (a * now[1] - b * now[0]) / det];
      const changes = slopes.map(([x, y], i) => starts[i].size * Math.min(Math.max(x * u + y * v, -LARGEST_CHANGE), LARGEST_CHANGE));
      for (let part = 1; ; part /= 2) {
        const small = part < LEAST_PART;
        starts.forEach(({ parameter }, i) => (parameters[parameter] = from[i] + (small ? 0 : part * changes[i])));
        if (small) return;
        const then = off();
        if (then !== null && Math.hypot(...then) < Math.hypot(...now)) break;
      }
    }
    if (this.begin(parameters) !== 0) return;
    const { row } = this;
    for (const { parameter, column } of starts) parameters[parameter] = row[column]; // as constraints moved them
  }
}

let session: Session | null = null;
self.onmessage = (event: MessageEvent<Setup | Order>) => {
  if ("wasm" in event.data) {
    session = new Session(event.data);
    self.postMessage({ ready: session.width });
  } else if (session !== null) {
    const answer = session.run(event.data);
    self.postMessage(answer, { transfer: [answer.rows.buffer, answer.derivatives.buffer] });
  }
};
