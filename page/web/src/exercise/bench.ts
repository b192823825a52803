// The bench of one exercise: the contract, the reader's code, what can be done with it, and what
// came of it. Everything heavy is loaded when it is first needed.

import type { Checker } from "../cpp/checker.ts";
import type {
  ExerciseData,
  Judge,
  ProgressRecord,
  Progress as Step,
  TestResult,
  VerdictJson,
} from "../cpp/types.ts";
import { button, freshId, html } from "../dom.ts";
import { asForm, type Change, type Form, fingerprint, type Version, Work } from "../work.ts";
import { CodeField } from "./code-field.ts";
import { colour } from "./colour.ts";
import { Forms } from "./forms.ts";
import { Hints } from "./hints.ts";
import { inputPanel } from "./input-panel.ts";
import { Mine } from "./mine.ts";
import { nextAfter, type Parts } from "./parts.ts";
import { sideBySideSwitch } from "./side-by-side.ts";
import { Versions, when } from "./versions.ts";

const SAVE_AFTER_MS = 400;
const NOT_LOADED =
  "A part of this page could not be loaded. Try again; if the book has been replaced meanwhile, load the page again. Your code is kept.";
/** A step that is over sooner is not worth a word. */
const SAY_AFTER_MS = 300;

/** What is folded on a screen and whole on paper. */
const ON_PAPER = ".contract, .given, .command-line";

type State = "idle" | "loading" | "compiling" | "running" | "done";

const STATES: Record<Step["step"], State> = {
  wait: "loading",
  download: "loading",
  start: "loading",
  compile: "compiling",
  link: "compiling",
  run: "running",
};
const WORDS: Record<Step["step"], string> = {
  wait: "This is not built yet.",
  download: "Downloading the compiler …",
  start: "Starting the compiler …",
  compile: "Compiling your code …",
  link: "Linking it with the tests …",
  run: "Running the tests …",
};

const megabytes = (bytes: number): string => `${Math.max(1, Math.round(bytes / 1e6))} MB`;

/** All benches of the page: what one downloads, the others have too. */
const benches = new Set<Bench>();

export class Bench {
  readonly #host: HTMLElement;
  readonly #parts: Parts;
  readonly #code: CodeField;
  readonly #hints: Hints;
  readonly #forms: Forms | undefined;
  readonly #mine: Mine | undefined;
  readonly #written = html("div", { class: "written" });
  readonly #versions = new Versions((version) => this.#bringBack(version));

  readonly #check = button("Check", () => void this.check(), "do");
  readonly #stop = button("Stop", () => this.#stopping?.abort());
  readonly #ready = button("Get ready", () => void this.#prepare());
  readonly #again = button("Try again", () => this.#retry?.());
  readonly #hint = button("Hint", () => this.#oneMoreHint());
  readonly #reset = button("Reset", () => this.#startAgain());
  readonly #undo = button("Undo reset", () => this.#undoReset());
  readonly #solution = button("Solution", () => void this.#askForSolution());
  readonly #allTheSame = button("Show it all the same", () => void this.#giveUp());

  readonly #size = html("p", { class: "size" });
  readonly #bar = html("progress", { max: "1", value: "0", "aria-label": "Download" });
  readonly #received = html("span");
  readonly #progress = html("div", { class: "progress" }, this.#bar, this.#received);
  readonly #status = html("p", { class: "status", role: "status" });
  readonly #stale = html("p", { class: "stale" });
  readonly #results = html("div", { class: "results" });
  readonly #answer = html("div", { class: "solution" });
  readonly #notKept = html("p", { class: "not-kept", role: "status" });
  readonly #changed = html("div", { class: "changed" });

  #saved: string;
  #saving: ReturnType<typeof setTimeout> | undefined;
  #beforeReset: string | undefined;
  #checked: { of: string; at: string } | undefined;
  #stopping: AbortController | undefined;
  #retry: (() => void) | undefined;
  #speaking: ReturnType<typeof setTimeout> | undefined;
  #data: Promise<ExerciseData> | undefined;

