// Drives the extension's language client's protocol against `lag lsp` in node: a text, its diagnostics, a hover.
import { spawn } from "node:child_process";
import { createRequire } from "node:module";

const require = createRequire(import.meta.url);
const { createProtocolConnection, StreamMessageReader, StreamMessageWriter } = require("vscode-languageserver-protocol/node");

const [command, ...rest] = (process.env.LAG ?? "lag").split(" ");
const server = spawn(command, [...rest, "lsp", "--stdio"], { stdio: ["pipe", "pipe", "inherit"] });
const connection = createProtocolConnection(
  new StreamMessageReader(server.stdout),
  new StreamMessageWriter(server.stdin),
);
const uri = new URL("pendulum.lag", import.meta.url).href;
const text = `model Pendulum
  parameter Length l = 0.5 m;
  coordinate Angle theta(start = 60 deg);
  gravity = -g_n*world.y;
  mass 1 kg at {l*sin(thet), -l*cos(theta)};
end Pendulum;
`;
const told = new Promise((done) => connection.onNotification("textDocument/publishDiagnostics", done));
connection.listen();
const { capabilities } = await connection.sendRequest("initialize", {
  processId: process.pid,
  rootUri: null,
  capabilities: {},
});
await connection.sendNotification("initialized", {});
await connection.sendNotification("textDocument/didOpen", {
  textDocument: { uri, languageId: "lag", version: 1, text },
});
const { diagnostics } = await told;
const hover = await connection.sendRequest("textDocument/hover", {
  textDocument: { uri },
  position: { line: 4, character: 16 },
});
await connection.sendRequest("shutdown");
await connection.sendNotification("exit");
const checks = {
  "the server offers completion": capabilities.completionProvider !== undefined,
  "one fault, at its place": diagnostics.length === 1 && diagnostics[0].code === "E0201" && diagnostics[0].range.start.line === 4,
  "a hover shows the declaration": hover.contents.value.includes("parameter Length l = 0.5 m"),
};
for (const [what, holds] of Object.entries(checks)) {
  console.log(`${holds ? "ok" : "FAILED"}: ${what}`);
}
process.exit(Object.values(checks).every(Boolean) ? 0 : 1);
