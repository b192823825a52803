// A browser for the tests, if there is one, and a small server for the built pages.

import { spawnSync } from "node:child_process";
import fs from "node:fs";
import http from "node:http";
import { createRequire } from "node:module";
import os from "node:os";
import path from "node:path";
import { fileURLToPath } from "node:url";

export const root = path.dirname(path.dirname(path.dirname(fileURLToPath(import.meta.url))));
export const site = process.env.CONTACT_SITE ?? path.join(root, "build", "site");
/** Packages live with the page's sources. */
export const require = createRequire(path.join(root, "page", "package.json"));

/** The browser to use: $CHROMIUM, or the first of the usual names; undefined if there is none. */
export function findBrowser() {
  if (process.env.CHROMIUM) return process.env.CHROMIUM;
  for (const name of ["chromium", "chromium-browser", "google-chrome-stable", "google-chrome"]) {
    const { status, stdout } = spawnSync("sh", ["-c", `command -v ${name}`], { encoding: "utf8" });
    // Ubuntu's chromium is a snap, which cannot be started from a test.
    if (status === 0 && !fs.realpathSync(stdout.trim()).includes("snap")) return stdout.trim();
  }
  return undefined;
}

/** Why the tests of the page are not run here, or false if they are: for node:test's `skip`. */
export function notRun() {
  return findBrowser() ? false : "not run: no Chromium found (set CHROMIUM to one)";
}

/** The built pages with components: home, every lesson, and the page with one of everything. */
export function pages() {
  if (!fs.existsSync(path.join(site, "index.html")))
    throw new Error(`the book is not built in ${site}: run ./contact serve or docs/build.py`);
  const lessons = fs
    .readdirSync(path.join(site, "chapters"))
    .filter((name) => name.endsWith(".html"))
    .sort()
    .map((name) => `chapters/${name}`);
  return ["index.html", "kitchen_sink.html", ...lessons];
}

export const lessons = () => pages().filter((page) => page.startsWith("chapters/"));

/** The chapter of a lesson's page. @param {string} page */
export const chapterOf = (page) => path.basename(page, ".html");

/** The figures of a page, in order, and whether this run has built them: then the page has their picture. @param {string} page */
export function figuresOn(page) {
  const html = fs.readFileSync(path.join(site, page), "utf8");
  return [...html.matchAll(/<contact-figure name="([^"]+)"[^>]*>\s*<(\w+)/g)].map(
    ([, name = "", inside]) => ({ name, built: inside === "img" }),
  );
}

/** The lessons whose figures are all built: all of them, or those of the turn. */
export const completeLessons = () =>
  lessons().filter((page) => figuresOn(page).every(({ built }) => built));

/** Whether the site has this of what the pages run. @param {string} file */
const isBuilt = (file) => fs.existsSync(path.join(site, "_static", "contact", file));

/** What the pages show or run and this run has not built, by the names that they ask for at building.json. */
function notBuilt() {
  const figures = pages()
    .flatMap(figuresOn)
    .filter(({ built }) => !built);
  const ladders = lessons().map(chapterOf);
  return [
    ...new Set(figures.map(({ name }) => name)),
    ...ladders.filter((slug) => !isBuilt(`ladders/${slug}.wasm`)).map((slug) => `ladder ${slug}`),
    ...(["player", "opening"].every((name) => isBuilt(`scenes/${name}.wasm`))
      ? []
      : ["20_scenes/scene_player"]),
  ];
}

const types = {
  ".html": "text/html; charset=utf-8",
  ".js": "text/javascript",
  ".mjs": "text/javascript",
  ".css": "text/css",
  ".json": "application/json",
  ".svg": "image/svg+xml",
  ".wasm": "application/wasm",
  ".woff2": "font/woff2",
  ".png": "image/png",
  ".txt": "text/plain; charset=utf-8",
  ".gz": "application/gzip",
};

/** @typedef {(pathname: string, response: http.ServerResponse, file: string) => boolean} Answer */

/** @typedef {{ origin: string, close: () => void, asked: string[], answer?: Answer | undefined }} Served */

/** What serve() fills in. @returns {Served} */
export const notYetServed = () => ({ origin: "", close: () => {}, asked: [] });

/**
 * Serves a folder on the loopback; it holds no test run open. `asked` is every path asked for, in
 * order. `answer`, if it is set, may answer itself and then returns true. What this run has not
 * built waits, as for a reader of ./contact serve while it builds.
 */
