// The page of a reader's own work: what it shows, and how work gets out of a browser and into another.

import assert from "node:assert/strict";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { after, before, describe, test } from "node:test";
import { notRun, open, require, root, settle } from "./browser.mjs";
import { inBrowser } from "./in_browser.mjs";

const skip = notRun();

/** @typedef {import("playwright-core").Page} Page */
/** @typedef {import("playwright-core").BrowserContextOptions} Options */

const HIT = "02_triangles/ray_triangle";
const GONE = "02_triangles/taken_out";
const CODE = "contact-hours/1/code/";
const PROGRESS = "contact-hours/1/progress";

const code = (/** @type {string} */ text) =>
  JSON.stringify({ text, base: "", saved: "2026-11-21T08:00:00Z", kept: [] });
const record = (/** @type {Record<string, object>} */ exercises) =>
  JSON.stringify({ format: "contact-progress/1", exercises });

/** What a reader may have in a browser. */
const MINE = {
  [`${CODE}${HIT}`]: code("// mine\n"),
  [`${CODE}${GONE}`]: code("int gone = 1;\n"),
  [PROGRESS]: record({
    [HIT]: { attempts: 3, best_points: 7, max_points: 12, hints_shown: 1, tests: {} },
  }),
};

describe("your work", { skip, timeout: 120_000 }, () => {
  const { server, chromium } = inBrowser();
  /** @type {string} */
  let scratch;
  before(async () => {
    scratch = fs.mkdtempSync(path.join(os.tmpdir(), "contact-work-"));
  });
  after(async () => {
    fs.rmSync(scratch, { recursive: true, force: true });
  });

  /** The page in a profile of its own that holds this. @param {Record<string, string>} holds @param {Options} options */
  async function visit(holds = {}, options = {}) {
    const shown = await open(chromium.browser, `${server.origin}/your_work.html`, options);
    await shown.page.evaluate((entries) => {
      for (const [key, value] of Object.entries(entries)) localStorage.setItem(key, value);
    }, holds);
    await shown.page.reload();
    await shown.page.locator("contact-work table").waitFor();
    // What the judge says, and what is kept for offline reading, arrive later and push the rest down.
    if (holds[PROGRESS]) await shown.page.locator(".mastery li").first().waitFor();
    await shown.page.locator(".offline .kept").filter({ hasText: /./ }).waitFor();
    await settle(shown.page);
    return shown;
  }

  const stored = (/** @type {Page} */ page, /** @type {string} */ key) =>
    page.evaluate((name) => JSON.parse(localStorage.getItem(name) ?? "null"), key);

  const cells = (/** @type {Page} */ page, /** @type {string} */ id) =>
    page.locator(`tr[data-exercise="${id}"] :is(th, td)`).allTextContents();

  /** Presses what saves a file, and returns where it was saved. @param {Page} page @param {string} button */
  async function download(page, button) {
    const [file] = await Promise.all([
      page.waitForEvent("download"),
      page.getByRole("button", { name: button, exact: true }).press("Enter"),
    ]);
    const place = path.join(scratch, `${Math.random()}-${file.suggestedFilename()}`);
    await file.saveAs(place);
    return place;
  }

  const importFile = (/** @type {Page} */ page, /** @type {string | object} */ file) =>
    page.getByLabel(/^Import an archive/).setInputFiles(/** @type {any} */ (file));

  const said = (/** @type {Page} */ page) => page.locator(".along [role=status]");

  test("points, how far, a link to each exercise, and the sum of a chapter", async () => {
    const { page, trouble, close } = await visit(MINE);
    const [title, points, far] = await cells(page, HIT);
    assert.ok(title);
    assert.equal(points, "7 of 12");
    assert.equal(far, "tried 3 times, 1 hint");
    const chapter = page.locator("tr.chapter").filter({ hasText: "Triangles" });
    assert.match((await chapter.textContent()) ?? "", /7 of \d+0 of \d passed/);
    await page.locator(`tr[data-exercise="${HIT}"] a`).press("Enter");
    await page.waitForURL(/chapters\/02_triangles\.html#exercise-ray-triangle$/);
    assert.ok(await page.locator("#exercise-ray-triangle").isVisible());
    assert.deepEqual(trouble, []);
    await close();
  });

  test("objectives are mastered as the book's judge says", async () => {
    const done = { attempts: 1, best_points: 12, max_points: 12, passed: "2026-11-20T10:00:00Z" };
    const { page, trouble, close } = await visit({ [PROGRESS]: record({ [HIT]: done }) });
    const objectives = page.locator(".mastery li");
    await objectives.first().waitFor();
    const where = path.join(root, "chapters", "02_triangles", "chapter.toml");
    const toml = fs.readFileSync(where, "utf8");
    for (const said of await objectives.allTextContents()) {
      const text = said.replace(/^(Mastered|Not passed yet|\d of \d passed)\. /, "");
      assert.ok(toml.includes(`text = "${text}"`), said);
    }
    assert.ok(await objectives.filter({ hasText: "Not passed yet." }).count());
    assert.deepEqual(trouble, []);
    await page.evaluate((key) => localStorage.removeItem(key), PROGRESS);
    await page.reload();
    await page.locator("contact-work table").waitFor();
    assert.equal(await objectives.count(), 0);
    await close();
  });

  test("code of an exercise that the book no longer has is shown, and saved to a file", async () => {
    const { page, close } = await visit(MINE);
    const lost = page.locator(`.lost li[data-exercise="${GONE}"]`);
    await lost.locator("summary").press("Enter");
    assert.equal(await lost.locator("pre").textContent(), "int gone = 1;\n");
    const place = await download(page, "Save taken_out.cpp");
    assert.equal(fs.readFileSync(place, "utf8"), "int gone = 1;\n");
    await close();
  });

  test("out of one browser and into another, where nothing is lost", async () => {
    const first = await visit(MINE);
    const archive = await download(first.page, "Export my work");
    await first.close();
    const second = await visit({
      [`${CODE}${HIT}`]: code("// other\n"),
      [PROGRESS]: record({ [HIT]: { attempts: 1, best_points: 9, max_points: 12, tests: {} } }),
    });
    const [title] = await cells(second.page, HIT);
    await importFile(second.page, archive);
    await said(second.page).getByText(`Changed: ${title}.`).waitFor();
    await said(second.page).getByText(`New here: ${GONE}.`).waitFor();
    const now = await stored(second.page, `${CODE}${HIT}`);
    assert.equal(now.text, "// mine\n");
    assert.deepEqual(
      now.kept.map((/** @type {any} */ version) => [version.text, version.why]),
      [["// other\n", "import"]],
    );
    const [, points, far] = await cells(second.page, HIT);
    assert.equal(points, "9 of 12");
    assert.equal(far, "tried 3 times, 1 hint");
    await importFile(second.page, archive);
    await said(second.page)
      .getByText(/^The same already: /)
      .waitFor();
    await second.close();
  });

  test("the command line's progress.json is taken in; what is neither is refused, and changes nothing", async () => {
    const { page, close } = await visit(MINE);
    const passed = { attempts: 1, best_points: 12, max_points: 12, passed: "2026-11-20T10:00:00Z" };
    const file = path.join(scratch, "progress.json");
    fs.writeFileSync(file, record({ [HIT]: passed }));
    await importFile(page, file);
    await said(page)
      .getByText(/^Progress of 1 exercise is merged/)
      .waitFor();
    assert.deepEqual((await cells(page, HIT)).slice(1), [
      "12 of 12",
      "passed on 20 November 2026, 1 hint",
    ]);
    const before = await page.evaluate(() => JSON.stringify(localStorage));
    for (const [name, content] of Object.entries({
      "a.json": "{}",
      "a.zip": "PK\u0003\u0004 no",
    })) {
      await importFile(page, { name, mimeType: "text/plain", buffer: Buffer.from(content) });
      await said(page).getByText("Nothing was changed.").waitFor();
      assert.equal(await page.evaluate(() => JSON.stringify(localStorage)), before);
    }
    await close();
  });

  test("forgetting asks, saves first, and leaves nothing", async () => {
    const { page, close } = await visit(MINE);
    await page.evaluate(() => localStorage.setItem("theme", "dark"));
    await page.getByRole("button", { name: "Forget everything", exact: true }).press("Enter");
    await page.getByRole("button", { name: "Keep it" }).press("Enter");
    assert.ok(await stored(page, PROGRESS));
    await page.getByRole("button", { name: "Forget everything", exact: true }).press("Enter");
    const archive = await download(page, "Export, then forget everything");
    await page.getByText(/^Forgotten\. Your work is in contact-hours-.*\.zip\.$/).waitFor();
    assert.deepEqual(await page.evaluate(() => Object.keys(localStorage)), ["theme"]);
    const left = await page.evaluate(async () => {
      const open = (await caches.keys()).map(async (name) => (await caches.open(name)).keys());
      return (await Promise.all(open)).flat().map(({ url }) => url);
    });
    assert.deepEqual(left, []);
    assert.deepEqual(await cells(page, HIT).then((row) => row[2]), "not begun");
    await importFile(page, archive);
    await said(page)
      .getByText(/^New here: /)
      .waitFor();
    assert.equal((await stored(page, `${CODE}${HIT}`)).text, "// mine\n");
    await close();
  });

  test("by keyboard alone", async () => {
    const { page, close } = await visit(MINE);
    const focused = () => page.evaluate(() => document.activeElement?.textContent ?? "");
    await page.getByRole("button", { name: "Export my work" }).focus();
    const download = page.waitForEvent("download");
    await page.keyboard.press("Enter");
    await download;
    await page.keyboard.press("Tab");
    assert.equal(await page.evaluate(() => document.activeElement?.id), "contact-import");
    for (let steps = 0; steps < 10 && (await focused()) !== "Forget everything"; steps += 1)
      await page.keyboard.press("Tab");
    await page.keyboard.press("Enter");
    assert.equal(await focused(), "Export, then forget everything");
    await page.keyboard.press("Tab");
    await page.keyboard.press("Enter");
    assert.equal(await focused(), "Forget everything");
    assert.ok(await stored(page, PROGRESS));
    await close();
  });

  for (const colorScheme of /** @type {const} */ (["light", "dark"]))
    test(`axe finds nothing, ${colorScheme}`, async () => {
      const { page, close } = await visit(MINE, { colorScheme, reducedMotion: "reduce" });
      await page.getByRole("button", { name: "Forget everything", exact: true }).press("Enter");
      await page.locator(".lost summary").press("Enter");
      await page.evaluate(() => scrollTo(0, 0));
      await page.addScriptTag({ path: require.resolve("axe-core/axe.min.js") });
      const found = await page.evaluate(async () => {
        const { violations } = await /** @type {any} */ (globalThis).axe.run(document);
        return violations.map((/** @type {any} */ rule) => [
          rule.id,
          rule.nodes.map((/** @type {any} */ node) => node.failureSummary),
        ]);
      });
      assert.deepEqual(found, []);
      await close();
    });

  test("nothing sticks out on a phone", async () => {
    const viewport = { width: 360, height: 740 };
    const { page, close } = await visit(MINE, { viewport, isMobile: true, hasTouch: true });
    const width = await page.evaluate(() => document.documentElement.scrollWidth);
    assert.ok(width <= 360, `${width} pixels wide`);
    await close();
  });

  test("without a script, the page says how the command line does it", async () => {
    const { page, trouble, close } = await open(
      chromium.browser,
      `${server.origin}/your_work.html`,
      { javaScriptEnabled: false },
    );
    assert.ok(await page.getByText("This page needs JavaScript").isVisible());
    assert.ok(await page.getByText("./contact export my-work.zip").isVisible());
    assert.deepEqual(trouble, []);
    await close();
  });

  test("where nothing can be kept for offline reading, the page says why", async () => {
    const { page, close } = await open(chromium.browser, `${server.origin}/your_work.html`);
    await page.addInitScript(() =>
      Object.defineProperty(globalThis, "isSecureContext", { value: false }),
    );
    await page.reload();
    await page.getByText("only if it comes over https or from this machine").waitFor();
    assert.equal(await page.getByRole("button", { name: /offline/ }).count(), 0);
    await close();
  });
});
