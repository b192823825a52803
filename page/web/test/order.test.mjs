import assert from "node:assert/strict";
import test from "node:test";
import { load } from "./load.mjs";

const { moved, parseQuantity, rightFromStart, sameUnit } = await load("order.ts");

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

test("a quantity is a number and the unit after it", () => {
  assert.deepEqual(parseQuantity("−1.5 m/s"), { value: -1.5, unit: "m/s" });
  assert.deepEqual(parseQuantity("3/4"), { value: 0.75, unit: "" });
  assert.deepEqual(parseQuantity("2m"), { value: 2, unit: "m" });
  assert.equal(parseQuantity("about 2"), undefined);
  assert.equal(parseQuantity(""), undefined);
});

test("a unit may be written in several ways, and is still not another unit", () => {
  assert.ok(sameUnit("m/s", "m s⁻¹"));
  assert.ok(sameUnit("m/s²", "m·s^-2"));
  assert.ok(sameUnit("N m", "m N"));
  assert.ok(sameUnit("°", "degrees"));
  assert.ok(sameUnit("", ""));
  assert.ok(!sameUnit("m", "m/s"));
  assert.ok(!sameUnit("s/m", "m/s"));
  assert.ok(!sameUnit("m²", "m"));
  assert.ok(!sameUnit("", "m"));
});
