// The grips of a figure: each one is an element of its own that stays in place while the drawing
// under it is redrawn, so that it keeps the focus, the finger and the screen reader's attention.

import { svg } from "./dom.ts";
import type { PointHandle, SlideHandle } from "./figure.ts";
import type { Fields } from "./layout.ts";
import type { FigureModel } from "./model.ts";
import { pretty, type Vec2 } from "./numbers.ts";
import type { Point } from "./scene.ts";
import type { View } from "./view.ts";

// biome-ignore lint/suspicious/noExplicitAny: fields are checked against the C++ layout at run time
type AnyHandle = PointHandle<any> | SlideHandle<any, any>;
type Slide = SlideHandle<Record<string, unknown>, Fields>;
type Grab = { readonly pointer: Vec2; readonly place: Vec2; readonly from: Point | number };

const AXES = ["x", "y", "z"];

export class Grip {
  readonly element: SVGGElement;
  readonly #handle: AnyHandle;
  readonly #model: FigureModel;
  readonly #view: View;
  #grab: Grab | undefined;

  constructor(handle: AnyHandle, model: FigureModel, view: View, hintId: string) {
    this.#handle = handle;
    this.#model = model;
    this.#view = view;
    this.element = gripElement(handle, hintId, rings());
    listen(this.element, {
      down: (event) => this.#down(event),
      move: (event) => this.#move(event),
      release: () => this.#release(),
      key: (event) => this.#key(event),
    });
  }

