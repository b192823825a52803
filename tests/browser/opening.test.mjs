// The lesson with the scene player opens with a scene that moves, without a press and over a picture of the same size.

import assert from "node:assert/strict";
import fs from "node:fs";
import path from "node:path";
import { describe, test } from "node:test";
import { notRun, open, root, site } from "./browser.mjs";
import { inBrowser } from "./in_browser.mjs";

const skip = notRun();
const WHERE = "chapters/20_scenes.html";
const SCENE = path.join(root, "chapters", "20_scenes", "scenes", "billiards_break.json");

/** @typedef {import("playwright-core").Page} Page */

/** Waits until the opening is there. @param {Page} page */
async function opened(page) {
  const opening = page.locator("contact-player .opening");
  await opening.waitFor({ timeout: 60_000 });
  return opening;
}

/** The time and the hits that the page says. @param {Page} page */
async function clock(page) {
  const said = await page.locator("contact-player .opening .clock").textContent();
  const [, time = "", hits = ""] = /^t = (\S+) s, (\d+) hits?,/.exec(said ?? "") ?? [];
  assert.ok(time && hits, String(said));
  return { time: Number(time), hits: Number(hits) };
}

/** Waits until the page says a time after this one, s. @param {Page} page @param {number} time */
const after = (page, time) =>
  page.waitForFunction(
    (past) => {
      const said = document.querySelector("contact-player .opening .clock")?.textContent ?? "";
      return Number(/^t = (\S+) s/.exec(said)?.[1]) > past;
    },
    time,
    { timeout: 60_000 },
  );

/** Lets the browser draw so many pictures. @param {Page} page */
const pictures = (page, count = 20) =>
  page.evaluate(async (most) => {
    for (let i = 0; i < most; ++i) await new Promise(requestAnimationFrame);
  }, count);

/** What is on the canvas. @param {Page} page */
const drawn = (page) =>
  page.evaluate(() =>
    /** @type {HTMLCanvasElement} */ (
      document.querySelector("contact-player .opening canvas")
    ).toDataURL(),
  );

