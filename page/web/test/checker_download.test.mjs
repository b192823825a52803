// What the page downloads to check exercises: each file once, whole or not at all, and what to say when it fails.

import assert from "node:assert/strict";
import http from "node:http";
import { after, before, beforeEach, test } from "node:test";
import { gzipSync } from "node:zlib";
import { load } from "./load.mjs";

/** @type {typeof import("../src/cpp/download.ts")} */
let library;
/** @type {typeof import("../src/cpp/timing.ts")} */
let timing;

/** As Cache Storage, in memory. */
class FakeStore {
  /** @type {Map<string, Uint8Array<ArrayBuffer>>} */
  kept = new Map();
  /** @param {RequestInfo | URL} address */
  async match(address) {
    const bytes = this.kept.get(String(address));
    return bytes && new Response(bytes);
  }
  /** @param {RequestInfo | URL} address @param {Response} response */
  async put(address, response) {
    this.kept.set(String(address), new Uint8Array(await response.arrayBuffer()));
  }
  /** @param {RequestInfo | URL} address */
  async delete(address) {
    return this.kept.delete(String(address));
  }
  async keys() {
    return [...this.kept.keys()].map((url) => new Request(url));
  }
}

/** @type {http.Server} */
let server;
let folder = "";
/** What the server gives by path; `broken`: it hangs up after half of it. @type {Map<string, { bytes: Buffer, broken?: boolean }>} */
const files = new Map();
/** @type {string[]} */
let asked = [];
/** @type {FakeStore} */
let store;

before(async () => {
  library = await load("cpp/download.ts");
  timing = await load("cpp/timing.ts");
  server = http.createServer((request, response) => {
    const name = String(request.url).slice("/cpp/".length);
    asked.push(name);
    const file = files.get(name);
    if (!file) return void response.writeHead(404).end();
    response.writeHead(200, { "content-length": file.bytes.length });
    if (!file.broken) return void response.end(file.bytes);
    response.write(file.bytes.subarray(0, file.bytes.length / 2), () => response.destroy());
  });
  await new Promise((listening) => server.listen(0, "127.0.0.1", () => listening(undefined)));
  const { port } = /** @type {import("node:net").AddressInfo} */ (server.address());
  folder = `http://127.0.0.1:${port}/cpp/`;
});
after(() => {
  server.closeAllConnections();
  server.close();
});
beforeEach(() => {
  files.clear();
  asked = [];
  store = new FakeStore();
});

/** Bytes that do not compress to nothing. @param {number} length */
const noise = (length) => {
  let x = length;
  return Buffer.from(
    Uint8Array.from({ length }, () => {
      x = (Math.imul(x, 1664525) + 1013904223) >>> 0;
      return x >>> 24;
    }),
  );
};

/** Puts a file on the server. @param {string} name @param {Buffer} bytes */
function shipped(name, bytes) {
  const sent = name.endsWith(".gz") ? gzipSync(bytes) : bytes;
  files.set(name, { bytes: sent });
  return { file: name, bytes: bytes.length, transfer: sent.length };
}

/** @param {string} name @param {Partial<{ bytes: Buffer, broken: boolean }>} change */
function alter(name, change) {
  const file = files.get(name);
  assert.ok(file);
  files.set(name, { ...file, ...change });
}

const downloads = (kept = /** @type {FakeStore | undefined} */ (store)) =>
  new library.Downloads(folder, { fetch, store: kept });

/** A store that is written to beside what is waited for. @param {() => boolean} holds */
async function soon(holds) {
  for (let turn = 0; turn < 1000 && !holds(); ++turn) await new Promise((go) => setTimeout(go, 2));
  assert.ok(holds());
}

test("a file is opened, and fetched once", async () => {
  const bytes = noise(300_000);
  const file = shipped("a.12345678.wasm.gz", bytes);
  const here = downloads();
  assert.equal(await here.isKept(file), false);
  assert.deepEqual(Buffer.from(await here.bytes(file)), bytes);
  await soon(() => store.kept.size === 1);
  assert.equal(await here.isKept(file), true);
  assert.deepEqual(Buffer.from(await downloads().bytes(file)), bytes);
  assert.deepEqual(asked, ["a.12345678.wasm.gz"]);
});

test("a blob holds the file as it is shipped", async () => {
  const file = shipped("a.12345678.pch.gz", noise(50_000));
  const blob = await downloads().blob(file);
  assert.deepEqual(Buffer.from(await blob.arrayBuffer()), files.get(file.file)?.bytes);
});

test("where the browser keeps nothing, it is fetched each time", async () => {
  const bytes = noise(1000);
  const file = shipped("a.12345678.tar.gz", bytes);
  const here = new library.Downloads(folder, { fetch, store: undefined });
  assert.equal(here.keeps, false);
  for (let turn = 0; turn < 2; ++turn) assert.deepEqual(Buffer.from(await here.bytes(file)), bytes);
  assert.equal(asked.length, 2);
});

test("progress adds up to what is transferred, also where the server has opened the file", async () => {
  const bytes = noise(300_000);
  const file = shipped("a.12345678.wasm.gz", bytes);
  for (const opened of [false, true]) {
    if (opened) alter(file.file, { bytes });
    store = new FakeStore();
    let received = 0;
    let told = 0;
    const arrived = (/** @type {number} */ count) => {
      received += count;
      told += 1;
    };
    assert.deepEqual(Buffer.from(await downloads().bytes(file, { arrived })), bytes);
    assert.ok(Math.abs(received - file.transfer) < 1e-6 * file.transfer, `${received}`);
    assert.ok(told > 1);
  }
});