  /** Puts the grip where its point is now, and says so to assistive technology. */
  place(): void {
    const at = this.#screen();
    this.element.style.display = at ? "" : "none";
    if (at)
      this.element.setAttribute("transform", `translate(${at[0].toFixed(1)} ${at[1].toFixed(1)})`);
    const numbers = this.#model.numbers(this.#handle.field);
    const text =
      numbers.length === 1
        ? pretty(numbers[0]!)
        : numbers.map((value, i) => `${AXES[i]} ${pretty(value)}`).join(", ");
    this.element.setAttribute("aria-valuetext", text);
    this.element.setAttribute("aria-valuenow", String(numbers[0] ?? 0));
    if (this.#handle.limit) {
      this.element.setAttribute("aria-valuemin", String(this.#handle.limit[0]));
      this.element.setAttribute("aria-valuemax", String(this.#handle.limit[1]));
    }
  }

  get #step(): number {
    return this.#handle.step ?? 0.1;
  }

  #worldPoint(): Point | undefined {
    if (this.#handle.kind === "point") {
      if (this.#handle.shown?.(this.#model.input) === false) return undefined;
      const origin = this.#origin();
      return this.#model
        .numbers(this.#handle.field)
        .map((value, i) => value + (origin[i] ?? 0)) as unknown as Point;
    }
    if (this.#model.problem) return undefined;
    return (this.#handle as Slide).at(this.#model.input, this.#model.output);
  }

  /** Where the vector of a point handle begins. */
  #origin(): readonly number[] {
    const from = this.#handle.kind === "point" ? this.#handle.from : undefined;
    return from ? this.#model.numbers(from as string) : [];
  }

  #screen(): Vec2 | undefined {
    const point = this.#worldPoint();
    const at = point?.every(Number.isFinite) ? this.#view.toScreen(point) : undefined;
    return at?.every(Number.isFinite) ? at : undefined;
  }

  #down(event: PointerEvent): void {
    if (event.button !== 0) return;
    event.stopPropagation();
    event.preventDefault();
    const place = this.#screen();
    if (!place) return;
    this.element.focus({ preventScroll: true });
    this.element.setPointerCapture(event.pointerId);
    this.element.classList.add("held");
    const numbers = this.#model.numbers(this.#handle.field);
    const from = this.#handle.kind === "point" ? this.#worldPoint()! : numbers[0]!;
    this.#grab = { pointer: [event.clientX, event.clientY], place, from };
  }

  #move(event: PointerEvent): void {
    const grab = this.#grab;
    if (!grab) return;
    event.stopPropagation();
    const by: Vec2 = [event.clientX - grab.pointer[0], event.clientY - grab.pointer[1]];
    if (this.#handle.kind === "point") this.#dragPoint(this.#handle, grab, by);
    else this.#dragSlide(this.#handle as Slide, grab, by);
  }

  #dragPoint(handle: PointHandle<Fields>, grab: Grab, by: Vec2): void {
    const to: Vec2 = [grab.place[0] + by[0], grab.place[1] + by[1]];
    const point = this.#view.dragged(grab.from as Point, to, handle.move ?? "picture");
    if (!point) return;
    const origin = this.#origin();
    // What a move keeps stays exactly as it was, not rounded.
    const kept = { picture: -1, level: 2, vertical: 1 }[handle.move ?? "picture"];
    const before = this.#model.numbers(handle.field);
    const numbers = point.map((value, i) =>
      i === kept ? before[i]! : this.#tidy(value - (origin[i] ?? 0)),
    );
    this.#model.set({ [handle.field]: numbers });
  }

  #dragSlide(handle: Slide, grab: Grab, by: Vec2): void {
    if (this.#model.problem) return;
    const at = handle.at(this.#model.input, this.#model.output);
    const along = handle.along(this.#model.input, this.#model.output);
    const here = this.#view.toScreen(at);
    const there = this.#view.toScreen(
      at.map((value, i) => value + along[i]! * 0.01) as unknown as Point,
    );
    if (!here || !there) return;
    const way: Vec2 = [(there[0] - here[0]) * 100, (there[1] - here[1]) * 100];
    const square = way[0] ** 2 + way[1] ** 2;
    // A line that is seen end-on cannot be followed; then up and down are used instead.
    const change = square > 25 ? (by[0] * way[0] + by[1] * way[1]) / square : -by[1] / 100;
    this.#model.set({ [handle.field]: this.#tidy((grab.from as number) + change) });
  }

  #key(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey) return;
    const size = stepSize(event, this.#step);
    const numbers = this.#model.numbers(this.#handle.field);
    if (this.#handle.kind === "slide") {
      const sign = { ArrowUp: 1, ArrowRight: 1, ArrowDown: -1, ArrowLeft: -1 }[event.key];
      if (!sign) return;
      keep(event);
      this.#model.set({ [this.#handle.field]: this.#tidy(numbers[0]! + sign * size, 100) });
      return;
    }
    const step = this.#view.keyStep(event.key);
    if (!step) return;
    keep(event);
    const moved = numbers.map((value, i) =>
      step[i] ? this.#tidy(value + step[i]! * size, 100) : value,
    );
    this.#model.set({ [this.#handle.field]: moved });
  }

  #tidy(value: number, parts = 10): number {
    return tidy(value, this.#step / parts, this.#handle.limit);
  }

  #release(): void {
    this.#grab = undefined;
    this.element.classList.remove("held");
  }
}

/** What is taken hold of, with what a screen reader says of it. */
export function gripElement(
  handle: Pick<AnyHandle, "field" | "label" | "role"> & { readonly kind: string },
  hintId: string,
  ...parts: SVGElement[]
): SVGGElement {
  return svg(
    "g",
    {
      class: `grip r-${handle.role} ${handle.kind}`,
      tabindex: "0",
      role: "slider",
      "aria-label": handle.label,
      "aria-describedby": hintId,
      "data-field": handle.field,
    },
    ...parts,
  );
}

/** A grip as it is drawn: a ring about a knob, and room for a finger. */
export function rings(): SVGGElement {
  return svg(
    "g",
    {},
    svg("circle", { class: "reach", r: "16" }),
    svg("circle", { class: "ring", r: "11" }),
    svg("circle", { class: "knob", r: "6.5" }),
  );
}

export function listen(
  element: SVGGElement,
  on: {
    down(event: PointerEvent): void;
    move(event: PointerEvent): void;
    release(): void;
    key(event: KeyboardEvent): void;
  },
): void {
  element.addEventListener("pointerdown", on.down);
  element.addEventListener("pointermove", on.move);
  for (const end of ["pointerup", "pointercancel"] as const)
    element.addEventListener(end, on.release);
  // A finger on a grip drags it; without this some browsers scroll the page as well.
  element.addEventListener("touchstart", (event) => event.preventDefault(), { passive: false });
  element.addEventListener("keydown", on.key);
}

/** Within the limits, and on a round number, so that what is read can be typed. */
export function tidy(value: number, grain: number, limit?: readonly [number, number]): number {
  const parts = Math.round(1 / grain);
  const round = Math.round(value * parts) / parts;
  const [low, high] = limit ?? [-Infinity, Infinity];
  return Math.min(high, Math.max(low, round)) + 0;
}

/** How far an arrow key moves: farther with Shift, less far with Alt. */
export function stepSize(event: KeyboardEvent, step: number): number {
  return step * (event.shiftKey ? 10 : 1) * (event.altKey ? 0.1 : 1);
}

/** Takes a key for itself: the book's pages turn by arrow keys elsewhere. */
export function keep(event: KeyboardEvent): void {
  event.preventDefault();
  event.stopPropagation();
}
