// A student's answer can end in many ways; each is reported for the test in which it happened, and the rest still run.
import assert from "node:assert/strict";
import { test } from "node:test";
import { check } from "./check.mjs";
import { inRoot } from "./paths.mjs";
import { makeAll } from "./pool.mjs";
import { checkProgram } from "./products.mjs";
import { key, made } from "./recipes.mjs";

const fixtures = inRoot("page", "wasm", "fixtures");
const ends = {
  name: "fixtures/ends",
  slug: "00_vectors",
  folder: fixtures,
  test: `${fixtures}/ends_test.cpp`,
};

/** @type {[string, import("./test_program.mjs").Status, RegExp?][]} */
const expected = [
  ['right, "quoted" and [in brackets]', "passed"],
  ["~abort", "stopped", /^aborted: it called abort\(\)/],
  ["a*sterisk", "passed"],
  ["loop", "stopped", /^no answer after 4 seconds: an endless loop/],
  ["back\\slash", "passed"],
  ["recursion", "stopped", /^segmentation fault/],
  [
    "exit",
    "stopped",
    /^the program ended by itself \(exit code 0\): does your code call exit\(\)\?$/,
  ],
  ["exception", "stopped", /^threw an exception: not today/],
  ["number", "stopped", /not a std::exception/],
  ["assertion", "stopped", /^aborted: Eigen found a wrong index or size: Assertion `index >= 0/],
  ["memory", "stopped", /^ran out of memory$/],
  ["todo", "not_attempted"],
  ["off by one", "failed", /43/],
  ["last", "passed"],
];

/** The question that every one of these tests asks. @param {string} how */
const question = (how) => ({
  asked: "How does it end?",
  inputs: [{ name: "how", text: JSON.stringify(how) }],
});

test("every end is reported, and the rest still run", async () => {
  const recipe = checkProgram(ends, `${fixtures}/ends.cpp`);
  const { failed } = await makeAll([recipe]);
  assert.equal(failed.get(key(recipe)), undefined);
  const ran = (/** @type {string[]} */ names) => check(made(key(recipe)), names, { seconds: 4 });
  // By itself: after an endless loop a test has a second, and to fill the memory may take longer.
  const others = expected.map(([name]) => name).filter((name) => name !== "memory");
  const verdicts = [...(await ran(others)), ...(await ran(["memory"]))];
  for (const [name, status, words] of expected) {
    const verdict = verdicts.find(({ test }) => test === name);
    const { failure } = verdict ?? {};
    assert.equal(verdict?.status, status, `${name}: ${JSON.stringify(failure)}`);
    if (!words) continue;
    assert.match((status === "stopped" ? failure?.reason : failure?.got) ?? "", words);
    // Also of those that can no longer say it themselves.
    const { asked, inputs } = failure ?? {};
    assert.deepEqual({ asked, inputs }, question(name.replace("~", "")));
  }
  const failure = verdicts.find((verdict) => verdict.test === "off by one")?.failure;
  assert.deepEqual(failure?.misconceptions, ["one-too-many"]);
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
  assert.match(verdicts[1]?.failure?.reason ?? "", /did not run/);
});
