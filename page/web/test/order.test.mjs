import assert from "node:assert/strict";
import test from "node:test";
import { load } from "./load.mjs";

const { moved, rightFromStart } = await load("order.ts");

test("an item moves and the others keep their order", () => {
  assert.deepEqual(moved(["a", "b", "c", "d"], 0, 2), ["b", "c", "a", "d"]);
  assert.deepEqual(moved(["a", "b", "c"], 2, 0), ["c", "a", "b"]);
  assert.deepEqual(moved(["a", "b", "c"], 1, 1), ["a", "b", "c"]);
  assert.deepEqual(moved(["a", "b", "c"], 0, 99), ["b", "c", "a"]);
  assert.deepEqual(moved(["a"], 5, 0), ["a"]);
});

test("steps are counted up to the first wrong one", () => {
  assert.equal(rightFromStart([1, 0, 2], [1, 0, 2]), 3);
  assert.equal(rightFromStart([1, 2, 0], [1, 0, 2]), 1);
  assert.equal(rightFromStart([0, 1, 2], [1, 0, 2]), 0);
});
