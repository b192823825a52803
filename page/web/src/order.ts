// The logic of questions, apart from their elements.

import { parseNumber } from "./numbers.ts";

/** The list with the item at `from` moved to `to`; the others keep their order. */
export function moved<T>(items: readonly T[], from: number, to: number): T[] {
  const left = [...items];
  const [item] = left.splice(from, 1);
  if (item === undefined) return left;
  left.splice(Math.max(0, Math.min(left.length, to)), 0, item);
  return left;
}

/** How many items from the start are where they belong. */
export function rightFromStart(given: readonly number[], answer: readonly number[]): number {
  const first = given.findIndex((item, i) => item !== answer[i]);
  return first < 0 ? given.length : first;
}

export interface Quantity {
  readonly value: number;
  readonly unit: string;
}

/** "−1.5 m/s" as a number and a unit; nothing if it does not begin with a number. */
export function parseQuantity(text: string): Quantity | undefined {
  const match = /^\s*([-+−–]?[\d.]+(?:[eE][-+]?\d+)?(?:\s*\/\s*\d+\.?\d*)?)\s*(.*?)\s*$/.exec(text);
  const value = match && parseNumber(match[1]!);
  return value === undefined || value === null ? undefined : { value, unit: match![2]! };
}

const RAISED: Record<string, string> = { "⁻": "-", "¹": "1", "²": "2", "³": "3", "⁴": "4" };

/**
 * A unit in one way of writing, so that m/s², m s^-2 and m·s⁻² are the same: its factors with
 * their powers, in order.
 */
export function sameUnit(one: string, other: string): boolean {
  return canonicalUnit(one) === canonicalUnit(other);
}

function canonicalUnit(text: string): string {
  const plain = text
    .replace(/[⁻¹²³⁴]+/g, (raised) => `^${[...raised].map((c) => RAISED[c]).join("")}`)
    .replaceAll("°", " deg ")
    .replace(/degrees?/g, "deg")
    .replace(/[·⋅*×]/g, " ")
    .replace(/\s*\/\s*/g, " /")
    .replaceAll("−", "-")
    .trim();
  const powers = new Map<string, number>();
  for (const part of plain.split(/\s+/).filter((piece) => piece !== "" && piece !== "1")) {
    const match = /^(\/?)([^\d^]+)\^?(-?\d+)?$/.exec(part);
    if (!match) return text.trim();
    const power = Number(match[3] ?? 1) * (match[1] ? -1 : 1);
    powers.set(match[2]!, (powers.get(match[2]!) ?? 0) + power);
  }
  return [...powers]
    .map(([name, power]) => `${name}^${power}`)
    .sort()
    .join(" ");
}
