// The interface to the compile worker: started once for all exercises, given one request after another, and restarted
// when it does not answer.

import { abortable, pause } from "./abort.ts";
import { type Downloads, transferOf } from "./download.ts";
import type { Build, Built, FromCompiler, Modules, NotBuilt, ToCompiler } from "./messages.ts";
import { patienceForPrelude } from "./timing.ts";
import { CheckerError, type Manifest, type ShippedFile, type Size, type Tell } from "./types.ts";

/** As the native check (grading/build/build.cpp). */
const COMPILE_SECONDS = 60;
/** How long an unwanted compile may go on before its worker is ended: to start another takes as long. */
const UNWANTED_SECONDS = 2;

interface Started {
  readonly worker: Worker;
  readonly manifest: Manifest;
}

export class Toolchain {
  readonly #downloads: Downloads;
  readonly #folder: string;
  readonly #script: string;
  #manifest: Promise<Manifest> | undefined;
  #starting: Promise<Started> | undefined;
  #worker: Worker | undefined;
  #modules: Modules | undefined;
  /** Requests that wait for the start. */
  readonly #tells = new Set<Tell>();
  #queue: Promise<unknown> = Promise.resolve();
  /** The precompiled header on its way to the compiler. */
  #prelude: Promise<void> | undefined;
  #hasPrelude = false;
  #line = { bytes: 0, seconds: 0 };
  #warm = false;

  /** @param folder …/_static/contact/cpp/ @param script the address of the compile worker */
  constructor(downloads: Downloads, folder: string, script: string) {
    this.#downloads = downloads;
    this.#folder = folder;
    this.#script = script;
  }

