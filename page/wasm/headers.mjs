// Which files a source may include. The cache's key is made of the same list that the page's compiler is given; what
// the native compiler reads is compared with it (recipes.mjs). So nothing is made from a file that the key does not know.

import { createHash } from "node:crypto";
import fs from "node:fs";
import path from "node:path";
import { systemRoot } from "./flags.mjs";
import { eigenDir, root } from "./paths.mjs";

/** Packages of the machine whose headers a source may ask for, by the start of the header's name. */
export const systemPackages = [
  { start: "Eigen/", dir: eigenDir, as: `${systemRoot}/eigen3` },
  { start: "unsupported/Eigen/", dir: eigenDir, as: `${systemRoot}/eigen3` },
  { start: "nlohmann/", dir: "/usr/include", as: systemRoot },
  { start: "toml++/", dir: "/usr/include", as: systemRoot },
  { start: "catch2/", dir: "/usr/include", as: systemRoot },
];

/**
 * `unless`: the definition under which a header does not take its source in, as CONTACT_SCENES_COMPILED.
 * @typedef {{ name: string, quoted: boolean, unless: string | undefined }} Include
 * @typedef {{ bytes: Buffer, hash: string, includes: Include[] }} Source
 */

/** @type {Map<string, Source | null>} */
const sources = new Map();

const directive =
  /^[ \t]*#[ \t]*(?:(if)(?:n?def)?\b(?:[ \t]+(CONTACT_[A-Z]+_COMPILED)\b)?|(endif)|include(?:_next)?[ \t]*(["<])([^">\n]+)[">])/gm;

/** The files that a text names after #include, under any conditions, and whether a header includes its source there. @param {string} text @returns {Include[]} */
function includesOf(text) {
  const includes = [];
  /** @type {(string | undefined)[]} */
  const open = [];
  for (const [line, start, compiled, end, mark, name] of text.matchAll(directive)) {
    if (start) open.push(line.includes("ifndef") ? compiled : undefined);
    else if (end) open.pop();
    else {
      const unless = open.find((condition) => condition !== undefined);
      includes.push({ name: String(name), quoted: mark === '"', unless });
    }
  }
  return includes;
}

/** A file with its hash and its includes; read once.
 * @param {string} file @returns {Source | null} */
function source(file) {
  const known = sources.get(file);
  if (known !== undefined) return known;
  /** @type {Source | null} */
  let found = null;
  if (fs.statSync(file, { throwIfNoEntry: false })?.isFile()) {
    const bytes = fs.readFileSync(file);
    const includes = includesOf(bytes.toString("latin1"));
    found = { bytes, hash: createHash("sha256").update(bytes).digest("hex"), includes };
  }
  sources.set(file, found);
  return found;
}

/** What closure() has found. @type {Map<string, { file: string, virtual: string, hash: string, bytes: Buffer }[]>} */
const closures = new Map();

/** Forgets what was read, for a process that outlives an edit. */
export function forgetSources() {
  sources.clear();
  closures.clear();
}

/** The name of a file in the tree that the compiler sees, the same on every machine.
 * @param {string} file */
export function virtualPath(file) {
  for (const { dir, as } of systemPackages) {
    if (as === systemRoot) continue;
    const inside = path.relative(dir, file);
    if (!inside.startsWith("..")) return path.posix.join(as, inside);
  }
  const inside = path.relative(root, file);
  if (!inside.startsWith("..")) return inside.split(path.sep).join("/");
  for (const { start, dir, as } of systemPackages) {
    const inside = path.relative(dir, file);
    if (inside.startsWith(start)) return path.posix.join(as, inside);
  }
  return path.posix.join("outside", file.split(path.sep).join("/"));
}

/**
 * @param {string} name @param {boolean} quoted @param {string} from @param {string[]} folders
 * @returns {string | undefined}
 */
function resolve(name, quoted, from, folders) {
  const places = [...(quoted ? [path.dirname(from)] : []), ...folders];
  for (const { start, dir } of systemPackages) if (name.startsWith(start)) places.push(dir);
  for (const place of places) {
    const file = path.resolve(place, name);
    if (source(file)) return file;
  }
  return undefined; // the standard library's, which comes with the compiler
}

/**
 * Every file that compiling `start` may read, itself first.
 * @param {string} start @param {string[]} folders searched for headers, in order
 * @param {string[]} flags with -DCONTACT_SCENES_COMPILED a header's source is no part of it
 * @returns {{ file: string, virtual: string, hash: string, bytes: Buffer }[]}
 */
export function closure(start, folders, flags = []) {
  if (!source(start)) throw new Error(`no such file: ${start}`);
  const compiled = flags.filter((flag) => /^-DCONTACT_[A-Z]+_COMPILED$/.test(flag));
  const asked = [start, ...folders, ...compiled].join("\0");
  const known = closures.get(asked);
  if (known) return [...known];
  const seen = new Set([start]);
  for (const file of seen)
    for (const { name, quoted, unless } of source(file)?.includes ?? []) {
      if (unless !== undefined && compiled.includes(`-D${unless}`)) continue;
      const next = resolve(name, quoted, file, folders);
      if (next) seen.add(next);
    }
  const found = [...seen].map(sourceFile);
  closures.set(asked, found);
  return [...found];
}

/** One file, as the compiler gets it. @param {string} file */
export function sourceFile(file) {
  const found = source(file);
  if (!found) throw new Error(`no such file: ${file}`);
  return { file, virtual: virtualPath(file), hash: found.hash, bytes: found.bytes };
}
