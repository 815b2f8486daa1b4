// Runs the worker of a page outside a browser: node worker.mjs FOLDER, with worker.js, setup.json, lag.wasm, model.tape
// and orders.json in it. Writes answers.json.
import { readFileSync, writeFileSync } from "node:fs";

const folder = process.argv[2];
const read = (name) => readFileSync(`${folder}/${name}`);
const buffer = (name) => new Uint8Array(read(name)).buffer;
const answers = [];
globalThis.self = { postMessage: (message) => answers.push(message) };
(0, eval)(read("worker.js").toString());
self.onmessage({ data: { ...JSON.parse(read("setup.json")), wasm: buffer("lag.wasm"), tape: buffer("model.tape") } });
for (const { parameters, inputs, pull = null } of JSON.parse(read("orders.json"))) {
  self.onmessage({ data: { number: 1, parameters: Float64Array.from(parameters), inputs: Float64Array.from(inputs), pull } });
}
writeFileSync(`${folder}/answers.json`, JSON.stringify(answers, (_, value) => (value instanceof Float64Array ? Array.from(value) : value)));
