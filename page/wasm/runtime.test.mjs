// What the compiler's libraries were built without: exceptions thrown inside them, and a word about what was broken.
// And that nothing in a student's file takes the place of something in the tests.
import assert from "node:assert/strict";
import { test } from "node:test";
import { check } from "./check.mjs";
import { inRoot } from "./paths.mjs";
import { makeAll } from "./pool.mjs";
import { checkProgram, exerciseList, openChecks, openTests } from "./products.mjs";
import { key, made } from "./recipes.mjs";
import { definedNames, sealed } from "./seal.mjs";

/** @typedef {import('./recipes.mjs').Link} Link */

const fixtures = inRoot("page", "wasm", "fixtures");
const throws = {
  name: "fixtures/throws",
  slug: "00_vectors",
  folder: fixtures,
  test: `${fixtures}/throws_test.cpp`,
};

/** @param {Link} recipe */
async function program(recipe) {
  const { failed } = await makeAll([recipe]);
  assert.deepEqual([...failed.values()], []);
  return made(key(recipe));
}

const memory = /^ran out of memory$/;
const library = (/** @type {string} */ what) =>
  new RegExp(`^aborted: the standard library found .*: Assertion \`${what}.*' failed\\.$`, "s");

/** @type {Record<string, RegExp | "passed">} */
const endings = {
  "string::at": /^threw an exception: basic_string$/,
  "string::substr": /^threw an exception: (basic_)?string/,
  "string::insert": /^threw an exception: basic_string$/,
  stoi: /^threw std::invalid_argument: stoi: no conversion$/,
  "stoi of much": /^threw an exception: stoi: out of range$/,
  stod: /^threw std::invalid_argument: stod: no conversion$/,
  "vector::at": /^threw an exception: vector$/,
  "a long vector": /^threw an exception: vector$/,
  "much memory": memory,
  new: memory,
  "long string": /^threw an exception: basic_string$/,
  bitset: /^threw an exception: .*to_ulong overflow error$/,
  "optional::value": /^threw an exception: bad_optional_access$/,
  get: /^threw an exception: bad_variant_access$/,
  function: /^threw an exception: std::bad_function_call$/,
  dynamic_cast: /^threw an exception: std::bad_cast$/,
  stream: /^threw an exception: ios_base::clear/,
  rethrown: /^threw an exception: once and again$/,
  caught: "passed",
  "vector index": library("__n < size\\(\\)"),
  "empty optional": library("this->has_value\\(\\)"),
  "empty vector": library("!empty\\(\\)"),
  "array index": library("__n < _Size"),
  "null pointer": /^segmentation fault/,
};

test("what the standard library notices, it throws, or it says what it was", async () => {
  const bytes = await program(checkProgram(throws, `${fixtures}/throws.cpp`));
  const verdicts = await check(bytes, Object.keys(endings));
  /** @type {string[]} */
  const wrong = [];
  for (const { test, status, failure } of verdicts) {
    const ending = /** @type {RegExp | "passed"} */ (endings[test]);
    const right =
      ending === "passed"
        ? status === "passed"
        : status !== "passed" && ending.test(failure?.reason ?? failure?.got ?? "");
    const told = ending === "passed" || failure?.inputs[0]?.text === JSON.stringify(test);
    if (!right || !told) wrong.push(`${test}: ${status} ${JSON.stringify(failure)}`);
  }
  assert.deepEqual(wrong, []);
  assert.equal(verdicts.length, Object.keys(endings).length);
});

const attack = inRoot("tests", "grading", "sealed", "replaces_exact_product.cpp");
const attacked = "a ray hits where it passes inside the triangle and misses beside it";
const rayTriangle = /** @type {import('./products.mjs').Exercise} */ (
  exerciseList().find(({ name }) => name === "02_triangles/ray_triangle")
);

test("sealed tests cannot be changed by a function of the same name", async () => {
  const [verdict] = await check(await program(checkProgram(rayTriangle, attack)), [attacked]);
  assert.equal(verdict?.status, "failed");
});

test("open tests could be", async () => {
  const recipe = checkProgram(rayTriangle, attack);
  const [answer] = recipe.parts;
  const parts = [
    /** @type {Link['parts'][number]} */ (answer),
    openTests(rayTriangle),
    openChecks(),
  ];
  const [verdict] = await check(await program({ ...recipe, parts }), [attacked]);
  assert.equal(verdict?.status, "passed");
});

test("a student's own main() is one too many, in either form", async () => {
  for (const name of ["own_main", "own_main_with_arguments"]) {
    const { failed } = await makeAll([checkProgram(throws, `${fixtures}/${name}.cpp`)]);
    assert.match([...failed.values()].join(), /duplicate symbol: .*main/);
  }
});

test("sealing hides what an object defines, and what it uses of the others, but what is agreed", async () => {
  const tests = openTests(rayTriangle);
  const checks = openChecks();
  const { failed } = await makeAll([tests, checks]);
  assert.deepEqual([...failed.values()], []);
  const open = made(key(tests));
  const shared = definedNames(made(key(checks)));
  const names = definedNames(open);
  const [agreed = "", ...others] = names;
  assert.ok(others.length > 0);
  const closed = sealed(open, [shared], [agreed]);
  const left = definedNames(closed);
  assert.equal(left.size, names.size);
  assert.deepEqual(
    [...left].filter((name) => names.has(name)),
    [agreed],
  );
  // Each name is where the other object has it: in the one as defined, in the other as used.
  const asked = "_ZN7contact7testing6detail4failERKNS1_5AskedE";
  const [fail = ""] = [...shared].filter((name) => name.startsWith(asked));
  const sealedFail = [...definedNames(sealed(made(key(checks)), [], []))].filter((name) =>
    name.endsWith(fail),
  );
  assert.equal(sealedFail.length, 1);
  assert.notEqual(sealedFail[0], fail);
  assert.ok(Buffer.from(closed).includes(String(sealedFail[0])));
});
