// node page/engines/record.mjs [--only QUESTION]... [--engine ID]...
//
// Asks the book and all engines every question, with default settings and with the best of those that are tried, and
// writes page/engines/recorded.json: versions, date, answers, errors, times. With --only or --engine the other answers
// stay as they are; `--engine none` writes only what is said of engines and questions. Exit code 2: wrong usage.
import fs from "node:fs";
import os from "node:os";
import { parseArgs } from "node:util";
import { gzipSync } from "node:zlib";
import { build } from "esbuild";
import { inRoot } from "../wasm/paths.mjs";
import { loadAll, recordFile, written } from "./engines.mjs";

/** @param {import("../web/src/engines/types.ts").Answer} answer */
const shown = ({ value, error, time, failed }) => ({
  value: written(value),
  error: written(error),
  ms: Number(time.toPrecision(3)),
  ...(failed && { failed }),
});

/** @returns {{ only: string[], engine: string[] }} */
function options() {
  try {
    const { values } = parseArgs({
      options: {
        only: { type: "string", multiple: true, default: [] },
        engine: { type: "string", multiple: true, default: [] },
      },
    });
    return /** @type {{ only: string[], engine: string[] }} */ (values);
  } catch (error) {
    console.error(`${error instanceof Error ? error.message : error}`);
    console.error("usage: node page/engines/record.mjs [--only QUESTION]... [--engine ID]...");
    process.exit(2);
  }
}

/** What a browser downloads for one engine, compressed. @param {string} id @returns {Promise<number>} bytes */
async function download(id) {
  const { outputFiles = [] } = await build({
    entryPoints: [inRoot("page", "web", "src", "engines", "adapters", `${id}.ts`)],
    bundle: true,
    format: "esm",
    minify: true,
    write: false,
    external: ["module", "node:*", "fs", "path", "url", "worker_threads"],
    alias: { three: inRoot("page", "node_modules", "three", "src", "Three.Core.js") },
    loader: { ".wasm": "binary" },
    logLevel: "error",
  });
  return outputFiles.reduce(
    (sum, { contents }) => sum + gzipSync(contents, { level: 9 }).length,
    0,
  );
}

/** What the page says of an engine. @param {import("./engines.mjs").Adapter} adapter */
async function about(adapter) {
  const { load: _, id, ...facts } = adapter;
  return { id, ...facts, ...(id !== "book" && { bytes: await download(id) }) };
}

const { only, engine: engines } = options();
const { library, asked } = await loadAll();
const { QUESTIONS, ask, best, defaultsOf } = library;
const chosenAny = () =>
  asked.some(({ adapter }) => engines.length === 0 || engines.includes(adapter.id));
const before = fs.existsSync(recordFile) ? JSON.parse(fs.readFileSync(recordFile, "utf8")) : {};
/** @type {Record<string, Record<string, unknown>>} */
const answers = {};
for (const question of QUESTIONS) {
  /** @type {Record<string, unknown>} */
  const row = {};
  for (const { adapter, engine } of asked) {
    const { id } = adapter;
    const chosen =
      (only.length === 0 || only.includes(question.id)) &&
      (engines.length === 0 || engines.includes(id));
    const old = before.answers?.[question.id]?.[id];
    if (!chosen) {
      if (old) row[id] = old;
      continue;
    }
    // The first run compiles the code of the engine, and is not what a reader's tenth run takes.
    const first = ask(question, adapter, engine, defaultsOf(adapter));
    if (!first) continue;
    const answer = first.time < 2000 ? ask(question, adapter, engine, defaultsOf(adapter)) : first;
    const tuned = id === "book" ? undefined : best(question, adapter, engine);
    row[id] = {
      ...shown(answer ?? first),
      ...(tuned && { best: { ...shown(tuned.answer), settings: tuned.settings } }),
    };
    console.error(`${question.id} ${id} ${(answer ?? first).error}`);
  }
  answers[question.id] = row;
}
const record = {
  date: chosenAny() ? new Date().toISOString().slice(0, 10) : before.date,
  node: process.version,
  processor: os.cpus()[0]?.model ?? "unknown",
  engines: await Promise.all(asked.map(({ adapter }) => about(adapter))),
  questions: QUESTIONS.map(({ ask: _, ...facts }) => facts),
  answers,
};
fs.writeFileSync(recordFile, `${JSON.stringify(record, null, 2)}\n`);
// Some engines leave a worker or a timer.
process.exit(0);
