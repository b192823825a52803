// <contact-engines base="…" not-built>…the recorded answers…</contact-engines>
//
// The page "Ask the engines". The recorded answers are there without a script. This adds the reader's settings, a button to
// each question, and a column for the answers that the engines give here.
//
// For other code on the page: the event `contact-change` after each answer, and the attribute `asking` meanwhile.

import { button, html } from "./dom.ts";
import type { Choice, FromWorker, ToWorker } from "./engines/messages.ts";
import { errorWritten, timeText, valueWritten, type Written } from "./engines/words.ts";
import { untilBuilt } from "./pending.ts";

/** As page/wasm/build.mjs names them. */
const OF_THE_BOOK = ["20_scenes/scene_player", "engines/queries"];

type Answered = Extract<FromWorker, { kind: "answer" }>;

export class ContactEngines extends HTMLElement {
  #worker: Worker | undefined;
  #waiting: AbortController | undefined;
  #built = false;
  #settings: HTMLElement | undefined;
  readonly #status = html("p", { class: "status", role: "status" });
  readonly #step = numberField("0.0001", "0.1", "0.0001");
  readonly #iterations = numberField("1", "1000", "1");
  readonly #continuous = html("input", { type: "checkbox" });
  readonly #strict = html("input", { type: "checkbox" });
  #buttons: HTMLButtonElement[] = [];
  readonly #stop = button("Stop", () => this.#stopAsking("Stopped."));

