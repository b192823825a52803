// The scene that the page opens with, over the still picture: it moves by itself while it is in
// sight, and once to its end. It can be paused; a reader who wants less motion starts it.

import { button, html, onceAFrame } from "../dom.ts";
import { pretty } from "../numbers.ts";
import { OpeningRun, type OpeningScene, readOpening } from "./opening.ts";
import { nextTime, watchablePace } from "./pace.ts";
import { Picture } from "./picture.ts";
import { paintOn, whenRepainted } from "./stage.ts";

/** Hits between two pictures at most: with more of them the clock is slower. */
const BUDGET = 5000;

export class Opening {
  readonly element: HTMLElement;
  readonly #scene: OpeningScene;
  readonly #run: OpeningRun;
  readonly #picture: Picture;
  readonly #pace: number;
  readonly #canvas: HTMLCanvasElement;
  readonly #clock = html("span", { class: "clock" });
  readonly #press: HTMLButtonElement;
  readonly #paint: () => void;
  readonly #cleanUp: (() => void)[] = [];
  /** Whether the reader wants it to move; whether it is in sight; whether it can go on. */
  #playing: boolean;
  #seen = false;
  #stuck = false;
  #asked = 0;
  #last = 0;

  private constructor(scene: OpeningScene, run: OpeningRun) {
    this.#scene = scene;
    this.#run = run;
    this.#picture = new Picture(scene, run.frame());
    this.#pace = watchablePace(scene.duration);
    this.#canvas = html("canvas", { role: "img", "aria-label": scene.about });
    this.#press = button("", () => this.#toggle());
    this.element = html(
      "div",
      { class: "opening" },
      this.#canvas,
      html("div", { class: "buttons" }, this.#press, this.#clock),
    );
    this.#paint = onceAFrame(() => this.#draw());
    const less = matchMedia("(prefers-reduced-motion: reduce)");
    this.#playing = !less.matches;
    const calm = (): void => {
      if (less.matches) this.#playing = false;
      this.#follow();
    };
    less.addEventListener("change", calm);
    this.#cleanUp.push(() => less.removeEventListener("change", calm));
  }

  /**
   * Loads the scene and its C++.
   * @param scene address of its text
   * @throws if it is not there, or is a scene of another kind
   */
  static async load(scene: string, wasm: string): Promise<Opening> {
    const answer = await fetch(scene);
    if (!answer.ok) throw new Error(`${scene}: ${answer.status} ${answer.statusText}`);
    const read = readOpening(await answer.text());
    return new Opening(read, await OpeningRun.start(wasm, read));
  }

  /** It stands in the page now. */
  shown(): void {
    const sight = new IntersectionObserver((entries) => {
      this.#seen = entries.at(-1)?.isIntersecting ?? false;
      this.#follow();
    });
    sight.observe(this.element);
    this.#cleanUp.push(() => sight.disconnect(), whenRepainted(this.element, this.#paint));
    this.#draw();
    this.#follow();
  }

  close(): void {
    this.#playing = false;
    this.#follow();
    for (const clean of this.#cleanUp.splice(0)) clean();
    this.element.remove();
  }

  get #atEnd(): boolean {
    return this.#stuck || this.#run.frame().time >= this.#scene.duration;
  }

  #toggle(): void {
    this.#playing = !this.#playing;
    if (this.#playing && this.#atEnd) {
      this.#stuck = false;
      this.#run.restart();
    }
    this.#follow();
  }

  /** Moves on or stops, as it shall now, and says so. */
  #follow(): void {
    cancelAnimationFrame(this.#asked);
    this.#press.textContent = this.#playing ? "Pause" : this.#atEnd ? "Play again" : "Play";
    if (!this.#playing || !this.#seen) return;
    this.#last = performance.now();
    this.#asked = requestAnimationFrame((now) => this.#next(now));
  }

  #next(now: number): void {
    const { duration } = this.#scene;
    const elapsed = (now - this.#last) / 1000;
    this.#last = now;
    const until = nextTime(this.#run.frame().time, elapsed, this.#pace, duration);
    this.#stuck = !this.#run.advance(until, BUDGET);
    this.#draw();
    if (this.#atEnd) {
      this.#playing = false;
      this.#follow();
    } else this.#asked = requestAnimationFrame((next) => this.#next(next));
  }

  #draw(): void {
    const frame = this.#run.frame();
    const { clientWidth: width, clientHeight: height } = this.element;
    if (width > 0)
      paintOn(this.#canvas, width, height, this.#picture.pieces([frame], width, height));
    const hits = `${frame.hits.toLocaleString("en")} ${frame.hits === 1 ? "hit" : "hits"}`;
    this.#clock.textContent = `t = ${frame.time.toFixed(2)} s, ${hits}, pace × ${pretty(this.#pace)}`;
  }
}
