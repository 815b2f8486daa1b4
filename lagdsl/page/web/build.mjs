// Bundles the page: dist/page.js, dist/worker.js, dist/page.css, dist/licenses.txt. The same sources give the same bytes.
import { build } from "esbuild";
import { mkdir, readFile, writeFile } from "node:fs/promises";

const common = { bundle: true, minify: true, target: "es2022", format: "iife", legalComments: "none", logLevel: "warning" };
await mkdir("dist", { recursive: true });
await build({ ...common, entryPoints: ["src/main.ts"], outfile: "dist/page.js" });
await build({ ...common, entryPoints: ["src/loader.ts"], outfile: "dist/loader.js" });
await build({ ...common, entryPoints: ["src/worker.ts"], outfile: "dist/worker.js" });
await build({ ...common, entryPoints: ["src/page.css"], outfile: "dist/page.css" });
const notices = [];
for (const name of ["three", "uplot"]) {
  const { version } = JSON.parse(await readFile(`node_modules/${name}/package.json`, "utf8"));
  notices.push(`${name} ${version}\n\n${(await readFile(`node_modules/${name}/LICENSE`, "utf8")).trim()}\n`);
}
await writeFile("dist/licenses.txt", notices.join("\n"));
