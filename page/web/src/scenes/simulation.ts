// The scene player's C++ with its replies as objects. In a worker of the page, and in Node.

import { Program, type Source } from "../../../wasm/loader.ts";
import type { Composition, Frame, Opened, Overrides, Side } from "./messages.ts";

interface Functions {
  player_room(bytes: number): number;
  player_answer(request: number, bytes: number): number;
  player_advance(side: number, until: number, budget: number): number;
  player_frame(side: number): number;
  player_numbers(): number;
}

/** How an advance ended. */
export const REACHED = 0;
export const MORE = 1;
export const STUCK = 2;

/** Numbers of a frame before its bodies, in the order of player.cpp. */
const HEAD = 15;

export class Simulation {
  readonly #program: Program<Functions>;

  private constructor(program: Program<Functions>) {
    this.#program = program;
  }

  static async start(source: Source): Promise<Simulation> {
    return new Simulation(await Program.start<Functions>(source));
  }

  /** The scene and its plan, with both runs at their beginning, or what is wrong with the text. */
  open(text: string, file: string, overrides: Overrides): Opened | { readonly wrong: string } {
    return this.#ask({ do: "open", text, file, ...overrides });
  }

  /** Both runs from the beginning again: as planned, and as switched if anything is. */
  switch(overrides: Overrides): readonly Side[] {
    return this.#ask<{ sides: Side[] }>({ do: "switch", ...overrides }).sides;
  }

  composition(side: number): Composition {
    return this.#ask({ do: "composition", side });
  }

  /** Why a run is stuck. */
  trouble(): string {
    return this.#ask({ do: "trouble" });
  }

  /** Runs until a time, for at most so many hits or steps. */
  advance(side: number, until: number, budget: number): number {
    return this.#program.call((player) => player.player_advance(side, until, budget));
  }

  /** Where everything is now; nothing if there is no such run. */
  frame(side: number): Frame | undefined {
    const size = this.#program.call((player) => player.player_frame(side));
    if (size === 0) return undefined;
    const place = this.#program.call((player) => player.player_numbers());
    const numbers = this.#program.numbers(place, size).slice();
    const [time, energy, firstEnergy, steps, substeps, hits, pairs, contacts, rests] = numbers;
    const [largestOverlap, bytes, bytesPerBody, eventDriven, apart, farthest] = numbers.subarray(9);
    return {
      side,
      time: time!,
      energy: energy!,
      firstEnergy: firstEnergy!,
      steps: steps!,
      substeps: substeps!,
      hits: hits!,
      pairs: pairs!,
      contacts: contacts!,
      rests: rests!,
      largestOverlap: largestOverlap!,
      bytes: bytes!,
      bytesPerBody: bytesPerBody!,
      eventDriven: eventDriven === 1,
      apart: apart!,
      farthest: farthest!,
      bodies: numbers.slice(HEAD),
    };
  }

  #ask<Answer>(request: Record<string, unknown>): Answer {
    const bytes = new TextEncoder().encode(JSON.stringify(request));
    const place = this.#program.call((player) => {
      const room = player.player_room(bytes.length);
      new Uint8Array(player.memory.buffer).set(bytes, room);
      return player.player_answer(room, bytes.length);
    });
    const answer = JSON.parse(this.#program.text(place)) as { ok: Answer } | { error: string };
    if ("error" in answer) throw new Error(answer.error);
    return answer.ok;
  }
}
