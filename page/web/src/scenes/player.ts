// The scene player in the page: scenes to pick and a field to paste one, the picture with its clock,
// the numbers of both runs, and the plan with its switches. A worker computes; nothing here waits.

import type { SceneList } from "../contact-player.ts";
import { button, freshId, html, onceAFrame } from "../dom.ts";
import { pretty } from "../numbers.ts";
import type { Frame, FromWorker, Side, ToWorker } from "./messages.ts";
import { isMade, PlayerModel } from "./model.ts";
import { nextTime, PACES, paceFor } from "./pace.ts";
import { Picture } from "./picture.ts";
import { paintOn, whenRepainted } from "./stage.ts";

const OWN = "own";
const PATIENCE = 3000; // ms
const STEP = 40; // pictures from the beginning of a scene to its end, with "One step"

type Answer<Kind extends FromWorker["kind"]> = Extract<FromWorker, { kind: Kind }>;

export class Player {
  readonly element: HTMLElement;
  readonly model = new PlayerModel();
  readonly #base: string;
  /** Where the scenes are. */
  readonly #scenes: string;
  readonly #changed: () => void;
  #worker: Worker | undefined;
  #awaited: { resolve: () => void; reject: (error: Error) => void } | undefined;
  #picture: Picture | undefined;
  /** Whether the clock runs; whether the worker is at work. */
  #playing = false;
  #busy = false;
  /** Since when. */
  #since = 0;
  #ended = "";
  /** What stopped the C++, until something else is asked for. */
  #note = "";
  /** Name and text of what was opened last. */
  #opening: [name: string, text: string] = ["", ""];
  #pace = 1;
  #last = 0;
  readonly #cleanUp: (() => void)[] = [];

  readonly #pick: HTMLSelectElement;
  readonly #about = html("p", { class: "about" });
  readonly #text: HTMLTextAreaElement;
  readonly #own: HTMLDetailsElement;
  readonly #wrong = html("pre", { class: "wrong", role: "alert", tabindex: "0" });
  readonly #canvas = html("canvas", { class: "stage", role: "img" });
  readonly #legend = html("p", { class: "legend" });
  readonly #play: HTMLButtonElement;
  readonly #stepOn: HTMLButtonElement;
  readonly #paces: HTMLSelectElement;
  readonly #clock = html("output", { class: "clock" });
  readonly #composed = html("details", { class: "composed" });
  readonly #apart = html("p", { class: "apart" });
  readonly #numbers = html("table", { class: "computed" });
  readonly #status = html("p", { class: "status", role: "status" });
  readonly #plan = html("tbody");
  readonly #notices = html("div", { class: "notices" });
  readonly #stepSize: HTMLInputElement;
  readonly #asPlanned: HTMLButtonElement;
  readonly #paint: () => void;

  constructor(list: SceneList, base: string, scenes: string, changed: () => void) {
    this.#base = base;
    this.#scenes = scenes;
    this.#changed = changed;
    this.#paint = onceAFrame(() => this.#draw());
    this.#pick = html("select", { id: freshId("scene") });
    for (const { name } of list.scenes)
      this.#pick.append(html("option", { value: name }, name.replaceAll("_", " ")));
    this.#pick.append(html("option", { value: OWN }, "my own (the text below)"));
    this.#pick.value = list.first;
    this.#pick.addEventListener("change", () => void this.#picked());

    const textId = freshId("scene-text");
    this.#text = html("textarea", { id: textId, rows: "14", spellcheck: "false", wrap: "off" });
    this.#wrong.hidden = true;
    this.#wrong.setAttribute("aria-label", "What is wrong with the scene");
    this.#own = html(
      "details",
      { class: "own" },
      html("summary", {}, "The scene as text: change it, or paste another"),
      html("label", { for: textId }, "Scene, as JSON"),
      " (",
      html("a", { href: new URL("../schema.json", scenes).href }, "its JSON Schema"),
      ")",
      this.#text,
      html(
        "div",
        { class: "buttons" },
        button("Run this text", () => {
          this.#note = "";
          void this.#open(OWN, this.#text.value);
        }),
      ),
    );

