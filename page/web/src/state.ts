// A figure's state as the part of the address after #, so that a link shows what its sender saw:
//
//   #figure=01_planes/segment_plane&start=0,1,2.5&offset=0.5&eye=30,20
//
// Numbers are written in full (shortest text that reads back as the same double). Fields that the
// link leaves out keep their initial value; anything that does not fit the figure is ignored.

import type { Field, Fields, FieldValue } from "./layout.ts";

export interface LinkedState {
  readonly fields: Fields;
  /** Azimuth and elevation of the eye, degrees, in a 3D figure that was turned. */
  readonly eye?: readonly [number, number];
}

const plain = (value: number): string => String(value).replace("e+", "e");

export function encodeState(
  figure: string,
  fields: Fields,
  eye?: readonly [number, number],
): string {
  const parts = Object.entries(fields).map(([name, value]) => {
    const list = typeof value === "number" ? [value] : value;
    return `${encodeURIComponent(name)}=${list.map(plain).join(",")}`;
  });
  if (eye) parts.push(`eye=${eye.map((angle) => angle.toFixed(1)).join(",")}`);
  return `#figure=${figure}&${parts.join("&")}`;
}

export function decodeState(
  fragment: string,
  figure: string,
  layout: readonly Field[],
): LinkedState | undefined {
  const entries = fragment
    .replace(/^#/, "")
    .split("&")
    .map((part) => part.split("=", 2).map(decode));
  if (entries[0]?.[0] !== "figure" || entries[0][1] !== figure) return undefined;
  const fields: Record<string, FieldValue> = {};
  let eye: [number, number] | undefined;
  for (const [name, text] of entries.slice(1)) {
    const numbers = (text ?? "")
      .split(",")
      .map((part) => (part === "" ? Number.NaN : Number(part)));
    if (!numbers.every(Number.isFinite)) continue;
    const field = layout.find((known) => known.name === name);
    if (field && numbers.length === field.size)
      fields[field.name] = field.size === 1 ? numbers[0]! : numbers;
    else if (name === "eye" && numbers.length === 2) eye = [numbers[0]!, numbers[1]!];
  }
  return eye ? { fields, eye } : { fields };
}

function decode(text: string): string {
  try {
    return decodeURIComponent(text);
  } catch {
    return "";
  }
}
