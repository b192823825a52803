// The picture of a run: bodies and half-spaces seen from afar, as flat shapes from back to front,
// painted on a canvas in the page and written as SVG when the book is built. Nothing here computes
// motion; it only says where on the picture a place is.

import { clipPolygon } from "../clip.ts";
import type { Vec2, Vec3 } from "../numbers.ts";
import type { Role } from "../scene.ts";
import type { Body, Frame, SceneFacts } from "./messages.ts";

/** What of a scene is drawn, and of a moment of its run. */
type Drawn = Pick<SceneFacts, "gravity" | "bodies">;
type Pose = Pick<Frame, "side" | "bodies">;

export type Piece =
  | {
      readonly kind: "disc";
      readonly at: Vec2;
      readonly radius: number;
      readonly role: Role;
      readonly fill: number;
      readonly dashed: boolean;
      /** Hides what is behind it. */
      readonly solid: boolean;
    }
  | {
      readonly kind: "face";
      readonly points: readonly Vec2[];
      readonly role: Role;
      readonly fill: number;
      readonly dashed: boolean;
      readonly solid: boolean;
    }
  | { readonly kind: "mark"; readonly at: Vec2; readonly role: Role };

const DEGREE = Math.PI / 180;

const add = (a: Vec3, b: Vec3, by = 1): Vec3 => [
  a[0] + b[0] * by,
  a[1] + b[1] * by,
  a[2] + b[2] * by,
];
const dot = (a: Vec3, b: Vec3): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a: Vec3, b: Vec3): Vec3 => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];
const mix = (a: Vec3, b: Vec3, share: number): Vec3 => add(a, add(b, a, -1), share);

/** A point of a body in the world. */
function turned([w, x, y, z]: readonly number[], point: Vec3): Vec3 {
  const v: Vec3 = [x!, y!, z!];
  const t = cross(v, point);
  return add(add(point, t, 2 * w!), cross(v, t), 2);
}

/** How far a body reaches from its origin. */
export function reach({ shape }: Body): number {
  switch (shape.type) {
    case "sphere":
      return shape.radius;
    case "box":
      return Math.hypot(...shape.half_lengths);
    case "capsule":
      return shape.radius + shape.half_length;
    case "hull":
      return Math.max(...shape.points.map((point) => Math.hypot(...point)));
    case "half_space":
      return 0;
  }
}

interface Bounds {
  readonly low: Vec3;
  readonly high: Vec3;
}

export interface Eye {
  /** Degrees from +x towards +y, and above the ground, as seen from what is looked at. */
  readonly azimuth: number;
  readonly elevation: number;
}

const bodyAt = (frame: Pose, i: number): Vec3 => {
  const [x, y, z] = frame.bodies.subarray(7 * i);
  return [x!, y!, z!];
};
const turnOf = (frame: Pose, i: number): Float64Array =>
  frame.bodies.subarray(7 * i + 3, 7 * i + 7);

/** The bodies that have a size, by number. */
const solid = (scene: Drawn): number[] =>
  [...scene.bodies.keys()].filter((i) => scene.bodies[i]!.shape.type !== "half_space");

export class Picture {
  readonly #scene: Drawn;
  readonly #walls: readonly { normal: Vec3; offset: number }[];
  #bounds: Bounds;
  #eye: Eye;
  #first: Pose;

  constructor(scene: Drawn, first: Pose) {
    this.#scene = scene;
    this.#first = first;
    this.#walls = scene.bodies.flatMap(({ shape }) => (shape.type === "half_space" ? shape : []));
    this.#bounds = { low: [0, 0, 0], high: [0, 0, 0] };
    this.#bounds = this.#around(first);
    this.#eye = this.firstEye;
  }

  /** From above if nothing has a height to fall from; else from the side. */
  get firstEye(): Eye {
    const { low, high } = this.#bounds;
    const flat = this.#scene.gravity[2] === 0 && high[2] - low[2] <= 2.01 * this.#largest;
    return flat ? { azimuth: -90, elevation: 89.9 } : { azimuth: -82, elevation: 9 };
  }

