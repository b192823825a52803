// The book without a network: what was visited, the whole of it, and what a new version does to both.

import assert from "node:assert/strict";
import crypto from "node:crypto";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { after, before, describe, test } from "node:test";
import { pathToFileURL } from "node:url";
import {
  completeLessons,
  launch,
  lessons,
  loadFigures,
  notRun,
  open,
  serve,
  site,
} from "./browser.mjs";
import { exerciseOn, pageOf, solutionOf } from "./exercise_page.mjs";

const skip = notRun();
const LESSON = skip ? "" : /** @type {string} */ (completeLessons().at(-1));
const OTHER = skip ? "" : /** @type {string} */ (completeLessons()[0]);

/** @typedef {import("playwright-core").Page} Page */

/** Waits until this page and all that it has loaded are kept. @param {Page} page */
async function kept(page) {
  await page.evaluate(async () => {
    const loaded = () => performance.getEntriesByType("resource").map(({ name }) => name);
    const there = async (/** @type {string} */ address) => {
      const name = (await caches.keys()).find((key) => key.startsWith("contact-book/1/files"));
      return name && (await (await caches.open(name)).match(address, { ignoreSearch: true }));
    };
    const wanted = new Set([location.href, ...loaded()]);
    for (const address of wanted)
      while (!/\/(offline\.json|sw\.js)$/.test(address) && !(await there(address)))
        await new Promise((done) => setTimeout(done, 20));
  });
}

/**
 * What a page asks for and does not get. The worker's own attempts are not among it, nor what a page
 * no longer wanted, nor the look for a newer book and a newer compiler, nor a figure that this run has not built.
 * @param {Page} page
 */
function failures(page) {
  const looks = /\/(offline|manifest|building)\.json(\?|$)/;
  const notBuilt = (/** @type {string} */ address) => {
    const { pathname } = new URL(address);
    return /\/figures\/.*\.wasm$/.test(pathname) && !fs.existsSync(path.join(site, pathname));
  };
  /** @type {string[]} */
  const failed = [];
  page.on("requestfailed", (request) => {
    const dropped = request.failure()?.errorText === "net::ERR_ABORTED";
    const address = request.url();
    if (!dropped && !looks.test(address) && !notBuilt(address)) failed.push(address);
  });
  return failed;
}

/** Where the files are that are kept. @param {Page} page @returns {Promise<string[]>} */
const keptFiles = (page) =>
  page.evaluate(async () => {
    const name = (await caches.keys()).find((key) => key.startsWith("contact-book/1/files"));
    const keys = name ? await (await caches.open(name)).keys() : [];
    return keys.map(({ url }) => new URL(url).pathname);
  });

/** Everything a page shows is there, and its figures run, those that are built. @param {Page} page */
async function reads(page) {
  assert.equal(await page.locator("h1").count(), 1);
  await loadFigures(page);
  const figure = page.locator("contact-figure:not(:has(> .not-built))").first();
  if (await figure.count()) assert.ok(await figure.locator(".stage").isVisible());
  const family = await page.evaluate(() => document.fonts.check('16px "Source Serif 4"'));
  assert.ok(family, "the face of the text");
  const style = await page.evaluate(() => getComputedStyle(document.body).backgroundColor);
  assert.notEqual(style, "rgba(0, 0, 0, 0)", "the style");
}

