// What passes between the parts that check an answer in the page. Names follow `contact check --json`
// (cli/README.md), so that a verdict reads the same wherever it was made.

import type { FormData } from "../exercise/form-data.ts";

export interface Input {
  readonly name: string;
  readonly text: string;
}

/** Why a test did not pass. Parts that have nothing to say are empty or absent. */
export interface Failure {
  readonly asked: string;
  readonly inputs: readonly Input[];
  readonly got?: string;
  readonly right?: string;
  /** How far from `right` an answer may be. */
  readonly allowed?: string;
  /** Every known mistake that gives this answer. */
  readonly misconceptions?: readonly string[];
  /** The judge adds it, if exactly one mistake gives this answer. */
  readonly hint?: string;
  /** The judge adds one about each, if several mistakes give this answer. */
  readonly questions?: readonly string[];
  /** What stopped the test, or why it was skipped. */
  readonly reason?: string;
}

/** What is said beyond the first wrong answer to a reader who has failed the same test before, each time with other
 * code. */
export interface CloserLook {
  /** How many of the test's questions the code answers right, and how many wrong. */
  readonly right: number;
  readonly wrong: number;
  /** The inputs of the first few of each. */
  readonly right_inputs?: readonly (readonly Input[])[];
  readonly wrong_inputs?: readonly (readonly Input[])[];
  /** The same with inputs that fit the head. */
  readonly smaller?: Failure;
  /** One of the exercise's hints, counted from 1. */
  readonly hint_number?: number;
  readonly hint?: string;
}

/** How much is to be found out: which inputs are answered right, or also a smaller one that is not. */
export type Look = "inputs" | "smaller";

/** By the names of tests. */
export type Looks = Readonly<Record<string, CloserLook>>;

/** A test and what it may take, in seconds. */
export interface TimedTest {
  readonly name: string;
  readonly seconds: number;
}

/** What the runner saw happen to one test. */
export interface TestResult {
  readonly name: string;
  /** "skipped": it was not run. */
  readonly status: "passed" | "failed" | "not_attempted" | "stopped" | "skipped";
  readonly failure?: Failure;
  /** What a test that passed has to show, in the same form. */
  readonly finding?: Failure;
  readonly seconds: number;
  readonly look?: CloserLook;
}

export interface TestVerdict {
  readonly name: string;
  readonly status: TestResult["status"];
  readonly points: number;
  readonly max_points: number;
  readonly seconds: number;
  /** Where it is not "shown". */
  readonly visibility?: "after_due" | "values_withheld" | "hidden";
  readonly failure?: Failure;
  /** The earlier test that fails for the same cause. */
  readonly same_as?: string;
  readonly look?: CloserLook;
  readonly finding?: Failure;
}

/** One message of the compiler. Lines and columns count from 1. */
export interface Diagnostic {
  readonly file: string;
  readonly line: number;
  readonly column: number;
  readonly end_line: number;
  readonly end_column: number;
  readonly severity: "error" | "warning" | "note";
  /** The compiler's own words. */
  readonly message: string;
  /** A sentence for a beginner. */
  readonly words: string;
  /** Which of the known mistakes it is, if one is recognised. */
  readonly mistake?: string;
}

export interface CompileError {
  readonly file: string;
  readonly line: number;
  readonly column: number;
  readonly message: string;
  readonly excerpt: string;
  readonly explanation: string;
  readonly contract: readonly { readonly file: string; line: number; text: string }[];
  /** All that the compiler said. */
  readonly full: string;
}

export interface Seconds {
  readonly compile: number;
  readonly link: number;
  readonly run: number;
}

export type Outcome = "passed" | "failed" | "not_attempted" | "does_not_compile";

/** One element of `results` in `contact check --json`. */
export interface VerdictJson {
  readonly exercise: string;
  readonly file: string;
  readonly verdict: Outcome;
  readonly points: number;
  readonly max_points: number;
  readonly tests: readonly TestVerdict[];
  readonly warnings: readonly string[];
  readonly diagnostics?: readonly Diagnostic[];
  /** What the student's program printed, cut at a limit. */
  readonly output: string;
  readonly seconds: Seconds;
  /** Names the text that was checked, without its blanks and comments. */
  readonly code?: string;
  readonly compile_error?: CompileError;
}

/** _static/contact/exercises/NN_slug/NAME.json, written when the page is rendered. */
export interface ExerciseData {
  readonly format: "contact-exercise/1";
  /** NN_slug/NAME */
  readonly id: string;
  readonly chapter: string;
  readonly name: string;
  readonly title: string;
  readonly kind: string;
  readonly points: number;
  /** The book's own files of this exercise, by their paths in the repository. */
  readonly files: Readonly<Record<string, string>>;
  /** As HTML, in order. */
  readonly hints: readonly string[];
  /** The hint of each misconception that a test may recognise, as HTML. */
  readonly misconceptions: Readonly<Record<string, string>>;
  /** What the other forms are made of, if the solution has marks. */
  readonly form?: FormData;
}

