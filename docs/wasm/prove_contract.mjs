// node docs/wasm/prove_contract.mjs [NN_slug/NAME ... | --all] [--native build/dev/exercises.json]
//
// Proves that an exercise's unchanged tests serve in the page: the stub, the solution and every wrong answer are
// compiled to WebAssembly, run in Node, and get what the native program gives them, test by test: verdict, misconception,
// points, and the words of the failure (numbers to 12 digits). Exit code 0: all agree; 1: some do not; 3: something
// that is needed is not built.
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { parseArgs } from "node:util";
import { check } from "./check.mjs";
import { descriptionFile, nativeCheck, nativeProgram, readDescription } from "./native_check.mjs";
import { inRoot, shown } from "./paths.mjs";
import { makeAll } from "./pool.mjs";
import { checkProgram, exerciseList } from "./products.mjs";
import { key, made } from "./recipes.mjs";

/** @typedef {import('./check.mjs').Verdict} Verdict */
/** @typedef {{ name: string, points: number }} Test */
/** @typedef {{ kind: 'stub' | 'solution' | 'wrong', file: string, misconception?: string, caughtBy?: string }} Answer */

/** The tests of an exercise with their points, from its exercise.toml, in order.
 * @param {string} exercise @returns {Test[]} */
function testsOf(exercise) {
  const toml = fs.readFileSync(inRoot("exercises", exercise, "exercise.toml"), "utf8");
  return toml
    .split(/^\[\[tests\]\]\s*$/m)
    .slice(1)
    .map((part) => {
      const name = /^name *= *("(?:[^"\\]|\\.)*")/m.exec(part)?.[1];
      const points = /^points *= *(\d+)/m.exec(part)?.[1];
      if (name === undefined || points === undefined)
        throw new Error(`exercises/${exercise}/exercise.toml: a test without a name or points`);
      return { name: JSON.parse(name), points: Number(points) };
    });
}

/** @param {string} exercise @returns {Answer[]} */
function answersOf(exercise) {
  const short = path.basename(exercise);
  const wrongs = inRoot("solutions", exercise, "wrong");
  const wrongFiles = fs.existsSync(wrongs) ? fs.readdirSync(wrongs).sort() : [];
  return [
    { kind: "stub", file: inRoot("exercises", exercise, `${short}.cpp`) },
    { kind: "solution", file: inRoot("solutions", exercise, `${short}.cpp`) },
    ...wrongFiles
      .filter((file) => file.endsWith(".cpp"))
      .map((name) => {
        const file = path.join(wrongs, name);
        const text = fs.readFileSync(file, "utf8");
        const misconception = /^\/\/ misconception: *(\S+)/m.exec(text)?.[1];
        const caughtBy = /^\/\/ caught by: *(.+?) *$/m.exec(text)?.[1];
        if (misconception === undefined || caughtBy === undefined)
          throw new Error(`${shown(file)} does not say its misconception and what it is caught by`);
        return { kind: /** @type {const} */ ("wrong"), file, misconception, caughtBy };
      }),
  ];
}

