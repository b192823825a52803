// Numbers of an answer as the page writes them, as docs/_ext/contact_book/ask_engines.py does.

/** A number, and the power of ten that it is to be multiplied by. */
export interface Written {
  readonly number: string;
  readonly power?: string;
}

/** Outside of these an error is written with a power of ten. */
const SMALL = 1e-3;
const LARGE = 1e3;

const minus = (text: string): string => text.replace("-", "−");

function twoDigits(x: number): Written {
  const [mantissa = "", exponent = "0"] = x.toExponential(1).split("e");
  return { number: minus(String(Number(mantissa))), power: minus(String(Number(exponent))) };
}

/** A value with up to ten digits; a very small one with two. */
export function valueWritten(value: number): Written {
  if (!Number.isFinite(value)) return { number: "none" };
  if (value !== 0 && Math.abs(value) < SMALL) return twoDigits(value);
  return { number: minus(String(Number(value.toPrecision(10)))) };
}

/** An error with two digits. */
export function errorWritten(error: number): Written {
  if (!Number.isFinite(error)) return { number: "–" };
  if (error === 0) return { number: "0" };
  return error < SMALL || error >= LARGE
    ? twoDigits(error)
    : { number: String(Number(error.toPrecision(2))) };
}

export const timeText = (ms: number): string =>
  ms < 100 ? `${Number(ms.toPrecision(2))} ms` : `${Number((ms / 1000).toPrecision(2))} s`;
