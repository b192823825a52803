// Fetches the files of the compiler and keeps them in the browser. Their names carry a hash of their content, so
// what is kept is never stale. Used by the page and by the compile worker.

import { CheckerError, type Manifest, type ShippedFile } from "./types.ts";

/** The cache's name. A service worker may read it, too. */
export const CACHE = "contact-cpp";

/** Where files are kept: Cache Storage, or nothing where the browser has none. */
export type Store = Pick<Cache, "match" | "put" | "delete" | "keys">;

/** The browser's cache; undefined where there is none (http on another host than localhost, some private windows). */
export async function openStore(): Promise<Store | undefined> {
  try {
    return await globalThis.caches?.open(CACHE);
  } catch {
    return undefined;
  }
}

export interface Surroundings {
  readonly fetch: typeof fetch;
  readonly store: Store | undefined;
}

export interface FetchOptions {
  /** Told of bytes that arrived over the network, as shipped. */
  readonly arrived?: (bytes: number) => void;
  readonly signal?: AbortSignal | undefined;
}

/** The folder with manifest.json, and what is in it. */
export class Downloads {
  readonly #folder: string;
  readonly #fetch: typeof fetch;
  readonly #store: Store | undefined;

  /** @param folder the address of …/_static/contact/cpp/ */
  constructor(folder: string, { fetch, store }: Surroundings) {
    this.#folder = folder;
    this.#fetch = fetch;
    this.#store = store;
  }

  get keeps(): boolean {
    return this.#store !== undefined;
  }

