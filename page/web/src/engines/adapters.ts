// The engines, in the order of the table. Each is loaded when it is first asked; a new one is a file in adapters/ and a
// line here.

import type { Adapter } from "./types.ts";

export const ADAPTERS: readonly (() => Promise<Adapter>)[] = [
  async () => (await import("./adapters/rapier3d.ts")).rapier3d,
  async () => (await import("./adapters/jolt.ts")).jolt,
  async () => (await import("./adapters/cannon.ts")).cannon,
  async () => (await import("./adapters/bvh.ts")).bvh,
  async () => (await import("./adapters/rapier2d.ts")).rapier2d,
  async () => (await import("./adapters/box2d.ts")).box2d,
  async () => (await import("./adapters/planck.ts")).planck,
  async () => (await import("./adapters/matter.ts")).matter,
];