  constructor(host: HTMLElement, parts: Parts) {
    this.#host = host;
    this.#parts = parts;
    const code = Work.code(parts.id);
    const keys = html("p", { class: "keys", id: freshId("keys") });
    const apple = /Mac|iPhone|iPad/.test(navigator.platform);
    const chord = [html("kbd", {}, apple ? "⌘" : "Ctrl"), "+", html("kbd", {}, "Enter")];
    keys.append(...chord, " checks. ", html("kbd", {}, "Tab"), " indents; ");
    keys.append(html("kbd", {}, "Esc"), " and then ", html("kbd", {}, "Tab"));
    keys.append(" leaves the editor.");
    this.#check.setAttribute("aria-keyshortcuts", apple ? "Meta+Enter" : "Control+Enter");
    this.#saved = code?.text ?? parts.stub;
    this.#code = new CodeField({
      text: this.#saved,
      file: parts.file,
      title: parts.title,
      describedBy: keys.id,
      changed: () => this.#edited(),
      notLoaded: () => this.#say(NOT_LOADED),
      check: () => void this.check(),
    });
    if (parts.forms) this.#forms = this.#makeForms();
    if (parts.mine) this.#mine = this.#makeMine(parts.mine);
    this.#hints = new Hints(parts.hints, Work.progress().exercises[parts.id]?.hints_shown ?? 0);
    this.#build(keys);
    this.#sayIfTheBookChanged(code?.base);
    this.#refresh();
    this.#host.setAttribute("state", "idle");
    void this.#recallVerdict();
    Work.onChange((change) => this.#workChanged(change));
    addEventListener("pagehide", () => this.#save());
    // A page that comes back out of the browser's memory heard nothing of what other tabs did meanwhile.
    addEventListener("pageshow", ({ persisted }) => {
      if (persisted) this.#workChanged({ what: "code", id: parts.id, elsewhere: true });
    });
    document.addEventListener("visibilitychange", () => {
      if (document.visibilityState === "hidden") this.#save();
    });
    addEventListener("beforeprint", () => {
      for (const folded of this.#host.querySelectorAll<HTMLDetailsElement>(ON_PAPER))
        folded.open = true;
    });
    benches.add(this);
    this.#tellSizeWhenSeen();
  }

  // ---- What is there ----

  #build(keys: HTMLElement): void {
    const { contractListing, points, commands, file } = this.#parts;
    const contract = html("details", { class: "contract", open: "" });
    const name = html("code", {}, file.replace(/\.cpp$/, ".hpp"));
    contract.append(html("summary", {}, "The contract, ", name));
    contract.append(...contractListing.querySelectorAll(":scope .highlight"));
    const read = html("div", { class: "read" }, contract, ...this.#given());
    const buttons = html("div", { class: "buttons" });
    buttons.append(this.#check, this.#stop, this.#again, this.#hint, this.#reset, this.#undo);
    if (this.#mine) buttons.append(this.#mine.button);
    // Last, since it comes and goes by itself.
    buttons.append(this.#solution, this.#allTheSame, this.#ready);
    for (const hidden of [this.#stop, this.#again, this.#ready, this.#undo, this.#allTheSame])
      hidden.hidden = true;
    for (const hidden of [this.#progress, this.#size, this.#answer, this.#changed, this.#stale])
      hidden.hidden = true;
    if (points) this.#results.append(points);
    const heading = html("p", { class: "name" }, "Your code, ", html("code", {}, file));
    heading.append(sideBySideSwitch());
    const write = html("div", { class: "write" });
    const below = html("div", { class: "below" }, keys, this.#size);
    this.#written.append(heading, this.#code.element, below);
    this.#forms?.panel.append(this.#written);
    const forms = this.#forms ? [this.#forms.tabs, this.#forms.panel] : [this.#written];
    write.append(this.#changed, ...this.#inputs(), ...forms, buttons);
    write.append(this.#progress, this.#notKept, this.#status);
    write.append(this.#hints.element, this.#answer, this.#stale, this.#results);
    write.append(this.#versions.element);
    if (commands) {
      const summary = html("summary", {}, "On the command line instead");
      write.append(html("details", { class: "command-line" }, summary, commands));
    }
    this.#host.replaceChildren(html("div", { class: "bench" }, read, write));
  }

  #given(): HTMLElement[] {
    const { given } = this.#parts;
    if (!given) return [];
    const name = given.querySelector("code, .literal")?.textContent ?? "";
    const folded = html("details", { class: "given", open: "" });
    folded.append(html("summary", {}, "The code to break, ", html("code", {}, name)));
    folded.append(...given.querySelectorAll(":scope .highlight"));
    return [folded];
  }

  #inputs(): HTMLElement[] {
    const { inputs } = this.#parts;
    if (inputs.length === 0) return [];
    const panel = inputPanel(inputs, {
      text: () => this.#code.text,
      replace: (text) => {
        this.#code.text = text;
      },
      say: (words) => this.#say(words),
    });
    return [panel];
  }

  #makeMine(tie: NonNullable<Parts["mine"]>): Mine {
    const { base, title, file } = this.#parts;
    return new Mine(tie, {
      base,
      title,
      file,
      text: () => this.#text,
      exercise: () => this.#exercise(),
      checker: () => this.#checker(),
      toCode: () => {
        this.#host.querySelector(".write")?.scrollIntoView({ block: "nearest" });
        this.#mine?.button.focus({ preventScroll: true });
      },
      say: (words) => this.#say(words),
    });
  }

  #makeForms(): Forms {
    const { id } = this.#parts;
    const entry = (): { passed?: string; solution_shown?: boolean } =>
      Work.progress().exercises[id] ?? {};
    return new Forms({
      id,
      load: () => this.#exercise(),
      failed: (error, again) => this.#failed(error, again),
      changed: () => this.#refreshText(),
      check: () => void this.check(),
      write: (text, form) => {
        this.#replace(text, "form");
        Work.setProgress(asForm(Work.progress(), id, form));
        this.#say(
          "This is what you have put together. What was here is among the earlier versions.",
        );
      },
      solutionIsOpen: () => Boolean(entry().passed || entry().solution_shown),
      solutionShown: () =>
        this.#record((one) => {
          one.solution_shown = true;
        }),
    });
  }

  /** The text that a check would check: the editor's, or that of another form. */
  get #text(): string {
    return this.#forms?.text() ?? this.#code.text;
  }

  /** What depends on what the browser keeps. */
  #refresh(): void {
    this.#versions.show(Work.versions(this.#parts.id), this.#code.text);
    const problem = Work.problem ?? "";
    if (this.#notKept.textContent !== problem) this.#notKept.textContent = problem;
    this.#refreshText();
  }

  /** What depends on the text alone: after every key. */
  #refreshText(): void {
    const writes = this.#writes;
    this.#mine?.changed();
    this.#written.hidden = !writes;
    this.#reset.hidden = !writes;
    if (!writes) this.#undo.hidden = true;
    this.#reset.disabled = this.#code.text === this.#parts.stub;
    const stale = this.#checked && this.#checked.of !== fingerprint(this.#text);
    this.#host.toggleAttribute("stale", Boolean(stale));
    this.#stale.hidden = !stale;
    this.#stale.textContent = stale
      ? `This is what your check of ${when(this.#checked!.at)} said. The code has changed since.`
      : "";
  }

  get #writes(): boolean {
    return !this.#forms || this.#forms.form === "write";
  }

  /** Names the stub and the contract that a text begins from. */
  get #base(): string {
    return `${fingerprint(this.#parts.stub)}-${fingerprint(this.#parts.contract)}`;
  }

  #sayIfTheBookChanged(base: string | undefined): void {
    if (!base || base === this.#base) return;
    const [stub, contract] = base.split("-");
    const what = [
      contract === fingerprint(this.#parts.contract) ? "" : "the contract",
      stub === fingerprint(this.#parts.stub) ? "" : "the code to begin with",
    ].filter(Boolean);
    const words = `Since you started, the book has changed ${what.join(" and ")} of this exercise. Your code is unchanged.`;
    const listing = html("pre");
    listing.append(colour(this.#parts.stub));
    const fresh = html("div", { class: "highlight" }, listing);
    fresh.hidden = true;
    const show = button("Show the new beginning", () => {
      fresh.hidden = !fresh.hidden;
      show.textContent = fresh.hidden ? "Show the new beginning" : "Hide it";
    });
    const go = button("Go on with mine", () => {
      Work.save(this.#parts.id, this.#code.text, this.#base);
      this.#changed.hidden = true;
    });
    this.#changed.append(html("p", {}, words), html("div", { class: "buttons" }, show, go), fresh);
    this.#changed.hidden = false;
  }

  // ---- Words and states ----

  /** Shows a button or hides it; a focus that it had goes to Check instead of nowhere. */
  #show(which: HTMLButtonElement, visible: boolean): void {
    const focused = document.activeElement === which;
    which.hidden = !visible;
    if (focused && !visible) this.#check.focus({ preventScroll: true });
  }

  #say(words: string): void {
    clearTimeout(this.#speaking);
    this.#status.textContent = words;
  }

  #sayIfItLasts(words: string): void {
    clearTimeout(this.#speaking);
    this.#speaking = setTimeout(() => this.#say(words), SAY_AFTER_MS);
  }

  #state(state: State): void {
    const busy = state === "loading" || state === "compiling" || state === "running";
    this.#check.setAttribute("aria-disabled", String(busy));
    this.#show(this.#stop, busy);
    if (busy) for (const other of [this.#ready, this.#again]) this.#show(other, false);
    if (state !== "loading") this.#progress.hidden = true;
    this.#host.setAttribute("state", state);
  }

  #stepSaid: Step["step"] | undefined;
  #downloaded = false;

  #tell(step: Step): void {
    this.#state(STATES[step.step]);
    const { received, total } = step;
    const downloading = step.step === "download" && received !== undefined && Boolean(total);
    this.#progress.hidden = !downloading;
    if (downloading) {
      this.#bar.value = received / total!;
      const done = (received / 1e6).toFixed(1);
      this.#received.textContent = `${done} of ${megabytes(total!)}`;
    }
    if (step.words) this.#sayIfItLasts(step.words);
    if (this.#stepSaid === step.step) return;
    this.#stepSaid = step.step;
    if (step.step === "wait") return;
    if (step.step === "download" && this.#downloaded)
      this.#sayIfItLasts("Downloading what makes checks quicker …");
    else if (downloading) this.#sayIfItLasts(`${WORDS.download} It is ${megabytes(total!)}.`);
    else this.#sayIfItLasts(WORDS[step.step]);
    if (step.step !== "download") this.#downloaded = true;
  }

  /** Runs what can be stopped and can fail, and says how it ended otherwise. */
  async #attempt(work: (signal: AbortSignal) => Promise<void>, again: () => void): Promise<void> {
    if (this.#stopping) return;
    const stopping = new AbortController();
    this.#stopping = stopping;
    this.#stepSaid = undefined;
    this.#downloaded = false;
    this.#size.hidden = true;
    this.#state("loading");
    try {
      await work(stopping.signal);
    } catch (error) {
      this.#state("idle");
      if (stopping.signal.aborted) this.#say("Stopped.");
      else this.#failed(error, again);
    } finally {
      this.#stopping = undefined;
      for (const bench of benches) void bench.#tellSize();
    }
  }

  #failed(error: unknown, again: () => void): void {
    const actionable = error instanceof Error && error.name === "CheckerError";
    if (!actionable) console.warn(`exercise ${this.#parts.id}:`, error);
    // What a failed import() is called differs between browsers; that it is a TypeError does not.
    const notLoaded = error instanceof TypeError && /import|module/i.test(error.message);
    const words = actionable
      ? (error as Error).message
      : notLoaded
        ? NOT_LOADED
        : "Something went wrong in the page itself. Your code is kept.";
    this.#say(words);
    this.#retry = again;
    this.#again.hidden = false;
  }

  // ---- Saving ----

  #edited(): void {
    clearTimeout(this.#saving);
    this.#saving = setTimeout(() => this.#save(), SAVE_AFTER_MS);
    if (this.#code.text !== this.#parts.stub) this.#undo.hidden = true;
    this.#refreshText();
  }

  #save(): void {
    clearTimeout(this.#saving);
    const { text } = this.#code;
    if (text === this.#saved) return;
    this.#saved = text;
    const base = Work.base(this.#parts.id) || this.#base;
    Work.save(this.#parts.id, text, base);
  }

  #workChanged({ what, id, elsewhere }: Change): void {
    if (id !== undefined && id !== this.#parts.id) return;
    if (elsewhere && what === "code") this.#takeOver();
    if (elsewhere && what === "verdict" && !this.#stopping) void this.#recallVerdict();
    this.#refresh();
  }

  #takeOver(): void {
    const taken = Work.takeOver(this.#parts.id, this.#code.text, this.#saved);
    if (!taken) return;
    clearTimeout(this.#saving);
    this.#saved = taken.text;
    this.#code.text = taken.text;
    const words = taken.imported
      ? "Your code was replaced by the import; yours from before is among the earlier versions."
      : "Your code was changed in another tab; this is what you wrote there.";
    const typed = " What you had just typed here is among the earlier versions.";
    this.#say(taken.aside ? words + typed : words);
  }

  /** Another text in the place of the present one, which becomes an earlier version. */
  #replace(text: string, why: "reset" | "solution" | "form"): void {
    this.#save();
    Work.keep(this.#parts.id, why);
    this.#code.text = text;
    this.#save();
    this.#refresh();
  }

  #bringBack(version: Version): void {
    this.#replace(version.text, "reset");
    this.#say(`This is your version of ${when(version.at)}. The one before it is kept too.`);
  }

  #startAgain(): void {
    this.#beforeReset = this.#code.text;
    this.#replace(this.#parts.stub, "reset");
    Work.save(this.#parts.id, this.#parts.stub, this.#base);
    Work.setProgress(asForm(Work.progress(), this.#parts.id, "write"));
    this.#changed.hidden = true;
    this.#undo.hidden = false;
    this.#say("This is the original stub. Your code is kept among the earlier versions.");
  }

  #undoReset(): void {
    if (this.#beforeReset === undefined) return;
    const hadFocus = document.activeElement === this.#undo;
    this.#code.text = this.#beforeReset;
    this.#beforeReset = undefined;
    this.#save();
    this.#refresh();
    this.#undo.hidden = true;
    if (hadFocus) this.#reset.focus({ preventScroll: true });
    this.#say("Your code is back.");
  }

  // ---- Help ----

  #record(change: (entry: { hints_shown?: number; solution_shown?: boolean }) => void): void {
    const progress = Work.progress();
    const entry = { ...progress.exercises[this.#parts.id] };
    change(entry);
    const exercises = { ...progress.exercises, [this.#parts.id]: entry };
    Work.setProgress({ ...progress, exercises });
  }

  #oneMoreHint(): void {
    if (this.#hints.left > 0)
      this.#record((entry) => {
        entry.hints_shown = (entry.hints_shown ?? 0) + 1;
      });
    this.#say(this.#hints.more());
  }

  async #askForSolution(): Promise<void> {
    if (!this.#answer.hidden) {
      this.#answer.hidden = true;
      return;
    }
    const done = Work.progress().exercises[this.#parts.id];
    if (done?.passed || done?.solution_shown) {
      await this.#showSolution(() => void this.#askForSolution());
      return;
    }
    const { left } = this.#hints;
    const hints = left === 1 ? " There is one more hint." : ` There are ${left} more hints.`;
    this.#say(`The solution opens once all tests pass.${left > 0 ? hints : ""}`);
    this.#allTheSame.hidden = false;
  }

  async #giveUp(): Promise<void> {
    if (!(await this.#showSolution(() => void this.#giveUp()))) return;
    this.#record((entry) => {
      entry.solution_shown = true;
    });
    if (document.activeElement === this.#allTheSame) this.#solution.focus({ preventScroll: true });
    this.#allTheSame.hidden = true;
  }

  async #showSolution(again: () => void): Promise<boolean> {
    const { id, file } = this.#parts;
    try {
      const data = await this.#exercise();
      const text = data.files[`solutions/${id}/${file}`] ?? "";
      const listing = html("pre", { tabindex: "0", role: "region", "aria-label": "The solution" });
      listing.append(colour(text));
      const take = button("Put it in the editor", () => {
        this.#replace(text, "solution");
        this.#say("This is the book's solution. Your code is kept among the earlier versions.");
      });
      this.#answer.replaceChildren(
        html("p", { class: "name" }, "The book's solution: one way of several"),
        html("div", { class: "highlight" }, listing),
        html("div", { class: "buttons" }, take),
      );
      this.#answer.hidden = false;
      this.#say("The solution is below.");
      return true;
    } catch (error) {
      this.#failed(error, again);
      return false;
    }
  }

  // ---- Checking ----

  #exercise(): Promise<ExerciseData> {
    const { base, id } = this.#parts;
    const load = async (): Promise<ExerciseData> => {
      const response = await fetch(`${base}exercises/${id}.json`, { cache: "no-cache" });
      if (!response.ok) throw new Error(`${response.status} for ${response.url}`);
      return (await response.json()) as ExerciseData;
    };
    this.#data ??= load().catch((error: unknown) => {
      this.#data = undefined;
      const sentence = "The exercise's own files could not be loaded. Are you offline?";
      throw Object.assign(new Error(sentence), { name: "CheckerError", cause: error });
    });
    return this.#data;
  }

  async #checker(): Promise<Checker> {
    const { Checker } = await import("../cpp/checker.ts");
    return Checker.for(this.#parts.base);
  }

  #prepare(): Promise<void> {
    const prepare = async (signal: AbortSignal): Promise<void> => {
      const checker = await this.#checker();
      await checker.prepare(this.#parts.id, (step) => this.#tell(step), signal);
      this.#state("idle");
      this.#say("Ready: checks are quick from now on.");
    };
    return this.#attempt(prepare, () => void this.#prepare());
  }

  check(): Promise<void> {
    const missing = this.#forms?.missing();
    if (missing) {
      this.#say(missing);
      return Promise.resolve();
    }
    const check = async (signal: AbortSignal): Promise<void> => {
      const text = this.#text;
      const form = this.#writes ? undefined : (this.#forms!.form as Form);
      this.#save();
      Work.keep(this.#parts.id, "checked", text);
      this.#sayIfItLasts("Getting ready …");
      const [data, checker] = await Promise.all([this.#exercise(), this.#checker()]);
      let tests = 0;
      const onTest = (result: TestResult): void => {
        tests += 1;
        const mark = result.status === "passed" ? "passed" : result.status.replace("_", " ");
        this.#sayIfItLasts(`Running the tests: ${tests} done, the last one ${mark}.`);
      };
      const tell = (step: Step): void => this.#tell(step);
      const progress = Work.progress() as ProgressRecord;
      const verdict = await checker.check(data, text, tell, { signal, onTest, progress });
      const judge = await checker.judge(data);
      const now = new Date().toISOString().replace(/\.\d+Z$/, "Z");
      this.#recordVerdict(judge, verdict, now, form);
      this.#hints.showUpTo(Work.progress().exercises[this.#parts.id]?.hints_shown ?? 0);
      Work.setVerdict(this.#parts.id, text, verdict);
      Work.judged(this.#parts.id, text, verdict);
      this.#checked = { of: fingerprint(text), at: now };
      await this.#showVerdict(verdict, data);
      if (verdict.diagnostics?.length && this.#writes) this.#code.open();
      this.#bringIntoSight();
    };
    return this.#attempt(check, () => void this.check());
  }

  /** @param form that of the text that was checked; the editor's own if undefined */
  #recordVerdict(judge: Judge, verdict: VerdictJson, now: string, form: Form | undefined): void {
    const { id } = this.#parts;
    const progress = Work.progress();
    const began = progress.exercises[id]?.form ?? "write";
    const record = judge.record(asForm(progress, id, form ?? began), verdict, now);
    Work.setProgress(asForm(record as typeof progress, id, began));
  }

  async #showVerdict(verdict: VerdictJson, data: ExerciseData | undefined): Promise<void> {
    const { messageList, printed, sentence, testList } = await import("./results.ts");
    const compiles = verdict.verdict !== "does_not_compile";
    const goTo = (message: Parameters<CodeField["goTo"]>[0]): void =>
      this.#writes ? this.#code.goTo(message) : this.#forms?.goTo(message.line);
    const messages = messageList(verdict, this.#parts.file, goTo);
    const { points } = this.#parts;
    const tests = compiles ? [testList(verdict, data)] : points ? [points] : [];
    const next = verdict.verdict === "passed" ? this.#whatNext() : [];
    this.#results.replaceChildren(...next, ...messages, ...tests, ...printed(verdict));
    const current = this.#checked?.of === fingerprint(this.#text);
    this.#forms?.judged(verdict, data);
    this.#code.mark(current && this.#writes ? (verdict.diagnostics ?? []) : []);
    this.#host.setAttribute("verdict", verdict.verdict);
    this.#refresh();
    this.#say(sentence(verdict));
    this.#state("done");
  }

  /** The first thing to look at. While the reader is typing, the code stays visible. */
  #bringIntoSight(): void {
    const first = this.#results.querySelector("li:has(> .failure), .messages > li");
    if (first && !this.#code.inUse) first.scrollIntoView({ block: "nearest" });
    this.#status.scrollIntoView({ block: "nearest" });
  }

  #whatNext(): HTMLElement[] {
    const next = nextAfter(this.#host);
    const ways: (Node | string)[] = ["Compare it with the book's own: press Solution."];
    if (next) ways.push(" ", html("a", { href: next.href }, next.words), ".");
    return [html("p", { class: "next" }, ...ways)];
  }

  /** The verdict of an earlier visit, or of another tab. */
  async #recallVerdict(): Promise<void> {
    const last = Work.verdict(this.#parts.id);
    const verdict = last?.verdict as VerdictJson | undefined;
    if (!last || !Array.isArray(verdict?.tests)) return;
    this.#checked = { of: last.of, at: last.at };
    const hinted = verdict.tests.some(
      ({ failure, look }) => failure?.misconceptions?.length || look?.hint_number,
    );
    const data = hinted ? await this.#exercise().catch(() => undefined) : undefined;
    if (this.#stopping) return;
    await this.#showVerdict(verdict, data);
  }

  // ---- The size of the download, before it is asked for ----

  #tellSizeWhenSeen(): void {
    const seen = new IntersectionObserver((entries) => {
      if (!entries.some(({ isIntersecting }) => isIntersecting)) return;
      seen.disconnect();
      void this.#tellSize();
    });
    seen.observe(this.#check);
  }

  async #tellSize(): Promise<void> {
    try {
      const { core, kept } = await (await this.#checker()).size();
      if (this.#stopping) return;
      this.#show(this.#ready, core > 0);
      this.#ready.textContent = `Get ready (${megabytes(core)})`;
      this.#size.hidden = core === 0;
      const often = kept ? "downloaded once" : "on every visit";
      this.#size.textContent = `The compiler: ${megabytes(core)}, ${often}.`;
    } catch {
      // It is said when a check is asked for.
      this.#show(this.#ready, false);
      this.#size.hidden = true;
    }
  }
}
