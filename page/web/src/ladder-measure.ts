// What a ladder's measurements say: each method's time and accuracy over all families, which methods
// no other beats, and the sentence about the method that the book recommends.

import {
  type LadderMethod,
  type LadderResult,
  type LadderRow,
  withoutPeers,
} from "./ladder-data.ts";

/** What the cells of a column show: wrong answers, or the largest error if no method is wrong. */
export type Measure = "wrong" | "error";

export function measureOf({ families, results }: LadderResult, family: string): Measure {
  if (families.find(({ id }) => id === family)?.by_error) return "error";
  const rows = results.filter((row) => row.family === family);
  if (rows.some((row) => row.wrong > 0)) return "wrong";
  return rows.some((row) => (row.error_max ?? 0) > 0) ? "error" : "wrong";
}

/** An error as the result files have it: none, or an infinite one after an overflow, is null. */
export const knownError = (error: number): number | null => (Number.isFinite(error) ? error : null);

export const cellValue = (row: LadderRow, measure: Measure): number | null =>
  measure === "wrong" ? row.wrong / row.n : row.error_max;

/** From 0, as good as can be, to 5. No value, after an overflow, is the worst. */
export const LEVELS = 6;
const LIMITS: Record<Measure, readonly number[]> = {
  wrong: [0, 0.001, 0.01, 0.1, 0.5],
  error: [1e-14, 1e-10, 1e-6, 1e-3, 0.1],
};
export const LEVEL_WORDS: Record<Measure, readonly string[]> = {
  wrong: ["none", "to 0.1 %", "to 1 %", "to 10 %", "to 50 %", "more"],
  error: ["to 10⁻¹⁴", "to 10⁻¹⁰", "to 10⁻⁶", "to 0.001", "to 0.1", "more"],
};

export function levelOf(value: number | null, measure: Measure): number {
  if (value === null) return LEVELS - 1;
  const at = LIMITS[measure].findIndex((limit) => value <= limit);
  return at < 0 ? LEVELS - 1 : at;
}

/** The label of a cell: per cent of wrong answers, or the error. */
export function labelOf(value: number | null, measure: Measure): string {
  if (value === null) return "–";
  if (value === 0) return "0";
  if (measure === "wrong") {
    const percent = Number((value * 100).toPrecision(2));
    if (percent === 100 && value < 1) return ">99";
    return percent < 1e-3 ? "<0.001" : String(percent);
  }
  return value >= 0.01
    ? String(Number(value.toPrecision(1)))
    : value.toExponential(0).replace("-", "−");
}

export function inWords(value: number | null, measure: Measure): string {
  const label = labelOf(value, measure);
  return measure === "wrong" ? `${label} % wrong` : `${label}, the largest error`;
}

export function duration(ns: number): string {
  const [unit, size] =
    ns < 999.5 ? ["ns", 1] : ns < 999_500 ? ["µs", 1e3] : ns < 999.5e6 ? ["ms", 1e6] : ["s", 1e9];
  const value = ns / Number(size);
  return `${value < 99.5 ? Number(value.toPrecision(2)) : Math.round(value)} ${unit}`;
}

export interface Time {
  readonly median: number;
  readonly q1: number;
  readonly q3: number;
}

/** Geometric means over the families, so that each counts alike; nothing if one is missing. */
export function timeOf(
  rows: readonly LadderRow[],
  method: string,
  families: number,
): Time | undefined {
  const own = rows.filter((row) => row.method === method);
  if (own.length < families || own.length === 0) return undefined;
  const mean = (of: (row: LadderRow) => number): number =>
    Math.exp(own.reduce((sum, row) => sum + Math.log(of(row)), 0) / own.length);
  return {
    median: mean((row) => row.ns_median),
    q1: mean((row) => row.ns_q1),
    q3: mean((row) => row.ns_q3),
  };
}

/** A method in the picture. */
export interface Rung {
  readonly method: LadderMethod;
  readonly time: Time;
  /** Mean share of wrong answers over the families; the largest error where nothing is decided. */
  readonly off: number;
  /** No other method is faster, or as fast, and more often right, or as often. */
  readonly frontier: boolean;
}

/**
 * Whether the ladder counts wrong answers: some are wrong, or no row has an error to show instead. One
 * whose every family is about the error does not: its answer is a number, and there "wrong" is only a
 * coarse check of it, like its sign.
 */
export function decides(measured: LadderResult): boolean {
  const { families, results } = withoutPeers(measured);
  if (results.every((row) => row.error_max === null)) return true;
  return results.some((row) => row.wrong > 0) && !families.every((family) => family.by_error);
}

/** The book's methods by time. */
export function rungs(measured: LadderResult): Rung[] {
  const result = withoutPeers(measured);
  const counted = decides(result);
  const off = (method: string): number => {
    const rows = result.results.filter((row) => row.method === method);
    return counted
      ? rows.reduce((sum, row) => sum + row.wrong / row.n, 0) / rows.length
      : Math.max(...rows.map((row) => row.error_max ?? Number.POSITIVE_INFINITY));
  };
  const all = result.methods.flatMap((method) => {
    const time = timeOf(result.results, method.id, result.families.length);
    return time ? [{ method, time, off: off(method.id) }] : [];
  });
  type Bare = (typeof all)[number];
  // Never wrong by design is more than not wrong on these inputs.
  const atLeastAsRight = (p: Bare, q: Bare): boolean =>
    p.off < q.off || (p.off === q.off && Number(p.method.exact) >= Number(q.method.exact));
  const beats = (p: Bare, q: Bare): boolean =>
    p.time.median <= q.time.median &&
    atLeastAsRight(p, q) &&
    (p.time.median < q.time.median || !atLeastAsRight(q, p));
  return all
    .map((rung) => ({ ...rung, frontier: !all.some((other) => beats(other, rung)) }))
    .sort((p, q) => p.time.median - q.time.median);
}

