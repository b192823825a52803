// A figure's C++ in WebAssembly: four exports and two arrays of doubles.

import { type Engine, type Fields, flatten, type Layout, unflatten } from "./layout.ts";

interface Exports {
  readonly memory: WebAssembly.Memory;
  _initialize?(): void;
  layout(): number;
  input(): number;
  output(): number;
  compute(): void;
}

/** Links a compiled figure. It calls no system, so whatever it imports answers "not supported". */
export async function startEngine(module: WebAssembly.Module): Promise<Engine> {
  const imports: Record<string, Record<string, () => number>> = {};
  for (const { module: from, name } of WebAssembly.Module.imports(module)) {
    imports[from] ??= {};
    imports[from][name] = () => 52;
  }
  const instance = await WebAssembly.instantiate(module, imports);
  const figure = instance.exports as unknown as Exports;
  figure._initialize?.();
  const layout = readLayout(figure);
  const inputs = layout.inputs.reduce((sum, { size }) => sum + size, 0);
  const outputs = layout.outputs.reduce((sum, { size }) => sum + size, 0);
  return {
    layout,
    compute(input: Fields): Fields {
      const numbers = flatten(layout.inputs, input);
      new Float64Array(figure.memory.buffer, figure.input(), inputs).set(numbers);
      figure.compute();
      const result = new Float64Array(figure.memory.buffer, figure.output(), outputs);
      return unflatten(layout.outputs, result);
    },
  };
}

function readLayout(figure: Exports): Layout {
  const bytes = new Uint8Array(figure.memory.buffer, figure.layout());
  const text = new TextDecoder().decode(bytes.subarray(0, bytes.indexOf(0)));
  return JSON.parse(text) as Layout;
}

export async function fetchEngine(url: string): Promise<Engine> {
  const response = await fetch(url);
  if (!response.ok) throw new Error(`${url}: ${response.status}`);
  return startEngine(await WebAssembly.compile(await response.arrayBuffer()));
}
