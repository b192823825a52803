// The service worker: a page that was read once can be read again without a network.
//
// - A page comes from the network, and from what is kept if there is none, or if it takes too long.
// - A part of a page (script, style, font, picture, figure) comes from what is kept if that is of the
//   very version the page was made with (offline.json names it by hash), else from the network.
// - The compiler's files come from where the checker keeps them, else from the network.
//
// Any version of this worker can serve a page that any other version opened, because every file is
// named by its content: so it takes over at once, and breaks nothing.

import { CACHE as COMPILER_CACHE } from "../cpp/download.ts";
import { keepAll } from "./keep.ts";
import { COMPILER, LIST, type List } from "./list.ts";
import { Shelf } from "./shelf.ts";

// TypeScript's libraries for a page and for a service worker exclude each other.
interface LongEvent extends Event {
  waitUntil(work: Promise<unknown>): void;
}
interface FetchEvent extends LongEvent {
  readonly request: Request;
  readonly clientId: string;
  readonly resultingClientId: string;
  respondWith(response: Promise<Response>): void;
}
interface Client {
  readonly id: string;
  readonly url: string;
}
interface VisitedEvent extends LongEvent {
  readonly source: Client | null;
  readonly data: { readonly kind?: string; readonly addresses?: readonly string[] };
}
interface Worker {
  readonly registration: { readonly scope: string };
  readonly clients: {
    claim(): Promise<void>;
    matchAll(which: { includeUncontrolled: boolean; type: "all" }): Promise<readonly Client[]>;
  };
  skipWaiting(): Promise<void>;
  addEventListener(type: "install" | "activate", listener: (event: LongEvent) => void): void;
  addEventListener(type: "fetch", listener: (event: FetchEvent) => void): void;
  addEventListener(type: "message", listener: (event: VisitedEvent) => void): void;
}
const worker = globalThis as unknown as Worker;
const shelf = new Shelf(worker.registration.scope);

/** A page that is kept need not wait longer for a slow network. */
const PATIENCE_MS = 4000;

worker.addEventListener("install", (event) => event.waitUntil(worker.skipWaiting()));
worker.addEventListener("activate", (event) => event.waitUntil(worker.clients.claim()));

worker.addEventListener("fetch", (event) => {
  const { request } = event;
  const path = shelf.path(request.url);
  if (request.method !== "GET" || request.headers.has("range")) return;
  if (path === undefined || path === LIST || path === "sw.js") return;
  if (path.startsWith(COMPILER)) event.respondWith(compilerFile(request));
  else if (request.mode === "navigate") event.respondWith(page(event, path));
  else event.respondWith(part(event, path));
});

worker.addEventListener("message", (event) => {
  const { kind, addresses } = event.data;
  if (kind === "visited" && event.source && addresses)
    event.waitUntil(visited(event.source, addresses));
});

// --- Pages ------------------------------------------------------------------------------------

/** The lists of open pages, from the moment they are asked for. */
const pins = new Map<string, Promise<List | undefined>>();

async function page(event: FetchEvent, path: string): Promise<Response> {
  const kept = await shelf.keptPage(path);
  const list = shelf.refresh();
  const client = event.resultingClientId;
  pins.set(client, list);
  try {
    const late = kept && new Promise<undefined>((done) => setTimeout(done, PATIENCE_MS));
    const network = fetch(event.request);
    const response = await (late ? Promise.race([network, late]) : network);
    if (response && (response.status < 500 || !kept)) {
      if (response.ok && !response.redirected)
        event.waitUntil(keepPage(path, response.clone(), client, list));
      return response;
    }
    // The response may still arrive, and fail, when no request waits for it.
    network.catch(() => {});
  } catch {
    // No network.
  }
  if (!kept) return absent(await shelf.keptPages());
  pins.set(client, shelf.list(kept.version));
  event.waitUntil(shelf.pin(client, kept.version));
  return kept.response;
}

