// A figure's C++ in WebAssembly, with its fields as the drawing code wants them: one number plain,
// several as a list, and no field that there is not.

import { loadFigure, type Source } from "../../wasm/loader.ts";
import { type Engine, flatten, unflatten } from "./layout.ts";

export async function startEngine(source: Source): Promise<Engine> {
  const figure = await loadFigure(source);
  const { layout } = figure;
  return {
    layout,
    ready: () => figure.ready(),
    compute(input) {
      const given: Record<string, number[]> = {};
      for (const field of layout.inputs) given[field.name] = flatten([field], input);
      const found = figure.compute(given);
      return unflatten(
        layout.outputs,
        layout.outputs.flatMap(({ name }) => found[name] ?? []),
      );
    },
  };
}
