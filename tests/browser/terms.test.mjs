// Looking things up: what a linked term shows, where the search leads, the glossary and the index; and boxes that are
// closed at first.

import assert from "node:assert/strict";
import fs from "node:fs";
import path from "node:path";
import { describe } from "node:test";
import { notRun, open, require, site } from "./browser.mjs";
import { inBrowser } from "./in_browser.mjs";
import { ofAll } from "./sample.mjs";

const skip = notRun();
const sink = "kitchen_sink.html";

const WANTED = [
  "orientation predicate",
  "floating-point filter",
  "conflict list",
  "effective mass",
  "reduced mass",
  "line of impact",
  "impulsive force",
  "torque",
  "symplectic Euler",
  "Verlet",
  "conservative advancement",
  "tangential restitution",
  "unit roundoff",
  "support function",
  "Minkowski difference",
];

describe("terms", { skip }, () => {
  const { server, chromium } = inBrowser();
  const url = (/** @type {string} */ where) => `${server.origin}/${where}`;
  const term = "article a:has(> .std-term)";

  for (const name of WANTED)
    ofAll(`searching for ${name} leads to the place that teaches it`, async () => {
      const { page, trouble, close } = await open(
        chromium.browser,
        url(`search.html?q=${encodeURIComponent(name)}`),
      );
      const summary = page.locator("#search-results li").first().locator("p.context");
      assert.ok(((await summary.textContent()) ?? "").toLowerCase().includes(name.toLowerCase()));
      assert.deepEqual(trouble, []);
      const first = page.locator("#search-results li a").first();
      const href = (await first.getAttribute("href")) ?? "";
      const place = new URL(href, page.url());
      assert.match(place.hash, /^#(term|index)-/, href);
      await page.goto(place.href);
      const words = await page.evaluate((/** @type {string} */ id) => {
        const target = document.getElementById(id);
        return target?.closest("p, li, dd, dt, figcaption, td, details")?.textContent ?? "";
      }, place.hash.slice(1));
      assert.ok(words.toLowerCase().includes(name.toLowerCase()), `${href}: ${words}`);
      if (place.pathname.endsWith("/glossary.html")) {
        const definition = page.locator(`dt[id="${place.hash.slice(1)}"] ~ dd`).first();
        assert.match((await definition.textContent()) ?? "", /will come/);
        assert.ok((await definition.locator("a").count()) > 0);
      }
      await close();
    });

  ofAll("pointing at a term shows its definition, which can be reached and dismissed", async () => {
    const { page, trouble, close } = await open(chromium.browser, url(sink));
    const link = page.locator(term).first();
    await link.hover();
    const shown = page.locator(".term-shown");
    await shown.waitFor();
    assert.match((await shown.textContent()) ?? "", /relative velocity.*Also: generalized mass/s);
    assert.equal(await link.getAttribute("aria-describedby"), "term-shown");
    await shown.locator("a").last().hover();
    await page.waitForTimeout(400);
    assert.ok(await shown.isVisible());
    await page.keyboard.press("Escape");
    assert.equal(await shown.count(), 0);
    assert.equal(await link.getAttribute("aria-describedby"), null);
    await link.hover({ position: { x: 2, y: 2 } });
    await page.mouse.move(0, 0);
    await page.waitForTimeout(500);
    assert.equal(await shown.count(), 0);
    assert.deepEqual(trouble, []);
    await close();
  });

  ofAll("a term that the keyboard reaches shows its definition, and Enter goes there", async () => {
    const { page, close } = await open(chromium.browser, url(sink));
    const link = page.locator(term).nth(1);
    await page.locator(term).first().focus();
    await page.keyboard.press("Tab");
    assert.ok(await link.evaluate((node) => node === document.activeElement));
    const shown = page.locator(".term-shown");
    await shown.waitFor();
    assert.match((await shown.textContent()) ?? "", /lever arm/);
    await page.keyboard.press("Enter");
    await page.waitForURL(/glossary\.html#term-moment-arm$/);
    await close();
  });

  for (const colorScheme of /** @type {const} */ (["light", "dark"]))
    ofAll(`a tap shows a definition with a link to its entry, ${colorScheme}`, async () => {
      const { page, close } = await open(chromium.browser, url(sink), {
        viewport: { width: 360, height: 740 },
        isMobile: true,
        hasTouch: true,
        colorScheme,
        reducedMotion: "reduce",
      });
      const link = page.locator(term).nth(1);
      await link.tap();
      const shown = page.locator(".term-shown");
      await shown.waitFor();
      assert.match(page.url(), /kitchen_sink\.html$/);
      assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= 360);
      const box = await shown.boundingBox();
      assert.ok(box && box.x >= 0 && box.x + box.width <= 360, JSON.stringify(box));
      await page.addScriptTag({ path: require.resolve("axe-core/axe.min.js") });
      const found = await page.evaluate(async () => {
        const { violations } = await /** @type {any} */ (globalThis).axe.run(".term-shown");
        return violations.map((/** @type {any} */ rule) => rule.id);
      });
      assert.deepEqual(found, []);
      await shown.locator(".entry a").tap();
      await page.waitForURL(/glossary\.html#term-/);
      await close();
    });

  const lookUp = skip
    ? []
    : [
        "glossary.html",
        "genindex.html",
        ...(fs.existsSync(path.join(site, "lectures"))
          ? fs.readdirSync(path.join(site, "lectures")).map((name) => `lectures/${name}`)
          : []),
      ];
  for (const where of lookUp)
    for (const colorScheme of /** @type {const} */ (["light", "dark"]))
      ofAll(`${where}: axe finds nothing and a phone is wide enough, ${colorScheme}`, async () => {
        const { page, trouble, close } = await open(chromium.browser, url(where), {
          viewport: { width: 360, height: 740 },
          isMobile: true,
          colorScheme,
          reducedMotion: "reduce",
        });
        assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= 360);
        await page.addScriptTag({ path: require.resolve("axe-core/axe.min.js") });
        const found = await page.evaluate(async () => {
          const { violations } = await /** @type {any} */ (globalThis).axe.run(document);
          return violations.map(
            (/** @type {any} */ rule) =>
              `${rule.id}: ${rule.nodes[0].target} ${rule.nodes[0].failureSummary}`,
          );
        });
        assert.deepEqual(found, []);
        assert.deepEqual(trouble, []);
        await close();
      });
});

describe("boxes", { skip }, () => {
  const { server, chromium } = inBrowser();
  const url = (/** @type {string} */ where) => `${server.origin}/${where}`;
  const box = "details.deeper";
  const isOpen = (/** @type {import("playwright-core").Page} */ page) =>
    page.locator(box).evaluate((node) => /** @type {HTMLDetailsElement} */ (node).open);

  ofAll("a box is closed at first, and opened from the keyboard without a script", async () => {
    const { page, close } = await open(chromium.browser, url(sink), {
      javaScriptEnabled: false,
      boxes: "closed",
    });
    const inside = page.locator(`${box} .inside`);
    assert.equal(await inside.isVisible(), false);
    await page.locator(`${box} > summary`).focus();
    await page.keyboard.press("Enter");
    assert.ok(await inside.isVisible());
    await close();
  });

  ofAll("an address inside opens the box, on the page and on the way to it", async () => {
    const inside = "#question-blended-temperature";
    const { page, close } = await open(chromium.browser, url(sink + inside), { boxes: "closed" });
    assert.ok(await isOpen(page));
    await page.locator(`${box} > summary`).click();
    assert.equal(await isOpen(page), false);
    await page.goto(url(sink));
    assert.equal(await isOpen(page), false);
    await page.evaluate((hash) => {
      location.hash = hash;
    }, inside);
    await page.waitForFunction((of) => document.querySelector(of)?.matches("[open]"), box);
    await close();
  });

  ofAll("a search opens the box in which it marks a word", async () => {
    const { page, close } = await open(chromium.browser, url(`${sink}?highlight=listing`), {
      boxes: "closed",
    });
    await page.waitForFunction((of) => document.querySelector(of)?.matches("[open]"), box);
    await close();
  });

  ofAll("on paper a box is open, with a script and without", async () => {
    const { page, close } = await open(chromium.browser, url(sink), { boxes: "closed" });
    await page.evaluate(() => dispatchEvent(new Event("beforeprint")));
    assert.ok(await isOpen(page));
    await page.evaluate(() => dispatchEvent(new Event("afterprint")));
    assert.equal(await isOpen(page), false);
    await close();
    const paper = await open(chromium.browser, url(sink), {
      javaScriptEnabled: false,
      boxes: "closed",
    });
    await paper.page.emulateMedia({ media: "print" });
    const inside = paper.page.locator(`${box} .inside`);
    assert.ok(await inside.evaluate((node) => node.checkVisibility() && node.clientHeight > 50));
    await paper.close();
  });
});