  /** The list of files, asked for once a page unless that fails. */
  manifest(): Promise<Manifest> {
    this.#manifest ??= this.#downloads.manifest().catch((error: unknown) => {
      this.#manifest = undefined;
      throw error;
    });
    return this.#manifest;
  }

  /** Requests the list again at its next use, because more has been built. */
  renewManifest(): void {
    this.#manifest = undefined;
  }

  async #missing(keys: readonly string[]): Promise<ShippedFile[]> {
    const { files } = await this.manifest();
    const named = keys.flatMap((key) => files[key] ?? []);
    const kept = await Promise.all(named.map((file) => this.#downloads.isKept(file)));
    return named.filter((_, i) => !kept[i]);
  }

  async size(): Promise<Size> {
    const { core, behind } = await this.manifest();
    const kept = this.#downloads.keeps;
    if (this.#worker && !kept) return { core: 0, behind: 0, kept };
    const [first, later] = await Promise.all([this.#missing(core), this.#missing(behind)]);
    return { core: transferOf(first), behind: transferOf(later), kept };
  }

  /** Downloads and starts the compiler, and waits for the precompiled header if that is soon there. */
  async ready(tell: Tell, signal?: AbortSignal): Promise<void> {
    signal?.throwIfAborted();
    this.#tells.add(tell);
    try {
      this.#starting ??= this.#start();
      await abortable(this.#starting, signal);
      this.#fetchPrelude();
      await abortable(this.#waitForPrelude(tell, signal), signal);
    } finally {
      this.#tells.delete(tell);
      // No request waits any more: complete files are kept, the other downloads are cancelled.
      if (signal?.aborted && this.#tells.size === 0 && !this.#worker) this.#end?.();
    }
  }

  /** Ends the worker, and with it what it does. */
  #end: (() => void) | undefined;

  async #start(): Promise<Started> {
    try {
      return await this.#startNow();
    } catch (error) {
      this.#starting = undefined;
      this.forget();
      throw error;
    }
  }

  /** Requests the list of files again next time, because the book may have been replaced. */
  forget(): void {
    this.#manifest = undefined;
  }

  async #startNow(): Promise<Started> {
    const manifest = await this.manifest();
    const total = transferOf(await this.#missing(manifest.core));
    const worker = new Worker(this.#script, { type: "module" });
    const began = performance.now();
    let received = 0;
    const say: Tell = (progress) => {
      for (const tell of this.#tells) tell(progress);
    };
    say(total > 0 ? { step: "download", received, total } : { step: "start" });
    return new Promise((resolve, reject) => {
      const end = (error: unknown) => {
        worker.terminate();
        this.#end = undefined;
        this.#starting = undefined;
        reject(error);
      };
      this.#end = () => end(new DOMException("no request waits for it", "AbortError"));
      worker.onerror = (event) => {
        event.preventDefault();
        end(new Error(`the compile worker: ${event.message}`));
      };
      worker.onmessage = ({ data }: MessageEvent<FromCompiler>) => {
        if (data.kind === "arrived") {
          received += data.bytes;
          say({ step: "download", received: Math.min(received, total), total });
        } else if (data.kind === "opening") {
          this.#line = { bytes: received, seconds: (performance.now() - began) / 1000 };
          say({ step: "start" });
        } else if (data.kind === "started") {
          this.#worker = worker;
          this.#modules = data.modules;
          this.#hasPrelude = data.prelude;
          this.#end = undefined;
          void this.#downloads.forgetOlder(manifest);
          resolve({ worker, manifest });
        } else if (data.kind === "failed") {
          end(data.sentence ? new CheckerError(data.sentence) : new Error(data.why));
        }
      };
      this.#post(worker, {
        kind: "start",
        folder: this.#folder,
        manifest,
        modules: this.#modules,
      });
    });
  }

  #post(worker: Worker, message: ToCompiler): void {
    worker.postMessage(message);
  }

  #terminate(): void {
    this.#worker?.terminate();
    this.#worker = undefined;
    this.#starting = undefined;
    this.#prelude = undefined;
    this.#hasPrelude = false;
  }

  /** Fetches the precompiled header beside everything else, for this check or the next one. */
  #fetchPrelude(): void {
    const worker = this.#worker;
    if (this.#hasPrelude || !worker) return;
    const { saveData } = (navigator as { connection?: { saveData?: boolean } }).connection ?? {};
    if (saveData) return;
    this.#prelude ??= this.#bringPrelude(worker).catch(() => {
      // Checks are slower without it, and that is all; the next one tries again.
      if (this.#worker === worker) this.#prelude = undefined;
    });
  }

  async #bringPrelude(worker: Worker): Promise<void> {
    const file = (await this.manifest()).files["prelude.pch"];
    if (!file) return;
    this.#preludeArrived = 0;
    const blob = await this.#downloads.blob(file, {
      arrived: (bytes) => {
        this.#preludeArrived += bytes;
        this.#onPrelude?.();
      },
    });
    if (this.#worker !== worker) return;
    // The compiler opens it when it is at leisure.
    this.#post(worker, { kind: "prelude", blob });
    this.#hasPrelude = true;
  }

  #preludeArrived = 0;
  #onPrelude: (() => void) | undefined;

  async #waitForPrelude(tell: Tell, signal?: AbortSignal): Promise<void> {
    const file = (await this.manifest()).files["prelude.pch"];
    if (this.#hasPrelude || !this.#prelude || !file) return;
    const left = file.transfer - this.#preludeArrived;
    const seconds = patienceForPrelude(left, this.#line);
    if (seconds === 0) return;
    this.#onPrelude = () => {
      if (signal?.aborted) return;
      tell({
        step: "download",
        received: this.#line.bytes + this.#preludeArrived,
        total: this.#line.bytes + file.transfer,
      });
    };
    await Promise.race([this.#prelude, pause(seconds)]);
    this.#onPrelude = undefined;
  }

  /** Warms up the compiler's code by running it once, before the first request. */
  async warm(): Promise<void> {
    if (this.#warm || !this.#worker) return;
    this.#warm = true;
    const turn = this.#queue.then(() => this.#ask({ kind: "warm" }, "warm", () => {}));
    this.#queue = turn.catch(() => {});
    await this.#queue;
  }

  /** Compiles and links one answer; one at a time. `ready` comes first. */
  build(build: Build, tell: Tell, signal?: AbortSignal): Promise<Built | NotBuilt> {
    const turn = this.#queue.then(async () => {
      signal?.throwIfAborted();
      await this.ready(tell, signal); // the compiler may have been ended since
      this.#warm = true;
      tell({ step: "compile" });
      return this.#compile(build, tell, signal);
    });
    this.#queue = turn.catch(() => {});
    return abortable(turn, signal);
  }

  async #compile(build: Build, tell: Tell, signal?: AbortSignal): Promise<Built | NotBuilt> {
    const linking = () => {
      if (!signal?.aborted) tell({ step: "link" });
    };
    let clock = setTimeout(() => this.#giveUp(), 1000 * COMPILE_SECONDS);
    const unwanted = () => {
      clearTimeout(clock);
      clock = setTimeout(() => this.#giveUp(), 1000 * UNWANTED_SECONDS);
    };
    signal?.addEventListener("abort", unwanted, { once: true });
    try {
      const done = await this.#ask({ kind: "build", build }, "done", linking);
      if (done) return done.result;
      const name = build.exercise.slice(build.exercise.indexOf("/") + 1);
      const log = `${name}.cpp:1:1: fatal error: the compiler did not finish within ${COMPILE_SECONDS} s\n`;
      const none = { log, defined: [], compile: COMPILE_SECONDS, link: 0 };
      return { ok: false, step: "compile", ...none };
    } finally {
      clearTimeout(clock);
      signal?.removeEventListener("abort", unwanted);
    }
  }

  #giveUp = () => {};

  /** One question and its answer; nothing if the worker had to be ended. */
  #ask<Kind extends FromCompiler["kind"]>(
    message: ToCompiler,
    kind: Kind,
    linking: () => void,
  ): Promise<Extract<FromCompiler, { kind: Kind }> | undefined> {
    const worker = this.#worker;
    if (!worker) return Promise.reject(new Error("the compiler is not started"));
    return new Promise((resolve, reject) => {
      this.#giveUp = () => {
        this.#terminate();
        resolve(undefined);
      };
      worker.onerror = (event) => {
        event.preventDefault();
        this.#terminate();
        reject(new Error(`the compile worker: ${event.message}`));
      };
      worker.onmessage = ({ data }: MessageEvent<FromCompiler>) => {
        if (data.kind === "linking") linking();
        else if (data.kind === kind) resolve(data as Extract<FromCompiler, { kind: Kind }>);
        else if (data.kind === "failed") {
          this.#terminate();
          reject(new Error(data.why));
        }
      };
      this.#post(worker, message);
    });
  }
}
