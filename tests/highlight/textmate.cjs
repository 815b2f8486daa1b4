// Scopes of the characters of texts, by the engine of VS Code: node textmate.cjs REQUEST, with the modules in NODE_PATH.
const fs = require("fs");
const path = require("path");
const oniguruma = require("vscode-oniguruma");
const textmate = require("vscode-textmate");

async function main() {
  const request = JSON.parse(fs.readFileSync(process.argv[2], "utf8"));
  const wasm = fs.readFileSync(path.join(path.dirname(require.resolve("vscode-oniguruma")), "onig.wasm"));
  await oniguruma.loadWASM(wasm.buffer.slice(wasm.byteOffset, wasm.byteOffset + wasm.byteLength));
  const registry = new textmate.Registry({
    onigLib: Promise.resolve({
      createOnigScanner: (sources) => new oniguruma.OnigScanner(sources),
      createOnigString: (text) => new oniguruma.OnigString(text),
    }),
    loadGrammar: async () => textmate.parseRawGrammar(request.grammar, "lag.tmLanguage.json"),
  });
  const grammar = await registry.loadGrammar("source.lag");
  const found = {};
  for (const [name, text] of Object.entries(request.texts)) {
    const scopes = [];
    let state = textmate.INITIAL;
    for (const line of text.split("\n")) {
      const { tokens, ruleStack } = grammar.tokenizeLine(line, state);
      for (const token of tokens) {
        // Characters of Python are code points; those of JavaScript beyond 16 bits are two.
        for (const _ of line.slice(token.startIndex, Math.min(token.endIndex, line.length))) {
          scopes.push(token.scopes[token.scopes.length - 1]);
        }
      }
      scopes.push("");
      state = ruleStack;
    }
    scopes.pop();
    found[name] = scopes;
  }
  process.stdout.write(JSON.stringify(found));
}

main();
