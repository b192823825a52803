// node benchmarks/page_check.mjs [--repeats 20] [--cold 3] [--json FILE]
//
// Measures the cost of checking ray_triangle in the page, in bytes and in seconds, in headless Chromium with a fresh
// profile each time, served from this machine; alternating with it, `contact check` of the same file. It needs what
// `page/wasm/build.mjs toolchain` and `cmake --build build/dev` make. Exit code 1 if a wish is not met:
//
//   a first check at most 3 s after the download, a warm one at most 0.8 s, a first check after at most 30 MB
//
// "After the download" counts from the last byte that the check waits for until its verdict.

import { spawnSync } from "node:child_process";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { parseArgs } from "node:util";
import { check, makePage, notBuilt, root } from "../page/web/test/cpp/checker_page.mjs";
import {
  findBrowser,
  flags,
  launch,
  notRun,
  open,
  require,
  serve,
} from "../tests/browser/browser.mjs";

/** @typedef {import("../page/web/test/cpp/checker_page.mjs").Checked} Checked */
/** @typedef {{ median: number, q1: number, q3: number, least: number, runs: number }} Spread */

const wishes = { first: 3, warm: 0.8, bytes: 30e6 };
const id = "02_triangles/ray_triangle";
const solution = fs.readFileSync(path.join(root, "solutions", id, "ray_triangle.cpp"), "utf8");

const { values } = parseArgs({
  options: {
    repeats: { type: "string", default: "20" },
    cold: { type: "string", default: "3" },
    json: { type: "string" },
  },
});
const repeats = Number(values.repeats);
const colds = Number(values.cold);

const why = notRun() || notBuilt();
if (why) {
  console.error(why);
  process.exit(2);
}

let turns = 0;
/** Each run changes a comment, so that no two files are the same. */
const edited = () => {
  turns += 1;
  return `${solution}\n// edit ${turns}\n`;
};

/** @param {number[]} numbers @param {number} quantile, from 0 to 1 */
function at(numbers, part) {
  const sorted = [...numbers].sort((a, b) => a - b);
  const place = part * (sorted.length - 1);
  const low = Math.floor(place);
  const [a = 0, b = a] = [sorted[low], sorted[low + 1]];
  return a + (place - low) * (b - a);
}

/** @param {number[]} numbers @returns {Spread} */
const spread = (numbers) => ({
  median: at(numbers, 0.5),
  q1: at(numbers, 0.25),
  q3: at(numbers, 0.75),
  least: Math.min(...numbers),
  runs: numbers.length,
});

/** @param {Checked} result */
function passed(result) {
  if (result.verdict?.verdict !== "passed")
    throw new Error(
      `the solution does not pass: ${result.error ?? JSON.stringify(result.verdict)}`,
    );
  return result;
}

/** What a check took, in seconds; `ready` and `after` count from the last byte.
 * @param {Checked} result */
function times(result) {
  const { told, milliseconds, verdict } = passed(result);
  const downloaded = told.filter(({ step }) => step === "download").at(-1)?.at ?? 0;
  const compiling = told.find(({ step }) => step === "compile")?.at ?? 0;
  const { compile, link, run } = /** @type {NonNullable<typeof verdict>} */ (verdict).seconds;
  const all = milliseconds / 1000;
  return {
    all,
    download: downloaded / 1000,
    ready: (compiling - downloaded) / 1000,
    after: all - downloaded / 1000,
    compile,
    link,
    run,
    rest: all - compiling / 1000 - compile - link - run,
  };
}

const folder = await makePage();
const server = await serve(folder.folder);
const address = `${server.origin}/index.html`;
const manifest = JSON.parse(
  fs.readFileSync(path.join(root, "build", "web", "cpp", "manifest.json"), "utf8"),
);

/** @param {import("playwright-core").Page} page */
const opened = (page) => page.waitForFunction("document.body.dataset.ready");

/** Without the precompiled header, as on a line on which it is not here yet. @param {boolean} without */
function withoutPrelude(without) {
  delete server.answer;
  if (!without) return;
  const { "prelude.pch": _, ...files } = manifest.files;
  server.answer = (pathname, response) => {
    if (!pathname.endsWith("/manifest.json")) return false;
    response.end(JSON.stringify({ ...manifest, files, behind: [] }));
    return true;
  };
}

