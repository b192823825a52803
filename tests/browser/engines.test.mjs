// "Ask the engines" in a browser: nothing is loaded before a button is pressed, then all engines answer.

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import fs from "node:fs";
import path from "node:path";
import { describe, test } from "node:test";
import { notRun, open, require, root, site } from "./browser.mjs";
import { inBrowser } from "./in_browser.mjs";

const PAGE = "ask_the_engines.html";
const LIMIT = 300;
const built = ["scenes/player.wasm", "engines/queries.wasm"].every((name) =>
  fs.existsSync(path.join(site, "_static", "contact", name)),
);
const skip = notRun() || (built ? false : "not run: the book's modules are not built in this turn");

describe("ask the engines", { skip }, () => {
  const { server, chromium } = inBrowser();

  test("no engine is loaded before it is asked", async () => {
    const { page, trouble, close } = await open(chromium.browser, `${server.origin}/${PAGE}`);
    /** @type {string[]} */
    const requests = [];
    page.on("request", (/** @type {any} */ request) => requests.push(request.url()));
    await page.reload();
    await page.evaluate(() => scrollTo(0, document.body.scrollHeight));
    await page.waitForLoadState("networkidle");
    assert.deepEqual(
      requests.filter((url) => /worker|wasm|rapier|jolt|cannon|box2d|planck|matter/.test(url)),
      [],
    );
    assert.deepEqual(trouble, []);
    await close();
  });

  test("all engines answer where they are asked, with the reader's step", async () => {
    const { page, trouble, close } = await open(chromium.browser, `${server.origin}/${PAGE}`);
    await page.getByLabel("Step").fill("0.001");
    await page.locator("#ask-free-fall").getByRole("button").click();
    await page.waitForFunction(
      () => document.querySelector("contact-engines .status")?.textContent === "All have answered.",
    );
    for (const id of [
      "book",
      "rapier3d",
      "jolt",
      "cannon",
      "rapier2d",
      "box2d",
      "planck",
      "matter",
    ]) {
      const cells = page.locator(`#ask-free-fall tr[data-engine="${id}"] td.here`);
      const value = Number(await cells.first().textContent());
      // By half a step or less: 10 m/s² for 1 s, and a step of 1 ms.
      assert.ok(Math.abs(value - 15) < 0.0051, `${id}: ${value}`);
    }
    assert.equal(
      await page.locator('#ask-free-fall tr[data-engine="bvh"] td.here').textContent(),
      "–",
    );
    assert.deepEqual(trouble, []);
    await close();
  });

  test("what is asked can be stopped, and asked again", async () => {
    const { page, close } = await open(chromium.browser, `${server.origin}/${PAGE}`);
    await page.getByRole("button", { name: "Ask all questions here" }).click();
    await page.getByRole("button", { name: "Stop" }).click();
    await page.locator("#ask-far-ball").getByRole("button").click();
    await page.waitForFunction(
      () => document.querySelector("contact-engines .status")?.textContent === "All have answered.",
    );
    const book = page.locator('#ask-far-ball tr[data-engine="book"] td.here').first();
    assert.equal(await book.textContent(), "9999.72");
    await close();
  });

  test("axe finds nothing", async () => {
    const { page, close } = await open(chromium.browser, `${server.origin}/${PAGE}`);
    await page.addScriptTag({ path: require.resolve("axe-core/axe.min.js") });
    const found = await page.evaluate(async () => {
      const { violations } = await /** @type {any} */ (globalThis).axe.run(document, {
        resultTypes: ["violations"],
      });
      return violations.map((/** @type {any} */ rule) => [rule.id, rule.nodes[0]?.html]);
    });
    assert.deepEqual(found, []);
    await close();
  });

  test(`the page is not over ${LIMIT} kB before anything is pressed`, () => {
    const weigh = path.join(root, "page", "web", "weight.mjs");
    const { status, stdout, stderr } = spawnSync(
      process.execPath,
      [weigh, PAGE, "--site", site, "--limit", String(LIMIT)],
      { encoding: "utf8" },
    );
    console.log(stdout.trim());
    assert.equal(status, 0, stderr);
  });
});
