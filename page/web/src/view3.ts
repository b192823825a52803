// A view in space. three's cameras and vectors project; what comes out is a list of flat shapes,
// so the picture needs no WebGL, prints sharply, follows the theme and is the same in Node.

import { type Camera, OrthographicCamera, PerspectiveCamera, Vector3 } from "three";
import { clipLine, clipLineToStage, clipPolygon, clipPolygonToStage } from "./clip.ts";
import type { View3 } from "./figure.ts";
import { ballHider, faceHider, type Hider, visibility } from "./hidden.ts";
import type { Vec2, Vec3 } from "./numbers.ts";
import type { FaceStyle, LineStyle, Point, Role, Scene, Thing } from "./scene.ts";
import { type Shape, stripShapes } from "./shapes.ts";
import type { Move, View } from "./view.ts";

const FIELD_OF_VIEW = 28;
const DEGREE = Math.PI / 180;
const CIRCLE = 60;

export interface Eye {
  readonly azimuth: number;
  readonly elevation: number;
}

const vector = (point: Point): Vector3 => new Vector3(point[0], point[1], point[2] ?? 0);
const mix = (from: Vector3, to: Vector3, share: number): Vector3 => from.clone().lerp(to, share);

export class SpaceView implements View {
  readonly camera: PerspectiveCamera | OrthographicCamera;
  readonly target: Vector3;
  readonly #view: View3;
  #width = 1;
  #height = 1;

  constructor(view: View3) {
    this.#view = view;
    this.target = vector(view.target);
    this.camera =
      view.projection === "orthographic"
        ? new OrthographicCamera()
        : new PerspectiveCamera(FIELD_OF_VIEW);
    this.camera.up.set(0, 0, 1);
    this.look({ azimuth: view.azimuth, elevation: view.elevation });
  }

  get distance(): number {
    return this.#view.span / 2 / Math.tan((FIELD_OF_VIEW / 2) * DEGREE);
  }

  /** Where the eye is now, in degrees. */
  get eye(): Eye {
    const from = this.camera.position.clone().sub(this.target).normalize();
    return {
      azimuth: Math.atan2(from.y, from.x) / DEGREE,
      elevation: Math.asin(Math.max(-1, Math.min(1, from.z))) / DEGREE,
    };
  }

  look({ azimuth, elevation }: Eye): void {
    const up = Math.max(-85, Math.min(85, elevation)) * DEGREE;
    const round = azimuth * DEGREE;
    this.camera.position
      .set(Math.cos(up) * Math.cos(round), Math.cos(up) * Math.sin(round), Math.sin(up))
      .multiplyScalar(this.distance)
      .add(this.target);
    this.update();
  }

