// Integrates motions with the runtime of lagdsl as WebAssembly. One motion a message; the newest message counts.
import { INTERRUPTED, placeIn, STOPPED, type Answer, type Order, type Pull, type Setup } from "./orders.ts";

interface Lag {
  memory: WebAssembly.Memory;
  __heap_base: WebAssembly.Global;
  _initialize(): void;
  lag_tape_check(tape: number, count: number, needed: number): number;
  lag_tape_model(tape: number, count: number, memory: number): number;
  lag_tape_start(model: number): number;
  lag_session_size(model: number, start: number): number;
  lag_session_place(block: number, model: number, start: number, tolerance: number, length: number): number;
  lag_session_parameters(session: number): number;
  lag_session_inputs(session: number): number;
  lag_session_lasting(session: number): number;
  lag_session_begin(session: number, t: number): number;
  lag_session_to(session: number, t: number, steps: number): number;
  lag_session_row(session: number): number;
  lag_session_width(session: number): number;
  lag_session_sensitivities_size(model: number, count: number): number;
  lag_session_differentiate(session: number, block: number, count: number, which: number): void;
  lag_session_derivatives(session: number): number;
  lag_session_events(session: number): number;
  lag_session_fault(session: number, status: number): number;
  lag_session_guilty(session: number): number;
}