describe("offline", { skip, timeout: 300_000 }, () => {
  /** @type {Awaited<ReturnType<typeof launch>>} */
  let chromium;
  /** @type {string} */
  let scratch;
  before(async () => {
    chromium = await launch();
    scratch = fs.mkdtempSync(path.join(os.tmpdir(), "contact-offline-"));
  });
  after(async () => {
    await chromium.close();
    fs.rmSync(scratch, { recursive: true, force: true });
  });

  test("the list names every file of the site as it is", () => {
    const list = JSON.parse(fs.readFileSync(path.join(site, "offline.json"), "utf8"));
    assert.equal(list.format, "contact-offline/1");
    const names = Object.keys(list.files);
    for (const needed of ["index.html", LESSON, "_static/book.css", "_static/contact/contact.js"])
      assert.ok(names.includes(needed), needed);
    for (const [name, { hash, bytes, transfer }] of Object.entries(list.files)) {
      const content = fs.readFileSync(path.join(site, name));
      const digest = crypto.createHash("sha256").update(content).digest("hex");
      assert.equal(digest.slice(0, hash.length), hash, name);
      assert.equal(content.length, bytes, name);
      assert.ok(transfer > 0 && transfer <= bytes + 64, name);
    }
  });

  test("a page that was visited once is read again with the network off", async () => {
    const server = await serve();
    const { page, close } = await open(chromium.browser, `${server.origin}/${LESSON}`);
    await loadFigures(page);
    await kept(page);
    const failed = failures(page);
    await page.context().setOffline(true);
    await page.reload();
    await reads(page);
    assert.deepEqual(failed, []);
    await close();
    server.close();
  });

  test("and when the server is gone; a page never visited says that it is not kept", async () => {
    const server = await serve();
    const { page, close } = await open(chromium.browser, `${server.origin}/${LESSON}`);
    await loadFigures(page);
    await kept(page);
    server.close();
    await page.goto(`${server.origin}/${OTHER}`);
    assert.equal(await page.locator("h1").textContent(), "You are offline");
    await page.getByRole("link", { name: LESSON }).click();
    await reads(page);
    await close();
  });

  test("what is kept is not asked for again", async () => {
    const server = await serve();
    const { page, close } = await open(chromium.browser, `${server.origin}/${LESSON}`);
    await loadFigures(page);
    await kept(page);
    server.asked.length = 0;
    await page.reload();
    await loadFigures(page);
    await page.waitForLoadState("networkidle");
    const again = new Set(server.asked);
    again.delete("/sw.js"); // The browser looks for a newer worker when it likes.
    assert.deepEqual([...again].sort(), [`/${LESSON}`, "/offline.json"].sort());
    await close();
    server.close();
  });

  /** Keeps the whole book from the page of one's work. @param {Page} page */
  async function keepWhole(page) {
    const keep = page.getByRole("button", { name: /^Keep the whole book/ });
    assert.match((await keep.textContent()) ?? "", /\(\d+(\.\d)? [kM]B\)$/, "the size, before");
    await keep.click();
    await page.getByText(/^Done[:,] /).waitFor();
    assert.match(
      (await page.locator("contact-work .kept").textContent()) ?? "",
      /whole book is kept/,
    );
  }

  test("the whole book is kept, and every page is read without a server", async () => {
    const server = await serve();
    const { page, trouble, close } = await open(
      chromium.browser,
      `${server.origin}/your_work.html`,
    );
    assert.deepEqual(trouble, []);
    await keepWhole(page);
    await page.getByText("Done, without the compiler: ").waitFor();
    server.close();
    const failed = failures(page);
    const list = JSON.parse(fs.readFileSync(path.join(site, "offline.json"), "utf8"));
    const pages = Object.keys(list.files).filter((name) => /^[a-z].*\.html$/.test(name));
    assert.ok(pages.length > 5);
    for (const where of pages) {
      const answer = await page.goto(`${server.origin}/${where}`);
      assert.equal(answer?.status(), 200, where);
    }
    await page.goto(`${server.origin}/search.html?q=triangle`);
    await page.locator("ul.search li").first().waitFor();
    for (const where of lessons()) {
      await page.goto(`${server.origin}/${where}`);
      await reads(page);
    }
    assert.deepEqual(failed, []);
    await page.goto(`${server.origin}/your_work.html`);
    await page.getByRole("button", { name: "Forget it" }).click();
    await page.getByText("Forgotten. Your own work is untouched.").waitFor();
    await page.goto(`${server.origin}/${LESSON}`, { waitUntil: "commit" }).catch(() => {});
    assert.notEqual(await page.locator("h1").first().textContent({ timeout: 5000 }), "Triangles");
    await close();
  });

  test("with the compiler, an exercise is checked without a server", async () => {
    const server = await serve();
    const { page, close } = await open(chromium.browser, `${server.origin}/your_work.html`, {
      permissions: ["clipboard-read", "clipboard-write"],
    });
    await page.getByRole("checkbox", { name: /^With the compiler.* MB\)$/ }).check();
    await keepWhole(page);
    assert.match(
      (await page.locator("contact-work .kept").textContent()) ?? "",
      /compiler is kept/,
    );
    await page.getByText("Done: everything is kept").waitFor();
    server.close();
    const id = "02_triangles/ray_triangle";
    await page.goto(`${server.origin}/${pageOf(id)}`);
    const exercise = exerciseOn(page, id);
    assert.equal(await exercise.submit(solutionOf(id)), "passed");
    await close();
  });

  test("a reader with a downloaded compiler gets the tests of all exercises with the book", async () => {
    const server = await serve();
    const { page, close } = await open(chromium.browser, `${server.origin}/your_work.html`);
    const exercises = await page.evaluate(async () => {
      const folder = new URL("_static/contact/cpp/", document.baseURI);
      const manifest = await (await fetch(new URL("manifest.json", folder))).json();
      const cache = await caches.open("contact-cpp");
      for (const key of manifest.core)
        await cache.put(new URL(manifest.files[key].file, folder), new Response("kept"));
      const objects = /** @type {{ file: string }[]} */ (Object.values(manifest.exercises));
      return objects.map(({ file }) => new URL(file, folder).href);
    });
    await page.reload();
    await page.getByRole("checkbox", { name: /^With the compiler/, checked: true }).waitFor();
    await keepWhole(page);
    await page.getByText("Done: everything is kept").waitFor();
    const kept = await page.evaluate(async () =>
      (await (await caches.open("contact-cpp")).keys()).map(({ url }) => url),
    );
    assert.ok(exercises.length > 0);
    assert.deepEqual(
      exercises.filter((address) => !kept.includes(address)),
      [],
    );
    server.close();
    await close();
  });

  test("a download that is stopped goes on where it was", async () => {
    const server = await serve();
    const { page, close } = await open(chromium.browser, `${server.origin}/your_work.html`);
    // Two files never come.
    server.answer = (pathname) => pathname.startsWith("/_static/contact/ladders/");
    await page.getByRole("button", { name: /^Keep the whole book/ }).click();
    while ((await keptFiles(page)).length < 20) await page.waitForTimeout(20);
    await page.getByRole("button", { name: "Stop" }).click();
    await page.getByText(/^Stopped\./).waitFor();
    server.answer = undefined;
    const there = new Set(await keptFiles(page));
    server.asked.length = 0;
    await keepWhole(page);
    assert.deepEqual(
      server.asked.filter((asked) => there.has(asked)),
      [],
    );
    assert.ok((await keptFiles(page)).length > there.size);
    await close();
    server.close();
  });

  /** A copy of the site that a test may change, without the compiler. */
  function copyOfSite() {
    const folder = fs.mkdtempSync(path.join(scratch, "site-"));
    const compiler = path.join(site, "_static", "contact", "cpp");
    fs.cpSync(site, folder, { recursive: true, filter: (from) => from !== compiler });
    return folder;
  }

  /** Publishes another version: some files changed, some removed, and the list written again. */
  function publish(
    /** @type {string} */ folder,
    /** @type {Record<string, (text: string) => string | undefined>} */ changes,
  ) {
    const where = path.join(folder, "offline.json");
    const list = JSON.parse(fs.readFileSync(where, "utf8"));
    for (const [name, change] of Object.entries(changes)) {
      const file = path.join(folder, name);
      const text = change(fs.readFileSync(file, "utf8"));
      fs.rmSync(file);
      delete list.files[name];
      if (text === undefined) continue;
      fs.writeFileSync(file, text);
      const hash = crypto.createHash("sha256").update(text).digest("hex").slice(0, 16);
      list.files[name] = { hash, bytes: text.length, transfer: text.length };
    }
    list.version = crypto.randomBytes(8).toString("hex");
    fs.writeFileSync(where, JSON.stringify(list));
  }

  const chunks = () => {
    const folder = path.join(site, "_static", "contact", "chunks");
    return fs.readdirSync(folder).map((name) => `_static/contact/chunks/${name}`);
  };

  test("a new version replaces what changed, and only that; code stays", async () => {
    const folder = copyOfSite();
    const server = await serve(folder);
    const { page, close } = await open(chromium.browser, `${server.origin}/your_work.html`);
    const code = JSON.stringify({ text: "// mine", base: "", saved: "", kept: [] });
    const key = "contact-hours/1/code/02_triangles/ray_triangle";
    await page.evaluate(([name, text]) => localStorage.setItem(name, text), [key, code]);
    await keepWhole(page);
    publish(folder, {
      [LESSON]: (text) => text.replace(/<h1>[^<]*/, "<h1>A newer chapter"),
      "_static/book.css": (text) => `${text}\narticle h1 { letter-spacing: 3px; }\n`,
    });
    server.asked.length = 0;
    await page.goto(`${server.origin}/${OTHER}`);
    await page.waitForFunction(async () => {
      const name = (await caches.keys()).find((it) => it.startsWith("contact-book/1/notes"));
      const notes = await caches.open(/** @type {string} */ (name));
      const read = async (/** @type {string} */ note) =>
        (await (await notes.match(new URL(note, `${location.origin}/`)))?.json()) ?? {};
      return (await read("whole")).version === (await read("current"));
    });
    const pages = new Set(server.asked.filter((asked) => !/(sw\.js|offline\.json)$/.test(asked)));
    assert.deepEqual([...pages].sort(), ["/_static/book.css", `/${LESSON}`, `/${OTHER}`].sort());
    server.close();
    await page.goto(`${server.origin}/${LESSON}`);
    assert.match((await page.locator("h1").textContent()) ?? "", /^A newer chapter/);
    const spacing = () =>
      page.locator("h1").evaluate((node) => getComputedStyle(node).letterSpacing);
    assert.equal(await spacing(), "3px");
    assert.equal(await page.evaluate((name) => localStorage.getItem(name), key), code);
    const places = await keptFiles(page);
    assert.equal(places.length, new Set(places).size, "one version of each file");
    await close();
  });

  test("an update breaks no page that is open", async () => {
    const folder = copyOfSite();
    const server = await serve(folder);
    const { page, close } = await open(chromium.browser, `${server.origin}/your_work.html`);
    await keepWhole(page);
    await page.goto(`${server.origin}/${LESSON}`);
    // Everything that the open page may still ask for is gone from the site or is another.
    /** @type {Record<string, () => string | undefined>} */
    const gone = Object.fromEntries(chunks().map((name) => [name, () => undefined]));
    const place = `_static/contact/figures/${LESSON.slice("chapters/".length, -".html".length)}`;
    const figures = fs.readdirSync(path.join(site, place)).filter((name) => name.endsWith(".js"));
    for (const name of figures)
      gone[`${place}/${name}`] = () => "throw new Error('another version');";
    publish(folder, {
      ...gone,
      "_static/contact/contact.js": () => "throw new Error('another version');",
      [OTHER]: (text) => text.replace(/<h1>[^<]*/, "<h1>A newer chapter"),
    });
    const second = await page.context().newPage();
    await second.goto(`${server.origin}/${OTHER}`);
    assert.match((await second.locator("h1").textContent()) ?? "", /^A newer chapter/);
    await second.waitForLoadState("networkidle");
    await reads(page);
    await close();
    server.close();
  });

  test("a page opened from a file says that it runs nothing, and only there", async () => {
    const context = await chromium.browser.newContext();
    const page = await context.newPage();
    await page.goto(pathToFileURL(path.join(site, LESSON)).href);
    const note = page.locator(".opened-from-file");
    assert.ok(await note.isVisible());
    assert.match((await note.textContent()) ?? "", /runs nothing.*\.\/contact serve/s);
    assert.ok(await page.locator("contact-figure > img").first().isVisible());
    const server = await serve();
    await page.goto(`${server.origin}/${LESSON}`);
    assert.equal(await note.count(), 0);
    await context.close();
    server.close();
  });
});
