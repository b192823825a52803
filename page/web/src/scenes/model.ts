// What the player shows, without the page: which effects are switched, what the plan says in words,
// and what the numbers beside the picture are.

import { pretty } from "../numbers.ts";
import type { Composition, Decision, Frame, Opened, Overrides, Plan, Side } from "./messages.ts";

/** An effect as a row of the table. */
export interface Row {
  readonly effect: string;
  /** "on", "off", or a value: "0.004 s". */
  readonly planned: string;
  /** The same in the second run; as planned if there is none. */
  readonly beside: string;
  /** The state of the switch; nothing where there is none. */
  readonly on: boolean | undefined;
  readonly overridden: boolean;
  readonly why: string;
  readonly says: readonly string[];
  /** The error accepted and the cost, in words. */
  readonly account: string;
}

/** A quantity of both runs. */
export interface Quantity {
  readonly name: string;
  readonly values: readonly string[];
}

/** Pictures over which the cost is averaged. */
const WINDOW = 40;

const seconds = (value: number): string => `${pretty(value)} s`;

function stateOf(decision: Decision, on: boolean): string {
  return decision.value !== null && on ? seconds(decision.value) : on ? "on" : "off";
}

function errorOf({ error, error_is }: Decision): string {
  if (error === null) return `Error accepted: no bound, ${error_is}.`;
  return error > 0
    ? `Error accepted: ${pretty(error, 3)} m, ${error_is}.`
    : "Error accepted: none.";
}

function costOf({ changes_nothing, instructions, instructions_are, planned }: Decision): string {
  if (changes_nothing) return `Switching it changes nothing here: ${changes_nothing}.`;
  if (instructions_are === "") return "";
  if (!instructions) return `${planned ? "Costs" : "Saves"} ${instructions_are}.`;
  const costs = planned === instructions > 0;
  const count = `about ${pretty(Math.abs(instructions), 3)} instructions`;
  return `${costs ? "Costs" : "Saves"} ${count}: ${instructions_are}.`;
}

export function isMade(side: Side | undefined): side is Composition & { readonly plan?: Plan } {
  return side !== undefined && !("refused" in side);
}

export class PlayerModel {
  opened: Opened | undefined;
  sides: readonly Side[] = [];
  frames: readonly Frame[] = [];
  /** Of the last pictures: the time of each run, and its computing since its beginning in ms. */
  #past: { readonly times: readonly number[]; readonly took: readonly number[] }[] = [];
  step: number | undefined;
  readonly #switched = new Map<string, boolean>();

  /** Another scene, or the same from the beginning. */
  open(opened: Opened): void {
    this.opened = opened;
  }

  /** Both runs are at their beginning. */
  begin(sides: readonly Side[], frames: readonly Frame[]): void {
    this.sides = sides;
    this.#past = [];
    this.show(
      frames,
      sides.map(() => 0),
    );
  }

  /** Both runs have come to a moment. @param took ms of computing by each since its beginning */
  show(frames: readonly Frame[], took: readonly number[]): void {
    this.frames = frames;
    const times: number[] = [];
    for (const { side, time } of frames) times[side] = time;
    this.#past = [...this.#past, { times, took }].slice(-WINDOW);
  }

