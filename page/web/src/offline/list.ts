// offline.json at the site's root: every file of the book by its path from there, with the start of
// the SHA-256 of its content and its sizes. Written at the end of the book's build
// (docs/_ext/contact_book/offline.py); the compiler has a list of its own.

export interface Entry {
  readonly hash: string;
  /** Its size. */
  readonly bytes: number;
  /** Its size as a server would compress it. */
  readonly transfer: number;
}

export interface List {
  readonly format: "contact-offline/1";
  /** Two lists of one version name the same files. */
  readonly version: string;
  readonly files: Readonly<Record<string, Entry>>;
}

export const LIST = "offline.json";

/** Where the compiler is, which keeps its files itself (src/cpp/download.ts). */
export const COMPILER = "_static/contact/cpp/";

const HASH_LENGTH = 16;

export async function hashOf(content: BufferSource): Promise<string> {
  const digest = new Uint8Array(await crypto.subtle.digest("SHA-256", content));
  const hex = Array.from(digest, (byte) => byte.toString(16).padStart(2, "0")).join("");
  return hex.slice(0, HASH_LENGTH);
}

/** The site's list as it is now; throws if there is none or no network. */
export async function fetchList(root: string): Promise<List> {
  const response = await fetch(new URL(LIST, root), { cache: "no-cache" });
  if (!response.ok) throw new Error(`${LIST}: ${response.status}`);
  const list = (await response.json()) as List;
  if (list.format !== "contact-offline/1") throw new Error(`${LIST}: ${list.format}`);
  return list;
}

/** Whether it is a page, and not a part of one. */
export const isPage = (path: string): boolean =>
  path.endsWith(".html") && !path.startsWith("_static/");
