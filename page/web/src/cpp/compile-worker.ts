// Clang and LLD, loaded once and kept warm. It compiles one file at a time and links it with the exercise's tests.

import { Downloads, inWords, opened, openStore } from "./download.ts";
import type {
  Build,
  Built,
  FromCompiler,
  Modules,
  NotBuilt,
  Scope,
  ToCompiler,
} from "./messages.ts";
import { CheckerError, type Manifest } from "./types.ts";

type Bytes = Uint8Array<ArrayBuffer>;
type Tree = { [name: string]: Tree | string | Bytes };

/** The compiler's program as corrected by page/wasm/compiler.mjs. */
interface Llvm {
  start(parts: { modules: Modules; files: Tree }): Promise<void>;
  openTar(tar: ArrayBuffer): Tree;
  runLLVM(args: readonly string[], files: Tree, options: object): Tree;
  readonly Exit: new (...args: never[]) => Error;
}

const scope = globalThis as unknown as Scope<ToCompiler, FromCompiler>;
const post = (message: FromCompiler, transfer: Transferable[] = []): void =>
  scope.postMessage(message, transfer);

let turn = Promise.resolve();

// One after the other: a build that follows the precompiled header waits until that is opened.
scope.onmessage = ({ data }) => {
  turn = turn
    .then(() => handle(data))
    .catch((error: unknown) => {
      const sentence = error instanceof CheckerError ? error.message : "";
      post({
        kind: "failed",
        sentence,
        why: error instanceof Error ? error.message : String(error),
      });
    });
};

let compiler: Compiler | undefined;

async function handle(message: ToCompiler): Promise<void> {
  if (message.kind === "start") {
    compiler = await Compiler.start(message.folder, message.manifest, message.modules);
    post({ kind: "started", modules: compiler.modules, prelude: compiler.hasPrelude });
    return;
  }
  if (!compiler) throw new Error("the compiler has not been started");
  if (message.kind === "prelude") {
    await compiler.takePrelude(message.blob);
    post({ kind: "prelude" });
  } else if (message.kind === "warm") {
    compiler.warm();
    post({ kind: "warm" });
  } else {
    const result = compiler.build(message.build);
    post({ kind: "done", result }, result.ok ? [result.program.buffer] : []);
  }
}

/** The compiler's program as a module. A page that was opened from a file may import a data: address alone. */
async function imported(program: Bytes): Promise<Llvm> {
  const blob = new Blob([program], { type: "text/javascript" });
  if ("contactSavedFrom" in globalThis) {
    const text = encodeURIComponent(await blob.text());
    return (await import(`data:text/javascript,${text}`)) as Llvm;
  }
  const address = URL.createObjectURL(blob);
  try {
    return (await import(address)) as Llvm;
  } finally {
    URL.revokeObjectURL(address);
  }
}

class Compiler {
  readonly modules: Modules;
  readonly #llvm: Llvm;
  readonly #manifest: Manifest;
  readonly #downloads: Downloads;
  readonly #checks: Bytes;
  #prelude: Bytes | undefined;

  private constructor(
    llvm: Llvm,
    modules: Modules,
    checks: Bytes,
    manifest: Manifest,
    downloads: Downloads,
  ) {
    this.#llvm = llvm;
    this.modules = modules;
    this.#checks = checks;
    this.#manifest = manifest;
    this.#downloads = downloads;
  }

