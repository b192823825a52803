// <contact-ladder name="02_triangles" base="…"><script type="application/json">{…}</script>
//   …plot and table… </contact-ladder>
//
// The book's own measurement is there without a script. This adds "Run it here": the same C++,
// compiled to WebAssembly, timed in the reader's browser and drawn beside it.

import { button, html } from "./dom.ts";
import {
  type LadderResult,
  type LadderRow,
  methodName,
  type WorkerMessage,
} from "./ladder-data.ts";
import { pretty } from "./numbers.ts";
import { untilBuilt } from "./pending.ts";

export class ContactLadder extends HTMLElement {
  #worker: Worker | undefined;
  #waiting: AbortController | undefined;
  #rows: LadderRow[] = [];
  #built = false;

  /** The reader's own measurements so far. */
  get rows(): readonly LadderRow[] {
    return this.#rows;
  }

  connectedCallback(): void {
    const script = this.querySelector(':scope > script[type="application/json"]');
    if (this.#built || !script?.textContent) return;
    this.#built = true;
    this.#build(JSON.parse(script.textContent) as LadderResult);
  }

  disconnectedCallback(): void {
    this.#waiting?.abort();
    this.#worker?.terminate();
  }

  #build(result: LadderResult): void {
    const base = new URL(this.getAttribute("base") ?? "./", document.baseURI).href;
    for (const scrolling of this.querySelectorAll<HTMLElement>(":is(.plot, .wide):not([role])")) {
      scrolling.tabIndex = 0;
      scrolling.setAttribute("role", "region");
      scrolling.setAttribute("aria-label", "Measurements, may scroll sideways");
    }
    const status = html("span", { class: "status", role: "status" });
    const progress = html("progress", { max: "1", value: "0", "aria-label": "Progress" });
    const run = button("Run it here", () => start());
    const cancel = button("Cancel", () => stop("Stopped."));
    const place = html("div", { class: "wide", tabindex: "0", role: "region" });
    place.setAttribute("aria-label", "Your own measurements, may scroll sideways");
    progress.hidden = true;
    cancel.hidden = true;
    place.hidden = true;
    const buttons = html("div", { class: "buttons" }, run, cancel, progress, status);
    const here = html("div", { class: "here" }, buttons, place);
    const plot = this.querySelector(":scope > .plot");
    if (plot) plot.after(here);
    else this.append(here);

    const stop = (words: string): void => {
      this.#waiting?.abort();
      this.#worker?.terminate();
      this.#worker = undefined;
      run.hidden = false;
      cancel.hidden = true;
      progress.hidden = true;
      status.textContent = words;
      void this.#show(result, place);
    };
    const receive = ({ data }: MessageEvent<WorkerMessage>): void => {
      if (data.kind === "row") {
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
  }

  async #show(result: LadderResult, place: HTMLElement): Promise<void> {
    if (this.#rows.length === 0) return;
    place.replaceChildren(table(result, this.#rows));
    place.hidden = false;
    const { ladderPlot } = await import("./ladder-plot.ts");
    const plot = this.querySelector(":scope > .plot");
    plot?.replaceChildren(ladderPlot(result, document, this.#rows));
  }
}

function table(result: LadderResult, rows: readonly LadderRow[]): HTMLElement {
  const head = ["Inputs", "Method", "Wrong", "Here, ns: median (quartiles)", "In the book, ns"];
  const body = rows.map((row) => {
    const method = result.methods.find(({ id }) => id === row.method);
    const family = result.families.find(({ id }) => id === row.family);
    const book = result.results.find(
      (other) => other.method === row.method && other.family === row.family,
    );
    const ns = (value: number): string => pretty(value, 3);
    const cells = [
      family?.title ?? row.family,
      method ? methodName(method) : row.method,
      `${row.wrong.toLocaleString("en")} of ${row.n.toLocaleString("en")}`,
      `${ns(row.ns_median)} (${ns(row.ns_q1)}–${ns(row.ns_q3)})`,
      book ? ns(book.ns_median) : "–",
    ];
    return html("tr", {}, ...cells.map((cell) => html("td", {}, cell)));
  });
  const headings = head.map((name) => html("th", { scope: "col" }, name));
  return html(
    "table",
    { class: "docutils" },
    html("caption", {}, "Rings in the plot: WebAssembly in this browser"),
    html("thead", {}, html("tr", {}, ...headings)),
    html("tbody", {}, ...body),
  );
}

/** What the browser tells of itself. */
function machine(): string {
  const cores = navigator.hardwareConcurrency;
  const named = /(Firefox|Edg|Chrome|Version)\/(\d+)/.exec(navigator.userAgent);
  const names: Record<string, string> = { Edg: "Edge", Version: "Safari" };
  const browser = named ? `${names[named[1]!] ?? named[1]} ${named[2]}` : "this browser";
  return cores ? `${browser}, ${cores} threads` : browser;
}
