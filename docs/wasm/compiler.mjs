// Clang, LLD and ar as WebAssembly, in this process: one call compiles, links or archives a tree of files
// held in memory. The package is used as published but for two faults, mended in a copy.
import fs from "node:fs";
import { createRequire } from "node:module";
import path from "node:path";
import { pathToFileURL } from "node:url";
import { cacheDir } from "./paths.mjs";

/** A tree of files: a name to bytes, text or a further tree.
 * @typedef {{ [name: string]: Tree | string | Uint8Array }} Tree */

/** @typedef {{ files: Tree, log: string }} Output */

/** The compiler said no; `log` holds its own words. */
export class CompileError extends Error {
  /** @param {string} what @param {string} log */
  constructor(what, log) {
    super(`${what}\n${log.trim()}`);
    this.name = "CompileError";
    this.log = log.trim();
  }
}

const packageName = "@yowasp/clang";
const require = createRequire(import.meta.url);

/** The folder of the installed package. */
function packageDir() {
  try {
    return path.resolve(path.dirname(require.resolve(packageName)), "..");
  } catch {
    throw new Error(
      `${packageName} is not installed: run \`npm ci\` in docs/ (or ./contact setup)`,
    );
  }
}

/** The version of the installed compiler, as in its package.json. @returns {string} */
export function compilerVersion() {
  const file = path.join(packageDir(), "package.json");
  return JSON.parse(fs.readFileSync(file, "utf8")).version;
}

/**
 * What is wrong in the package, and what is right. Each text must be found exactly once, so that a
 * new version that differs is noticed here and not in a puzzling compile error.
 */
const mends = [
  {
    why: '".." in a path is skipped instead of leading up, and Eigen includes "../plugins/..."',
    from: `    let entry = this;
    let separatorAt = -1;
    do {`,
    to: `    let entry = this;
    const above = [];
    let separatorAt = -1;
    do {`,
  },
  {
    why: "the same",
    from: `      else if (segment === "..")
        ;
      else if (Object.hasOwn(files, segment))
        entry = files[segment];`,
    to: `      else if (segment === "..")
        entry = above.pop() ?? entry;
      else if (Object.hasOwn(files, segment)) {
        above.push(entry);
        entry = files[segment];
      }`,
  },
  {
    why: "each write copies the whole file, so a 28 MB precompiled header takes minutes",
    from: `    const newData = new Uint8Array(Math.max(this.file.data.length, offset + contents.length));
    newData.set(this.file.data);
    newData.subarray(offset).set(contents);
    this.file.data = newData;`,
    to: `    const end = offset + contents.length;
    const old = this.file.data;
    if (!this.file.grown || end > old.buffer.byteLength) {
      const room = new Uint8Array(Math.max(end, 2 * old.length, 65536));
      room.set(old);
      this.file.data = room.subarray(0, Math.max(end, old.length));
      this.file.grown = true;
    } else if (end > old.length) {
      this.file.data = new Uint8Array(old.buffer, 0, end);
    }
    this.file.data.set(contents, offset);`,
  },
];

/** The package's program text with the faults mended. @param {string} source */
export function mended(source) {
  for (const { why, from, to } of mends) {
    if (source.split(from).length !== 2)
      throw new Error(`${packageName} has changed; this mend no longer fits: ${why}`);
    source = source.replace(from, () => to);
  }
  return source;
}

/** Makes (once) a folder with the mended program beside links to the package's large files. */
function mendedCopy() {
  const source = path.join(packageDir(), "gen");
  const target = path.join(cacheDir, `compiler-${compilerVersion()}`);
  const bundle = path.join(target, "bundle.mjs");
  fs.mkdirSync(target, { recursive: true });
  const text = mended(fs.readFileSync(path.join(source, "bundle.js"), "utf8"));
  for (const name of fs.readdirSync(source)) {
    const link = path.join(target, name);
    if (name === "bundle.js") continue;
    if (fs.existsSync(link)) continue;
    fs.rmSync(link, { force: true }); // a link whose target has moved
    try {
      fs.symlinkSync(path.join(source, name), link);
    } catch (error) {
      if (/** @type {NodeJS.ErrnoException} */ (error).code !== "EEXIST") throw error;
    }
  }
  if (!fs.existsSync(bundle) || fs.readFileSync(bundle, "utf8") !== text) {
    const part = `${bundle}.${process.pid}`;
    fs.writeFileSync(part, text);
    fs.renameSync(part, bundle);
  }
  return pathToFileURL(bundle).href;
}

/** @type {Promise<any> | undefined} */
let loading;

/** Loads the compiler: about a second, once in a process. */
async function loaded() {
  loading ??= (async () => {
    const module = await import(mendedCopy());
    await module.runLLVM(null, {}, { fetchProgress() {} });
    return module;
  })();
  return loading;
}

/**
 * Runs one tool (`args[0]`) on a tree of files and gives back the tree after it.
 * @param {string[]} args @param {Tree} files @param {string} what for the message when it fails
 * @returns {Promise<Output>}
 */
export async function runTool(args, files, what) {
  const llvm = await loaded();
  const decoder = new TextDecoder();
  let log = "";
  const write = (/** @type {Uint8Array | null} */ bytes) => {
    if (bytes) log += decoder.decode(bytes, { stream: true });
  };
  try {
    const options = { synchronously: true, decodeASCII: false, stdout: write, stderr: write };
    return { files: llvm.runLLVM(args, files, options), log };
  } catch (error) {
    // Not the error itself: it carries the whole tree of files.
    if (error instanceof llvm.Exit) throw new CompileError(`${what} does not compile`, log);
    throw new CompileError(`${what}: the compiler stopped: ${String(error)}`, log);
  }
}
