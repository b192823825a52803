// A ladder as a picture: how often a method is wrong against what a query costs, one band for each
// family of inputs, each method named beside its point. The same code draws in the page and, with a
// document of its own, in Node.

import * as Plot from "@observablehq/plot";
import type { LadderMethod, LadderResult, LadderRow } from "./ladder-data.ts";

const WIDTH = 720;
const BAND = 200;
const LETTER = 6.3;
const LINE = 15;

type Measure = {
  readonly title: string;
  readonly of: (row: LadderRow) => number;
  readonly format: (value: number) => string;
  readonly logarithmic: boolean;
};

/** Wrong answers if there are any to show; otherwise the largest error. */
function measureOf(rows: readonly LadderRow[]): Measure {
  const percent = (share: number): string =>
    share === 0 ? "0" : `${Number((share * 100).toPrecision(2))} %`;
  const wrong: Measure = {
    title: "wrong answers",
    of: (row) => row.wrong / row.n,
    format: percent,
    logarithmic: false,
  };
  if (rows.some((row) => row.wrong > 0)) return wrong;
  const errors = rows.map((row) => row.error_max ?? 0);
  if (!errors.some((error) => error > 0)) return wrong;
  return {
    title: "largest error",
    of: (row) => row.error_max ?? 0,
    format: (value) => (value === 0 ? "0" : value.toExponential(0).replace("-", "−")),
    logarithmic: true,
  };
}

function colour(method: LadderMethod | undefined): string {
  if (method?.exact) return "var(--contact-hit, #0f7040)";
  return method?.scalar === "float" ? "var(--contact-a, #a8430b)" : "var(--contact-c, #6b35b8)";
}

const shape = (method: LadderMethod | undefined): "square" | "triangle" | "circle" =>
  method?.exact ? "square" : method?.scalar === "float" ? "triangle" : "circle";

/** `here` are the reader's own times, drawn as rings beside the book's. */
export function ladderPlot(
  result: LadderResult,
  document: Document,
  here: readonly LadderRow[] = [],
): SVGSVGElement {
  const rows = result.results;
  const all = [...rows, ...here];
  const measure = measureOf(all);
  const methods = new Map(result.methods.map((method) => [method.id, method]));
  const of = (row: LadderRow): LadderMethod | undefined => methods.get(row.method);
  const order = result.families.map(({ id }) => id);
  const levels = all.map(measure.of).filter((value) => value > 0);
  const smallest = levels.length > 0 ? Math.min(...levels) : 1e-3;
  const largest = levels.length > 0 ? Math.max(...levels) : 1;
  const paper = "var(--contact-paper, #fff)";
  const faint = "var(--contact-ghost, #c3cad3)";
  const marks = (data: readonly LadderRow[], own: boolean): Plot.Markish[] => [
    Plot.ruleY(data, {
      x1: "ns_q1",
      x2: "ns_q3",
      y: measure.of,
      fy: "family",
      stroke: (row: LadderRow) => colour(of(row)),
      strokeWidth: own ? 1 : 2.5,
      strokeOpacity: own ? 1 : 0.5,
    }),
    Plot.dot(data, {
      x: "ns_median",
      y: measure.of,
      fy: "family",
      symbol: (row: LadderRow) => shape(of(row)),
      fill: own ? paper : (row: LadderRow) => colour(of(row)),
      stroke: own ? (row: LadderRow) => colour(of(row)) : paper,
      strokeWidth: own ? 2 : 1,
      r: own ? 4 : 5,
    }),
  ];
  const svg = Plot.plot({
    document,
    width: WIDTH,
    height: BAND * order.length + 60,
    marginLeft: 70,
    marginRight: 20,
    marginTop: 26,
    marginBottom: 44,
    className: "contact-plot",
    style: { background: "none", color: "inherit", font: "12px system-ui, sans-serif" },
    x: {
      type: "log",
      label: null,
      tickFormat: (ns: number) => ns.toLocaleString("en"),
      ticks: 5,
      insetRight: 110,
      insetLeft: 20,
    },
    y: {
      type: "symlog",
      constant: smallest / 2,
      domain: [0, largest * 2],
      label: null,
      ticks: yTicks(smallest, largest),
      tickFormat: measure.format,
      insetBottom: 12,
      insetTop: 22,
    },
    fy: { domain: order, label: null, axis: null, padding: 0.12 },
    color: { type: "identity" },
    symbol: { type: "identity" as never },
    marks: [
      Plot.frame({ stroke: faint }),
      Plot.gridX({ stroke: faint, strokeOpacity: 0.6 }),
      Plot.gridY({ stroke: faint, strokeOpacity: 0.6, ticks: yTicks(smallest, largest) }),
      ...marks(rows, false),
      ...(here.length > 0 ? marks(here, true) : []),
    ],
  }) as SVGSVGElement & Plot.Plot;
  svg.setAttribute("class", `${svg.getAttribute("class") ?? ""} ladder`);
  svg.setAttribute("role", "img");
  svg.setAttribute("aria-label", `${result.question} ${measure.title} against time, plotted.`);
  // Plot names its groups, and a group without a role may have no name.
  for (const group of svg.querySelectorAll("g[aria-label]")) group.removeAttribute("aria-label");
  annotate(svg, result, here, measure, document);
  return svg;
}