  /** Loads everything at once, so that one file is opened and compiled while another arrives. */
  static async start(
    folder: string,
    manifest: Manifest,
    known: Modules | undefined,
  ): Promise<Compiler> {
    const surroundings = { fetch: globalThis.fetch.bind(globalThis), store: await openStore() };
    const downloads = new Downloads(folder, surroundings);
    const arrived = (bytes: number) => post({ kind: "arrived", bytes });
    const file = (key: string) => {
      const shipped = manifest.files[key];
      if (!shipped) throw new Error(`the manifest has no ${key}`);
      return shipped;
    };
    const bytes = (key: string) => downloads.bytes(file(key), { arrived });
    const module = async (key: string): Promise<[string, WebAssembly.Module]> => {
      const before = known?.[key];
      if (before) return [key, before];
      try {
        const response = await opened(
          await downloads.file(file(key), { arrived }),
          "application/wasm",
        );
        return [key, await WebAssembly.compileStreaming(response)];
      } catch (error) {
        throw inWords(error);
      }
    };
    const names = Object.keys(manifest.files).filter((key) => /^llvm.*\.wasm$/.test(key));
    const prelude = manifest.files["prelude.pch"];
    const [program, tar, checks, kept, ...modules] = await Promise.all([
      bytes("compiler.js"),
      bytes("system.tar"),
      bytes("checks.o"),
      prelude &&
        downloads.isKept(prelude).then((is) => (is ? downloads.bytes(prelude) : undefined)),
      ...names.map(module),
    ]);
    post({ kind: "opening" });
    const llvm = await imported(program);
    const made = Object.fromEntries(modules);
    await llvm.start({ modules: made, files: llvm.openTar(tar.buffer) });
    const compiler = new Compiler(llvm, made, checks, manifest, downloads);
    compiler.#prelude = kept;
    return compiler;
  }

  get hasPrelude(): boolean {
    return this.#prelude !== undefined;
  }

  async takePrelude(blob: Blob | undefined): Promise<void> {
    const file = this.#manifest.files["prelude.pch"];
    if (this.#prelude || !file) return;
    this.#prelude = blob
      ? new Uint8Array(await (await opened(new Response(blob))).arrayBuffer())
      : await this.#downloads.bytes(file);
  }

  build({ exercise, files, source, tests }: Build): Built | NotBuilt {
    const began = performance.now();
    const name = exercise.slice(exercise.indexOf("/") + 1);
    const compiled = this.#compile(`${name}.cpp`, `exercises/${exercise}`, files, source);
    const compile = seconds(began);
    const { log } = compiled;
    if (!compiled.result) return { ok: false, step: "compile", log, defined: [], compile, link: 0 };
    post({ kind: "linking" });
    const caller = typeof tests === "string" ? this.#caller(exercise, files, tests) : tests;
    if (typeof caller === "string") throw new Error(`the call from a figure: ${caller}`);
    const called = typeof tests === "string" ? ["--wrap=_ZN7contact4todoEv"] : [];
    const linked = this.#link(compiled.result, caller, called);
    const link = seconds(began) - compile;
    if (linked.result)
      return { ok: true, program: linked.result, log, compile, link, prelude: this.hasPrelude };
    const defined = this.#definedIn(compiled.result);
    return { ok: false, step: "link", log: linked.log, defined, compile, link };
  }

  /** Compiles and links a file like those that come. */
  warm(): void {
    const { result } = this.#compile("warm.cpp", ".", {}, WARMING);
    if (!result) return;
    const objects: Tree = { "answer.o": result, "checks.o": this.#checks };
    this.#run(this.#linkArguments(Object.keys(objects)), objects, "program.wasm");
  }

  #compile(file: string, folder: string, files: Build["files"], source: string): Ran {
    const { flags, withPrelude, include, diagnostics } = this.#manifest.compile;
    const tree: Tree = {};
    for (const [path, text] of Object.entries(files))
      if (path.endsWith(".hpp")) put(tree, path, text);
    tree[file] = source;
    if (this.#prelude) tree["prelude.pch"] = this.#prelude;
    const prelude = this.#prelude ? withPrelude : [];
    const search = ["-I", `/${folder}`, ...include];
    const output = ["-emit-obj", "-main-file-name", file, "-o", "answer.o", "-x", "c++", file];
    const ran = this.#run(
      [...flags, ...diagnostics, ...search, ...prelude, ...output],
      tree,
      "answer.o",
    );
    if (ran.result || ran.log.includes("error:")) return ran;
    return { result: undefined, log: `${ran.log}${file}:1:1: fatal error: ${ran.why}\n` };
  }

  /** Of each exercise the last source that calls it, compiled: it changes with the book alone. */
  readonly #callers = new Map<string, { source: string; object: Bytes }>();

  /** The object, or what the compiler has against it. */
  #caller(exercise: string, files: Build["files"], source: string): Bytes | string {
    const known = this.#callers.get(exercise);
    if (known?.source === source) return known.object;
    const { result, log } = this.#compile("caller.cpp", `exercises/${exercise}`, files, source);
    if (!result) return log;
    this.#callers.set(exercise, { source, object: result });
    return result;
  }