const LOOKED = 5;
const LONGEST = 3000; // [ms] of integration; motions beyond that end early, which the page tells
const STEPS = 2000; // between looks at the clock, fewer where each of them has derivatives
const KEPT = 64; // LAG_SESSION_EVENTS
const MOST_EVENTS = 20000;
const PULLS = 4; // steps of Gauss and Newton towards the pointer
const LEAST_CHANGE = 1e-6;
const LARGEST_CHANGE = 0.5; // of a start in one step

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
    new Uint8Array(this.lag.memory.buffer).set(bytes, tape);
    const needed = this.take(4);
    if (this.lag.lag_tape_check(tape, bytes.length, needed) !== 0) throw new Error("the tape is damaged");
    const room = new Uint32Array(this.lag.memory.buffer, needed, 1)[0];
    const model = this.lag.lag_tape_model(tape, bytes.length, this.take(room));
    const start = this.lag.lag_tape_start(model);
    const block = this.take(this.lag.lag_session_size(model, start));
    const length = setup.stop - setup.start;
    this.session = this.lag.lag_session_place(block, model, start, setup.tolerance, length);
    this.width = this.lag.lag_session_width(this.session);
    const lasting = this.lag.lag_session_lasting(this.session);
    for (const row of setup.lasting) new Float64Array(this.lag.memory.buffer, lasting)[row] = 0;
    if (setup.by.length > 0) this.differentiate(model, setup.by);
  }

  private differentiate(model: number, by: number[]): void {
    const which = this.take(4 * by.length);
    const block = this.take(this.lag.lag_session_sensitivities_size(model, by.length));
    new Uint32Array(this.lag.memory.buffer, which, by.length).set(by);
    this.lag.lag_session_differentiate(this.session, block, by.length, which);
  }

  /** Of the present row, as it stands in the memory of the module. */
  private derivatives(): Float64Array {
    const { length } = this.setup.by;
    const address = length > 0 ? this.lag.lag_session_derivatives(this.session) : 0;
    return address === 0 ? new Float64Array(0) : new Float64Array(this.lag.memory.buffer, address, length * this.width).slice();
  }

  /** Addresses from __heap_base on are ours; the memory grows as it is needed. */
  private take(size: number): number {
    const start = Math.ceil(this.end / 16) * 16;
    this.end = start + size;
    const missing = Math.ceil((this.end - this.lag.memory.buffer.byteLength) / 65536);
    if (missing > 0) this.lag.memory.grow(missing);
    return start;
  }

  private write(address: number, values: Float64Array): void {
    new Float64Array(this.lag.memory.buffer, address, values.length).set(values);
  }

  run(order: Order): Answer {
    const began = performance.now();
    const { start, stop, rows, by } = this.setup;
    const steps = Math.ceil(STEPS / (1 + by.length));
    const values = new Float64Array(rows * this.width);
    this.write(this.lag.lag_session_inputs(this.session), order.inputs);
    if (order.pull !== null) this.pulled(order.pull, order.parameters);
    let status = this.begin(order.parameters);
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
      if (status === LOOKED) { // more steps than a look allows
        status = performance.now() - began < LONGEST ? 0 : INTERRUPTED;
        if (status === 0) continue;
      }
      const row = this.lag.lag_session_row(this.session);
      const found = new Float64Array(this.lag.memory.buffer, row, this.width);
      time = found[0];
      if (status === 0 || (status === STOPPED && time > values[Math.max(count - 1, 0) * this.width])) {
        values.set(found, count * this.width);
        ++count;
      }
      if (status === 0 && performance.now() - began > LONGEST) status = INTERRUPTED;
    }
    const derivatives = status === 0 ? this.derivatives() : new Float64Array(0);
    const took = performance.now() - began;
    const blamed = status > 0 ? this.blamed(status) : [];
    const found = values.slice(0, count * this.width);
    return { number: order.number, rows: found, parameters: order.parameters, events, blamed, status, time, took, derivatives };
  }

  private begin(parameters: Float64Array): number {
    this.write(this.lag.lag_session_parameters(this.session), parameters);
    return this.lag.lag_session_begin(this.session, this.setup.start);
  }

  private note(events: Answer["events"]): void {
    const at = this.lag.lag_session_events(this.session);
    const [count] = new Float64Array(this.lag.memory.buffer, at, 1);
    const found = new Float64Array(this.lag.memory.buffer, at + 8, 3 * Math.min(count, KEPT));
    for (let k = 0; k < found.length && events.length < MOST_EVENTS; k += 3) events.push([found[k], found[k + 1], found[k + 2]]);
  }

  /** Numbers of what is to blame for a status. */
  private blamed(status: number): number[] {
    const which = this.lag.lag_session_fault(this.session, status);
    if (which >= 0) return [which];
    const guilty = new Float64Array(this.lag.memory.buffer, this.lag.lag_session_guilty(this.session), this.setup.entries);
    return [...guilty.keys()].filter((k) => guilty[k] !== 0);
  }

  /** Starts with which a place is nearest to where it is pulled, by the least change of them: Gauss and Newton, with halved steps. */
  private pulled({ parts, goal, across, starts }: Pull, parameters: Float64Array): void {
    const off = (): [number, number] | null => {
      if (this.begin(parameters) !== 0) return null;
      const row = new Float64Array(this.lag.memory.buffer, this.lag.lag_session_row(this.session), this.width);
      const place = placeIn(row, parts);
      const away = [0, 1, 2].map((k) => goal[k] - place[k]);
      return [0, 1].map((i) => across[i].reduce((sum, part, k) => sum + part * away[k], 0)) as [number, number];
    };
    const changed = (changes: number[], part: number, from: number[]): void =>
      starts.forEach(({ parameter }, i) => (parameters[parameter] = from[i] + part * changes[i]));
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
      const changes = slopes.map((slope, i) => {
        const change = slope[0] * u + slope[1] * v;
        return starts[i].size * Math.min(Math.max(change, -LARGEST_CHANGE), LARGEST_CHANGE);
      });
      let part = 1;
      for (; part > 0.05; part /= 2) {
        changed(changes, part, from);
        const then = off();
        if (then !== null && Math.hypot(...then) < Math.hypot(...now)) break;
      }
      if (part <= 0.05) {
        changed(changes, 0, from);
        return;
      }
    }
    if (this.begin(parameters) !== 0) return;
    const row = new Float64Array(this.lag.memory.buffer, this.lag.lag_session_row(this.session), this.width);
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