function yTicks(smallest: number, largest: number): number[] {
  const low = Math.floor(Math.log10(smallest));
  const high = Math.ceil(Math.log10(largest));
  const every = Math.max(1, Math.ceil((high - low) / 5));
  const ticks = [0];
  for (let power = high; power >= low; power -= every)
    if (10 ** power <= largest * 2) ticks.push(10 ** power);
  return ticks;
}

interface Box {
  readonly left: number;
  readonly right: number;
  readonly top: number;
  readonly bottom: number;
}

const overlap = (p: Box, q: Box): boolean =>
  p.left < q.right && q.left < p.right && p.top < q.bottom && q.top < p.bottom;

/** Titles, and each method's name where no other name or point is, with a line to its point. */
function annotate(
  svg: SVGSVGElement & Plot.Plot,
  result: LadderResult,
  here: readonly LadderRow[],
  measure: Measure,
  document: Document,
): void {
  const x = svg.scale("x");
  const y = svg.scale("y");
  const fy = svg.scale("fy");
  if (!x || !y || !fy) return;
  const add = (tag: string, attributes: Record<string, string | number>, text = ""): void => {
    const element = document.createElementNS("http://www.w3.org/2000/svg", tag);
    const all = tag === "text" ? { "text-anchor": "start", ...attributes } : attributes;
    for (const [name, value] of Object.entries(all)) element.setAttribute(name, String(value));
    element.textContent = text;
    svg.append(element);
  };
  const bandTop = (family: string): number => Number(fy.apply(family));
  const firstTop = bandTop(result.families[0]?.id ?? "");
  for (const family of result.families) {
    const top = bandTop(family.id);
    const place = (row: LadderRow): { row: LadderRow; px: number; py: number } => ({
      row,
      px: Number(x.apply(row.ns_median)),
      py: Number(y.apply(measure.of(row))) + top - firstTop,
    });
    const inBand = (row: LadderRow): boolean => row.family === family.id;
    const points = result.results
      .filter(inBand)
      .map(place)
      .sort((p, q) => p.px - q.px);
    const n = points[0]?.row.n ?? family.n;
    add(
      "text",
      { x: 74, y: top + 15, "font-size": 13, "font-weight": 600, fill: "currentColor" },
      n ? `${family.title} (${n.toLocaleString("en")} inputs)` : family.title,
    );
    const taken: Box[] = [
      { left: 70, right: 70 + 260, top, bottom: top + 18 },
      ...[...points, ...here.filter(inBand).map(place)].map(({ px, py }) => ({
        left: px - 6,
        right: px + 6,
        top: py - 6,
        bottom: py + 6,
      })),
    ];
    const bottom = top + (fy.bandwidth ?? BAND);
    for (const { row, px, py } of points) {
      const method = result.methods.find(({ id }) => id === row.method);
      const name = method?.title ?? row.method;
      const place = freePlace(px, py, name.length * LETTER, taken, top, bottom);
      taken.push(place.box);
      const stroke = colour(method);
      const x2 = place.x > px ? place.x - 2 : place.box.right;
      const y2 = place.y - 4;
      if (Math.hypot(y2 - py, x2 - px) > 14)
        add("line", { x1: px, y1: py, x2, y2, stroke, "stroke-width": 0.7 });
      add("text", { x: place.x, y: place.y, fill: stroke, "font-size": 12 }, name);
    }
  }
  const height = Number(svg.getAttribute("height"));
  const label = { fill: "currentColor", "font-size": 12 };
  add(
    "text",
    { ...label, x: WIDTH - 20, y: height - 6, "text-anchor": "end" },
    "time of one query, ns →",
  );
  add("text", { ...label, x: 8, y: 14 }, `↑ ${measure.title}`);
  for (const [i, [scalar, exact, words]] of (
    [
      ["float", false, "▲ float"],
      ["double", false, "● double"],
      ["", true, "■ never wrong by design"],
    ] as const
  ).entries()) {
    const fill = colour({ id: "", title: "", scalar, exact });
    add("text", { x: 330 + 85 * i, y: 14, fill, "font-size": 12 }, words);
  }
}

const PLACES = [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10]
  .flatMap((lines) => (lines === 0 ? [0] : [-lines, lines]))
  .flatMap((lines) => [10, 22, 40, 62, 86, 112].map((right) => ({ right, down: lines * LINE })))
  .sort((p, q) => effort(p) - effort(q));

function effort({ right, down }: { readonly right: number; readonly down: number }): number {
  return Math.abs(down) + 0.55 * (right - 10) + (down > 0 ? 1 : 0);
}

/** The nearest place to the right of a point, or beyond it to the left, where a name fits. */
function freePlace(
  px: number,
  py: number,
  width: number,
  taken: readonly Box[],
  top: number,
  bottom: number,
): { x: number; y: number; box: Box } {
  const boxAt = (x: number, y: number): Box => ({
    left: x - 2,
    right: x + width + 2,
    top: y - 11,
    bottom: y + 3,
  });
  for (const { right, down } of PLACES) {
    for (const x of right < 40 ? [px + right, px - right - width] : [px + right]) {
      const y = py + 4 + down;
      const box = boxAt(x, y);
      const inside = box.top > top + 2 && box.bottom < bottom - 1 && box.right < WIDTH - 20;
      if (inside && box.left > 72 && !taken.some((other) => overlap(other, box)))
        return { x, y, box };
    }
  }
  return { x: px + 10, y: py + 4, box: boxAt(px + 10, py + 4) };
}
