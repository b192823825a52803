// Times of a figure's C++, measured in the page: the figure itself has no clock, so that its numbers
// are the same everywhere.

import type { Control } from "./figure.ts";
import type { Fields } from "./layout.ts";
import type { FigureModel } from "./model.ts";

/** A time is the least of several, until these have taken so many ms together. */
const ENOUGH = 30;
const MAX_CALLS = 20;

type Measure = Extract<Control<Fields>, { kind: "measure" }>;

/**
 * Measures the times one after the other, and shows each as it comes. It ends early if it is stopped, or if
 * the C++ stops.
 */
export async function measure(
  { field, run, repeats, setting }: Measure,
  model: FigureModel,
  stopped: () => boolean,
): Promise<void> {
  const count = model.size(field);
  model.set({ [field]: Array(count).fill(0), [setting.field]: model.output[setting.output] ?? 0 });
  const measured = model.input[setting.field];
  for (let i = 0; i < count; i++) {
    await new Promise((done) => setTimeout(done));
    // The reader may have chosen another setting meanwhile: the times would not belong together.
    const same =
      model.input[setting.field] === measured && model.output[setting.output] === measured;
    if (stopped() || !same) return;
    try {
      const ms = time(() => model.engine.compute({ ...model.input, [run]: 1 + i })[repeats]);
      model.setNumber(field, i, ms);
    } catch {
      return;
    }
  }
}

/** The ms of one repeat, rounded to a few digits, which fit into a link. */
function time(call: () => unknown): number {
  call(); // what is made once is made now
  let least = Number.POSITIVE_INFINITY;
  let total = 0;
  for (let calls = 0; calls < MAX_CALLS && total < ENOUGH; calls++) {
    const began = performance.now();
    const times = Number(call());
    const ms = performance.now() - began;
    total += ms;
    least = Math.min(least, ms / times);
  }
  return Number(least.toPrecision(3));
}
