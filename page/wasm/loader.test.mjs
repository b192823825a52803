// What the page loads: a figure's numbers are those of its native program, bit for bit; a ladder's wrong answers are
// those of the native ladder; a stop is reported, and the page continues.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { before, describe, test } from "node:test";
import { chaptersTaken } from "../../tests/browser/sample.mjs";
import { load } from "../web/test/load.mjs";
import { importLoader } from "./import_loader.mjs";
import { initialStates } from "./initial_states.mjs";
import { nativeFigure } from "./native_figure.mjs";
import { inRoot } from "./paths.mjs";
import { makeAll } from "./pool.mjs";
import { figureRecipe, figures, ladders } from "./products.mjs";
import { key, made } from "./recipes.mjs";

/** @param {string} name */
const fixture = (name) =>
  figureRecipe(inRoot("page", "wasm", "fixtures", name), [
    inRoot("chapters", "01_planes"),
    inRoot("chapters", "00_vectors"),
  ]);
const stops = fixture("stops.cpp");
const heap = fixture("heap.cpp");
const { loadFigure, loadLadder, Stopped } = await importLoader();

// Of a third of the chapters, others in each turn. tools/page_parts.py builds these, and their native programs.
const ofFigures = chaptersTaken("figures", "chapters whose figures compute as natively");
const ofLadders = chaptersTaken("ladder", "chapters whose ladder finds what it finds natively");
const takenFigures = figures().filter(({ name }) => ofFigures.includes(name.split("/")[0] ?? ""));
const takenLadders = ladders().filter(({ name }) => ofLadders.includes(name));

/** @type {Map<string, string>} */
let failed = new Map();
before(async () => {
  const recipes = [...takenFigures, ...takenLadders].map(({ recipe }) => recipe);
  ({ failed } = await makeAll([stops, heap, ...recipes]));
});

/** @param {import("./recipes.mjs").Recipe} recipe */
function bytes(recipe) {
  const why = failed.get(key(recipe));
  if (why !== undefined) assert.fail(why);
  return new Uint8Array(made(key(recipe)));
}

/** @param {string} name @returns {string} */
function native(name) {
  const program = inRoot("build", "dev", "bin", name);
  assert.ok(
    fs.existsSync(program),
    `${name} is not built: cmake --build build/dev --target ${name}`,
  );
  return program;
}

/** Numbers that come again with the seed (Mulberry32). @param {number} seed */
function random(seed) {
  return () => {
    seed = (seed + 0x6d2b79f5) | 0;
    let t = Math.imul(seed ^ (seed >>> 15), seed | 1);
    t ^= t + Math.imul(t ^ (t >>> 7), t | 61);
    return ((t ^ (t >>> 14)) >>> 0) / 2 ** 32;
  };
}

const special = [0, -0, 1, -1, 0.5, 2, -3, 0.1, 1e-9, 1e-160, -5e-324, 1e9, -1e160, 1.7e308];

/** What a reader comes to from `start`: each number left alone, or moved by up to about its size, on a grid or off it.
 * Of many numbers about six are moved: balls that all move at once overlap.
 * @param {() => number} next @param {number} start @param {number} count of the figure's numbers */
function near(next, start, count) {
  if (next() < Math.max(0.6, 1 - 6 / count)) return start;
  const moved = start + (2 * next() - 1) * Math.max(1, Math.abs(start));
  return next() < 0.5 ? Math.round(moved) : moved;
}

const unfinite = [Number.NaN, Number.POSITIVE_INFINITY, Number.NEGATIVE_INFINITY];

/** Mostly what a reader drags; then borders; now and then what no reader can. @param {() => number} next */
function number(next) {
  const kind = next();
  const pick = (/** @type {number[]} */ list) => list[Math.floor(next() * list.length)] ?? 0;
  if (kind < 0.6) return next() * 10 - 5;
  if (kind < 0.8) return Math.round(next() * 8 - 4) / 2;
  return kind < 0.995 ? pick(special) : pick(unfinite);
}

/** The same bits; all NaN alike, since no answer may depend on which.
 * @param {readonly number[]} a @param {readonly number[]} b */
const same = (a, b) => a.length === b.length && a.every((value, i) => Object.is(value, b[i]));

/** JSON has no NaN and no infinity. @param {number} value */
const asJson = (value) =>
  Number.isNaN(value)
    ? "nan"
    : Object.is(value, -0)
      ? "-0.0"
      : Number.isFinite(value)
        ? value
        : value > 0
          ? "inf"
          : "-inf";
