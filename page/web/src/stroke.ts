// A curve that is drawn by hand: an area that takes strokes of a pointer or finger, and a handle on the curve for
// drawing with the keyboard.

import { svg } from "./dom.ts";
import type { StrokeHandle } from "./figure.ts";
import { gripElement, keep, listen, rings, stepSize, tidy } from "./handles.ts";
import type { Fields } from "./layout.ts";
import type { FigureModel } from "./model.ts";
import { pretty, type Vec2 } from "./numbers.ts";
import type { View } from "./view.ts";

/** What an arrow key moves of the neighbours, the nearest first. */
const BESIDE = [0.8, 0.6, 0.4, 0.2];

/** A stroke may begin and end beside the curve, in pixels, because a reader seldom hits its first point. */
const MARGIN = 16;

export class Stroke {
  readonly element: SVGGElement;
  readonly #handle: StrokeHandle<Fields>;
  readonly #model: FigureModel;
  readonly #view: View;
  readonly #sheet = svg("rect", { class: "sheet" });
  readonly #grip = rings();
  /** The number that the keyboard changes. */
  #index: number;
  /** Where the pointer was last, while it draws. */
  #last: Vec2 | undefined;

  constructor(handle: StrokeHandle<Fields>, model: FigureModel, view: View, hintId: string) {
    this.#handle = handle;
    this.#model = model;
    this.#view = view;
    this.#index = Math.floor(model.size(handle.field) / 2);
    this.element = gripElement(handle, hintId, this.#sheet, this.#grip);
    listen(this.element, {
      down: (event) => this.#down(event),
      move: (event) => this.#move(event),
      release: () => this.#release(),
      key: (event) => this.#key(event),
    });
  }

  place(): void {
    const numbers = this.#numbers;
    const [low, high] = this.#handle.limit;
    const from = this.#view.toScreen([this.#across(0), high]);
    const to = this.#view.toScreen([this.#across(numbers.length - 1), low]);
    const value = numbers[this.#index] ?? Number.NaN;
    const at = this.#view.toScreen([this.#across(this.#index), value]);
    const shown = [from, to, at].every((point) => point?.every(Number.isFinite));
    this.element.style.display = shown ? "" : "none";
    if (!shown) return;
    const [x, y] = [from![0] - MARGIN, from![1] - MARGIN];
    const [width, height] = [to![0] + MARGIN - x, to![1] + MARGIN - y];
    for (const [name, value] of Object.entries({ x, y, width, height }))
      this.#sheet.setAttribute(name, Math.max(0, value).toFixed(1));
    this.#grip.setAttribute("transform", `translate(${at![0].toFixed(1)} ${at![1].toFixed(1)})`);
    const where = `${this.#index + 1} of ${numbers.length}`;
    this.element.setAttribute("aria-valuetext", `${pretty(value)}, point ${where}`);
    this.element.setAttribute("aria-valuenow", String(value));
    this.element.setAttribute("aria-valuemin", String(low));
    this.element.setAttribute("aria-valuemax", String(high));
  }

  get #numbers(): readonly number[] {
    return this.#model.numbers(this.#handle.field);
  }

  get #step(): number {
    return this.#handle.step ?? 0.1;
  }

  #across(index: number): number {
    return this.#handle.across(index, this.#model.input);
  }

  /** Where the pointer is, in the world. */
  #where(event: PointerEvent): Vec2 | undefined {
    const screen = this.element.ownerSVGElement?.getScreenCTM()?.inverse();
    if (!screen) return undefined;
    const { x, y } = new DOMPoint(event.clientX, event.clientY).matrixTransform(screen);
    const point = this.#view.dragged([0, 0], [x, y], "picture");
    return point && [point[0], point[1]];
  }

  #down(event: PointerEvent): void {
    const where = this.#where(event);
    if (event.button !== 0 || !where) return;
    event.stopPropagation();
    event.preventDefault();
    this.element.focus({ preventScroll: true });
    this.element.setPointerCapture(event.pointerId);
    this.element.classList.add("held");
    this.#last = where;
    this.#draw([where]);
  }

  #move(event: PointerEvent): void {
    if (!this.#last) return;
    event.stopPropagation();
    // A fast hand makes several moves between two pictures.
    const moves = event.getCoalescedEvents?.() ?? [];
    const through = (moves.length > 0 ? moves : [event]).map((move) => this.#where(move));
    this.#draw(through.filter((where) => where !== undefined));
  }

  /** Lays the curve on a line from where the pointer was through the points where it has been. */
  #draw(through: readonly Vec2[]): void {
    const numbers = [...this.#numbers];
    const across = numbers.map((_, i) => this.#across(i));
    for (const [x, y] of through) {
      const [fromX, fromY] = this.#last!;
      this.#index = nearest(across, x);
      let passed = false;
      across.forEach((at, i) => {
        if ((at - fromX) * (at - x) > 0 || x === fromX) return;
        numbers[i] = this.#tidy(fromY + ((y - fromY) * (at - fromX)) / (x - fromX), 10);
        passed = true;
      });
      if (!passed) numbers[this.#index] = this.#tidy(y, 10);
      this.#last = [x, y];
    }
    this.#model.set({ [this.#handle.field]: numbers });
  }

  #key(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey) return;
    const numbers = [...this.#numbers];
    const along = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
    const up = { ArrowUp: 1, ArrowDown: -1 }[event.key];
    if (along) {
      keep(event);
      this.#index = Math.min(numbers.length - 1, Math.max(0, this.#index + along));
      this.place();
    } else if (up) {
      keep(event);
      const size = up * stepSize(event, this.#step);
      for (const [away, share] of [1, ...BESIDE].entries())
        for (const i of new Set([this.#index - away, this.#index + away]))
          if (i in numbers) numbers[i] = this.#tidy(numbers[i]! + share * size, 100);
      this.#model.set({ [this.#handle.field]: numbers });
    }
  }

  #tidy(value: number, parts: number): number {
    return tidy(value, this.#step / parts, this.#handle.limit);
  }

  #release(): void {
    this.#last = undefined;
    this.element.classList.remove("held");
  }
}

function nearest(across: readonly number[], x: number): number {
  const off = across.map((at) => Math.abs(at - x));
  return off.indexOf(Math.min(...off));
}
