// Opens pages from files, in both colour modes, wide and as narrow as a phone, and prints what is
// wrong with each as JSON: what axe finds, what runs over the edge, what is fetched, what is said
// on the console. Prints "no browser" if there is none.

import fs from "node:fs";
import { pathToFileURL } from "node:url";
import { findBrowser, launch, require } from "../browser/browser.mjs";

if (!findBrowser()) {
  console.log("no browser");
  process.exit(0);
}
const axe = fs.readFileSync(require.resolve("axe-core/axe.min.js"), "utf8");
const { browser, close } = await launch();
/** @type {Record<string, string[]>} */
const wrong = {};
for (const file of process.argv.slice(2)) {
  wrong[file] = [];
  for (const colorScheme of /** @type {const} */ (["light", "dark"]))
    for (const width of [1200, 390]) {
      // axe is injected into the page, which the page's own policy forbids.
      const context = await browser.newContext({
        viewport: { width, height: 900 },
        colorScheme,
        bypassCSP: true,
      });
      const page = await context.newPage();
      const say = (/** @type {string} */ what) =>
        wrong[file].push(`${colorScheme}, ${width}: ${what}`);
      page.on("console", (message) => say(`console: ${message.text()}`));
      page.on("request", (request) => {
        if (request.url() !== pathToFileURL(file).href) say(`fetches ${request.url()}`);
      });
      await page.goto(pathToFileURL(file).href);
      const over = await page.evaluate(
        () => document.documentElement.scrollWidth - document.documentElement.clientWidth,
      );
      if (over > 0) say(`runs ${over} pixels over the edge`);
      await page.evaluate(axe);
      const found = await page.evaluate(() => /** @type {any} */ (globalThis).axe.run());
      for (const { id, nodes } of found.violations) say(`${id}: ${nodes[0].target}`);
      await context.close();
    }
}
await close();
console.log(JSON.stringify(wrong));
