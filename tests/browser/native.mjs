// A figure's C++ as a native program, to compare with the page's WebAssembly.

import { spawnSync } from "node:child_process";
import { nativeFigure } from "../../page/wasm/native_figure.mjs";

/** @typedef {Record<string, number | number[]>} Fields */

/** JSON.stringify writes −0 as 0. @param {number} value */
const text = (value) => (Object.is(value, -0) ? "-0.0" : String(value));

/** @param {Fields} fields */
const line = (fields) =>
  `{${Object.entries(fields)
    .map(([name, value]) => `"${name}":[${[value].flat().map(text).join(",")}]`)
    .join(",")}}`;

const special = { nan: Number.NaN, inf: Infinity, "-inf": -Infinity };

/** @param {string} name "01_planes/segment_plane" @param {Fields[]} inputs @returns {Fields[]} */
export function native(name, inputs) {
  const program = nativeFigure(name);
  const input = `${inputs.map(line).join("\n")}\n`;
  const done = spawnSync(program, { input, encoding: "utf8", maxBuffer: 1 << 28 });
  if (done.status !== 0) throw new Error(`${program}: ${done.error?.message ?? done.stderr}`);
  return done.stdout
    .trim()
    .split("\n")
    .map((row) => {
      // A number as printed has 17 digits, and "-0" must stay negative.
      const fields = JSON.parse(row, (_key, value) =>
        typeof value === "string" && value in special
          ? special[/** @type {keyof typeof special} */ (value)]
          : value,
      );
      if (fields.error) throw new Error(`${name}: ${fields.error}`);
      for (const key of Object.keys(fields))
        if (fields[key].length === 1) fields[key] = fields[key][0];
      return fields;
    });
}

/** Pseudo-random numbers in [0, 1), the same every time. @param {number} seed */
export function random(seed) {
  let state = seed >>> 0;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
}

/**
 * Inputs of the same shape. A third are on a grid of quarters, some with a zero, so that edge cases occur. A third
 * keep most of the numbers and move some by up to about their size, since some figures answer nowhere else. A third
 * are halves, doubles and tens, since much of what a figure asks for is a ratio.
 * @param {Fields} like @param {number} count @param {number} seed @returns {Fields[]}
 */
export function inputsLike(like, count, seed) {
  const next = random(seed);
  const number = () => (next() < 0.15 ? 0 : Math.round((next() * 8 - 4) * 4) / 4);
  const near = (/** @type {number} */ start) => {
    if (next() < 0.7) return start;
    return Math.round((start + (2 * next() - 1) * Math.max(1, Math.abs(start))) * 4) / 4;
  };
  const ratio = (/** @type {number} */ start) => {
    const kind = next();
    if (kind < 0.3) return start;
    if (kind < 0.5) return 0;
    if (kind < 0.75) return kind < 0.6 ? start * 2 : start / 2;
    return 10 * Math.round(next() * 10);
  };
  const drawn = [
    (/** @type {number | number[]} */ value) =>
      Array.isArray(value) ? value.map(number) : Math.abs(number()),
    (/** @type {number | number[]} */ value) =>
      Array.isArray(value) ? value.map(near) : near(value),
    (/** @type {number | number[]} */ value) =>
      Array.isArray(value) ? value.map(ratio) : ratio(value),
  ];
  return Array.from({ length: count }, (_, i) =>
    Object.fromEntries(
      Object.entries(like).map(([name, value]) => [name, drawn[i % 3]?.(value) ?? 0]),
    ),
  );
}
