// The thread in which a reader's function answers for a figure: it is ended when it never answers.

import { ConsoleStdout, File, OpenFile, WASI } from "@bjorn3/browser_wasi_shim";
import { trapText } from "../../../wasm/test_program.mjs";
import type { Scope } from "./messages.ts";

export type ToMine =
  | { readonly kind: "program"; readonly program: WebAssembly.Module }
  | { readonly kind: "given"; readonly numbers: readonly number[] };

export type FromMine =
  | { readonly kind: "ready" }
  | { readonly kind: "found"; readonly numbers: readonly number[] }
  | { readonly kind: "not_written" }
  | { readonly kind: "thrown"; readonly words: string }
  | { readonly kind: "stopped"; readonly why: string };

interface Exports {
  readonly memory: WebAssembly.Memory;
  contact_mine_start(): void;
  contact_mine_given(): number;
  contact_mine_found(): number;
  contact_mine_words(): number;
  contact_mine_answer(): number;
}

const scope = globalThis as unknown as Scope<ToMine, FromMine>;
let program: WebAssembly.Module | undefined;
let exports: Exports | undefined;
let printed = "";

scope.onmessage = ({ data }) => {
  try {
    if (data.kind === "program") {
      program = data.program;
      exports = start(program);
      scope.postMessage({ kind: "ready" });
    } else {
      scope.postMessage(answer(data.numbers));
    }
  } catch (error) {
    // Its memory may be in any state: the next question goes to a new instance.
    exports = undefined;
    scope.postMessage({ kind: "stopped", why: trapText(error, printed) });
  }
};

function start(module: WebAssembly.Module): Exports {
  printed = "";
  const decoder = new TextDecoder();
  const errors = new ConsoleStdout((bytes) => {
    printed = (printed + decoder.decode(bytes, { stream: true })).slice(-4000);
  });
  const files = [new OpenFile(new File([])), new ConsoleStdout(() => {}), errors];
  const wasi = new WASI([], [], files, { debug: false });
  const instance = new WebAssembly.Instance(module, { wasi_snapshot_preview1: wasi.wasiImport });
  wasi.inst = instance as unknown as typeof wasi.inst;
  const made = instance.exports as unknown as Exports;
  made.contact_mine_start();
  return made;
}

function answer(numbers: readonly number[]): FromMine {
  if (!program) throw new Error("there is no program");
  exports ??= start(program);
  const { memory } = exports;
  new Float64Array(memory.buffer, exports.contact_mine_given(), numbers.length).set(numbers);
  const count = exports.contact_mine_answer();
  if (count === -1) return { kind: "not_written" };
  if (count < 0) {
    const bytes = new Uint8Array(memory.buffer);
    const at = exports.contact_mine_words();
    const words = new TextDecoder().decode(bytes.slice(at, bytes.indexOf(0, at)));
    return { kind: "thrown", words };
  }
  const found = new Float64Array(memory.buffer, exports.contact_mine_found(), count);
  return { kind: "found", numbers: [...found] };
}
