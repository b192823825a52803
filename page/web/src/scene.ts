// What a figure draws: a list of things in the world, each with a role that decides its colour.
// Nothing here knows about the screen; projecting is the view's part.

import type { Vec2, Vec3 } from "./numbers.ts";

/** Colours by meaning; the palette gives each one a colour in every theme. */
export type Role =
  | "ink"
  | "muted"
  | "ray"
  | "surface"
  | "normal"
  | "hit"
  | "miss"
  | "a"
  | "b"
  | "c"
  | "ball"
  | "ghost";

export type Point = Vec2 | Vec3;

export interface LineStyle {
  readonly role: Role;
  readonly width?: number;
  readonly dashed?: boolean;
  readonly arrow?: boolean;
  /** Drawn the same in front of and behind faces. */
  readonly through?: boolean;
}

export interface FaceStyle {
  readonly role: Role;
  /** How much of the colour the face has, 0 to 1. */
  readonly fill?: number;
  readonly outline?: boolean;
  /** Lines behind it are dashed. */
  readonly hides?: boolean;
  readonly dashed?: boolean;
}

export interface LabelStyle {
  readonly role?: Role;
  /** Pixels right and down from the point. */
  readonly offset?: Vec2;
  readonly anchor?: "start" | "middle" | "end";
  readonly size?: "small" | "normal";
}

/** A row of small cells under the drawing: one verdict each, empty where there is none. */
export interface Strip {
  readonly name: string;
  readonly cells: readonly (Role | undefined)[];
}

export type Thing =
  | { readonly kind: "strips"; readonly strips: readonly Strip[] }
  | { readonly kind: "line"; readonly points: readonly Point[]; readonly style: LineStyle }
  | { readonly kind: "face"; readonly points: readonly Point[]; readonly style: FaceStyle }
  | {
      readonly kind: "ball";
      readonly centre: Point;
      readonly radius: number;
      readonly style: FaceStyle;
    }
  | {
      readonly kind: "dot";
      readonly at: Point;
      readonly role: Role;
      readonly radius: number;
      readonly hollow: boolean;
    }
  | {
      readonly kind: "label";
      readonly at: Point;
      readonly text: string;
      readonly style: LabelStyle;
    };

export class Scene {
  readonly things: Thing[] = [];

  line(from: Point, to: Point, style: LineStyle): this {
    return this.path([from, to], style);
  }

  /** Through these points; through fewer than two there is nothing to draw. */
  path(points: readonly Point[], style: LineStyle): this {
    return this.#add({ kind: "line", points, style });
  }

  arrow(from: Point, to: Point, style: LineStyle): this {
    return this.path([from, to], { ...style, arrow: true });
  }

  /** A flat convex face. */
  face(points: readonly Point[], style: FaceStyle): this {
    return this.#add({ kind: "face", points, style });
  }

  /** A disc in 2D, a sphere in 3D. */
  ball(centre: Point, radius: number, style: FaceStyle): this {
    return this.#add({ kind: "ball", centre, radius, style });
  }

  dot(at: Point, role: Role, radius = 4.5, hollow = false): this {
    return this.#add({ kind: "dot", at, role, radius, hollow });
  }

  label(at: Point, text: string, style: LabelStyle = {}): this {
    return this.#add({ kind: "label", at, text, style });
  }

  /** Rows of cells along the lower edge of the picture. */
  strips(strips: readonly Strip[]): this {
    this.things.push({ kind: "strips", strips });
    return this;
  }

  /** In 3D: the line down to the ground, and the point there, by which the eye reads depth. */
  drop(at: Vec3, z = 0, role: Role = "muted"): this {
    const foot: Vec3 = [at[0], at[1], z];
    this.line(at, foot, { role, width: 1, dashed: true, through: true });
    return this.dot(foot, role, 2.5);
  }

  /** A square piece of the plane through `centre`, with its grid; `normal` need not be a unit. */
  patch(centre: Vec3, normal: Vec3, half: number, style: FaceStyle): this {
    const axes = level(normal);
    if (!axes) return this;
    const [u, v] = axes;
    const at = (s: number, t: number): Vec3 => [
      centre[0] + s * u[0] + t * v[0],
      centre[1] + s * u[1] + t * v[1],
      centre[2] + s * u[2] + t * v[2],
    ];
    this.face([at(-half, -half), at(half, -half), at(half, half), at(-half, half)], style);
    const thin: LineStyle = { role: style.role, width: 0.5, through: true };
    for (const share of [-0.5, 0, 0.5]) {
      this.line(at(share * half, -half), at(share * half, half), thin);
      this.line(at(-half, share * half), at(half, share * half), thin);
    }
    return this;
  }

  /** A flat disc: the shadow of a ball on the ground, the cut of a ball by a plane. */
  disc(centre: Vec3, normal: Vec3, radius: number, style: FaceStyle): this {
    const axes = level(normal);
    if (!axes) return this;
    const [u, v] = axes;
    const rim = Array.from({ length: 48 }, (_, i): Vec3 => {
      const c = radius * Math.cos((i * Math.PI) / 24);
      const s = radius * Math.sin((i * Math.PI) / 24);
      return [
        centre[0] + c * u[0] + s * v[0],
        centre[1] + c * u[1] + s * v[1],
        centre[2] + c * u[2] + s * v[2],
      ];
    });
    return this.face(rim, style);
  }

  /** What is not finite has no place in the drawing. */
  #add(thing: Exclude<Thing, { kind: "strips" }>): this {
    const points = "points" in thing ? thing.points : ["at" in thing ? thing.at : thing.centre];
    const size = thing.kind === "ball" ? thing.radius : 1;
    if (points.every((point) => point.every(Number.isFinite)) && size > 0 && size < 1e300)
      this.things.push(thing);
    return this;
  }
}

/** Two unit vectors that span the plane across `normal`, the first one level with the ground. */
function level(normal: Vec3): [Vec3, Vec3] | undefined {
  const length = Math.hypot(...normal);
  if (!(length > 0) || !Number.isFinite(length)) return undefined;
  const [x, y, z] = [normal[0] / length, normal[1] / length, normal[2] / length];
  const flat = Math.hypot(x, y);
  const u: Vec3 = flat < 1e-9 ? [1, 0, 0] : [-y / flat, x / flat, 0];
  return [u, [y * u[2] - z * u[1], z * u[0] - x * u[2], x * u[1] - y * u[0]]];
}
