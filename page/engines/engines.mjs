// The engines and the book in Node, from the same code as in the page.
import fs from "node:fs";
import path from "node:path";
import { inRoot } from "../wasm/paths.mjs";
import { load } from "../web/test/load.mjs";

export const recordFile = inRoot("page", "engines", "recorded.json");

/** @typedef {typeof import("../web/src/engines/node.ts")} Library */
/** @typedef {import("../web/src/engines/types.ts").Adapter} Adapter */
/** @typedef {import("../web/src/engines/types.ts").Engine} Engine */

/**
 * Everything that is asked, loaded. The book comes first.
 * @returns {Promise<{ library: Library, asked: { adapter: Adapter, engine: Engine }[] }>}
 */
export async function loadAll() {
  /** @type {Library} */
  const library = await load("engines/node.ts");
  const bytes = (/** @type {string} */ name) => {
    const file = inRoot("build", "web", ...name.split("/"));
    if (!fs.existsSync(file))
      throw new Error(
        `${path.relative(inRoot(), file)} is missing: run node page/wasm/build.mjs figures --only 20_scenes/scene_player --only engines/queries`,
      );
    return fs.readFileSync(file);
  };
  const book = library.book(bytes("scenes/player.wasm"), bytes("engines/queries.wasm"));
  const adapters = [book, ...(await Promise.all(library.ADAPTERS.map((get) => get())))];
  const asked = [];
  for (const adapter of adapters) asked.push({ adapter, engine: await adapter.load() });
  return { library, asked };
}

/** JSON has no NaN and no infinity. @param {number} x */
export const written = (x) => (Number.isFinite(x) ? x : null);
