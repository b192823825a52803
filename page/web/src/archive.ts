// A reader's work as one file, as `contact export` writes and `contact check`, `grade` and `import`
// read it: a zip archive of
//
//   contact-submission.json      {"format": "contact-submission/1", "exported": time, "from": "page"}
//   work/progress.json           the record of progress, with the answers to questions
//   work/NN_slug/NAME.cpp        the code, one file an exercise

import { strFromU8, strToU8, unzipSync, type Zippable, zipSync } from "fflate";
import { allAnswers, takeAnswers } from "./storage.ts";
import {
  type ExerciseProgress,
  fingerprint,
  isExerciseId,
  isForm,
  PROGRESS_FORMAT,
  type Progress,
  Work,
  type WorkStore,
} from "./work.ts";

export const SUBMISSION_FORMAT = "contact-submission/1";

const ABOUT = "contact-submission.json";
const PROGRESS = "work/progress.json";
const CODE = /^work\/(.+)\.cpp$/;
/** No solution is longer; an archive with a longer file is not a reader's. */
const MAX_BYTES = 1 << 20;
const MAX_FILES = 1000;
const MAX_UNPACKED = 20 * 1024 * 1024;

export interface Imported {
  /** Exercises whose code is now the archive's. The former text is an earlier version of each in
   * `replaced`. */
  readonly added: readonly string[];
  readonly replaced: readonly string[];
  /** Exercises whose code was the same already. */
  readonly same: readonly string[];
  /** Exercises of which the archive has only the book's own beginning: the code here stays. */
  readonly yours: readonly string[];
  /** How many exercises the archive's record of progress speaks of. */
  readonly progress: number;
  /** Files that were left alone: not a reader's work, or too large. */
  readonly ignored: readonly string[];
  /** A sentence if the browser did not keep all of it. */
  readonly problem: string | undefined;
}

/** Says to the reader why a file cannot be imported. Nothing was changed. */
export class ArchiveError extends Error {}

export function exportWork(store: WorkStore = Work, now = new Date()): Uint8Array {
  const exported = now.toISOString().replace(/\.\d+Z$/, "Z");
  const about = { format: SUBMISSION_FORMAT, exported, from: "page" };
  const json = (data: unknown): Uint8Array => strToU8(`${JSON.stringify(data, null, 2)}\n`);
  const questions = allAnswers();
  const known = Object.keys(questions).length > 0 ? { questions } : {};
  const record = { ...store.progress(), ...known };
  const files: Zippable = { [ABOUT]: json(about), [PROGRESS]: json(record) };
  for (const id of store.ids()) files[`work/${id}.cpp`] = strToU8(store.code(id)?.text ?? "");
  return zipSync(files, { mtime: now });
}

interface Contents {
  readonly code: ReadonlyMap<string, string>;
  readonly progress: Progress | undefined;
  readonly ignored: readonly string[];
}

function text(bytes: Uint8Array, name: string): string {
  try {
    return new TextDecoder("utf-8", { fatal: true }).decode(bytes);
  } catch {
    throw new ArchiveError(`${name} in this archive is not text in UTF-8.`);
  }
}

function requireOurs(bytes: Uint8Array | undefined): void {
  let format: unknown;
  try {
    format = bytes && JSON.parse(strFromU8(bytes)).format;
  } catch {
    format = undefined;
  }
  if (format === SUBMISSION_FORMAT) return;
  if (typeof format === "string" && /^contact-submission\/\d+$/.test(format))
    throw new ArchiveError("This archive comes from a newer version of the book than this one.");
  throw new ArchiveError(
    `This archive is not an export of Contact Hours: it holds no ${ABOUT} that says so.`,
  );
}

/** A record that need not be sound in every entry: what is not is passed over when merging. */
function readRecord(json: string): Progress | undefined {
  try {
    const { format, exercises } = JSON.parse(json);
    return format === PROGRESS_FORMAT && isObject(exercises) ? JSON.parse(json) : undefined;
  } catch {
    return undefined;
  }
}

function open(bytes: Uint8Array): Contents {
  const ignored: string[] = [];
  let count = 0;
  let unpacked = 0;
  const wanted = ({ name, originalSize }: { name: string; originalSize: number }): boolean => {
    if (name.endsWith("/")) return false;
    count += 1;
    const known = name === ABOUT || name === PROGRESS || isExerciseId(CODE.exec(name)?.[1] ?? "");
    if (known && originalSize <= MAX_BYTES && count <= MAX_FILES) {
      unpacked += originalSize;
      if (unpacked > MAX_UNPACKED) throw new ArchiveError("This archive unpacks to over 20 MB.");
      return true;
    }
    ignored.push(name);
    return false;
  };
  let files: Record<string, Uint8Array>;
  try {
    files = unzipSync(bytes, { filter: wanted });
  } catch (error) {
    if (error instanceof ArchiveError) throw error;
    throw new ArchiveError("This file is not a zip archive, or it is damaged.");
  }
  requireOurs(files[ABOUT]);
  const code = new Map<string, string>();
  for (const [name, content] of Object.entries(files)) {
    const id = CODE.exec(name)?.[1];
    if (id) code.set(id, text(content, name));
  }
  const record = files[PROGRESS];
  const progress = record && readRecord(text(record, PROGRESS));
  if (record && !progress)
    throw new ArchiveError(`${PROGRESS} in this archive is not a record of progress.`);
  return { code, progress, ignored };
}