  /** ms of computing for one second of the scene, lately: a browser's code is slow at first. */
  cost(side: number): number | undefined {
    const [from, to] = [this.#past[0], this.#past.at(-1)];
    const time = (to?.times[side] ?? 0) - (from?.times[side] ?? 0);
    return time > 0 ? (to!.took[side]! - from!.took[side]!) / time : undefined;
  }

  /** Nothing is switched any more. */
  forget(): void {
    this.#switched.clear();
    this.step = undefined;
  }

  get isOverridden(): boolean {
    return this.#switched.size > 0 || this.step !== undefined;
  }

  get overrides(): Overrides {
    const names = (on: boolean): string[] =>
      [...this.#switched].filter(([, is]) => is === on).map(([name]) => name);
    const step = this.step === undefined ? {} : { step: this.step };
    return { with: names(true), without: names(false), ...step };
  }

  /** Switches an effect; back to what the plan says is no override. */
  set(effect: string, on: boolean): void {
    const planned = this.opened?.plan.decisions.find((each) => each.effect === effect)?.planned;
    if (on === planned) this.#switched.delete(effect);
    else this.#switched.set(effect, on);
  }

  /** The plan of the second run, if there is one, else the first's. */
  get plan(): Plan | undefined {
    return this.sides[1]?.plan ?? this.opened?.plan;
  }

  rows(): Row[] {
    const beside = this.plan?.decisions ?? [];
    return (this.opened?.plan.decisions ?? []).map((decision, i) => ({
      effect: decision.effect,
      planned: stateOf(decision, decision.planned),
      beside: stateOf(beside[i] ?? decision, (beside[i] ?? decision).on),
      on: decision.switched
        ? (this.#switched.get(decision.effect) ?? beside[i]?.on ?? decision.on)
        : undefined,
      overridden: this.#switched.has(decision.effect),
      why: decision.why,
      says: decision.says,
      account: `${errorOf(decision)} ${costOf(decision)}`.trim(),
    }));
  }

  /** The errors that a plan accepts beside its tolerance; of both runs, where they differ. */
  accounts(): string[] {
    const first = this.opened?.plan.accepted;
    const second = this.plan?.accepted;
    if (first === undefined) return [];
    if (second === undefined || second === first) return [first];
    return [`As planned: ${first}`, `As you switch it: ${second}`];
  }

  /** A run is composed of something else now. */
  composed(side: number, composition: Composition): void {
    const { plan } = this.sides[side] ?? {};
    this.sides = this.sides.map((each, i) =>
      i !== side ? each : plan ? { ...composition, plan } : composition,
    );
  }

  /** Of what the runs are composed, a sentence each. */
  compositions(): string[] {
    return this.sides.flatMap((side, i): string[] => {
      if (!isMade(side)) return [];
      const stages = side.stages.map(({ name, detail }) => (detail ? `${name} (${detail})` : name));
      const name = i === 0 ? "As planned" : "As switched";
      const { fallback } = side;
      const why = fallback
        ? ` From t = ${seconds(fallback.time)} on it goes step by step: ${fallback.why}.`
        : "";
      return [`${name}: ${stages.join(", ")}.${why}`];
    });
  }

  get time(): number {
    return Math.min(...this.frames.map(({ time }) => time), this.opened?.scene.duration ?? 0);
  }

  /** The quantities beside the picture, for each run. */
  quantities(): Quantity[] {
    const { frames } = this;
    const row = (name: string, value: (frame: Frame) => string): Quantity => ({
      name,
      values: frames.map(value),
    });
    const whole = (value: number): string => value.toLocaleString("en");
    const all = [
      row("goes", ({ eventDriven, side }) => {
        const run = this.sides[side];
        return eventDriven || !isMade(run)
          ? "from event to event"
          : `in steps of ${seconds(run.step)}`;
      }),
      row("hits", ({ hits }) => whole(hits)),
    ];
    if (frames.some(({ steps }) => steps > 0)) {
      all.push(row("steps", ({ steps }) => whole(steps)));
      all.push(row("contacts solved", ({ contacts }) => whole(contacts)));
    }
    all.push(
      row("computing for one second of the scene", ({ side }) => {
        const cost = this.cost(side);
        return cost === undefined ? "–" : `${pretty(cost, 3)} ms`;
      }),
      row("state of a body", ({ bytesPerBody }) => `${whole(bytesPerBody)} bytes`),
      row("energy", ({ energy }) => `${pretty(energy)} J`),
      row("energy change", (frame) => energyChange(frame)),
    );
    return all;
  }

  /** How far the runs are apart: the error, if one of them is right. */
  apart(): string {
    const frame = this.frames.find(({ side }) => side === 1);
    if (!frame || this.frames.length < 2) return "";
    const name = this.opened?.scene.bodies[frame.farthest]?.name;
    const { tolerance = null } = this.opened?.scene ?? {};
    if (frame.apart === 0 || name === undefined)
      return "The positions of the two runs are the same so far, bit for bit.";
    const than =
      tolerance === null
        ? ""
        : frame.apart <= tolerance
          ? `, within the tolerance of ${pretty(tolerance)} m`
          : `, more than the tolerance of ${pretty(tolerance)} m`;
    return `The two runs are ${pretty(frame.apart, 3)} m apart at most (${name})${than}.`;
  }
}

export function energyChange({ energy, firstEnergy }: Frame): string {
  const change = energy - firstEnergy;
  const share =
    firstEnergy === 0 ? "" : ` (${pretty((100 * change) / Math.abs(firstEnergy), 3)} %)`;
  return `${pretty(change, 3)} J${share}`;
}
