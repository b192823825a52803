// <contact-work base="…/_static/contact/"><script type="application/json">{"chapters":[…]}</script>…
// fallback…</contact-work>
//
// A reader's own work on one page: progress, export and import, the book for offline reading, and what this browser
// stores of all that.

import { ArchiveError, exportWork, type Imported, importWork, mergeProgress } from "./archive.ts";
import { button, html } from "./dom.ts";
import { masteryList } from "./mastery.ts";
import { offlineControls } from "./offline/controls.ts";
import { OfflineBook, sizeText } from "./offline/offline.ts";
import { type ExerciseProgress, isExerciseId, parseProgress, Work } from "./work.ts";

interface Exercise {
  readonly id: string;
  readonly title: string;
  readonly points: number;
  readonly kind: string;
  readonly href: string;
}

interface Chapter {
  readonly slug: string;
  readonly title: string;
  readonly href: string;
  readonly exercises: readonly Exercise[];
}

/** All that this book has ever kept of a reader begins so. */
const KEYS = "contact-hours/";

const day = (time: string): string =>
  new Date(time).toLocaleDateString("en-GB", { day: "numeric", month: "long", year: "numeric" });

const counted = (count: number, one: string, many = `${one}s`): string =>
  `${count} ${count === 1 ? one : many}`;

const number = (value: number): string => String(Math.round(value * 100) / 100);

/** The status of one exercise, in words. */
function standing(entry: ExerciseProgress | undefined, hasCode: boolean): string {
  const parts: string[] = [];
  if (entry?.passed) parts.push(`passed on ${day(entry.passed)}`);
  else if (entry?.attempts)
    parts.push(`tried ${entry.attempts === 1 ? "once" : `${entry.attempts} times`}`);
  else parts.push(hasCode ? "begun" : "not begun");
  if (entry?.hints_shown) parts.push(counted(entry.hints_shown, "hint"));
  if (entry?.solution_shown && !entry.passed) parts.push("solution seen");
  return parts.join(", ");
}

function progressTable(chapters: readonly Chapter[]): HTMLElement {
  const record = Work.progress().exercises;
  const mine = new Set(Work.ids());
  const table = html("table", { class: "progress-table" });
  table.append(
    html("caption", {}, "Points by chapter and exercise"),
    html(
      "thead",
      {},
      html(
        "tr",
        {},
        ...["Exercise", "Points", "How far"].map((name) => html("th", { scope: "col" }, name)),
      ),
    ),
  );
  for (const { title, href, exercises } of chapters) {
    const best = ({ id }: Exercise): number => record[id]?.best_points ?? 0;
    const reached = exercises.reduce((sum, exercise) => sum + best(exercise), 0);
    const all = exercises.reduce((sum, { points }) => sum + points, 0);
    const passed = exercises.filter(({ id }) => record[id]?.passed).length;
    const head = html(
      "tr",
      { class: "chapter" },
      html("th", { scope: "rowgroup" }, html("a", { href }, title)),
      html("td", {}, `${number(reached)} of ${number(all)}`),
      html("td", {}, `${passed} of ${exercises.length} passed`),
    );
    const rows = exercises.map((exercise) => {
      const entry = record[exercise.id];
      const state = entry?.passed
        ? "passed"
        : entry?.attempts || mine.has(exercise.id)
          ? "begun"
          : "";
      return html(
        "tr",
        { "data-exercise": exercise.id, "data-state": state },
        html("th", { scope: "row" }, html("a", { href: exercise.href }, exercise.title)),
        html("td", {}, `${number(best(exercise))} of ${number(exercise.points)}`),
        html("td", {}, standing(entry, mine.has(exercise.id))),
      );
    });
    table.append(html("tbody", {}, head, ...rows));
  }
  return html(
    "div",
    { class: "table", role: "region", tabindex: "0", "aria-label": "Progress" },
    table,
  );
}