const TIME = /^\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d(\.\d{1,9})?Z$/;
/** An upper limit on attempts. */
const MAX_COUNTED = 1e6;

const isObject = (value: unknown): value is Record<string, unknown> =>
  typeof value === "object" && value !== null && !Array.isArray(value);
const isTime = (value: unknown): value is string => typeof value === "string" && TIME.test(value);
const clamped = (value: unknown): number =>
  typeof value === "number" ? Math.min(Math.max(value, 0), MAX_COUNTED) : 0;

function soundTimes(passedAs: object): Record<string, string> {
  return Object.fromEntries(
    Object.entries(passedAs).filter(([form, time]) => isForm(form) && isTime(time)),
  );
}

/** The members of the right type, and all unknown members. */
function sound(entry: object): ExerciseProgress {
  const kinds: Record<string, (value: unknown) => unknown> = {
    attempts: (value) => (typeof value === "number" ? Math.trunc(clamped(value)) : undefined),
    hints_shown: (value) => (typeof value === "number" ? Math.trunc(clamped(value)) : undefined),
    best_points: (value) => (typeof value === "number" ? clamped(value) : undefined),
    max_points: (value) => (typeof value === "number" ? clamped(value) : undefined),
    passed: (value) => (isTime(value) ? value : undefined),
    last_checked: (value) => (isTime(value) ? value : undefined),
    solution_shown: (value) => (typeof value === "boolean" ? value : undefined),
    form: (value) => (isForm(value) ? value : undefined),
    passed_as: (value) => (isObject(value) ? soundTimes(value) : undefined),
    tests: (value) => (isObject(value) ? value : undefined),
    failing: (value) => (isObject(value) ? value : undefined),
  };
  const kept = Object.entries(entry)
    .map(([name, value]) => [name, Object.hasOwn(kinds, name) ? kinds[name]!(value) : value])
    .filter(([, value]) => value !== undefined);
  return Object.fromEntries(kept);
}

/** A time is compared without its fraction, which only the page writes. */
const seconds = (time: unknown): string => (isTime(time) ? time.slice(0, 19) : "");

/** The better of two records of one exercise: best points, earliest pass, most attempts, most
 * help. All else is of the later check. */
function mergeEntry(ours: ExerciseProgress, theirs: ExerciseProgress): ExerciseProgress {
  const theirsIsLater = seconds(theirs.last_checked) > seconds(ours.last_checked);
  const merged = theirsIsLater ? { ...ours, ...theirs } : { ...theirs, ...ours };
  for (const name of ["attempts", "best_points", "hints_shown"] as const) {
    const best = clamped(theirs[name]) > clamped(ours[name]) ? theirs[name] : ours[name];
    if (best !== undefined) merged[name] = best;
  }
  const [our, their] = [seconds(ours.passed), seconds(theirs.passed)];
  const passed = our && (!their || our <= their) ? ours.passed : their ? theirs.passed : undefined;
  if (passed) merged.passed = passed;
  const as: Record<string, string> = {};
  for (const times of [ours.passed_as, theirs.passed_as])
    for (const [form, time] of Object.entries(isObject(times) ? soundTimes(times) : {}))
      if (!as[form] || seconds(time) < seconds(as[form])) as[form] = time;
  if (Object.keys(as).length > 0) merged.passed_as = as;
  if (ours.solution_shown === true || theirs.solution_shown === true) merged.solution_shown = true;
  return merged;
}

/** Both records as one, as `contact import` makes it (cli/README.md), without the answers to
 * questions, which the page keeps apart. */
export function mergeProgress(ours: Progress, theirs: Progress): Progress {
  const exercises = { ...ours.exercises };
  for (const [id, entry] of Object.entries(theirs.exercises))
    if (isExerciseId(id) && isObject(entry))
      exercises[id] = mergeEntry(exercises[id] ?? {}, sound(entry));
  const { questions: _kept, ...others } = { ...theirs, ...ours };
  return { ...others, exercises };
}

/** Imports an archive. No text is lost: one that is replaced becomes an earlier version. */
export function importWork(bytes: Uint8Array, store: WorkStore = Work): Imported {
  const { code, progress, ignored } = open(bytes);
  const added: string[] = [];
  const replaced: string[] = [];
  const same: string[] = [];
  const yours: string[] = [];
  for (const [id, content] of code) {
    const present = store.code(id);
    if (present?.text === content) {
      same.push(id);
      continue;
    }
    // `base` begins with the fingerprint of the stub.
    if (present?.base.startsWith(`${fingerprint(content)}-`)) {
      yours.push(id);
      continue;
    }
    if (present) store.keep(id, "import");
    store.save(id, content, present?.base ?? "");
    (present ? replaced : added).push(id);
  }
  if (progress) {
    store.setProgress(mergeProgress(store.progress(), progress));
    takeAnswers(progress.questions);
  }
  const entries = Object.keys(progress?.exercises ?? {}).filter(isExerciseId).length;
  return { added, replaced, same, yours, progress: entries, ignored, problem: store.problem };
}
