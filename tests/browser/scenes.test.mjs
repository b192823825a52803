// The scene player: the reference C++ in the reader's browser, by the keyboard alone.

import assert from "node:assert/strict";
import fs from "node:fs";
import path from "node:path";
import { describe, test } from "node:test";
import { notRun, open, require, root } from "./browser.mjs";
import { inBrowser } from "./in_browser.mjs";

const skip = notRun();
const WHERE = "kitchen_sink.html";

/** @typedef {import("playwright-core").Page} Page */
/** @typedef {import("playwright-core").Locator} Locator */

/** The keyboard goes to it and presses. @param {Locator} what @param {string} key */
async function press(what, key = "Enter") {
  await what.focus();
  await what.press(key);
}

/** Starts the player of a page. @param {Page} page @returns {Promise<Locator>} */
async function started(page) {
  const player = page.locator("contact-player").first();
  await press(player.getByRole("button", { name: "Start the scene player" }));
  await player.locator(".plan tbody tr").first().waitFor({ timeout: 60_000 });
  return player;
}

/** Picks a scene and waits until it is planned. @param {Locator} player @param {string} name */
async function pick(player, name) {
  await player.getByLabel("Scene", { exact: true }).selectOption(name);
  await player.page().waitForFunction(
    (wanted) => {
      const element = /** @type {any} */ (document.querySelector("contact-player"));
      return element.model?.opened?.scene.name === wanted && element.model.frames.length > 0;
    },
    name,
    { timeout: 60_000 },
  );
}

/** The rows "At this moment", by name. @param {Locator} player */
const numbers = (player) =>
  player
    .locator(".computed tbody tr")
    .evaluateAll((rows) =>
      Object.fromEntries(
        rows.map((row) => [
          row.querySelector("th")?.textContent,
          [...row.querySelectorAll("td")].map((cell) => cell.textContent),
        ]),
      ),
    );

/** One step of the clock by the keyboard; the time after it. @param {Locator} player */
async function step(player) {
  const clock = player.locator(".clock");
  const before = await clock.textContent();
  await press(player.getByRole("button", { name: "One step" }));
  await player
    .page()
    .waitForFunction(
      (old) => document.querySelector("contact-player .clock")?.textContent !== old,
      before,
      { timeout: 60_000 },
    );
  return Number(/t = (\S+) s/.exec((await clock.textContent()) ?? "")?.[1]);
}

