// How a product comes from sources: a small graph of compile, archive and link, each remembered by its content.

import { createHash } from "node:crypto";
import fs from "node:fs";
import path from "node:path";
import { CompileError, compilerVersion, runTool } from "./compiler.mjs";
import { assertionsFolder, precompileFlags } from "./flags.mjs";
import { closure, forgetSources, sourceFile, virtualPath } from "./headers.mjs";
import { fromRoot, nativeVersion, runNative } from "./native_compiler.mjs";
import { cacheDir, eigenDir, inRoot, root } from "./paths.mjs";
import { definedNames, sealed } from "./seal.mjs";

/**
 * @typedef {{ tool: 'compile', what: string, source: string, folders: string[], flags: string[],
 *             language: 'c++' | 'c' | 'assembly', pch?: Precompile, inPage?: boolean }} Compile
 *   `inPage`: by the compiler that the page has, as a reader's file; else by the same as a native program
 * @typedef {{ tool: 'precompile', what: string, source: string, folders: string[], flags: string[],
 *             inPage?: boolean }} Precompile
 * @typedef {{ tool: 'archive', what: string, parts: Recipe[] }} Archive
 * @typedef {{ tool: 'link', what: string, before: string[], after: string[], parts: Recipe[] }} Link
 * @typedef {{ tool: 'seal', what: string, part: Recipe, others: Recipe[], open: Recipe[], keep: string[] }} Seal
 *   what `others` define is sealed as well; what `open` defines is not, nor the names in `keep`
 * @typedef {{ tool: 'shrink', what: string, part: Recipe }} Shrink a linked module, made smaller
 * @typedef {Compile | Precompile | Archive | Link | Seal | Shrink} Recipe
 */

/** What must be made before this can be. @param {Recipe} recipe @returns {Recipe[]} */
export function needs(recipe) {
  if (recipe.tool === "compile") return recipe.pch ? [recipe.pch] : [];
  if (recipe.tool === "precompile") return [];
  if (recipe.tool === "seal") return [recipe.part, ...recipe.others, ...recipe.open];
  if (recipe.tool === "shrink") return [recipe.part];
  return recipe.parts;
}

/** Every file that is read. @param {Compile | Precompile} recipe */
function filesOf({ source, folders, flags }) {
  const files = closure(source, folders, flags);
  // A header of our own in the place of one of the compiler's.
  if (flags.includes(`/${assertionsFolder}`)) files.push(sourceFile(assertionHandler));
  return files;
}

/** What libc++ does when one of its assertions fails. */
export const assertionHandler = inRoot(assertionsFolder, "__assertion_handler");

/** The version of Binaryen, and so of what shrink.mjs makes. */
const shrinkerVersion = () =>
  JSON.parse(fs.readFileSync(inRoot("page", "node_modules", "binaryen", "package.json"), "utf8"))
    .version;

/** The name under which the result is kept: it changes with the compiler, the flags and every file read.
 * @param {Recipe} recipe @returns {string} */
export function key(recipe) {
  const hash = createHash("sha256");
  const add = (/** @type {string[]} */ ...texts) => {
    for (const text of texts) hash.update(`${text.length}:${text}`);
  };
  add("2", recipe.tool, compilerVersion());
  if (recipe.tool === "compile" || recipe.tool === "precompile") {
    if (!recipe.inPage) add(nativeVersion());
    // It names its files by where they are.
    if (!recipe.inPage && recipe.tool === "precompile") add(root, eigenDir);
    add(...recipe.flags, "", ...recipe.folders.map(virtualPath), "");
    for (const { virtual, hash } of filesOf(recipe)) add(virtual, hash);
  }
  if (recipe.tool === "link") add(...recipe.before, "", ...recipe.after, "");
  if (recipe.tool === "shrink") add(shrinkerVersion());
  if (recipe.tool === "seal") add("2", `${recipe.others.length}`, ...recipe.keep);
  for (const need of needs(recipe)) add(key(need));
  return hash.digest("hex");
}

/** @param {string} name a key */
const cached = (name) => path.join(cacheDir, "made", name.slice(0, 2), name.slice(2));

/** Whether the result is there; looking marks it as used. @param {string} name a key */
export function isMade(name) {
  try {
    const now = new Date();
    fs.utimesSync(cached(name), now, now);
    return true;
  } catch {
    return false;
  }
}

/** @param {string} name a key @returns {Uint8Array} */
export function made(name) {
  return new Uint8Array(fs.readFileSync(cached(name)));
}

/** Writes a file so that a reader sees the old one or the new one, never half.
 * @param {string} file @param {Uint8Array | string} content */
export function writeWhole(file, content) {
  fs.mkdirSync(path.dirname(file), { recursive: true });
  const part = `${file}.${process.pid}.part`;
  fs.writeFileSync(part, content);
  fs.renameSync(part, file);
}

/** Deletes what no build has used for some days. @param {number} days */
export function prune(days) {
  const before = Date.now() - days * 86_400_000;
  const top = path.join(cacheDir, "made");
  if (!fs.existsSync(top)) return;
  for (const folder of fs.readdirSync(top))
    for (const name of fs.readdirSync(path.join(top, folder))) {
      const file = path.join(top, folder, name);
      if (fs.statSync(file).mtimeMs < before) fs.rmSync(file, { force: true });
    }
}

/** @typedef {import('./compiler.mjs').Tree} Tree */

/** @param {Tree} tree @param {string} file @param {Uint8Array} bytes */
export function put(tree, file, bytes) {
  const parts = file.split("/");
  const name = /** @type {string} */ (parts.pop());
  let folder = tree;
  for (const part of parts) folder = /** @type {Tree} */ ((folder[part] ??= {}));
  folder[name] = bytes;
}

