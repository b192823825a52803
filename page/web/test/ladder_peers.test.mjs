// Other libraries as methods of a ladder: what they are asked and what they tell, and how they are timed.

import assert from "node:assert/strict";
import fs from "node:fs";
import test from "node:test";
import { load } from "./load.mjs";

const { loadPeer, timed } = await load("ladder-peers.ts");
const { box, sphere } = await load("peers/three-rays.ts");

/** @param {any} peer @param {number[][]} questions */
function ask(peer, questions) {
  const asked = peer.prepare(Float64Array.from(questions.flat()));
  asked.pass();
  return [...asked.answers()];
}

/** The same whole numbers in each run. */
function whole(seed = 1) {
  let state = seed;
  return (/** @type {number} */ from, /** @type {number} */ to) => {
    state = (state * 48271) % 2147483647;
    return from + (state % (to - from + 1));
  };
}

test("three.js at a ball: hit or not, and t in lengths of the direction", () => {
  const ball = [5, 0, 0, 1];
  const got = ask(sphere, [
    [0, 0, 0, 1, 0, 0, ...ball],
    [0, 0, 0, 2, 0, 0, ...ball],
    [0, 0, 0, -1, 0, 0, ...ball],
    [0, 3, 0, 1, 0, 0, ...ball],
    // From inside it tells where the ray leaves.
    [5, 0, 0, 0, 0.5, 0, ...ball],
  ]);
  assert.deepEqual(got, [1, 4, 1, 2, 0, NaN, 0, NaN, 1, 2]);
});

test("three.js at random balls finds what whole numbers say", () => {
  const number = whole();
  const questions = [];
  const right = [];
  while (questions.length < 500) {
    const [o, d, c] = [0, 1, 2].map(() => [0, 1, 2].map(() => number(-20, 20)));
    const r = number(1, 20);
    const dot = (/** @type {number[]} */ p, /** @type {number[]} */ q) =>
      p.reduce((sum, x, i) => sum + x * q[i], 0);
    const m = o.map((x, i) => x - c[i]);
    const [a, b, below] = [dot(d, d), dot(m, d), dot(m, m) - r * r];
    const depth = b * b - a * below;
    // Tangents, and starts on the surface, are decided by rounding.
    if (a === 0 || depth === 0 || below === 0) continue;
    const [enters, leaves] = [-1, 1].map((sign) => (-b + sign * Math.sqrt(depth)) / a);
    questions.push([...o, ...d, ...c, r]);
    const hit = depth > 0 && (below < 0 || b < 0);
    right.push(hit ? [1, below < 0 ? leaves : enters] : [0, NaN]);
  }
  const hits = right.filter(([hit]) => hit).length;
  assert.ok(hits > 50 && hits < 450, `${hits} hit`);
  const got = ask(sphere, questions);
  for (const [i, [hit, t]] of right.entries()) {
    assert.equal(got[2 * i], hit, `${questions[i]}`);
    if (hit) assert.ok(Math.abs(got[2 * i + 1] - t) < 1e-10, `${questions[i]}: t`);
    else assert.ok(Number.isNaN(got[2 * i + 1]));
  }
});

test("three.js at a box: hit or not", () => {
  const cube = [1, 1, 1, 2, 2, 2];
  const got = ask(box, [
    [0, 0, 0, 1, 1, 1, ...cube],
    [0, 0, 0, -1, -1, -1, ...cube],
    [0, 1.5, 1.5, 3, 0, 0, ...cube],
    [0, 2.5, 1.5, 3, 0, 0, ...cube],
    [1.5, 1.5, 1.5, 0, 0, 1, ...cube],
  ]);
  assert.deepEqual(got, [1, 0, 1, 0, 1]);
});

test("three.js at random boxes finds what whole numbers say", () => {
  const number = whole(7);
  const questions = [];
  const right = [];
  while (questions.length < 500) {
    const [o, p, q] = [0, 1, 2].map(() => [0, 1, 2].map(() => number(-9, 9)));
    const d = [0, 1, 2].map(() => number(1, 9) * (number(0, 1) ? 1 : -1));
    const low = p.map((x, i) => Math.min(x, q[i]));
    const high = p.map((x, i) => Math.max(x, q[i]));
    // Bounds on t, all over the same denominator.
    const all = Math.abs(d[0] * d[1] * d[2]);
    const bounds = d.map((rate, i) =>
      [low[i], high[i]].map((x) => ((x - o[i]) * all) / rate).sort((s, t) => s - t),
    );
    const from = Math.max(0, ...bounds.map(([lower]) => lower));
    const to = Math.min(...bounds.map(([, upper]) => upper));
    if (from === to) continue;
    questions.push([...o, ...d, ...low, ...high]);
    right.push(from < to ? 1 : 0);
  }
  const hits = right.filter(Boolean).length;
  assert.ok(hits > 50 && hits < 450, `${hits} hit`);
  assert.deepEqual(ask(box, questions), right);
});

test("a peer's version is that of the page's package", async () => {
  const file = new URL("../../package.json", import.meta.url);
  const pinned = JSON.parse(fs.readFileSync(file, "utf8")).dependencies.three;
  for (const id of ["three-ray-sphere", "three-ray-box"]) {
    const { version } = await loadPeer({ id });
    assert.ok(pinned === version || pinned.startsWith(`${version}.`), `${pinned}: ${version}`);
  }
});

test("a peer that the page does not have is an error", async () => {
  await assert.rejects(loadPeer({ id: "nobody" }), /the page has no peer nobody/);
});

test("the time of an answer is the time of a pass over their number", () => {
  let time = 0;
  const times = timed(
    () => {
      time += 0.5;
    },
    100,
    () => time,
  );
  assert.deepEqual(times, { ns_median: 5000, ns_q1: 5000, ns_q3: 5000, repeats: 7 });
});

test("median and quartiles are those of seven turns after one that warms up", () => {
  const passes = [40, 9, 4, 10, 6, 5, 8, 7];
  let time = 0;
  const times = timed(
    () => {
      time += passes.shift() ?? Number.NaN;
    },
    1,
    () => time,
  );
  assert.deepEqual(times, { ns_median: 7e6, ns_q1: 5.5e6, ns_q3: 8.5e6, repeats: 7 });
});
