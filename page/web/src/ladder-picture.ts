// A ladder as one table that fits one screen: a method a row, by time; a column a family of inputs,
// coloured by how often the method is wrong, or by how much; its time as a bar beside. The same code
// makes the text in the page and, when the book is built, in Node.

import {
  kindOf,
  type LadderMethod,
  type LadderResult,
  type LadderRow,
  methodName,
  partsOf,
} from "./ladder-data.ts";
import {
  cellValue,
  decides,
  duration,
  inWords,
  LEVEL_WORDS,
  labelOf,
  levelOf,
  type Measure,
  measureOf,
  proven,
  type Rung,
  rungs,
  type Time,
  timeOf,
} from "./ladder-measure.ts";
import { escapeText } from "./shapes.ts";

const BAR = { width: 120, height: 22, inset: 4 };

/** A heading in which no line ends before a unit or beside a sign between numbers. */
const unbroken = (text: string): string =>
  escapeText(text)
    .replace(/ ([:=]) /g, "\u00a0$1\u00a0")
    .replace(/(\d) (?=(?:s|m|mm)\b|%)/g, "$1\u00a0");

/** Text in an attribute. */
export const quoted = (text: string): string => escapeText(text).replaceAll('"', "&quot;");

/** Where a time lies on the logarithmic axis that all rows share, and the times that have a line. */
type Scale = { readonly at: (ns: number) => number; readonly ticks: readonly number[] };

function scaleOf(times: readonly number[]): Scale {
  const low = Math.log10(Math.min(...times) / 1.3);
  const high = Math.log10(Math.max(...times) * 1.3);
  const at = (ns: number): number =>
    BAR.inset + ((Math.log10(ns) - low) / (high - low)) * (BAR.width - 2 * BAR.inset);
  const ticks = (steps: readonly number[]): number[] => {
    const all: number[] = [];
    for (let power = Math.floor(low); power <= high; power += 1)
      all.push(...steps.map((step) => step * 10 ** power));
    return all.filter((ns) => ns >= 10 ** low && ns <= 10 ** high);
  };
  // A scale needs two numbers at least.
  const decades = ticks([1]);
  return { at, ticks: decades.length < 2 ? ticks([1, 2, 5]) : decades };
}

const px = (x: number): string => x.toFixed(1);

type Label = { readonly words: string; readonly x: number };

/** Labels of some ticks, each moved into the axis; nothing if two of them come too near. */
function labelled(at: Scale["at"], ticks: readonly number[]): Label[] | undefined {
  let free = 0;
  const labels: Label[] = [];
  for (const ns of ticks) {
    const words = duration(ns);
    const half = words.length * 3.2;
    const x = Math.min(Math.max(at(ns), half), BAR.width - half);
    if (x - half < free) return undefined;
    free = x + half + 4;
    labels.push({ words, x });
  }
  return labels;
}

/** Every tick has a label, or every second, or third: as many as have room. */
function axis({ at, ticks }: Scale): string {
  let labels: Label[] = [];
  for (let step = 1; step <= ticks.length && labels.length === 0; step += 1)
    for (let first = 0; first < step; first += 1) {
      const some = labelled(
        at,
        ticks.filter((_, i) => i % step === first),
      );
      if (some && some.length > labels.length) labels = some;
    }
  const lines = ticks.map((ns) => `<line x1="${px(at(ns))}" x2="${px(at(ns))}" y1="15" y2="20"/>`);
  const texts = labels.map(
    ({ words, x }) => `<text x="${px(x)}" y="11" text-anchor="middle">${words}</text>`,
  );
  return `<svg class="axis" viewBox="0 0 ${BAR.width} 20" aria-hidden="true">${lines.join("")}${texts.join("")}</svg>`;
}

/** Bar to the median with a line from quartile to quartile, and below it a dot for each family. */
function bar(
  scale: Scale,
  time: Time | undefined,
  families: readonly LadderRow[],
  here: Time | undefined,
): string {
  const { at, ticks } = scale;
  const middle = !time ? 10 : here ? 5 : 8;
  const whole = (t: Time, y: number, size: number, name: string): string =>
    `<rect class="${name}" x="${BAR.inset}" y="${y - size / 2}" width="${px(Math.max(1, at(t.median) - BAR.inset))}" height="${size}"/>` +
    `<line class="quartiles" x1="${px(at(t.q1))}" x2="${px(at(t.q3))}" y1="${y}" y2="${y}"/>`;
  const grid = ticks
    .map((ns) => `<line x1="${px(at(ns))}" x2="${px(at(ns))}" y1="0" y2="${BAR.height}"/>`)
    .join("");
  const dots = families
    .map(
      (row) => `<circle cx="${px(at(row.ns_median))}" cy="${middle + (here ? 6.5 : 9)}" r="1.7"/>`,
    )
    .join("");
  return (
    `<svg class="bar" viewBox="0 0 ${BAR.width} ${BAR.height}" aria-hidden="true">` +
    `<g class="grid">${grid}</g>${time ? whole(time, middle, 8, "book") : ""}<g class="families">${dots}</g>` +
    `${here ? whole(here, time ? 18 : middle, 5, "own") : ""}</svg>`
  );
}

