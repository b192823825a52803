// Numbers with units, as a reader types them. grading/text/units.json lists the units, and
// grading/text/quantity.cpp reads the same for `contact ask`; tests/cli/support/quantities.json has cases
// that both must answer alike.

import UNITS from "../../../grading/text/units.json";
import { parseNumber } from "./numbers.ts";

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

/** The factors of a unit with their powers: m/s², m s^-2 and m·s⁻² give the same. */
function factors(text: string): [name: string, power: number][] {
  const plain = text
    .replace(/[⁻¹²³⁴]+/g, (raised) => `^${[...raised].map((c) => RAISED[c]).join("")}`)
    .replaceAll("°C", " degC ")
    .replaceAll("°", " deg ")
    .replace(/degrees?/g, "deg")
    .replaceAll("μ", "µ")
    .replace(/[·⋅*×]/g, " ")
    .replace(/\s*\/\s*/g, " /")
    .replaceAll("−", "-")
    .trim();
  const found: [string, number][] = [];
  for (const part of plain.split(/\s+/).filter((piece) => piece !== "" && piece !== "1")) {
    const match = /^(\/?)([^\d^/-]+)(?:\^?(-?\d+))?$/.exec(part);
    // What is not written as a unit is one unit of its own, which no other equals.
    if (!match) return [[text.trim(), 1]];
    found.push([match[2]!, Number(match[3] ?? 1) * (match[1] ? -1 : 1)]);
  }
  return found;
}

interface Measure {
  readonly factor: number;
  /** Of the units that no other is made of. */
  readonly powers: string;
}

function measure(text: string, table: Record<string, readonly (number | string)[]>): Measure {
  let factor = 1;
  const powers = new Map<string, number>();
  for (const [name, power] of factors(text)) {
    const [size, of] = (Object.hasOwn(table, name) ? table[name]! : [1, name]) as [number, string];
    factor *= size ** power;
    for (const [base, exponent] of of === name ? ([[name, 1]] as const) : factors(of))
      powers.set(base, (powers.get(base) ?? 0) + exponent * power);
  }
  const sorted = [...powers].filter(([, power]) => power !== 0).map((pair) => pair.join("^"));
  return { factor, powers: sorted.sort().join(" ") };
}

/** Whether these are the same unit, written in one way or another. */
export function sameUnit(one: string, other: string): boolean {
  return measure(one, {}).powers === measure(other, {}).powers;
}

/** The number that this quantity has in another unit; nothing if that measures something else. */
export function inUnit({ value, unit }: Quantity, wanted: string): number | undefined {
  if (sameUnit(unit, wanted)) return value;
  const [from, to] = [measure(unit, UNITS), measure(wanted, UNITS)];
  return from.powers === to.powers ? (value * from.factor) / to.factor : undefined;
}
