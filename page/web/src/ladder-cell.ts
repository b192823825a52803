// What a pressed cell of a ladder shows: the methods on this family of inputs, wrong answers or error
// against time, and an input on which the method fails.

import {
  kindOf,
  type LadderFailure,
  type LadderFamily,
  type LadderMethod,
  type LadderResult,
  type LadderRow,
  methodName,
  withoutPeers,
} from "./ladder-data.ts";
import {
  cellValue,
  duration,
  inWords,
  labelOf,
  type Measure,
  measureOf,
} from "./ladder-measure.ts";
import { quoted } from "./ladder-picture.ts";
import { escapeText } from "./shapes.ts";

const WIDTH = 400;
const HEIGHT = 230;
const FRAME = { left: 52, right: WIDTH - 12, top: 26, bottom: HEIGHT - 38 };
/** Zero lies below the logarithmic scale, on a line of its own. */
const ZERO = FRAME.bottom - 12;
const LOWEST = ZERO - 22;
const HIGHEST = FRAME.top + 12;
const LETTER = 7.2;
/** Half the size of a mark. */
const MARK = 5;

export interface Cell {
  readonly method: LadderMethod;
  readonly family: LadderFamily;
  readonly row: LadderRow;
  readonly own: LadderRow | undefined;
  readonly measure: Measure;
}

export function cellOf(
  result: LadderResult,
  here: readonly LadderRow[],
  method: string,
  family: string,
): Cell | undefined {
  const is = (row: LadderRow): boolean => row.method === method && row.family === family;
  const about = result.methods.find(({ id }) => id === method);
  const inputs = result.families.find(({ id }) => id === family);
  const row = result.results.find(is);
  if (!about || !inputs || !row) return undefined;
  const measure = measureOf(result, family);
  return { method: about, family: inputs, row, own: about.peer ? row : here.find(is), measure };
}

const px = (x: number): string => x.toFixed(1);

/** Positions of powers of ten, and their labels where they have room of `apart` pixels. */
function ticks(low: number, high: number, at: (power: number) => number, apart: number): number[] {
  const powers: number[] = [];
  for (let power = Math.ceil(low); power <= high; power += 1) powers.push(power);
  const step = Math.max(1, Math.ceil(apart / Math.max(1, Math.abs(at(1) - at(0)))));
  return powers.filter((power) => (power - (powers[0] ?? 0)) % step === 0);
}

function mark(kind: string, x: number, y: number, classes: string, title: string): string {
  const size = MARK;
  const shapes: Record<string, string> = {
    float: `<path d="M${px(x)},${px(y - size)}l${size},${1.8 * size}h${-2 * size}z"`,
    double: `<circle cx="${px(x)}" cy="${px(y)}" r="${size - 0.5}"`,
    exact: `<rect x="${px(x - size + 0.5)}" y="${px(y - size + 0.5)}" width="${2 * size - 1}" height="${2 * size - 1}"`,
  };
  return `${shapes[kind]} class="${classes}"><title>${escapeText(title)}</title></${kind === "float" ? "path" : kind === "double" ? "circle" : "rect"}>`;
}

type Point = readonly [number, number];

/** The middle of a name of this width, on its line: where it covers the fewest marks, near its own if possible. */
function nameAt([x, y]: Point, marks: readonly Point[], width: number, axisName: string): Point {
  const half = width / 2;
  const within = (at: number): number =>
    Math.min(Math.max(at, FRAME.left + half + 4), FRAME.right - half - 4);
  const covered = ([at, line]: Point): number =>
    marks.filter(
      ([p, q]) => Math.abs(p - at) < half + MARK && q > line - 9 - MARK && q < line + 3 + MARK,
    ).length;
  const lines = [y - 11, y + 21];
  for (let away = 8; away < FRAME.bottom - FRAME.top; away += 8)
    lines.push(y - 11 - away, y + 21 + away);
  const places: Point[] = lines
    .filter((line) => line > FRAME.top + 10 && line < FRAME.bottom - 2)
    .flatMap((line) => [x, x + half, x - half].map((at): Point => [within(at), line]));
  // Above the frame there are no marks, but the axis has its name there.
  if (width < FRAME.right - 8 - 6 * axisName.length) places.push([FRAME.right - half, 14]);
  return places.reduce((best, next) => (covered(next) < covered(best) ? next : best));
}

