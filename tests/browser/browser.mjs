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
export const require = createRequire(path.join(root, "docs", "package.json"));

/** The browser to use, or undefined. CONTACT says which names are looked for. */
function findBrowser() {
  if (process.env.CHROMIUM) return process.env.CHROMIUM;
  for (const name of ["chromium", "chromium-browser", "google-chrome-stable", "google-chrome"]) {
    const { status, stdout } = spawnSync("sh", ["-c", `command -v ${name}`], { encoding: "utf8" });
    // Ubuntu's chromium is a snap, which cannot be started from a test.
    if (status === 0 && !fs.realpathSync(stdout.trim()).includes("snap")) return stdout.trim();
  }
  return undefined;
}

/** Why the tests of the page cannot be run here, or undefined if they can. */
export function whyNot() {
  if (!findBrowser()) return "no Chromium found: set CHROMIUM to one";
  if (!fs.existsSync(path.join(site, "index.html"))) return `the book is not built in ${site}`;
  return undefined;
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
};

/** Serves a folder on the loopback; it holds no test run open. */
export async function serve(folder = site) {
  const server = http.createServer((request, response) => {
    const { pathname } = new URL(request.url ?? "/", "http://localhost");
    const asked = path.join(folder, decodeURIComponent(pathname));
    const file = asked.endsWith("/") ? path.join(asked, "index.html") : asked;
    if (!file.startsWith(folder) || !fs.existsSync(file) || fs.statSync(file).isDirectory()) {
      response.writeHead(404).end("not here");
      return;
    }
    const type = types[path.extname(file)] ?? "application/octet-stream";
    response.writeHead(200, { "content-type": type });
    fs.createReadStream(file).pipe(response);
  });
  await new Promise((done) => server.listen(0, "127.0.0.1", () => done(undefined)));
  server.unref();
  const address = /** @type {import("node:net").AddressInfo} */ (server.address());
  const close = () => {
    server.closeAllConnections();
    server.close();
  };
  return { origin: `http://127.0.0.1:${address.port}`, close };
}

/** A fresh browser with a profile of its own, which goes when it is closed. */
export async function launch() {
  const { chromium } = require("playwright-core");
  const profile = fs.mkdtempSync(path.join(os.tmpdir(), "contact-browser-"));
  const browser = await chromium.launch({
    executablePath: findBrowser(),
    headless: true,
    args: [
      "--no-sandbox",
      "--disable-gpu",
      "--disable-quic",
      "--no-first-run",
      "--disable-background-networking",
      "--disable-component-update",
      "--disable-sync",
      `--disk-cache-dir=${profile}`,
    ],
  });
  const close = async () => {
    await browser.close();
    fs.rmSync(profile, { recursive: true, force: true });
  };
  return { browser, close };
}
