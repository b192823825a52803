// The book's own answers on the page "Ask the engines": the reference headers of several chapters as one module.
import { inRoot } from "./paths.mjs";
import { chapterFolders, figureRecipe } from "./products.mjs";

/** The chapters whose headers it includes; with those that they build on. */
const CHAPTERS = ["05_meshes", "11_time_of_impact"];

/** Its answers are timed, so it is compiled for speed. @returns {import('./products.mjs').Product[]} */
export function engineProducts() {
  const folders = [...new Set(CHAPTERS.flatMap(chapterFolders))];
  const recipe = figureRecipe(inRoot("page", "engines", "queries.cpp"), folders, true);
  return [{ name: "engines/queries", output: "engines/queries.wasm", recipe }];
}
