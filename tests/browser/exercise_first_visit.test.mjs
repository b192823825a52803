// Exercises on the first visit of a page and on later ones: the download of the toolchain, and the behaviour when a
// file does not load or cannot be stored.

import assert from "node:assert/strict";
import fs from "node:fs";
import path from "node:path";
import { describe, test } from "node:test";
import { notRun, site } from "./browser.mjs";
import {
  exerciseOn,
  hintFor,
  newReader,
  PATIENCE,
  pageOf,
  plain,
  solutionOf,
  stubOf,
  toolchainAsked,
  visit,
  wrongAnswersOf,
} from "./exercise_page.mjs";
import { inBrowser } from "./in_browser.mjs";

/** @typedef {import("./exercise_page.mjs").Exercise} Exercise */
/** @typedef {import("playwright-core").Page} Page */
/** @typedef {import("playwright-core").BrowserContext} BrowserContext */

const skip = notRun();
const segment = "01_planes/segment_plane";
const distance = "01_planes/signed_distance";

describe("exercises on a first or later visit", { skip }, () => {
  const { server, chromium } = inBrowser();
  /** @param {import("playwright-core").BrowserContextOptions} [options] */
  const nothingKept = (options) => newReader(chromium.browser, options);
  const asked = (since = 0) => toolchainAsked(server.asked.slice(since));

  test("two exercises checked at the same time: each its own verdict, one download", async () => {
    const context = await nothingKept();
    const since = server.asked.length;
    const { page, trouble } = await visit(context, server.origin, pageOf(segment));
    const first = exerciseOn(page, segment);
    const second = exerciseOn(page, distance);
    const [wrong] = wrongAnswersOf(distance);
    assert.ok(wrong);
    await first.paste(solutionOf(segment));
    await second.paste(wrong.text);
    const verdicts = [
      first.untilDone(() => first.press("Check")),
      second.untilDone(() => second.press("Check")),
    ];
    assert.deepEqual(await Promise.all(verdicts), ["passed", "failed"]);
    const failure = await second.failureOf(wrong.caughtBy);
    assert.equal(failure.at(-1)?.says, hintFor(wrong.misconception));
    const times = asked(since);
    assert.ok(
      Object.keys(times).some((name) => /llvm/.test(name)),
      Object.keys(times).join(),
    );
    for (const [name, count] of Object.entries(times)) assert.equal(count, 1, name);
    assert.deepEqual(trouble, []);
    await context.close();
  });

  describe("the download", () => {
    const manifest = () =>
      JSON.parse(fs.readFileSync(path.join(site, "_static/contact/cpp/manifest.json"), "utf8"));
    /** The largest file that a first check needs. */
    const largest = () => {
      const { core, files } = manifest();
      const parts = core.map((/** @type {string} */ key) => files[key]);
      return parts.sort((/** @type {any} */ a, /** @type {any} */ b) => b.transfer - a.transfer)[0];
    };
    const limited = { timeout: 2 * PATIENCE };
    const getReady = /^Get ready \((\d+) MB\)$/;
    /** @type {BrowserContext} */
    let context;
    /** @type {Page} */
    let page;
    /** @type {Exercise} */
    let exercise;
    const begin = async () => {
      context = await nothingKept();
      ({ page } = await visit(context, server.origin, pageOf(segment)));
      exercise = exerciseOn(page, segment);
      // The size is shown when the reader gets there.
      await exercise.button("Check").scrollIntoViewIfNeeded();
    };
    const end = async () => {
      server.answer = undefined;
      await context.close();
    };

    /** Sends half of a file, and the rest or a broken connection when it is told to. */
    function halfOf(/** @type {string} */ name) {
      /** @type {(how: "rest" | "break") => void} */
      let go = () => {};
      const told = new Promise((resolve) => {
        go = resolve;
      });
      server.answer = (pathname, response, file) => {
        if (!pathname.endsWith(`/${name}`)) return false;
        const bytes = fs.readFileSync(file);
        const half = bytes.length >> 1;
        response.writeHead(200, { "content-length": bytes.length });
        response.write(bytes.subarray(0, half));
        told.then((how) => {
          if (how === "rest") response.end(bytes.subarray(half));
          else response.destroy();
        });
        return true;
      };
      return go;
    }

    test("its size is said before anything is downloaded", async () => {
      const since = server.asked.length;
      await begin();
      const said = await exercise.button(getReady).textContent();
      const { core, files } = manifest();
      const bytes = core.reduce(
        (/** @type {number} */ sum, /** @type {string} */ key) => sum + files[key].transfer,
        0,
      );
      const megabytes = Number(said?.match(getReady)?.[1]);
      assert.ok(Math.abs(megabytes - bytes / 1e6) <= 1.5, `${said}, and it is ${bytes} bytes`);
      assert.deepEqual(asked(since), {});
      await end();
    });

    test("a bar shows how far it is; the next visit downloads nothing", async () => {
      await begin();
      const go = halfOf(path.basename(largest().file));
      await exercise.press(getReady);
      const bar = exercise.element.locator(".progress progress");
      await bar.waitFor();
      await page.waitForFunction(
        (id) => {
          const progress = document.querySelector(`contact-exercise[name="${id}"] progress`);
          const { value = 0, max = 0 } = /** @type {HTMLProgressElement} */ (progress) ?? {};
          return value > max / 10 && value < max;
        },
        segment,
        { timeout: PATIENCE },
      );
      assert.match(
        plain((await exercise.element.locator(".progress").textContent()) ?? ""),
        /\d MB/,
      );
      assert.equal(await exercise.attribute("state"), "loading");
      go("rest");
      await exercise.button(getReady).waitFor({ state: "detached", timeout: PATIENCE });
      await bar.waitFor({ state: "hidden", timeout: PATIENCE });
      // What is fetched behind the reader's back comes too; then a second visit needs nothing.
      assert.equal(await exercise.submit(solutionOf(segment)), "passed");
      await page.waitForLoadState("networkidle");
      const since = server.asked.length;
      await page.reload({ waitUntil: "load" });
      assert.equal(await exercise.button(getReady).count(), 0);
      assert.equal(await exercise.check(), "passed");
      await page.waitForLoadState("networkidle");
      assert.deepEqual(asked(since), {});
      await end();
    });

    test("one that breaks off says so, and goes on with what is missing", limited, async () => {
      await begin();
      const name = path.basename(largest().file);
      const go = halfOf(name);
      const since = server.asked.length;
      await exercise.press(getReady);
      const { core, files } = manifest();
      const others = core
        .map((/** @type {string} */ key) => files[key].file)
        .filter((/** @type {string} */ file) => file !== name && !file.startsWith("judge"));
      /** Which of them the browser has kept so far. */
      const kept = () =>
        page.evaluate(
          async (wanted) => {
            const requests = await (await caches.open("contact-cpp")).keys();
            return wanted.filter((file) => requests.some(({ url }) => url.endsWith(`/${file}`)));
          },
          /** @type {string[]} */ (others),
        );
      while ((await kept()).length < others.length) await page.waitForTimeout(50);
      go("break");
      const status = exercise.element.locator(".status").filter({ hasText: /broke off/i });
      await status.waitFor({ timeout: PATIENCE });
      assert.equal(await exercise.attribute("state"), "idle");
      server.answer = undefined;
      assert.equal(await exercise.submit(solutionOf(segment)), "passed");
      const times = asked(since);
      for (const [pathname, count] of Object.entries(times))
        assert.ok(count === 1 || pathname.endsWith(`/${name}`), `${pathname}: ${count} times`);
      await end();
    });

    test("any static host will do: no isolation is asked for", async () => {
      await begin();
      const response = await page.reload();
      const headers = Object.keys(response?.headers() ?? {});
      assert.deepEqual(
        headers.filter((name) => /cross-origin/.test(name)),
        [],
      );
      assert.equal(await page.evaluate(() => crossOriginIsolated), false);
      await end();
    });
  });

  test("a page that comes back out of the browser's memory shows what was written meanwhile", async () => {
    const context = await nothingKept();
    const page = await context.newPage();
    await page.goto(`${server.origin}/${pageOf(segment)}`, { waitUntil: "load" });
    const exercise = exerciseOn(page, segment);
    await exercise.edit();
    await exercise.paste("// written before\n");
    await page.evaluate((id) => {
      const key = `contact-hours/1/code/${id}`;
      dispatchEvent(new Event("pagehide"));
      const kept = JSON.parse(localStorage.getItem(key) ?? "");
      localStorage.setItem(key, JSON.stringify({ ...kept, text: "// written meanwhile\n" }));
      dispatchEvent(new PageTransitionEvent("pageshow", { persisted: true }));
    }, segment);
    assert.equal(await exercise.text(), "// written meanwhile\n");
    await context.close();
  });

  test("an editor that does not load says so, and loads when it can", async () => {
    const context = await nothingKept({ serviceWorkers: "block" });
    const page = await context.newPage();
    let there = false;
    await page.route(/\/chunks\/editor-/, (route) =>
      there ? route.continue() : route.fulfill({ status: 404, body: "gone" }),
    );
    await page.goto(`${server.origin}/${pageOf(segment)}`, { waitUntil: "load" });
    const bench = page.locator(`contact-exercise[name="${segment}"]`);
    await bench.locator(".code pre").click();
    await bench.locator(".status", { hasText: "could not be loaded" }).waitFor();
    there = true;
    await page.reload();
    await bench.locator(".code pre").click();
    await bench.locator(".cm-content").waitFor();
    await context.close();
  });

  test("on a laptop the contract is beside the code on request, and stays there", async () => {
    const context = await nothingKept();
    const page = await context.newPage();
    await page.setViewportSize({ width: 1280, height: 900 });
    await page.goto(`${server.origin}/${pageOf(segment)}`, { waitUntil: "load" });
    const bench = page.locator(`contact-exercise[name="${segment}"]`);
    const beside = bench.getByRole("button", { name: "Contract beside the code" });
    const isBeside = async () => {
      const code = await bench.locator(".code").boundingBox();
      const contract = await bench.locator(".contract").boundingBox();
      assert.ok(code && contract);
      return contract.x >= code.x + code.width && contract.x + contract.width <= 1280;
    };
    await beside.scrollIntoViewIfNeeded();
    assert.equal(await isBeside(), false);
    const before = await beside.boundingBox();
    await beside.click();
    assert.equal(await isBeside(), true);
    const after = await beside.boundingBox();
    assert.ok(
      before && after && Math.abs(after.y - before.y) < 2,
      "what was looked at stays there",
    );
    await page.reload();
    assert.equal(await isBeside(), true);
    assert.equal(await beside.getAttribute("aria-pressed"), "true");
    await beside.click();
    assert.equal(await isBeside(), false);
    await context.close();
  });

  test("where the browser keeps nothing everything works, and the page says so", async () => {
    const context = await nothingKept();
    const page = await context.newPage();
    await page.addInitScript(() =>
      Object.defineProperty(globalThis, "localStorage", {
        get() {
          throw new DOMException("denied", "SecurityError");
        },
      }),
    );
    /** @type {string[]} the book's own scripts only: the theme's stumble over this as well */
    const trouble = [];
    page.on("pageerror", ({ stack = "", message }) => {
      if (stack.includes("/_static/contact/")) trouble.push(message);
    });
    await page.goto(`${server.origin}/${pageOf(segment)}`, { waitUntil: "load" });
    const exercise = exerciseOn(page, segment);
    await exercise.edit();
    await exercise.element
      .getByText(/browser keeps nothing/)
      .first()
      .waitFor();
    assert.equal(await exercise.submit(solutionOf(segment)), "passed");
    await exercise.press("Hint");
    await exercise.press("Reset");
    assert.equal(await exercise.text(), stubOf(segment));
    await exercise.press("Undo reset");
    assert.equal(await exercise.text(), solutionOf(segment));
    assert.deepEqual(trouble, []);
    await context.close();
  });
});
