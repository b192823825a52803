// The book without a network: what was visited, the whole of it, and what a new version does to both.

import assert from "node:assert/strict";
import crypto from "node:crypto";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { after, before, describe, test } from "node:test";
import { launch, lessons, loadFigures, notRun, open, serve, site } from "./browser.mjs";

const skip = notRun();
const LESSON = skip ? "" : /** @type {string} */ (lessons().at(-1));
const OTHER = skip ? "" : /** @type {string} */ (lessons()[0]);

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

/** Everything a page shows is there, and its figures run. @param {Page} page */
async function reads(page) {
  assert.equal(await page.locator("h1").count(), 1);
  await loadFigures(page);
  const figure = page.locator("contact-figure").first();
  assert.ok(await figure.locator(".stage").isVisible());
  const family = await page.evaluate(() => document.fonts.check('16px "Source Serif 4"'));
  assert.ok(family, "the face of the text");
  const style = await page.evaluate(() => getComputedStyle(document.body).backgroundColor);
  assert.notEqual(style, "rgba(0, 0, 0, 0)", "the style");
}

describe("offline", { skip, timeout: 120_000 }, () => {
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
    const { page, trouble, close } = await open(chromium.browser, `${server.origin}/${LESSON}`);
    await loadFigures(page);
    await kept(page);
    await page.context().setOffline(true);
    await page.reload();
    await reads(page);
    assert.deepEqual(trouble, []);
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
});
