// A flat view: the same scale on both axes, y up, the asked-for part of the plane always visible.

import { clipLineToStage, clipPolygonToStage } from "./clip.ts";
import type { View2 } from "./figure.ts";
import type { Vec2 } from "./numbers.ts";
import type { Point, Scene, Thing } from "./scene.ts";
import { type Shape, stripShapes } from "./shapes.ts";
import type { View } from "./view.ts";

const PADDING = 12;

export class FlatView implements View {
  readonly #view: View2;
  #width = 1;
  #height = 1;
  #scale = 1;

  constructor(view: View2) {
    this.#view = view;
  }

  resize(width: number, height: number): void {
    const { x, y } = this.#view;
    this.#width = width;
    this.#height = height;
    this.#scale = Math.min(
      (width - 2 * PADDING) / (x[1] - x[0]),
      (height - 2 * PADDING) / (y[1] - y[0]),
    );
  }

  toScreen([x, y]: Point): Vec2 {
    const middle = this.#middle();
    return [
      this.#width / 2 + (x - middle[0]) * this.#scale,
      this.#height / 2 - (y - middle[1]) * this.#scale,
    ];
  }

  dragged(_from: Point, [px, py]: Vec2): Vec2 {
    const middle = this.#middle();
    return [
      middle[0] + (px - this.#width / 2) / this.#scale,
      middle[1] - (py - this.#height / 2) / this.#scale,
    ];
  }

  keyStep(key: string): Vec2 | undefined {
    const steps: Record<string, Vec2> = {
      ArrowRight: [1, 0],
      ArrowLeft: [-1, 0],
      ArrowUp: [0, 1],
      ArrowDown: [0, -1],
    };
    return steps[key];
  }

  project(scene: Scene): Shape[] {
    return [...this.#grid(), ...layered(scene.things).flatMap((thing) => this.#shape(thing))];
  }

  #middle(): Vec2 {
    const { x, y } = this.#view;
    return [(x[0] + x[1]) / 2, (y[0] + y[1]) / 2];
  }

  #shape(thing: Thing): Shape[] {
    const { toScreen } = this;
    const place = (point: Point): Vec2 => toScreen.call(this, point);
    switch (thing.kind) {
      case "strips":
        return stripShapes(thing.strips, this.#width, this.#height);
      case "line":
        return this.#line(thing.points.map(place), thing);
      case "face":
        return [this.#face(thing.points.map(place), thing)];
      case "ball": {
        const rim = Array.from({ length: 64 }, (_, i): Vec2 => {
          const angle = (i * Math.PI) / 32;
          return [
            thing.centre[0] + thing.radius * Math.cos(angle),
            thing.centre[1] + thing.radius * Math.sin(angle),
          ];
        });
        return [this.#face(rim.map(place), thing)];
      }
      case "dot":
        return [{ ...thing, at: place(thing.at) }];
      case "label": {
        const [x, y] = place(thing.at);
        const { role = "ink", offset = [0, 0], anchor = "start", size } = thing.style;
        const at: Vec2 = [x + offset[0], y + offset[1]];
        return [{ kind: "label", at, text: thing.text, role, anchor, small: size === "small" }];
      }
    }
  }

  #line(points: readonly Vec2[], { style }: Extract<Thing, { kind: "line" }>): Shape[] {
    const shape = {
      kind: "line" as const,
      role: style.role,
      width: style.width ?? 2,
      dashed: style.dashed ?? false,
      faint: false,
      arrow: style.arrow ?? false,
    };
    const [from, to, ...more] = points;
    if (!from || !to) return [];
    if (more.length > 0) return [{ ...shape, points }];
    const cut = clipLineToStage([from, to], this.#width, this.#height);
    return cut ? [{ ...shape, points: cut }] : [];
  }

  #face(
    points: readonly Vec2[],
    { style }: { readonly style: Extract<Thing, { kind: "face" }>["style"] },
  ): Shape {
    return {
      kind: "face",
      points: clipPolygonToStage(points, this.#width, this.#height),
      role: style.role,
      fill: style.fill ?? 0.15,
      outline: style.outline ?? true,
      dashed: style.dashed ?? false,
    };
  }

  #grid(): Shape[] {
    const step = this.#view.grid;
    if (!step) return [];
    const [left, top] = this.dragged([0, 0], [0, 0]);
    const [right, bottom] = this.dragged([0, 0], [this.#width, this.#height]);
    const lines: [Vec2, Vec2][] = [];
    for (let x = Math.ceil(left / step) * step; x <= right; x += step)
      lines.push([this.toScreen([x, top]), this.toScreen([x, bottom])]);
    for (let y = Math.ceil(bottom / step) * step; y <= top; y += step)
      lines.push([this.toScreen([left, y]), this.toScreen([right, y])]);
    return lines.map((points) => ({
      kind: "line",
      points,
      role: "ghost",
      width: 1,
      dashed: false,
      faint: true,
      arrow: false,
    }));
  }
}

/** Faces lie under lines, lines under dots, dots under words; otherwise as drawn. */
function layered(things: readonly Thing[]): Thing[] {
  const layer = { strips: 4, face: 0, ball: 0, line: 1, dot: 2, label: 3 };
  return [...things].sort((p, q) => layer[p.kind] - layer[q.kind]);
}
