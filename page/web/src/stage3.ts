// Everything that needs three, so that a page without a figure in space never loads it.
export { orbit } from "./orbit.ts";
export { SpaceView } from "./view3.ts";