/** First checks, each in a browser that has never seen the page. @param {boolean} without the precompiled header */
async function firstChecks(without) {
  withoutPrelude(without);
  /** @type {ReturnType<typeof times>[]} */
  const found = [];
  for (let turn = 0; turn < colds; ++turn) {
    const { browser, close } = await launch();
    const { page, close: leave } = await open(browser, address);
    await opened(page);
    found.push(times(await check(page, id, edited())));
    await leave();
    await close();
  }
  withoutPrelude(false);
  return found;
}

/** First checks after the browser was closed and opened again: everything is in its cache. */
async function checksFromCache() {
  const { chromium } = require("playwright-core");
  const profile = fs.mkdtempSync(path.join(os.tmpdir(), "contact-profile-"));
  const start = async () => {
    const context = await chromium.launchPersistentContext(profile, {
      executablePath: findBrowser(),
      headless: true,
      args: flags,
    });
    const page = await context.newPage();
    await page.goto(address);
    await opened(page);
    return { context, page };
  };
  const found = [];
  try {
    for (let turn = 0; turn <= colds; ++turn) {
      const { context, page } = await start();
      const result = times(await check(page, id, edited()));
      if (turn > 0) found.push(result);
      else
        await page.waitForFunction(
          "checker.size().then(({ core, behind }) => core + behind === 0)",
        );
      await context.close();
    }
  } finally {
    fs.rmSync(profile, { recursive: true, force: true });
  }
  return found;
}

/** Megabytes that belong to the page's own process, shared ones in part; undefined where /proc does not say.
 * @param {import("playwright-core").Browser} browser */
async function memory(browser) {
  const session = await browser.newBrowserCDPSession();
  const { processInfo } = await session.send("SystemInfo.getProcessInfo");
  const sizes = processInfo
    .filter(({ type }) => type === "renderer")
    .map((process) => `/proc/${process.id}/smaps_rollup`)
    .filter((file) => fs.existsSync(file))
    .map((file) => Number(/^Pss: *(\d+) kB/m.exec(fs.readFileSync(file, "utf8"))?.[1]) / 1000);
  return sizes.length > 0 ? Math.max(...sizes) : undefined;
}

const native = path.join(root, "build", "dev", "bin", "contact");
const scratch = fs.mkdtempSync(path.join(os.tmpdir(), "contact-native-"));

/** `contact check` of the same text, in seconds. @param {string} text */
function nativeCheck(text) {
  const file = path.join(scratch, "ray_triangle.cpp");
  fs.writeFileSync(file, text);
  const environment = {
    ...process.env,
    CONTACT_ROOT: root,
    CONTACT_WORK: path.join(scratch, "work"),
  };
  const began = performance.now();
  const { status, stdout, stderr, error } = spawnSync(native, ["check", file], {
    env: environment,
    encoding: "utf8",
  });
  const seconds = (performance.now() - began) / 1000;
  if (error) throw error;
  if (status !== 0) throw new Error(`contact check failed:\n${stdout}${stderr}`);
  return seconds;
}

/** Warm checks, each followed by a native one, so that a busy moment counts on both sides. */
async function warmChecks() {
  const { browser, close } = await launch();
  const { page, close: leave } = await open(browser, address);
  await opened(page);
  const prepared = await page.evaluate("prepare()");
  const firstAfterReady = times(await check(page, id, edited()));
  for (let turn = 0; turn < 3; ++turn) passed(await check(page, id, edited()));
  const compares = fs.existsSync(native);
  if (compares) nativeCheck(edited());
  const found = [];
  /** @type {number[]} */
  const natives = [];
  for (let turn = 0; turn < repeats; ++turn) {
    found.push(times(await check(page, id, edited())));
    if (compares) natives.push(nativeCheck(edited()));
  }
  const megabytes = await memory(browser);
  await leave();
  await close();
  return { prepared: prepared.milliseconds / 1000, firstAfterReady, found, natives, megabytes };
}

/** The page with the exercise before anything is pressed, in bytes, if the book is built. */
function pageWeight() {
  const weigh = path.join(root, "page", "web", "weight.mjs");
  const { status, stdout } = spawnSync(process.execPath, [weigh, "chapters/02_triangles.html"], {
    encoding: "utf8",
  });
  const found = /together +([\d.]+) kB/.exec(stdout);
  return status === 0 && found ? Number(found[1]) * 1000 : undefined;
}

