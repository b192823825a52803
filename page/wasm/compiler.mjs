// Clang, LLD and ar as WebAssembly, in this process: one call compiles, links or archives a tree of files
// held in memory. The package is used as published, except for two faults, which are corrected in a copy.
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
      `${packageName} is not installed: run \`npm ci\` in page/ (or ./contact setup)`,
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
  {
    why: "it fetches its parts under their own names, and a page keeps them under names that tell their content",
    from: `var modules = async (fetch3) => ({
  "llvm.core.wasm": await fetch3(new URL("./llvm.core.wasm", import.meta.url)).then(compileWasmModule),
  "llvm.core2.wasm": await fetch3(new URL("./llvm.core2.wasm", import.meta.url)).then(compileWasmModule),
  "llvm.core3.wasm": await fetch3(new URL("./llvm.core3.wasm", import.meta.url)).then(compileWasmModule),
  "llvm.core4.wasm": await fetch3(new URL("./llvm.core4.wasm", import.meta.url)).then(compileWasmModule)
});
var filesystem = async (fetch3) => ({
  "usr": await fetch3(new URL("./llvm-resources.tar", import.meta.url)).then((resp) => resp.arrayBuffer()).then(unpackTarFilesystem)
});`,
    to: `var supplied;
var modules = async () => supplied.modules;
var filesystem = async () => supplied.files;
async function start(parts) {
  supplied = parts;
  await runLLVM(null, {}, { fetchProgress() {} });
}`,
  },
  {
    why: "the same",
    from: `  if (!getCoreModule) getCoreModule = (name) => fetchCompile(new URL(\`./\${name}\`, import.meta.url));
`,
    to: "",
  },
  {
    why: "the same",
    from: `export {
  Exit,
  commands,`,
    to: `export {
  Exit,
  start,
  unpackTarFilesystem as openTar,
  commands,`,
  },
];

/** The compiler's modules of WebAssembly, and the tar of its headers and libraries. */
export const coreNames = [
  "llvm.core.wasm",
  "llvm.core2.wasm",
  "llvm.core3.wasm",
  "llvm.core4.wasm",
];
const resources = "llvm-resources.tar";

/** A file of the package, as published. @param {string} name */
const published = (name) => fs.readFileSync(path.join(packageDir(), "gen", name));

/** @param {string} name one of coreNames */
export const coreModule = (name) => published(name);

/** The package's program text with the faults corrected. @param {string} source */
export function mended(source) {
  for (const { why, from, to } of mends) {
    if (source.split(from).length !== 2)
      throw new Error(`${packageName} has changed; this mend no longer fits: ${why}`);
    source = source.replace(from, () => to);
  }
  return source;
}

/** The program text of the compiler as a page may have it: `start` is given what it needs, and it fetches nothing. */
export const mendedProgram = () => mended(published("bundle.js").toString("utf8"));

/** Writes the corrected program where Node can import it. @returns {string} its address */
function mendedCopy() {
  const file = path.join(cacheDir, `compiler-${compilerVersion()}.mjs`);
  const text = mendedProgram();
  if (!fs.existsSync(file) || fs.readFileSync(file, "utf8") !== text) {
    fs.mkdirSync(cacheDir, { recursive: true });
    const part = `${file}.${process.pid}`;
    fs.writeFileSync(part, text);
    fs.renameSync(part, file);
  }
  return pathToFileURL(file).href;
}

/** The headers and libraries of the package, as a tree. @returns {Promise<Tree>} */
export async function resourceTree() {
  const { openTar } = await import(mendedCopy());
  const bytes = published(resources);
  return openTar(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength));
}

/** @type {Promise<any> | undefined} */
let loading;

/** Loads the compiler: about a second, once in a process. */
async function loaded() {
  loading ??= (async () => {
    const llvm = await import(mendedCopy());
    const modules = await Promise.all(
      coreNames.map(async (name) => [name, await WebAssembly.compile(coreModule(name))]),
    );
    await llvm.start({
      modules: Object.fromEntries(modules),
      files: { usr: await resourceTree() },
    });
    return llvm;
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
