// What the page's compiler and linker say of one file, with the flags and the names that the page uses.

import path from "node:path";
import { CompileError, runTool } from "../../wasm/compiler.mjs";
import { diagnosticFlags, programLink, studentFlags } from "../../wasm/flags.mjs";
import { closure, virtualPath } from "../../wasm/headers.mjs";
import { makeAll } from "../../wasm/pool.mjs";
import {
  checkPrelude,
  checksObject,
  exerciseList,
  studentFolders,
  testObject,
} from "../../wasm/products.mjs";
import { key, made } from "../../wasm/recipes.mjs";

/** @typedef {import("../../wasm/compiler.mjs").Tree} Tree */

/** @param {string} name NN_slug/NAME */
function found(name) {
  const exercise = exerciseList().find((exercise) => exercise.name === name);
  if (!exercise) throw new Error(`there is no exercise ${name}`);
  return exercise;
}

/** Makes what compiling needs, and linking for the exercises named. @param {string[]} linked */
export async function ready(linked) {
  const needed = [checkPrelude, checksObject(), ...linked.map((name) => testObject(found(name)))];
  const { failed } = await makeAll(needed);
  for (const why of failed.values()) throw new Error(why);
}

/** @param {Tree} tree @param {string} file @param {Uint8Array} bytes */
function put(tree, file, bytes) {
  const parts = file.split("/");
  const name = /** @type {string} */ (parts.pop());
  let folder = tree;
  for (const part of parts) {
    folder[part] ??= {};
    folder = /** @type {Tree} */ (folder[part]);
  }
  folder[name] = bytes;
}

/** Runs a tool; nothing for the result if it says no.
 * @param {string[]} args @param {Tree} tree @param {string} result the file that it makes
 * @returns {Promise<{ made: Uint8Array | undefined, log: string }>} */
async function run(args, tree, result) {
  try {
    const { files, log } = await runTool(args, tree, String(args[0]));
    const bytes = files[result];
    return { made: bytes instanceof Uint8Array ? bytes : undefined, log };
  } catch (error) {
    if (error instanceof CompileError) return { made: undefined, log: error.log };
    throw error;
  }
}

/** Compiles a student's text as NAME.cpp in the root. @param {string} name NN_slug/NAME @param {string} text */
export function compile(name, text) {
  const exercise = found(name);
  const short = path.basename(name);
  const folders = [exercise.folder, ...studentFolders];
  /** @type {Tree} */
  const tree = { [`${short}.cpp`]: text, "prelude.pch": made(key(checkPrelude)) };
  for (const header of [path.join(exercise.folder, `${short}.hpp`), checkPrelude.source])
    for (const { virtual, bytes } of closure(header, folders)) put(tree, virtual, bytes);
  const search = folders.flatMap((folder) => ["-I", virtualPath(folder)]);
  const args = [...studentFlags, ...diagnosticFlags, ...search, "-include-pch", "prelude.pch"];
  args.push("-emit-obj", "-o", "answer.o", "-x", "c++", `${short}.cpp`);
  return run(args, tree, "answer.o");
}

/** Links an object with the tests of an exercise. @param {string} name NN_slug/NAME @param {Uint8Array} object */
export function link(name, object) {
  const tree = {
    "answer.o": object,
    "tests.o": made(key(testObject(found(name)))),
    "checks.o": made(key(checksObject())),
  };
  const { before, after } = programLink;
  return run([...before, ...Object.keys(tree), ...after, "-o", "answer.wasm"], tree, "answer.wasm");
}
