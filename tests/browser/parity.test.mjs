// The page and the command line give the same verdict. Of a third of the exercises, another third
// in each turn, the stub, the solution and a wrong answer are checked both ways, in a real browser
// by the page's own checker and by `contact check`, and so are answers that end badly (endings/). With
// CONTACT_ALL=1 it is every exercise and every wrong answer of the book. Verdicts, points, hints and words
// are equal, numbers to 12 digits. How a program dies differs between machines (a signal, a trap,
// an abort); that it was stopped, and at which question, does not.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import fs from "node:fs";
import path from "node:path";
import { after, before, test } from "node:test";
import { wrongAnswers } from "../../page/wasm/book.mjs";
import { launch, notRun, open, root, serve } from "./browser.mjs";
import { sample, wanted } from "./sample.mjs";

/** @typedef {import("../../page/web/src/cpp/types.ts").VerdictJson} Verdict */
/** @typedef {import("../../page/web/src/cpp/types.ts").TestVerdict} TestVerdict */
/** @typedef {{ exercise: string, kind: "stub" | "solution" | "wrong" | "ending", file: string }} Answer */

const skip = notRun();

/** Below a folder, every NN_slug/NAME. @param {string} folder */
const exercisesIn = (folder) =>
  fs
    .readdirSync(path.join(root, folder))
    .sort()
    .flatMap((slug) =>
      fs
        .readdirSync(path.join(root, folder, slug))
        .sort()
        .map((name) => `${slug}/${name}`),
    );

/** @param {string} folder @returns {string[]} */
const sources = (folder) =>
  fs.existsSync(path.join(root, folder))
    ? fs
        .readdirSync(path.join(root, folder))
        .filter((name) => name.endsWith(".cpp"))
        .sort()
        .map((name) => `${folder}/${name}`)
    : [];

/** One exercise of so many is taken in a turn. */
const EACH = 3;

/** One wrong answer, another one whenever the exercise is taken. @param {string} exercise @returns {string[]} */
function wrongOf(exercise) {
  const all = wrongAnswers(exercise);
  return sample(all, all.length, "parity of wrong answers", {
    within: EACH,
    name: (file) => `${exercise}/${path.basename(file, ".cpp")}`,
  });
}

/** @returns {Answer[]} */
function answers() {
  const all = sample(exercisesIn("exercises"), EACH, "parity", { kind: "exercises" }).flatMap(
    (exercise) => {
      const file = `${exercise}/${path.basename(exercise)}.cpp`;
      return [
        { exercise, kind: /** @type {const} */ ("stub"), file: `exercises/${file}` },
        { exercise, kind: /** @type {const} */ ("solution"), file: `solutions/${file}` },
        ...wrongOf(exercise).map((wrong) => ({
          exercise,
          kind: /** @type {const} */ ("wrong"),
          file: wrong,
        })),
      ];
    },
  );
  const endings = exercisesIn("tests/browser/endings")
    .filter(wanted)
    .flatMap((exercise) =>
      sources(`tests/browser/endings/${exercise}`).map((file) => ({
        exercise,
        kind: /** @type {const} */ ("ending"),
        file,
      })),
    );
  return [...all, ...endings];
}

/** What `contact check` says of these files, in order. @param {readonly Answer[]} list @returns {Verdict[]} */
function onTheCommandLine(list) {
  let output;
  const command = path.join(root, "build", "dev", "bin", "contact");
  const args = ["check", "--json", ...list.map(({ file }) => file)];
  const options = { cwd: root, maxBuffer: 1 << 28, env: { ...process.env, CONTACT_ROOT: root } };
  try {
    output = execFileSync(command, args, options);
  } catch (error) {
    // It ends with 1 when an answer does not pass; what it says is on its standard output.
    output = /** @type {{ stdout: Buffer }} */ (error).stdout;
  }
  return JSON.parse(output.toString()).results;
}

