// Asks the engines away from the page, so that it stays usable. Each engine is loaded when it is first asked.

import { book } from "./engines/adapters/book.ts";
import { ADAPTERS } from "./engines/adapters.ts";
import { ask, defaultsOf } from "./engines/ask.ts";
import type { Choice, FromWorker, ToWorker } from "./engines/messages.ts";
import { QUESTIONS } from "./engines/questions.ts";
import type { Adapter, Engine, Settings } from "./engines/types.ts";

const scope = globalThis as unknown as {
  onmessage: ((event: MessageEvent<ToWorker>) => void) | null;
  postMessage(message: FromWorker): void;
};

interface Loaded {
  readonly adapter: Adapter;
  readonly engine: Engine;
}

let loaded: readonly Loaded[] | undefined;

const reason = (error: unknown): string => (error instanceof Error ? error.message : String(error));

async function load(base: string): Promise<readonly Loaded[]> {
  const made: Loaded[] = [];
  const theBook = book(`${base}scenes/player.wasm`, `${base}engines/queries.wasm`);
  for (const get of [async () => theBook, ...ADAPTERS]) {
    let name = "an engine";
    try {
      const adapter = await get();
      name = adapter.id;
      scope.postMessage({ kind: "loading", engine: adapter.title });
      made.push({ adapter, engine: await adapter.load() });
    } catch (error) {
      scope.postMessage({ kind: "failed", engine: name, why: reason(error) });
    }
  }
  return made;
}

function chosen(adapter: Adapter, choice: Choice): Settings {
  const { step, iterations } = defaultsOf(adapter);
  return {
    step: choice.step ?? step,
    iterations: choice.iterations ?? iterations,
    continuous: choice.continuous,
    strict: choice.strict,
  };
}

async function answer({ base, questions, choice }: ToWorker): Promise<void> {
  loaded ??= await load(base);
  for (const question of QUESTIONS.filter(({ id }) => questions.includes(id)))
    for (const { adapter, engine } of loaded) {
      const settings = chosen(adapter, choice);
      const found = ask(question, adapter, engine, settings);
      scope.postMessage({
        kind: "answer",
        question: question.id,
        engine: adapter.id,
        answer: found,
        settings: question.duration === undefined ? undefined : settings,
      });
    }
  scope.postMessage({ kind: "done" });
}

scope.onmessage = ({ data }) => {
  answer(data).catch((error: unknown) => {
    scope.postMessage({ kind: "failed", engine: "the worker", why: reason(error) });
    scope.postMessage({ kind: "done" });
  });
};
