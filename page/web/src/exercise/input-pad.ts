// Points of the plane, to be dragged. It computes nothing of the exercise: it shows the numbers that are typed beside it.

import { svg } from "../dom.ts";
import type { Vec2 } from "../numbers.ts";

const SIZE = 240;
const MARGIN = 26;

export interface PadOptions {
  readonly label: string;
  points(): readonly Vec2[];
  moved(index: number, to: Vec2): void;
}

interface Frame {
  readonly low: Vec2;
  readonly span: number;
  /** What dragging rounds to. */
  readonly grain: number;
}

/** The square that holds all points. */
function frameOf(points: readonly Vec2[]): Frame {
  const finite = points.filter((p) => p.every(Number.isFinite));
  const range = (axis: 0 | 1): [number, number] => {
    const values = finite.map((p) => p[axis]);
    return values.length ? [Math.min(...values), Math.max(...values)] : [0, 0];
  };
  const [x, y] = [range(0), range(1)];
  const span = Math.max(x[1] - x[0], y[1] - y[0]) || Math.max(1, Math.abs(x[0]), Math.abs(y[0]));
  const low: Vec2 = [(x[0] + x[1] - span) / 2, (y[0] + y[1] - span) / 2];
  return { low, span, grain: 10 ** Math.floor(Math.log10(span / 5)) };
}

export class Pad {
  readonly element = svg("svg", {
    class: "pad",
    viewBox: `0 0 ${SIZE} ${SIZE}`,
    role: "group",
  });
  readonly #options: PadOptions;
  #frame: Frame;

  constructor(options: PadOptions) {
    this.#options = options;
    this.#frame = frameOf(options.points());
    this.element.setAttribute("aria-label", options.label);
    this.refresh();
  }

  /** Draws the points as they are now, all of them in sight. */
  refresh(): void {
    this.#frame = frameOf(this.#options.points());
    const focused = [...this.element.children].indexOf(document.activeElement as Element);
    this.element.replaceChildren(...this.#options.points().map((_, i) => this.#knob(i)));
    this.#place();
    (this.element.children[focused] as SVGElement | undefined)?.focus({ preventScroll: true });
  }

  #place(): void {
    const { low, span } = this.#frame;
    const scale = (SIZE - 2 * MARGIN) / span;
    for (const [i, [x, y]] of this.#options.points().entries()) {
      const knob = this.element.children[i];
      if (!knob) continue;
      const at = [MARGIN + (x - low[0]) * scale, SIZE - MARGIN - (y - low[1]) * scale];
      const seen = at.every(Number.isFinite);
      knob.setAttribute("visibility", seen ? "visible" : "hidden");
      if (seen)
        knob.setAttribute("transform", `translate(${at[0]!.toFixed(1)} ${at[1]!.toFixed(1)})`);
      knob.setAttribute("aria-valuetext", `x ${x}, y ${y}`);
      knob.setAttribute("aria-valuenow", String(x));
    }
  }

  #knob(index: number): SVGGElement {
    const knob = svg(
      "g",
      { class: "knob", tabindex: "0", role: "slider", "aria-label": `point ${index}` },
      svg("circle", { class: "reach", r: "16" }),
      svg("circle", { class: "dot", r: "6" }),
    );
    const name = svg("text", { x: "9", y: "-8" });
    name.textContent = String(index);
    knob.append(name);
    let held: { x: number; y: number; from: Vec2 } | undefined;
    knob.addEventListener("pointerdown", (event) => {
      if (event.button !== 0) return;
      event.preventDefault();
      knob.setPointerCapture(event.pointerId);
      knob.focus({ preventScroll: true });
      held = { x: event.clientX, y: event.clientY, from: this.#options.points()[index]! };
    });
    knob.addEventListener("pointermove", (event) => {
      if (!held) return;
      const { width } = this.element.getBoundingClientRect();
      const unit = (this.#frame.span * SIZE) / ((SIZE - 2 * MARGIN) * width);
      const x = held.from[0] + (event.clientX - held.x) * unit;
      const y = held.from[1] - (event.clientY - held.y) * unit;
      this.#move(index, [x, y]);
    });
    const release = (): void => {
      if (!held) return;
      held = undefined;
      this.refresh();
    };
    knob.addEventListener("pointerup", release);
    knob.addEventListener("pointercancel", release);
    // A finger on a point drags it; without this some browsers scroll the page as well.
    knob.addEventListener("touchstart", (event) => event.preventDefault(), { passive: false });
    knob.addEventListener("keydown", (event) => {
      const way = { ArrowRight: [1, 0], ArrowLeft: [-1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
      const step = way[event.key as keyof typeof way];
      if (!step || event.ctrlKey || event.metaKey) return;
      event.preventDefault();
      event.stopPropagation();
      const [x, y] = this.#options.points()[index]!;
      const { grain } = this.#frame;
      this.#move(index, [x + step[0]! * grain, y + step[1]! * grain]);
      this.refresh();
    });
    return knob;
  }

  #move(index: number, [x, y]: Vec2): void {
    const { grain } = this.#frame;
    const round = (value: number): number =>
      grain < 1
        ? Math.round(value * Math.round(1 / grain)) / Math.round(1 / grain)
        : Math.round(value / grain) * grain;
    this.#options.moved(index, [round(x) + 0, round(y) + 0]);
    this.#place();
  }
}
