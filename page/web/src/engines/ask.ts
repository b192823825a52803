// Asks one engine one question, and compares its answer with the exact one.

import type { Adapter, Answer, Engine, Question, Settings } from "./types.ts";

/** Settings of an engine that simulates nothing. */
const NOTHING: Settings = { step: 1 / 60, iterations: 1, continuous: false, strict: false };

export const defaultsOf = (adapter: Adapter): Settings => adapter.defaults ?? NOTHING;

/** The exact answer for an engine of the plane or of space. */
export const exactFor = (question: Question, dimension: 2 | 3): Question["exact"] =>
  dimension === 2 ? (question.exact2 ?? question.exact) : question.exact;

/** Undefined: the engine does not answer this. */
export function ask(
  question: Question,
  adapter: Adapter,
  engine: Engine,
  settings: Settings,
): Answer | undefined {
  if (adapter.dimension === 2 && !question.planar) return undefined;
  const start = performance.now();
  const done = (value: number, failed?: string): Answer => {
    const { value: exact } = exactFor(question, adapter.dimension);
    const time = performance.now() - start;
    return { value, error: Math.abs(value - exact), time, ...(failed && { failed }) };
  };
  try {
    const value = question.ask(engine, settings);
    return value === undefined ? undefined : done(value);
  } catch (error) {
    return done(Number.NaN, error instanceof Error ? error.message : String(error));
  }
}

/** Steps and multiples of the default iterations that are tried for the best settings. */
const STEPS = [1 / 60, 1 / 240, 1 / 480];
const TIMES = [1, 4];

/** The settings of which the best are recorded: with continuous detection and without thresholds. */
export function candidates(question: Question, adapter: Adapter): readonly Settings[] {
  const { iterations } = defaultsOf(adapter);
  const sharp = { continuous: true, strict: true };
  if (question.duration === undefined) return [{ step: 1 / 60, iterations, ...sharp }];
  return STEPS.flatMap((step) =>
    TIMES.map((times) => ({ step, iterations: times * iterations, ...sharp })),
  );
}

export interface Best {
  readonly answer: Answer;
  readonly settings: Settings;
}

/** The candidate with the least error; if two are equal, the cheaper one. */
export function best(question: Question, adapter: Adapter, engine: Engine): Best | undefined {
  let found: Best | undefined;
  for (const settings of candidates(question, adapter)) {
    const answer = ask(question, adapter, engine, settings);
    if (!answer) return undefined;
    if (!found || answer.error < found.answer.error || Number.isNaN(found.answer.error))
      found = { answer, settings };
  }
  return found;
}
