// three.js asked whether a ray hits a ball or a box, as its documentation says: at a ball the direction has
// length 1, and the answer is the point where the ray hits, or null.

import { Box3, Ray, REVISION, Sphere, Vector3 } from "three";
import type { PeerCode } from "../ladder-peers.ts";

const vector = (numbers: Float64Array, at: number): Vector3 =>
  new Vector3(numbers[at], numbers[at + 1], numbers[at + 2]);

const version = `0.${REVISION}`;

/** Asked: origin, direction of any length, centre, radius. Told: 1 if it hits, else 0; and t of the point, in
 * lengths of the direction, NaN without one. From inside the ball the point is where the ray leaves it. */
export const sphere: PeerCode = {
  version,
  prepare(questions) {
    const size = 10;
    const rays: Ray[] = [];
    const balls: Sphere[] = [];
    const points: Vector3[] = [];
    const lengths: number[] = [];
    for (let at = 0; at < questions.length; at += size) {
      const direction = vector(questions, at + 3);
      lengths.push(direction.length());
      rays.push(new Ray(vector(questions, at), direction.normalize()));
      balls.push(new Sphere(vector(questions, at + 6), questions[at + 9]));
      points.push(new Vector3());
    }
    const hits: (Vector3 | null)[] = rays.map(() => null);
    const along = new Vector3();
    return {
      pass() {
        for (let i = 0; i < rays.length; i += 1)
          hits[i] = rays[i]!.intersectSphere(balls[i]!, points[i]!);
      },
      answers: () =>
        Float64Array.from(
          hits.flatMap((hit, i) => {
            if (!hit) return [0, Number.NaN];
            const { origin, direction } = rays[i]!;
            return [1, along.subVectors(hit, origin).dot(direction) / lengths[i]!];
          }),
        ),
    };
  },
};

/** Asked: origin, direction, the box's lowest and highest corner. Told: 1 if the ray hits, else 0. */
export const box: PeerCode = {
  version,
  prepare(questions) {
    const size = 12;
    const rays: Ray[] = [];
    const boxes: Box3[] = [];
    for (let at = 0; at < questions.length; at += size) {
      rays.push(new Ray(vector(questions, at), vector(questions, at + 3)));
      boxes.push(new Box3(vector(questions, at + 6), vector(questions, at + 9)));
    }
    const hits = new Float64Array(rays.length);
    const point = new Vector3();
    return {
      pass() {
        for (let i = 0; i < rays.length; i += 1)
          hits[i] = rays[i]!.intersectBox(boxes[i]!, point) ? 1 : 0;
      },
      answers: () => hits.slice(),
    };
  },
};
