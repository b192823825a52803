// node page/web/build.mjs [--out build/web] [--scripts-only] [--of-built] [--quiet]
//
// Bundles the page's script, one module a figure and the style sheet, then draws each figure's
// fallback picture with its own C++ (page/wasm/build.mjs figures comes first). Only what changed is
// written. `--scripts-only` leaves the pictures out; `--of-built`: a figure whose C++ is not built has no
// picture, instead of being a failure.
// Exit code 0: all there; 1: something failed (the rest is written); 2: wrong usage.

import { createHash } from "node:crypto";
import fs from "node:fs";
import path from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";
import { parseArgs } from "node:util";
import { build, transform } from "esbuild";
import {
  DARK,
  drawingRules,
  FORCED,
  LEVELS_DARK,
  LEVELS_LIGHT,
  LIGHT,
  levelVariables,
  ROLES,
  variables,
} from "./palette.mjs";

const here = path.dirname(fileURLToPath(import.meta.url));
const root = path.dirname(path.dirname(here));
const modules = path.join(root, "page", "node_modules");

/** @returns {{ values: Record<string, any> }} */
function options() {
  try {
    return parseArgs({
      options: {
        out: { type: "string", default: path.join(root, "build", "web") },
        "scripts-only": { type: "boolean", default: false },
        "of-built": { type: "boolean", default: false },
        quiet: { type: "boolean", default: false },
      },
    });
  } catch (error) {
    console.error(`${error instanceof Error ? error.message : error}`);
    console.error(
      "usage: node page/web/build.mjs [--out FOLDER] [--scripts-only] [--of-built] [--quiet]",
    );
    process.exit(2);
  }
}

const { out, quiet, "scripts-only": scriptsOnly, "of-built": ofBuilt } = options().values;

/** @param {string} text */
const say = (text) => {
  if (!quiet) console.log(text);
};

/** Writes a file if its content is another one; says whether it did.
 * @param {string} file @param {string | Uint8Array} content */
function write(file, content) {
  const bytes = Buffer.from(content);
  if (fs.existsSync(file) && fs.readFileSync(file).equals(bytes)) return false;
  fs.mkdirSync(path.dirname(file), { recursive: true });
  const part = `${file}.${process.pid}.part`;
  fs.writeFileSync(part, bytes);
  fs.renameSync(part, file);
  return true;
}

/** Every figure's drawing: chapters/NN_slug/figures/NAME.ts. */
function figures() {
  const chapters = path.join(root, "chapters");
  const folders = fs.existsSync(chapters) ? fs.readdirSync(chapters).sort() : [];
  return folders.flatMap((slug) => {
    const folder = path.join(chapters, slug, "figures");
    const files = fs.existsSync(folder) ? fs.readdirSync(folder).sort() : [];
    return files
      .filter((file) => file.endsWith(".ts"))
      .map((file) => ({ name: `${slug}/${file.slice(0, -3)}`, source: path.join(folder, file) }));
  });
}

/** @type {import("esbuild").BuildOptions} */
const common = {
  bundle: true,
  format: "esm",
  splitting: true,
  write: false,
  target: ["es2022", "safari16"],
  // three's renderer is never used: its core alone is a quarter of the size.
  alias: {
    "@contact": path.join(here, "src"),
    three: path.join(modules, "three", "src", "Three.Core.js"),
    "three/addons": path.join(modules, "three", "examples", "jsm"),
  },
  nodePaths: [modules],
  // Engines that are asked questions come with their WebAssembly.
  loader: { ".wasm": "binary" },
  // What engines import where they run in Node; a browser never reaches it.
  external: ["module", "node:*", "fs", "path", "url", "worker_threads"],
  logLevel: "warning",
  legalComments: "none",
};

/** @param {import("esbuild").BuildOptions} wanted */
async function bundle(wanted) {
  const { outputFiles = [] } = await build({ ...common, ...wanted });
  const written = outputFiles.filter(({ path: file, contents }) => write(file, contents)).length;
  const chunks = path.join(/** @type {string} */ (wanted.outdir), "chunks");
  const kept = new Set(outputFiles.map(({ path: file }) => file));
  if (fs.existsSync(chunks))
    for (const file of fs.readdirSync(chunks).map((name) => path.join(chunks, name)))
      if (!kept.has(file)) fs.rmSync(file);
  return written;
}

function styles() {
  const roles = ROLES.map(
    (role) =>
      `contact-figure .grip.r-${role},contact-figure .t-${role}{color:var(--contact-${role})}`,
  ).join("\n");
  const levels = LEVELS_LIGHT.map(
    (_, i) =>
      `contact-ladder .level-${i}{background:var(--contact-level-${i});color:var(--contact-on-level-${i})}`,
  ).join("");
  const light = `${variables(LIGHT)}${levelVariables(LEVELS_LIGHT)}`;
  const dark = `${variables(DARK)}${levelVariables(LEVELS_DARK)}`;
  return `
:root{${light}}
body[data-theme="dark"]{${dark}}
@media(prefers-color-scheme:dark){body:not([data-theme="light"]){${dark}}}
@media print{body,body[data-theme]{${light}}}
@media(forced-colors:active){body,body[data-theme]{${variables(FORCED)}}}
contact-figure .stage{${drawingRules(ROLES)}}
${roles}
${levels}
${["contact.css", "opening.css", "ladder.css", "exercise.css", "mine.css", "engines.css"].map((name) => fs.readFileSync(path.join(here, "src", name), "utf8")).join("\n")}`;
}

