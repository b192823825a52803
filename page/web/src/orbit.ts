// Turning a figure in space: three's OrbitControls on the drawing, with the two things a page
// needs changed. A finger that moves up or down scrolls the page, and the wheel is left to it too.

import { MOUSE, TOUCH } from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import type { SpaceView } from "./view3.ts";

export function orbit(view: SpaceView, stage: SVGSVGElement, changed: () => void): () => void {
  // Controls are written for an HTML element; what they use of it, an SVG element has as well.
  const controls = new OrbitControls(view.camera, stage as unknown as HTMLElement);
  controls.target.copy(view.target);
  controls.enablePan = false;
  controls.enableZoom = false;
  controls.minPolarAngle = (5 / 180) * Math.PI;
  controls.maxPolarAngle = (175 / 180) * Math.PI;
  controls.mouseButtons = { LEFT: MOUSE.ROTATE, MIDDLE: null, RIGHT: null };
  controls.touches = { ONE: TOUCH.ROTATE, TWO: null };
  stage.style.touchAction = "pan-y pinch-zoom";
  controls.addEventListener("change", () => {
    view.update();
    changed();
  });
  return () => controls.dispose();
}
