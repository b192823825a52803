// What the page remembers of a reader, on the reader's own machine only.
//
// localStorage["contact-hours/1/questions"] is a JSON object from a question's name
// ("02_triangles/beta-sign") to { kind, answer, right, tries, at }: the last answer given (a number
// with its unit as typed, an index, a list of indices, true for a construction, the texts of the gaps,
// or what the reader wrote), whether it was right, how many answers were given, and when (ISO time).
// To say why is never right or wrong: right is false, and `marks` has which of the criteria the reader
// marked. The 1 is the version of this format: a reader's later page never misreads an earlier one's
// record. `contact ask` keeps the same in work/progress.json.

export interface Answered {
  readonly kind: string;
  readonly answer: string | number | boolean | readonly number[] | readonly string[];
  readonly right: boolean;
  readonly marks?: readonly boolean[];
  readonly tries: number;
  readonly at: string;
}

export const QUESTIONS_KEY = "contact-hours/1/questions";

function readAll(): Record<string, Answered> {
  try {
    const kept: unknown = JSON.parse(localStorage.getItem(QUESTIONS_KEY) ?? "{}");
    return typeof kept === "object" && kept !== null ? (kept as Record<string, Answered>) : {};
  } catch {
    return {};
  }
}

export function recall(id: string): Answered | undefined {
  return readAll()[id];
}

/** Keeps an answer; where the browser keeps nothing, the page works all the same. */
export function remember(id: string, answer: Omit<Answered, "tries" | "at">): void {
  const all = readAll();
  const tries = (all[id]?.tries ?? 0) + 1;
  writeAll({ ...all, [id]: { ...answer, tries, at: new Date().toISOString() } });
}

/** Keeps which criteria the reader has marked in the answer that was kept last. */
export function mark(id: string, marks: readonly boolean[]): void {
  const all = readAll();
  const kept = all[id];
  if (kept) writeAll({ ...all, [id]: { ...kept, marks, at: new Date().toISOString() } });
}

function writeAll(all: Record<string, Answered>): void {
  try {
    localStorage.setItem(QUESTIONS_KEY, JSON.stringify(all));
  } catch {
    // Storage is full or switched off.
  }
}

/** All answers, for an archive of the reader's work. */
export const allAnswers = readAll;

const NAME = /^\d\d_[a-z][a-z0-9_]*\/[a-z0-9][a-z0-9_-]*$/;
const TIME = /^\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d(\.\d{1,9})?Z$/;
const MAX_TRIES = 1e6;
/** A reader writes a few sentences; a longer answer is not one. */
const LONGEST = 20_000;

function isAnswer(entry: unknown): entry is Answered {
  if (typeof entry !== "object" || entry === null) return false;
  const { kind, answer, right, tries, at } = entry as Partial<Answered>;
  return (
    typeof kind === "string" &&
    answer !== undefined &&
    typeof right === "boolean" &&
    typeof tries === "number" &&
    typeof at === "string" &&
    TIME.test(at) &&
    JSON.stringify(entry).length <= LONGEST
  );
}

/** Takes in the answers of an archive, as `contact import` does: the later one to each question. */
export function takeAnswers(theirs: unknown): void {
  if (typeof theirs !== "object" || theirs === null) return;
  const all = readAll();
  for (const [id, entry] of Object.entries(theirs)) {
    if (id.length >= 120 || !NAME.test(id) || !isAnswer(entry)) continue;
    const ours = isAnswer(all[id]) ? all[id] : undefined;
    const later = !ours || entry.at.slice(0, 19) > ours.at.slice(0, 19) ? entry : ours;
    const most = Math.max(entry.tries, ours?.tries ?? 0, 0);
    all[id] = { ...later, tries: Math.trunc(Math.min(most, MAX_TRIES)) };
  }
  writeAll(all);
}
