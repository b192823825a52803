// Checks an answer in the page. One checker serves all exercises of a page: one download, one compiler.

import { untilBuilt } from "../pending.ts";
import { abortable } from "./abort.ts";
import { Downloads, openStore } from "./download.ts";
import { loadJudge } from "./judge.ts";
import { Runners } from "./runner.ts";
import { Toolchain } from "./toolchain.ts";
import {
  type BookData,
  CheckerError,
  type CheckOptions,
  type ExerciseData,
  type Judge,
  type ShippedFile,
  type Size,
  type Tell,
  type TimedTest,
  type VerdictJson,
} from "./types.ts";

interface Parts {
  readonly downloads: Downloads;
  readonly toolchain: Toolchain;
}

export class Checker {
  static readonly #all = new Map<string, Checker>();

  /** The checker of a page; `base` is the address of …/_static/contact/. */
  static for(base: string): Checker {
    const address = new URL(base, document.baseURI).href;
    const known = Checker.#all.get(address) ?? new Checker(address);
    Checker.#all.set(address, known);
    return known;
  }

  readonly #base: string;
  readonly #parts: Promise<Parts>;
  readonly #runners: Runners;
  readonly #judges = new Map<string, Promise<Judge>>();
  #judgeParts: Promise<[WebAssembly.Module, BookData]> | undefined;

  private constructor(base: string) {
    this.#base = base;
    this.#runners = new Runners(new URL("run-worker.js", base).href);
    this.#parts = this.#open();
  }

  async #open(): Promise<Parts> {
    const folder = new URL("cpp/", this.#base).href;
    const store = await openStore();
    const downloads = new Downloads(folder, { fetch: globalThis.fetch.bind(globalThis), store });
    const script = new URL("compile-worker.js", this.#base).href;
    return { downloads, toolchain: new Toolchain(downloads, folder, script) };
  }

  /** What is still to be downloaded. Never downloads the toolchain. */
  async size(): Promise<Size> {
    return (await this.#parts).toolchain.size();
  }

  /** Downloads and starts what a check needs, so that the first check is quick. */
  async prepare(id: string, tell: Tell, signal?: AbortSignal): Promise<void> {
    const { toolchain } = await this.#parts;
    await this.#tests(id, tell, signal);
    await toolchain.ready(tell, signal);
    this.#runners.prepare();
    tell({ step: "start" });
    await abortable(toolchain.warm(), signal);
  }

  /** From a text to its verdict. A signal that is aborted stops whatever is being done for this check alone. */
  async check(
    data: ExerciseData,
    source: string,
    tell: Tell,
    { seed, signal, onTest, progress }: CheckOptions = {},
  ): Promise<VerdictJson> {
    signal?.throwIfAborted();
    const { downloads, toolchain } = await this.#parts;
    // A lone half of a surrogate pair is no text, and C++ could not say so.
    const whole = new TextDecoder().decode(new TextEncoder().encode(source));
    const shipped = await this.#tests(data.id, tell, signal);
    // Small, so side by side with the rest.
    const small = Promise.all([downloads.bytes(shipped), this.judge(data)]);
    small.catch(() => toolchain.forget()); // told below, when its turn comes
    await toolchain.ready(tell, signal);
    const [linked, judge] = await abortable(small, signal);
    this.#runners.prepare();

    const build = { exercise: data.id, files: data.files, source: whole, tests: linked };
    const built = await toolchain.build(build, tell, signal);
    const file = `work/${data.id}.cpp`;
    const { compile, link } = built;
    if (!built.ok) {
      const verdict = judge.uncompiled(data.id, { ...built, source: whole });
      return { ...verdict, file, seconds: { compile, link, run: 0 } };
    }
    tell({ step: "run" });
    const began = performance.now();
    const tests = judge.tests(data.id).map(inPage);
    // A run takes the program with it; a closer look needs another.
    const program = built.program.slice();
    const { results, output } = await this.#runners.run(
      { program: built.program, tests, seed },
      {
        onStart: (test) => tell({ step: "run", test }),
        onTest: (result) => onTest?.(result),
        signal,
      },
    );
    const again = progress && judge.again(data.id, progress, results, whole);
    let looked = results;
    if (again) {
      tell({ step: "run", test: again.test });
      const { looks } = await this.#runners.run(
        {
          program,
          tests: tests.filter(({ name }) => name === again.test),
          seed,
          look: again.look,
        },
        { onStart: () => {}, onTest: () => {}, signal },
      );
      const look = looks[again.test];
      if (look)
        looked = results.map((result) =>
          result.name === again.test ? { ...result, look } : result,
        );
    }
    const run = (performance.now() - began) / 1000;
    const ran = { source: whole, log: built.log, output, ...(progress ? { progress } : {}) };
    const verdict = judge.judge(data.id, looked, ran);
    return { ...verdict, file, seconds: { compile, link, run } };
  }