  #link(answer: Bytes, tests: Bytes, more: readonly string[]): Ran {
    const objects: Tree = { "answer.o": answer, "tests.o": tests, "checks.o": this.#checks };
    const names = [...more, ...Object.keys(objects)];
    return this.#run(this.#linkArguments(names), objects, "program.wasm");
  }

  #linkArguments(objects: readonly string[]): string[] {
    const { before, after } = this.#manifest.link;
    return [...before, ...objects, ...after, "-o", "program.wasm"];
  }

  /** As `nm --demangle --defined-only --extern-only` says: "00000000 T exercise::plane(int)". */
  #definedIn(object: Bytes): string[] {
    const options = ["--demangle", "--defined-only", "--extern-only"];
    const { log } = this.#run(["nm", ...options, "answer.o"], { "answer.o": object }, "");
    return log.split("\n").flatMap((line) => / T (.*)$/.exec(line)?.[1] ?? []);
  }

  #run(args: readonly string[], files: Tree, wanted: string): Ran {
    const decoder = new TextDecoder();
    let log = "";
    const write = (bytes: Bytes | null): void => {
      if (bytes) log += decoder.decode(bytes, { stream: true });
    };
    const options = { synchronously: true, decodeASCII: false, stdout: write, stderr: write };
    try {
      const result = this.#llvm.runLLVM(args, files, options)[wanted];
      return { result: result instanceof Uint8Array ? result : undefined, log };
    } catch (error) {
      // An Exit is the compiler's "no"; anything else is its own end, of which only the words are kept: the rest
      // holds on to the whole tree of files.
      if (error instanceof this.#llvm.Exit) return { result: undefined, log };
      const why = `the compiler gave up (${error instanceof Error ? error.message : String(error)})`;
      return { result: undefined, log, why };
    }
  }
}

/** What an exercise's answer is made of. */
const WARMING = `#include <contact/prelude.hpp>
namespace {
std::optional<double> across(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  const Eigen::Vector3d c = a.cross(b);
  if (c.squaredNorm() == 0) return std::nullopt;
  const double t = c.normalized().dot(b - 2 * a) / std::sqrt(a.norm());
  if (!(t >= 0 && t <= 1)) return std::nullopt;
  return t;
}
}  // namespace
std::array<double, 3> warmed(const std::vector<Eigen::Vector3d>& points) {
  std::array<double, 3> sums{};
  for (const auto& p : points)
    for (int i = 0; i < 3; ++i) sums[static_cast<std::size_t>(i)] += across(p, points[0]).value_or(p[i]);
  if (points.empty()) throw std::invalid_argument("no points");
  std::sort(sums.begin(), sums.end());
  return sums;
}
`;

interface Ran {
  readonly result: Bytes | undefined;
  readonly log: string;
  /** How the tool itself came to an end, if it said nothing about the file. */
  readonly why?: string;
}

function put(tree: Tree, path: string, text: string): void {
  const parts = path.split("/");
  const name = parts.pop() ?? "";
  let folder = tree;
  for (const part of parts) {
    folder[part] ??= {};
    folder = folder[part] as Tree;
  }
  folder[name] = text;
}

const seconds = (since: number): number => (performance.now() - since) / 1000;