/** All methods on the family of the cell; only the cell's method is named. */
export function scatter(result: LadderResult, here: readonly LadderRow[], cell: Cell): string {
  const { family, measure } = cell;
  const inFamily = (row: LadderRow): boolean => row.family === family.id;
  const own = here.filter(inFamily);
  const book = withoutPeers(result).results.filter(inFamily);
  const all = [...book, ...own];
  const times = all.map((row) => Math.log10(row.ns_median));
  const [left, right] = [Math.min(...times) - 0.15, Math.max(...times) + 0.15];
  const xOf = (power: number): number =>
    FRAME.left + 14 + ((power - left) / (right - left)) * (FRAME.right - FRAME.left - 28);
  const values = all.map((row) => cellValue(row, measure) ?? 0).filter((value) => value > 0);
  const high = Math.log10(values.length > 0 ? Math.max(...values) : 1);
  const low = Math.min(high - 1, Math.log10(values.length > 0 ? Math.min(...values) : 0.01));
  const level = (power: number): number =>
    LOWEST - ((power - low) / (high - low)) * (LOWEST - HIGHEST);
  const yOf = (value: number | null): number =>
    value === null ? HIGHEST : value === 0 ? ZERO : level(Math.log10(value));

  const axisName = measure === "wrong" ? "↑ % wrong" : "↑ largest error";
  const text = (x: number, y: number, words: string, anchor: string, name = ""): string =>
    `<text x="${px(x)}" y="${px(y)}" text-anchor="${anchor}"${name ? ` class="${name}"` : ""}>${escapeText(words)}</text>`;
  const parts = [
    `<rect class="frame" x="${FRAME.left}" y="${FRAME.top}" width="${FRAME.right - FRAME.left}" height="${FRAME.bottom - FRAME.top}"/>`,
    text(FRAME.left - 6, ZERO + 4, "0", "end"),
    `<line class="grid" x1="${FRAME.left}" x2="${FRAME.right}" y1="${ZERO}" y2="${ZERO}"/>`,
  ];
  if (values.length > 0)
    for (const power of ticks(low, high + 1e-9, level, 16)) {
      const y = level(power);
      parts.push(
        `<line class="grid" x1="${FRAME.left}" x2="${FRAME.right}" y1="${px(y)}" y2="${px(y)}"/>`,
        text(FRAME.left - 6, y + 4, labelOf(10 ** power, measure), "end"),
      );
    }
  for (const power of ticks(left, right, xOf, 46)) {
    const x = xOf(power);
    parts.push(
      `<line class="grid" x1="${px(x)}" x2="${px(x)}" y1="${FRAME.top}" y2="${FRAME.bottom}"/>`,
      text(x, FRAME.bottom + 15, duration(10 ** power), "middle"),
    );
  }
  parts.push(
    text(4, 14, axisName, "start"),
    text(FRAME.right, HEIGHT - 5, "time of one answer →", "end"),
  );
  const points = (rows: readonly LadderRow[], name: string): string[] =>
    rows.map((row) => {
      const method = result.methods.find(({ id }) => id === row.method);
      const chosen = row.method === cell.method.id ? " chosen" : "";
      const title = method ? methodName(method) : row.method;
      const value = cellValue(row, measure);
      const kind = method ? kindOf(method) : "double";
      const shape = mark(
        kind,
        xOf(Math.log10(row.ns_median)),
        yOf(value),
        `${name}${chosen}`,
        `${title}: ${inWords(value, measure)}, ${duration(row.ns_median)}`,
      );
      return `<g data-method="${quoted(row.method)}">${shape}</g>`;
    });
  parts.push(...points(own, "own"), ...points(book, "book"));
  const marks = all.map(
    (row): Point => [xOf(Math.log10(row.ns_median)), yOf(cellValue(row, measure))],
  );
  const chosen: Point = [xOf(Math.log10(cell.row.ns_median)), yOf(cellValue(cell.row, measure))];
  const name = nameAt(chosen, marks, cell.method.title.length * LETTER, axisName);
  parts.push(text(name[0], name[1], cell.method.title, "middle", "name"));
  const label = `${family.title}: ${measure === "wrong" ? "wrong answers" : "largest error"} against time, plotted.`;
  return `<svg class="scatter" viewBox="0 0 ${WIDTH} ${HEIGHT}" role="img" aria-label="${quoted(label)}">${parts.join("")}</svg>`;
}

function factsOf(failure: LadderFailure): string {
  const rows = failure.facts.map(({ name, text }) => {
    const long = text.length > 400;
    const shown = long
      ? `<details><summary>${text.split(" ").length} numbers</summary>${escapeText(text)}</details>`
      : escapeText(text);
    return `<div><dt>${escapeText(name)}</dt><dd>${shown}</dd></div>`;
  });
  return `<dl class="numbers">${rows.join("")}</dl>`;
}

/** What is told of the cell, above its scatter. */
export function summary({ method, row, own, measure }: Cell): string {
  const count = (of: LadderRow): string =>
    `${of.wrong.toLocaleString("en")} of ${of.n.toLocaleString("en")} answers wrong` +
    (of.undecided > 0 ? `, ${of.undecided.toLocaleString("en")} undecided` : "");
  const error = row.error_max === null ? "" : `, largest error ${labelOf(row.error_max, "error")}`;
  const time = (of: LadderRow): string =>
    `${duration(of.ns_median)} (quartiles ${duration(of.ns_q1)} to ${duration(of.ns_q3)})`;
  const said = `${count(row)}${measure === "error" || row.error_max ? error : ""}; ${time(row)}.`;
  if (method.peer) return `In this browser: ${said}`;
  return own ? `${said} In this browser: ${count(own)}; ${time(own)}.` : said;
}

/** The input, if the method has one on which it fails. */
export function failureOf({ method, row, family, measure }: Cell): string {
  if (method.peer) return "<p>Inputs on which another library is wrong are not kept.</p>";
  const { failure } = row;
  if (!failure && row.fails) return '<p class="failing" role="status">Loading an input …</p>';
  if (!failure)
    return "<p>No input of this family to show: the method is not wrong on any of them.</p>";
  const number = (failure.input + 1).toLocaleString("en");
  const of = row.n.toLocaleString("en");
  // A peer that is wrong makes a column count wrong answers, where the book kept the largest errors.
  const what =
    measure === "wrong" && row.wrong > 0
      ? "An input on which it is wrong"
      : "The input with its largest error";
  const error = failure.error === null ? "" : `, error ${labelOf(failure.error, "error")}`;
  const smaller = failure.simplified ? ", with parts left out that do not matter" : "";
  const heading = `${what} (${escapeText(family.title)}, number ${number} of ${of}${smaller}${error})`;
  const note = failure.note ? `<p class="note">${escapeText(failure.note)}</p>` : "";
  return `<h4>${heading}</h4>${factsOf(failure)}${note}`;
}