/** To one digit, for a bound. */
function roundedUp(value: number): number {
  const digit = 10 ** Math.floor(Math.log10(value));
  return value > 0 && Number.isFinite(value) ? Math.ceil(value / digit) * digit : value;
}

const fullName = ({ title, scalar }: LadderMethod): string =>
  title.includes(scalar) ? title : `${title} (${scalar})`;

/** What the measurements prove about the method that the book recommends. */
export function proven(result: LadderResult): { name: string; words: string } | undefined {
  const all = rungs(result);
  const chosen = all.find(({ method }) => method.recommended);
  const fastest = all[0];
  if (!chosen || !fastest) return undefined;
  const rows = result.results.filter((row) => row.method === chosen.method.id);
  const sum = (of: (row: LadderRow) => number): number => rows.reduce((n, row) => n + of(row), 0);
  const wrong = sum((row) => row.wrong);
  const asked = sum((row) => row.n).toLocaleString("en");
  const counted = decides(result);
  const { exact } = chosen.method;
  const alike = all.filter((rung) => (exact ? rung.method.exact : rung.off <= chosen.off));
  const first = chosen !== fastest && alike[0] === chosen && alike.length > 1;
  const parts: string[] = [];
  if (!counted) parts.push(`no error above ${labelOf(roundedUp(chosen.off), "error")}`);
  if (wrong > 0) parts.push(`wrong on ${wrong.toLocaleString("en")} of ${asked} inputs`);
  else if (counted && !exact) parts.push(`not wrong on any of ${asked} inputs`);
  else if (counted && !first) parts.push("never wrong by design");
  const like = exact
    ? "by design are never wrong"
    : counted
      ? "are wrong at most that often"
      : "have no larger error";
  if (first) parts.push(`the fastest of the ${alike.length} methods that ${like}`);
  const ratio = Number((chosen.time.median / fastest.time.median).toPrecision(2));
  const times = ratio === 1 ? "about" : `${ratio}\u00a0×`;
  parts.push(chosen === fastest ? "the fastest of all" : `${times} the time of the fastest of all`);
  const against = rivals(all, chosen, result);
  return { name: fullName(chosen.method), words: `${parts.join(", ")}${against}.` };
}

/**
 * Whether a method failed no more than the choice: wrong and undecided at most as often, and with no
 * larger error. Of families whose errors are of different magnitudes, the largest hides the others,
 * so that a ladder which counts wrong answers compares them family by family.
 */
function failsNoMore(result: LadderResult, method: string, chosen: string): boolean {
  const rowsOf = (id: string): LadderRow[] => result.results.filter((row) => row.method === id);
  const [theirs, own] = [rowsOf(method), rowsOf(chosen)];
  const sum = (rows: readonly LadderRow[], of: (row: LadderRow) => number): number =>
    rows.reduce((n, row) => n + of(row), 0);
  const most = (rows: readonly LadderRow[]): number =>
    Math.max(0, ...rows.map((row) => row.error_max ?? Number.POSITIVE_INFINITY));
  // Where the choice has no number, there is none to compare.
  const numbered = own.filter((row) => row.error_max !== null).map(({ family }) => family);
  const within = (families: readonly string[]): boolean => {
    const [theirMost, ownMost] = [theirs, own].map((rows) =>
      most(rows.filter(({ family }) => families.includes(family))),
    );
    return Number(theirMost) <= Number(ownMost);
  };
  return (
    sum(theirs, (row) => row.wrong) <= sum(own, (row) => row.wrong) &&
    sum(theirs, (row) => row.undecided) <= sum(own, (row) => row.undecided) &&
    (decides(result) ? numbered.every((family) => within([family])) : within(numbered))
  );
}

/**
 * What speaks against the choice belongs to it: faster methods that failed no more on these inputs.
 * Where the choice answers with a number, a method whose number has a larger error is none of them,
 * however seldom it is wrong; nor is one that leaves more undecided.
 */
function rivals(all: readonly Rung[], chosen: Rung, result: LadderResult): string {
  const found = all
    .slice(0, all.indexOf(chosen))
    .filter(({ method }) => failsNoMore(result, method.id, chosen.method.id));
  const [first] = found;
  if (!first) return "";
  const one = found.length === 1;
  // In quotes, because a name may contain a comma.
  const who = one ? `“${fullName(first.method)}”` : `${found.length} other methods`;
  const rows = result.results;
  const numbers = rows.some((row) => row.method === chosen.method.id && row.error_max !== null);
  const wrong = rows.some((row) => row.method === chosen.method.id && row.wrong > 0);
  const good: string[] = [];
  if (!numbers || rows.some((row) => row.wrong > 0))
    good.push(`${one ? "was" : "were"} ${wrong ? "no more often" : "not"} wrong`);
  if (numbers) good.push("had no larger error");
  const byDesign = chosen.method.exact && !found.some(({ method }) => method.exact);
  const only = byDesign ? `, but ${one ? "is" : "are"} not so by design` : "";
  return `; ${who} ${one ? "is" : "are"} faster and ${good.join(" and ")} on these inputs${only}`;
}
