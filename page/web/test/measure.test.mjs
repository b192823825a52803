// Times that a figure's control measures: one after the other, none of another setting.

import assert from "node:assert/strict";
import { test } from "node:test";
import { load } from "./load.mjs";

const { measure } = await load("measure.ts");

const control = {
  kind: "measure",
  field: "ms",
  label: "Measure",
  run: "run",
  repeats: "repeats",
  setting: { field: "measured_for", output: "setting" },
};

/** A model whose setting is twice its field `kind`. */
function fakeModel() {
  const runs = new Set();
  const model = {
    input: { kind: 1, run: 0, measured_for: 0, ms: [7, 7, 7] },
    output: { setting: 2 },
    runs,
    size: () => 3,
    set(fields) {
      model.input = { ...model.input, ...fields };
      model.output = { setting: 2 * model.input.kind };
    },
    setNumber(field, index, value) {
      model.set({ [field]: model.input[field].map((old, i) => (i === index ? value : old)) });
    },
    engine: {
      compute(input) {
        runs.add(input.run);
        const began = performance.now();
        while (performance.now() - began < 1);
        return { repeats: 4 };
      },
    },
  };
  return model;
}

test("each time is measured by a run of its own, for one repeat, and belongs to the setting", async () => {
  const model = fakeModel();
  await measure(control, model, () => false);
  assert.deepEqual([...model.runs], [1, 2, 3]);
  assert.equal(model.input.measured_for, 2);
  assert.equal(model.input.run, 0);
  for (const ms of model.input.ms) assert.ok(ms >= 0.24, `${ms} ms`);
});

test("measuring ends when the reader stops it or chooses another setting", async () => {
  const stopped = fakeModel();
  await measure(control, stopped, () => stopped.input.ms[0] > 0);
  assert.deepEqual(stopped.input.ms.slice(1), [0, 0]);
  const other = fakeModel();
  const running = measure(control, other, () => false);
  other.set({ kind: 5 });
  await running;
  assert.deepEqual(other.input.ms, [0, 0, 0]);
});
