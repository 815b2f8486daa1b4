// Bundles the extension into two files: itself with its language client, and the protocol that the client speaks.
import { build } from "esbuild";

const PROTOCOL = /^vscode-(languageserver-protocol|jsonrpc)(\/node(\.js)?)?$/;

const common = {
  bundle: true,
  platform: "node",
  format: "cjs",
  target: "node20",
  external: ["vscode"],
  minify: true,
};

const beside = {
  name: "the protocol lies beside the extension",
  setup(building) {
    building.onResolve({ filter: PROTOCOL }, () => ({ path: "./protocol.js", external: true }));
  },
};

await build({ ...common, entryPoints: { protocol: "vscode-languageserver-protocol/node" }, outdir: "dist" });
await build({ ...common, entryPoints: ["src/extension.ts"], outdir: "dist", plugins: [beside] });
