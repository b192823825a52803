// Which parts of a line are behind a face or a ball, so that they can be dashed: this shows depth even on paper.

import { type Camera, OrthographicCamera, Plane, Vector3 } from "three";

export interface Hider {
  /** Shares along from–to at which the line may pass behind, or come out. */
  cuts(from: Vector3, to: Vector3): number[];
  hides(point: Vector3): boolean;
}

export interface Piece {
  readonly from: number;
  readonly to: number;
  readonly hidden: boolean;
}

/** The line in as few pieces as are wholly hidden or wholly to be seen, by shares of its length. */
export function visibility(hiders: readonly Hider[], from: Vector3, to: Vector3): Piece[] {
  const inner = hiders
    .flatMap((hider) => hider.cuts(from, to))
    .filter((share) => share > 1e-6 && share < 1 - 1e-6)
    .sort((p, q) => p - q);
  const pieces: Piece[] = [];
  let start = 0;
  for (const end of [...inner, 1]) {
    const middle = from.clone().lerp(to, (start + end) / 2);
    const hidden = hiders.some((hider) => hider.hides(middle));
    const before = pieces.at(-1);
    if (before?.hidden === hidden) pieces[pieces.length - 1] = { ...before, to: end };
    else pieces.push({ from: start, to: end, hidden });
    start = end;
  }
  return pieces;
}

/** A point that all lines of sight pass through, or the way they all go. */
function sight(camera: Camera): { eye: Vector3; parallel: boolean } {
  const parallel = camera instanceof OrthographicCamera;
  const back = new Vector3().setFromMatrixColumn(camera.matrixWorld, 2);
  return { eye: parallel ? back : camera.position, parallel };
}

function planeCut(plane: Plane, from: Vector3, to: Vector3): number[] {
  const before = plane.distanceToPoint(from);
  const after = plane.distanceToPoint(to);
  return before === after ? [] : [before / (before - after)];
}

/** A flat convex face, as a hider of what is beyond it. */
export function faceHider(camera: Camera, points: readonly Vector3[]): Hider[] {
  const { eye, parallel } = sight(camera);
  const [a, b, c] = points;
  if (!a || !b || !c) return [];
  const face = new Plane().setFromCoplanarPoints(a, b, c);
  const eyeSide = parallel ? face.normal.dot(eye) : face.distanceToPoint(eye);
  if (!(Math.abs(eyeSide) > 1e-9)) return [];
  if (eyeSide < 0) face.negate();
  const middle = points.reduce((sum, p) => sum.add(p), new Vector3()).divideScalar(points.length);
  const edges = points.map((from, i) => {
    const to = points[(i + 1) % points.length]!;
    const third = parallel ? from.clone().add(eye) : eye;
    const edge = new Plane().setFromCoplanarPoints(from, to, third);
    return edge.distanceToPoint(middle) < 0 ? edge.negate() : edge;
  });
  return [
    {
      cuts: (from, to) => [face, ...edges].flatMap((plane) => planeCut(plane, from, to)),
      hides: (point) =>
        face.distanceToPoint(point) < -1e-6 &&
        edges.every((edge) => edge.distanceToPoint(point) > 0),
    },
  ];
}

/** A ball, as a hider of what is behind it or inside. */
export function ballHider(camera: Camera, centre: Vector3, radius: number): Hider[] {
  const { eye, parallel } = sight(camera);
  const way = (point: Vector3): Vector3 =>
    parallel ? eye.clone() : eye.clone().sub(point).normalize();
  const hides = (point: Vector3): boolean => {
    const toCentre = centre.clone().sub(point);
    const along = toCentre.dot(way(point));
    const beside = toCentre.lengthSq() - along * along;
    return beside < radius * radius && (along > 0 || toCentre.lengthSq() < radius * radius);
  };
  return [{ hides, cuts: (from, to) => changes(from, to, hides) }];
}

const SAMPLES = 32;

/** Where a yes-or-no along a line changes, found by halving between samples. */
function changes(from: Vector3, to: Vector3, test: (point: Vector3) => boolean): number[] {
  const at = (share: number): boolean => test(from.clone().lerp(to, share));
  const found: number[] = [];
  for (let i = 0; i < SAMPLES; ++i) {
    let low = i / SAMPLES;
    let high = (i + 1) / SAMPLES;
    const before = at(low);
    if (before === at(high)) continue;
    for (let step = 0; step < 20; ++step) {
      const half = (low + high) / 2;
      if (at(half) === before) low = half;
      else high = half;
    }
    found.push((low + high) / 2);
  }
  return found;
}
