// The state of one figure: its input, the output of its C++, and the listeners.

import type { AnyFigure } from "./figure.ts";
import { type Engine, type Fields, type FieldValue, type Layout, unflatten } from "./layout.ts";

export class FigureModel {
  readonly figure: AnyFigure;
  readonly engine: Engine;
  #input: Fields;
  #output: Fields;
  #problem = "";
  readonly #listeners: (() => void)[] = [];

  constructor(figure: AnyFigure, engine: Engine, fields: Fields = {}) {
    this.figure = figure;
    this.engine = engine;
    this.#input = { ...figure.initial, ...fields };
    this.#output = {};
    this.#compute();
  }

  get input(): Fields {
    return this.#input;
  }

  get output(): Fields {
    return this.#output;
  }

  /** Why there is no answer, as a clause; empty if there is one. */
  get problem(): string {
    return this.#problem;
  }

  size(field: string): number {
    return this.engine.layout.inputs.find(({ name }) => name === field)?.size ?? 0;
  }

  numbers(field: string): readonly number[] {
    const value = this.#input[field];
    return typeof value === "number" ? [value] : (value ?? []);
  }

  /** Changes some fields; the output is up to date when this returns. */
  set(fields: Fields): void {
    this.#input = { ...this.#input, ...fields };
    this.#compute();
    this.#tell();
  }

  setNumber(field: string, index: number, value: number): void {
    const numbers = this.numbers(field).map((old, i) => (i === index ? value : old));
    this.set({ [field]: this.size(field) === 1 ? (numbers[0] as FieldValue) : numbers });
  }

  reset(): void {
    this.set(this.figure.initial as Fields);
  }

  onChange(listener: () => void): void {
    this.#listeners.push(listener);
  }

  #tell(): void {
    for (const listener of this.#listeners) listener();
  }

  #compute(): void {
    const asked = this.#input;
    try {
      this.#output = this.engine.compute(this.#input);
      this.#problem = problemText(this.engine, this.#output);
    } catch (error) {
      this.#problem = error instanceof Error ? error.message : String(error);
      this.#output = unanswered(this.engine.layout);
      // The C++ starts afresh; if the reader has moved on meanwhile, ask it again.
      const again = (): void => {
        if (this.#input === asked) return;
        this.#compute();
        this.#tell();
      };
      this.engine.ready().then(again, () => {});
    }
  }
}

/** What is drawn from when the C++ stopped: no numbers, and a problem. */
function unanswered({ outputs }: Layout): Fields {
  const numbers = outputs.flatMap(({ name, size }) =>
    Array(size).fill(name === "problem" ? -1 : 0),
  );
  return unflatten(outputs, numbers);
}

function problemText(engine: Engine, output: Fields): string {
  const code = Number(output.problem);
  return code === 0 ? "" : (engine.layout.problems[code] ?? `problem ${code}`);
}

/** What the figure says of its state, in one sentence. */
export function sentence({ figure, input, output, problem }: FigureModel): string {
  return problem ? `There is no answer: ${problem}.` : figure.describe(input, output);
}
