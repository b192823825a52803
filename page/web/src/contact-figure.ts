// <contact-figure name="02_triangles/ray_triangle" base="../_static/contact/"><img …></contact-figure>
//
// The picture inside is the fallback. When the figure comes near the window, its drawing code and
// its C++ (WebAssembly) are loaded and the live figure takes the picture's place. If that fails the
// picture stays, with a sentence that says so.
//
// For other code on the page: `ready` (a promise), `input`, `output` (records of the C++ fields),
// `set(fields)`, `reset()`, and the event `contact-change` after each change.

import { makeControls } from "./controls.ts";
import { button, freshId, html, onceAFrame, svg } from "./dom.ts";
import { startEngine } from "./engine.ts";
import type { AnyFigure } from "./figure.ts";
import { Grip } from "./handles.ts";
import type { Fields } from "./layout.ts";
import { FigureModel, sentence } from "./model.ts";
import { untilBuilt } from "./pending.ts";
import { Scene } from "./scene.ts";
import { shapesToSvg } from "./shapes.ts";
import { decodeState, encodeState } from "./state.ts";
import { Stroke } from "./stroke.ts";
import { currentValues, makeValues } from "./values.ts";
import { KEYS_2D, KEYS_3D, KEYS_STROKE, type View } from "./view.ts";
import { FlatView } from "./view2.ts";
import type { Eye, SpaceView } from "./view3.ts";

const SPEAK_AFTER = 600;

export class ContactFigure extends HTMLElement {
  #model: FigureModel | undefined;
  #view: View | undefined;
  #space: SpaceView | undefined;
  #eyeMoved = false;
  #redraw: () => void = () => {};
  #ready: Promise<void> | undefined;
  readonly #cleanUp: (() => void)[] = [];

  get name(): string {
    return this.getAttribute("name") ?? "";
  }

  get input(): Fields | undefined {
    return this.#model?.input;
  }

  get output(): Fields | undefined {
    return this.#model?.output;
  }

  /** The numbers beside the drawing. */
  get values(): ReturnType<typeof currentValues> {
    return this.#model ? currentValues(this.#model) : [];
  }

  /** Loads the figure if it is not loaded yet; rejected if it cannot be. */
  get ready(): Promise<void> {
    this.#ready ??= this.#load();
    return this.#ready;
  }

  /** Puts something under the numbers of the loaded figure. */
  beside(element: HTMLElement): void {
    this.querySelector(".computed")?.after(element);
  }

  set(fields: Fields): void {
    this.#model?.set(fields);
  }