export async function serve(folder = site, served = notYetServed()) {
  /** @type {string[] | undefined} */
  let waiting;
  const server = http.createServer((request, response) => {
    const { pathname } = new URL(request.url ?? "/", "http://localhost");
    served.asked.push(pathname);
    if (pathname === "/building.json") {
      waiting ??= notBuilt();
      if (waiting.length > 0) {
        response.setHeader("content-type", "application/json");
        response.end(JSON.stringify({ waiting, building: [] }));
        return;
      }
    }
    const asked = path.join(folder, decodeURIComponent(pathname));
    const file = asked.endsWith("/") ? path.join(asked, "index.html") : asked;
    if (!file.startsWith(folder) || !fs.existsSync(file) || fs.statSync(file).isDirectory()) {
      response.writeHead(404).end("not here");
      return;
    }
    const type = types[path.extname(file)] ?? "application/octet-stream";
    response.setHeader("content-type", type);
    if (served.answer?.(pathname, response, file)) return;
    fs.createReadStream(file).pipe(response);
  });
  await new Promise((done) => server.listen(0, "127.0.0.1", () => done(undefined)));
  server.unref();
  const address = /** @type {import("node:net").AddressInfo} */ (server.address());
  served.origin = `http://127.0.0.1:${address.port}`;
  served.close = () => {
    server.closeAllConnections();
    server.close();
  };
  return served;
}

/** What every browser here is started with. */
export const flags = [
  "--no-sandbox",
  "--disable-gpu",
  "--disable-quic",
  "--no-first-run",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
];

/** A fresh browser with a profile of its own, which goes when it is closed. */
export async function launch() {
  const { chromium } = require("playwright-core");
  const profile = fs.mkdtempSync(path.join(os.tmpdir(), "contact-browser-"));
  const browser = await chromium.launch({
    executablePath: findBrowser(),
    headless: true,
    args: [...flags, `--disk-cache-dir=${profile}`],
  });
  const close = async () => {
    await browser.close();
    fs.rmSync(profile, { recursive: true, force: true });
  };
  return { browser, close };
}

/**
 * Gathers what must not happen on a page: console errors, exceptions, failed requests and requests
 * to other origins.
 * @param {import("playwright-core").Page} page
 * @param {string} origin
 */
export function gatherTrouble(page, origin) {
  /** @type {string[]} */
  const trouble = [];
  page.on("console", (message) => {
    if (message.type() === "error") trouble.push(`console: ${message.text()}`);
  });
  page.on("pageerror", (error) => trouble.push(`exception: ${error.message}`));
  page.on("request", (request) => {
    const asked = request.url();
    if (!asked.startsWith(`${origin}/`) && !/^(data|blob):/.test(asked))
      trouble.push(`off the origin: ${asked}`);
  });
  page.on("response", (response) => {
    if (response.status() >= 400) trouble.push(`${response.status()}: ${response.url()}`);
  });
  return trouble;
}

/**
 * A page in a context of its own, with what must not happen on it. Its Deeper boxes are opened, so that what is in them
 * is tested like the rest, unless `boxes` says "closed".
 * @param {import("playwright-core").Browser} browser
 * @param {string} url
 * @param {import("playwright-core").BrowserContextOptions & { boxes?: "open" | "closed" }} options
 */
export async function open(browser, url, { boxes = "open", ...options } = {}) {
  const context = await browser.newContext({ viewport: { width: 1200, height: 900 }, ...options });
  const page = await context.newPage();
  const { origin } = url.startsWith("about:") ? { origin: "" } : new URL(url);
  const trouble = gatherTrouble(page, origin);
  await page.goto(url, { waitUntil: "load" });
  if (boxes === "open") await openBoxes(page);
  return { page, trouble, close: () => context.close() };
}

/** Opens every Deeper box of a page. @param {import("playwright-core").Page} page */
export const openBoxes = (page) =>
  page.evaluate(() => {
    for (const box of document.querySelectorAll("details.deeper"))
      if (box instanceof HTMLDetailsElement) box.open = true;
  });

/** Loads every figure of a page that is built, as scrolling through it does. @param {import("playwright-core").Page} page */
export async function loadFigures(page) {
  await page.evaluate(async () => {
    await customElements.whenDefined("contact-figure");
    for (const figure of document.querySelectorAll("contact-figure:not(:has(> .not-built))"))
      await /** @type {any} */ (figure).ready;
  });
}

/**
 * Waits until nothing on the page moves any more: a click is lost if what is pressed moves between the press and the
 * release, and figures, faces and answers of the judge arrive late. @param {import("playwright-core").Page} page
 */
export async function settle(page) {
  if ((await page.locator("contact-figure").count()) > 0) await loadFigures(page);
  await page.evaluate(async () => {
    await document.fonts.ready;
    for (let still = 0, height = -1; still < 5; ) {
      await new Promise(requestAnimationFrame);
      const now = document.documentElement.scrollHeight;
      still = now === height ? still + 1 : 0;
      height = now;
    }
  });
}

/** Loads one figure, as scrolling to it does. @param {any} locator */
export const loadFigure = (locator) =>
  locator.evaluate(async (/** @type {any} */ figure) => {
    await customElements.whenDefined("contact-figure");
    await figure.ready;
  });

/** A figure's input or output as plain fields, -0 and NaN kept. @param {any} locator @param {"input" | "output"} which */
export const fieldsOf = (locator, which) =>
  locator.evaluate(
    (/** @type {any} */ figure, /** @type {"input" | "output"} */ name) =>
      Object.fromEntries(Object.entries(figure[name])),
    which,
  );
