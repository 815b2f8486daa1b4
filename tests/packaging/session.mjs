// Rows of a motion as JSON: node session.mjs lag.wasm model.tape tolerance stop count [rows that come and go]
import { readFileSync } from "node:fs";

const [wasm, path, tolerance, stop, count, loose] = process.argv.slice(2);
const module = new WebAssembly.Module(readFileSync(wasm));
const lag = new WebAssembly.Instance(module, {}).exports;
lag._initialize();

// Addresses from __heap_base on are ours; memory grows as it is needed.
let end = lag.__heap_base.value;
function take(size) {
  const start = Math.ceil(end / 16) * 16;
  end = start + size;
  const missing = Math.ceil((end - lag.memory.buffer.byteLength) / 65536);
  if (missing > 0) lag.memory.grow(missing);
  return start;
}
function check(status, what) {
  if (status !== 0) throw new Error(`${what}: status ${status}`);
}

const bytes = readFileSync(path);
const tape = take(bytes.length);
new Uint8Array(lag.memory.buffer).set(bytes, tape);
const needed = take(4);
check(lag.lag_tape_check(tape, bytes.length, needed), "tape");
const model = lag.lag_tape_model(tape, bytes.length, take(new Uint32Array(lag.memory.buffer, needed, 1)[0]));
const start = lag.lag_tape_start(model);
const block = take(lag.lag_session_size(model, start));
const session = lag.lag_session_place(block, model, start, Number(tolerance), Number(stop));
const lasting = lag.lag_session_lasting(session);
for (const row of loose ? loose.split(",") : []) new Float64Array(lag.memory.buffer, lasting)[Number(row)] = 0;
check(lag.lag_session_begin(session, 0), "begin");
const rows = [];
for (let k = 1; k <= Number(count); ++k) {
  check(lag.lag_session_to(session, (Number(stop) * k) / Number(count), 0), "to");
  const row = lag.lag_session_row(session);
  rows.push(Array.from(new Float64Array(lag.memory.buffer, row, lag.lag_session_width(session))));
}
console.log(JSON.stringify({ imports: WebAssembly.Module.imports(module), rows }));
