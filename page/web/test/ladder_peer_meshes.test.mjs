// three-mesh-bvh as a method of a ladder: it is given meshes, and asked where a segment first meets one of them.

import assert from "node:assert/strict";
import test from "node:test";
import { load } from "./load.mjs";

const { bvh } = await load("peers/mesh-segments.ts");

/** @typedef {{ vertices: number[][], triangles: number[][] }} Mesh */

/** |x| + |y| + |z| = size. @param {number} size @returns {Mesh} */
const octahedron = (size) => ({
  vertices: [0, 1, 2].flatMap((axis) =>
    [size, -size].map((x) => [0, 1, 2].map((i) => (i === axis ? x : 0))),
  ),
  triangles: [0, 1].flatMap((x) =>
    [2, 3].flatMap((y) => [4, 5].map((z) => ((x + y + z) % 2 === 0 ? [x, y, z] : [x, z, y]))),
  ),
});
/** @type {Mesh} */
const tetrahedron = {
  vertices: [
    [-7, -8, -9],
    [9, -5, -4],
    [-2, 9, -6],
    [1, 2, 8],
  ],
  triangles: [
    [0, 2, 1],
    [0, 1, 3],
    [1, 2, 3],
    [2, 0, 3],
  ],
};

/** Meshes as the ladder's C++ gives them. @param {Mesh[]} meshes */
const numbersOf = (meshes) =>
  Float64Array.from(
    meshes.flatMap(({ vertices, triangles }) => [
      vertices.length,
      triangles.length,
      ...vertices.flat(),
      ...triangles.flat(),
    ]),
  );

/** @param {Mesh[]} meshes @param {number[][]} questions mesh, start, end */
function ask(meshes, questions) {
  const asked = bvh(numbersOf(meshes)).prepare(Float64Array.from(questions.flat()));
  asked.pass();
  const told = [...asked.answers()];
  return questions.map((_, i) => told.slice(2 * i, 2 * i + 2));
}

const MISS = [-1, Number.NaN];

test("which mesh, which of its triangles, and t in lengths of the segment", () => {
  const meshes = [tetrahedron, octahedron(3)];
  // The plane x + y + z = 3 belongs to the first triangle of the octahedron.
  const got = ask(meshes, [
    [1, 4, 4, 4, -4, -4, -4],
    [1, 4, 4, 4, 0, 0, 0],
    [1, -4, -4, -4, 4, 4, 4],
    [1, 40, 40, 40, 30, 30, 30],
    [0, 40, 40, 40, 30, 30, 30],
  ]);
  assert.deepEqual(
    got.map(([triangle]) => triangle),
    [0, 0, 7, -1, -1],
  );
  const ts = [3 / 8, 3 / 4, 3 / 8];
  for (const [i, t] of ts.entries()) assert.ok(Math.abs(Number(got[i]?.[1]) - t) < 1e-15, `${i}`);
  assert.ok(got.slice(3).every(([, t]) => Number.isNaN(t)));
});

test("a segment that ends before the mesh misses it, however short it is", () => {
  for (const size of [1, 2 ** -9]) {
    const mesh = octahedron(3 * size);
    const along = (/** @type {number} */ end) => [
      0,
      ...[4, 0.25, 0.5, end, 0.25, 0.5].map((x) => x * size),
    ];
    const [before, after] = ask([mesh], [along(2.5), along(2)]);
    assert.deepEqual(before, MISS, `${size}`);
    assert.ok(Math.abs(Number(after?.[1]) - 1.75 / 2) < 1e-15, `${size}`);
  }
});

test("both sides of a triangle are met", () => {
  assert.equal(ask([octahedron(3)], [[0, 0, 0, 0, 4, 4, 4]])[0]?.[0], 0);
});

test("a segment without length meets nothing", () => {
  assert.deepEqual(ask([octahedron(3)], [[0, 1, 1, 1, 1, 1, 1]]), [MISS]);
});

/** Six times the volume of a tetrahedron. @param {number[][]} vertices */
function volume([a, b, c, d]) {
  const [u, v, w] = [b, c, d].map((p) => p.map((x, i) => x - a[i]));
  return (
    u[0] * (v[1] * w[2] - v[2] * w[1]) +
    u[1] * (v[2] * w[0] - v[0] * w[2]) +
    u[2] * (v[0] * w[1] - v[1] * w[0])
  );
}

/** The first triangle and its t; undefined if that is decided by a zero. @param {Mesh} mesh @param {number[][]} ends */
function first({ vertices, triangles }, [start, end]) {
  let best = MISS;
  for (const [i, corners] of triangles.entries()) {
    const [a, b, c] = corners.map((v) => vertices[v]);
    const [from, to] = [volume([a, b, c, start]), volume([a, b, c, end])];
    const around = [
      volume([start, end, a, b]),
      volume([start, end, b, c]),
      volume([start, end, c, a]),
    ].map(Math.sign);
    if (from === 0 || to === 0 || around.includes(0)) return undefined;
    const meets = from * to < 0 && around.every((sign) => sign === around[0]);
    if (meets && !(best[1] < from / (from - to))) best = [i, from / (from - to)];
  }
  return best;
}

test("three-mesh-bvh at random segments finds what whole numbers say", () => {
  const meshes = [octahedron(9), tetrahedron];
  let state = 5;
  const number = (/** @type {number} */ from, /** @type {number} */ to) => {
    state = (state * 48271) % 2147483647;
    return from + (state % (to - from + 1));
  };
  const questions = [];
  const right = [];
  while (questions.length < 500) {
    const mesh = number(0, 1);
    const ends = [0, 1].map(() => [0, 1, 2].map(() => number(-15, 15)));
    const truth = first(meshes[mesh], ends);
    if (!truth) continue;
    questions.push([mesh, ...ends.flat()]);
    right.push(truth);
  }
  const hits = right.filter(([triangle]) => triangle >= 0).length;
  assert.ok(hits > 50 && hits < 450, `${hits} hit`);
  for (const [i, got] of ask(meshes, questions).entries()) {
    const [triangle, t] = right[i];
    assert.equal(got[0], triangle, `${questions[i]}`);
    if (triangle >= 0) assert.ok(Math.abs(got[1] - t) < 1e-14, `${questions[i]}: t`);
  }
});

test("a ray keeps the direction of its segment, so that it meets the vertex that this touches", () => {
  // With (0, -0.8, 0.6), rounded, three-mesh-bvh misses the vertex (1, 0, 0).
  const [touches] = ask([octahedron(1)], [[0, 1, 4, -3, 1, -4, 3]]);
  assert.deepEqual(touches, [0, 0.5]);
});

test("three-mesh-bvh loses an edge that a segment touches from outside", () => {
  // In its middle, (0, 3/4, -1/4), the segment touches the edge between (0, 1, 0) and (0, 0, -1), and it does not
  // enter. The ladder counts this miss as wrong.
  const ends = [
    [1, 0.5, -1.5],
    [-1, 1, 1],
  ];
  assert.deepEqual(ask([octahedron(1)], [[0, ...ends.flat()]]), [MISS]);
});
