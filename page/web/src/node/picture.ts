// The fallback picture of a figure: the same C++ and the same drawing code as in the page, run in
// Node when the book is built.

import { pictureStyle } from "../../palette.mjs";
import { startEngine } from "../engine.ts";
import type { AnyFigure } from "../figure.ts";
import type { Fields, Layout } from "../layout.ts";
import { FigureModel, sentence } from "../model.ts";
import { Scene } from "../scene.ts";
import { escapeText, shapesToSvg, subscripted } from "../shapes.ts";
import { currentValues, valueText } from "../values.ts";
import { FlatView } from "../view2.ts";
import { SpaceView } from "../view3.ts";

export interface Picture {
  readonly svg: string;
  readonly facts: {
    readonly title: string;
    readonly describe: string;
    readonly values: readonly { name: string; meaning: string; text: string }[];
    readonly layout: Layout;
  };
}

const WIDTH = 600;
const LINE = 21;

export async function drawPicture(figure: AnyFigure, wasm: Uint8Array): Promise<Picture> {
  const engine = await startEngine(wasm as BufferSource);
  checkFields(figure, engine.layout);
  const model = new FigureModel(figure, engine);
  if (model.problem) throw new Error(`its initial state has a problem: ${model.problem}`);
  const view = figure.view.kind === "3d" ? new SpaceView(figure.view) : new FlatView(figure.view);
  const height = Math.round(WIDTH / (figure.aspect ?? 1.35));
  view.resize(WIDTH, height);
  const scene = new Scene();
  figure.draw(scene, model.input, model.output);
  const drawn = shapesToSvg(view.project(scene));
  const values = currentValues(model);
  const describe = sentence(model);
  const rows = values.map((value, i) => {
    const y = height + 24 + LINE * i;
    const name = subscripted(value.name, (sub) => `<tspan font-size="80%">${sub}</tspan>`);
    return (
      `<text class="${/[A-Za-z]{3}/.test(value.name) ? "name word" : "name"}" x="14" y="${y}">${name}</text>` +
      `<text class="text" x="150" y="${y}">${escapeText(valueText(value))}</text>` +
      `<text class="meaning" x="340" y="${y}">${escapeText(value.meaning)}</text>`
    );
  });
  const full = height + (rows.length > 0 ? 16 + LINE * rows.length : 0);
  const svg =
    `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${WIDTH} ${full}" width="${WIDTH}" height="${full}" role="img">` +
    `<title>${escapeText(figure.title)}</title><desc>${escapeText(describe)}</desc>` +
    `<style>${pictureStyle(drawn)}` +
    ".name,.text,.meaning{font:13px system-ui,sans-serif;fill:var(--contact-ink)}" +
    ".name{font-style:italic;font-weight:600}.word{font-style:normal}.meaning{fill:var(--contact-muted)}</style>" +
    `<rect class="paper" width="${WIDTH}" height="${full}"/>` +
    `<svg width="${WIDTH}" height="${height}">${drawn}</svg>${rows.join("")}</svg>\n`;
  const facts = {
    title: figure.title,
    describe,
    values: values.map((value) => ({
      name: value.name,
      meaning: value.meaning,
      text: valueText(value),
    })),
    layout: engine.layout,
  };
  return { svg, facts };
}

/** The figure and its C++ must speak of the same fields. */
function checkFields(figure: AnyFigure, layout: Layout): void {
  const known = new Map(layout.inputs.map(({ name, size }) => [name, size]));
  for (const [name, size] of known) {
    const value: unknown = figure.initial[name];
    const length = Array.isArray(value) ? value.length : typeof value === "number" ? 1 : 0;
    if (length !== size)
      throw new Error(`initial.${name} must be ${size} number(s), as in the C++`);
  }
  const used = [...figure.handles, ...figure.controls].flatMap((one) =>
    one.kind === "states"
      ? one.options.flatMap(({ fields }: { fields: Fields }) => Object.keys(fields))
      : one.kind === "measure"
        ? [one.field, one.run, one.setting.field]
        : [one.field],
  );
  for (const name of [...Object.keys(figure.initial), ...used])
    if (!known.has(name)) throw new Error(`the C++ has no input ${name}`);
}
