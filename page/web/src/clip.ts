// Cutting lines and polygons to a region of the picture, so that a point typed far away or behind
// the eye leaves sensible coordinates in the SVG.

import type { Vec2 } from "./numbers.ts";

/** Cuts a convex or concave polygon by the half-space where `inside` ≥ 0. */
export function clipPolygon<P>(
  points: readonly P[],
  inside: (point: P) => number,
  between: (from: P, to: P, share: number) => P,
): P[] {
  const kept: P[] = [];
  points.forEach((to, i) => {
    const from = points[(i + points.length - 1) % points.length]!;
    const before = inside(from);
    const after = inside(to);
    if (before >= 0 !== after >= 0) kept.push(between(from, to, before / (before - after)));
    if (after >= 0) kept.push(to);
  });
  return kept;
}

/** The part of a line from `from` to `to` where `inside` ≥ 0, or nothing. */
export function clipLine<P>(
  [from, to]: readonly [P, P],
  inside: (point: P) => number,
  between: (from: P, to: P, share: number) => P,
): [P, P] | undefined {
  const before = inside(from);
  const after = inside(to);
  if (before < 0 && after < 0) return undefined;
  if (before >= 0 && after >= 0) return [from, to];
  const cut = between(from, to, before / (before - after));
  return before >= 0 ? [from, cut] : [cut, to];
}

export function mix2(from: Vec2, to: Vec2, share: number): Vec2 {
  return [from[0] + (to[0] - from[0]) * share, from[1] + (to[1] - from[1]) * share];
}

type Side = (point: Vec2) => number;

function sides(width: number, height: number, margin: number): Side[] {
  return [
    ([x]) => x + margin,
    ([x]) => width + margin - x,
    ([, y]) => y + margin,
    ([, y]) => height + margin - y,
  ];
}

const MARGIN = 400;

export function clipPolygonToStage(points: readonly Vec2[], width: number, height: number): Vec2[] {
  return sides(width, height, MARGIN).reduce<Vec2[]>(
    (left, side) => clipPolygon(left, side, mix2),
    [...points],
  );
}

export function clipLineToStage(
  line: readonly [Vec2, Vec2],
  width: number,
  height: number,
): [Vec2, Vec2] | undefined {
  return sides(width, height, MARGIN).reduce<[Vec2, Vec2] | undefined>(
    (left, side) => left && clipLine(left, side, mix2),
    [line[0], line[1]],
  );
}