function cell(
  row: LadderRow | undefined,
  measure: Measure,
  name: string,
  family: string,
  pressable: boolean,
  { exact, peer }: LadderMethod,
): string {
  if (!row) return `<td data-family="${quoted(family)}">–</td>`;
  const value = cellValue(row, measure);
  const label = labelOf(value, measure);
  // What is never wrong does not overflow: without an error it computes no number. A peer may by its own
  // definition compute another one.
  const decidesOnly = value === null && (exact || peer);
  const level = decidesOnly ? "level-none" : `level-${levelOf(value, measure)}`;
  const attributes = `class="${level}" data-family="${quoted(row.family)}"`;
  if (!pressable) return `<td ${attributes}>${label}</td>`;
  const nothing = peer ? "no number to compare" : "no number, it only decides";
  const words = decidesOnly ? nothing : inWords(value, measure);
  const told = quoted(`${words}: ${name}, ${family}`);
  return `<td ${attributes}><button type="button" tabindex="-1" aria-label="${told}" title="${told}">${label}</button></td>`;
}

/** The marks of a method, for the eye and for a screen reader. */
function marks({ recommended, exact }: LadderMethod): string {
  const mark = (sign: string, words: string): string =>
    `<span class="mark" title="${words}"><span aria-hidden="true">${sign}</span><span class="unseen">${words}: </span></span>`;
  return (
    (recommended ? mark("★", "the book's choice") : "") +
    (exact ? mark("◆", "never wrong by design") : "")
  );
}

/** A method's name, and its cells. */
function cellsOf(method: LadderMethod, result: LadderResult, pressable: boolean): string {
  const rows = result.results.filter((row) => row.method === method.id);
  const cells = result.families.map(({ id, title: family }) =>
    cell(
      rows.find((row) => row.family === id),
      measureOf(result, id),
      methodName(method),
      family,
      pressable,
      method,
    ),
  );
  return cells.join("");
}

/** The name of a method, with its type unless that is in the name. */
function nameOf(method: LadderMethod, bold: boolean): string {
  const title = unbroken(method.title);
  const scalar =
    methodName(method) === method.title ? "" : ` <small>${escapeText(method.scalar)}</small>`;
  return `${bold ? `<strong>${title}</strong>` : title}${scalar}`;
}

/** A peer has no time in the book. */
function peerRow(
  method: LadderMethod,
  result: LadderResult,
  scale: Scale,
  pressable: boolean,
): string {
  const rows = result.results.filter((row) => row.method === method.id);
  const own = timeOf(rows, method.id, result.families.length);
  const words = own ? `<span class="own">${duration(own.median)}</span>` : "–";
  return (
    `<tr class="peer" data-method="${quoted(method.id)}" data-kind="${kindOf(method)}">` +
    `<th scope="row">${nameOf(method, false)}</th>${cellsOf(method, result, pressable)}` +
    `<td class="ns">${words}</td><td class="bars">${bar(scale, undefined, rows, own)}</td></tr>`
  );
}

function rowOf(
  rung: Rung,
  result: LadderResult,
  here: readonly LadderRow[],
  scale: Scale,
  pressable: boolean,
): string {
  const { method, time, frontier } = rung;
  const rows = result.results.filter((row) => row.method === method.id);
  const own = timeOf(here, method.id, result.families.length);
  const words = `${duration(time.median)}, quartiles ${duration(time.q1)} to ${duration(time.q3)}`;
  const ownWords = own ? `<br/><span class="own">${duration(own.median)}</span>` : "";
  const classes = [method.recommended ? "recommended" : "", frontier ? "frontier" : ""];
  return (
    `<tr class="${classes.filter(Boolean).join(" ")}" data-method="${quoted(method.id)}" data-kind="${kindOf(method)}">` +
    `<th scope="row">${marks(method)}${nameOf(method, frontier)}</th>` +
    `${cellsOf(method, result, pressable)}<td class="ns" title="${words}">${duration(time.median)}${ownWords}</td>` +
    `<td class="bars">${bar(scale, time, rows, own)}</td></tr>`
  );
}