/** The libraries inside the page's script, with their licences. */
function notices() {
  const bundled = fs
    .readdirSync(modules)
    .flatMap((name) =>
      name.startsWith("@")
        ? fs.readdirSync(path.join(modules, name)).map((inner) => `${name}/${inner}`)
        : [name],
    )
    .filter((name) => used.has(name));
  const texts = bundled.map((name) => {
    const folder = path.join(modules, name);
    const about = JSON.parse(fs.readFileSync(path.join(folder, "package.json"), "utf8"));
    const licence = fs.readdirSync(folder).find((file) => /^licen[cs]e/i.test(file));
    const text = licence ? fs.readFileSync(path.join(folder, licence), "utf8").trim() : "";
    return `${name} ${about.version} (${about.license})\n\n${text}\n`;
  });
  return texts.join(`\n${"-".repeat(78)}\n\n`);
}

/** The scenes that the page's player offers, and the schema that they fit, as they are. */
function scenes() {
  const folder = path.join(root, "chapters", SCENES, "scenes");
  const schema = path.join(root, "chapters", SCENES, "scene.schema.json");
  const written = write(path.join(out, "scenes", "schema.json"), fs.readFileSync(schema)) ? 1 : 0;
  const files = fs.existsSync(folder) ? fs.readdirSync(folder) : [];
  const kept = files.filter((name) => name.endsWith(".json"));
  const target = path.join(out, "scenes", SCENES);
  for (const name of fs.existsSync(target) ? fs.readdirSync(target) : [])
    if (!kept.includes(name)) fs.rmSync(path.join(target, name));
  const copied = kept.filter((name) =>
    write(path.join(target, name), fs.readFileSync(path.join(folder, name))),
  );
  return written + copied.length;
}

/** One file by itself; the pages' build puts it at the site's root, so that all of the site is its own. */
async function serviceWorker() {
  const { outputFiles = [] } = await build({
    ...common,
    splitting: false,
    format: "iife",
    minify: true,
    entryPoints: [path.join(here, "src", "offline", "sw.ts")],
    outfile: path.join(out, "sw.js"),
  });
  return outputFiles.filter(({ path: file, contents }) => write(file, contents)).length > 0;
}

/** What an exercise saved as one file has in it: each script whole, because such a file can import nothing. */
async function alone() {
  const worker = (/** @type {string} */ name) => ({
    in: path.join(here, "src", "cpp", `${name}.ts`),
    out: name,
  });
  const page = (/** @type {string} */ name) => ({
    in: path.join(here, "src", "alone", `${name}.ts`),
    out: name,
  });
  const wanted = { splitting: false, outdir: path.join(out, "alone"), minify: true };
  const modules = await bundle({ ...wanted, entryPoints: ["contact", "save"].map(page) });
  const workers = ["compile-worker", "run-worker", "program-worker"].map(worker);
  return modules + (await bundle({ ...wanted, format: "iife", entryPoints: workers }));
}

/** The chapter of the scenes, and the one of them that the player begins with. */
const SCENES = "20_scenes";
const FIRST_SCENE = "billiards_break";

/** Names of packages whose code is in the bundle. @type {Set<string>} */
const used = new Set();

async function scripts() {
  const entries = [
    { in: path.join(here, "src", "contact.ts"), out: "contact" },
    { in: path.join(here, "src", "ladder-worker.ts"), out: "ladder-worker" },
    { in: path.join(here, "src", "scenes-worker.ts"), out: "scenes-worker" },
    { in: path.join(here, "src", "engines-worker.ts"), out: "engines-worker" },
    { in: path.join(here, "src", "contact-work.ts"), out: "contact-work" },
    // By a name of its own, so that a test or a benchmark can check an answer as the page does.
    { in: path.join(here, "src", "cpp", "checker.ts"), out: "checker" },
    ...["compile-worker", "run-worker", "program-worker", "mine-worker"].map((name) => ({
      in: path.join(here, "src", "cpp", `${name}.ts`),
      out: name,
    })),
    ...figures().map(({ name, source }) => ({ in: source, out: `figures/${name}` })),
  ];
  const collect = {
    name: "collect",
    /** @param {import("esbuild").PluginBuild} plugin */
    setup(plugin) {
      plugin.onEnd(({ metafile }) => {
        for (const file of Object.keys(metafile?.inputs ?? {})) {
          const match = /node_modules\/((?:@[^/]+\/)?[^/]+)\//.exec(file);
          if (match) used.add(/** @type {string} */ (match[1]));
        }
      });
    },
  };
  let written = await bundle({
    entryPoints: entries,
    outdir: out,
    chunkNames: "chunks/[name]-[hash]",
    minify: true,
    metafile: true,
    plugins: [collect],
  });
  written += await alone();
  if (await serviceWorker()) written += 1;
  written += scenes();
  const { code } = await transform(styles(), {
    loader: "css",
    minify: true,
    target: ["chrome111", "firefox113", "safari16"],
  });
  if (write(path.join(out, "contact.css"), code)) written += 1;
  if (write(path.join(out, "notices.txt"), notices())) written += 1;
  return written;
}