  connectedCallback(): void {
    if (this.#built) return;
    this.#built = true;
    const sections = [...this.querySelectorAll<HTMLElement>("section.asked")];
    for (const section of sections) this.#addTo(section);
    const all = button("Ask all questions here", () =>
      this.#ask(sections.map((section) => section.dataset.question!)),
    );
    this.#buttons.push(all);
    this.#stop.disabled = true;
    this.#settings = this.#form(all);
    sections[0]?.before(this.#settings);
  }

  disconnectedCallback(): void {
    this.#waiting?.abort();
    this.#worker?.terminate();
  }

  #form(all: HTMLButtonElement): HTMLElement {
    const labelled = (field: HTMLElement, text: string, after = ""): HTMLElement =>
      html("label", {}, `${text} `, field, after);
    const box = (field: HTMLElement, text: string): HTMLElement =>
      html("label", {}, field, ` ${text}`);
    return html(
      "fieldset",
      { class: "engine-settings" },
      html("legend", {}, "Settings for what you ask here"),
      labelled(this.#step, "Step", " s"),
      labelled(this.#iterations, "Iterations"),
      box(this.#continuous, "continuous detection of fast bodies"),
      box(this.#strict, "no thresholds"),
      html("p", {}, "An empty field leaves each engine its default."),
      html("div", { class: "buttons" }, all, this.#stop),
      this.#status,
    );
  }

  #addTo(section: HTMLElement): void {
    const name = section.dataset.question!;
    const heads = [...section.querySelectorAll("thead tr")];
    heads[0]?.firstElementChild?.after(
      html("th", { scope: "colgroup", colspan: "3" }, "asked here"),
    );
    heads[1]?.firstElementChild?.after(
      ...["answer", "error", "time"].map((text) => html("th", { scope: "col" }, text)),
    );
    for (const row of section.querySelectorAll("tbody tr"))
      row.firstElementChild?.after(html("td", { class: "here", colspan: "3" }));
    const here = button("Ask them here", () => this.#ask([name]));
    this.#buttons.push(here);
    section.append(html("div", { class: "buttons" }, here));
  }

  #choice(): Choice | undefined {
    for (const field of [this.#step, this.#iterations])
      if (!field.reportValidity()) return undefined;
    return {
      ...(this.#step.value && { step: this.#step.valueAsNumber }),
      ...(this.#iterations.value && { iterations: this.#iterations.valueAsNumber }),
      continuous: this.#continuous.checked,
      strict: this.#strict.checked,
    };
  }

  #ask(questions: readonly string[]): void {
    const choice = this.#choice();
    if (!choice) return;
    for (const name of questions)
      for (const cell of this.#section(name)?.querySelectorAll("td.here") ?? [])
        cell.replaceChildren();
    const base = new URL(this.getAttribute("base") ?? "./", document.baseURI).href;
    // Beside what was pressed, since the page is long.
    const at = questions.length === 1 ? this.#section(questions[0]!) : this.#settings;
    at?.querySelector(".buttons")?.after(this.#status);
    this.#setAsking(true);
    this.#status.textContent = "Loading the engines …";
    this.#send({ base, questions, choice }).catch((error: unknown) => {
      if (!(error instanceof DOMException && error.name === "AbortError"))
        this.#stopAsking(`The engines could not be loaded: ${String(error)}`);
    });
  }

  /** While `./contact serve` builds, the book's own modules may not be there yet. */
  async #send(message: ToWorker): Promise<void> {
    const waiting = new AbortController();
    this.#waiting = waiting;
    const say = (words: string): void => {
      this.#status.textContent = words;
    };
    if (this.hasAttribute("not-built"))
      for (const name of OF_THE_BOOK) await untilBuilt(name, message.base, say, waiting.signal);
    waiting.signal.throwIfAborted();
    this.#worker ??= this.#start(message.base);
    this.#worker.postMessage(message);
  }

  #start(base: string): Worker {
    const worker = new Worker(`${base}engines-worker.js`, { type: "module" });
    worker.onmessage = (event: MessageEvent<FromWorker>) => this.#told(event.data);
    worker.onerror = () =>
      this.#stopAsking("The engines could not be loaded. Reload the page and press again.");
    return worker;
  }

  #told(message: FromWorker): void {
    if (message.kind === "loading") this.#status.textContent = `Loading ${message.engine} …`;
    if (message.kind === "failed")
      this.#status.textContent = `${message.engine} could not be loaded: ${message.why}`;
    if (message.kind === "answer") this.#show(message);
    if (message.kind === "done") {
      this.#setAsking(false);
      this.#status.textContent = "All have answered.";
    }
    this.dispatchEvent(new CustomEvent("contact-change", { bubbles: true }));
  }

  #show({ question, engine, answer, settings }: Answered): void {
    this.#status.textContent = `Asking: ${question} …`;
    const row = this.#section(question)?.querySelector(`tr[data-engine="${CSS.escape(engine)}"]`);
    if (!row) return;
    for (const cell of row.querySelectorAll("td.here")) cell.remove();
    const head = row.firstElementChild;
    if (!answer) {
      head?.after(html("td", { class: "here not-asked", colspan: "3" }, "–"));
      return;
    }
    const used = settings && engine !== "book" ? settingsText(settings) : "";
    const value = cell(valueWritten(answer.value));
    if (answer.failed) value.textContent = answer.failed;
    value.title = used;
    head?.after(value, cell(errorWritten(answer.error)), cell({ number: timeText(answer.time) }));
  }

  #section(name: string): Element | null {
    return this.querySelector(`section.asked[data-question="${CSS.escape(name)}"]`);
  }

  #setAsking(asking: boolean): void {
    this.toggleAttribute("asking", asking);
    for (const one of this.#buttons) one.disabled = asking;
    this.#stop.disabled = !asking;
  }

  #stopAsking(words: string): void {
    this.#waiting?.abort();
    this.#worker?.terminate();
    this.#worker = undefined;
    this.#setAsking(false);
    this.#status.textContent = words;
  }
}

function cell({ number, power }: Written): HTMLElement {
  const made = html("td", { class: "here" }, power ? `${number} · 10` : number);
  if (power) made.append(html("sup", {}, power));
  return made;
}

function settingsText({ step, iterations }: { step: number; iterations: number }): string {
  return `step ${Number(step.toPrecision(4))} s, ${iterations} iterations`;
}

function numberField(min: string, max: string, step: string): HTMLInputElement {
  return html("input", { type: "number", min, max, step, placeholder: "default" });
}
