// Runs scenes away from the page, a slice at a time, so that a request to do something else is heard
// between two slices.

import type { Frame, FromWorker, Overrides, ToWorker } from "./scenes/messages.ts";
import { MORE, Simulation, STUCK } from "./scenes/simulation.ts";

const SLICE = 15; // ms
/** More would keep the page busy with drawing. */
const MAX_BODIES = 20_000;

const scope = globalThis as unknown as {
  onmessage: ((event: MessageEvent<ToWorker>) => void) | null;
  postMessage(message: FromWorker, transfer?: Transferable[]): void;
};

let simulation: Simulation | undefined;
let made: boolean[] = [];
let took: number[] = [];
/** Whether each run went from event to event when it was last looked at. */
let driven: boolean[] = [];
let budgets: number[] = [];
/** Counts what was asked, so that a run that is no longer wanted ends. */
let turn = 0;

const breathing = new MessageChannel();
const breathe = (): Promise<void> =>
  new Promise((done) => {
    breathing.port1.onmessage = () => done();
    breathing.port2.postMessage(0);
  });

function frames(): Frame[] {
  return made.flatMap((there, side) => (there ? (simulation!.frame(side) ?? []) : []));
}

function begin(sides: readonly object[]): void {
  made = sides.map((side) => !("refused" in side));
  took = sides.map(() => 0);
  driven = sides.map((side) => "event_driven" in side && side.event_driven === true);
  budgets = sides.map(() => 16);
}

function send(message: FromWorker): void {
  const carried = "frames" in message ? message.frames.map(({ bodies }) => bodies.buffer) : [];
  scope.postMessage(message, carried as ArrayBuffer[]);
}

/** The last scene that was opened: it stays when the next is none. */
let last: readonly [text: string, file: string] | undefined;

function open(text: string, file: string, overrides: Overrides): void {
  const opened = simulation!.open(text, file, overrides);
  if ("wrong" in opened) {
    send({ kind: "wrong", lines: opened.wrong });
    return;
  }
  const bodies = opened.scene.bodies.length;
  if (bodies > MAX_BODIES) {
    if (last) simulation!.open(...last, { with: [], without: [] });
    const most = `the page draws at most ${MAX_BODIES}; contact simulate runs more`;
    const lines = `${file}: bodies: there are ${bodies}, and ${most}`;
    send({ kind: "wrong", lines });
    return;
  }
  last = [text, file];
  begin(opened.sides);
  send({ kind: "opened", opened, frames: frames() });
}

async function run(until: number): Promise<void> {
  const mine = turn;
  // What comes first after a pause is slower: each of the two in its turn.
  const order = turn % 2 === 0 ? [...made.keys()] : [...made.keys()].reverse();
  for (const side of order) {
    for (let more = made[side]; more; ) {
      const began = performance.now();
      const end = simulation!.advance(side, until, budgets[side]!);
      const ms = performance.now() - began;
      took[side]! += ms;
      // The budget follows what hits and steps of this scene cost.
      const scale = Math.min(4, Math.max(0.25, SLICE / Math.max(ms, 0.01)));
      budgets[side] = Math.min(1e6, Math.max(1, Math.round(budgets[side]! * scale)));
      if (end === STUCK) {
        send({ kind: "ended", side, words: simulation!.trouble(), frames: frames() });
        return;
      }
      more = end === MORE;
      if (more) await breathe();
      if (mine !== turn) return;
    }
  }
  const now = frames();
  for (const { side, eventDriven } of now) {
    if (eventDriven === driven[side]) continue;
    driven[side] = eventDriven;
    send({ kind: "composed", side, composition: simulation!.composition(side) });
  }
  send({ kind: "frame", frames: now, took: [...took] });
}

async function take(asked: ToWorker): Promise<void> {
  turn += 1;
  switch (asked.do) {
    case "load":
      simulation = await Simulation.start(asked.wasm);
      send({ kind: "loaded" });
      break;
    case "open":
      open(asked.text, asked.file, asked.overrides);
      break;
    case "switch": {
      const sides = simulation!.switch(asked.overrides);
      begin(sides);
      send({ kind: "switched", sides, frames: frames() });
      break;
    }
    case "run":
      await run(asked.until);
      break;
  }
}

scope.onmessage = ({ data }) => {
  take(data).catch((error: unknown) =>
    send({ kind: "broken", words: error instanceof Error ? error.message : String(error) }),
  );
};