/** _static/contact/exercises/book.json */
export interface BookData {
  readonly format: "contact-book/1";
  readonly files: Readonly<Record<string, string>>;
  readonly exercises: readonly string[];
  readonly titles: Readonly<Record<string, string>>;
  readonly points: Readonly<Record<string, number>>;
}

/** A file of the toolchain as it is shipped; `file` is relative to _static/contact/cpp/. */
export interface ShippedFile {
  readonly file: string;
  /** Its size when opened. */
  readonly bytes: number;
  /** Its size on the way. */
  readonly transfer: number;
}

/** _static/contact/cpp/manifest.json, made by page/wasm/build.mjs. */
export interface Manifest {
  readonly format: "contact-cpp/1";
  readonly files: Readonly<Record<string, ShippedFile>>;
  /** What a first check needs. */
  readonly core: readonly string[];
  /** What is fetched behind the reader's back: it makes checks faster. */
  readonly behind: readonly string[];
  readonly compile: {
    readonly flags: readonly string[];
    readonly withPrelude: readonly string[];
    readonly include: readonly string[];
    readonly diagnostics: readonly string[];
  };
  readonly link: { readonly before: readonly string[]; readonly after: readonly string[] };
  readonly exercises: Readonly<Record<string, ShippedFile>>;
}

/** Bytes still to be transferred before a check; 0 for what the browser has kept. */
export interface Size {
  readonly core: number;
  readonly behind: number;
  /** Whether the browser keeps what is downloaded, so that the next visit needs no network. */
  readonly kept: boolean;
}

/** "wait": what is needed is still being built by `./contact serve`. */
export type Step = "wait" | "download" | "start" | "compile" | "link" | "run";

export interface Progress {
  readonly step: Step;
  /** While downloading: bytes so far and of how many. */
  readonly received?: number;
  readonly total?: number;
  /** While waiting: what for, a sentence. */
  readonly words?: string;
  /** While running: the test that has begun. */
  readonly test?: string;
}

export type Tell = (progress: Progress) => void;

export interface CheckOptions {
  /** What random inputs start from; without it always the same. */
  readonly seed?: string;
  readonly signal?: AbortSignal;
  /** What was done before: a test that fails again has more said of it. */
  readonly progress?: ProgressRecord;
  /** Each test's result as it ends, before the verdict. */
  readonly onTest?: (result: TestResult) => void;
}

/** Something that the reader can act on: `message` is the sentence to show. */
export class CheckerError extends Error {
  override readonly name = "CheckerError";
}

/** What `contact progress --json` says (cli/README.md). */
export type ProgressReport = Readonly<Record<string, unknown>>;

/** work/progress.json. */
export interface ProgressRecord {
  readonly format: "contact-progress/1";
  readonly exercises: Readonly<Record<string, unknown>>;
}

/** What else is known of a file whose tests ran. */
export interface Ran {
  /** The student's text, and what the compiler said of it: warnings then have their place. */
  readonly source?: string;
  readonly log?: string;
  /** What the student's program printed. */
  readonly output?: string;
  /** Before this check: for the next hint. */
  readonly progress?: ProgressRecord | undefined;
}

/** A source file that came to nothing. */
export interface Uncompiled {
  readonly step: "compile" | "link";
  /** All that the compiler or the linker said. */
  readonly log: string;
  readonly source: string;
  /** The functions that the student's file defines, if the linker did not find one. */
  readonly defined?: readonly string[];
}

/** The book's own judge (grading/verdict/verdict.cpp and its kin, as WebAssembly). Every call is over at once. */
export interface Judge {
  /** The tests in their order, each with what it may take in a check. */
  tests(id: string): TimedTest[];
  /** The test of which more is to be found out, since it has failed before with other code. */
  again(
    id: string,
    progress: ProgressRecord,
    results: readonly TestResult[],
    source: string,
  ): { readonly test: string; readonly look: Look } | null;
  judge(id: string, results: readonly TestResult[], ran?: Ran): VerdictJson;
  uncompiled(id: string, what: Uncompiled): VerdictJson;
  /** The record after a check, a hint, a look at the solution. */
  record(progress: ProgressRecord, verdict: VerdictJson, now: string): ProgressRecord;
  recordHint(progress: ProgressRecord, id: string): ProgressRecord;
  recordSolutionShown(progress: ProgressRecord, id: string): ProgressRecord;
  report(progress: ProgressRecord): ProgressReport;
}
