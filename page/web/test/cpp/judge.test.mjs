// The judge of the page says what `contact check`, `contact hint`, `contact solution` and `contact progress` say;
// and the commonest mistakes are recognised by the words of both compilers: a third of them, another third in each
// turn, and all with CONTACT_ALL=1. (The program's own words for all of them: tests/cli/test_mistakes.py.)

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { before, describe, test } from "node:test";
import { sample } from "../../../../tests/browser/sample.mjs";
import { wrongAnswers } from "../../../wasm/book.mjs";
import { PageCompiler } from "../../../wasm/page_compiler.mjs";
import { inRoot } from "../../../wasm/paths.mjs";
import { exerciseList } from "../../../wasm/products.mjs";
import { load } from "../load.mjs";

/** @typedef {import("../../src/cpp/types.ts").VerdictJson} Verdict */
/** @typedef {import("../../src/cpp/types.ts").TestResult} TestResult */

/** Every file of the book that the judge reads. @returns {Record<string, string>} */
function bookFiles() {
  /** @type {Record<string, string>} */
  const files = {};
  const take = (/** @type {string[]} */ ...parts) => {
    files[parts.join("/")] = fs.readFileSync(inRoot(...parts), "utf8");
  };
  take("chapters", "misconceptions.toml");
  for (const slug of fs.readdirSync(inRoot("chapters")))
    for (const file of ["chapter.toml", "contact/shapes.hpp"])
      if (fs.existsSync(inRoot("chapters", slug, file))) take("chapters", slug, file);
  for (const { name } of exerciseList())
    for (const file of fs.readdirSync(inRoot("exercises", name))) take("exercises", name, file);
  return files;
}

/** @type {PageCompiler} */
let compiler;
/** @type {import("../../src/cpp/judge.ts").BookJudge} */
let judge;
/** @type {typeof import("../../src/cpp/judge.ts")} */
let library;
before(async () => {
  compiler = await new PageCompiler(inRoot("build", "web", "cpp")).load();
  library = await load("cpp/judge.ts");
  judge = await library.loadJudge(await compiler.file("judge.wasm"), bookFiles());
});

const program = inRoot("build", "dev", "bin", "contact");

/** Runs `contact` with a folder of copies of its own. @param {string} work @param {string[]} words */
function contact(work, ...words) {
  assert.ok(fs.existsSync(program), "cmake --build build/dev --target contact");
  const done = spawnSync(program, words, {
    encoding: "utf8",
    maxBuffer: 1 << 28,
    env: { ...process.env, CONTACT_ROOT: inRoot(), CONTACT_WORK: work },
  });
  assert.ok(done.status === 0 || done.status === 1, `${words.join(" ")}: ${done.stderr}`);
  return done.stdout;
}

/** @template T @param {(folder: string) => T} use @returns {T} */
function inFolder(use) {
  const folder = fs.mkdtempSync(path.join(os.tmpdir(), "contact-judge-"));
  try {
    return use(folder);
  } finally {
    fs.rmSync(folder, { recursive: true, force: true });
  }
}

/** @param {string} folder */
const names = (folder) => fs.readdirSync(folder).sort();

/** The mistakes, each a file that says which it is. */
const everyMistake = ["01_planes", "02_triangles"]
  .map((slug) => inRoot("tests", "grading", "mistakes", slug))
  .filter((folder) => fs.existsSync(folder))
  .flatMap((folder) =>
    names(folder).flatMap((short) =>
      names(path.join(folder, short)).map((file) => ({
        id: `${path.basename(folder)}/${short}`,
        file: path.join(folder, short, file),
      })),
    ),
  );

const mistakes = sample(everyMistake, 3, "mistakes in the page", {
  kind: "explain",
  name: ({ id, file }) => `${id}/${path.basename(file)}`,
});

/** What the first error (or else the first warning) must be. @param {string} text */
function expected(text) {
  const lines = text.split("\n");
  const mistake = /^\/\/ mistake: (\S+)$/m.exec(text)?.[1];
  assert.ok(mistake, "the file says which mistake it is");
  const says = [...text.matchAll(/^\/\/ says: (.*)$/gm)].map((match) => String(match[1]));
  const alone = /^\/\/ alone$/m.test(text);
  return { mistake, says, alone, line: lines.findIndex((line) => line.endsWith("// here")) + 1 };
}

/** @param {Verdict} verdict @param {string} text @param {string} whose */
function recognised(verdict, text, whose) {
  const { mistake, says, alone, line } = expected(text);
  const diagnostics = verdict.diagnostics ?? [];
  const first = diagnostics.find(({ severity }) => severity === "error") ?? diagnostics[0];
  const all = `${whose}: ${JSON.stringify(diagnostics, null, 1)}`;
  assert.equal(first?.mistake, mistake, all);
  for (const part of says) assert.ok(first?.words.includes(part), `"${part}" is not in ${all}`);
  assert.match(first?.words ?? "", /[.?]$|\.\.\.$/, all);
  if (line > 0) assert.equal(first?.line, line, all);
  if (alone) assert.equal(diagnostics.length, 1, all);
  if (verdict.compile_error) {
    assert.equal(verdict.verdict, "does_not_compile");
    assert.equal(verdict.compile_error.explanation.startsWith(first?.words ?? "?"), true, all);
  }
}