describe("the scene that the page opens with", { skip }, () => {
  const { server, chromium } = inBrowser();
  const shown = (options = {}) => open(chromium.browser, `${server.origin}/${WHERE}`, options);

  /** The page with another text or module of the opening. @param {string} file @param {string} body */
  async function instead(file, body) {
    server.answer = (pathname, response) => {
      if (path.basename(pathname) !== file) return false;
      response.end(body);
      return true;
    };
    // A worker would give what it has stored.
    const { page, trouble, close } = await shown({ serviceWorkers: "block" });
    const leave = async () => {
      server.answer = undefined;
      await close();
    };
    return { page, trouble, close: leave };
  }

  test("it moves without a press", async () => {
    const { page, trouble, close } = await shown();
    await opened(page);
    const first = await drawn(page);
    await after(page, 0.2);
    assert.ok((await clock(page)).hits > 0);
    assert.notEqual(await drawn(page), first);
    assert.deepEqual(trouble, []);
    await close();
  });

  test("it can be paused and goes on from there, by the keyboard", async () => {
    const { page, close } = await shown();
    const opening = await opened(page);
    await after(page, 0);
    await opening.getByRole("button", { name: "Pause" }).press("Enter");
    const still = await clock(page);
    const picture = await drawn(page);
    await pictures(page);
    assert.deepEqual(await clock(page), still);
    assert.equal(await drawn(page), picture);
    await opening.getByRole("button", { name: "Play", exact: true }).press("Enter");
    await after(page, still.time);
    await close();
  });

  for (const width of [1200, 360])
    test(`it has the size of the picture that it covers, ${width} pixels wide`, async () => {
      const { page, close } = await shown({ viewport: { width, height: 740 } });
      const opening = await opened(page);
      const box = await page.locator("contact-player > img").boundingBox();
      for (const part of [opening, opening.locator("canvas")]) {
        const own = await part.boundingBox();
        for (const key of /** @type {const} */ (["x", "y", "width", "height"]))
          assert.ok(
            Math.abs((own?.[key] ?? NaN) - (box?.[key] ?? NaN)) < 1,
            `${key} of ${own?.[key]}`,
          );
      }
      const buttons = await opening.locator(".buttons").boundingBox();
      assert.ok(buttons && box && buttons.width <= box.width, `${buttons?.width} pixels`);
      assert.equal(
        await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth),
        true,
      );
      await close();
    });

  test("it stays still for a reader who wants less motion, until it is started", async () => {
    const { page, close } = await shown({ reducedMotion: "reduce" });
    const opening = await opened(page);
    await pictures(page);
    assert.deepEqual(await clock(page), { time: 0, hits: 0 });
    await opening.getByRole("button", { name: "Play", exact: true }).press("Enter");
    await after(page, 0);
    await page.emulateMedia({ reducedMotion: "no-preference" });
    await page.emulateMedia({ reducedMotion: "reduce" });
    await opening.getByRole("button", { name: "Play", exact: true }).waitFor();
    await close();
  });

  test("it stops out of sight, and goes on when it is back", async () => {
    const { page, close } = await shown();
    const opening = await opened(page);
    await after(page, 0);
    await page.evaluate(() => scrollTo(0, document.body.scrollHeight));
    await pictures(page, 5);
    const away = await clock(page);
    await pictures(page);
    assert.deepEqual(await clock(page), away);
    await opening.scrollIntoViewIfNeeded();
    await after(page, away.time);
    await close();
  });

  test("it ends, and plays again from the start", async () => {
    const scene = JSON.parse(fs.readFileSync(SCENE, "utf8"));
    const short = JSON.stringify({ ...scene, duration: 0.03, expect: [] });
    const { page, trouble, close } = await instead("billiards_break.json", short);
    const again = (await opened(page)).getByRole("button", { name: "Play again" });
    await again.waitFor({ timeout: 60_000 });
    assert.deepEqual(await clock(page), { time: 0.03, hits: 0 });
    await again.press("Enter");
    await page.getByRole("button", { name: "Pause" }).waitFor();
    assert.ok((await clock(page)).time < 0.03);
    assert.deepEqual(trouble, []);
    await close();
  });

  test("it waits until it is built, and then appears without a picture behind it", async () => {
    const built = fs.readFileSync(path.join(site, WHERE), "utf8");
    const html = built.replace(
      /(<contact-player[^>]*>.*?)<img[^>]*>/s,
      '$1<p class="not-built">The scene player is still being built.</p>',
    );
    assert.notEqual(html, built);
    let waiting = ["another", "20_scenes/scene_player"];
    const { page, trouble, close } = await shown({ serviceWorkers: "block" });
    await page.route("**/building.json*", (route) =>
      route.fulfill({ json: { waiting, building: [] } }),
    );
    server.answer = (pathname, response) => {
      if (pathname !== `/${WHERE}`) return false;
      response.end(html);
      return true;
    };
    await page.reload();
    server.answer = undefined;
    await page.getByText("This is not built yet: one other is before it.").waitFor();
    assert.equal(await page.locator("contact-player .opening").count(), 0);
    waiting = [];
    const opening = await opened(page);
    await after(page, 0);
    assert.equal(await page.locator("contact-player .not-built").isVisible(), false);
    const box = await opening.boundingBox();
    assert.ok(box && Math.abs(box.width / box.height - 1.5) < 0.01, JSON.stringify(box));
    assert.deepEqual(trouble, []);
    await close();
  });

  test("the player replaces it, with the same scene", async () => {
    const { page, trouble, close } = await shown();
    const opening = await opened(page);
    const player = page.locator("contact-player");
    await player.getByRole("button", { name: "Start the scene player" }).press("Enter");
    await player.locator(".plan tbody tr").first().waitFor({ timeout: 60_000 });
    assert.equal(await player.getByLabel("Scene", { exact: true }).inputValue(), "billiards_break");
    assert.equal(await opening.count(), 0);
    assert.deepEqual(trouble, []);
    await close();
  });

  /** @type {[string, string, string][]} */
  const broken = [
    ["its C++ is broken", "opening.wasm", "no module"],
    ["its scene is of another kind", "billiards_break.json", '{ "format": "contact-scene/1" }'],
  ];
  for (const [why, file, body] of broken)
    test(`the picture stays if ${why}, and nothing is an error`, async () => {
      const { page, trouble, close } = await instead(file, body);
      const said = await page.locator("contact-player").evaluate(async (player) => {
        while (!(/** @type {any} */ (player).opening)) await new Promise(requestAnimationFrame);
        return /** @type {any} */ (player).opening.then(
          () => "shown",
          () => "refused",
        );
      });
      assert.equal(said, "refused");
      assert.equal(await page.locator("contact-player .opening").count(), 0);
      const picture = page.locator("contact-player > img");
      assert.ok(await picture.isVisible());
      assert.equal(await picture.getAttribute("aria-hidden"), null);
      assert.deepEqual(trouble, []);
      await close();
    });
});
