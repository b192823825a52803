// A page with nothing but the checker on it, for tests and measurements in a browser: what page/wasm/build.mjs
// made, the page's own scripts, and the data of the exercises from the repository.

import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";

const here = path.dirname(fileURLToPath(import.meta.url));
const docs = path.resolve(here, "..", "..", "..");
export const root = path.dirname(docs);

/** @typedef {import("../../src/cpp/types.ts").ExerciseData} ExerciseData */
/** @typedef {import("../../src/cpp/types.ts").VerdictJson} VerdictJson */
/** @typedef {import("../../src/cpp/types.ts").Progress & { at: number }} Told */
/** @typedef {{ verdict?: VerdictJson, error?: string, told: Told[], milliseconds: number }} Checked */

const read = (/** @type {string} */ file) => fs.readFileSync(path.join(root, file), "utf8");
const folders = (/** @type {string} */ folder) => fs.readdirSync(path.join(root, folder)).sort();

/** Why there is nothing to check with, or false. @param {string} [web] */
export function notBuilt(web = path.join(root, "build", "web")) {
  const there = fs.existsSync(path.join(web, "cpp", "manifest.json"));
  return there ? false : "not run: node page/wasm/build.mjs toolchain makes what it needs";
}

/** What the rendered page would give of an exercise. @param {string} id @returns {ExerciseData} */
export function exerciseData(id) {
  const [chapter = "", name = ""] = id.split("/");
  const names = [
    ...folders(`exercises/${id}`).map((file) => `exercises/${id}/${file}`),
    `solutions/${id}/${name}.cpp`,
  ];
  const files = Object.fromEntries(names.map((file) => [file, read(file)]));
  const about = {
    chapter,
    name,
    title: name,
    kind: "blank",
    points: 0,
    hints: [],
    misconceptions: {},
  };
  return { format: "contact-exercise/1", id, ...about, files };
}

export const exerciseIds = () =>
  folders("exercises").flatMap((slug) =>
    folders(`exercises/${slug}`).map((name) => `${slug}/${name}`),
  );

function bookData() {
  const chapters = folders("chapters").filter((slug) =>
    fs.existsSync(path.join(root, "chapters", slug, "chapter.toml")),
  );
  const names = [
    ...chapters.map((slug) => `chapters/${slug}/chapter.toml`),
    "chapters/misconceptions.toml",
  ];
  const files = Object.fromEntries(names.map((file) => [file, read(file)]));
  return { format: "contact-book/1", files, exercises: exerciseIds(), titles: {}, points: {} };
}

/**
 * Makes the folder to serve; `remove` takes it away again.
 * @param {string} [web] where page/wasm/build.mjs has put what it made
 */
export async function makePage(web = path.join(root, "build", "web")) {
  const folder = fs.mkdtempSync(path.join(os.tmpdir(), "contact-checker-"));
  const base = path.join(folder, "_static", "contact");
  fs.mkdirSync(path.join(base, "exercises"), { recursive: true });
  fs.symlinkSync(path.join(web, "cpp"), path.join(base, "cpp"));
  fs.writeFileSync(path.join(base, "exercises", "book.json"), JSON.stringify(bookData()));
  const names = ["checker", "compile-worker", "run-worker", "program-worker"];
  await build({
    entryPoints: names.map((name) => path.join(docs, "web", "src", "cpp", `${name}.ts`)),
    outdir: base,
    bundle: true,
    format: "esm",
    target: "es2022",
    minify: true,
    logLevel: "warning",
  });
  const script = `
    import { Checker } from "./_static/contact/checker.js";
    const checker = Checker.for("_static/contact/");
    const began = (name) => {
      const start = performance.now(), told = [];
      const tell = (progress) => {
        window.reached[name] = progress.step;
        told.push({ ...progress, at: performance.now() - start });
      };
      return { told, tell, since: () => performance.now() - start };
    };
    window.checker = checker;
    window.aborts = {};
    window.reached = {};
    window.check = async (data, source, { name = "", ...options } = {}) => {
      const { told, tell, since } = began(name);
      const abort = (window.aborts[name] = new AbortController());
      try {
        const verdict = await checker.check(data, source, tell, { ...options, signal: abort.signal });
        return { verdict, told, milliseconds: since() };
      } catch (error) {
        return { error: error.name + ": " + error.message, told, milliseconds: since() };
      }
    };
    window.prepare = async () => {
      const { told, tell, since } = began("prepare");
      await checker.prepare("02_triangles/ray_triangle", tell);
      return { told, milliseconds: since() };
    };
    document.body.dataset.ready = "yes";`;
  const html = `<!doctype html><meta charset="utf-8"><link rel="icon" href="data:,"><title>checker</title>
    <body><script type="module">${script}</script></body>`;
  fs.writeFileSync(path.join(folder, "index.html"), html);
  return { folder, remove: () => fs.rmSync(folder, { recursive: true, force: true }) };
}

/**
 * Checks an answer in the page.
 * @param {import("playwright-core").Page} page @param {string} id @param {string} source
 * @param {{ name?: string, seed?: string, progress?: unknown }} [options] `name`: to abort it by; `progress`: what was
 *   done before
 * @returns {Promise<Checked>}
 */
export function check(page, id, source, options = {}) {
  return page.evaluate(
    ([given, text, more]) => /** @type {any} */ (globalThis).check(given, text, more),
    /** @type {const} */ ([exerciseData(id), source, options]),
  );
}
