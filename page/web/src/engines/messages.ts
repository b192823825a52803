// What the page and its worker tell each other when engines are asked.

import type { Answer, Settings } from "./types.ts";

/** What a reader may set for all engines; undefined: each engine's default. */
export interface Choice {
  /** s */
  readonly step?: number;
  readonly iterations?: number;
  readonly continuous: boolean;
  readonly strict: boolean;
}

export interface ToWorker {
  /** The folder with the page's built files. */
  readonly base: string;
  readonly questions: readonly string[];
  readonly choice: Choice;
}

export type FromWorker =
  | { readonly kind: "loading"; readonly engine: string }
  | {
      readonly kind: "answer";
      readonly question: string;
      readonly engine: string;
      /** Undefined: the engine does not answer this. */
      readonly answer: Answer | undefined;
      /** Undefined: the question has no settings. */
      readonly settings: Settings | undefined;
    }
  /** An engine that could not be loaded. */
  | { readonly kind: "failed"; readonly engine: string; readonly why: string }
  | { readonly kind: "done" };
