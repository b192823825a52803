// The commonest mistakes of beginners, each made in the page: the compiler's message comes in words
// for a beginner, at its line, marked in the editor, with the compiler's own words one click away.
// The mistakes are those of the judge's own tests (tests/grading/mistakes); a third of them in each turn.

import assert from "node:assert/strict";
import fs from "node:fs";
import path from "node:path";
import { before, describe, test } from "node:test";
import { notRun, root } from "./browser.mjs";
import { exerciseOn, lineOf, pageOf, visit } from "./exercise_page.mjs";
import { inBrowser } from "./in_browser.mjs";
import { sample } from "./sample.mjs";

const skip = notRun();
const exerciseId = "02_triangles/ray_triangle";
const commonest = [
  "missing_semicolon",
  "misspelt_name",
  "missing_std",
  "missing_namespace_contact",
  "missing_parenthesis",
  "missing_return",
  "wrong_type_returned",
  "no_such_member",
  "too_few_arguments",
  "assigned_to_a_const",
  "assignment_in_a_condition",
];

/** A mistake's code, and what must be said of it. @param {string} name */
function mistake(name) {
  const file = path.join(root, "tests", "grading", "mistakes", exerciseId, `${name}.cpp`);
  const code = fs.readFileSync(file, "utf8");
  const says = [...code.matchAll(/^\/\/ says: (.*)$/gm)].map(([, words = ""]) => words);
  assert.ok(says.length > 0, file);
  // What is missing at the end of a function is said at its last brace.
  const place = code.includes("// here") ? "// here" : "}\n\n}  // namespace exercise";
  return { code, says, line: lineOf(code, place) };
}

describe("the commonest mistakes", { skip }, () => {
  const { server, chromium } = inBrowser();
  /** @type {ReturnType<typeof exerciseOn>} */
  let exercise;
  /** @type {string[]} */
  let trouble;
  before(async () => {
    const context = await chromium.browser.newContext({
      viewport: { width: 1200, height: 900 },
      permissions: ["clipboard-read", "clipboard-write"],
    });
    const visited = await visit(context, server.origin, pageOf(exerciseId));
    trouble = visited.trouble;
    exercise = exerciseOn(visited.page, exerciseId);
  });

  for (const name of sample(commonest, 3, "mistakes in an exercise", { kind: "explain" }))
    test(`${name.replaceAll("_", " ")}: in words, at its line`, async () => {
      const { code, says, line } = mistake(name);
      await exercise.submit(code);
      const [first] = await exercise.messages();
      assert.ok(first, "nothing is said");
      for (const part of says) assert.ok(first.words.includes(part), `${first.words}: no ${part}`);
      assert.ok(
        new RegExp(`\\b${line}\\b`).test(first.place),
        `${first.place} is not line ${line}`,
      );
      const [mark] = await exercise.marks();
      assert.equal(mark?.line, line);
      // The compiler's own message is there, folded, and is not what the beginner is given.
      assert.equal(first.open, false);
      const own = first.original.match(/(?:error|warning): (.*)/)?.[1];
      assert.ok(own, first.original);
      assert.ok(!first.words.includes(own), first.words);
    });

  test("nothing went wrong in the console", () => assert.deepEqual(trouble, []));
});
