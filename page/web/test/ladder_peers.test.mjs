// Other libraries as methods of a ladder: what they are asked and what they tell, and how they are timed.

import assert from "node:assert/strict";
import fs from "node:fs";
import test from "node:test";
import { load } from "./load.mjs";

const { loadPeer, timed } = await load("ladder-peers.ts");
const { box, sphere } = await load("peers/three-rays.ts");
const { bvh, fast } = await load("peers/triangle-pairs.ts");

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

test("a flat triangle is asked without a message, and messages come back", (t) => {
  const said = t.mock.method(console, "warn", () => {});
  const failed = t.mock.method(console, "error", () => {});
  const point = [1, 2, 3];
  const pair = [...point, ...point, ...point, 0, 0, 0, 1, 0, 0, 0, 1, 0];
  for (const peer of [bvh, fast]) ask(peer, [pair]);
  assert.equal(said.mock.callCount() + failed.mock.callCount(), 0);
  console.warn("again");
  assert.equal(said.mock.callCount(), 1);
});

/** The sign of the volume of a tetrahedron with whole coordinates. @param {number[][]} vertices */
function side([a, b, c, d]) {
  const [u, v, w] = [b, c, d].map((p) => p.map((x, i) => x - a[i]));
  return Math.sign(
    u[0] * (v[1] * w[2] - v[2] * w[1]) +
      u[1] * (v[2] * w[0] - v[0] * w[2]) +
      u[2] * (v[0] * w[1] - v[1] * w[0]),
  );
}

/** Whether an edge of one triangle crosses the other; undefined if four of the points are in a plane. */
function meet(/** @type {number[][]} */ first, /** @type {number[][]} */ second) {
  let crosses = false;
  for (const [t, [a, b, c]] of [
    [first, second],
    [second, first],
  ]) {
    for (const [p, q] of [
      [t[0], t[1]],
      [t[1], t[2]],
      [t[2], t[0]],
    ]) {
      const ends = [side([a, b, c, p]), side([a, b, c, q])];
      const around = [side([p, q, a, b]), side([p, q, b, c]), side([p, q, c, a])];
      if (ends.includes(0) || around.includes(0)) return undefined;
      crosses ||= ends[0] !== ends[1] && around[0] === around[1] && around[1] === around[2];
    }
  }
  return crosses;
}

for (const [name, peer] of Object.entries({ "three-mesh-bvh": bvh, fast })) {
  test(`${name} at random triangles finds what whole numbers say`, () => {
    const number = whole(11);
    const questions = [];
    const right = [];
    while (questions.length < 500) {
      const points = Array.from({ length: 6 }, () => [0, 1, 2].map(() => number(-9, 9)));
      const met = meet(points.slice(0, 3), points.slice(3));
      if (met === undefined) continue;
      questions.push(points.flat());
      right.push(met ? 1 : 0);
    }
    const hits = right.filter(Boolean).length;
    assert.ok(hits > 50 && hits < 450, `${hits} meet`);
    assert.deepEqual(ask(peer, questions), right);
  });
}

test("a peer's version is that of the page's package", async () => {
  const file = new URL("../../package.json", import.meta.url);
  const { dependencies } = JSON.parse(fs.readFileSync(file, "utf8"));
  const of = {
    "three-ray-sphere": dependencies.three,
    "three-ray-box": dependencies.three,
    "bvh-meshes": dependencies["three-mesh-bvh"],
    "bvh-triangles": dependencies["three-mesh-bvh"],
    "fast-triangles": dependencies["fast-triangle-triangle-intersection"],
  };
  for (const [id, pinned] of Object.entries(of)) {
    const { version } = await loadPeer({ id }, new Float64Array());
    assert.ok(pinned === version || pinned.startsWith(`${version}.`), `${pinned}: ${version}`);
  }
});

test("a peer that the page does not have is an error", async () => {
  await assert.rejects(
    loadPeer({ id: "nobody" }, new Float64Array()),
    /the page has no peer nobody/,
  );
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

test("median and quartiles are those of seven turns after those that warm up", () => {
  // The third is hardly faster than the second.
  const passes = [90, 40, 35, 9, 4, 10, 6, 5, 8, 7];
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

test("warming up ends after ten turns", () => {
  let [passes, time] = [0, 0];
  timed(
    () => {
      passes += 1;
      time += passes <= 10 ? 1e6 / 2 ** passes : 5;
    },
    1,
    () => time,
  );
  assert.equal(passes, 17);
});
