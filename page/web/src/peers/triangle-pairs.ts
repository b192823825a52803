// Other libraries asked whether two triangles meet: three-mesh-bvh, which decides along the line common to both
// planes and by separating axes, and fast-triangle-triangle-intersection, which uses orientations.

import { trianglesIntersect } from "fast-triangle-triangle-intersection";
import { Triangle, Vector3 } from "three";
import { ExtendedTriangle } from "three-mesh-bvh";
import { dependencies } from "../../../package.json";
import type { PeerCode } from "../ladder-peers.ts";

/** Numbers of a question: the vertices of both triangles. */
const SIZE = 18;

/** Both write a message about each flat triangle, which would take longer than the answer. */
function quietly(work: () => void): void {
  const { warn, error } = console;
  console.warn = console.error = () => {};
  try {
    work();
  } finally {
    Object.assign(console, { warn, error });
  }
}

/** A peer that answers about each pair with 1 if they meet, else 0. */
function pairs<T>(
  version: string,
  triangle: (a: Vector3, b: Vector3, c: Vector3) => T,
  meet: (first: T, second: T) => boolean,
): PeerCode {
  return {
    version,
    prepare(questions) {
      const made = (at: number): T => {
        const vertex = (k: number): Vector3 => new Vector3().fromArray(questions, at + 3 * k);
        return triangle(vertex(0), vertex(1), vertex(2));
      };
      const asked: [T, T][] = [];
      for (let at = 0; at < questions.length; at += SIZE) asked.push([made(at), made(at + 9)]);
      const met = new Float64Array(asked.length);
      return {
        pass() {
          quietly(() => {
            for (let i = 0; i < asked.length; i += 1) met[i] = meet(...asked[i]!) ? 1 : 0;
          });
        },
        answers: () => met.slice(),
      };
    },
  };
}

/** Planes and axes of a triangle are computed in the first pass, and kept: a mesh asks for a triangle many times. */
export const bvh: PeerCode = pairs(
  dependencies["three-mesh-bvh"],
  (a, b, c) => new ExtendedTriangle(a, b, c),
  (first, second) => first.intersectsTriangle(second),
);

export const fast: PeerCode = pairs(
  dependencies["fast-triangle-triangle-intersection"],
  (a, b, c) => new Triangle(a, b, c),
  (first, second) => trianglesIntersect(first, second) !== null,
);
