// What the page and its workers say to each other.

import type { Look, Looks, Manifest, TestResult, TimedTest } from "./types.ts";

/** What is said of a worker whose script does not load: its error event has no words. */
export const NOT_LOADED = "a part of the page did not load";

/** One answer to be compiled and linked. */
export interface Build {
  /** NN_slug/NAME */
  readonly exercise: string;
  /** Files that it may include beside those of the toolchain, by their paths in the repository. */
  readonly files: Readonly<Record<string, string>>;
  readonly source: string;
  /** The exercise's tests, as shipped: opened; or the source of a file that calls the answer. */
  readonly tests: Uint8Array<ArrayBuffer> | string;
}

export type Modules = Readonly<Record<string, WebAssembly.Module>>;

export type ToCompiler =
  | {
      readonly kind: "start";
      /** The address of …/_static/contact/cpp/ */
      readonly folder: string;
      readonly manifest: Manifest;
      /** From a compiler before this one, which then need not be made again. */
      readonly modules: Modules | undefined;
    }
  /** The precompiled header is here: in the cache, or in this blob. */
  | { readonly kind: "prelude"; readonly blob: Blob | undefined }
  | { readonly kind: "build"; readonly build: Build }
  /** Nothing waits for it: the compiler's own code becomes quick by being used. */
  | { readonly kind: "warm" };

export interface Built {
  readonly ok: true;
  readonly program: Uint8Array<ArrayBuffer>;
  /** What the compiler said: warnings. */
  readonly log: string;
  readonly compile: number;
  readonly link: number;
  /** Whether the precompiled header was there. */
  readonly prelude: boolean;
}

export interface NotBuilt {
  readonly ok: false;
  readonly step: "compile" | "link";
  readonly log: string;
  /** The functions that the student's file defines: of use when the linker misses one. */
  readonly defined: readonly string[];
  readonly compile: number;
  readonly link: number;
}

export type FromCompiler =
  | { readonly kind: "arrived"; readonly bytes: number }
  | { readonly kind: "opening" }
  | { readonly kind: "started"; readonly modules: Modules; readonly prelude: boolean }
  | { readonly kind: "failed"; readonly sentence: string; readonly why: string }
  | { readonly kind: "prelude" }
  | { readonly kind: "linking" }
  | { readonly kind: "done"; readonly result: Built | NotBuilt }
  | { readonly kind: "warm" };

/** A program to be run; the thread that runs it is ready before it comes. */
export interface RunOrder {
  readonly program: Uint8Array<ArrayBuffer>;
  readonly tests: readonly TimedTest[];
  readonly seed: string | undefined;
  /** A closer look at what fails, instead of the first wrong answer alone. */
  readonly look?: Look;
}

export type FromRunner =
  | { readonly kind: "start"; readonly test: string }
  | { readonly kind: "test"; readonly result: TestResult }
  | {
      readonly kind: "done";
      readonly results: readonly TestResult[];
      readonly output: string;
      readonly looks: Looks;
    }
  | { readonly kind: "failed"; readonly why: string };

/** What a worker's global scope is, as far as it is used here. */
export interface Scope<In, Out> {
  onmessage: ((event: MessageEvent<In>) => void) | null;
  postMessage(message: Out, transfer?: Transferable[]): void;
}