/** @param {string} id @param {string} text @returns {Promise<Verdict>} */
async function inPage(id, text) {
  const contract = fs.readFileSync(inRoot("exercises", id, `${path.basename(id)}.hpp`), "utf8");
  const built = await compiler.build(id, contract, text);
  const { log } = built;
  if (!built.ok) return judge.uncompiled(id, { step: built.step, log, source: text });
  return judge.judge(id, [], { source: text, log });
}

describe("every mistake is recognised, in the page and by the program", () => {
  /** @type {Map<string, Verdict>} */
  const native = new Map();
  before(async () => {
    inFolder((work) => {
      const files = mistakes.map(({ file }) => file);
      const { results } = JSON.parse(contact(work, "check", "--json", ...files));
      for (const result of results) native.set(result.file, result);
    });
  });
  for (const { id, file } of mistakes) {
    test(`${path.basename(id)}/${path.basename(file)}`, async () => {
      const text = fs.readFileSync(file, "utf8");
      const theirs = /** @type {Verdict} */ (native.get(file));
      recognised(theirs, text, "the program");
      const mine = await inPage(id, text);
      recognised(mine, text, "the page");
      // What only warns is run, and has results in the program alone.
      if (theirs.verdict === "does_not_compile") assert.equal(mine.verdict, theirs.verdict);
    });
  }
});

test("a test that did not run, one without points and one that is not listed", () => {
  const verdict = judge.judge("02_triangles/ray_triangle", [
    { name: "not listed", status: "passed", seconds: 0 },
  ]);
  assert.equal(verdict.verdict, "failed");
  assert.equal(verdict.points, 0);
  for (const { status, failure } of verdict.tests) {
    assert.equal(status, "stopped");
    assert.equal(failure?.reason, "this test did not run");
  }
});

describe("the record of progress is the program's", () => {
  /** @param {any} record the times are those of the clock */
  const timeless = (record) =>
    JSON.parse(JSON.stringify(record), (name, value) =>
      ["passed", "last_checked", "write"].includes(name) &&
      typeof value === "string" &&
      value !== ""
        ? "then"
        : value,
    );

  test("checks, hints and a solution shown", () => {
    const id = "02_triangles/ray_triangle";
    const wrong = (/** @type {string} */ name) =>
      String(wrongAnswers(id).find((file) => path.basename(file, ".cpp") === name));
    const solution = `solutions/${id}/ray_triangle.cpp`;
    const steps = [wrong("one_sided"), solution, wrong("beta_sign")];
    inFolder((work) => {
      const copy = path.join(work, `${id}.cpp`);
      fs.mkdirSync(path.dirname(copy), { recursive: true });
      // To view the solution before passing is to give up; afterwards it has no effect.
      contact(work, "hint", id);
      contact(work, "hint", id);
      contact(work, "solution", id, "--give-up");
      let record = judge.recordHint(judge.recordHint(judge.emptyProgress(), id), id);
      record = judge.recordSolutionShown(record, id);
      for (const step of steps) {
        fs.copyFileSync(inRoot(step), copy);
        const [verdict] = JSON.parse(contact(work, "check", "--json", id)).results;
        record = judge.record(record, verdict, "2026-11-21T08:00:00Z");
      }
      fs.writeFileSync(copy, "this is no C++");
      const [broken] = JSON.parse(contact(work, "check", "--json", id)).results;
      assert.equal(broken.verdict, "does_not_compile");
      assert.equal(judge.record(record, broken, "2026-11-21T09:00:00Z").exercises[id].attempts, 3);
      const theirs = JSON.parse(fs.readFileSync(path.join(work, "progress.json"), "utf8"));
      assert.deepEqual(timeless(record), timeless(theirs));
      assert.equal(/** @type {any} */ (record.exercises)[id].passed, "2026-11-21T08:00:00Z");
      const report = JSON.parse(contact(work, "progress", "--json"));
      assert.deepEqual(judge.report(/** @type {any} */ (theirs)), report);
      assert.equal(report.total.passed, 1);
    });
  });

  test("what a newer version wrote stays", () => {
    const record = {
      format: "contact-progress/1",
      later: { kept: true },
      exercises: { "99_none/none": { attempts: 2, more: [1] } },
    };
    const after = judge.recordHint(/** @type {any} */ (record), "02_triangles/ray_triangle");
    assert.deepEqual(/** @type {any} */ (after).later, record.later);
    assert.deepEqual(after.exercises["99_none/none"], record.exercises["99_none/none"]);
  });

  test("what is no record is refused, and the judge goes on", () => {
    for (const broken of [null, [], { format: "contact-progress/2", exercises: {} }])
      assert.throws(
        () => judge.recordHint(/** @type {any} */ (broken), "02_triangles/ray_triangle"),
        library.JudgeError,
      );
    assert.throws(() => judge.judge("02_triangles/ray_triangel", []), /Did you mean/);
    assert.deepEqual(judge.problems(), []);
  });
});

test("a broken file of the book is reported", async () => {
  const files = bookFiles();
  files["exercises/02_triangles/ray_triangle/exercise.toml"] = 'title = "no end\n';
  const broken = await library.loadJudge(await compiler.file("judge.wasm"), files);
  assert.match(broken.problems().join(), /ray_triangle\/exercise\.toml:1: /);
  assert.throws(() => broken.judge("02_triangles/ray_triangle", []), library.JudgeError);
});

test("the module is small", () => {
  const { transfer } = /** @type {{ transfer: number }} */ (compiler.manifest.files["judge.wasm"]);
  assert.ok(transfer < 190_000, `${transfer} bytes compressed`);
});
