// The scene that the page opens with: its small module has the same bits as the player's, and its
// reader refuses every other kind of scene.

import assert from "node:assert/strict";
import fs from "node:fs";
import path from "node:path";
import { before, describe, test } from "node:test";
import { fileURLToPath } from "node:url";
import { load } from "./load.mjs";

const root = fileURLToPath(new URL("../../../", import.meta.url));
const folder = path.join(root, "chapters", "20_scenes", "scenes");
const text = (/** @type {string} */ name) =>
  fs.readFileSync(path.join(folder, `${name}.json`), "utf8");
const module = (/** @type {string} */ name) =>
  fs.readFileSync(path.join(root, "build", "web", "scenes", `${name}.wasm`));
const FIRST = "billiards_break";

/** @type {typeof import("../src/scenes/opening.ts")} */
let openings;
/** @type {typeof import("../src/scenes/simulation.ts")} */
let library;
/** @type {import("../src/scenes/simulation.ts").Simulation} */
let simulation;

before(async () => {
  openings = await load("scenes/opening.ts");
  library = await load("scenes/simulation.ts");
  simulation = await library.Simulation.start(module("player"));
});

/** The scene, changed by a function. @param {(scene: any) => void} change */
function changed(change) {
  const scene = JSON.parse(text(FIRST));
  change(scene);
  return JSON.stringify(scene);
}

/** The bits of numbers, −0 told from 0. @param {Float64Array} numbers */
const bits = (numbers) => [...new BigUint64Array(numbers.slice().buffer)];

/** The scene in the player, as planned. @param {string} given */
function planned(given) {
  const opened = simulation.open(given, "scene.json", { with: [], without: [] });
  assert.ok(!("wrong" in opened), JSON.stringify(opened));
  return opened;
}

/**
 * Compares the opening with the player as planned, at the ends of `steps` equal parts of the scene.
 * @param {string} given @param {number} steps @returns the hits
 */
async function compare(given, steps) {
  const opened = planned(given);
  const scene = openings.readOpening(given);
  assert.deepEqual(scene.bodies, opened.scene.bodies);
  assert.equal(scene.duration, opened.scene.duration);
  assert.equal(scene.about, opened.scene.about);
  const run = await openings.OpeningRun.start(module("opening"), scene);
  let hits = 0;
  for (let i = 0; i <= steps; ++i) {
    const until = (scene.duration * i) / steps;
    assert.equal(simulation.advance(0, until, Number.MAX_SAFE_INTEGER), library.REACHED);
    assert.ok(run.advance(until, 1e9));
    const theirs = simulation.frame(0);
    const ours = run.frame();
    assert.ok(theirs?.eventDriven);
    assert.equal(ours.time, theirs.time);
    assert.equal(ours.hits, theirs.hits, `hits until ${until} s`);
    assert.deepEqual(bits(ours.bodies), bits(theirs.bodies), `positions after ${until} s`);
    hits = ours.hits;
  }
  return hits;
}

describe("the opening and the player, bit for bit", () => {
  test("the scene that the page opens with, at 41 times", async () => {
    assert.ok((await compare(text(FIRST), 40)) > 50);
  });

  test("balls of different sizes and masses, all moving", async () => {
    const given = changed(({ bodies }) => {
      for (const [i, body] of bodies.entries()) {
        if (body.shape.type !== "sphere") continue;
        body.shape.radius *= 1 - i / 64;
        body.mass *= i;
        body.velocity = [1 - i, i / 2 - 4, 0];
      }
    });
    assert.ok((await compare(given, 10)) > 100);
  });
});

test("stopping on the way and starting again change no bit", async () => {
  const scene = openings.readOpening(text(FIRST));
  const run = await openings.OpeningRun.start(module("opening"), scene);
  run.advance(scene.duration, 1e9);
  const end = bits(run.frame().bodies);
  run.restart();
  assert.equal(run.frame().time, 0);
  assert.equal(run.frame().hits, 0);
  for (let i = 0; run.frame().time < scene.duration; ++i) run.advance(scene.duration, 1 + (i % 3));
  assert.deepEqual(bits(run.frame().bodies), end);
});

test("the other scenes that it reads, and that are planned from event to event: the same bits too", async () => {
  let compared = 0;
  for (const file of fs.readdirSync(folder)) {
    const given = text(path.basename(file, ".json"));
    try {
      openings.readOpening(given);
    } catch {
      continue;
    }
    const [side] = planned(given).sides;
    if (!side || !("event_driven" in side) || !side.event_driven) continue;
    await compare(given, 4);
    ++compared;
  }
  assert.ok(compared > 3, `only ${compared}`);
});

describe("a scene of another kind is refused", () => {
  /** @type {[string, (scene: any) => void, RegExp][]} */
  const others = [
    ["gravity", (scene) => scene.gravity.splice(1, 1, 1e-300), /gravity is not 0/],
    ["friction", ({ materials }) => (materials[0].friction = 0.1), /friction is not 0/],
    ["restitution", ({ materials }) => (materials[0].restitution = 0.9), /restitution is not 1/],
    ["a spring", ({ materials }) => (materials[0].stiffness = 1), /materials\[0\]\.stiffness/],
    ["a box", ({ bodies }) => (bodies[5].shape.type = "box"), /bodies\[5\]\.shape\.type/],
    ["a fixed ball", ({ bodies }) => (bodies[4].moves = false), /bodies\[4\]\.moves/],
    ["many of one", ({ bodies }) => (bodies[4].repeat = { count: [2, 1, 1] }), /\[4\]\.repeat/],
    ["rotation", ({ bodies }) => (bodies[4].angular_velocity = [0, 0, 1]), /angular_velocity/],
    ["height", ({ bodies }) => (bodies[4].position[2] = 1e-9), /position leaves the plane/],
    ["upward", ({ bodies }) => (bodies[4].velocity[2] = 1e-9), /velocity leaves the plane/],
    ["oblique", ({ bodies }) => (bodies[0].shape.normal = [0.6, 0.8, 0]), /along no axis/],
    ["a floor", ({ bodies }) => (bodies[0].shape.normal = [0, 0, 1]), /leaves the plane/],
    ["no mass", ({ bodies }) => delete bodies[4].mass, /bodies\[4\] has no mass/],
    ["no size", ({ bodies }) => (bodies[4].shape.radius = 0), /radius is not greater than 0/],
    ["no ball", (scene) => (scene.bodies = scene.bodies.slice(0, 4)), /no ball moves/],
    ["another format", (scene) => (scene.format = "contact-scene/2"), /format is not/],
    ["another key", (scene) => (scene.wind = 1), /scene\.wind is not known/],
  ];
  for (const [name, change, message] of others)
    test(name, () => assert.throws(() => openings.readOpening(changed(change)), { message }));
});
