// "Try mine in the figure": the reader's function answers for the numbers that are dragged in the
// figure of its lesson, beside the book's.

import type { ContactFigure } from "../contact-figure.ts";
import type { Checker } from "../cpp/checker.ts";
import { ANSWER_SECONDS, type MineAnswer, MineThread } from "../cpp/mine-thread.ts";
import type { ExerciseData, Progress, VerdictJson } from "../cpp/types.ts";
import { button } from "../dom.ts";
import type { Fields } from "../layout.ts";
import { MinePanel } from "./mine-panel.ts";
import { callerSource, givenTo, readFound, type Tie } from "./mine-program.ts";

const COMPILE_AFTER_MS = 800;

/** What the bench has for it. */
export interface MineHost {
  readonly base: string;
  readonly title: string;
  readonly file: string;
  text(): string;
  exercise(): Promise<ExerciseData>;
  checker(): Promise<Checker>;
  toCode(): void;
  say(words: string): void;
}

/** One exercise at a time has a figure. */
const inFigures = new Map<string, Mine>();

export class Mine {
  readonly button = button("Try mine in the figure", () => void this.#start());
  readonly #tie: Tie;
  readonly #host: MineHost;
  #figure: ContactFigure | undefined;
  #panel: MinePanel | undefined;
  #thread: MineThread | undefined;
  /** Of the text that is compiled, or being compiled. */
  #compiled: string | undefined;
  #waiting: ReturnType<typeof setTimeout> | undefined;
  #stopping: AbortController | undefined;

  constructor(tie: Tie, host: MineHost) {
    this.#tie = tie;
    this.#host = host;
  }

  /** The text has changed, or may have. */
  changed(): void {
    if (!this.#panel || this.#host.text() === this.#compiled) return;
    this.#thread?.end();
    this.#thread = undefined;
    this.#stopping?.abort();
    this.#compiled = undefined;
    this.#panel.say("Your code has changed: it is compiled when you pause.", "busy");
    clearTimeout(this.#waiting);
    this.#waiting = setTimeout(() => void this.#compile(), COMPILE_AFTER_MS);
  }

  async #start(): Promise<void> {
    const { figure: name, only, start } = this.#tie;
    const figure = document.querySelector<ContactFigure>(
      `contact-figure[name="${CSS.escape(name)}"]`,
    );
    figure?.scrollIntoView({ block: "nearest" });
    const loading = figure && !figure.input;
    if (loading) this.#host.say("The figure is being loaded …");
    try {
      await figure?.ready;
    } catch {
      // The figure says itself why it is not there.
    }
    if (!figure?.input) {
      this.#host.say("The figure could not be loaded, so your code cannot be tried in it.");
      return;
    }
    if (loading) this.#host.say("");
    if (!this.#panel) {
      inFigures.get(name)?.stop();
      inFigures.set(name, this);
      this.#figure = figure;
      const back = (): void => {
        this.stop();
        this.button.focus();
      };
      this.#panel = new MinePanel(this.#tie, this.#host.title, () => this.#host.toCode(), back);
      figure.beside(this.#panel.element);
      figure.addEventListener("contact-change", this.#moved);
      if (!this.#answers()) {
        if (start) figure.show(start);
        else if (only) figure.set({ [only.field]: only.value });
      }
    }
    this.#panel.element.scrollIntoView({ block: "nearest" });
    this.#panel.element.focus({ preventScroll: true });
    if (this.#host.text() !== this.#compiled) await this.#compile();
  }

  /** The figure shows the book's answer alone again. */
  stop(): void {
    clearTimeout(this.#waiting);
    this.#stopping?.abort();
    this.#thread?.end();
    this.#thread = undefined;
    this.#compiled = undefined;
    this.#figure?.removeEventListener("contact-change", this.#moved);
    this.#panel?.element.remove();
    this.#panel = undefined;
    if (inFigures.get(this.#tie.figure) === this) inFigures.delete(this.#tie.figure);
  }

  get #fields(): Fields {
    return { ...this.#figure?.output, ...this.#figure?.input };
  }

  async #compile(): Promise<void> {
    const panel = this.#panel;
    if (!panel) return;
    clearTimeout(this.#waiting);
    this.#stopping?.abort();
    this.#thread?.end();
    this.#thread = undefined;
    const stopping = new AbortController();
    this.#stopping = stopping;
    const text = this.#host.text();
    this.#compiled = text;
    panel.say("Compiling your code …", "busy");
    try {
      const [data, checker] = await Promise.all([this.#host.exercise(), this.#host.checker()]);
      const caller = callerSource(this.#tie, this.#host.file, this.#fields);
      const tell = (step: Progress): void => {
        if (stopping.signal.aborted || step.step !== "download" || !step.total) return;
        const done = (step.received ?? 0) / 1e6;
        panel.say(
          `The compiler: ${done.toFixed(0)} of ${(step.total / 1e6).toFixed(0)} MB …`,
          "busy",
        );
      };
      const built = await checker.callable(data, text, caller, tell, stopping.signal);
      if (stopping.signal.aborted) return;
      if ("verdict" in built) {
        panel.say(whyNot(built.verdict), "trouble");
        return;
      }
      const script = new URL("mine-worker.js", this.#host.base).href;
      this.#thread = new MineThread(script, built.program, (answer, book) =>
        this.#answered(answer, book),
      );
      this.#moved();
    } catch (error) {
      if (stopping.signal.aborted) return;
      this.#compiled = undefined;
      const actionable = error instanceof Error && error.name === "CheckerError";
      if (!actionable) console.warn("try mine:", error);
      const words = "Something went wrong in the page itself.";
      panel.say(`${actionable ? error.message : words} Press the button again.`, "trouble");
    }
  }

  /** Whether the numbers of the figure are such that the contract says something of them. */
  #answers(): boolean {
    const { only } = this.#tie;
    return !only || this.#fields[only.field] === only.value;
  }

  readonly #moved = (): void => {
    const { only } = this.#tie;
    const figure = this.#figure;
    if (!this.#thread || !figure?.input || !figure.output) return;
    if (only && !this.#answers()) {
      this.#panel?.say(`Your function answers for this alone: ${only.words}.`, "trouble");
      return;
    }
    if (Number(figure.output["problem"]) !== 0) {
      this.#panel?.say("The book has no answer here, so yours is not asked.", "trouble");
      return;
    }
    this.#thread.ask({ numbers: givenTo(this.#tie, this.#fields), book: figure.output });
  };

  #answered(answer: MineAnswer, book: Fields): void {
    const panel = this.#panel;
    if (!panel) return;
    if (answer.kind === "found") {
      panel.show(readFound(answer.numbers), book);
    } else if (answer.kind === "not_written") {
      panel.say("Your function still calls contact::todo().", "trouble");
    } else if (answer.kind === "thrown") {
      const what = answer.words ? `: ${answer.words}` : "";
      panel.say(`Your function threw an exception for these numbers${what}.`, "trouble");
    } else if (answer.kind === "stopped") {
      panel.say(`Your function stopped for these numbers: ${answer.why}.`, "trouble");
    } else {
      panel.say(
        `Your function gave no answer within ${ANSWER_SECONDS} second: an endless loop, or far too much work. It was stopped. Move the figure to ask it again.`,
        "trouble",
      );
    }
  }
}

/** The first message, in words for a beginner where there are some. */
function whyNot({ diagnostics = [], compile_error: error }: VerdictJson): string {
  const first = diagnostics.find(({ severity }) => severity === "error");
  const line = first?.line ?? error?.line;
  const words = first?.words || first?.message || error?.explanation || error?.message || "";
  return `Your code does not compile${line ? `, line ${line}` : ""}: ${words}`;
}
