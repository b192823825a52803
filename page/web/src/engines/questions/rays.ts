// Rays at a ball, a box and a mesh.

import { ball, box } from "../simulate.ts";
import type { Mesh, Question, Ray, Vec } from "../types.ts";

const PHI = (1 + Math.sqrt(5)) / 2;

/** The faces of an icosahedron, by its vertices. */
const ICOSAHEDRON = {
  vertices: [
    [-1, PHI, 0],
    [1, PHI, 0],
    [-1, -PHI, 0],
    [1, -PHI, 0],
    [0, -1, PHI],
    [0, 1, PHI],
    [0, -1, -PHI],
    [0, 1, -PHI],
    [PHI, 0, -1],
    [PHI, 0, 1],
    [-PHI, 0, -1],
    [-PHI, 0, 1],
  ] as Vec[],
  triangles: [
    [0, 11, 5],
    [0, 5, 1],
    [0, 1, 7],
    [0, 7, 10],
    [0, 10, 11],
    [1, 5, 9],
    [5, 11, 4],
    [11, 10, 2],
    [10, 7, 6],
    [7, 1, 8],
    [3, 9, 4],
    [3, 4, 2],
    [3, 2, 6],
    [3, 6, 8],
    [3, 8, 9],
    [4, 9, 5],
    [2, 4, 11],
    [6, 2, 10],
    [8, 6, 7],
    [9, 8, 1],
  ] as [number, number, number][],
};

const middle = (a: Vec, b: Vec): Vec => [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2];

const onSphere = (v: Vec): Vec => {
  const length = Math.hypot(...v);
  return [v[0] / length, v[1] / length, v[2] / length].map(Math.fround) as unknown as Vec;
};

/** A sphere of 162 vertices and 320 triangles, of floats. */
function sphereMesh(): Mesh {
  const vertices = ICOSAHEDRON.vertices.map(onSphere);
  let triangles = ICOSAHEDRON.triangles;
  for (let round = 0; round < 2; round += 1) {
    const made = new Map<string, number>();
    const between = (a: number, b: number): number => {
      const key = `${Math.min(a, b)} ${Math.max(a, b)}`;
      const known = made.get(key);
      if (known !== undefined) return known;
      made.set(key, vertices.length);
      return vertices.push(onSphere(middle(vertices[a]!, vertices[b]!))) - 1;
    };
    triangles = triangles.flatMap(([a, b, c]) => {
      const [ab, bc, ca] = [between(a, b), between(b, c), between(c, a)];
      return [
        [a, ab, ca],
        [ab, b, bc],
        [ca, bc, c],
        [ab, bc, ca],
      ] as [number, number, number][];
    });
  }
  return {
    vertices: Float32Array.from(vertices.flat()),
    triangles: Uint32Array.from(triangles.flat()),
  };
}

const MESH = sphereMesh();
const RAYS = 9_600;

/** From outside to points that are spread along the edges: ten of each, from both of its triangles. */
function edgeRays({ vertices, triangles }: Mesh): (Ray & { readonly target: number })[] {
  const vertex = (i: number): Vec => [vertices[3 * i]!, vertices[3 * i + 1]!, vertices[3 * i + 2]!];
  const rays: (Ray & { readonly target: number })[] = [];
  for (let i = 0; i < triangles.length; i += 1) {
    const a = vertex(triangles[i]!);
    const b = vertex(triangles[i % 3 === 2 ? i - 2 : i + 1]!);
    for (let k = 0; k < 10; k += 1) {
      const s = k / 10;
      const target = a.map((x, j) => x + s * (b[j]! - x)) as unknown as Vec;
      // Four radii from the centre, in a direction that changes from ray to ray.
      const origin = [
        3 * target[0] + Math.sin(k + i) / 2,
        3 * target[1] + Math.cos(2 * k + i) / 2,
        3 * target[2] + Math.sin(3 * k - i) / 2,
      ].map(Math.fround) as unknown as Vec;
      const along = target.map((x, j) => x - origin[j]!) as unknown as Vec;
      const length = Math.hypot(...along);
      rays.push({
        origin,
        direction: along.map((x) => x / length) as unknown as Vec,
        length: 20,
        target: length,
      });
    }
  }
  return rays;
}

const EDGE_RAYS = edgeRays(MESH);

const along = (origin: Vec, length: number): Ray => ({ origin, direction: [1, 0, 0], length });

export const rays: readonly Question[] = [
  {
    id: "shared-edges",
    text: "9,600 rays from outside are aimed at points on the edges between triangles of a closed mesh (162 vertices, 320 triangles). How many first hit it within 1 mm of their target?",
    unit: "",
    lesson: "02_triangles",
    planar: false,
    exact: {
      value: RAYS,
      how: "the mesh bounds a convex solid, and each ray is steep where it meets the surface, so rounding moves the hit by much less than 1 mm",
    },
    ask: (engine) =>
      engine
        .meshHits?.(MESH, EDGE_RAYS)
        .filter((distance, i) => Math.abs(distance - EDGE_RAYS[i]!.target) < 1e-3).length,
  },
  {
    id: "far-ball",
    text: "A ray from 10,000 m away passes 0.96 m beside the centre of a ball of radius 1 m. How far is the hit?",
    unit: "m",
    lesson: "04_rays",
    planar: true,
    exact: { value: 9999.72, how: "10,000 − √(1 − 0.96²), and the root is 0.28" },
    ask: (engine, { strict }) =>
      engine.ray?.(ball(1, [0, 0.96, 0]), along([-10_000, 0, 0], 20_000), strict),
  },
  {
    id: "grazing-ball",
    text: "A ray from 8 m away passes 1 − 2⁻²⁰ m beside the centre of a ball of radius 1 m. How far is the hit?",
    unit: "m",
    lesson: "04_rays",
    planar: true,
    exact: {
      value: 8 - Math.sqrt(2 ** -19 - 2 ** -40),
      how: "8 − √(2⁻¹⁹ − 2⁻⁴⁰): the difference under the root has no rounding error; 15 digits",
    },
    ask: (engine, { strict }) =>
      engine.ray?.(ball(1, [0, 1 - 2 ** -20, 0]), along([-8, 0, 0], 16), strict),
  },
  {
    id: "thin-plate",
    text: "A ray from 1,000 m away meets a plate 2 mm thick at a right angle, its middle at x = 0. How far is the hit?",
    unit: "m",
    lesson: "04_rays",
    planar: true,
    exact: { value: 999.999, how: "1,000 − 0.001" },
    ask: (engine, { strict }) =>
      engine.ray?.(box([0.001, 1, 1], [0, 0, 0]), along([-1000, 0.25, 0], 2000), strict),
  },
];
