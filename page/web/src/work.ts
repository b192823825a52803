// A reader's own work, kept in the reader's browser: code, earlier versions of it, progress, and
// the last verdict of each exercise. No version of the book ever deletes any of it.
//
// localStorage["contact-hours/1/progress"]      as work/progress.json of the command line
// localStorage["contact-hours/1/code/ID"]       Code: the text, the stub it began from, versions
// localStorage["contact-hours/1/forms/ID"]     FormState: lines put in order and gaps filled
// localStorage["contact-hours/1/verdict/ID"]    LastVerdict: what the last check said, and of what
//
// ID is "02_triangles/ray_triangle". The 1 is the version of this format.

const ROOT = "contact-hours/1/";
export const PROGRESS_KEY = `${ROOT}progress`;
export const CODE_PREFIX = `${ROOT}code/`;
export const FORMS_PREFIX = `${ROOT}forms/`;
export const VERDICT_PREFIX = `${ROOT}verdict/`;

export const PROGRESS_FORMAT = "contact-progress/1";
export const MAX_VERSIONS = 20;

/** Why a text was put aside. */
export type Why = "reset" | "solution" | "form" | "import" | "other-tab" | "checked";

/** What a check said of a text, as a verdict has it. */
export interface Said {
  readonly verdict: string;
  readonly points: number;
  readonly max_points: number;
}

export interface Version {
  readonly text: string;
  readonly at: string;
  readonly why: Why;
  /** Absent if it was never checked, or before this was kept. */
  readonly said?: Said;
}

/** Another tab's text, which takes the place of this page's. */
export interface TakenOver {
  readonly text: string;
  /** An import put it there. */
  readonly imported: boolean;
  /** What was here and not yet saved is an earlier version now. */
  readonly aside: boolean;
}

export interface Code {
  readonly text: string;
  /** The fingerprints of the stub and of the contract that the text began from, with a dash
   * between; empty if they are not known. */
  readonly base: string;
  readonly saved: string;
  /** Newest first. */
  readonly kept: readonly Version[];
}

/** In which ways an exercise is answered (grading/progress/progress_record.hpp). */
export const FORMS = ["order", "fill", "write"] as const;
export type Form = (typeof FORMS)[number];
export const isForm = (value: unknown): value is Form => FORMS.includes(value as Form);

export interface ExerciseProgress {
  attempts?: number;
  best_points?: number;
  max_points?: number;
  passed?: string;
  last_checked?: string;
  hints_shown?: number;
  solution_shown?: boolean;
  /** What the present text began from; absent means "write". */
  form?: Form;
  /** For each form in which every test has passed, when that first happened. */
  passed_as?: Record<string, string>;
  tests?: Record<string, string>;
  /** Of each test that fails, the texts with which it did since it last passed. */
  failing?: Record<string, string[]>;
}

export interface Progress {
  format: typeof PROGRESS_FORMAT;
  exercises: Record<string, ExerciseProgress>;
  /** Answers to questions, in an archive only: the page keeps them apart (storage.ts). */
  questions?: unknown;
}

/** What the reader has done in the forms other than writing. */
export interface FormState {
  /** The form that was chosen last. */
  readonly form: string;
  /** The fingerprint of the forms' data: for another version of the book it is not used. */
  readonly of: string;
  /** For each function its lines as they are ordered. */
  readonly order: readonly (readonly { readonly line: number; readonly out: boolean }[])[];
  readonly gaps: readonly string[];
}

export interface LastVerdict {
  readonly at: string;
  /** The text that was checked, as `fingerprint` names it. */
  readonly of: string;
  readonly verdict: unknown;
}

export interface Change {
  readonly what: "code" | "progress" | "verdict";
  /** The exercise, unless it is the progress of all. */
  readonly id?: string;
  /** Another tab or window did it. */
  readonly elsewhere: boolean;
}

type Keeper = Pick<Storage, "getItem" | "setItem" | "removeItem" | "key" | "length">;

const NOWHERE =
  "This browser keeps nothing for this site, so your code is gone when you close the page. Copy it if you want it.";
const FULL =
  "This browser has no more room for this site: what you changed last is gone when you close the page. Export your work.";

const ID = /^\d\d_[a-z][a-z0-9_]*\/[a-z][a-z0-9_]*$/;

