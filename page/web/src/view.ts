// What a view of a figure can do, in two dimensions or three.

import type { Vec2 } from "./numbers.ts";
import type { Point, Scene } from "./scene.ts";
import type { Shape } from "./shapes.ts";

/** Along the picture, in the horizontal plane, or in the vertical plane of constant y. */
export type Move = "picture" | "level" | "vertical";

export interface View {
  /** The size of the picture in pixels. */
  resize(width: number, height: number): void;
  /** The picture of a scene, ordered from back to front. */
  project(scene: Scene): Shape[];
  /** Where a point of the world is in the picture; nothing if it is behind the eye. */
  toScreen(point: Point): Vec2 | undefined;
  /** The point of the world at a place in the picture that `from` is dragged to. */
  dragged(from: Point, place: Vec2, move: Move): Point | undefined;
  /** One step in the world for an arrow key, along an axis; nothing for other keys. */
  keyStep(key: string): Point | undefined;
}

/** The keys that move a handle, for its description. */
export const KEYS_2D = "Arrow keys move it";
export const KEYS_3D = "Arrow keys move it level with the ground, Page Up and Page Down lift it";
export const KEYS_STROKE =
  "Draw the curve anew from left to right, or a part of it. Keys: left and right take another of its points, up and down move it and its neighbours; Shift for larger steps, Alt for smaller.";