  /** Shows one of the states that a control of the loaded figure offers, by its label; all else as at the start. */
  show(label: string): void {
    const controls = this.#model?.figure.controls ?? [];
    const states = controls.flatMap((one) => (one.kind === "states" ? one.options : []));
    const state = states.find((one) => one.label === label);
    if (!state) throw new Error(`the figure has no state "${label}"`);
    this.set({ ...this.#model?.figure.initial, ...state.fields } as Fields);
  }

  reset(): void {
    this.#model?.reset();
    const { view } = this.#model?.figure ?? {};
    if (this.#space && view?.kind === "3d") this.#space.look(view);
    this.#eyeMoved = false;
    if (this.#linked) history.replaceState(null, "", location.pathname + location.search);
    this.#redraw();
  }

  connectedCallback(): void {
    if (this.#ready) return;
    const start = (): void => {
      this.ready.catch((error: unknown) => this.#apologise(error));
    };
    if (this.#linked) {
      start();
      this.ready.then(() => this.scrollIntoView({ block: "center" })).catch(() => {});
      return;
    }
    const near = new IntersectionObserver(
      (entries) => {
        if (!entries.some((entry) => entry.isIntersecting)) return;
        near.disconnect();
        start();
      },
      { rootMargin: "500px" },
    );
    near.observe(this);
    this.#cleanUp.push(() => near.disconnect());
  }

  disconnectedCallback(): void {
    for (const clean of this.#cleanUp.splice(0)) clean();
  }

  get #linked(): boolean {
    return location.hash.startsWith(`#figure=${this.name}&`);
  }

  async #load(): Promise<void> {
    const base = new URL(this.getAttribute("base") ?? "./", document.baseURI).href;
    const missing = this.querySelector<HTMLElement>(".not-built");
    if (missing) {
      missing.setAttribute("role", "status");
      await untilBuilt(this.name, base, (words) => {
        if (missing.textContent !== words) missing.textContent = words;
      });
    }
    const [module, engine] = await Promise.all([
      import(`${base}figures/${this.name}.js`) as Promise<{ default: AnyFigure }>,
      startEngine(`${base}figures/${this.name}.wasm`),
    ]);
    const figure = module.default;
    const linked = decodeState(location.hash, this.name, engine.layout.inputs);
    const model = new FigureModel(figure, engine, linked?.fields);
    if (figure.view.kind === "3d") {
      const { SpaceView } = await import("./stage3.ts");
      this.#space = new SpaceView(figure.view);
    }
    this.#model = model;
    this.#view = this.#space ?? (figure.view.kind === "2d" ? new FlatView(figure.view) : undefined);
    this.#turnTo(linked?.eye);
    await this.#build(model);
    const follow = (): void => this.#follow();
    addEventListener("hashchange", follow);
    this.#cleanUp.push(() => removeEventListener("hashchange", follow));
  }

  #turnTo(eye: readonly [number, number] | undefined): void {
    if (!eye || !this.#space) return;
    this.#space.look({ azimuth: eye[0], elevation: eye[1] });
    this.#eyeMoved = true;
  }

  /** A link to this figure was followed while the page was open. */
  #follow(): void {
    const model = this.#model;
    if (!model) return;
    const linked = decodeState(location.hash, this.name, model.engine.layout.inputs);
    if (!linked) return;
    model.set({ ...model.figure.initial, ...linked.fields });
    this.#turnTo(linked.eye);
    this.#redraw();
    this.scrollIntoView({ block: "center" });
  }

  async #build(model: FigureModel): Promise<void> {
    const { figure } = model;
    const view = this.#view!;
    const hintId = freshId("hint");
    const drawing = svg("g", { class: "drawing", "aria-hidden": "true" });
    const grips = (figure.handles ?? []).map((handle) =>
      handle.kind === "stroke"
        ? new Stroke(handle, model, view, hintId)
        : new Grip(handle, model, view, hintId),
    );
    const stage = svg(
      "svg",
      { class: "stage", role: "group", "aria-label": figure.title },
      drawing,
      svg("g", {}, ...grips.map((grip) => grip.element)),
    );
    const controls = makeControls(model);
    const values = makeValues(model);
    const words = html("p", { class: "sentence", "aria-hidden": "true" });
    const spoken = html("p", { class: "spoken", "aria-live": "polite" });
    const hint = html("p", { class: "hint", id: hintId }, hintText(figure));
    const status = html("span", { class: "status", role: "status" });
    const buttons = html(
      "div",
      { class: "buttons" },
      button("Reset", () => this.reset()),
      button("Copy link", () => this.#copyLink(status)),
      status,
    );
    const picture = html("div", { class: "picture" }, stage as unknown as Node);
    if (this.#space) picture.append(this.#turnButtons(this.#space));
    const side = html("div", { class: "side" }, values.element, words, controls.element, buttons);
    const live = html("div", { class: "live-parts" }, picture, hint, side, spoken);

    const draw = onceAFrame(() => {
      const scene = new Scene();
      figure.draw(scene, model.input, model.output);
      drawing.innerHTML = shapesToSvg(view.project(scene));
      for (const grip of grips) grip.place();
    });
    this.#redraw = draw;
    let speaking: ReturnType<typeof setTimeout> | undefined;
    const changed = (): void => {
      values.refresh();
      controls.refresh();
      words.textContent = sentence(model);
      this.toggleAttribute("problem", model.problem !== "");
      draw();
    };
    const speakLater = (): void => {
      clearTimeout(speaking);
      speaking = setTimeout(() => {
        spoken.textContent = sentence(model);
      }, SPEAK_AFTER);
    };
    model.onChange(() => {
      changed();
      speakLater();
      this.dispatchEvent(new CustomEvent("contact-change", { bubbles: true }));
    });

    this.replaceChildren(live);
    const resize = (): void => {
      const width = Math.max(200, picture.clientWidth);
      const height = Math.round(width / stageAspect(figure, width));
      stage.setAttribute("viewBox", `0 0 ${width} ${height}`);
      view.resize(width, height);
      draw();
    };
    resize();
    changed();
    const observer = new ResizeObserver(resize);
    observer.observe(picture);
    this.#cleanUp.push(() => observer.disconnect());
    if (this.#space) {
      const { orbit } = await import("./stage3.ts");
      const turned = (): void => {
        this.#eyeMoved = true;
        draw();
      };
      this.#cleanUp.push(orbit(this.#space, stage, turned));
    }
    this.dispatchEvent(new CustomEvent("contact-change", { bubbles: true }));
  }

  #turnButtons(space: SpaceView): HTMLElement {
    const turn = (azimuth: number, elevation: number) => () => {
      const eye: Eye = space.eye;
      space.look({ azimuth: eye.azimuth + azimuth, elevation: eye.elevation + elevation });
      this.#eyeMoved = true;
      this.#redraw();
    };
    const group = html("div", { class: "turn", role: "group", "aria-label": "Turn the view" });
    for (const [sign, label, azimuth, elevation] of [
      ["←", "Turn the view left", 15, 0],
      ["→", "Turn the view right", -15, 0],
      ["↑", "Look from higher up", 0, 10],
      ["↓", "Look from lower down", 0, -10],
    ] as const) {
      const press = button(sign, turn(azimuth, elevation));
      press.setAttribute("aria-label", label);
      press.title = label;
      group.append(press);
    }
    return group;
  }

  async #copyLink(status: HTMLElement): Promise<void> {
    const eye = this.#space?.eye;
    const turned = this.#eyeMoved && eye ? ([eye.azimuth, eye.elevation] as const) : undefined;
    // In full: a page to embed has the lesson's address as its base.
    const state = encodeState(this.name, this.input ?? {}, turned);
    history.replaceState(null, "", location.pathname + location.search + state);
    try {
      await navigator.clipboard.writeText(location.href);
      status.textContent = "Link copied.";
    } catch {
      status.textContent = "The link is in the address bar.";
    }
  }

  #apologise(error: unknown): void {
    console.warn(`figure ${this.name}:`, error);
    if (this.querySelector(".not-live")) return;
    this.append(
      html(
        "p",
        { class: "not-live", role: "status" },
        this.querySelector("svg, img, canvas")
          ? "The live figure could not be loaded, so this is a picture of how it starts."
          : "The live figure could not be loaded.",
      ),
    );
  }
}

function hintText(figure: AnyFigure): string {
  const turn = figure.view.kind === "3d" ? " Drag the background to turn the view." : "";
  if (figure.handles.length === 0) return turn.trim();
  if (figure.handles.some(({ kind }) => kind === "stroke")) return KEYS_STROKE;
  const points = figure.handles.some(({ kind }) => kind === "point");
  const keys = figure.view.kind === "3d" && points ? KEYS_3D : KEYS_2D;
  return `Drag a ringed point.${turn} ${keys}; Shift for larger steps, Alt for smaller.`;
}

/** Width over height of the stage: a narrow one is made taller, so that there is room to drag. */
export function stageAspect(figure: AnyFigure, width: number): number {
  const aspect = figure.aspect ?? 1.35;
  return width < 420 ? Math.min(aspect, 1.1) : aspect;
}
