// Fetches every file of the book that is not kept yet.

import type { List } from "./list.ts";
import type { Shelf } from "./shelf.ts";

/** The site's files and its list do not agree: the book is being replaced at this moment. */
export class Replaced extends Error {
  constructor(path: string) {
    super(`The book is being replaced by a newer version (${path} has changed). Try again.`);
  }
}

const AT_ONCE = 4;

/**
 * Keeps all files of the list; `arrived` is told their compressed sizes as they come. What has arrived
 * stays if it breaks off, and is not fetched again. The note that the book is whole comes last.
 */
export async function keepAll(
  shelf: Shelf,
  list: List,
  arrived: (transfer: number) => void = () => {},
  signal?: AbortSignal,
): Promise<void> {
  const waiting = await shelf.missing(list);
  const fetchOn = async (): Promise<void> => {
    for (let next = waiting.shift(); next; next = waiting.shift()) {
      const { path, entry } = next;
      const request: RequestInit = { cache: "no-cache", ...(signal ? { signal } : {}) };
      const response = await fetch(new URL(encodeURI(path), shelf.root), request);
      if (!response.ok || !(await shelf.keep(path, entry.hash, response))) throw new Replaced(path);
      arrived(entry.transfer);
    }
  };
  await Promise.all(Array.from({ length: AT_ONCE }, fetchOn));
  await shelf.noteWhole(list);
}