/** Keeps a page that came over the network, if it is of the version that the list says. */
async function keepPage(
  path: string,
  response: Response,
  client: string,
  wanted: Promise<List | undefined>,
): Promise<void> {
  const list = await wanted;
  const hash = list?.files[path]?.hash;
  if (!list || !hash || !(await shelf.keep(path, hash, response))) {
    // The book is being replaced just now: this page's parts come from the network.
    pins.set(client, Promise.resolve(undefined));
    return;
  }
  await shelf.notePage(path, hash, list.version);
  await shelf.pin(client, list.version);
  const whole = await shelf.whole();
  if (whole && whole.version !== list.version) await keepAll(shelf, list).catch(() => {});
  await tidy();
}

async function tidy(): Promise<void> {
  const open = await worker.clients.matchAll({ includeUncontrolled: true, type: "all" });
  const there = new Set(open.map(({ id }) => id));
  for (const client of pins.keys()) if (!there.has(client)) pins.delete(client);
  await shelf.tidy(there);
}

/** A page that was loaded before this worker: keeps it, and what it has loaded so far. */
async function visited({ id, url }: Client, addresses: readonly string[]): Promise<void> {
  const pinned = pins.get(id) ?? shelf.refresh();
  pins.set(id, pinned);
  const list = await pinned;
  if (!list) return;
  const keep = async (address: string): Promise<boolean> => {
    const path = shelf.path(address);
    const hash = path === undefined ? undefined : list.files[path]?.hash;
    if (path === undefined || !hash) return false;
    if (await shelf.file(path, hash)) return true;
    // Nearly always still in the browser's other cache.
    const response = await fetch(address, { cache: "force-cache" });
    return response.ok && (await shelf.keep(path, hash, response));
  };
  const path = shelf.path(url);
  if (path === undefined || !(await keep(url))) return;
  await Promise.allSettled(addresses.map(keep));
  await shelf.notePage(path, list.files[path]!.hash, list.version);
  await shelf.pin(id, list.version);
}

function absent(kept: readonly string[]): Response {
  const home = shelf.root;
  const links = kept.map((path) => `<li><a href="${home}${encodeURI(path)}">${path}</a></li>`);
  const others = links.length > 0 ? `<p>These are:</p><ul>${links.join("")}</ul>` : "";
  const text = `<!doctype html><html lang="en"><meta charset="utf-8"><title>Not kept here</title>
<meta name="viewport" content="width=device-width,initial-scale=1"><meta name="color-scheme" content="light dark">
<style>body{font:1.1rem/1.6 Georgia,serif;max-width:36rem;margin:3rem auto;padding:0 1rem}</style>
<main><h1>You are offline</h1><p>This page is not kept in this browser.</p>${others}</main></html>`;
  const headers = { "content-type": "text/html; charset=utf-8" };
  return new Response(text, { status: 503, statusText: "Offline", headers });
}

// --- Parts of pages -----------------------------------------------------------------------------

async function listOf(client: string): Promise<List | undefined> {
  if (pins.has(client)) return pins.get(client);
  // This worker has been stopped and started since; or it is a worker of a page.
  return (await shelf.pinned(client)) ?? shelf.current();
}

async function part(event: FetchEvent, path: string): Promise<Response> {
  const hash = (await listOf(event.clientId))?.files[path]?.hash;
  const kept = hash && (await shelf.file(path, hash));
  if (kept) return kept;
  let response: Response;
  try {
    response = await fetch(event.request, { cache: "no-cache" });
  } catch (error) {
    const other = await shelf.anyVersion(path);
    if (other) return other;
    throw error;
  }
  if (response.ok && hash) event.waitUntil(shelf.keep(path, hash, response.clone()));
  // A newer book no longer has it, and a page of the older one asks.
  return response.ok ? response : ((await shelf.anyVersion(path)) ?? response);
}

async function compilerFile(request: Request): Promise<Response> {
  const cache = await caches.open(COMPILER_CACHE);
  const isList = request.url.endsWith("/manifest.json");
  const kept = await cache.match(request, { ignoreSearch: true });
  if (kept && !isList) return kept;
  try {
    return await fetch(request);
  } catch (error) {
    if (kept) return kept;
    throw error;
  }
}
