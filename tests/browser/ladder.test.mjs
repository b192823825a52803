// "Run it here": the chapter's ladder, timed as WebAssembly in the reader's browser. Every third one is run and
// stopped, others in each turn. (What each computes: page/wasm/loader.test.mjs.)

import assert from "node:assert/strict";
import { describe, test } from "node:test";
import { chapterOf, lessons, notRun, open } from "./browser.mjs";
import { inBrowser } from "./in_browser.mjs";
import { chaptersTaken } from "./sample.mjs";

const skip = notRun();

describe("ladders", { skip }, () => {
  const { server, chromium } = inBrowser();

  const taken = chaptersTaken("ladder", "chapters whose ladder runs in the page");
  const all = skip ? [] : lessons().filter((page) => taken.includes(chapterOf(page)));
  for (const where of all) {
    test(`${where}: run here`, { timeout: 60_000 }, async () => {
      const { page, trouble, close } = await open(chromium.browser, `${server.origin}/${where}`);
      const ladder = page.locator("contact-ladder").first();
      const data = JSON.parse((await ladder.locator(":scope > script").textContent()) ?? "");
      const before = await ladder.locator(".plot").innerHTML();
      await ladder.getByRole("button", { name: "Run it here" }).click();
      const status = ladder.locator(".status").filter({ hasText: /timed in|could not/ });
      await status.waitFor({ timeout: 50_000 });
      assert.match((await status.textContent()) ?? "", /timed in/);
      const rows = await ladder.evaluate((/** @type {any} */ element) => element.rows);
      const here = data.methods.filter(
        // GMP's rational numbers are not in the page.
        (/** @type {any} */ { scalar }) => scalar !== "rational",
      );
      assert.equal(rows.length, data.families.length * here.length);
      for (const row of rows) {
        assert.ok(row.ns_median > 0 && row.ns_q1 <= row.ns_median && row.ns_median <= row.ns_q3);
        const method = data.methods.find((/** @type {any} */ each) => each.id === row.method);
        assert.ok(method, row.method);
        if (method.exact) assert.equal(row.wrong, 0, row.method);
      }
      assert.equal(await ladder.locator(".here tbody tr").count(), rows.length);
      await page.waitForFunction(
        (old) => document.querySelector("contact-ladder .plot")?.innerHTML !== old,
        before,
      );
      assert.deepEqual(trouble, []);
      await close();
    });

    test(`${where}: cancelled`, async () => {
      const { page, close } = await open(chromium.browser, `${server.origin}/${where}`);
      const ladder = page.locator("contact-ladder").first();
      await ladder.getByRole("button", { name: "Run it here" }).click();
      await ladder.getByRole("button", { name: "Cancel" }).click();
      await ladder.getByText("Stopped.").waitFor();
      assert.ok(await ladder.getByRole("button", { name: "Run it here" }).isVisible());
      await close();
    });
  }
});
