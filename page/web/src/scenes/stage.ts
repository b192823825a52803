// The canvas of a scene in the page: how a picture gets onto it, and when it must be painted again.

import type { Role } from "../scene.ts";
import { type Piece, paint } from "./picture.ts";

/** Paints pieces on an empty canvas, in the page's colours. @param width in pixels of the page, as `height` */
export function paintOn(
  canvas: HTMLCanvasElement,
  width: number,
  height: number,
  pieces: readonly Piece[],
): void {
  const context = canvas.getContext("2d");
  if (!context) return;
  const fine = Math.min(devicePixelRatio, 2);
  const wanted = [Math.round(width * fine), Math.round(height * fine)] as const;
  if (canvas.width !== wanted[0] || canvas.height !== wanted[1])
    [canvas.width, canvas.height] = wanted;
  context.setTransform(fine, 0, 0, fine, 0, 0);
  context.clearRect(0, 0, width, height);
  const style = getComputedStyle(canvas);
  const colours = new Map<string, string>();
  const colour = (role: Role | "paper"): string => {
    const known = colours.get(role) ?? style.getPropertyValue(`--contact-${role}`).trim();
    colours.set(role, known);
    return known;
  };
  paint(context, pieces, colour);
}

/** Calls `repaint` when an element changes its size or the page its colours, until what it returns is called. */
export function whenRepainted(element: Element, repaint: () => void): () => void {
  const sizes = new ResizeObserver(repaint);
  sizes.observe(element);
  const themes = new MutationObserver(repaint);
  themes.observe(document.body, { attributes: true, attributeFilter: ["data-theme"] });
  const dark = matchMedia("(prefers-color-scheme: dark)");
  dark.addEventListener("change", repaint);
  return () => {
    sizes.disconnect();
    themes.disconnect();
    dark.removeEventListener("change", repaint);
  };
}
