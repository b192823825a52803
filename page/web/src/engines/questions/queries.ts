// Distances, depths, times of impact and rays: questions without a simulation.

import { about, ball, box } from "../simulate.ts";
import type { Placed, Question } from "../types.ts";

const SQRT2 = Math.SQRT2;
const EIGHTH = Math.PI / 4;

const distance =
  (a: Placed, b: Placed): Question["ask"] =>
  (engine, { strict }) =>
    engine.distance?.(a, b, strict);

const depth =
  (a: Placed, b: Placed): Question["ask"] =>
  (engine, { strict }) =>
    engine.depth?.(a, b, strict);

/** A long box along x and one along z above it, both rotated by 45° about their length: edges cross. */
const crossed = (height: number): readonly [Placed, Placed] => [
  box([2, 0.5, 0.5], [0, 0, 0], { orientation: about([1, 0, 0], EIGHTH) }),
  box([0.5, 0.5, 2], [0, height, 0], { orientation: about([0, 0, 1], EIGHTH) }),
];

const standing = box([0.5, 0.5, 0.5], [0, 0.5 + SQRT2 / 2, 0], {
  orientation: about([0, 0, 1], EIGHTH),
});

export const queries: readonly Question[] = [
  {
    id: "boxes-face-to-face",
    text: "Two cubes of 1 m at x = 0.1 and x = 1.1 touch along a face. What is their distance?",
    unit: "m",
    lesson: "09_separating_planes",
    planar: true,
    exact: {
      value: 3 * 2 ** -55,
      how: "3 · 2⁻⁵⁵: the stored 1.1 less the stored 0.1 is not quite 1",
    },
    ask: distance(box([0.5, 0.5, 0.5], [0.1, 0, 0]), box([0.5, 0.5, 0.5], [1.1, 0, 0])),
  },
  {
    id: "edge-on-face",
    text: "A cube of 1 m that is rotated by 45° stands with an edge on the top of another. What is their distance?",
    unit: "m",
    lesson: "09_separating_planes",
    planar: true,
    exact: { value: 0, how: "its centre is √½ above the face, up to 1e-16" },
    ask: distance(box([0.5, 0.5, 0.5], [0, 0, 0]), standing),
  },
  {
    id: "ball-in-box",
    text: "A ball of radius 0.1 m is inside a cube of 2 m, its centre 0.25 m below a face. What is the least depth of penetration, as a negative distance?",
    unit: "m",
    lesson: "09_separating_planes",
    planar: true,
    exact: { value: -0.35, how: "0.25 m to the face and 0.1 m for the ball" },
    ask: depth(box([1, 1, 1], [0, 0, 0]), ball(0.1, [0.125, 0.75, 0])),
  },
  {
    id: "ball-in-ball",
    text: "A ball of radius 0.25 m is inside one of 1 m, with the same centre. What is the depth, as a negative distance?",
    unit: "m",
    lesson: "09_separating_planes",
    planar: true,
    exact: { value: -1.25, how: "the sum of the radii, in any direction" },
    ask: depth(ball(1, [0, 0, 0]), ball(0.25, [0, 0, 0])),
  },
  {
    id: "far-from-origin",
    text: "Two balls of radius 0.5 m lie at x = 4,096 m and x = 4,097.0009765625 m. What is their distance?",
    unit: "m",
    lesson: "00_vectors",
    planar: true,
    exact: { value: 0.0009765625, how: "2⁻¹⁰ m, without rounding" },
    ask: distance(ball(0.5, [4096, 0, 0]), ball(0.5, [4097.0009765625, 0, 0])),
  },
  {
    id: "crossed-edges-apart",
    text: "Two long boxes of 1 m × 1 m cross at a right angle, each with an edge towards the other, their axes 1.5 m apart. What is their distance?",
    unit: "m",
    lesson: "09_separating_planes",
    planar: false,
    exact: { value: 1.5 - SQRT2, how: "1.5 − √2, 15 digits" },
    ask: distance(...crossed(1.5)),
  },
  {
    id: "crossed-edges-deep",
    text: "The same with their axes 1.3 m apart: the edges overlap. What is the depth, as a negative distance?",
    unit: "m",
    lesson: "09_separating_planes",
    planar: false,
    exact: { value: 1.3 - SQRT2, how: "1.3 − √2, 15 digits; no normal of a face gives less" },
    ask: depth(...crossed(1.3)),
  },
  {
    id: "ball-hits-ball",
    text: "A ball of radius 0.5 m moves at 2 m/s past another, whose centre is 3 m ahead and 0.6 m beside the path. When do they touch?",
    unit: "s",
    lesson: "11_time_of_impact",
    planar: true,
    exact: { value: 1.1, how: "(3 − 0.8)/2, since √(1 − 0.6²) = 0.8" },
    ask: (engine, { strict }) =>
      engine.impact?.(ball(0.5, [-3, 0, 0]), [2, 0, 0], ball(0.5, [0, 0.6, 0]), strict),
  },
  {
    id: "edge-hits-edge",
    text: "The crossed boxes with their axes 3 m apart approach at 2 m/s. When do the edges touch?",
    unit: "s",
    lesson: "11_time_of_impact",
    planar: false,
    exact: { value: (3 - SQRT2) / 2, how: "(3 − √2)/2, 15 digits" },
    ask(engine, { strict }) {
      const [a, b] = crossed(3);
      return engine.impact?.(a, [0, 2, 0], b, strict);
    },
  },
];