/** @param {Record<string, number[]>} input */
const asLine = (input) =>
  JSON.stringify(input, (_, value) =>
    typeof value === "number" ? asJson(value) : value,
  ).replaceAll('"-0.0"', "-0.0");
const fromJson = (/** @type {number | string} */ value) =>
  value === "nan"
    ? Number.NaN
    : value === "inf"
      ? Number.POSITIVE_INFINITY
      : value === "-inf"
        ? Number.NEGATIVE_INFINITY
        : Number(value);

const initial = initialStates(takenFigures.map(({ name }) => name));

describe("every figure computes what its native program computes, bit for bit", () => {
  for (const { name, recipe } of takenFigures) {
    test(name, async () => {
      const figure = await loadFigure(bytes(recipe));
      const program = nativeFigure(name);
      const layout = execFileSync(program, ["--layout"], { encoding: "utf8" });
      assert.deepEqual(figure.layout, JSON.parse(layout));

      // Half of them anywhere; half near where the figure begins, since some answer nowhere else.
      const next = random(20);
      const start = (await initial).get(name) ?? {};
      const count = figure.layout.inputs.reduce((sum, { size }) => sum + size, 0);
      const inputs = Array.from({ length: 2000 }, (_, i) =>
        Object.fromEntries(
          figure.layout.inputs.map(({ name, size }) => [
            name,
            Array.from({ length: size }, (_, k) =>
              i % 2 === 0 ? number(next) : near(next, [start[name] ?? 0].flat()[k] ?? 0, count),
            ),
          ]),
        ),
      );
      let answered = 0;
      let tried = 0;
      // A figure that takes long for a state is asked fewer of them, yet at least a twentieth.
      for (const began = performance.now(); tried < inputs.length; tried += 100) {
        if (tried > 0 && performance.now() - began > 1500) break;
        const some = inputs.slice(tried, tried + 100);
        const lines = some.map(asLine);
        const answers = execFileSync(program, {
          input: `${lines.join("\n")}\n`,
          encoding: "utf8",
          maxBuffer: 1 << 28,
        })
          .trimEnd()
          .split("\n");
        assert.equal(answers.length, some.length);
        for (const [i, input] of some.entries()) {
          const right = JSON.parse(answers[i] ?? "");
          assert.equal(right.error, undefined, `${lines[i]}: ${right.error}`);
          const got = figure.compute(input);
          for (const { name } of figure.layout.outputs)
            if (!same(got[name] ?? [], right[name].map(fromJson)))
              assert.fail(
                `${name} of ${lines[i]}: ${got[name]} in the page, ${right[name]} natively`,
              );
          if (got["problem"]?.[0] === 0) ++answered;
        }
      }
      // If every input were refused, nothing would have been compared.
      assert.ok(answered >= tried / 20, `only ${answered} of ${tried} inputs have an answer`);
    });
  }
});

describe("every ladder finds the wrong answers that its native program finds", () => {
  for (const { name, recipe } of takenLadders) {
    test(name, async () => {
      const size = 60;
      const folder = fs.mkdtempSync(path.join(os.tmpdir(), "contact-ladder-"));
      try {
        const file = path.join(folder, "result.json");
        execFileSync(native(`ladder_${name}`), [
          "--size",
          `${size}`,
          "--repeats",
          "1",
          "--json",
          file,
        ]);
        /** @type {{ results: { family: string, method: string, n: number, wrong: number, undecided: number, error_max: number | null }[] }} */
        const { results } = JSON.parse(fs.readFileSync(file, "utf8"));
        const ladder = await loadLadder(bytes(recipe));
        assert.ok(ladder.layout.families.length > 0 && ladder.layout.methods.length > 0);
        for (const [f, family] of ladder.layout.families.entries()) {
          ladder.prepare(f, size);
          for (const [m, method] of ladder.layout.methods.entries()) {
            if (method.part !== family.part) continue;
            const mine = ladder.run(m);
            const theirs = results.find(
              (row) => row.family === family.id && row.method === method.id,
            );
            assert.ok(theirs, `${family.id}, ${method.id}: not in the native ladder`);
            const what = `${family.id}, ${method.id}`;
            assert.equal(mine.n, theirs.n, what);
            assert.equal(mine.wrong, theirs.wrong, what);
            assert.equal(mine.undecided, theirs.undecided, what);
            // Two libraries may round an arccosine or an exponential to neighbouring numbers.
            const rounding = method.scalar === "float" ? 2 ** -22 : 2 ** -51;
            if (theirs.error_max === null) {
              assert.ok(!Number.isFinite(mine.error_max), what); // JSON has no infinity
            } else {
              const differ = Math.abs(mine.error_max - theirs.error_max);
              assert.ok(differ <= 1e-6 * theirs.error_max + rounding, `${what}: ${differ}`);
            }
            assert.ok(mine.ns_median > 0, what);
          }
        }
      } finally {
        fs.rmSync(folder, { recursive: true, force: true });
      }
    });
  }
});

