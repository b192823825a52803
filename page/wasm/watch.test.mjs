// Tests that do not end cost a check seconds, not minutes, and what a closer look finds comes through. The thread is
// played: it says what a program would say.
import assert from "node:assert/strict";
import { test } from "node:test";
import { watchTests } from "./test_watch.mjs";

const asked = { asked: "What?", inputs: [{ name: "x", text: "1" }] };

/** Tests whose names begin with "endless" never end. @type {import("./test_watch.mjs").Spawn} */
const spawn = ({ tests, questions, look }, tell) => {
  let ended = false;
  const say = async () => {
    for (const name of tests) {
      await new Promise((resolve) => setTimeout(resolve, 1));
      if (ended) return;
      tell({ event: "start", test: name });
      if (questions) tell({ event: "question", failure: asked });
      if (name.startsWith("endless")) return;
      if (look) tell({ event: "look", test: name, look: { right: 1, wrong: 2, how: look } });
      tell({ event: "end", test: name, status: "passed", seconds: 0 });
    }
    tell({ event: "done" });
  };
  void say();
  return {
    end: () => {
      ended = true;
    },
  };
};

/** @param {readonly string[]} names */
const timed = (names) => names.map((name) => ({ name, seconds: 2 }));

test("after a test that does not end, the others have less time and still run", async () => {
  const { results } = await watchTests(spawn, timed(["a", "endless", "b", "endless too"]), {});
  assert.deepEqual(
    results.map(({ status }) => status),
    ["passed", "stopped", "passed", "stopped"],
  );
  const endless = "an endless loop, or far too much work";
  assert.equal(results[1]?.failure?.reason, `no answer after 2 seconds: ${endless}`);
  assert.deepEqual(results[1]?.failure?.inputs, asked.inputs);
  assert.equal(
    results[3]?.failure?.reason,
    `no answer after 0.5 seconds: ${endless} (it had less time because a test before it did not end)`,
  );
});

test("when waiting for all of them would be long, the rest is not run", async () => {
  const names = [1, 2, 3, 4, 5, 6, 7, 8].map((n) => `endless ${n}`);
  const { results } = await watchTests(spawn, timed([...names, "last"]), {});
  assert.equal(results.length, 9);
  const stopped = results.filter(({ status }) => status === "stopped");
  const skipped = results.slice(stopped.length);
  assert.ok(stopped.length > 1);
  assert.ok(skipped.length > 1);
  const reason = `not run, because ${stopped.length} tests before it did not end; mend these first`;
  for (const { status, failure } of skipped)
    assert.deepEqual([status, failure?.reason], ["skipped", reason]);
});

test("a closer look is asked for and handed on", async () => {
  const { looks } = await watchTests(spawn, timed(["a"]), { look: "smaller" });
  assert.deepEqual(looks, { a: { right: 1, wrong: 2, how: "smaller" } });
});