  get eye(): Eye {
    return this.#eye;
  }

  look({ azimuth, elevation }: Eye): void {
    this.#eye = { azimuth, elevation: Math.max(-89.9, Math.min(89.9, elevation)) };
  }

  get #largest(): number {
    return Math.max(...solid(this.#scene).map((i) => reach(this.#scene.bodies[i]!)));
  }

  /** All bodies as they are, and the nearest places of the half-spaces. */
  #around(frame: Pose): Bounds {
    const low: [number, number, number] = [Infinity, Infinity, Infinity];
    const high: [number, number, number] = [-Infinity, -Infinity, -Infinity];
    const take = (point: Vec3, by: number): void => {
      for (const k of [0, 1, 2] as const) {
        low[k] = Math.min(low[k], point[k] - by);
        high[k] = Math.max(high[k], point[k] + by);
      }
    };
    for (const i of solid(this.#scene)) take(bodyAt(frame, i), reach(this.#scene.bodies[i]!));
    if (low[0] > high[0]) return { low: [-1, -1, -1], high: [1, 1, 1] };
    const middle = mix(low, high, 0.5);
    for (const { normal, offset } of this.#walls)
      take(add(middle, normal, offset - dot(normal, middle)), 0);
    return { low, high };
  }

  /** Keeps what moves in the picture, as long as that is not all too far away. */
  follow(frame: Pose): void {
    const { low, high } = this.#bounds;
    const size = Math.hypot(...add(high, low, -1));
    const next = this.#around(frame);
    const grown: Bounds = {
      low: low.map((x, k) => Math.min(x, next.low[k]!)) as unknown as Vec3,
      high: high.map((x, k) => Math.max(x, next.high[k]!)) as unknown as Vec3,
    };
    const now = Math.hypot(...add(grown.high, grown.low, -1));
    const start = this.#around(this.#first);
    const most = 60 * Math.hypot(...add(start.high, start.low, -1));
    if (Number.isFinite(now) && now > size && now <= most) this.#bounds = grown;
  }

  /** The runs at a moment, the first one filled and the second dashed, in pixels. */
  pieces(frames: readonly Pose[], width: number, height: number): Piece[] {
    const azimuth = this.#eye.azimuth * DEGREE;
    const elevation = this.#eye.elevation * DEGREE;
    const toEye: Vec3 = [
      Math.cos(elevation) * Math.cos(azimuth),
      Math.cos(elevation) * Math.sin(azimuth),
      Math.sin(elevation),
    ];
    const right: Vec3 = [-Math.sin(azimuth), Math.cos(azimuth), 0];
    const up = cross(toEye, right);
    const { low, high } = this.#bounds;
    const middle = mix(low, high, 0.5);
    const half = (way: Vec3): number =>
      [0, 1, 2].reduce((sum, k) => sum + Math.abs(way[k]!) * (high[k]! - low[k]!), 0) / 2;
    const margin = 0.94;
    const scale = Math.min(
      (margin * width) / 2 / Math.max(half(right), 1e-300),
      (margin * height) / 2 / Math.max(half(up), 1e-300),
    );
    const flat = (point: Vec3): Vec2 => {
      const from = add(point, middle, -1);
      return [width / 2 + dot(from, right) * scale, height / 2 - dot(from, up) * scale];
    };
    const view = { flat, scale, toEye };
    const walls = this.#wallPieces(view, Math.hypot(width, height) / scale);
    const solids: { depth: number; pieces: Piece[] }[] = [];
    for (const frame of frames) {
      const ghost = frame.side === 1;
      if (frame.bodies.length < 7 * this.#scene.bodies.length) continue;
      for (const i of solid(this.#scene)) {
        const body = this.#scene.bodies[i]!;
        if (ghost && !body.moves) continue;
        const role: Role = ghost ? "normal" : body.moves ? "ball" : "surface";
        const at = bodyAt(frame, i);
        if (!at.every(Number.isFinite)) continue;
        const depth = dot(at, toEye) + (ghost ? 1e-9 : 0);
        solids.push({ depth, pieces: this.#body(i, frame, role, ghost, view) });
      }
    }
    solids.sort((p, q) => p.depth - q.depth);
    return [...walls, ...solids.flatMap(({ pieces }) => pieces)];
  }

  /** The part of each half-space's face that no other half-space covers. */
  #wallPieces({ flat, toEye }: Projection, far: number): Piece[] {
    const middle = mix(this.#bounds.low, this.#bounds.high, 0.5);
    return this.#walls.flatMap(({ normal, offset }, i): Piece[] => {
      const side: Vec3 = Math.abs(normal[0]) < 0.9 ? [1, 0, 0] : [0, 1, 0];
      const u = cross(normal, side);
      const length = Math.hypot(...u);
      const v = cross(normal, u);
      const foot = add(middle, normal, offset - dot(normal, middle));
      const corner = (a: number, b: number): Vec3 =>
        add(add(foot, u, (a * far) / length), v, (b * far) / length);
      let face: Vec3[] = [corner(1, 1), corner(-1, 1), corner(-1, -1), corner(1, -1)];
      for (const [k, other] of this.#walls.entries()) {
        if (k === i || Math.abs(dot(other.normal, normal)) > 0.999999) continue;
        face = clipPolygon(face, (point) => dot(other.normal, point) - other.offset, mix);
      }
      if (face.length < 3) return [];
      const fill = dot(normal, toEye) > 0 ? 0.12 : 0;
      return [
        {
          kind: "face",
          points: face.map(flat),
          role: "surface",
          fill,
          dashed: false,
          solid: false,
        },
      ];
    });
  }

  #body(i: number, frame: Pose, role: Role, ghost: boolean, view: Projection): Piece[] {
    const { shape } = this.#scene.bodies[i]!;
    const { flat, scale, toEye } = view;
    const at = bodyAt(frame, i);
    const turn = turnOf(frame, i);
    const place = (point: Vec3): Vec3 => add(at, turned([...turn], point));
    const look = { role, fill: ghost ? 0 : 0.45, dashed: ghost, solid: !ghost };
    switch (shape.type) {
      case "sphere": {
        const disc: Piece = { kind: "disc", at: flat(at), radius: shape.radius * scale, ...look };
        const mark = turned([...turn], [shape.radius, 0, 0]);
        return this.#hasTurned(i, frame) && dot(mark, toEye) > 0
          ? [disc, { kind: "mark", at: flat(add(at, mark)), role }]
          : [disc];
      }
      case "box":
        return boxFaces(shape.half_lengths).flatMap(({ normal, points }): Piece[] =>
          dot(turned([...turn], normal), toEye) > 1e-9
            ? [{ kind: "face", points: points.map((point) => flat(place(point))), ...look }]
            : [],
        );
      case "capsule": {
        const rim = [-1, 1].flatMap((end) => {
          const [x, y] = flat(place([0, 0, end * shape.half_length]));
          return round.map(
            ([c, s]): Vec2 => [x + c * shape.radius * scale, y + s * shape.radius * scale],
          );
        });
        return [{ kind: "face", points: outline(rim), ...look }];
      }
      case "hull": {
        const points = shape.points.map((point) => flat(place(point)));
        const marks = ghost
          ? []
          : points.map((corner): Piece => ({ kind: "mark", at: corner, role }));
        return [{ kind: "face", points: outline(points), ...look }, ...marks];
      }
      case "half_space":
        return [];
    }
  }

  #hasTurned(i: number, frame: Pose): boolean {
    const from = turnOf(this.#first, i);
    return turnOf(frame, i).some((part, k) => part !== from[k]);
  }
}

interface Projection {
  readonly flat: (point: Vec3) => Vec2;
  readonly scale: number;
  readonly toEye: Vec3;
}

const round = Array.from({ length: 32 }, (_, i): Vec2 => {
  const angle = (2 * Math.PI * i) / 32;
  return [Math.cos(angle), Math.sin(angle)];
});

function boxFaces(half: Vec3): { normal: Vec3; points: Vec3[] }[] {
  return ([0, 1, 2] as const).flatMap((k) =>
    [-1, 1].map((sign) => {
      const normal: [number, number, number] = [0, 0, 0];
      normal[k] = sign;
      const [a, b] = [(k + 1) % 3, (k + 2) % 3];
      const points = [
        [1, 1],
        [-1, 1],
        [-1, -1],
        [1, -1],
      ].map(([p, q]) => {
        const corner: [number, number, number] = [0, 0, 0];
        corner[k] = sign * half[k];
        corner[a as 0] = p! * half[a as 0];
        corner[b as 0] = q! * half[b as 0];
        return corner as Vec3;
      });
      return { normal, points };
    }),
  );
}

/** The convex outline of points in the picture (Andrew's monotone chain). */
export function outline(points: readonly Vec2[]): Vec2[] {
  const sorted = [...points].sort((p, q) => p[0] - q[0] || p[1] - q[1]);
  const chain = (list: readonly Vec2[]): Vec2[] => {
    const kept: Vec2[] = [];
    for (const point of list) {
      while (kept.length >= 2) {
        const [p, q] = [kept.at(-2)!, kept.at(-1)!];
        if ((q[0] - p[0]) * (point[1] - p[1]) - (q[1] - p[1]) * (point[0] - p[0]) > 0) break;
        kept.pop();
      }
      kept.push(point);
    }
    return kept.slice(0, -1);
  };
  return sorted.length < 3 ? sorted : [...chain(sorted), ...chain(sorted.reverse())];
}

const MARK = 2.5;

/** Paints the pieces on a canvas whose unit is a pixel of the page. */
export function paint(
  context: CanvasRenderingContext2D,
  pieces: readonly Piece[],
  colour: (role: Role | "paper") => string,
): void {
  context.lineWidth = 1.3;
  context.lineJoin = "round";
  for (const piece of pieces) {
    context.strokeStyle = context.fillStyle = colour(piece.role);
    context.beginPath();
    if (piece.kind === "mark") {
      context.arc(piece.at[0], piece.at[1], MARK, 0, 2 * Math.PI);
      context.fill();
      continue;
    }
    if (piece.kind === "disc")
      context.arc(piece.at[0], piece.at[1], Math.max(piece.radius, 0.8), 0, 2 * Math.PI);
    else {
      for (const [x, y] of piece.points) context.lineTo(x, y);
      context.closePath();
    }
    context.setLineDash(piece.dashed ? [4, 3] : []);
    if (piece.solid) {
      context.fillStyle = colour("paper");
      context.fill();
      context.fillStyle = colour(piece.role);
    }
    context.globalAlpha = piece.fill;
    if (piece.fill > 0) context.fill();
    context.globalAlpha = 1;
    context.stroke();
  }
  context.setLineDash([]);
}

const px = (value: number): string => String(Math.round(value * 10) / 10);

/** The pieces as SVG, with the classes of every drawing of the book. */
export function piecesToSvg(pieces: readonly Piece[]): string {
  return pieces
    .map((piece) => {
      if (piece.kind === "mark")
        return `<circle class="head r-${piece.role}" cx="${px(piece.at[0])}" cy="${px(piece.at[1])}" r="${MARK}"/>`;
      const place =
        piece.kind === "disc"
          ? `circle cx="${px(piece.at[0])}" cy="${px(piece.at[1])}" r="${px(piece.radius)}"`
          : `polygon points="${piece.points.map(([x, y]) => `${px(x)},${px(y)}`).join(" ")}"`;
      const classes = `face outlined${piece.dashed ? " dashed" : ""} r-${piece.role}`;
      const under = piece.solid ? `<${place} class="paper"/>` : "";
      return `${under}<${place} class="${classes}" fill-opacity="${piece.fill}"/>`;
    })
    .join("");
}
