// The built pages and a browser for a block of tests.

import { after, before } from "node:test";
import { launch, notYetServed, serve, site } from "./browser.mjs";

/**
 * Serves the built pages and starts a browser before the first test of the block in which it is called, and ends both
 * after the last. Only tests and hooks may look into what it returns.
 */
export function inBrowser() {
  const server = notYetServed();
  const chromium = /** @type {Awaited<ReturnType<typeof launch>>} */ ({});
  before(async () => {
    await serve(site, server);
    Object.assign(chromium, await launch());
  });
  after(async () => {
    await chromium.close();
    server.close();
  });
  return { server, chromium };
}
