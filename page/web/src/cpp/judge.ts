// The book's own judge in the page: the grading library under `contact check` as WebAssembly (page/wasm/judge.mjs).
// It reads the book's files as the program does, from a tree; here the tree is in memory. Works in the page, in a
// worker and in Node.

import {
  ConsoleStdout,
  Directory,
  File,
  OpenFile,
  PreopenDirectory,
  WASI,
} from "@bjorn3/browser_wasi_shim";
import type {
  Judge,
  Look,
  ProgressRecord,
  ProgressReport,
  Ran,
  TestResult,
  TimedTest,
  Uncompiled,
  VerdictJson,
} from "./types.ts";

/** The book's files by their paths in the repository: exercise.toml, contracts, chapter.toml, misconceptions.toml. */
export type Files = Readonly<Record<string, string>>;

/** The judge could not answer: a name that the book does not have, a record of progress that is none, a broken file. */
export class JudgeError extends Error {
  override readonly name = "JudgeError";
}

interface Exports {
  readonly memory: WebAssembly.Memory;
  judge_room(bytes: number): number;
  judge_answer(request: number, bytes: number): number;
}

/** @param files what may be asked about; the judge knows no other exercise, chapter or misconception */
export async function loadJudge(
  wasm: BufferSource | WebAssembly.Module,
  files: Files,
): Promise<BookJudge> {
  const module = wasm instanceof WebAssembly.Module ? wasm : await WebAssembly.compile(wasm);
  return new BookJudge(module, files);
}

type Folder = Map<string, File | Directory>;

function tree(files: Files): Folder {
  const encoder = new TextEncoder();
  const top: Folder = new Map();
  for (const [path, text] of Object.entries(files)) {
    const parts = path.split("/");
    const name = parts.pop() ?? "";
    let folder = top;
    for (const part of parts) {
      let next = folder.get(part);
      if (!(next instanceof Directory)) {
        next = new Directory(new Map());
        folder.set(part, next);
      }
      folder = next.contents as Folder;
    }
    folder.set(name, new File(encoder.encode(text)));
  }
  return top;
}

export class BookJudge implements Judge {
  readonly #module: WebAssembly.Module;
  readonly #files: Files;
  #exports: Exports | undefined;
  #printed = "";

  constructor(module: WebAssembly.Module, files: Files) {
    this.#module = module;
    this.#files = files;
    this.#exports = this.#start();
  }

  /** The tests in their order, each with what it may take in a check. */
  tests(exercise: string): TimedTest[] {
    return this.#ask({ do: "tests", exercise });
  }

  /** The test of which more is to be found out, since it has failed before with other code. */
  again(
    exercise: string,
    progress: ProgressRecord,
    results: readonly TestResult[],
    source: string,
  ): { test: string; look: Look } | null {
    return this.#ask({ do: "again", exercise, progress, results, source });
  }

  /** Points, skips and hints from what happened to each test. */
  judge(exercise: string, results: readonly TestResult[], ran: Ran = {}): VerdictJson {
    return this.#ask({ do: "judge", exercise, results, ...ran });
  }

  /** The verdict on a file that does not compile or link, in words for a beginner. */
  uncompiled(exercise: string, what: Uncompiled): VerdictJson {
    return this.#ask({ do: "uncompiled", exercise, ...what });
  }

  /** The record with this verdict in it. What was not attempted, or does not compile, is no attempt. */
  record(progress: ProgressRecord, verdict: VerdictJson, now: string): ProgressRecord {
    return this.#ask({ do: "record", progress, verdict, now });
  }

  recordHint(progress: ProgressRecord, exercise: string): ProgressRecord {
    return this.#ask({ do: "record_hint", progress, exercise });
  }

  recordSolutionShown(progress: ProgressRecord, exercise: string): ProgressRecord {
    return this.#ask({ do: "record_solution_shown", progress, exercise });
  }

  /** A record in which nothing is done yet. */
  emptyProgress(): ProgressRecord {
    return this.#ask({ do: "empty_progress" });
  }

  report(progress: ProgressRecord): ProgressReport {
    return this.#ask({ do: "report", progress });
  }

  /** Files of the book that could not be read, each with the reason. */
  problems(): string[] {
    return this.#ask({ do: "problems" });
  }

  #start(): Exports {
    const printed = () =>
      new ConsoleStdout((bytes) => {
        this.#printed += new TextDecoder().decode(bytes);
      });
    const wasi = new WASI(
      [],
      [],
      [
        new OpenFile(new File([])),
        printed(),
        printed(),
        new PreopenDirectory("/", tree(this.#files)),
      ],
      { debug: false },
    );
    const instance = new WebAssembly.Instance(this.#module, {
      wasi_snapshot_preview1: wasi.wasiImport,
    });
    wasi.initialize(instance as Parameters<WASI["initialize"]>[0]);
    return instance.exports as unknown as Exports;
  }

  #ask<Answer>(request: Record<string, unknown>): Answer {
    this.#exports ??= this.#start();
    this.#printed = "";
    const exports = this.#exports;
    const bytes = new TextEncoder().encode(JSON.stringify(request));
    let text: string;
    try {
      const room = exports.judge_room(bytes.length);
      new Uint8Array(exports.memory.buffer).set(bytes, room);
      const reply = exports.judge_answer(room, bytes.length);
      const memory = new Uint8Array(exports.memory.buffer);
      text = new TextDecoder().decode(memory.slice(reply, memory.indexOf(0, reply)));
    } catch (error) {
      // It stopped in the middle of a call: the next one starts afresh.
      this.#exports = undefined;
      const why = this.#printed.trim() || (error instanceof Error ? error.message : String(error));
      throw new JudgeError(why, { cause: error });
    }
    const answer = JSON.parse(text) as { ok: Answer } | { error: string };
    if ("error" in answer) throw new JudgeError(answer.error);
    return answer.ok;
  }
}
