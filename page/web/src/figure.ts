// What the author of a figure writes. A figure computes nothing here: every number that it shows
// comes from its C++ (`output`), or is an input. `draw` only says what to draw where.

import type { Fields } from "./layout.ts";
import type { Vec2, Vec3 } from "./numbers.ts";
import type { Role, Scene } from "./scene.ts";

export type { Vec2, Vec3 } from "./numbers.ts";
export { pretty, prettyVector } from "./numbers.ts";
export type { Role, Scene } from "./scene.ts";

export interface View2 {
  readonly kind: "2d";
  /** The part of the plane that is always visible, however the stage is shaped. */
  readonly x: Vec2;
  readonly y: Vec2;
  readonly grid?: number;
}

export interface View3 {
  readonly kind: "3d";
  /** The point in the middle of the picture; z points up. */
  readonly target: Vec3;
  /** Where the eye is as seen from the target: degrees from +x towards +y, and above the ground. */
  readonly azimuth: number;
  readonly elevation: number;
  /** How much of the world fits across the smaller side of the picture. */
  readonly span: number;
  readonly projection?: "perspective" | "orthographic";
  /** Half the width of the ground grid, its height, and the distance between its lines. */
  readonly ground?: { readonly half: number; readonly z: number; readonly step: number };
}

/** A point of the input that is taken hold of in the drawing. */
export interface PointHandle<Input> {
  readonly kind: "point";
  readonly field: keyof Input & string;
  readonly label: string;
  readonly role: Role;
  /** The field where the vector begins, when it is an arrow and not a place. */
  readonly from?: keyof Input & string;
  /** In 3D: along the picture, kept at its height, or at its y. In 2D of no effect. */
  readonly move?: "picture" | "level" | "vertical";
  readonly step?: number;
  /** Dragging and arrow keys stay within; typing does not. */
  readonly limit?: readonly [min: number, max: number];
  /** Whether there is a grip in this state; without it, in every state. */
  shown?(input: Input): boolean;
}

/** One number of the input, drawn as a grip that slides along a line. */
export interface SlideHandle<Input, Output> {
  readonly kind: "slide";
  readonly field: keyof Input & string;
  readonly label: string;
  readonly role: Role;
  /** Where the grip is, and how far it goes, in world units, when the number grows by one. */
  at(input: Input, output: Output): Vec2 | Vec3;
  along(input: Input, output: Output): Vec2 | Vec3;
  readonly step?: number;
  readonly limit?: readonly [min: number, max: number];
}

/** An array of the input, drawn as a curve with pointer or finger: its numbers are heights. */
export interface StrokeHandle<Input> {
  readonly kind: "stroke";
  readonly field: keyof Input & string;
  readonly label: string;
  readonly role: Role;
  /** The x coordinate of the number with an index; it must increase with the index. */
  across(index: number, input: Input): number;
  readonly step?: number;
  /** The sheet that is drawn on reaches from the least height to the greatest. */
  readonly limit: readonly [min: number, max: number];
}

/** A stroke's sheet is large: put it first, and the grips that lie on it after it. */
export type Handle<Input, Output> =
  | PointHandle<Input>
  | SlideHandle<Input, Output>
  | StrokeHandle<Input>;

/** How one field of the input is typed or slid beside the drawing. */
export type Control<Input> =
  | {
      readonly kind: "numbers";
      readonly field: keyof Input & string;
      readonly label: string;
      readonly role?: Role;
      readonly step?: number;
      readonly unit?: string;
      /** What the numbers of a vector are, when they are not x, y and z. */
      readonly axes?: readonly string[];
    }
  | {
      readonly kind: "slider";
      readonly field: keyof Input & string;
      readonly label: string;
      readonly min: number;
      readonly max: number;
      readonly step: number;
      readonly unit?: string;
      /** Seconds from one end to the other, for a slider that can be played. */
      readonly play?: number;
    }
  | {
      readonly kind: "choice";
      readonly field: keyof Input & string;
      readonly label: string;
      readonly options: readonly { readonly value: number; readonly label: string }[];
    }
  | {
      /** A button that measures times in the page, each by a call of the C++ that is timed. */
      readonly kind: "measure";
      /** An array: the times in ms, of one repeat. 0: not measured. */
      readonly field: keyof Input & string;
      readonly label: string;
      /** The field that is 1 + i in the call that is timed for time i, otherwise 0. */
      readonly run: keyof Input & string;
      /** The output of such a call that says how often it repeated what is timed. */
      readonly repeats: string;
      /** The field that gets the output of that name: the setting that the times belong to. */
      readonly setting: { readonly field: keyof Input & string; readonly output: string };
    }
  | {
      /** Buttons that put the figure into states worth seeing; what they leave out stays. */
      readonly kind: "states";
      readonly label: string;
      readonly options: readonly { readonly label: string; readonly fields: Partial<Input> }[];
    };

/** The choice of the type in which a figure stores and computes: `single` is 1 for float. */
export const floatOrDouble = {
  kind: "choice",
  field: "single",
  label: "Numbers",
  options: [
    { value: 0, label: "double" },
    { value: 1, label: "float" },
  ],
} as const;

/** One number that the C++ gave, named as the lesson names it. `_` begins a subscript. */
export interface Value {
  readonly name: string;
  readonly meaning: string;
  readonly value: number | readonly number[] | string;
  readonly unit?: string;
  readonly role?: Role;
}

export interface Figure<Input = Fields, Output = Fields> {
  readonly title: string;
  readonly view: View2 | View3;
  /** Width over height of the drawing; a phone may get a taller one. */
  readonly aspect?: number;
  readonly initial: Input;
  readonly handles: readonly Handle<Input, Output>[];
  readonly controls: readonly Control<Input>[];
  /** Also called when the output has a problem: then only the input may be drawn. */
  draw(scene: Scene, input: Input, output: Output & { readonly problem: number }): void;
  values(input: Input, output: Output): Value[];
  /** One sentence that says what is to be seen: for a screen reader, for print, under the values. */
  describe(input: Input, output: Output): string;
}

/** A figure whose types are forgotten, as the page handles it. */
// biome-ignore lint/suspicious/noExplicitAny: the page checks fields against the C++ layout instead
export type AnyFigure = Figure<any, any>;

/** The vector with the given number in a field that is an array of vectors. */
export function vectorAt(numbers: readonly number[], index: number): Vec3 {
  const [x = Number.NaN, y = Number.NaN, z = Number.NaN] = numbers.slice(3 * index);
  return [x, y, z];
}

/** For placing labels and drawing on: a point some shares of the way from one to another. */
export function along(from: Vec3, to: Vec3, share: number): Vec3 {
  return [
    from[0] + (to[0] - from[0]) * share,
    from[1] + (to[1] - from[1]) * share,
    from[2] + (to[2] - from[2]) * share,
  ];
}

export function defineFigure<Input, Output>(figure: Figure<Input, Output>): Figure<Input, Output> {
  return figure;
}