describe("a ladder judges what libraries in JavaScript answer", () => {
  for (const { name, recipe } of takenLadders)
    test(name, async (t) => {
      const ladder = await loadLadder(bytes(recipe));
      const { families, peers } = ladder.layout;
      if (peers.length === 0) return t.skip("it asks none");
      const { loadPeer } = await load("ladder-peers.ts");
      for (const [p, peer] of peers.entries()) {
        const code = await loadPeer(peer, ladder.given(p));
        const n = 400;
        const wrong = [];
        for (const [f, { part }] of families.entries()) {
          if (part !== peer.part) continue;
          ladder.prepare(f, n);
          const asked = code.prepare(ladder.questions(p, n));
          asked.pass();
          const answers = asked.answers();
          assert.equal(answers.length, n * peer.tells);
          wrong.push(ladder.judge(p, answers).wrong);
          if (wrong.length > 1) continue;
          const nothing = ladder.judge(p, new Float64Array(answers.length));
          assert.ok(
            nothing.wrong > n / 10,
            `${peer.id}: ${nothing.wrong} wrong if all it says is 0`,
          );
        }
        // The first family is random; others are hard to decide.
        assert.equal(wrong[0], 0, peer.id);
        assert.ok(Math.max(...wrong) > 0 && Math.max(...wrong) < n, `${peer.id}: ${wrong}`);
      }
    });
});

describe("the heap of figures", () => {
  test("blocks keep what is in them, and freed ones are used again", async () => {
    const figure = await loadFigure(bytes(heap));
    const { problem, overwritten, misaligned, not_zero, grown } = figure.compute({
      rounds: [20_000],
      huge: [1],
    });
    assert.deepEqual([problem, overwritten, misaligned, not_zero], [[0], [0], [0], [0]]);
    // 200 blocks of up to 4 KiB each, and their sizes are rounded up.
    assert.ok((grown?.[0] ?? Number.NaN) < 64, `${grown} pages`);
    const again = figure.compute({ rounds: [20_000], huge: [1] });
    assert.deepEqual(again["grown"], [0]);
  });

  test("a block that is too large is refused", async () => {
    const figure = await loadFigure(bytes(heap));
    for (const huge of [2 ** 29 + 1, 2 ** 31, 2 ** 32 - 1])
      assert.deepEqual(figure.compute({ rounds: [10], huge: [huge] })["refused"], [1]);
    const { refused, overwritten } = figure.compute({ rounds: [1000], huge: [1000] });
    assert.deepEqual([refused, overwritten], [[0], [0]]);
  });
});

describe("what stops", () => {
  test("a throw is its message, and the next call works", async () => {
    const figure = await loadFigure(bytes(stops));
    const good = { normal: [0, 0, 2], depth: [3] };
    const before = figure.compute(good);
    assert.deepEqual(before["offset"], [1]);
    assert.throws(
      () => figure.compute({ normal: [0, 0, 0], depth: [3] }),
      (error) => error instanceof Stopped && /^normal = \(0, 0, 0\): /.test(error.message),
    );
    await figure.ready();
    assert.deepEqual(figure.compute(good), before);
  });

  test("a stack that overflows is an error, and the next call works", async () => {
    const figure = await loadFigure(bytes(stops));
    const good = { normal: [0, 0, 2], depth: [3] };
    const before = figure.compute(good);
    assert.throws(() => figure.compute({ normal: [0, 0, 2], depth: [1e6] }), Stopped);
    await figure.ready();
    assert.deepEqual(figure.compute(good), before);
  });

  test("a number that is not finite never reaches the figure", async () => {
    const figure = await loadFigure(bytes(stops));
    for (const value of unfinite) {
      const { problem, offset } = figure.compute({ normal: [0, value, 0], depth: [3] });
      assert.equal(figure.layout.problems[problem?.[0] ?? 0], "a number is missing or not finite");
      assert.deepEqual(offset, [0]);
    }
  });

  test("a field with the wrong count of numbers is refused by name", async () => {
    const figure = await loadFigure(bytes(stops));
    assert.throws(() => figure.compute({ normal: [0, 1], depth: [3] }), /normal takes 3 numbers/);
    assert.throws(() => figure.compute({ normal: [0, 1, 0] }), /depth takes 1 numbers/);
  });
});