describe("the scene player", { skip }, () => {
  const { server, chromium } = inBrowser();
  const shown = (options = {}) => open(chromium.browser, `${server.origin}/${WHERE}`, options);

  test("nothing of it but its opening is loaded before it is started", async () => {
    const { page, close } = await shown();
    await page.locator("contact-player").scrollIntoViewIfNeeded();
    await page.locator("contact-player .opening").waitFor({ timeout: 60_000 });
    await page.waitForLoadState("networkidle");
    const asked = server.asked.filter((file) => /\/scenes\/|scenes-worker|player-/.test(file));
    assert.deepEqual([...new Set(asked)].map((file) => path.basename(file)).sort(), [
      "billiards_break.json",
      "first.svg",
      "opening.wasm",
    ]);
    assert.ok(await page.locator("contact-player > img").isVisible());
    await close();
  });

  test("a scene is picked, planned and run; an effect off shows its error", async () => {
    const { page, trouble, close } = await shown();
    const player = await started(page);
    const names = fs
      .readdirSync(path.join(root, "chapters", "20_scenes", "scenes"))
      .map((file) => path.basename(file, ".json"));
    const offered = await player
      .getByLabel("Scene", { exact: true })
      .locator("option")
      .evaluateAll((options) => options.map((each) => /** @type {any} */ (each).value));
    assert.deepEqual(offered.slice(0, -1), names.sort());

    await pick(player, "high_drop");
    const gravity = player.getByRole("switch", { name: "gravity, in the second run" });
    assert.ok(await gravity.isChecked());
    const row = player.locator(".plan tbody tr").first();
    assert.match((await row.textContent()) ?? "", /gravity on.*gravity is \d+ m\/s²/s);
    assert.ok((await step(player)) > 0);
    const one = await numbers(player);
    assert.equal(one["hits"].length, 1);

    // Off, by the space bar: a second run, from the start, that does not fall.
    await press(gravity, " ");
    await page.waitForFunction(
      () => /** @type {any} */ (document.querySelector("contact-player")).model.frames.length === 2,
    );
    assert.equal(
      await page.evaluate(() => document.activeElement?.getAttribute("data-effect")),
      "gravity",
      "the focus stays where the reader put it",
    );
    const at = await step(player);
    const two = await numbers(player);
    assert.equal(two["hits"].length, 2);
    assert.notEqual(two["energy"][0], two["energy"][1]);
    const apart = (await player.locator(".apart").textContent()) ?? "";
    assert.match(apart, /m apart at most \(\w+\), more than the tolerance/);
    const fallen = await player.evaluate(
      (/** @type {any} */ element) => element.model.frames[1].apart,
    );
    const g = await player.evaluate((/** @type {any} */ element) =>
      Math.abs(element.model.opened.scene.gravity[2]),
    );
    if (at < 1.4) assert.ok(Math.abs(fallen - (g * at * at) / 2) < 1e-3 * fallen, `${fallen}`);

    // And on again: one run.
    await press(gravity, " ");
    await page.waitForFunction(
      () => /** @type {any} */ (document.querySelector("contact-player")).model.frames.length === 1,
    );
    assert.equal(await player.locator(".apart").textContent(), "");
    assert.deepEqual(trouble, []);
    await close();
  });

  test("a broken text is reported with its path; a valid one runs", async () => {
    const { page, trouble, close } = await shown();
    const player = await started(page);
    await pick(player, "head_on");
    await press(player.locator(".own > summary"));
    const field = player.getByLabel("Scene, as JSON");
    const good = await field.inputValue();
    await field.fill(good.replace('"mass": ', '"mass": -'));
    await press(player.getByRole("button", { name: "Run this text" }));
    const wrong = player.getByRole("alert");
    await wrong.filter({ hasText: /bodies\[\d\]\.mass = -.*must be/ }).waitFor();
    assert.match((await wrong.textContent()) ?? "", /^your scene:\d+: /);

    await field.fill(good.replace('"name": "head_on"', '"name": "mine"'));
    await press(player.getByRole("button", { name: "Run this text" }));
    await page.waitForFunction(
      () =>
        /** @type {any} */ (document.querySelector("contact-player")).model.opened?.scene.name ===
        "mine",
    );
    assert.equal(await wrong.isVisible(), false);
    const before = await step(player);
    assert.ok((await step(player)) > before);
    assert.deepEqual(trouble, []);
    await close();
  });

  test("more bodies than a page draws are refused, and what was there goes on", async () => {
    const { page, trouble, close } = await shown();
    const player = await started(page);
    await pick(player, "head_on");
    const before = await step(player);
    await press(player.locator(".own > summary"));
    const field = player.getByLabel("Scene, as JSON");
    const scene = JSON.parse(await field.inputValue());
    const [body] = scene.bodies;
    const standing = { name: "b", shape: body.shape, material: body.material, moves: false };
    const repeat = { count: [20_001, 1, 1], spacing: [100, 0, 0] };
    const many = { ...scene, expect: [], bodies: [{ ...standing, position: [0, 0, 0], repeat }] };
    await field.fill(JSON.stringify(many));
    await press(player.getByRole("button", { name: "Run this text" }));
    await player
      .getByRole("alert")
      .filter({ hasText: /your scene: bodies: there are 20001, and the page draws at most/ })
      .waitFor({ timeout: 60_000 });
    assert.ok((await step(player)) > before);
    assert.deepEqual(trouble, []);
    await close();
  });

  test("it plays by itself and the page stays usable", async () => {
    const { page, trouble, close } = await shown();
    const player = await started(page);
    await pick(player, "gas_in_a_box");
    await press(player.getByRole("button", { name: "Play", exact: true }));
    const longest = await page.evaluate(async () => {
      let most = 0;
      for (let last = performance.now(), n = 0; n < 30; ++n) {
        await new Promise((done) => setTimeout(done, 10));
        most = Math.max(most, performance.now() - last);
        last = performance.now();
      }
      return most;
    });
    assert.ok(longest < 1000, `${longest} ms without a turn for the page`);
    await page.waitForFunction(
      () => /** @type {any} */ (document.querySelector("contact-player")).model.time > 0,
      undefined,
      { timeout: 60_000 },
    );
    await press(player.getByRole("button", { name: "Pause" }));
    assert.deepEqual(trouble, []);
    await close();
  });

  for (const colorScheme of /** @type {const} */ (["light", "dark"]))
    test(`started, axe finds nothing, ${colorScheme}`, async () => {
      const { page, close } = await shown({ colorScheme, reducedMotion: "reduce" });
      const player = await started(page);
      await player.locator(".own > summary").click();
      await page.addScriptTag({ path: require.resolve("axe-core/axe.min.js") });
      const found = await page.evaluate(async () => {
        const { violations } = await /** @type {any} */ (globalThis).axe.run("contact-player");
        return violations.map(
          (/** @type {any} */ rule) =>
            `${rule.id}: ${rule.nodes.map((/** @type {any} */ node) => `${node.target} ${node.failureSummary}`).join("; ")}`,
        );
      });
      assert.deepEqual(found, []);
      const ink = await page.evaluate(() => {
        const canvas = /** @type {HTMLCanvasElement} */ (
          document.querySelector("contact-player canvas")
        );
        const { data } = /** @type {CanvasRenderingContext2D} */ (
          canvas.getContext("2d")
        ).getImageData(0, 0, canvas.width, canvas.height);
        return data.some((byte) => byte > 0);
      });
      assert.ok(ink, "something is drawn");
      await close();
    });

  test("started, nothing sticks out on a phone, and paper has the picture alone", async () => {
    const { page, close } = await shown({
      viewport: { width: 390, height: 740 },
      isMobile: true,
      hasTouch: true,
    });
    const player = await started(page);
    const width = await page.evaluate(() => document.documentElement.scrollWidth);
    assert.ok(width <= 390, `${width} pixels wide`);
    await page.emulateMedia({ media: "print" });
    assert.ok(await player.locator(":scope > img").isVisible());
    assert.equal(await player.locator(".live-parts").isVisible(), false);
    await close();
  });

  test("without a script there is the picture, and how else to run the scenes", async () => {
    const { page, close } = await shown({ javaScriptEnabled: false });
    const picture = page.locator("contact-player > img");
    await picture.scrollIntoViewIfNeeded();
    assert.ok(await picture.isVisible());
    assert.match((await picture.getAttribute("alt")) ?? "", /hits/);
    const words = await page.locator("contact-player noscript").textContent();
    assert.match(words ?? "", /contact simulate/);
    await close();
  });
});
