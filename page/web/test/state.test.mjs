import assert from "node:assert/strict";
import test from "node:test";
import { load } from "./load.mjs";

const { decodeState, encodeState } = await load("state.ts");
const layout = [
  { name: "start", size: 3 },
  { name: "radius", size: 1 },
];

test("a state comes back from its link bit for bit", () => {
  const fields = { start: [0.1 + 0.2, -0, 5e-324], radius: 1.7976931348623157e308 };
  const link = encodeState("01_planes/moving", fields, [30.04, -20]);
  const back = decodeState(link, "01_planes/moving", layout);
  assert.deepEqual([...back.fields.start].map(String), fields.start.map(String));
  assert.equal(back.fields.radius, fields.radius);
  assert.deepEqual(back.eye, [30, -20]);
});

test("a link for another figure changes nothing", () => {
  const link = encodeState("01_planes/moving", { radius: 2 });
  assert.equal(decodeState(link, "01_planes/other", layout), undefined);
  assert.equal(decodeState("", "01_planes/other", layout), undefined);
  assert.equal(decodeState("#some-heading", "01_planes/other", layout), undefined);
});

test("fields that do not fit are left out", () => {
  const text = "#figure=f&radius=1,2&start=1,,3&start2=1&radius=NaN&eye=1&radius=%zz";
  assert.deepEqual(decodeState(text, "f", layout), { fields: {} });
  assert.deepEqual(decodeState("#figure=f&radius=7&start=1,2", "f", layout), {
    fields: { radius: 7 },
  });
});