/** Whether this can be the name of an exercise, of this version of the book or another. */
export const isExerciseId = (id: string): boolean => ID.test(id);

/** A short name for a text: the same for the same text, and hardly ever for another. */
export function fingerprint(text: string): string {
  let high = 0xdeadbeef;
  let low = 0x41c6ce57;
  for (let index = 0; index < text.length; index += 1) {
    const unit = text.charCodeAt(index);
    high = Math.imul(high ^ unit, 2654435761);
    low = Math.imul(low ^ unit, 1597334677);
  }
  high = Math.imul(high ^ (high >>> 16), 2246822507) ^ Math.imul(low ^ (low >>> 13), 3266489909);
  low = Math.imul(low ^ (low >>> 16), 2246822507) ^ Math.imul(high ^ (high >>> 13), 3266489909);
  const hex = (word: number): string => (word >>> 0).toString(16).padStart(8, "0");
  return hex(high) + hex(low);
}

/** The record with another form for an exercise; an entry that says nothing is left out. */
export function asForm(progress: Progress, id: string, form: Form): Progress {
  const { form: _, ...entry } = progress.exercises[id] ?? {};
  const { [id]: __, ...others } = progress.exercises;
  const changed = form === "write" ? entry : { ...entry, form };
  const exercises = Object.keys(changed).length > 0 ? { ...others, [id]: changed } : others;
  return { ...progress, exercises };
}

export const emptyProgress = (): Progress => ({ format: PROGRESS_FORMAT, exercises: {} });

const isRecord = (value: unknown): value is Record<string, unknown> =>
  typeof value === "object" && value !== null && !Array.isArray(value);

/** What a text says as progress; undefined if it is not that format. */
export function parseProgress(text: string): Progress | undefined {
  try {
    const data: unknown = JSON.parse(text);
    if (!isRecord(data) || data["format"] !== PROGRESS_FORMAT) return undefined;
    const exercises = data["exercises"];
    if (!isRecord(exercises)) return undefined;
    for (const entry of Object.values(exercises)) {
      if (!isRecord(entry)) return undefined;
      if ("tests" in entry && !isRecord(entry["tests"])) return undefined;
    }
    return data as unknown as Progress;
  } catch {
    return undefined;
  }
}

function isSaid(value: unknown): value is Said {
  if (!isRecord(value)) return false;
  const { verdict, points, max_points } = value as Partial<Record<keyof Said, unknown>>;
  return (
    typeof verdict === "string" && typeof points === "number" && typeof max_points === "number"
  );
}

function parseVersion(entry: unknown): Version[] {
  if (!isRecord(entry) || typeof entry["text"] !== "string") return [];
  const { said, ...version } = entry as unknown as Version;
  return [isSaid(said) ? { ...version, said } : version];
}

function parseCode(text: string): Code | undefined {
  try {
    const data: unknown = JSON.parse(text);
    if (!isRecord(data) || typeof data["text"] !== "string") return undefined;
    const kept = Array.isArray(data["kept"]) ? data["kept"] : [];
    return {
      text: data["text"],
      base: typeof data["base"] === "string" ? data["base"] : "",
      saved: typeof data["saved"] === "string" ? data["saved"] : "",
      kept: kept.flatMap(parseVersion),
    };
  } catch {
    return undefined;
  }
}

/** Those that are never thrown out: the newest, the newest that passed, the newest of most points. */
function treasured(all: readonly Version[]): ReadonlySet<Version | undefined> {
  const points = ({ said }: Version): number => said?.points ?? 0;
  const most = Math.max(...all.map(points));
  return new Set([
    all[0],
    all.find(({ said }) => said?.verdict === "passed"),
    most > 0 ? all.find((version) => points(version) === most) : undefined,
  ]);
}

/** The versions with one more. When there are too many, the oldest goes of those that did not
 * compile; else of those that a check put aside; else of all. */
function withVersion(kept: readonly Version[], version: Version): readonly Version[] {
  const said = kept.find(({ text }) => text === version.text)?.said;
  const others = kept.filter(({ text }) => text !== version.text);
  const all = [said ? { ...version, said } : version, ...others];
  while (all.length > MAX_VERSIONS) {
    const stays = treasured(all);
    const spare = all.filter((one) => !stays.has(one));
    const checked = spare.filter(({ why }) => why === "checked");
    const broken = checked.filter((one) => one.said?.verdict === "does_not_compile");
    const goes = broken.at(-1) ?? checked.at(-1) ?? spare.at(-1)!;
    all.splice(all.indexOf(goes), 1);
  }
  return all;
}

