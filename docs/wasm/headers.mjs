// Which files a source may include. The same list is what the compiler is given and what the cache's key is made
// of, so nothing can be read that the key does not know.

import { createHash } from "node:crypto";
import fs from "node:fs";
import path from "node:path";
import { systemRoot } from "./flags.mjs";
import { eigenDir, root } from "./paths.mjs";

/** Packages of the machine whose headers a source may ask for, by the start of the header's name. */
const systemPackages = [
  { start: "Eigen/", dir: eigenDir, as: `${systemRoot}/eigen3` },
  { start: "unsupported/Eigen/", dir: eigenDir, as: `${systemRoot}/eigen3` },
  { start: "nlohmann/", dir: "/usr/include", as: systemRoot },
  { start: "toml++/", dir: "/usr/include", as: systemRoot },
  { start: "catch2/", dir: "/usr/include", as: systemRoot },
];

/** @typedef {{ bytes: Buffer, hash: string, includes: { name: string, quoted: boolean }[] }} Source */

/** @type {Map<string, Source | null>} */
const sources = new Map();

const includeLine = /^[ \t]*#[ \t]*include(?:_next)?[ \t]*(["<])([^">\n]+)[">]/gm;

/** A file with its hash and what it names after #include, whatever conditions stand round it; read once.
 * @param {string} file @returns {Source | null} */
function source(file) {
  const known = sources.get(file);
  if (known !== undefined) return known;
  /** @type {Source | null} */
  let found = null;
  if (fs.statSync(file, { throwIfNoEntry: false })?.isFile()) {
    const bytes = fs.readFileSync(file);
    const includes = [...bytes.toString("latin1").matchAll(includeLine)].map((match) => ({
      name: String(match[2]),
      quoted: match[1] === '"',
    }));
    found = { bytes, hash: createHash("sha256").update(bytes).digest("hex"), includes };
  }
  sources.set(file, found);
  return found;
}

/** Forgets what was read, for a process that outlives an edit. */
export function forgetSources() {
  sources.clear();
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
 * @returns {{ file: string, virtual: string, hash: string, bytes: Buffer }[]}
 */
export function closure(start, folders) {
  if (!source(start)) throw new Error(`no such file: ${start}`);
  const seen = new Set([start]);
  for (const file of seen)
    for (const { name, quoted } of source(file)?.includes ?? []) {
      const next = resolve(name, quoted, file, folders);
      if (next) seen.add(next);
    }
  return [...seen].map(sourceFile);
}

/** One file, as the compiler gets it. @param {string} file */
export function sourceFile(file) {
  const found = source(file);
  if (!found) throw new Error(`no such file: ${file}`);
  return { file, virtual: virtualPath(file), hash: found.hash, bytes: found.bytes };
}
