// Bundles the page into dist/. The same sources give the same bytes; sources.sha256 tells from which they come.
import { createHash } from "node:crypto";
import { mkdir, readdir, readFile, writeFile } from "node:fs/promises";
import { build } from "esbuild";

// Parts of three.js for what no page has, which it cannot leave out by itself: shaders of other materials and of effects, which
// are guarded by their own #if; shadows, headsets, surroundings, pictures from many sides, tracks of animations,
// files of scenes.
const parts = /\b(var|const) ((?:alphahash|alphamap|aomap|batching|bumpmap|clearcoat|clipping|cube_uv|displacementmap|dithering|emissivemap|envmap|fog|gradientmap|iridescence|lightmap|lightprobes|lights_(?:physical|toon|phong)|logdepthbuf|map_particle|metalnessmap|morph|normalmap|packing|roughnessmap|shadowmap|skin|tonemapping|transmission)\w*) = "(?:[^"\\]|\\.)*"/g;
const wholes = /\b(?:background|backgroundCube|cube|depth|distance|equirect|linedashed|mesh(?:matcap|normal|phong|physical|toon)|points|shadow)_(?:vert|frag): ([\w$]+)/g;
const absent = ["render", "dispose", "addEventListener", "removeEventListener", "setAnimationLoop", "getEnvironmentBlendMode"].map((name) => `${name}() {}`);
const without = (text) => {
  const unused = new Set([...text.matchAll(wholes)].map(([, name]) => name));
  const blank = (whole, name) => (unused.has(name) ? `const ${name} = ""` : whole);
  return text
    .replace(parts, '$1 $2 = ""')
    .replace(/\bconst ((?:vertex|fragment)\$\w+) = "(?:[^"\\]|\\.)*"/g, blank)
    .replace(/^(?:class|function) (WebXR(?:Manager|DepthSensing)|PMREMGenerator|WebGLShadowMap|CubeCamera)\b[^]*?^}/gm, `class $1 { enabled = false; isPresenting = false; ${absent.join(" ")} }`)
    .replace(/^\t(?:toJSON|fromJSON)\([^]*?^\t}$/gm, "")
    .replace(/^(?:\w*KeyframeTrack|PropertyBinding)\.[^]*?;$/gm, "");
};
const shaders = {
  name: "shaders",
  setup: ({ onLoad }) =>
    onLoad({ filter: /three\.(module|core)\.js$/ }, async ({ path }) => ({ contents: without(await readFile(path, "utf8")), loader: "js" })),
};
const common = { bundle: true, minify: true, target: "es2022", format: "iife", legalComments: "none", logLevel: "warning" };
await mkdir("dist", { recursive: true });
await build({ ...common, entryPoints: ["src/main.ts"], outfile: "dist/page.js", plugins: [shaders] });
await build({ ...common, entryPoints: ["src/loader.ts"], outfile: "dist/loader.js" });
await build({ ...common, entryPoints: ["src/worker.ts"], outfile: "dist/worker.js" });
await build({ ...common, entryPoints: ["src/page.css"], outfile: "dist/page.css" });
const notices = new Map(); // the terms that several share stand once
for (const [name, license] of [["gifenc", "LICENSE.md"], ["three", "LICENSE"], ["uplot", "LICENSE"]]) {
  const { version } = JSON.parse(await readFile(`node_modules/${name}/package.json`, "utf8"));
  const [holder, terms] = (await readFile(`node_modules/${name}/${license}`, "utf8")).split(/(?=Permission is hereby granted)/);
  const same = terms.replace(/\s+/g, " ").trim();
  notices.set(same, [...(notices.get(same) ?? []), `${name} ${version}\n\n${holder.trim()}`]);
}
const texts = [...notices].map(([terms, holders]) => [...holders, terms].join("\n\n"));
await writeFile("dist/licenses.txt", `${texts.join("\n\n")}\n`);

const sources = (await readdir("src")).map((name) => `src/${name}`);
const digest = createHash("sha256");
for (const name of [...sources, "build.mjs", "package-lock.json", "package.json", "tsconfig.json"].sort()) {
  digest.update(`${name}\0`).update(await readFile(name)).update("\0");
}
await writeFile("dist/sources.sha256", `${digest.digest("hex")}\n`);