/** The same words, and the same numbers to 12 digits. @param {string} a @param {string} b */
function sameText(a, b) {
  const number = /[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?/g;
  if (a.replace(number, "#") !== b.replace(number, "#")) return false;
  const theirs = b.match(number) ?? [];
  return (a.match(number) ?? []).every((text, i) => {
    const x = Number(text),
      y = Number(theirs[i]);
    return x === y || Math.abs(x - y) <= 1e-12 * Math.max(Math.abs(x), Math.abs(y));
  });
}

/** What differs between the two verdicts on one test; empty if nothing does.
 * @param {Verdict} page @param {Verdict} native */
function difference(page, native) {
  if (page.status !== native.status) return `${page.status} in the page, ${native.status} natively`;
  if (page.status === "stopped") return ""; // how a program dies differs; that it dies does not
  const a = page.failure,
    b = native.failure;
  if (a?.misconception !== b?.misconception)
    return `misconception ${a?.misconception ?? "none"} in the page, ${b?.misconception ?? "none"} natively`;
  /** @param {typeof a} failure */
  const words = (failure) =>
    failure === undefined
      ? ""
      : [
          failure.asked,
          failure.got,
          failure.right,
          failure.allowed ?? "",
          ...failure.inputs.map(({ name, text }) => `${name} = ${text}`),
        ].join("\n");
  return sameText(words(a), words(b)) ? "" : `in the page:\n${words(a)}\nnatively:\n${words(b)}`;
}

/** What an answer must get, whoever checks it. @param {Answer} answer @param {Verdict[]} verdicts */
function unmet(answer, verdicts) {
  const all = (/** @type {Verdict['status']} */ status) =>
    verdicts.every((verdict) => verdict.status === status);
  if (answer.kind === "stub")
    return all("not_attempted") ? "" : 'the stub is not "not attempted" throughout';
  if (answer.kind === "solution")
    return all("passed") ? "" : "the solution does not pass every test";
  const caught = verdicts.find(({ test }) => test === answer.caughtBy);
  if (caught?.status !== "failed") return `"${answer.caughtBy}" does not catch it`;
  const seen = caught.failure?.misconception ?? "none";
  return seen === answer.misconception ? "" : `recognised as ${seen}, not ${answer.misconception}`;
}

async function main() {
  const { values, positionals } = parseArgs({
    allowPositionals: true,
    options: {
      all: { type: "boolean", default: false },
      native: { type: "string", default: descriptionFile },
    },
  });
  const known = exerciseList();
  const chosen =
    positionals.length === 0
      ? known
      : positionals.map((name) => {
          const found = known.find((exercise) => exercise.name === name);
          if (!found) throw new Error(`there is no exercise ${name} with tests`);
          return found;
        });
  const build = readDescription(path.resolve(/** @type {string} */ (values.native)));
  let passed = 0;
  let failed = 0;
  const judge = (/** @type {string} */ what, /** @type {string} */ problem) => {
    if (problem === "") ++passed;
    else {
      ++failed;
      console.log(`FAILED  ${what}: ${problem}`);
    }
  };

  const jobs = chosen.flatMap((exercise) =>
    answersOf(exercise.name).map((answer) => ({
      exercise,
      answer,
      tests: testsOf(exercise.name),
      recipe: checkProgram(exercise, answer.file),
    })),
  );
  const start = performance.now();
  const { failed: broken } = await makeAll(
    jobs.map(({ recipe }) => recipe),
    {
      onDone: ({ recipe, ok, seconds }, left) => {
        if (process.stderr.isTTY || !ok || seconds > 5)
          console.error(
            `${ok ? "made  " : "FAILED"} ${recipe.what}  ${seconds.toFixed(1)} s, ${left} left`,
          );
      },
    },
  );
  const compiled = performance.now();

  const folder = fs.mkdtempSync(path.join(os.tmpdir(), "contact-prove-"));
  let inPage = 0;
  try {
    for (const { exercise, answer, tests, recipe } of jobs) {
      const what = shown(answer.file);
      const why = broken.get(key(recipe));
      if (why !== undefined) {
        judge(what, why);
        continue;
      }
      const names = tests.map(({ name }) => name);
      const begin = performance.now();
      const page = await check(made(key(recipe)), names);
      inPage += performance.now() - begin;
      const program = await nativeProgram(build, exercise.name, answer.file, folder);
      const native = await nativeCheck(program, names, folder);
      for (const [i, name] of names.entries()) {
        const [mine, theirs] = [page[i], native[i]];
        if (!mine || !theirs) throw new Error(`no verdict on ${name}`);
        judge(`${what}: ${name}`, difference(mine, theirs));
      }
      judge(what, unmet(answer, page));
      const points = (/** @type {Verdict[]} */ verdicts) =>
        tests.reduce(
          (sum, test, i) => sum + (verdicts[i]?.status === "passed" ? test.points : 0),
          0,
        );
      const [mine, theirs] = [points(page), points(native)];
      judge(`${what}: points`, mine === theirs ? "" : `${mine} in the page, ${theirs} natively`);
      const count = (/** @type {string} */ status) =>
        page.filter((verdict) => verdict.status === status).length;
      console.log(
        `${what}: ${count("passed")} of ${names.length} tests pass, ` +
          `${mine} of ${points(names.map((test) => ({ test, status: "passed" })))} points`,
      );
    }
  } finally {
    fs.rmSync(folder, { recursive: true, force: true });
  }
  const of = (/** @type {Answer['kind']} */ kind) =>
    jobs.filter(({ answer }) => answer.kind === kind).length;
  console.log(
    `${chosen.length} exercises, ${of("stub")} stubs, ${of("solution")} solutions, ` +
      `${of("wrong")} wrong answers, in WebAssembly and natively; ` +
      `compiled in ${((compiled - start) / 1000).toFixed(1)} s, ${(inPage / jobs.length / 1000).toFixed(2)} s a run in WebAssembly`,
  );
  console.log(`${passed} passed, ${failed} failed`);
  return failed === 0 ? 0 : 1;
}

try {
  process.exitCode = await main();
} catch (error) {
  console.error(/** @type {Error} */ (error).message);
  process.exitCode = 3;
}
