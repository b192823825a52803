// <contact-ladder name="02_triangles" base="…" failures="….json"><script type="application/json">{…}</script>
//   …picture and table… </contact-ladder>
//
// The book's own measurement is there without a script. This makes its cells answer: a pressed one
// shows its methods in a plot and an input on which the method fails, and opens that input in the
// chapter's figure. "Run it here" times the same C++, compiled to WebAssembly, in the reader's
// browser and draws it beside.

import type { ContactFigure } from "./contact-figure.ts";
import { button, freshId, html } from "./dom.ts";
import { type Cell, cellOf, failureOf, scatter, summary } from "./ladder-cell.ts";
import {
  KINDS,
  type Kind,
  kindOf,
  type LadderFailure,
  type LadderFailures,
  type LadderMethod,
  type LadderResult,
  type LadderRow,
  methodName,
  type WorkerMessage,
  withPeers,
} from "./ladder-data.ts";
import { ladderPicture } from "./ladder-picture.ts";
import { bookNumbers, ownNumbers } from "./ladder-tables.ts";
import { untilBuilt } from "./pending.ts";

/** Rows down and columns to the right. */
const ARROWS: Record<string, readonly [number, number]> = {
  ArrowUp: [-1, 0],
  ArrowDown: [1, 0],
  ArrowLeft: [0, -1],
  ArrowRight: [0, 1],
};

export class ContactLadder extends HTMLElement {
  #worker: Worker | undefined;
  #waiting: AbortController | undefined;
  #rows: LadderRow[] = [];
  #peers: readonly LadderMethod[] = [];
  #result: LadderResult | undefined;
  #picture: HTMLElement | undefined;
  #panel = html("section", { class: "cell", id: freshId("cell"), tabindex: "-1" });
  #opened: Cell | undefined;
  #hidden = new Set<Kind>();

  /** The reader's own measurements so far. */
  get rows(): readonly LadderRow[] {
    return this.#rows;
  }