/** Draws the pictures whose figure or C++ changed; returns what went wrong. */
async function pictures() {
  const cache = path.join(root, "build", "web-node");
  const list = figures();
  await bundle({
    entryPoints: [
      { in: path.join(here, "src", "node", "picture.ts"), out: "picture" },
      { in: path.join(here, "src", "node", "scene-picture.ts"), out: "scene-picture" },
      ...list.map(({ name, source }) => ({ in: source, out: `figures/${name}` })),
    ],
    outdir: cache,
    outExtension: { ".js": ".mjs" },
    chunkNames: "chunks/[name]-[hash]",
    platform: "node",
    target: "node18",
  });
  const module = (/** @type {string} */ name) => path.join(cache, `${name}.mjs`);
  const { drawPicture } = await import(pathToFileURL(module("picture")).href);
  const record = path.join(cache, "pictures.json");
  /** @type {Record<string, string>} */
  const drawn = fs.existsSync(record) ? JSON.parse(fs.readFileSync(record, "utf8")) : {};
  /** @type {string[]} */
  const wrong = [];
  let count = 0;
  for (const { name } of list) {
    const target = path.join(out, "figures", name);
    if (ofBuilt && !fs.existsSync(`${target}.wasm`)) {
      for (const kind of ["svg", "json"]) fs.rmSync(`${target}.${kind}`, { force: true });
      continue;
    }
    if (!fs.existsSync(`${target}.wasm`)) {
      wrong.push(`${name}: no ${name}.wasm yet (node page/wasm/build.mjs figures makes it)`);
      continue;
    }
    const wasm = fs.readFileSync(`${target}.wasm`);
    const hash = createHash("sha256").update(wasm);
    for (const part of [module("picture"), module(`figures/${name}`)])
      hash.update(fs.readFileSync(part));
    const now = hash.digest("hex");
    const there = fs.existsSync(`${target}.svg`) && fs.existsSync(`${target}.json`);
    if (there && drawn[name] === now) continue;
    try {
      const { default: figure } = await import(pathToFileURL(module(`figures/${name}`)).href);
      const { svg, facts } = await drawPicture(figure, wasm);
      write(`${target}.svg`, svg);
      write(`${target}.json`, `${JSON.stringify(facts, null, 1)}\n`);
      drawn[name] = now;
      count += 1;
    } catch (error) {
      wrong.push(`${name}: ${error instanceof Error ? error.message : error}`);
    }
  }
  try {
    if (await scenePicture(module("scene-picture"), drawn)) count += 1;
  } catch (error) {
    wrong.push(`the scene player: ${error instanceof Error ? error.message : error}`);
  }
  write(record, JSON.stringify(drawn));
  return { wrong, count };
}

/** The picture of the scene player, if it is another one now.
 * @param {string} drawer @param {Record<string, string>} drawn what the pictures were drawn from */
async function scenePicture(drawer, drawn) {
  const text = path.join(root, "chapters", SCENES, "scenes", `${FIRST_SCENE}.json`);
  if (!fs.existsSync(text)) return false;
  const folder = path.join(out, "scenes");
  const module = path.join(folder, "player.wasm");
  if (ofBuilt && !fs.existsSync(module)) {
    for (const kind of ["svg", "json"])
      fs.rmSync(path.join(folder, `first.${kind}`), { force: true });
    return false;
  }
  if (!fs.existsSync(module))
    throw new Error("no player.wasm yet (node page/wasm/build.mjs figures makes it)");
  const wasm = fs.readFileSync(module);
  const hash = createHash("sha256").update(wasm);
  for (const part of [drawer, text]) hash.update(fs.readFileSync(part));
  const now = hash.digest("hex");
  const there = ["first.svg", "first.json"].every((name) => fs.existsSync(path.join(folder, name)));
  if (there && drawn["the scene player"] === now) return false;
  const { drawScene } = await import(pathToFileURL(drawer).href);
  const { svg, facts } = await drawScene(wasm, FIRST_SCENE, fs.readFileSync(text, "utf8"));
  write(path.join(folder, "first.svg"), svg);
  write(path.join(folder, "first.json"), `${JSON.stringify(facts, null, 1)}\n`);
  drawn["the scene player"] = now;
  return true;
}

async function main() {
  const start = performance.now();
  const written = await scripts();
  say(`${written} scripts and styles written`);
  if (!scriptsOnly) {
    const { wrong, count } = await pictures();
    say(`${count} of ${figures().length + 1} pictures drawn`);
    for (const line of wrong) console.error(line);
    if (wrong.length > 0) return 1;
  }
  say(`${((performance.now() - start) / 1000).toFixed(1)} s`);
  return 0;
}

process.exitCode = await main();
