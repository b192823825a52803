// The page's compiler in Node, as a browser loads it: from cpp/manifest.json and from nothing else. For tests.
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { pathToFileURL } from "node:url";

/** @typedef {import('./toolchain.mjs').Manifest} Manifest */
/** @typedef {import('./compiler.mjs').Tree} Tree */
/** @typedef {{ ok: true, program: Uint8Array<ArrayBuffer>, log: string }
 *   | { ok: false, step: 'compile' | 'link', log: string }} Built */

/** Opens a shipped file, compressed or not. @param {Uint8Array} bytes @returns {Promise<ArrayBuffer>} */
async function opened(bytes) {
  const body = new Blob([new Uint8Array(bytes)]).stream();
  const zipped = bytes[0] === 0x1f && bytes[1] === 0x8b;
  const stream = zipped ? body.pipeThrough(new DecompressionStream("gzip")) : body;
  return new Response(stream).arrayBuffer();
}

/** Node 18 takes a .js file for a module only by a package.json beside it, which the page's files lack.
 * @param {string} file */
async function importModule(file) {
  const folder = fs.mkdtempSync(path.join(os.tmpdir(), "contact-compiler-"));
  try {
    const module = path.join(folder, "compiler.mjs");
    fs.copyFileSync(file, module);
    return await import(pathToFileURL(module).href);
  } finally {
    fs.rmSync(folder, { recursive: true, force: true });
  }
}

export class PageCompiler {
  /** @type {any} */
  #llvm;
  /** @type {Map<string, Uint8Array>} */
  #parts = new Map();

  /** @param {string} folder build/web/cpp */
  constructor(folder) {
    this.folder = folder;
    /** @type {Manifest} */
    this.manifest = JSON.parse(fs.readFileSync(path.join(folder, "manifest.json"), "utf8"));
  }

  /** @param {{ file: string }} shipped */
  async #read({ file }) {
    return opened(fs.readFileSync(path.join(this.folder, file)));
  }

  /** @param {string} name a key of the manifest's files */
  async file(name) {
    const shipped = this.manifest.files[name];
    if (!shipped) throw new Error(`the manifest has no ${name}`);
    return this.#read(shipped);
  }

  async load() {
    const { files, core, behind } = this.manifest;
    this.#llvm = await importModule(path.join(this.folder, String(files["compiler.js"]?.file)));
    const modules = core.filter((name) => /^llvm\..*\.wasm$/.test(name));
    const compiled = await Promise.all(
      modules.map(async (name) => [name, await WebAssembly.compile(await this.file(name))]),
    );
    await this.#llvm.start({
      modules: Object.fromEntries(compiled),
      files: this.#llvm.openTar(await this.file("system.tar")),
    });
    for (const name of ["checks.o", ...behind])
      this.#parts.set(name, new Uint8Array(await this.file(name)));
    return this;
  }

  /** @param {string[]} args @param {Tree} files @returns {{ files: Tree | undefined, log: string }} */
  #run(args, files) {
    const decoder = new TextDecoder();
    let log = "";
    const write = (/** @type {Uint8Array | null} */ bytes) => {
      if (bytes) log += decoder.decode(bytes, { stream: true });
    };
    const options = { synchronously: true, decodeASCII: false, stdout: write, stderr: write };
    try {
      return { files: this.#llvm.runLLVM(args, files, options), log };
    } catch (error) {
      if (error instanceof this.#llvm.Exit) return { files: undefined, log };
      throw new Error(`the compiler stopped: ${String(error)}\n${log}`);
    }
  }

  /**
   * Compiles one file and links it with the tests of its exercise.
   * @param {string} exercise NN_slug/NAME @param {string} contract the text of NAME.hpp @param {string} source
   * @param {{ prelude?: boolean }} [options] whether to use the precompiled header
   * @returns {Promise<Built>}
   */
  async build(exercise, contract, source, { prelude = true } = {}) {
    const { compile, link, exercises } = this.manifest;
    const [slug, name] = /** @type {[string, string]} */ (exercise.split("/"));
    const shipped = exercises[exercise];
    if (!shipped) throw new Error(`the manifest has no exercise ${exercise}`);
    /** @type {Tree} */
    const tree = {
      [`${name}.cpp`]: source,
      exercises: { [slug]: { [name]: { [`${name}.hpp`]: contract } } },
    };
    const pch = this.#parts.get("prelude.pch");
    if (prelude && pch) tree["prelude.pch"] = pch;
    const compiled = this.#run(
      [
        ...compile.flags,
        ...compile.diagnostics,
        ...["-I", `/exercises/${exercise}`],
        ...compile.include,
        ...(prelude ? compile.withPrelude : []),
        ...["-emit-obj", "-main-file-name", `${name}.cpp`, "-o", "answer.o"],
        ...["-x", "c++", `${name}.cpp`],
      ],
      tree,
    );
    if (!compiled.files) return { ok: false, step: "compile", log: compiled.log };
    const linked = this.#run(
      [...link.before, "answer.o", "tests.o", "checks.o", ...link.after, "-o", "program.wasm"],
      {
        "answer.o": /** @type {Uint8Array} */ (compiled.files["answer.o"]),
        "tests.o": new Uint8Array(await this.#read(shipped)),
        "checks.o": /** @type {Uint8Array} */ (this.#parts.get("checks.o")),
      },
    );
    if (!linked.files) return { ok: false, step: "link", log: linked.log };
    const program = /** @type {Uint8Array<ArrayBuffer>} */ (linked.files["program.wasm"]);
    return { ok: true, program, log: compiled.log };
  }
}
