// node page/web/weight.mjs [PAGE]... [--site build/site] [--limit KB]
//
// What a page of the book weighs, compressed, by kind: everything that Chromium asks for when the
// page is opened and read to its end, nothing pressed, and what the service worker itself is and asks
// for. Without PAGE: every lesson. Exit code 1 if a page is over the limit (none by default), 2 for
// wrong usage, a page that is not there, or no browser.

import fs from "node:fs";
import path from "node:path";
import { parseArgs } from "node:util";
import { gzipSync } from "node:zlib";

const kinds = {
  ".html": "HTML",
  ".css": "CSS",
  ".js": "JS",
  ".mjs": "JS",
  ".wasm": "WASM",
  ".woff2": "fonts",
  ".woff": "fonts",
  ".svg": "pictures",
  ".png": "pictures",
  ".json": "data",
};

/** What was compressed before: most pages ask for the same. @type {Map<string, number>} */
const sizes = new Map();

/** Compressed as a server would; fonts and bitmaps are so already. @param {string} file */
function compressed(file) {
  const known = sizes.get(file);
  if (known !== undefined) return known;
  const bytes = fs.readFileSync(file);
  const zipped = !/\.(woff2?|png)$/.test(file);
  const size = zipped ? gzipSync(bytes, { level: 9 }).length : bytes.length;
  sizes.set(file, size);
  return size;
}

const { values, positionals } = parseArgs({
  allowPositionals: true,
  options: { site: { type: "string" }, limit: { type: "string" } },
});
if (values.site) process.env.CONTACT_SITE = values.site;
const { launch, lessons, loadFigures, notRun, open, serve, site } = await import(
  "../../tests/browser/browser.mjs"
);
const why = notRun();
if (why) {
  console.error(why);
  process.exit(2);
}
const server = await serve();
const { browser, close } = await launch();

/** What a page asks for while it is read. @param {string} where */
async function asks(where) {
  const shown = await open(browser, "about:blank#");
  /** @type {Set<string>} */
  const asked = new Set(["/sw.js", "/offline.json"]);
  shown.page.on("request", (request) => {
    if (request.url().startsWith(server.origin)) asked.add(new URL(request.url()).pathname);
  });
  await shown.page.goto(`${server.origin}/${where}`);
  await loadFigures(shown.page);
  await shown.page.evaluate(async () => {
    // What comes into sight may load more.
    for (let y = 0; y < document.body.scrollHeight; y += innerHeight / 2) {
      scrollTo(0, y);
      await new Promise((done) => setTimeout(done, 50));
    }
  });
  await shown.page.waitForLoadState("networkidle");
  await shown.close();
  return asked;
}

/** @param {string} where @param {Set<string>} asked */
function tell(where, asked) {
  /** @type {Record<string, { files: number, bytes: number }>} */
  const sums = {};
  for (const pathname of asked) {
    // What is not built yet has no weight.
    if (pathname === "/building.json") continue;
    const file = path.join(site, decodeURIComponent(pathname));
    const kind = kinds[/** @type {keyof typeof kinds} */ (path.extname(file))] ?? "other";
    sums[kind] ??= { files: 0, bytes: 0 };
    sums[kind].files += 1;
    sums[kind].bytes += compressed(file);
  }
  const total = Object.values(sums).reduce((sum, { bytes }) => sum + bytes, 0);
  const kb = (/** @type {number} */ bytes) => `${(bytes / 1000).toFixed(1).padStart(7)} kB`;
  console.log(where);
  for (const [kind, { files, bytes }] of Object.entries(sums).sort(
    (p, q) => q[1].bytes - p[1].bytes,
  ))
    console.log(`  ${kind.padEnd(9)}${kb(bytes)}  ${files} ${files === 1 ? "file" : "files"}`);
  console.log(`  ${"together".padEnd(9)}${kb(total)} compressed`);
  if (values.limit && total > Number(values.limit) * 1000) {
    console.error(`${where} is over ${values.limit} kB`);
    process.exitCode = 1;
  }
}

// A few at a time, since reading is mostly waiting.
const together = 3;
const list = positionals.length > 0 ? positionals : lessons();
const missing = list.filter((where) => !fs.existsSync(path.join(site, where)));
if (missing.length > 0) {
  console.error(`${missing.join(", ")}: not in ${site}; a page is named as in ${lessons()[0]}`);
  await close();
  server.close();
  process.exit(2);
}
for (let i = 0; i < list.length; i += together) {
  const some = list.slice(i, i + together);
  const asked = await Promise.all(some.map(asks));
  for (const [k, where] of some.entries()) tell(where, /** @type {Set<string>} */ (asked[k]));
}
await close();
server.close();
