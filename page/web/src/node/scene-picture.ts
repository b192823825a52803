// The fallback picture of the scene player: the same C++ and the same drawing as in the page, run in
// Node when the book is built.

import { pictureStyle } from "../../palette.mjs";
import { pretty } from "../numbers.ts";
import { Picture, piecesToSvg } from "../scenes/picture.ts";
import { REACHED, Simulation } from "../scenes/simulation.ts";
import { escapeText } from "../shapes.ts";

const WIDTH = 600;
const HEIGHT = 400;
/** How much of a scene has been played in its picture. */
const PLAYED = 0.1;

export interface ScenePicture {
  readonly svg: string;
  readonly facts: { readonly first: string; readonly describe: string };
}

/** @param text the scene, which must be one that can be run */
export async function drawScene(
  wasm: Uint8Array,
  name: string,
  text: string,
): Promise<ScenePicture> {
  const simulation = await Simulation.start(wasm as BufferSource);
  const opened = simulation.open(text, `${name}.json`, { with: [], without: [] });
  if ("wrong" in opened) throw new Error(opened.wrong);
  const first = simulation.frame(0);
  const until = opened.scene.duration * PLAYED;
  if (!first || simulation.advance(0, until, Number.MAX_SAFE_INTEGER) !== REACHED)
    throw new Error(`${name} cannot be run: ${simulation.trouble()}`);
  const frame = simulation.frame(0)!;
  const pieces = new Picture(opened.scene, first).pieces([frame], WIDTH, HEIGHT);
  const drawn = piecesToSvg(pieces);
  const describe =
    `${opened.scene.about} The picture shows it after ${pretty(until)} s ` +
    `and ${frame.hits.toLocaleString("en")} hits.`;
  const svg =
    `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${WIDTH} ${HEIGHT}" width="${WIDTH}" height="${HEIGHT}" role="img">` +
    `<title>${escapeText(name)}</title><desc>${escapeText(describe)}</desc>` +
    `<style>${pictureStyle(drawn)}</style>` +
    `<rect class="paper" width="${WIDTH}" height="${HEIGHT}"/>${drawn}</svg>\n`;
  return { svg, facts: { first: name, describe } };
}