export class WorkStore {
  readonly #storage: Keeper | undefined;
  readonly #now: () => Date;
  /** What the browser did not take: it lasts as long as the page. */
  readonly #unkept = new Map<string, string>();
  /** The text of each exercise as this page last read or wrote it. */
  readonly #known = new Map<string, string>();
  readonly #listeners = new Set<(change: Change) => void>();

  constructor(storage: Keeper | undefined, now: () => Date = () => new Date()) {
    this.#storage = storage;
    this.#now = now;
  }

  /** A sentence for the reader if the browser does not keep what it is given. */
  get problem(): string | undefined {
    if (!this.#storage) return NOWHERE;
    return this.#unkept.size > 0 ? FULL : undefined;
  }

  code(id: string): Code | undefined {
    const code = this.#code(id);
    if (code) this.#known.set(id, code.text);
    return code;
  }

  versions(id: string): readonly Version[] {
    return this.#code(id)?.kept ?? [];
  }

  /** What the present text began from; empty if that is not known. Unlike `code`, it takes no
   * notice of what another tab has written. */
  base(id: string): string {
    return this.#code(id)?.base ?? "";
  }

  /** Keeps the text as the present one. A text that another tab has put there meanwhile becomes
   * an earlier version. */
  save(id: string, text: string, base: string): void {
    const there = this.#code(id);
    let kept = there?.kept ?? [];
    if (there && there.text !== text && there.text !== this.#known.get(id))
      kept = withVersion(kept, { text: there.text, at: this.#time(), why: "other-tab" });
    if (there && there.text === text && there.base === base) {
      this.#known.set(id, text);
      return;
    }
    this.#write(id, { text, base, saved: this.#time(), kept });
  }

  /** Puts a copy of the present text, or of another, among the earlier versions. */
  keep(id: string, why: Why, text?: string): void {
    const there = this.#code(id);
    const aside = text ?? there?.text;
    if (!there || aside === undefined) return;
    const version = { text: aside, at: this.#time(), why };
    const known = this.#known.get(id);
    this.#write(id, { ...there, kept: withVersion(there.kept, version) });
    if (text === undefined) return;
    // What is there may be another tab's text, which this page has still not seen.
    if (known === undefined) this.#known.delete(id);
    else this.#known.set(id, known);
  }

  /** Notes with an earlier version what a check said of it. */
  judged(id: string, text: string, { verdict, points, max_points }: Said): void {
    const there = this.#code(id);
    if (!there?.kept.some((version) => version.text === text)) return;
    const said = { verdict, points, max_points };
    const kept = there.kept.map((one) => (one.text === text ? { ...one, said } : one));
    this.#put(CODE_PREFIX + id, JSON.stringify({ ...there, kept }));
    this.#tell({ what: "code", id, elsewhere: false });
  }

  /** Another tab's text, if it is not what this page `saved` last. What is `here` instead, and
   * was not saved, becomes an earlier version. */
  takeOver(id: string, here: string, saved: string): TakenOver | undefined {
    const there = this.#code(id);
    if (!there || there.text === saved) return undefined;
    const [newest] = there.kept;
    const imported = newest?.why === "import" && newest.text === saved;
    const aside = here !== saved && here !== there.text;
    if (aside) this.keep(id, "other-tab", here);
    this.#known.set(id, there.text);
    return { text: there.text, imported, aside };
  }

  /** The exercises with code, also those that the book no longer has. */
  ids(): string[] {
    const keys = new Set(this.#unkept.keys());
    for (let index = 0; index < (this.#storage?.length ?? 0); index += 1) {
      const key = this.#storage?.key(index);
      if (key) keys.add(key);
    }
    return [...keys]
      .filter((key) => key.startsWith(CODE_PREFIX))
      .map((key) => key.slice(CODE_PREFIX.length))
      .filter((id) => this.#code(id) !== undefined)
      .sort();
  }

  /** What has been done so far. A record that cannot be read is put aside, not thrown away. */
  progress(): Progress {
    const text = this.#read(PROGRESS_KEY);
    if (text === null) return emptyProgress();
    const progress = parseProgress(text);
    if (progress) return progress;
    this.#put(`${PROGRESS_KEY}.broken-${this.#time()}`, text);
    this.#put(PROGRESS_KEY, JSON.stringify(emptyProgress()));
    return emptyProgress();
  }

  setProgress(progress: Progress): void {
    this.#put(PROGRESS_KEY, JSON.stringify(progress));
    this.#tell({ what: "progress", elsewhere: false });
  }

  verdict(id: string): LastVerdict | undefined {
    try {
      const data: unknown = JSON.parse(this.#read(VERDICT_PREFIX + id) ?? "null");
      return isRecord(data) && typeof data["of"] === "string"
        ? (data as unknown as LastVerdict)
        : undefined;
    } catch {
      return undefined;
    }
  }

  forms(id: string): FormState | undefined {
    try {
      const data: unknown = JSON.parse(this.#read(FORMS_PREFIX + id) ?? "null");
      return isRecord(data) && Array.isArray(data["order"]) && Array.isArray(data["gaps"])
        ? (data as unknown as FormState)
        : undefined;
    } catch {
      return undefined;
    }
  }

  setForms(id: string, state: FormState): void {
    this.#put(FORMS_PREFIX + id, JSON.stringify(state));
  }

  setVerdict(id: string, text: string, verdict: unknown): void {
    const last: LastVerdict = { at: this.#time(), of: fingerprint(text), verdict };
    this.#put(VERDICT_PREFIX + id, JSON.stringify(last));
    this.#tell({ what: "verdict", id, elsewhere: false });
  }

  /** Calls `listener` after each change, in this tab or another; returns how to stop that. */
  onChange(listener: (change: Change) => void): () => void {
    this.#listeners.add(listener);
    return () => this.#listeners.delete(listener);
  }

  /** Another tab has changed the value of this key; null means everything. */
  changedElsewhere(key: string | null): void {
    if (key === null) {
      for (const id of this.#known.keys()) this.#tell({ what: "code", id, elsewhere: true });
      this.#tell({ what: "progress", elsewhere: true });
    } else if (key.startsWith(CODE_PREFIX))
      this.#tell({ what: "code", id: key.slice(CODE_PREFIX.length), elsewhere: true });
    else if (key.startsWith(VERDICT_PREFIX))
      this.#tell({ what: "verdict", id: key.slice(VERDICT_PREFIX.length), elsewhere: true });
    else if (key === PROGRESS_KEY) this.#tell({ what: "progress", elsewhere: true });
  }

  #time(): string {
    return this.#now()
      .toISOString()
      .replace(/\.\d+Z$/, "Z");
  }

  #code(id: string): Code | undefined {
    const text = this.#read(CODE_PREFIX + id);
    return text === null ? undefined : parseCode(text);
  }

  #write(id: string, code: Code): void {
    this.#known.set(id, code.text);
    this.#put(CODE_PREFIX + id, JSON.stringify(code));
    this.#tell({ what: "code", id, elsewhere: false });
  }

  #read(key: string): string | null {
    return this.#unkept.get(key) ?? this.#storage?.getItem(key) ?? null;
  }

  #put(key: string, value: string): void {
    try {
      if (!this.#storage) throw new Error("no storage");
      this.#storage.setItem(key, value);
      this.#unkept.delete(key);
    } catch {
      this.#unkept.set(key, value);
      return;
    }
    // There may be room again for what was refused before.
    for (const [other, waiting] of this.#unkept) {
      try {
        this.#storage.setItem(other, waiting);
        this.#unkept.delete(other);
      } catch {
        break;
      }
    }
  }

  #tell(change: Change): void {
    for (const listener of this.#listeners) listener(change);
  }
}

/** The browser's storage, if it really keeps something. */
function browserStorage(): Keeper | undefined {
  try {
    const storage = globalThis.localStorage;
    const probe = `${ROOT}probe`;
    storage.setItem(probe, "1");
    storage.removeItem(probe);
    return storage;
  } catch {
    return undefined;
  }
}

export const Work = new WorkStore(browserStorage());

if (typeof window !== "undefined")
  window.addEventListener("storage", ({ key }) => Work.changedElsewhere(key));