/** Gives the browser a file to save. */
function save(name: string, content: BlobPart, type: string): void {
  const href = URL.createObjectURL(new Blob([content], { type }));
  const link = html("a", { href, download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(href), 60_000);
}

function exportNow(): string {
  const name = `contact-hours-${new Date().toISOString().slice(0, 10)}.zip`;
  save(name, exportWork() as Uint8Array<ArrayBuffer>, "application/zip");
  return name;
}

/** Code of exercises that this version of the book does not have; undefined if there is none. */
function lostCode(known: ReadonlySet<string>): HTMLElement | undefined {
  const lost = Work.ids().filter((id) => !known.has(id));
  if (lost.length === 0) return undefined;
  const items = lost.map((id) => {
    const code = Work.code(id);
    const text = code?.text ?? "";
    const earlier = code?.kept.length ? `, ${counted(code.kept.length, "earlier version")}` : "";
    const saved = code?.saved ? `, saved on ${day(code.saved)}` : "";
    const file = `${id.split("/")[1] ?? id}.cpp`;
    const listing = html(
      "pre",
      { tabindex: "0", "aria-label": `Code of ${id}` },
      html("code", {}, text),
    );
    return html(
      "li",
      { "data-exercise": id },
      html("details", {}, html("summary", {}, `${id}${saved}${earlier}`), listing),
      button(`Save ${file}`, () => save(file, text, "text/x-c++src")),
    );
  });
  return html(
    "section",
    { class: "lost" },
    html("h2", {}, "Exercises this book no longer has"),
    html(
      "p",
      {},
      "A newer version of the book has no place for this code. It is yours, and stays here.",
    ),
    html("ul", {}, ...items),
  );
}

/** What an import did, a sentence each; exercises by their titles where the book has them. */
function told(done: Imported, titles: ReadonlyMap<string, string>): string[] {
  const list = (ids: readonly string[]): string => ids.map((id) => titles.get(id) ?? id).join(", ");
  const said: string[] = [];
  if (done.added.length > 0) said.push(`New here: ${list(done.added)}.`);
  if (done.replaced.length > 0)
    said.push(
      `Changed: ${list(done.replaced)}. What you had before is among the exercise’s earlier versions.`,
    );
  if (done.same.length > 0) said.push(`The same already: ${list(done.same)}.`);
  if (done.yours.length > 0)
    said.push(`Yours stays, as the archive has only the beginning: ${list(done.yours)}.`);
  if (done.progress > 0)
    said.push(
      `Progress of ${counted(done.progress, "exercise")} is merged with yours: the better of both counts.`,
    );
  if (done.ignored.length > 0) said.push(`Left alone: ${list(done.ignored)}.`);
  if (done.problem) said.push(done.problem);
  return said.length > 0 ? said : ["It was empty."];
}

/** Takes in an archive, or a progress.json as the command line keeps it. */
async function importFile(file: File, titles: ReadonlyMap<string, string>): Promise<string[]> {
  const bytes = new Uint8Array(await file.arrayBuffer());
  const isZip = bytes[0] === 0x50 && bytes[1] === 0x4b;
  if (isZip) return told(importWork(bytes), titles);
  const progress = parseProgress(new TextDecoder().decode(bytes));
  if (!progress)
    throw new ArchiveError(
      `${file.name} is neither an archive that was exported here or by contact export, nor a progress.json.`,
    );
  Work.setProgress(mergeProgress(Work.progress(), progress));
  const exercises = Object.keys(progress.exercises).filter(isExerciseId).length;
  const nothing = { added: [], replaced: [], same: [], yours: [], ignored: [] };
  return told({ ...nothing, progress: exercises, problem: Work.problem }, titles);
}

function takeAlong(titles: ReadonlyMap<string, string>): HTMLElement {
  const status = html("div", { role: "status" });
  const say = (...sentences: string[]): void =>
    status.replaceChildren(...sentences.map((sentence) => html("p", {}, sentence)));
  const input = html("input", { type: "file", accept: ".zip,.json", id: "contact-import" });
  input.addEventListener("change", async () => {
    const file = input.files?.[0];
    if (!file) return;
    try {
      say(...(await importFile(file, titles)));
    } catch (error) {
      if (!(error instanceof ArchiveError)) throw error;
      say(error.message, "Nothing was changed.");
    }
    input.value = "";
  });
  const out = button("Export my work", () => say(`Saved as ${exportNow()}.`));
  return html(
    "section",
    { class: "along" },
    html("h2", {}, "Take it with you"),
    html(
      "p",
      {},
      "One file with your code and progress. Another browser takes it in here, and so do ",
      html("code", {}, "contact import"),
      " and ",
      html("code", {}, "contact check"),
      " on the command line.",
    ),
    html("div", { class: "buttons" }, out),
    html(
      "p",
      { class: "import" },
      html(
        "label",
        { for: "contact-import" },
        "Import an archive, or a progress.json of the command line:",
      ),
      input,
    ),
    status,
  );
}

/** Keys and sizes of what the browser's storage holds of the book. */
function stored(): { keys: string[]; bytes: number; code: number } {
  const keys: string[] = [];
  let bytes = 0;
  try {
    for (let index = 0; index < localStorage.length; index += 1) {
      const key = localStorage.key(index);
      if (!key?.startsWith(KEYS)) continue;
      keys.push(key);
      bytes += key.length + (localStorage.getItem(key)?.length ?? 0);
    }
  } catch {
    // The browser keeps nothing, which Work.problem says.
  }
  return { keys, bytes, code: Work.ids().length };
}

export class ContactWork extends HTMLElement {
  #built = false;

  connectedCallback(): void {
    if (this.#built) return;
    const data = this.querySelector<HTMLScriptElement>(':scope > script[type="application/json"]');
    if (!data?.textContent) return;
    this.#built = true;
    this.#build(data, (JSON.parse(data.textContent) as { chapters: readonly Chapter[] }).chapters);
  }

  #build(data: HTMLScriptElement, chapters: readonly Chapter[]): void {
    const base = new URL(this.getAttribute("base") ?? "", document.baseURI);
    const book = new OfflineBook(new URL("../../", base).href);
    const exercises = chapters.flatMap((chapter) => chapter.exercises);
    const titles = new Map(exercises.map(({ id, title }) => [id, title]));
    const known = new Set(titles.keys());
    const work = html("div", { class: "work" });
    const learnt = html("div", { class: "learnt" });
    let asked = 0;
    const showLearnt = async (): Promise<void> => {
      asked += 1;
      const mine = asked;
      // Without the judge the table says enough.
      const shown = await masteryList(base, chapters, Work.progress()).catch(() => undefined);
      if (mine === asked) learnt.replaceChildren(...(shown ? [shown] : []));
    };
    const held = html("p", { class: "held" });
    const showWork = (): void => {
      void showLearnt();
      const problem = Work.problem;
      const lost = lostCode(known);
      work.replaceChildren(
        ...(problem ? [html("p", { class: "problem" }, problem)] : []),
        progressTable(chapters),
        ...(lost ? [lost] : []),
      );
      const { bytes, code } = stored();
      held.textContent =
        bytes === 0
          ? "No work of yours yet."
          : `Your code of ${counted(code, "exercise")}, your progress and your answers: ${sizeText(bytes)}.`;
    };
    const controls = offlineControls(book);
    const offline = html(
      "section",
      { class: "keep" },
      html("h2", {}, "Read it offline"),
      controls.element,
    );
    this.replaceChildren(
      data,
      work,
      learnt,
      takeAlong(titles),
      offline,
      this.#forgetting(book, held, () => {
        showWork();
        controls.look();
      }),
    );
    showWork();
    Work.onChange(showWork);
  }

  /** What is held of the reader, and its end: asked twice, and exported first. */
  #forgetting(book: OfflineBook, held: HTMLElement, changed: () => void): HTMLElement {
    const status = html("p", { role: "status" });
    const ask = html(
      "p",
      {},
      "Your work is saved to a file first: your code as it is now and your progress, but not the earlier versions of your code. Then your code, its earlier versions, your progress and answers, and what is kept for offline reading are removed from this browser.",
    );
    const sure = html("div", { class: "sure", role: "group", "aria-label": "Are you sure?" });
    const first = button("Forget everything", () => {
      sure.hidden = false;
      yes.focus();
    });
    const yes = button("Export, then forget everything", () => void forget());
    const no = button("Keep it", () => {
      sure.hidden = true;
      first.focus();
    });
    sure.append(ask, html("div", { class: "buttons" }, yes, no));
    sure.hidden = true;
    const forget = async (): Promise<void> => {
      const name = exportNow();
      for (const key of stored().keys) localStorage.removeItem(key);
      Work.changedElsewhere(null);
      if ("caches" in globalThis) await book.forget();
      const here = await navigator.serviceWorker?.getRegistration(book.shelf.root);
      await here?.unregister();
      sure.hidden = true;
      status.textContent = `Forgotten. Your work is in ${name}.`;
      changed();
      first.focus();
    };
    return html(
      "section",
      { class: "held" },
      html("h2", {}, "What this browser stores"),
      held,
      html("div", { class: "buttons" }, first),
      sure,
      status,
    );
  }
}

customElements.define("contact-work", ContactWork);