const weigh = (/** @type {string[]} */ keys) =>
  keys.reduce((sum, key) => sum + manifest.files[key].transfer, 0);
const bytes = {
  page: pageWeight(),
  core: weigh(manifest.core),
  behind: weigh(manifest.behind),
  exercise: manifest.exercises[id].transfer,
  judge: manifest.files["judge.wasm"]?.transfer,
};

let result;
try {
  const first = await firstChecks(false);
  const without = await firstChecks(true);
  const cached = await checksFromCache();
  const warm = await warmChecks();
  /** @param {ReturnType<typeof times>[]} list */
  const summary = (list) =>
    Object.fromEntries(
      Object.keys(list[0] ?? {}).map((name) => [
        name,
        spread(list.map((one) => one[/** @type {keyof typeof one} */ (name)])),
      ]),
    );
  const ratio = warm.natives.length
    ? at(
        warm.found.map(({ all }, i) => all / /** @type {number} */ (warm.natives[i])),
        0.5,
      )
    : undefined;
  result = {
    machine: {
      processors: os.cpus().length,
      model: os.cpus()[0]?.model,
      load: os.loadavg()[0],
      node: process.version,
    },
    bytes,
    seconds: {
      first: summary(first),
      firstWithoutPrelude: summary(without),
      fromCache: summary(cached),
      prepare: warm.prepared,
      firstAfterPrepare: warm.firstAfterReady,
      warm: summary(warm.found),
      native: warm.natives.length ? spread(warm.natives) : undefined,
      ratio,
    },
    megabytes: warm.megabytes,
  };
} finally {
  server.close();
  folder.remove();
  fs.rmSync(scratch, { recursive: true, force: true });
}

const kilo = (/** @type {number | undefined} */ count) =>
  count === undefined ? "not built" : `${(count / 1000).toFixed(0)} kB`;
console.log("Bytes, compressed");
for (const [name, count] of [
  ["the page, before anything is pressed", bytes.page],
  ["a first check: compiler, headers, libraries, judge", bytes.core],
  ["  of it the judge", bytes.judge],
  ["behind the reader's back: the precompiled header", bytes.behind],
  ["the exercise's tests", bytes.exercise],
])
  console.log(`  ${String(name).padEnd(52)}${kilo(/** @type {number} */ (count)).padStart(12)}`);

const { seconds } = result;
console.log("\nSeconds: median (quartiles), runs");
/** @param {string} name @param {Spread | undefined} s */
const line = (name, s) =>
  s &&
  console.log(
    `  ${name.padEnd(52)}${s.median.toFixed(2).padStart(6)}  (${s.q1.toFixed(2)} - ${s.q3.toFixed(2)})  ${s.runs}`,
  );
line("first check, after the download", seconds.first["after"]);
line("  of it until the compiler is ready", seconds.first["ready"]);
line("first check without the precompiled header", seconds.firstWithoutPrelude["after"]);
line("first check from the browser's cache, all of it", seconds.fromCache["all"]);
console.log(
  `  ${"first check after “get ready”".padEnd(52)}${seconds.firstAfterPrepare.all.toFixed(2).padStart(6)}`,
);
line("warm check", seconds.warm["all"]);
for (const part of ["compile", "link", "run", "rest"])
  line(`  ${part === "rest" ? "judge, messages" : part}`, seconds.warm[part]);
line("contact check, natively", seconds.native);
if (seconds.ratio)
  console.log(`  the page takes ${seconds.ratio.toFixed(2)} times as long (median of pairs)`);
if (result.megabytes)
  console.log(`\nMemory of the page's process: ${result.megabytes.toFixed(0)} MB`);
console.log(
  `Load of the machine: ${result.machine.load?.toFixed(1)} on ${result.machine.processors} processors`,
);

if (values.json) fs.writeFileSync(values.json, `${JSON.stringify(result, null, 1)}\n`);
const missed = [
  (seconds.first["after"]?.median ?? 0) > wishes.first &&
    `a first check takes more than ${wishes.first} s`,
  (seconds.warm["all"]?.median ?? 0) > wishes.warm &&
    `a warm check takes more than ${wishes.warm} s`,
  bytes.core + bytes.exercise > wishes.bytes &&
    `a first check needs more than ${wishes.bytes / 1e6} MB`,
].filter(Boolean);
for (const text of missed) console.error(text);
process.exitCode = missed.length > 0 ? 1 : 0;
