// The scene player: reader, planner and simulator of 20_scenes as one module for the page. Unlike a figure it is
// given what a reader has typed, so it throws and catches. And its opening, a module of its own.
import fs from "node:fs";
import path from "node:path";
import { moduleLink, quiet, studentFlags } from "./flags.mjs";
import { inRoot } from "./paths.mjs";
import { chapterFolders, exceptionRuntime, figureRecipe } from "./products.mjs";

/** @typedef {import('./recipes.mjs').Compile} Compile */

/** @param {string} level how much is done for speed or size */
const flags = (level) => [
  ...studentFlags.filter((flag) => flag !== "-O1" && !/HARDENING|fsanitize/.test(flag)),
  level,
  "-DNDEBUG",
  "-DJSON_NO_IO",
  // Each source of the chapter is in one of the parts; no header takes it in.
  "-DCONTACT_SCENES_COMPILED",
  ...quiet,
];

/** A part of the player: the chapter's sources that it needs, and its own. @param {string} file @param {string} level */
function part(file, level) {
  const source = inRoot("page", "player", file);
  /** @type {Compile} */
  const recipe = {
    tool: "compile",
    what: path.relative(inRoot(), source),
    language: "c++",
    flags: flags(level),
    folders: chapterFolders("20_scenes"),
    source,
  };
  return recipe;
}

/** @returns {import('./recipes.mjs').Link} */
export function playerRecipe() {
  const parts = [part("quick.cpp", "-O2"), part("small.cpp", "-Oz"), exceptionRuntime];
  // Binaryen would take as long as half of the compiling, and save a thirtieth of what is sent.
  const before = [...moduleLink.before, "--compress-relocations"];
  return { tool: "link", what: "the scene player", before, after: moduleLink.after, parts };
}

/**
 * The scene that a page opens with: small as a figure, since it is loaded without asking.
 * @returns {import('./recipes.mjs').Recipe}
 */
export const openingRecipe = () =>
  figureRecipe(inRoot("page", "player", "opening.cpp"), chapterFolders("20_scenes"));

/** The player and its opening, if there are scenes to play: `--only 20_scenes/scene_player` takes both. @returns {import('./products.mjs').Product[]} */
export const playerProducts = () => {
  const name = "20_scenes/scene_player";
  return fs.existsSync(inRoot("chapters", "20_scenes", "scenes"))
    ? [
        { name, output: "scenes/player.wasm", recipe: playerRecipe() },
        { name: `${name}/opening`, output: "scenes/opening.wasm", recipe: openingRecipe() },
      ]
    : [];
};