  connectedCallback(): void {
    const script = this.querySelector(':scope > script[type="application/json"]');
    if (this.#result || !script?.textContent) return;
    this.#result = JSON.parse(script.textContent) as LadderResult;
    this.#build(this.#result);
  }

  disconnectedCallback(): void {
    this.#waiting?.abort();
    this.#worker?.terminate();
  }

  #build(result: LadderResult): void {
    for (const scrolling of this.querySelectorAll<HTMLElement>(".wide:not([role])"))
      mayScroll(scrolling, "Measurements, may scroll sideways");
    const numbers = this.querySelector<HTMLDetailsElement>(":scope > details");
    numbers?.addEventListener("toggle", () => {
      if (numbers.querySelector("table")) return;
      const place = mayScroll(html("div", { class: "wide" }), "Table of measurements");
      place.append(bookNumbers(result));
      numbers.append(place);
    });
    const picture =
      this.querySelector<HTMLElement>(":scope > .picture") ?? html("div", { class: "picture" });
    this.#picture = picture;
    this.#panel.hidden = true;
    const here = this.#runner(result);
    picture.before(this.#filter(result));
    picture.after(this.#panel, here);
    picture.addEventListener("click", (event) => this.#pressed(event.target as Element));
    picture.addEventListener("keydown", (event) => this.#key(event));
    for (const name of ["pointerover", "focusin"] as const)
      this.addEventListener(name, (event) => this.#light(event.target as Element));
    for (const name of ["pointerleave", "focusout"] as const)
      this.addEventListener(name, () => this.#light(undefined));
    this.#draw();
  }

  /** The book's measurement and, after a run, the peers. */
  #shown(): LadderResult {
    return withPeers(this.#result!, this.#peers, this.#rows);
  }

  #draw(): void {
    const { activeElement } = document;
    const at =
      activeElement && this.#picture?.contains(activeElement) ? where(activeElement) : undefined;
    const tables = (): Element[] => [...this.#picture!.querySelectorAll(".scrolling")];
    const scrolled = tables().map(({ scrollLeft }) => scrollLeft);
    this.#picture!.innerHTML = ladderPicture(this.#shown(), { here: this.#rows, pressable: true });
    for (const [i, table] of tables().entries()) table.scrollLeft = scrolled[i] ?? 0;
    this.#apply();
    if (at) this.#cell(at.method, at.family)?.focus();
  }

  /** What the filter hides, which cell is open, and which one the Tab key reaches. */
  #apply(): void {
    const rows = [...this.#picture!.querySelectorAll<HTMLElement>("tbody tr")];
    for (const row of rows) row.hidden = this.#hidden.has(row.dataset.kind as Kind);
    const opened = this.#opened;
    const pressed = opened && this.#cell(opened.method.id, opened.family.id);
    for (const each of this.#picture!.querySelectorAll("tbody button")) {
      each.setAttribute("aria-controls", this.#panel.id);
      each.setAttribute("aria-expanded", String(each === pressed));
    }
    this.#reach(pressed ?? this.#picture!.querySelector("tbody tr:not([hidden]) button"));
  }

  #reach(cell: Element | null | undefined): void {
    for (const each of this.#picture!.querySelectorAll<HTMLElement>("tbody button"))
      each.tabIndex = each === cell ? 0 : -1;
  }

  #cell(method: string, family: string): HTMLButtonElement | null {
    return this.#picture!.querySelector<HTMLButtonElement>(
      `tr[data-method="${CSS.escape(method)}"] td[data-family="${CSS.escape(family)}"] button`,
    );
  }

  #filter(result: LadderResult): HTMLElement {
    const present = KINDS.filter((kind) => result.methods.some((each) => kindOf(each) === kind));
    const choices = present.map((kind) => {
      const box = html("input", { type: "checkbox", checked: "" });
      box.addEventListener("change", () => {
        if (box.checked) this.#hidden.delete(kind);
        else this.#hidden.add(kind);
        this.#apply();
      });
      return html("label", {}, box, ` ${kind}`);
    });
    const legend = html("legend", {}, "Methods in");
    return html("fieldset", { class: "filter" }, legend, ...choices);
  }

  /** The row and the column of what is pointed at, and the row's points in the plot. */
  #light(target: Element | undefined): void {
    for (const lit of this.querySelectorAll(".lit")) lit.classList.remove("lit");
    const method = target?.closest<HTMLElement>("[data-method]")?.dataset.method;
    const family = target?.closest<HTMLElement>("[data-family]")?.dataset.family;
    const light = (name: string, value: string | undefined): void => {
      if (value === undefined) return;
      for (const each of this.querySelectorAll(`[data-${name}="${CSS.escape(value)}"]`))
        each.classList.add("lit");
    };
    light("method", method);
    light("family", family);
  }

  /** Arrow keys go from cell to cell. */
  #key(event: KeyboardEvent): void {
    const from = (event.target as Element).closest("td");
    const row = from?.parentElement;
    if (!from?.dataset.family || !row) return;
    const rows = [
      ...this.#picture!.querySelectorAll<HTMLTableRowElement>("tbody tr:not([hidden])"),
    ];
    const cells = [...row.querySelectorAll("td[data-family]")];
    const [down, right] = ARROWS[event.key] ?? [0, 0];
    if (!down && !right) return;
    event.preventDefault();
    const to = rows[rows.indexOf(row as HTMLTableRowElement) + down];
    const next = to?.querySelectorAll("td[data-family]")[cells.indexOf(from) + right];
    const press = next?.querySelector("button");
    if (!press) return;
    this.#reach(press);
    press.focus();
  }

  #pressed(target: Element): void {
    const at = target.closest("button") ? where(target) : undefined;
    if (!at) return;
    const again = this.#opened?.method.id === at.method && this.#opened.family.id === at.family;
    this.#opened = again ? undefined : cellOf(this.#shown(), this.#rows, at.method, at.family);
    this.#show();
    this.#apply();
    if (this.#opened?.row.fails && !this.#opened.row.failure) void this.#loadFailures();
  }

  /** Puts the failing inputs into their rows, and into the cell that is open by then. */
  async #loadFailures(): Promise<void> {
    try {
      const answer = await fetch(
        new URL(this.getAttribute("failures") ?? "./", document.baseURI).href,
      );
      if (!answer.ok) throw new Error(`${answer.url}: ${answer.status}`);
      const failing = (await answer.json()) as LadderFailures;
      const results = this.#result!.results.map((row) => {
        const failure = failing[`${row.family} ${row.method}`];
        return failure ? { ...row, failure } : row;
      });
      this.#result = { ...this.#result!, results };
    } catch (error) {
      console.warn(`ladder ${this.#result!.ladder}:`, error);
      const said = this.#panel.querySelector(".failing");
      if (said)
        said.textContent =
          "The input could not be loaded. Close, and press the cell again to try once more.";
      return;
    }
    this.#renew();
  }

  /** The open cell, with what is known by now. */
  #renew(): void {
    if (!this.#opened) return;
    const { method, family } = this.#opened;
    this.#opened = cellOf(this.#shown(), this.#rows, method.id, family.id);
    this.#show();
  }

  #show(): void {
    const cell = this.#opened;
    this.#panel.hidden = !cell;
    if (!cell) return;
    const title = `${methodName(cell.method)}: ${cell.family.title}`;
    this.#panel.setAttribute("aria-label", title);
    const close = button("Close", () => {
      const from = this.#opened;
      this.#opened = undefined;
      this.#show();
      this.#apply();
      if (from) this.#cell(from.method.id, from.family.id)?.focus();
    });
    const buttons = html("div", { class: "buttons" });
    const failure = cell.row.failure;
    const figure = failure?.figure ? this.#figure(failure.figure) : undefined;
    if (failure && figure)
      buttons.append(button("Open in the figure", () => void this.#open(figure, failure, title)));
    buttons.append(close);
    this.#panel.innerHTML = `<div class="told"><h3></h3><p>${summary(cell)}</p>${failureOf(cell)}</div>${scatter(this.#shown(), this.#rows, cell)}`;
    this.#panel.querySelector("h3")!.textContent = title;
    this.#panel.querySelector(".told")!.append(buttons);
  }

  /** The live figure of the ladder's chapter, if it is on this page. */
  #figure(name: string): ContactFigure | undefined {
    const full = `${this.#result!.ladder}/${name}`;
    return (
      document.querySelector<ContactFigure>(`contact-figure[name="${CSS.escape(full)}"]`) ??
      undefined
    );
  }

  async #open(figure: ContactFigure, failure: LadderFailure, title: string): Promise<void> {
    for (
      let box = figure.closest("details");
      box;
      box = box.parentElement?.closest("details") ?? null
    )
      box.open = true;
    const fields = Object.entries(failure.fields ?? {}).map(
      ([name, numbers]) => [name, numbers.length === 1 ? numbers[0]! : numbers] as const,
    );
    figure.parentElement?.querySelector(":scope > .from-ladder")?.remove();
    const status = html("span", { role: "status" }, "Loading …");
    const back = button("Back to the ladder", () => {
      this.#panel.scrollIntoView({ block: "center" });
      this.#panel.focus({ preventScroll: true });
    });
    const said = html("div", { class: "from-ladder" }, status, back);
    figure.before(said);
    try {
      await figure.ready;
      figure.reset();
      figure.set(Object.fromEntries(fields));
      status.textContent = `From the ladder, ${title}. ${failure.note}`;
    } catch {
      status.textContent = "The live figure could not be loaded.";
    }
    said.scrollIntoView({ block: "start" });
    back.focus({ preventScroll: true });
  }

  #runner(result: LadderResult): HTMLElement {
    const base = new URL(this.getAttribute("base") ?? "./", document.baseURI).href;
    const status = html("span", { class: "status", role: "status" });
    const progress = html("progress", { max: "1", value: "0", "aria-label": "Progress" });
    const run = button("Run it here", () => start());
    const cancel = button("Cancel", () => stop("Stopped."));
    const numbers = html("details", {}, html("summary", {}, "Your own numbers"));
    progress.hidden = true;
    cancel.hidden = true;
    numbers.hidden = true;
    const buttons = html("div", { class: "buttons" }, run, cancel, progress, status);

    const stop = (words: string): void => {
      this.#waiting?.abort();
      this.#worker?.terminate();
      this.#worker = undefined;
      run.hidden = false;
      cancel.hidden = true;
      progress.hidden = true;
      status.textContent = words;
      if (this.#rows.length === 0) return;
      const place = mayScroll(
        html("div", { class: "wide" }),
        "Your own measurements, may scroll sideways",
      );
      place.append(ownNumbers(this.#shown(), this.#rows));
      numbers.replaceChildren(html("summary", {}, "Your own numbers"), place);
      numbers.hidden = false;
      this.#draw();
      this.#renew();
    };
    const receive = ({ data }: MessageEvent<WorkerMessage>): void => {
      if (data.kind === "peers") {
        this.#peers = data.peers;
      } else if (data.kind === "row") {
        this.#rows.push(data.row);
        progress.value = data.done / data.of;
        status.textContent = `${data.done} of ${data.of}`;
      } else if (data.kind === "end") {
        stop(`${this.#rows.length} timed in ${data.seconds.toFixed(1)} s: ${machine()}.`);
      } else {
        console.warn(`ladder ${result.ladder}:`, data.message);
        void failed();
      }
    };
    /** It did not start: perhaps it is still to be built, and starts then. */
    const failed = async (): Promise<void> => {
      this.#worker?.terminate();
      progress.hidden = true;
      this.#waiting = new AbortController();
      const { signal } = this.#waiting;
      const say = (words: string): void => {
        if (!signal.aborted) status.textContent = words;
      };
      try {
        if (await untilBuilt(`ladder ${this.getAttribute("name")}`, base, say, signal)) start();
        else stop("The ladder could not be run in this browser.");
      } catch {
        // Cancelled meanwhile, and said so.
      }
    };
    const start = (): void => {
      this.#rows = [];
      run.hidden = true;
      cancel.hidden = false;
      progress.hidden = false;
      progress.value = 0;
      status.textContent = "Loading …";
      this.#worker = new Worker(`${base}ladder-worker.js`, { type: "module" });
      this.#worker.addEventListener("message", receive);
      this.#worker.addEventListener("error", () => void failed());
      this.#worker.postMessage(`${base}ladders/${this.getAttribute("name")}.wasm`);
    };
    return html("div", { class: "here" }, buttons, numbers);
  }
}

/** The method and the family of a cell that an element is in. */
function where(element: Element): { method: string; family: string } | undefined {
  const family = element.closest<HTMLElement>("td[data-family]")?.dataset.family;
  const method = element.closest<HTMLElement>("tr[data-method]")?.dataset.method;
  return family === undefined || method === undefined ? undefined : { method, family };
}

/** A wide box that the keyboard reaches and scrolls. */
function mayScroll(box: HTMLElement, name: string): HTMLElement {
  box.tabIndex = 0;
  box.setAttribute("role", "region");
  box.setAttribute("aria-label", name);
  return box;
}

/** What the browser tells of itself. */
function machine(): string {
  const cores = navigator.hardwareConcurrency;
  const named = /(Firefox|Edg|Chrome|Version)\/(\d+)/.exec(navigator.userAgent);
  const names: Record<string, string> = { Edg: "Edge", Version: "Safari" };
  const browser = named ? `${names[named[1]!] ?? named[1]} ${named[2]}` : "this browser";
  return cores ? `${browser}, ${cores} threads` : browser;
}
