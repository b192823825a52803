// What the browser keeps of the book for reading without a network. A reader's own work is elsewhere
// (work.ts), and nothing here touches it.
//
// A file is kept under its path and the hash of its content, so a new version of the book replaces
// what changed and nothing else, and an old version stays as long as something needs it: a page that
// is open, or one that was kept when that version was current. Used by the service worker and by the
// page alike.

import { type Entry, fetchList, hashOf, isPage, type List } from "./list.ts";

/** How a page was kept: its content, and the list that its parts are found by. */
interface PageNote {
  readonly version: string;
  readonly hash: string;
}

interface WholeNote {
  readonly version: string;
  readonly at: string;
}

export interface Missing {
  readonly path: string;
  readonly entry: Entry;
}

export class Shelf {
  /** The address of the site's root, with a slash at its end. */
  readonly root: string;
  readonly #files: string;
  readonly #notes: string;

  constructor(root: string) {
    this.root = root;
    const place = new URL(root).pathname;
    this.#files = `contact-book/1/files${place}`;
    this.#notes = `contact-book/1/notes${place}`;
  }

  /** A path from the root; undefined for what is not the book's. */
  path(address: string): string | undefined {
    const url = new URL(address);
    url.search = "";
    url.hash = "";
    if (!url.href.startsWith(this.root)) return undefined;
    const path = decodeURIComponent(url.href.slice(this.root.length));
    return path === "" || path.endsWith("/") ? `${path}index.html` : path;
  }

  #key(path: string, hash: string): string {
    return `${new URL(encodeURI(path), this.root).href}?${hash}`;
  }

  async file(path: string, hash: string): Promise<Response | undefined> {
    return (await caches.open(this.#files)).match(this.#key(path, hash));
  }

  /** The file as it was in any version. */
  async anyVersion(path: string): Promise<Response | undefined> {
    const files = await caches.open(this.#files);
    return files.match(new URL(encodeURI(path), this.root), { ignoreSearch: true });
  }

  /** Keeps a file if it is the one that is wanted; says whether it is. */
  async keep(path: string, hash: string, response: Response): Promise<boolean> {
    const content = await response.arrayBuffer();
    if ((await hashOf(content)) !== hash) return false;
    const type = response.headers.get("content-type") ?? "application/octet-stream";
    const made = new Response(content, { headers: { "content-type": type } });
    await (await caches.open(this.#files)).put(this.#key(path, hash), made);
    return true;
  }

  // --- Lists ----------------------------------------------------------------------------------

  /** The newest list that the browser has. */
  async current(): Promise<List | undefined> {
    const version = await this.#read<string>("current");
    return version === undefined ? undefined : this.list(version);
  }

  list(version: string): Promise<List | undefined> {
    return this.#read<List>(`list/${version}`);
  }

  /** The site's list, fetched; the one that is kept where there is no network. */
  async refresh(): Promise<List | undefined> {
    try {
      const list = await fetchList(this.root);
      if (!(await this.list(list.version))) await this.#write(`list/${list.version}`, list);
      await this.#write("current", list.version);
      return list;
    } catch {
      return this.current();
    }
  }

  // --- Pages ----------------------------------------------------------------------------------

  /** Remembers that a page is kept, and with which list. */
  async notePage(path: string, hash: string, version: string): Promise<void> {
    await this.#write(`page/${path}`, { version, hash } satisfies PageNote);
  }

  async keptPage(path: string): Promise<{ response: Response; version: string } | undefined> {
    const note = await this.#read<PageNote>(`page/${path}`);
    const response = note && (await this.file(path, note.hash));
    return response && { response, version: note.version };
  }

  async keptPages(): Promise<string[]> {
    return (await this.#names("page/")).sort();
  }

  // --- Open pages -----------------------------------------------------------------------------

  async pin(client: string, version: string): Promise<void> {
    await this.#write(`client/${client}`, version);
  }

  async unpin(client: string): Promise<void> {
    await this.#remove(`client/${client}`);
  }

  /** The list that an open page was made with. */
  async pinned(client: string): Promise<List | undefined> {
    const version = await this.#read<string>(`client/${client}`);
    return version === undefined ? undefined : this.list(version);
  }

  // --- The whole book -------------------------------------------------------------------------

  whole(): Promise<WholeNote | undefined> {
    return this.#read<WholeNote>("whole");
  }

  /** The files of a list that are not kept yet. */
  async missing(list: List): Promise<Missing[]> {
    const there = await this.#keys();
    return Object.entries(list.files)
      .filter(([path, { hash }]) => !there.has(this.#key(path, hash)))
      .map(([path, entry]) => ({ path, entry }));
  }

  /** Everything of this list is kept now. */
  async noteWhole(list: List): Promise<void> {
    for (const [path, { hash }] of Object.entries(list.files))
      if (isPage(path)) await this.notePage(path, hash, list.version);
    const note: WholeNote = { version: list.version, at: new Date().toISOString() };
    await this.#write("whole", note);
  }

  /** How many files are kept, and what they weigh. */
  async weight(): Promise<{ files: number; bytes: number }> {
    const files = await caches.open(this.#files);
    let bytes = 0;
    const keys = await files.keys();
    for (const key of keys) bytes += (await (await files.match(key))?.blob())?.size ?? 0;
    return { files: keys.length, bytes };
  }

  /** Removes the files and lists that no kept or open page needs. `open` are the clients there are. */
  async tidy(open: ReadonlySet<string>): Promise<void> {
    const current = await this.#read<string>("current");
    const needed = new Set(current === undefined ? [] : [current]);
    const wanted = new Set<string>();
    for (const client of await this.#names("client/")) {
      const version = await this.#read<string>(`client/${client}`);
      if (!open.has(client)) await this.unpin(client);
      else if (version !== undefined) needed.add(version);
    }
    for (const path of await this.#names("page/")) {
      const note = await this.#read<PageNote>(`page/${path}`);
      if (!note) continue;
      needed.add(note.version);
      wanted.add(this.#key(path, note.hash));
    }
    for (const version of await this.#names("list/")) {
      const list = needed.has(version) ? await this.list(version) : undefined;
      if (!list) await this.#remove(`list/${version}`);
      for (const [path, { hash }] of Object.entries(list?.files ?? {}))
        wanted.add(this.#key(path, hash));
    }
    const files = await caches.open(this.#files);
    for (const key of await this.#keys()) if (!wanted.has(key)) await files.delete(key);
  }

  async forget(): Promise<void> {
    await caches.delete(this.#files);
    await caches.delete(this.#notes);
  }

  async #keys(): Promise<Set<string>> {
    const files = await caches.open(this.#files);
    return new Set((await files.keys()).map(({ url }) => url));
  }

  // --- Notes: small records, as JSON beside the files ---------------------------------------------

  #note(name: string): string {
    return new URL(encodeURI(name), this.root).href;
  }

  async #read<T>(name: string): Promise<T | undefined> {
    const response = await (await caches.open(this.#notes)).match(this.#note(name));
    return response && ((await response.json()) as T);
  }

  async #write(name: string, value: unknown): Promise<void> {
    const notes = await caches.open(this.#notes);
    await notes.put(this.#note(name), new Response(JSON.stringify(value)));
  }

  async #remove(name: string): Promise<void> {
    await (await caches.open(this.#notes)).delete(this.#note(name));
  }

  async #names(prefix: string): Promise<string[]> {
    const start = this.#note(prefix);
    const keys = await (await caches.open(this.#notes)).keys();
    return keys
      .filter(({ url }) => url.startsWith(start))
      .map(({ url }) => decodeURI(url.slice(start.length)));
  }
}