    this.#play = button("Play", () => this.#toggle(), "play");
    this.#stepOn = button("One step", () => this.#oneStep());
    const restart = button("From the start", () => this.#again());
    this.#paces = html("select", { "aria-label": "Seconds of the scene in a second" });
    for (const pace of PACES)
      this.#paces.append(html("option", { value: String(pace) }, `× ${pace}`));
    this.#paces.addEventListener("change", () => {
      this.#pace = Number(this.#paces.value);
    });

    this.#stepSize = html("input", { type: "text", inputmode: "decimal", id: freshId("step") });
    this.#stepSize.addEventListener("change", () => this.#stepChanged());
    this.#asPlanned = button("All as planned", () => {
      this.model.forget();
      this.#stepSize.value = "";
      this.#again();
    });
    const heads = [
      "Effect",
      "In the second run",
      "What the plan says, the error accepted, the cost",
    ];
    const plan = html(
      "table",
      { class: "plan docutils" },
      html("caption", {}, "The plan: which effects are on, and the numbers that decide"),
      html("thead", {}, html("tr", {}, ...heads.map((head) => html("th", { scope: "col" }, head)))),
      this.#plan,
    );
    const wide = html("div", { class: "wide", tabindex: "0", role: "region" }, plan);
    wide.setAttribute("aria-label", "The plan, may scroll sideways");
    this.element = html(
      "div",
      { class: "live-parts" },
      html(
        "div",
        { class: "choose" },
        html("label", { for: this.#pick.id }, "Scene"),
        this.#pick,
        this.#about,
        this.#own,
        this.#wrong,
      ),
      html(
        "div",
        { class: "show" },
        html(
          "div",
          { class: "seen" },
          html("div", { class: "picture" }, this.#canvas, this.#turnButtons()),
          this.#legend,
          html(
            "div",
            { class: "buttons" },
            this.#play,
            this.#stepOn,
            restart,
            html("label", { class: "pace" }, "Pace ", this.#paces),
            this.#clock,
          ),
        ),
        html("div", { class: "side" }, this.#numbers, this.#apart, this.#composed, this.#status),
      ),
      html(
        "div",
        { class: "buttons switches" },
        html("label", { for: this.#stepSize.id }, "Step of the second run, s"),
        this.#stepSize,
        this.#asPlanned,
      ),
      this.#notices,
      wide,
    );
    this.#dragToTurn();
  }

  /** Loads the C++ and the scene that is picked at first. */
  async start(): Promise<void> {
    await this.#startWorker();
    await this.#picked();
  }

  /** It stands in the page now. */
  shown(): void {
    this.#cleanUp.push(whenRepainted(this.#canvas.parentElement!, this.#paint));
    this.#paint();
    this.#pick.focus({ preventScroll: true });
  }

  close(): void {
    this.#pause();
    this.#worker?.terminate();
    for (const clean of this.#cleanUp.splice(0)) clean();
  }

  // The worker.

  #startWorker(): Promise<void> {
    this.#worker?.terminate();
    this.#busy = false;
    this.#worker = new Worker(`${this.#base}scenes-worker.js`, { type: "module" });
    this.#worker.addEventListener("message", ({ data }: MessageEvent<FromWorker>) =>
      this.#receive(data),
    );
    this.#worker.addEventListener("error", ({ message }) => this.#broken(message));
    return new Promise((resolve, reject) => {
      this.#awaited = { resolve, reject };
      this.#send({ do: "load", wasm: `${this.#base}scenes/player.wasm` });
    });
  }

  #send(message: ToWorker): void {
    if (!this.#busy) this.#since = performance.now();
    this.#busy = true;
    this.#worker?.postMessage(message);
  }

  #receive(message: FromWorker): void {
    switch (message.kind) {
      case "loaded":
        this.#busy = false;
        this.#awaited?.resolve();
        this.#awaited = undefined;
        break;
      case "opened":
        this.#opened(message);
        break;
      case "wrong":
        this.#sayWrong(message.lines);
        break;
      case "switched":
        this.#begin(message.sides, message.frames);
        break;
      case "frame":
        this.#busy = false;
        this.model.show(message.frames, message.took);
        this.#shown();
        break;
      case "composed":
        this.model.composed(message.side, message.composition);
        this.#tellCompositions();
        break;
      case "ended":
        this.#busy = false;
        this.#ended = message.words;
        this.#pause();
        this.model.frames = message.frames;
        this.#shown();
        break;
      case "broken":
        this.#broken(message.words);
        break;
    }
  }

  /** The C++ stopped. It restarts with the same scene and no effect switched. */
  #broken(words: string): void {
    this.#busy = false;
    this.#pause();
    if (this.#awaited) {
      this.#awaited.reject(new Error(words));
      this.#awaited = undefined;
      return;
    }
    const again = this.model.isOverridden ? this.#opening : undefined;
    const started = this.#startWorker().then(() => (again ? this.#open(...again) : undefined));
    started.catch((error: unknown) => console.warn("scene player:", error));
    this.#note = again
      ? `The second run stopped: ${words}. Everything is as planned again.`
      : `The simulation stopped: ${words}. Pick a scene to go on.`;
    this.#status.textContent = this.#note;
  }

  // The scene.

  async #picked(): Promise<void> {
    const name = this.#pick.value;
    if (name === OWN) {
      this.#own.open = true;
      this.#text.focus();
      return;
    }
    this.#note = "";
    const response = await fetch(`${this.#scenes}${name}.json`);
    if (!response.ok) {
      this.#sayWrong(`${name}.json: ${response.status} ${response.statusText}`);
      return;
    }
    const text = await response.text();
    if (this.#pick.value !== name) return;
    this.#text.value = text;
    await this.#open(name, text);
  }

  async #open(name: string, text: string): Promise<void> {
    this.#pause();
    this.#opening = [name, text];
    this.#pick.value = name;
    this.model.forget();
    this.#stepSize.value = "";
    this.#wrong.hidden = true;
    this.#status.textContent = this.#note || "Planning …";
    const file = name === OWN ? "your scene" : `${name}.json`;
    // A scene before this one may be too much for any patience.
    if (this.#busy && performance.now() - this.#since > PATIENCE) await this.#startWorker();
    this.#send({ do: "open", text, file, overrides: this.model.overrides });
  }

  /** The text is no scene: what was there before stays. */
  #sayWrong(lines: string): void {
    this.#busy = false;
    this.#wrong.textContent = lines;
    this.#wrong.hidden = false;
    this.#status.textContent = "";
  }

  #opened({ opened, frames }: Answer<"opened">): void {
    this.model.open(opened);
    const { scene } = opened;
    this.#about.textContent = scene.about;
    this.#canvas.setAttribute("aria-label", `${scene.name}: ${scene.about}`);
    this.#pace = paceFor(scene.duration);
    this.#paces.value = String(this.#pace);
    this.#picture = frames[0] ? new Picture(scene, frames[0]) : undefined;
    this.#begin(opened.sides, frames);
  }

  /** Both runs are at their beginning. */
  #begin(sides: readonly Side[], frames: readonly Frame[]): void {
    this.#busy = false;
    this.#ended = "";
    this.model.begin(sides, frames);
    this.#tellPlan();
    this.#tellCompositions();
    this.#legend.replaceChildren(
      html("span", { class: "first" }, "filled: as planned"),
      ...(sides.length > 1
        ? [" · ", html("span", { class: "second" }, "dashed: as you switch it")]
        : []),
    );
    this.#shown();
  }

  #again(): void {
    this.#note = "";
    this.#send({ do: "switch", overrides: this.model.overrides });
  }

  #stepChanged(): void {
    const text = this.#stepSize.value.trim();
    const value = Number(text);
    const good = text === "" || (Number.isFinite(value) && value > 0);
    this.#stepSize.toggleAttribute("aria-invalid", !good);
    if (!good) return;
    this.model.step = text === "" ? undefined : value;
    this.#again();
  }

  // The clock.

  #toggle(): void {
    if (this.#playing) this.#pause();
    else if (this.#atEnd) {
      this.#playing = true;
      this.#again();
    } else {
      this.#playing = true;
      this.#next();
    }
    this.#last = performance.now();
    this.#tellClock();
  }

  #pause(): void {
    this.#playing = false;
    this.#tellClock();
  }

  get #atEnd(): boolean {
    const { scene } = this.model.opened ?? {};
    return this.#ended !== "" || (scene !== undefined && this.model.time >= scene.duration);
  }

  #oneStep(): void {
    const { scene } = this.model.opened ?? {};
    if (!scene || this.#busy || this.#atEnd) return;
    this.#pause();
    this.#runTo(Math.min(scene.duration, this.model.time + scene.duration / STEP));
  }

  #runTo(until: number): void {
    if (this.model.frames.length === 0) return;
    this.#send({ do: "run", until });
  }

  /** Asks for the next picture when the browser is ready for one. */
  #next(): void {
    requestAnimationFrame((now) => {
      const { scene } = this.model.opened ?? {};
      if (!this.#playing || this.#busy || !scene || !this.element.isConnected) return;
      const elapsed = (now - this.#last) / 1000;
      this.#last = now;
      this.#runTo(nextTime(this.model.time, elapsed, this.#pace, scene.duration));
    });
  }

  #shown(): void {
    const [first] = this.model.frames;
    if (first) this.#picture?.follow(first);
    if (this.#playing && this.#atEnd) this.#pause();
    this.#tellNumbers();
    this.#tellClock();
    this.#paint();
    this.#changed();
    if (this.#playing && !this.#busy) this.#next();
  }

  // What is said.

  #tellClock(): void {
    const { model } = this;
    this.#play.textContent = this.#playing ? "Pause" : this.#atEnd ? "Play again" : "Play";
    const runs = model.frames.length > 0;
    this.#play.disabled = this.#stepOn.disabled = !runs;
    const { duration = 0 } = model.opened?.scene ?? {};
    this.#clock.textContent = runs
      ? `t = ${model.time.toPrecision(4)} s of ${pretty(duration)} s`
      : "";
  }

  #tellNumbers(): void {
    const { model } = this;
    const heads = model.frames.map(({ side }) => (side === 0 ? "as planned" : "as switched"));
    this.#numbers.replaceChildren(
      html("caption", {}, "At this moment"),
      html(
        "thead",
        {},
        html("tr", {}, html("td"), ...heads.map((head) => html("th", { scope: "col" }, head))),
      ),
      html(
        "tbody",
        {},
        ...model
          .quantities()
          .map(({ name, values }) =>
            html(
              "tr",
              {},
              html("th", { scope: "row" }, name),
              ...values.map((value) => html("td", {}, value)),
            ),
          ),
      ),
    );
    this.#apart.textContent = model.apart();
    const refused = model.sides.flatMap((side, i) =>
      isMade(side) || !("refused" in side)
        ? []
        : `${i === 0 ? "As planned" : "As switched"} it cannot be run: ${side.refused}.`,
    );
    const words = [...refused, this.#ended, this.#note].filter(Boolean).join(" ");
    if (this.#status.textContent !== words) this.#status.textContent = words;
  }

  #tellCompositions(): void {
    this.#composed.replaceChildren(
      html("summary", {}, "What each run is composed of"),
      ...this.model.compositions().map((words) => html("p", {}, words)),
      html(
        "p",
        {},
        "In the page, runs from event to event always know sizes and restitution; no bit depends on it.",
      ),
    );
  }

  #tellPlan(): void {
    const { model } = this;
    const held = document.activeElement?.getAttribute("data-effect");
    this.#plan.replaceChildren(
      ...model.rows().map((row) => {
        const switching = html("td", {}, row.on === undefined ? row.beside : "");
        if (row.on !== undefined) {
          const name = row.effect.replaceAll("-", " ");
          const press = html("input", {
            type: "checkbox",
            role: "switch",
            "data-effect": row.effect,
            "aria-label": `${name}, in the second run`,
          });
          press.checked = row.on;
          press.addEventListener("change", () => {
            model.set(row.effect, press.checked);
            this.#again();
          });
          const forced = row.overridden ? " forced" : "";
          switching.append(html("label", {}, press, `${row.on ? " on" : " off"}${forced}`));
        }
        const why = html("td", {}, html("p", {}, row.why));
        for (const line of row.says) why.append(html("p", { class: "says" }, line));
        why.append(html("p", {}, row.account));
        return html(
          "tr",
          row.overridden ? { class: "overridden" } : {},
          html(
            "th",
            { scope: "row" },
            row.effect.replaceAll("-", " "),
            " ",
            html("span", { class: row.planned === "off" ? "off" : "on" }, row.planned),
          ),
          switching,
          why,
        );
      }),
    );
    this.#notices.replaceChildren(
      ...model.accounts().map((line) => html("p", { class: "accepted" }, line)),
      ...(model.plan?.notices ?? []).map((notice) => html("p", {}, notice)),
    );
    this.#asPlanned.disabled = !model.isOverridden;
    if (held) this.#plan.querySelector<HTMLElement>(`[data-effect="${CSS.escape(held)}"]`)?.focus();
  }

  // The picture.

  #draw(): void {
    if (!this.element.isConnected) return;
    const width = Math.max(200, this.#canvas.parentElement!.clientWidth);
    const height = Math.round(width / (width < 420 ? 1.1 : 1.5));
    const pieces = this.#picture?.pieces(this.model.frames, width, height);
    paintOn(this.#canvas, width, height, pieces ?? []);
  }

  #turn(azimuth: number, elevation: number): void {
    const eye = this.#picture?.eye;
    if (!eye) return;
    this.#picture?.look({
      azimuth: eye.azimuth + azimuth,
      elevation: eye.elevation + elevation,
    });
    this.#paint();
  }

  #turnButtons(): HTMLElement {
    const group = html("div", { class: "turn", role: "group", "aria-label": "Turn the view" });
    for (const [sign, label, azimuth, elevation] of [
      ["←", "Turn the view left", 15, 0],
      ["→", "Turn the view right", -15, 0],
      ["↑", "Look from higher up", 0, 10],
      ["↓", "Look from lower down", 0, -10],
    ] as const) {
      const press = button(sign, () => this.#turn(azimuth, elevation));
      press.setAttribute("aria-label", label);
      press.title = label;
      group.append(press);
    }
    return group;
  }

  #dragToTurn(): void {
    let from: readonly [number, number] | undefined;
    this.#canvas.addEventListener("pointerdown", (event) => {
      from = [event.clientX, event.clientY];
      this.#canvas.setPointerCapture(event.pointerId);
    });
    this.#canvas.addEventListener("pointermove", (event) => {
      if (!from) return;
      this.#turn((from[0] - event.clientX) / 3, (event.clientY - from[1]) / 3);
      from = [event.clientX, event.clientY];
    });
    for (const end of ["pointerup", "pointercancel"] as const)
      this.#canvas.addEventListener(end, () => {
        from = undefined;
      });
  }
}