  resize(width: number, height: number): void {
    this.#width = width;
    this.#height = height;
    const { camera } = this;
    const tall = Math.max(1, height / width);
    if (camera instanceof PerspectiveCamera) {
      camera.aspect = width / height;
      camera.fov = (2 * Math.atan(Math.tan((FIELD_OF_VIEW / 2) * DEGREE) * tall)) / DEGREE;
      camera.near = this.distance / 100;
      camera.far = this.distance * 100;
    } else {
      const half = (this.#view.span / 2) * tall;
      camera.top = half;
      camera.bottom = -half;
      camera.right = (half * width) / height;
      camera.left = -camera.right;
      camera.near = this.distance / 100;
      camera.far = this.distance * 100;
    }
    camera.updateProjectionMatrix();
    this.update();
  }

  /** After the camera has moved. */
  update(): void {
    this.camera.lookAt(this.target);
    this.camera.updateMatrixWorld();
  }

  toScreen(point: Point): Vec2 | undefined {
    const inCamera = vector(point).applyMatrix4(this.camera.matrixWorldInverse);
    return inFront(this.camera, inCamera) >= 0 ? this.#pixel(inCamera) : undefined;
  }

  dragged(from: Point, place: Vec2, move: Move): Vec3 | undefined {
    const start = vector(from);
    const depth = start.clone().project(this.camera).z;
    const at = this.#unproject(place, depth);
    if (move === "picture") return at.toArray();
    const near = this.#unproject(place, -1);
    const way = at.sub(near).normalize();
    const kept = move === "level" ? "z" : "y";
    if (Math.abs(way[kept]) < 0.05) return undefined;
    const reach = (start[kept] - near[kept]) / way[kept];
    return reach > 0 ? near.addScaledVector(way, reach).toArray() : undefined;
  }

  /** Left and right along the level axis nearest to the picture's, up is away from the reader. */
  keyStep(key: string): Vec3 | undefined {
    const right = new Vector3().setFromMatrixColumn(this.camera.matrixWorld, 0);
    const alongX = Math.abs(right.x) >= Math.abs(right.y);
    const sign = Math.sign(alongX ? right.x : right.y) || 1;
    const across: Vec3 = alongX ? [sign, 0, 0] : [0, sign, 0];
    const away: Vec3 = [-across[1], across[0], 0];
    const negative = (step: Vec3): Vec3 => [-step[0], -step[1], -step[2]];
    const steps: Record<string, Vec3> = {
      ArrowRight: across,
      ArrowLeft: negative(across),
      ArrowUp: away,
      ArrowDown: negative(away),
      PageUp: [0, 0, 1],
      PageDown: [0, 0, -1],
    };
    return steps[key];
  }

  project(scene: Scene): Shape[] {
    const hiders = scene.things.flatMap((thing) => this.#hider(thing));
    const under: Shape[] = [];
    const faces: { depth: number; shapes: Shape[] }[] = [];
    const over: Shape[] = [];
    const top: Shape[] = [];
    const below: Shape[] = [];
    for (const thing of scene.things) {
      switch (thing.kind) {
        case "strips":
          below.push(...stripShapes(thing.strips, this.#width, this.#height));
          break;
        case "line":
          this.#line(thing.points.map(vector), thing.style, hiders, under, over);
          break;
        case "face":
          faces.push(this.#face(thing.points.map(vector), thing.style));
          break;
        case "ball":
          faces.push(this.#ball(vector(thing.centre), thing.radius, thing.style));
          break;
        case "dot": {
          const at = this.toScreen(thing.at);
          if (at) top.push({ ...thing, at });
          break;
        }
        case "label": {
          const place = this.toScreen(thing.at);
          if (place) top.push(label(place, thing));
          break;
        }
      }
    }
    faces.sort((p, q) => q.depth - p.depth);
    top.sort((p, q) => (p.kind === "label" ? 1 : 0) - (q.kind === "label" ? 1 : 0));
    const ground = this.#ground();
    return [
      ...ground,
      ...under,
      ...faces.flatMap(({ shapes }) => shapes),
      ...over,
      ...top,
      ...below,
    ];
  }

  #pixel(inCamera: Vector3): Vec2 {
    const at = inCamera.clone().applyMatrix4(this.camera.projectionMatrix);
    return [((at.x + 1) / 2) * this.#width, ((1 - at.y) / 2) * this.#height];
  }

  #unproject([x, y]: Vec2, depth: number): Vector3 {
    const at = new Vector3((x / this.#width) * 2 - 1, 1 - (y / this.#height) * 2, depth);
    return at.unproject(this.camera);
  }

  #hider(thing: Thing): Hider[] {
    if (thing.kind === "face" && thing.style.hides)
      return faceHider(this.camera, thing.points.map(vector));
    if (thing.kind === "ball" && thing.style.hides)
      return ballHider(this.camera, vector(thing.centre), thing.radius);
    return [];
  }

  #line(
    points: readonly Vector3[],
    style: LineStyle,
    hiders: readonly Hider[],
    under: Shape[],
    over: Shape[],
  ): void {
    for (let i = 0; i + 1 < points.length; ++i) {
      const from = points[i]!;
      const to = points[i + 1]!;
      const pieces = style.through
        ? [{ from: 0, to: 1, hidden: false }]
        : visibility(hiders, from, to);
      for (const [j, piece] of pieces.entries()) {
        const last = i + 2 === points.length && j + 1 === pieces.length;
        const ends = [mix(from, to, piece.from), mix(from, to, piece.to)] as const;
        const arrow = (style.arrow ?? false) && last;
        const shape = this.#piece(ends, { ...style, arrow }, piece.hidden);
        if (shape) (piece.hidden ? under : over).push(shape);
      }
    }
  }

  #piece(piece: readonly [Vector3, Vector3], style: LineStyle, behind: boolean): Shape | undefined {
    const inCamera = piece.map((point) =>
      point.clone().applyMatrix4(this.camera.matrixWorldInverse),
    );
    const front = clipLine(
      [inCamera[0]!, inCamera[1]!],
      (point) => inFront(this.camera, point),
      mix,
    );
    const cut =
      front &&
      clipLineToStage([this.#pixel(front[0]), this.#pixel(front[1])], this.#width, this.#height);
    return (
      cut && {
        kind: "line",
        points: cut,
        role: style.role,
        width: style.width ?? 2.2,
        dashed: behind || (style.dashed ?? false),
        faint: behind,
        arrow: style.arrow ?? false,
      }
    );
  }

  #face(points: readonly Vector3[], style: FaceStyle): { depth: number; shapes: Shape[] } {
    const inCamera = points.map((point) =>
      point.clone().applyMatrix4(this.camera.matrixWorldInverse),
    );
    const depth = -inCamera.reduce((sum, point) => sum + point.z, 0) / inCamera.length;
    const front = clipPolygon(inCamera, (point) => inFront(this.camera, point), mix);
    const pixels = front.map((point) => this.#pixel(point));
    const cut = clipPolygonToStage(pixels, this.#width, this.#height);
    if (cut.length < 3) return { depth, shapes: [] };
    const face: Shape = {
      kind: "face",
      points: cut,
      role: style.role,
      fill: style.fill ?? 0.18,
      outline: style.outline ?? true,
      dashed: style.dashed ?? false,
    };
    return { depth, shapes: [face] };
  }

  /** A ball is its outline and its equator, the far half of it dashed. */
  #ball(centre: Vector3, radius: number, style: FaceStyle): { depth: number; shapes: Shape[] } {
    const toEye = eyeFrom(this.camera, centre);
    const distance = toEye.length();
    const flat = this.camera instanceof OrthographicCamera;
    if (!flat && distance <= radius) return { depth: 0, shapes: [] };
    const shrink = flat ? 0 : (radius * radius) / (distance * distance);
    const middle = centre.clone().addScaledVector(toEye, shrink);
    const rim = circle(middle, toEye, radius * Math.sqrt(1 - shrink));
    const outline = this.#face(rim, style);
    const equator = circle(centre, new Vector3(0, 0, 1), radius);
    const halves = equator.flatMap((from, i) => {
      const to = equator[(i + 1) % equator.length]!;
      const half = mix(from, to, 0.5);
      const behind = half.clone().sub(centre).dot(eyeFrom(this.camera, half)) < 0;
      const line = { role: style.role, width: 1 };
      return behind && i % 2 === 0 ? [] : (this.#piece([from, to], line, false) ?? []);
    });
    return { depth: outline.depth, shapes: [...outline.shapes, ...halves] };
  }

  #ground(): Shape[] {
    const ground = this.#view.ground;
    if (!ground) return [];
    const { half, z, step } = ground;
    const [cx, cy] = this.#view.target;
    const style = { role: "ghost" as Role, width: 1 };
    const lines: Shape[] = [];
    for (let i = -Math.floor(half / step); i <= half / step; ++i) {
      const [x, y] = [cx + i * step, cy + i * step];
      for (const [from, to] of [
        [new Vector3(x, cy - half, z), new Vector3(x, cy + half, z)],
        [new Vector3(cx - half, y, z), new Vector3(cx + half, y, z)],
      ] as const) {
        const line = this.#piece([from, to], style, false);
        if (line) lines.push({ ...line, faint: true } as Shape);
      }
    }
    return lines;
  }
}

function label(place: Vec2, { text, style }: Extract<Thing, { kind: "label" }>): Shape {
  const { role = "ink", offset = [0, 0], anchor = "start", size } = style;
  const at: Vec2 = [place[0] + offset[0], place[1] + offset[1]];
  return { kind: "label", at, text, role, anchor, small: size === "small" };
}

/** How far a point in camera coordinates is in front of the nearest that can be drawn. */
function inFront(camera: PerspectiveCamera | OrthographicCamera, point: Vector3): number {
  return -point.z - camera.near;
}

/** From a point to the eye; for parallel projection, a long way against the view. */
export function eyeFrom(camera: Camera, point: Vector3): Vector3 {
  return camera instanceof OrthographicCamera
    ? new Vector3(0, 0, 1e3).transformDirection(camera.matrixWorld).multiplyScalar(1e3)
    : camera.position.clone().sub(point);
}

function circle(centre: Vector3, axis: Vector3, radius: number): Vector3[] {
  const n = axis.clone().normalize();
  const u = new Vector3(Math.abs(n.x) < 0.9 ? 1 : 0, Math.abs(n.x) < 0.9 ? 0 : 1, 0)
    .cross(n)
    .normalize();
  const v = n.clone().cross(u);
  return Array.from({ length: CIRCLE }, (_, i) => {
    const angle = (2 * Math.PI * i) / CIRCLE;
    return centre
      .clone()
      .addScaledVector(u, radius * Math.cos(angle))
      .addScaledVector(v, radius * Math.sin(angle));
  });
}