/** Texts with their numbers apart. @param {string} text */
function taken(text) {
  const number = /[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?/g;
  return { words: text.replace(number, "#"), numbers: (text.match(number) ?? []).map(Number) };
}

/** @param {string} a @param {string} b */
function sameText(a, b) {
  const [p, q] = [taken(a), taken(b)];
  return (
    p.words === q.words &&
    p.numbers.every((x, i) => {
      const y = /** @type {number} */ (q.numbers[i]);
      if (x === 0 || y === 0) return Object.is(x, y);
      return Math.abs(x - y) <= 1e-12 * Math.max(Math.abs(x), Math.abs(y));
    })
  );
}

/** Everything in a test's verdict, in the order in which it is shown. @param {TestVerdict} verdict */
function told({ status, points, max_points, failure }) {
  const inputs = (failure?.inputs ?? []).map(({ name, text }) => `${name} = ${text}`);
  // Which machine noticed the end, and how it puts it, is the machine's.
  const reason = status === "stopped" ? "" : (failure?.reason ?? "");
  // What an exception of the standard library says is that library's.
  const got = (failure?.got ?? "").replace(/(threw std::invalid_argument: sto[a-z]+).*/, "$1");
  return [
    status,
    `${points} of ${max_points}`,
    failure?.asked ?? "",
    ...inputs,
    got,
    failure?.right ?? "",
    failure?.allowed ?? "",
    failure?.misconceptions?.join(" ") ?? "",
    failure?.hint ?? "",
    reason,
  ].join("\n");
}

/** How two verdicts differ; empty if they do not. @param {Verdict} page @param {Verdict} native */
function difference(page, native) {
  const head = (/** @type {Verdict} */ v) => `${v.verdict}, ${v.points} of ${v.max_points} points`;
  if (head(page) !== head(native)) return `${head(page)} in the page, ${head(native)} natively`;
  const names = (/** @type {Verdict} */ v) => v.tests.map(({ name }) => name).join("; ");
  if (names(page) !== names(native)) return `tests: ${names(page)} against ${names(native)}`;
  for (const [i, mine] of page.tests.entries()) {
    const theirs = /** @type {TestVerdict} */ (native.tests[i]);
    if (!sameText(told(mine), told(theirs)))
      return `${mine.name}\nin the page:\n${told(mine)}\nnatively:\n${told(theirs)}`;
  }
  return "";
}

/** @type {Awaited<ReturnType<typeof launch>>} */
let browser;
/** @type {Awaited<ReturnType<typeof serve>>} */
let server;
/** @type {Awaited<ReturnType<typeof open>>} */
let shown;

const all = skip ? [] : answers();
/** @type {Map<string, Verdict>} */
const native = new Map();

before(async () => {
  if (skip) return;
  server = await serve();
  browser = await launch();
  shown = await open(browser.browser, `${server.origin}/index.html`);
  for (const [i, verdict] of onTheCommandLine(all).entries())
    native.set(/** @type {Answer} */ (all[i]).file, verdict);
});

after(async () => {
  await browser?.close();
  server?.close();
});

/** The page's own verdict. @param {Answer} answer @returns {Promise<Verdict>} */
function inThePage({ exercise, file }) {
  const source = fs.readFileSync(path.join(root, file), "utf8");
  return shown.page.evaluate(
    async ([id, text]) => {
      const base = new URL("_static/contact/", location.href).href;
      const { Checker } = await import(`${base}checker.js`);
      const data = await (await fetch(`${base}exercises/${id}.json`)).json();
      return Checker.for(base).check(data, text, () => {});
    },
    [exercise, source],
  );
}

for (const answer of all)
  test(`${answer.kind} ${answer.file}`, { skip }, async () => {
    const page = await inThePage(answer);
    const theirs = native.get(answer.file);
    assert.ok(theirs, "the command line gives a verdict");
    assert.equal(difference(page, theirs), "");
    // What compiles without a warning there does so here.
    if (answer.kind !== "ending")
      assert.deepEqual([page.diagnostics, theirs.diagnostics], [[], []]);
  });

test("nothing went wrong on the page meanwhile", { skip }, () => {
  assert.deepEqual(shown.trouble, []);
});