/** Whose the rows in JavaScript are, and on how many inputs: fewer than the book's. */
function peersWords({ methods, results }: LadderResult): string {
  const peers = methods.filter(({ peer }) => peer);
  if (peers.length === 0) return "";
  const sizes = results
    .filter(({ method }) => peers.some(({ id }) => id === method))
    .map(({ n }) => n);
  const [least, most] = [Math.min(...sizes), Math.max(...sizes)].map((n) => n.toLocaleString("en"));
  const inputs = least === most ? least : `${least} to ${most}`;
  const notes = new Set(peers.flatMap(({ note }) => note ?? []));
  return [
    `in JavaScript: another library, asked only here, on ${inputs} inputs a family, because the book's ` +
      "own numbers are those of native programs",
    ...notes,
  ].join("; ");
}

function legend(result: LadderResult, own: boolean): string {
  const used = new Set(result.families.map(({ id }) => measureOf(result, id)));
  const scales = (["wrong", "error"] as const).filter((measure) => used.has(measure));
  const colours = scales.map((measure) => {
    const steps = LEVEL_WORDS[measure].map(
      (words, level) => `<span class="step level-${level}">${words}</span>`,
    );
    const name = measure === "wrong" ? "Wrong answers" : "Largest error";
    return `<p><span class="name">${name}:</span> ${steps.join(" ")}</p>`;
  });
  const byDesign = result.methods.some(({ exact }) => exact);
  const worse = decides(result) ? "less often right" : "less accurate on the worst input";
  const signs = [
    result.methods.some(({ recommended }) => recommended) ? "★ the book's choice" : "",
    byDesign ? "◆ never wrong by design" : "",
    `<strong>bold</strong>: every faster method is ${worse}${byDesign && decides(result) ? ", or is without the ◆ of this one" : ""}`,
    "bar: time of one answer on a logarithmic axis, as the geometric mean over the families of inputs (the columns)",
    "line on the bar: the middle half of the repeated measurements",
    "dot below the bar: the time of one family",
    own ? "dashed: this browser, in WebAssembly" : "",
    peersWords(result),
  ];
  return `<div class="legend">${colours.join("")}<p>${signs.filter(Boolean).join(" · ")}.</p></div>`;
}

export interface PictureOptions {
  /** The reader's own times, drawn beside the book's. */
  readonly here?: readonly LadderRow[];
  /** Whether the cells are buttons. */
  readonly pressable?: boolean;
}

/** Each table of several is a region with a name of its own. */
function region(question: string, single: boolean): string {
  const name = `Accuracy against time${single ? "" : `, ${question}`}`;
  return `role="region" tabindex="0" aria-label="${quoted(name)}, may scroll sideways"`;
}

/** The table of one question. */
function one(result: LadderResult, single: boolean, options: PictureOptions): string {
  const { here = [], pressable = false } = options;
  const all = rungs(result);
  const own = here.filter(({ family }) => result.families.some(({ id }) => id === family));
  const scale = scaleOf([...result.results, ...own].map((row) => row.ns_median));
  const many = result.families.length > 6 ? " many" : "";
  const heads = result.families.map(({ id, title }) => {
    const unit = measureOf(result, id) === "wrong" ? "% wrong" : "error";
    return (
      `<th scope="col" class="family" data-family="${quoted(id)}"><span class="title">${unbroken(title)}</span>` +
      `<small>${unit}</small></th>`
    );
  });
  const rows = all.map((rung) => rowOf(rung, result, own, scale, pressable));
  for (const method of result.methods)
    if (method.peer) rows.push(peerRow(method, result, scale, pressable));
  const said = proven(result);
  const sentence = said
    ? `<p class="proven"><span aria-hidden="true">★ </span><strong>${escapeText(said.name)}:</strong> ${escapeText(said.words)}</p>`
    : "";
  return (
    `${sentence}<div class="scrolling" ${region(result.question, single)}><table class="ladder-picture${many}">` +
    `<caption><span>${escapeText(result.question)}</span></caption>` +
    `<thead><tr><th scope="col" class="method">Method, by time</th>${heads.join("")}` +
    `<th scope="col" class="ns">Time</th><td class="bars">${axis(scale)}</td></tr></thead>` +
    `<tbody>${rows.join("")}</tbody></table></div>`
  );
}

/** The picture as HTML that is also XML: a table for each question. */
export function ladderPicture(result: LadderResult, options: PictureOptions = {}): string {
  const parts = partsOf(result);
  const tables = parts.map((part) => one(part, parts.length === 1, options)).join("");
  return `${tables}${legend(result, (options.here ?? []).length > 0)}`;
}