/** @param {Compile | Precompile} recipe @returns {Tree} */
function treeFor(recipe) {
  /** @type {Tree} */
  const tree = {};
  for (const { virtual, bytes } of filesOf(recipe)) put(tree, virtual, new Uint8Array(bytes));
  return tree;
}

/**
 * What the compiler is told, but for flags, precompiled header and result.
 * @param {Compile | Precompile} recipe @param {(file: string) => string} named how the compiler knows a file
 */
function compilation(recipe, named) {
  const source = named(recipe.source);
  const search = recipe.folders.flatMap((folder) => ["-I", named(folder)]);
  if (recipe.tool === "precompile") return [...search, "-emit-pch", "-x", "c++-header", source];
  if (recipe.language === "assembly") return [source];
  const name = path.basename(source);
  return [...search, "-emit-obj", "-main-file-name", name, "-x", recipe.language, source];
}

/** In the tree that compiler.mjs is given. @param {string} file */
const inTree = (file) => `/${virtualPath(file)}`;

/** Compiles with the native program, from the files themselves. @param {Compile | Precompile} recipe
 * @param {string} name its key @param {string[]} needed @returns {Promise<string>} */
async function makeNatively(recipe, name, needed) {
  const target = cached(name);
  const part = `${target}.${process.pid}.part`;
  fs.mkdirSync(path.dirname(target), { recursive: true });
  const flags = recipe.tool === "precompile" ? [...recipe.flags, ...precompileFlags] : recipe.flags;
  const [header] = needed;
  const include = header === undefined ? [] : ["-include-pch", cached(header)];
  const rest = [...include, "-o", part, ...compilation(recipe, fromRoot)];
  /** @type {unknown} */
  let error;
  const { log, read } = await runNative(flags, rest, recipe.what).catch((thrown) => {
    error = thrown;
    return { log: "", read: [] };
  });
  const known = new Set([recipe, ...needs(recipe)].flatMap(filesRead));
  const unknown = read.find((file) => !known.has(file));
  // A source that was saved meanwhile may be why it does not compile.
  forgetSources();
  if (key(recipe) !== name) error = new Changed(recipe.what);
  else if (unknown)
    error = new CompileError(
      `${recipe.what} reads a file that headers.mjs does not find`,
      `${unknown}: include it by its name, and not by a macro.`,
    );
  if (error) {
    fs.rmSync(part, { force: true });
    throw error;
  }
  fs.renameSync(part, target);
  return log;
}

/** Where the files are that it may read. @param {Recipe} recipe */
const filesRead = (recipe) =>
  recipe.tool === "compile" || recipe.tool === "precompile"
    ? filesOf(recipe).map(({ file }) => fs.realpathSync(file))
    : [];

/** A source was edited between the moment when its key was computed and the moment when it was read. */
export class Changed extends Error {}

/**
 * Makes one thing whose needs are made, and keeps it. Gives back what the compiler said (warnings).
 * @param {Recipe} recipe @param {string} name its key @param {string[]} needed the keys of its needs
 * @returns {Promise<string>}
 */
export async function make(recipe, name, needed) {
  if (recipe.tool === "seal") {
    const [part, ...rest] = needed.map(made);
    const defined = rest.map(definedNames);
    const count = recipe.others.length;
    const keep = [...recipe.keep, ...defined.slice(count).flatMap((names) => [...names])];
    const object = sealed(/** @type {Uint8Array} */ (part), defined.slice(0, count), keep);
    writeWhole(cached(name), object);
    return "";
  }
  if (recipe.tool === "shrink") {
    // Loaded where it is needed: most of the build does without.
    const { shrunk } = await import("./shrink.mjs");
    writeWhole(cached(name), shrunk(made(String(needed[0]))));
    return "";
  }
  const result = "result.out";
  const compiles = recipe.tool === "compile" || recipe.tool === "precompile";
  if (compiles && !recipe.inPage) return makeNatively(recipe, name, needed);
  /** @type {Tree} */
  let tree = {};
  /** @type {string[]} */
  let args;
  switch (recipe.tool) {
    case "compile": {
      tree = treeFor(recipe);
      args = [...recipe.flags];
      if (recipe.pch) {
        for (const { virtual, bytes } of filesOf(recipe.pch))
          put(tree, virtual, new Uint8Array(bytes));
        tree["prelude.pch"] = made(String(needed[0]));
        args.push("-include-pch", "prelude.pch");
      }
      args.push("-o", result, ...compilation(recipe, inTree));
      break;
    }
    case "precompile":
      tree = treeFor(recipe);
      args = [...recipe.flags, ...precompileFlags, "-o", result, ...compilation(recipe, inTree)];
      break;
    case "archive":
    case "link": {
      const names = recipe.parts.map((part, i) => {
        const file = part.tool === "archive" ? `part${i}.a` : `part${i}.o`;
        tree[file] = made(String(needed[i]));
        return file;
      });
      args =
        recipe.tool === "archive"
          ? ["ar", "crsD", result, ...names]
          : [...recipe.before, ...names, ...recipe.after, "-o", result];
      break;
    }
  }
  if (compiles && key(recipe) !== name) throw new Changed(recipe.what);
  const { files, log } = await runTool(args, tree, recipe.what);
  const bytes = files[result];
  if (!(bytes instanceof Uint8Array)) throw new CompileError(`${recipe.what}: no result`, log);
  writeWhole(cached(name), bytes);
  return log;
}