  address(file: ShippedFile): string {
    return new URL(file.file, this.#folder).href;
  }

  async isKept(file: ShippedFile): Promise<boolean> {
    return (await this.#store?.match(this.address(file))) !== undefined;
  }

  /** The list of files: the newest, or the one that is kept when there is no network. */
  async manifest(signal?: AbortSignal): Promise<Manifest> {
    const manifest = await this.json<Manifest>("manifest.json", signal);
    if (manifest.format !== "contact-cpp/1")
      throw new CheckerError(
        "This page and its compiler are of different versions. Load the page again.",
      );
    return manifest;
  }

  /** A document whose name does not tell its content: the newest, or what is kept when there is no network. */
  async json<Document>(name: string, signal?: AbortSignal): Promise<Document> {
    const address = new URL(name, this.#folder).href;
    let response: Response | undefined;
    try {
      response = await this.#fetch(address, { cache: "no-cache", ...(signal ? { signal } : {}) });
    } catch (error) {
      if (signal?.aborted) throw error;
      response = await this.#store?.match(address);
      if (!response) throw unreachable();
    }
    if (!response.ok) throw notBuilt(response.status);
    const copy = response.clone();
    const document = (await response.json()) as Document;
    await this.#store?.put(address, copy).catch(() => {});
    return document;
  }

  /** Removes what this list no longer names, once all of its core is kept: until then the old one may be needed. */
  async forgetOlder(manifest: Manifest): Promise<void> {
    for (const key of manifest.core) {
      const file = manifest.files[key];
      if (file && !(await this.isKept(file))) return;
    }
    const named = new Set([new URL("manifest.json", this.#folder).href]);
    for (const files of [manifest.files, manifest.exercises])
      for (const file of Object.values(files)) named.add(this.address(file));
    for (const { url } of (await this.#store?.keys()) ?? [])
      if (url.startsWith(this.#folder) && !named.has(url)) await this.#store?.delete(url);
  }

  /**
   * A file, from the cache or over the network; what comes over the network is kept on its way. The body is as it
   * is shipped: see `opened`. A body that ends too early is an error and is not kept.
   */
  async file(file: ShippedFile, { arrived, signal }: FetchOptions = {}): Promise<Response> {
    const address = this.address(file);
    const kept = await this.#store?.match(address);
    if (kept) return kept;
    // The browser's other cache need not hold it a second time.
    const cache = this.#store ? "no-store" : "default";
    let response: Response;
    try {
      response = await this.#fetch(address, { cache, ...(signal ? { signal } : {}) });
    } catch (error) {
      if (signal?.aborted) throw error;
      throw unreachable();
    }
    if (response.status === 404) throw replaced();
    if (!response.ok || !response.body) throw notBuilt(response.status);
    const body = response.body.pipeThrough(counted(file, arrived));
    if (!this.#store) return new Response(body);
    const [here, there] = body.tee();
    // A full disk, or a body that breaks off: it is not kept, and that is all.
    this.#store.put(address, new Response(there)).catch(() => {});
    return new Response(here);
  }

  /** A file as it is shipped, downloaded completely and stored; the caller opens it. */
  async blob(file: ShippedFile, options: FetchOptions = {}): Promise<Blob> {
    try {
      return await (await this.file(file, options)).blob();
    } catch (error) {
      throw inWords(error, options.signal);
    }
  }

  /** A file to its last byte, opened. */
  async bytes(file: ShippedFile, options: FetchOptions = {}): Promise<Uint8Array<ArrayBuffer>> {
    try {
      const response = await this.file(file, options);
      return new Uint8Array(await (await opened(response)).arrayBuffer());
    } catch (error) {
      throw inWords(error, options.signal);
    }
  }
}

/** Says what arrives, in bytes as shipped, and whether all of it did. */
function counted(
  file: ShippedFile,
  arrived: ((bytes: number) => void) | undefined,
): TransformStream<Uint8Array<ArrayBuffer>, Uint8Array<ArrayBuffer>> {
  let length = 0;
  // A server may have taken the compression off already.
  let whole = file.transfer;
  return new TransformStream({
    transform(chunk, controller) {
      if (length === 0 && file.file.endsWith(".gz") && !isZipped(chunk)) whole = file.bytes;
      length += chunk.length;
      arrived?.((chunk.length * file.transfer) / whole);
      controller.enqueue(chunk);
    },
    flush() {
      if (length !== whole) throw brokeOff();
    },
  });
}

const isZipped = (start: Uint8Array): boolean => start[0] === 0x1f && start[1] === 0x8b;

/** A response whose body is decompressed, if it is compressed. */
export async function opened(response: Response, type?: string): Promise<Response> {
  const headers = { "content-type": type ?? "application/octet-stream" };
  const reader = (response.body as ReadableStream<Uint8Array<ArrayBuffer>>).getReader();
  const first = await reader.read();
  const body = new ReadableStream<Uint8Array<ArrayBuffer>>({
    start(controller) {
      if (first.done) controller.close();
      else controller.enqueue(first.value);
    },
    async pull(controller) {
      const next = await reader.read();
      if (next.done) controller.close();
      else controller.enqueue(next.value);
    },
    cancel: (reason) => reader.cancel(reason),
  });
  const zipped = !first.done && isZipped(first.value);
  return new Response(zipped ? body.pipeThrough(new DecompressionStream("gzip")) : body, {
    headers,
  });
}

const brokeOff = () =>
  new CheckerError("The download broke off. Try again: what has arrived whole is kept.");

function unreachable(): CheckerError {
  const { contactSavedFrom } = globalThis as { contactSavedFrom?: string };
  if (contactSavedFrom)
    return new CheckerError(
      `The compiler could not be loaded from ${contactSavedFrom}. This file was saved without it, so it needs a network and a server that allows other pages to load it. Your code is kept.`,
    );
  if (globalThis.location?.protocol === "file:")
    return new CheckerError(
      "A page opened from a file cannot load the compiler. Open the book from a web server.",
    );
  if (globalThis.navigator?.onLine === false)
    return new CheckerError(
      "You are offline, and the compiler is not in this browser yet. Try again when you are online.",
    );
  return brokeOff();
}

/** A file that the list names is not there. */
const replaced = () =>
  new CheckerError(
    "The book has been replaced since this page was opened. Load the page again; your code is kept.",
  );

const notBuilt = (status: number) =>
  new CheckerError(
    status === 404
      ? "The compiler is not here: this copy of the book was built without its exercises."
      : `The server did not give out the compiler (it answered ${status}). Try again later.`,
  );

/** What went wrong with a body, in a sentence for the reader; an abort stays what it is. */
export function inWords(error: unknown, signal?: AbortSignal): unknown {
  if (error instanceof CheckerError || signal?.aborted) return error;
  // A broken connection, or compressed data that ends in the middle.
  return error instanceof TypeError ? unreachable() : error;
}

/** The sum of what some files weigh on the way. */
export const transferOf = (files: readonly ShippedFile[]): number =>
  files.reduce((sum, { transfer }) => sum + transfer, 0);
