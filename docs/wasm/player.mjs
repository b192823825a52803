// The scene player: reader, planner and simulator of 20_scenes as one module for the page. Unlike a figure it is
// given what a reader has typed, so it throws and catches.
import fs from "node:fs";
import path from "node:path";
import { moduleLink, quiet, studentFlags } from "./flags.mjs";
import { inRoot } from "./paths.mjs";
import { chapterFolders, exceptionRuntime } from "./products.mjs";

/** @typedef {import('./recipes.mjs').Compile} Compile */

/** @param {string} level how much is done for speed or size */
const flags = (level) => [
  ...studentFlags.filter((flag) => flag !== "-O1" && !/HARDENING|fsanitize/.test(flag)),
  level,
  "-DNDEBUG",
  "-DJSON_NO_IO",
  ...quiet,
];

/** What reads and tells is small; what runs is quick. */
const small = [
  "plan_json.cpp",
  "plan_text.cpp",
  "scenes/json_tree.cpp",
  "scenes/scene_reader.cpp",
  "scenes/page/player.cpp",
];
const quick = ["scenes/page/player_run.cpp"];

const folders = () => [inRoot("cli"), ...chapterFolders("20_scenes")];

/** What the small ones share is read once. @returns {import('./recipes.mjs').Precompile} */
const prelude = () => ({
  tool: "precompile",
  what: "what the scene player's files share",
  flags: flags("-Oz"),
  folders: folders(),
  source: inRoot("cli", "scenes", "page", "player_prelude.hpp"),
});

/** @returns {import('./recipes.mjs').Link} */
export function playerRecipe() {
  const part = (/** @type {string} */ file, /** @type {string} */ level) => {
    const source = inRoot("cli", file);
    /** @type {Compile} */
    const recipe = {
      tool: "compile",
      what: path.relative(inRoot(), source),
      language: "c++",
      flags: flags(level),
      folders: folders(),
      source,
    };
    return level === "-Oz" ? { ...recipe, pch: prelude() } : recipe;
  };
  const parts = [
    ...small.map((file) => part(file, "-Oz")),
    ...quick.map((file) => part(file, "-O2")),
    exceptionRuntime,
  ];
  // Binaryen would take as long as half of the compiling, and save a thirtieth of what is sent.
  const before = [...moduleLink.before, "--compress-relocations"];
  return { tool: "link", what: "the scene player", before, after: moduleLink.after, parts };
}

/** The player, if there are scenes to play. @returns {import('./products.mjs').Product[]} */
export const playerProduct = () =>
  fs.existsSync(inRoot("chapters", "20_scenes", "scenes"))
    ? [{ name: "20_scenes/scene_player", output: "scenes/player.wasm", recipe: playerRecipe() }]
    : [];
