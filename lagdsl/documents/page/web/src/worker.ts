// Integrates motions with the runtime of lagdsl as WebAssembly. One motion a message; the newest message counts.
import { INTERRUPTED, STOPPED, type Answer, type Order, type Setup } from "./orders.ts";

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
}

const LOOKED = 5;
const LONGEST = 3000; // [ms] of integration; motions beyond that end early, which the page tells
const STEPS = 2000; // between looks at the clock, fewer where each of them has derivatives

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
    this.write(this.lag.lag_session_parameters(this.session), order.parameters);
    this.write(this.lag.lag_session_inputs(this.session), order.inputs);
    let status = this.lag.lag_session_begin(this.session, start);
    let count = 0;
    let time = start;
    while (status === 0 && count < rows) {
      const goal = count + 1 === rows ? stop : start + ((stop - start) * count) / (rows - 1);
      if (count > 0) status = this.lag.lag_session_to(this.session, goal, steps);
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
    return { number: order.number, rows: values.slice(0, count * this.width), status, time, took, derivatives };
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
