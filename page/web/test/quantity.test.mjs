// The cases that the page and `contact ask` must answer alike.

import assert from "node:assert/strict";
import fs from "node:fs";
import test from "node:test";
import { load } from "./load.mjs";

const { inUnit, parseQuantity, sameUnit } = await load("quantity.ts");
const file = new URL("../../../tests/cli/support/quantities.json", import.meta.url);
const cases = JSON.parse(fs.readFileSync(file, "utf8"));

test("a quantity is a number and the unit after it", () => {
  for (const { text, value, unit } of cases.quantities) {
    const read = parseQuantity(text);
    if (value === null) assert.equal(read, undefined, text);
    else assert.deepEqual(read, { value, unit }, text);
  }
});

test("a unit may be written in several ways, and is still not another unit", () => {
  for (const { one, other, same } of cases.units) {
    assert.equal(sameUnit(one, other), same, `${one}, ${other}`);
    assert.equal(sameUnit(other, one), same, `${other}, ${one}`);
  }
});

test("a quantity is converted to the unit that is asked for", () => {
  for (const { text, unit, value } of cases.conversions) {
    const converted = inUnit(parseQuantity(text), unit);
    if (value === null) assert.equal(converted, undefined, `${text} in ${unit}`);
    else
      assert.ok(
        Math.abs(converted - value) <= 1e-12 * Math.abs(value),
        `${text} in ${unit}: ${converted}`,
      );
  }
});
