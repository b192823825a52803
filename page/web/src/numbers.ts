// How numbers are written for a reader, and read back. JavaScript's own shortest text is used
// wherever a number must survive exactly (typed fields, links).

export type Vec2 = readonly [number, number];
export type Vec3 = readonly [number, number, number];

const MINUS = "\u2212";

/** Four significant digits, as a reader writes them: 0.25, −1.732, 1.2 × 10⁻⁹. */
export function pretty(value: number, digits = 4): string {
  if (Number.isNaN(value)) return "not a number";
  if (!Number.isFinite(value)) return value > 0 ? "∞" : `${MINUS}∞`;
  if (value === 0) return "0";
  const size = Math.abs(value);
  if (size >= 1e6 || size < 1e-4) {
    const [mantissa = "", exponent = "0"] = value.toExponential(digits - 2).split("e");
    return `${trim(mantissa)} × 10${superscript(Number(exponent))}`.replace("-", MINUS);
  }
  const decimals = Math.max(0, digits - 1 - Math.floor(Math.log10(size)));
  return trim(value.toFixed(Math.min(decimals, 8))).replace("-", MINUS);
}

export function prettyVector(values: readonly number[], digits = 3): string {
  return `(${values.map((value) => pretty(value, digits)).join(", ")})`;
}

function trim(text: string): string {
  return text.includes(".") ? text.replace(/\.?0+$/, "") : text;
}

function superscript(exponent: number): string {
  const digits = "⁰¹²³⁴⁵⁶⁷⁸⁹";
  return [...String(exponent)].map((c) => (c === "-" ? "⁻" : digits[Number(c)])).join("");
}

/** What a person types as a number: a decimal comma is not accepted, a typographic minus is. */
export function parseNumber(text: string): number | undefined {
  const plain = text.trim().replaceAll(MINUS, "-").replaceAll("–", "-");
  const match = /^([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)(?:\s*\/\s*(\d+\.?\d*))?$/.exec(plain);
  if (!match) return undefined;
  const value = match[2] === undefined ? Number(match[1]) : Number(match[1]) / Number(match[2]);
  return Number.isFinite(value) ? value : undefined;
}