test("a download that breaks off says so, and goes on from what is complete", async () => {
  const whole = shipped("whole.12345678.o.gz", noise(1000));
  const bytes = noise(400_000);
  const part = shipped("part.12345678.tar.gz", bytes);
  alter(part.file, { broken: true });
  const here = downloads();
  await here.bytes(whole);
  await assert.rejects(here.bytes(part), { name: "CheckerError", message: /broke off/ });
  await soon(() => store.kept.size === 1);
  alter(part.file, { broken: false });
  asked = [];
  await here.bytes(whole);
  assert.deepEqual(Buffer.from(await here.bytes(part)), bytes);
  assert.deepEqual(asked, [part.file]);
});

test("a file that is too short, though the server says it is whole, is not kept", async () => {
  const file = shipped("a.12345678.o", noise(1000));
  const bytes = Buffer.from(files.get(file.file)?.bytes ?? []);
  alter(file.file, { bytes: bytes.subarray(0, 900) });
  await assert.rejects(downloads().bytes(file), { name: "CheckerError", message: /broke off/ });
  await new Promise((go) => setTimeout(go, 20));
  assert.equal(store.kept.size, 0);
});

test("a disk that is full costs the keeping, not the file", async () => {
  const bytes = noise(2000);
  const file = shipped("a.12345678.o", bytes);
  store.put = async () => {
    throw new DOMException("no room", "QuotaExceededError");
  };
  assert.deepEqual(Buffer.from(await downloads().bytes(file)), bytes);
});

test("an abort is an abort, not a broken line", async () => {
  const file = shipped("a.12345678.o", noise(2000));
  const abort = new AbortController();
  abort.abort();
  await assert.rejects(downloads().bytes(file, { signal: abort.signal }), { name: "AbortError" });
});

/** @param {Record<string, unknown>} manifest */
const publish = (manifest) => {
  const empty = { format: "contact-cpp/1", core: [], behind: [], exercises: {} };
  files.set("manifest.json", { bytes: Buffer.from(JSON.stringify({ ...empty, ...manifest })) });
};

test("a new list removes what it does not name, of this book and of no other", async () => {
  const [old, stays, exercise] = ["old.1.o", "stays.1.o", "exercises/01/a.1.o"].map((name) =>
    shipped(name, noise(100)),
  );
  publish({ files: { old, stays }, exercises: { "01/a": exercise } });
  const here = downloads();
  await here.manifest();
  for (const file of [old, stays, exercise]) await here.bytes(/** @type {any} */ (file));
  await soon(() => store.kept.size === 4);
  store.kept.set("http://127.0.0.1/other/cpp/old.1.o", new Uint8Array(1));
  const newer = shipped("newer.1.o", noise(100));
  publish({ files: { stays, newer }, exercises: { "01/a": exercise }, core: ["stays", "newer"] });
  const later = downloads();
  const list = await later.manifest();
  await later.forgetOlder(list);
  assert.ok(store.kept.has(`${folder}old.1.o`), "until the new core is there, the old one stays");
  await later.bytes(/** @type {any} */ (newer));
  await soon(() => store.kept.has(`${folder}newer.1.o`));
  await later.forgetOlder(list);
  assert.deepEqual([...store.kept.keys()].map((url) => url.replace(folder, "")).sort(), [
    "exercises/01/a.1.o",
    "http://127.0.0.1/other/cpp/old.1.o",
    "manifest.json",
    "newer.1.o",
    "stays.1.o",
  ]);
});

test("without a network the stored list is used; without that, the reader is told", async () => {
  publish({ files: {} });
  await downloads().manifest();
  const offline = () => Promise.reject(new TypeError("Failed to fetch"));
  const kept = new library.Downloads(folder, { fetch: offline, store });
  assert.equal((await kept.manifest()).format, "contact-cpp/1");
  const none = new library.Downloads(folder, { fetch: offline, store: new FakeStore() });
  await assert.rejects(none.manifest(), { name: "CheckerError", message: /broke off/ });
});

test("a file that the list names and the server lacks: the book has been replaced", async () => {
  const gone = { file: "gone.1.o", bytes: 1, transfer: 1 };
  publish({ files: { gone } });
  const here = downloads();
  await here.manifest();
  await assert.rejects(here.bytes(gone), { name: "CheckerError", message: /has been replaced/ });
});

test("a book built without its exercises says so", async () => {
  await assert.rejects(downloads().manifest(), { name: "CheckerError", message: /built without/ });
  publish({ format: "contact-cpp/2", files: {} });
  await assert.rejects(downloads().manifest(), { name: "CheckerError", message: /versions/ });
});

test("a check waits for the precompiled header only if that is sooner than to do without", () => {
  const { patienceForPrelude } = timing;
  const size = 16e6;
  const line = (/** @type {number} */ bytesPerSecond) => ({
    bytes: 27e6,
    seconds: 27e6 / bytesPerSecond,
  });
  assert.equal(patienceForPrelude(size, line(1e6)), 0);
  assert.equal(patienceForPrelude(size, line(3e6)), 0);
  assert.ok(patienceForPrelude(size, line(4e6)) > 4);
  assert.ok(patienceForPrelude(size, line(100e6)) >= 1);
  // Nearly there: also on a slow line.
  assert.ok(patienceForPrelude(1e6, line(1e6)) >= 1);
  // Everything came from the cache, or too little to judge by.
  assert.equal(patienceForPrelude(size, { bytes: 0, seconds: 0.1 }), 0);
  assert.equal(patienceForPrelude(size, { bytes: 5000, seconds: 0.001 }), 0);
});
