// The picture as a list of plain shapes in pixels, and that list as SVG text. The page, the
// fallback picture and the tests all go through here.

import type { Vec2 } from "./numbers.ts";
import type { Role, Strip } from "./scene.ts";

export type Shape =
  | {
      readonly kind: "line";
      readonly points: readonly Vec2[];
      readonly role: Role;
      readonly width: number;
      readonly dashed: boolean;
      readonly faint: boolean;
      readonly arrow: boolean;
    }
  | {
      readonly kind: "face";
      readonly points: readonly Vec2[];
      readonly role: Role;
      readonly fill: number;
      readonly outline: boolean;
      readonly dashed: boolean;
    }
  | {
      readonly kind: "dot";
      readonly at: Vec2;
      readonly radius: number;
      readonly role: Role;
      readonly hollow: boolean;
    }
  | {
      readonly kind: "label";
      readonly at: Vec2;
      readonly text: string;
      readonly role: Role;
      readonly anchor: "start" | "middle" | "end";
      readonly small: boolean;
    };

const px = (value: number): string => String(Math.round(value * 10) / 10);
const list = (points: readonly Vec2[]): string =>
  points.map(([x, y]) => `${px(x)},${px(y)}`).join(" ");

export function escapeText(text: string): string {
  return text.replaceAll("&", "&amp;").replaceAll("<", "&lt;").replaceAll(">", "&gt;");
}

/** `w_a` as "w" and a lowered "a"; `n·a − k` as it stands. */
export function subscripted(text: string, lower: (sub: string) => string): string {
  return text
    .split(/(_[A-Za-z0-9]+)/)
    .map((part) => (part.startsWith("_") ? lower(escapeText(part.slice(1))) : escapeText(part)))
    .join("");
}

const ARROW = 11;

/** The head of an arrow, and the line shortened so that it does not poke through. */
function arrowhead(points: readonly Vec2[]): { line: Vec2[]; head: Vec2[] } | undefined {
  const tip = points.at(-1);
  const before = points.at(-2);
  if (!tip || !before) return undefined;
  const dx = tip[0] - before[0];
  const dy = tip[1] - before[1];
  const length = Math.hypot(dx, dy);
  if (length < 1) return undefined;
  const size = Math.min(ARROW, length * 0.6);
  const [ux, uy] = [dx / length, dy / length];
  const base: Vec2 = [tip[0] - ux * size, tip[1] - uy * size];
  const half = size * 0.4;
  return {
    line: [...points.slice(0, -1), [base[0] + ux, base[1] + uy]],
    head: [
      tip,
      [base[0] - uy * half, base[1] + ux * half],
      [base[0] + uy * half, base[1] - ux * half],
    ],
  };
}

function lineSvg(shape: Extract<Shape, { kind: "line" }>): string {
  const classes = ["line", `r-${shape.role}`];
  if (shape.dashed) classes.push("dashed");
  if (shape.faint) classes.push("faint");
  const head = shape.arrow ? arrowhead(shape.points) : undefined;
  const points = head?.line ?? shape.points;
  const text = `<polyline class="${classes.join(" ")}" stroke-width="${shape.width}" points="${list(points)}"/>`;
  return head ? `${text}<polygon class="head r-${shape.role}" points="${list(head.head)}"/>` : text;
}

function shapeSvg(shape: Shape): string {
  switch (shape.kind) {
    case "line":
      return lineSvg(shape);
    case "face": {
      const classes = `face r-${shape.role}${shape.outline ? " outlined" : ""}${shape.dashed ? " dashed" : ""}`;
      return `<polygon class="${classes}" fill-opacity="${shape.fill}" points="${list(shape.points)}"/>`;
    }
    case "dot":
      return `<circle class="dot r-${shape.role}${shape.hollow ? " hollow" : ""}" cx="${px(shape.at[0])}" cy="${px(shape.at[1])}" r="${shape.radius}"/>`;
    case "label": {
      const classes = `label r-${shape.role}${shape.small ? " small" : ""}`;
      const text = subscripted(
        shape.text,
        (sub) =>
          `<tspan dy="0.3em" font-size="80%">${sub}</tspan><tspan dy="-0.3em">&#8203;</tspan>`,
      );
      return `<text class="${classes}" x="${px(shape.at[0])}" y="${px(shape.at[1])}" text-anchor="${shape.anchor}">${text}</text>`;
    }
  }
}

export function shapesToSvg(shapes: readonly Shape[]): string {
  return shapes.map(shapeSvg).join("");
}

const ROW = 17;

/** Rows of cells along the lower edge, named on the left; an empty cell is only outlined. */
export function stripShapes(strips: readonly Strip[], width: number, height: number): Shape[] {
  const left = Math.min(130, width * 0.34);
  const right = width - 6;
  return strips.flatMap(({ name, cells }, row): Shape[] => {
    const top = height - ROW * (strips.length - row);
    const size = (right - left) / cells.length;
    const boxes = cells.map((role, i): Shape => {
      const [x1, x2] = [left + i * size, left + (i + 1) * size - Math.min(1, size * 0.25)];
      const [y1, y2] = role ? [top, top + 11] : [top + 2, top + 9];
      return {
        kind: "face",
        points: [
          [x1, y1],
          [x2, y1],
          [x2, y2],
          [x1, y2],
        ],
        role: role ?? "miss",
        fill: role ? 0.75 : 0,
        outline: !role,
        dashed: false,
      };
    });
    const at: Vec2 = [left - 8, top + 10];
    const label = {
      kind: "label",
      at,
      text: name,
      role: "ink",
      anchor: "end",
      small: true,
    } as const;
    return [label, ...boxes];
  });
}
