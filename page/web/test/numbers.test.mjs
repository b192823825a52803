import assert from "node:assert/strict";
import test from "node:test";
import { load } from "./load.mjs";

const { parseNumber, pretty, prettyVector } = await load("numbers.ts");

test("numbers are shown as a reader writes them", () => {
  assert.equal(pretty(0.25), "0.25");
  assert.equal(pretty(-1.7320508), "−1.732");
  assert.equal(pretty(1234567), "1.23 × 10⁶");
  assert.equal(pretty(-3.2e-9), "−3.2 × 10⁻⁹");
  assert.equal(pretty(100), "100");
  assert.equal(pretty(-0), "0");
  assert.equal(pretty(Number.NaN), "not a number");
  assert.equal(pretty(-Infinity), "−∞");
  assert.equal(prettyVector([1, -0.5, 0]), "(1, −0.5, 0)");
});

test("what a person types is read as a number, or refused", () => {
  assert.equal(parseNumber(" −1.5 "), -1.5);
  assert.equal(parseNumber("3/4"), 0.75);
  assert.equal(parseNumber(".5e-3"), 0.0005);
  for (const text of ["", "1,5", "x", "1/0", "1.2.3", "--1", "1e999", "NaN"])
    assert.equal(parseNumber(text), undefined, text);
});
