// An input as its reader typed it, and the C++ that returns it. What is typed is what is compiled: no number is rounded
// on the way.

/** A number as typed, a vector, a list of points, or the members of a struct in their order. */
export type Member = string | readonly string[] | readonly (readonly string[])[];
export type Value = Member | { readonly [member: string]: Member };

const MINUS = /[\u2212\u2013]/g;
const DECIMAL = /^[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?$/;
const HEXADECIMAL = /^[-+]?0[xX][0-9a-fA-F]+(?:\.[0-9a-fA-F]*)?[pP][-+]?\d+$/;
const WHOLE = /^[-+]?\d+$/;
const LINE = 96;

/** The C++ literal of a typed number; undefined if it is none. */
export function literal(typed: string): string | undefined {
  const text = typed.trim().replace(MINUS, "-").replace(/^\+/, "");
  if (HEXADECIMAL.test(text)) return text;
  if (!DECIMAL.test(text)) return undefined;
  if (!WHOLE.test(text)) return text;
  // Without leading zeros, which mean octal; as a double where an int could not hold it, or has no -0.
  const digits = text.replace(/^(-?)0+(?=\d)/, "$1");
  return digits.length > 9 || digits === "-0" ? `${digits}.0` : digits;
}

function list(parts: readonly string[], indent: string): string {
  const line = `{${parts.join(", ")}}`;
  if (line.length + indent.length <= LINE) return line;
  return `{\n${parts.map((part) => `${indent}  ${part},\n`).join("")}${indent}}`;
}

function member(value: Member, indent: string): string {
  if (typeof value === "string") {
    const number = literal(value);
    if (number === undefined) throw new RangeError(value);
    return number;
  }
  const parts = value.map((part) => member(part, `${indent}  `));
  return list(parts, indent);
}

/** The body of a function that returns the value. Throws a RangeError with the text that is no number. */
export function bodyOf(value: Value): string {
  if (typeof value === "string" || Array.isArray(value))
    return `{\n  return ${member(value as Member, "  ")};\n}`;
  const parts = Object.entries(value).map(([name, part]) => `.${name} = ${member(part, "    ")}`);
  return `{\n  return ${list(parts, "  ")};\n}`;
}

/** The end of the comment, string or character that begins at an index; the index itself if none does. */
function skipped(text: string, at: number): number {
  const from = (pattern: RegExp): number => {
    pattern.lastIndex = at;
    return pattern.test(text) ? pattern.lastIndex : at;
  };
  return Math.max(
    from(/\/\/[^\n]*/y),
    from(/\/\*[\s\S]*?(?:\*\/|$)/y),
    from(/"(?:\\.|[^"\\\n])*"?/y),
    // A digit separator is no character.
    /\w/.test(text[at - 1] ?? "") ? at : from(/'(?:\\.|[^'\\\n])*'?/y),
  );
}

/** Where the bracket at an index is closed; undefined if it never is. */
function closing(text: string, open: number): number | undefined {
  const [left, right] = text[open] === "(" ? "()" : "{}";
  let depth = 0;
  for (let i = open; i < text.length; i += 1) {
    const end = skipped(text, i);
    if (end > i) i = end - 1;
    else if (text[i] === left) depth += 1;
    else if (text[i] === right) {
      depth -= 1;
      if (depth === 0) return i;
    }
  }
  return undefined;
}

/** The source with another body of the function of this name; undefined if it defines none. */
export function withBody(source: string, name: string, body: string): string | undefined {
  const called = new RegExp(`${name}\\s*\\(`, "y");
  for (let i = 0; i < source.length; i += 1) {
    const end = skipped(source, i);
    if (end > i) {
      i = end - 1;
      continue;
    }
    called.lastIndex = i;
    if (/\w/.test(source[i - 1] ?? "") || !called.test(source)) continue;
    const close = closing(source, called.lastIndex - 1);
    const gap = close === undefined ? null : /^\s*(?=\{)/.exec(source.slice(close + 1));
    if (close === undefined || !gap) continue;
    const open = close + 1 + gap[0].length;
    const last = closing(source, open);
    if (last === undefined) return undefined;
    return `${source.slice(0, close + 1)} ${body}${source.slice(last + 1)}`;
  }
  return undefined;
}