  /** Links an answer with a file that calls it, instead of with its tests. */
  async callable(
    data: ExerciseData,
    source: string,
    caller: string,
    tell: Tell,
    signal?: AbortSignal,
  ): Promise<{ program: WebAssembly.Module } | { verdict: VerdictJson }> {
    signal?.throwIfAborted();
    const { toolchain } = await this.#parts;
    const whole = new TextDecoder().decode(new TextEncoder().encode(source));
    await toolchain.ready(tell, signal);
    const build = { exercise: data.id, files: data.files, source: whole, tests: caller };
    const built = await toolchain.build(build, tell, signal);
    if (built.ok) return { program: await WebAssembly.compile(built.program) };
    const judge = await this.judge(data);
    return { verdict: judge.uncompiled(data.id, { ...built, source: whole }) };
  }

  /** Where an exercise's tests are; while they are still to be built, waits until they are. */
  async #tests(id: string, tell: Tell, signal?: AbortSignal): Promise<ShippedFile> {
    const { toolchain } = await this.#parts;
    const look = async (): Promise<ShippedFile | undefined> =>
      (await abortable(toolchain.manifest(), signal)).exercises[id];
    // Without any list the first one may still be built; if not, the second look says what is wrong.
    const found = await look().catch(() => undefined);
    if (found) return found;
    signal?.throwIfAborted();
    const say = (words: string): void => tell({ step: "wait", words });
    await untilBuilt(`exercise ${id}`, this.#base, say, signal);
    toolchain.renewManifest();
    const built = await look();
    if (built) return built;
    throw new CheckerError("The tests of this exercise are not in this copy of the book.");
  }

  /** The judge alone, without the compiler. */
  judge(data: ExerciseData): Promise<Judge> {
    const known = this.#judges.get(data.id);
    if (known) return known;
    const judge = this.#newJudge(data);
    this.#judges.set(data.id, judge);
    judge.catch(() => this.#judges.delete(data.id));
    return judge;
  }

  async #newJudge(data: ExerciseData): Promise<Judge> {
    this.#judgeParts ??= this.#loadJudgeParts().catch((error: unknown) => {
      this.#judgeParts = undefined;
      throw error;
    });
    const [module, book] = await this.#judgeParts;
    return loadJudge(module, { ...book.files, ...data.files });
  }

  async #loadJudgeParts(): Promise<[WebAssembly.Module, BookData]> {
    const { downloads, toolchain } = await this.#parts;
    const file = (await toolchain.manifest()).files["judge.wasm"];
    if (!file) throw new CheckerError("This copy of the book was built without its judge.");
    const wasm = downloads.bytes(file).then((bytes) => WebAssembly.compile(bytes));
    return Promise.all([wasm, downloads.json<BookData>("../exercises/book.json")]);
  }
}

/** The page can only look at the clock, which also counts other work of the machine. */
const inPage = ({ name, seconds }: TimedTest): TimedTest => ({
  name,
  seconds: Math.min(2 * seconds, Math.max(seconds, 3)),
});
