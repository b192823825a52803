// A process that makes things, one at a time, for pool.mjs. A compiler that has run a few times is faster than a
// new one, so it stays until its parent lets go of it.
import os from "node:os";
import { CompileError } from "./compiler.mjs";
import { forgetSources } from "./headers.mjs";
import { Changed, isMade, make } from "./recipes.mjs";

os.setPriority(5);

/** @typedef {{ recipe: import('./recipes.mjs').Recipe, name: string, needed: string[] }} Job */

process.on("message", async (/** @type {Job} */ { recipe, name, needed }) => {
  const start = performance.now();
  try {
    forgetSources();
    // Another build may have made it meanwhile.
    const log = isMade(name) ? "" : await make(recipe, name, needed);
    process.send?.({ ok: true, log, seconds: (performance.now() - start) / 1000 });
  } catch (error) {
    const log =
      error instanceof CompileError ? error.message : String(/** @type {Error} */ (error).stack);
    const changed = error instanceof Changed;
    process.send?.({ ok: false, changed, log, seconds: (performance.now() - start) / 1000 });
  }
});
process.on("disconnect", () => process.exit());
