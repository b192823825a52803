// Keeping the whole book in the browser, as the page offers it: what it would take, how it goes, what
// is there, and how to be rid of it.

import { CACHE as COMPILER_CACHE } from "../cpp/download.ts";
import type { Manifest, ShippedFile } from "../cpp/types.ts";
import { keepAll, Replaced } from "./keep.ts";
import { COMPILER, fetchList, type List } from "./list.ts";
import { Shelf } from "./shelf.ts";

/** "1.4 MB", "320 kB" */
export function sizeText(bytes: number): string {
  if (bytes < 1000) return `${bytes} bytes`;
  return bytes < 1e6 ? `${Math.round(bytes / 1000)} kB` : `${(bytes / 1e6).toFixed(1)} MB`;
}

/** Why this browser cannot keep the book here; undefined if it can. */
export function whyNot(): string | undefined {
  if (!isSecureContext)
    return "A browser keeps a book for offline reading only if it comes over https or from this machine itself, and this address is neither.";
  if (!("serviceWorker" in navigator) || !("caches" in globalThis))
    return "This browser window keeps nothing for offline reading. It may be a private window.";
  return undefined;
}

export const transferOf = (files: readonly { transfer: number }[]): number =>
  files.reduce((total, { transfer }) => total + transfer, 0);

/** What is there and what is missing, of the book and of the compiler. */
export interface Standing {
  readonly list: List | undefined;
  readonly book: readonly { transfer: number }[];
  readonly whole: { readonly at: string; readonly version: string } | undefined;
  readonly kept: { readonly files: number; readonly bytes: number };
  /** Undefined if this copy of the book has no compiler. */
  readonly compiler:
    | {
        readonly all: ShippedFile[];
        readonly missing: ShippedFile[];
        /** What a first check needs is kept: the reader checks in this browser. */
        readonly inUse: boolean;
      }
    | undefined;
}

export class OfflineBook {
  readonly shelf: Shelf;
  readonly #compilerFolder: string;

  constructor(root: string) {
    this.shelf = new Shelf(root);
    this.#compilerFolder = new URL(COMPILER, root).href;
  }

  async standing(): Promise<Standing> {
    const list = await fetchList(this.shelf.root).catch(() => this.shelf.current());
    const compiler = await this.#compiler();
    return {
      list,
      book: list ? (await this.shelf.missing(list)).map(({ entry }) => entry) : [],
      whole: await this.shelf.whole(),
      kept: await this.shelf.weight(),
      compiler: compiler && {
        all: compiler.files,
        missing: await this.#missing(compiler.files),
        inUse: (await this.#missing(compiler.core)).length === 0,
      },
    };
  }

  /** Fetches what is missing; `arrived` is told the compressed bytes as they come. */
  async keep(
    withCompiler: boolean,
    arrived: (bytes: number) => void,
    signal: AbortSignal,
  ): Promise<void> {
    await navigator.storage?.persist?.().catch(() => false);
    const list = await this.shelf.refresh();
    if (!list) throw new TypeError("no list");
    await keepAll(this.shelf, list, arrived, signal);
    const compiler = withCompiler ? await this.#compiler() : undefined;
    if (!compiler) return;
    for (const file of await this.#missing(compiler.files))
      await this.#keepCompilerFile(new URL(file.file, this.#compilerFolder), file, arrived, signal);
    await (await caches.open(COMPILER_CACHE)).put(this.#manifest, compiler.list);
  }

  /** As the checker keeps it, but an error if it is not kept. */
  async #keepCompilerFile(
    address: URL,
    file: ShippedFile,
    arrived: (bytes: number) => void,
    signal: AbortSignal,
  ): Promise<void> {
    const response = await fetch(address, { cache: "no-store", signal });
    if (!response.ok || !response.body) throw new Replaced(file.file);
    let length = 0;
    const counted = new TransformStream<Uint8Array<ArrayBuffer>, Uint8Array<ArrayBuffer>>({
      transform(chunk, controller) {
        length += chunk.length;
        arrived(chunk.length);
        controller.enqueue(chunk);
      },
      flush() {
        // A server may have taken the compression off.
        if (length !== file.transfer && length !== file.bytes) throw new Replaced(file.file);
      },
    });
    const cache = await caches.open(COMPILER_CACHE);
    await cache.put(address, new Response(response.body.pipeThrough(counted)));
  }

  /** Removes everything but the reader's own work. */
  async forget(): Promise<void> {
    await this.shelf.forget();
    const cache = await caches.open(COMPILER_CACHE);
    const keys = (await cache.keys()).map(({ url }) => url);
    const ours = keys.filter((url) => url.startsWith(this.shelf.root));
    // Deleted whole, it takes what is still on its way along. Another book of this host may be in it.
    if (ours.length === keys.length) await caches.delete(COMPILER_CACHE);
    else for (const url of ours) await cache.delete(url);
  }

  /** The compiler's list, the newest or the one that is kept, and its files; undefined if there is none. */
  async #compiler(): Promise<
    { list: Response; files: ShippedFile[]; core: ShippedFile[] } | undefined
  > {
    const response =
      (await fetch(this.#manifest, { cache: "no-cache" }).catch(() => undefined)) ??
      (await caches.match(this.#manifest, { cacheName: COMPILER_CACHE }));
    if (!response?.ok) return undefined;
    const list = response.clone();
    const manifest = (await response.json()) as Manifest;
    if (manifest.format !== "contact-cpp/1") return undefined;
    return {
      list,
      core: manifest.core.flatMap((key) => manifest.files[key] ?? []),
      files: [manifest.files, manifest.exercises].flatMap((map) => Object.values(map)),
    };
  }

  get #manifest(): string {
    return new URL("manifest.json", this.#compilerFolder).href;
  }

  async #missing(files: readonly ShippedFile[]): Promise<ShippedFile[]> {
    const cache = await caches.open(COMPILER_CACHE);
    const there = new Set((await cache.keys()).map(({ url }) => url));
    return files.filter(({ file }) => !there.has(new URL(file, this.#compilerFolder).href));
  }
}
