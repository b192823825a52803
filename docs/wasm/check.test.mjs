// A student's answer can end in many ways; each is told of the test where it happened, and the rest still run.
import assert from "node:assert/strict";
import { test } from "node:test";
import { check } from "./check.mjs";
import { inRoot } from "./paths.mjs";
import { makeAll } from "./pool.mjs";
import { checkProgram } from "./products.mjs";
import { key, made } from "./recipes.mjs";

const fixtures = inRoot("docs", "wasm", "fixtures");
const ends = {
  name: "fixtures/ends",
  slug: "00_vectors",
  folder: fixtures,
  test: `${fixtures}/ends_test.cpp`,
};

/** @type {[string, import("./test_program.mjs").Status, RegExp?][]} */
const expected = [
  ['right, "quoted" and [in brackets]', "passed"],
  ["~abort", "stopped", /ended itself.*on its last legs/s],
  ["a*sterisk", "passed"],
  ["loop", "stopped", /longer than 1 s/],
  ["back\\slash", "passed"],
  ["recursion", "stopped", /stack overflow|not its own/],
  ["exit", "stopped", /ended the program/],
  ["exception", "failed", /threw an exception: not today/],
  ["number", "failed", /not a std::exception/],
  ["assertion", "stopped", /ended itself.*index/s],
  ["memory", "stopped", /ended itself|memory/],
  ["todo", "not_attempted"],
  ["off by one", "failed", /43/],
  ["last", "passed"],
];

test("every end is told, and the rest still run", async () => {
  const recipe = checkProgram(ends, `${fixtures}/ends.cpp`);
  const { failed } = await makeAll([recipe]);
  assert.equal(failed.get(key(recipe)), undefined);
  const verdicts = await check(
    made(key(recipe)),
    expected.map(([name]) => name),
    { seconds: 1 },
  );
  for (const [i, [name, status, words]] of expected.entries()) {
    const verdict = verdicts[i];
    assert.equal(verdict?.test, name);
    assert.equal(verdict?.status, status, `${name}: ${verdict?.failure?.got}`);
    if (words) assert.match(verdict?.failure?.got ?? "", words);
  }
  const failure = verdicts.find((verdict) => verdict.test === "off by one")?.failure;
  assert.equal(failure?.misconception, "one-too-many");
  assert.equal(failure?.right, "42");
  assert.deepEqual(failure?.inputs, [{ name: "how", text: '"off by one"' }]);
});

test("a test that is not there is not taken for passed", async () => {
  const recipe = checkProgram(ends, `${fixtures}/ends.cpp`);
  const verdicts = await check(made(key(recipe)), ["last", "never written"]);
  assert.deepEqual(
    verdicts.map(({ status }) => status),
    ["passed", "stopped"],
  );
  assert.match(verdicts[1]?.failure?.got ?? "", /not in the program/);
});
