// The scene player's logic, and its C++ as WebAssembly: the same module as in the page, in Node.

import assert from "node:assert/strict";
import { execFileSync, spawnSync } from "node:child_process";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { after, before, describe, test } from "node:test";
import { fileURLToPath } from "node:url";
import { load } from "./load.mjs";

const root = fileURLToPath(new URL("../../../", import.meta.url));
const folder = path.join(root, "chapters", "20_scenes", "scenes");
const bin = process.env.CONTACT_PROGRAMS ?? path.join(root, "build", "dev", "bin");
const contact = path.join(bin, "contact");
const text = (/** @type {string} */ name) =>
  fs.readFileSync(path.join(folder, `${name}.json`), "utf8");
const nothing = { with: [], without: [] };
const names = fs.readdirSync(folder).map((file) => path.basename(file, ".json"));

/** @type {typeof import("../src/scenes/simulation.ts")} */
let library;
/** @type {typeof import("../src/scenes/model.ts")} */
let models;
/** @type {typeof import("../src/scenes/pace.ts")} */
let paces;
/** @type {typeof import("../src/scenes/picture.ts")} */
let pictures;
/** @type {import("../src/scenes/simulation.ts").Simulation} */
let simulation;
const temporary = fs.mkdtempSync(path.join(os.tmpdir(), "contact-scenes-"));
after(() => fs.rmSync(temporary, { recursive: true, force: true }));

before(async () => {
  library = await load("scenes/simulation.ts");
  models = await load("scenes/model.ts");
  paces = await load("scenes/pace.ts");
  pictures = await load("scenes/picture.ts");
  simulation = await library.Simulation.start(
    fs.readFileSync(path.join(root, "build", "web", "scenes", "player.wasm")),
  );
});

/** @param {string} name @param {import("../src/scenes/messages.ts").Overrides} overrides */
function opened(name, overrides = nothing) {
  const found = simulation.open(text(name), `${name}.json`, overrides);
  assert.ok(!("wrong" in found), JSON.stringify(found));
  return found;
}

/** Runs a side to a time in slices of so many hits or steps. */
function runTo(/** @type {number} */ side, /** @type {number} */ until, budget = 1e9) {
  let end = library.MORE;
  while (end === library.MORE) end = simulation.advance(side, until, budget);
  assert.equal(end, library.REACHED, simulation.trouble());
  return /** @type {NonNullable<ReturnType<typeof simulation.frame>>} */ (simulation.frame(side));
}

/**
 * The last places of all that moves, as `contact simulate` writes them: a table of time, body, x, y, z.
 * @param {string} name @param {number} until @param {string[]} words
 */
function native(name, until, words) {
  const file = path.join(temporary, `${name}.csv`);
  fs.rmSync(file, { force: true });
  const where = ["--until", String(until), "--every", "0", "--output", file, ...words];
  execFileSync(contact, ["simulate", path.join(folder, `${name}.json`), ...where], {
    env: { ...process.env, CONTACT_ROOT: root },
    stdio: ["ignore", "ignore", "pipe"],
  });
  return fs.readFileSync(file, "utf8");
}

/** How much of a scene is run, s, where all of it would take long. @type {Record<string, number>} */
const SHORTER = { ball_pit: 0.05, bowling: 1, dominoes: 0.3, stack_of_ten: 1 };

/** Runs with something switched. @type {[string, import("../src/scenes/messages.ts").Overrides][]} */
const SWITCHED = [
  ["high_drop", { with: [], without: ["gravity"] }],
  ["high_drop", { with: [], without: [], step: 0.01 }],
  ["bouncing_ball", { with: [], without: ["restitution"] }],
  ["billiards_break", { with: [], without: ["event-driven"] }],
  ["sliding_block", { with: [], without: ["friction"] }],
  ["dominoes", { with: [], without: ["rotation"] }],
];

describe("same scene, same bytes, natively and in the page", () => {
  for (const [name, overrides] of [...names.map((name) => [name, nothing]), ...SWITCHED]) {
    const words = overrides.without.flatMap((effect) => ["--without", effect]);
    if ("step" in overrides) words.push("--step", String(overrides.step));
    test([name, ...words].join(" "), () => {
      const { scene, sides } = opened(name, overrides);
      const side = sides.length - 1;
      const end = SHORTER[name] ?? scene.duration;
      // Where it stops on the way must change nothing.
      runTo(side, end / 3, 7);
      const frame = runTo(side, end, 1000);
      const rows = native(name, end, words).trim().split("\n");
      const heads = (rows[0] ?? "").split(",");
      assert.deepEqual(heads.slice(0, 5), ["time", "body", "x", "y", "z"]);
      // A table has orientations only if something in it can turn.
      const columns = ["x", "y", "z", "qw", "qx", "qy", "qz"].map((head) => heads.indexOf(head));
      const bodies = new Map(scene.bodies.map((body, i) => [body.name, i]));
      const last = rows.slice(1).filter((row) => Number(row.split(",")[0]) === end);
      const seen = new Set();
      for (const row of last) {
        const cells = row.split(",");
        const i = /** @type {number} */ (bodies.get(cells[1] ?? ""));
        for (const [k, column] of columns.entries())
          if (column >= 0)
            assert.ok(Object.is(frame.bodies[7 * i + k], Number(cells[column])), row);
        if (scene.bodies[i]?.moves) seen.add(i);
      }
      assert.equal(seen.size, scene.bodies.filter(({ moves }) => moves).length);
    });
  }
});

test("every scene of the book is read and planned, with the numbers of `contact plan`", () => {
  for (const name of names) {
    const { plan } = opened(name);
    const said = JSON.parse(
      execFileSync(contact, ["plan", path.join(folder, `${name}.json`), "--json"], {
        env: { ...process.env, CONTACT_ROOT: root },
        maxBuffer: 1 << 26,
      }).toString(),
    );
    const shared = plan.decisions.map(({ says, switched, ...rest }) => rest);
    assert.deepEqual(shared, said.decisions, name);
    assert.deepEqual(plan.notices, said.notices, name);
    assert.equal(plan.error, said.error, name);
    assert.equal(plan.tolerance, said.tolerance, name);
    const endless = said.decisions.some(({ error }) => error === null);
    assert.ok(endless ? said.error === null : said.error <= said.tolerance, name);
  }
});

test("a broken scene gets the words of `contact scene check`, with the path in the file", () => {
  const broken = text("head_on").replace('"mass": ', '"mass": -');
  assert.notEqual(broken, text("head_on"));
  const file = path.join(temporary, "broken.json");
  fs.writeFileSync(file, broken);
  const found = simulation.open(broken, file, nothing);
  assert.ok("wrong" in found);
  assert.match(found.wrong, /broken\.json:\d+: bodies\[\d+\]\.mass = -/);
  const check = spawnSync(contact, ["scene", "check", file], {
    env: { ...process.env, CONTACT_ROOT: root },
    encoding: "utf8",
  });
  assert.ok(`${check.stdout}${check.stderr}`.includes(found.wrong), check.stdout + check.stderr);
  const torn = simulation.open("{", "torn.json", nothing);
  assert.ok("wrong" in torn && torn.wrong.startsWith("torn.json:1"), JSON.stringify(torn));
  // It goes on with the next scene.
  assert.equal(opened("head_on").scene.name, "head_on");
});

test("an override makes a second run; how far it is off is measured", () => {
  const { sides } = opened("high_drop", { with: [], without: ["gravity"] });
  assert.equal(sides.length, 2);
  const gravity = sides[1]?.plan?.decisions.find(({ effect }) => effect === "gravity");
  assert.deepEqual([gravity?.on, gravity?.planned, gravity?.overridden], [false, true, true]);
  assert.equal(sides[1]?.plan?.error, null);
  assert.match(sides[1]?.plan?.accepted ?? "", /no bound/);
  const until = 1;
  const planned = runTo(0, until);
  const other = runTo(1, until);
  // Without gravity it stays where it was; with it, it has fallen by g t²/2.
  const { scene } = opened("high_drop");
  const ball = scene.bodies.findIndex(({ moves }) => moves);
  const fallen = Math.abs(scene.gravity[2]) / 2;
  assert.equal(other.farthest, ball);
  assert.ok(Math.abs(other.apart - fallen) < 1e-12 * fallen, `${other.apart}`);
  assert.equal(planned.apart, 0);
  assert.ok(Math.abs(planned.energy - planned.firstEnergy) <= 1e-12 * planned.firstEnergy);
  assert.equal(simulation.frame(1), undefined);
});

test("an effect that is a value is not switched, and says so", () => {
  assert.throws(
    () => simulation.open(text("high_drop"), "x", { with: ["horizon"], without: [] }),
    /horizon/,
  );
  assert.equal(opened("high_drop").scene.name, "high_drop");
});

test("the switches: back to the plan is no override", () => {
  const model = new models.PlayerModel();
  const high = opened("high_drop");
  model.open(high);
  model.begin(high.sides, []);
  assert.deepEqual(model.accounts(), [high.plan.accepted]);
  const other = opened("high_drop", { with: [], without: ["gravity"] });
  model.begin(other.sides, []);
  assert.deepEqual(model.accounts(), [
    `As planned: ${high.plan.accepted}`,
    `As you switch it: ${other.sides[1]?.plan?.accepted}`,
  ]);
  model.begin(high.sides, []);
  const gravity = () => model.rows().find(({ effect }) => effect === "gravity");
  assert.deepEqual([gravity()?.planned, gravity()?.on], ["on", true]);
  model.set("gravity", false);
  assert.deepEqual(model.overrides, { with: [], without: ["gravity"] });
  assert.ok(gravity()?.overridden && gravity()?.on === false);
  model.set("gravity", true);
  assert.deepEqual(model.overrides, nothing);
  assert.equal(model.isOverridden, false);
  model.step = 0.01;
  assert.equal(model.isOverridden, true);
  model.forget();
  assert.equal(model.isOverridden, false);
  const values = model.rows().filter(({ on }) => on === undefined);
  assert.deepEqual(
    values.map(({ effect }) => effect),
    ["step-size", "horizon"],
  );
});

test("the cost is that of the last pictures, of each run by itself", () => {
  const model = new models.PlayerModel();
  const { sides } = opened("high_drop", { with: [], without: ["gravity"] });
  const at = (/** @type {number} */ time) =>
    sides.map((_, side) => ({ .../** @type {any} */ (simulation.frame(side)), time }));
  model.begin(sides, at(0));
  assert.equal(model.cost(0), undefined);
  // The first picture takes a second of computing, all later ones 2 ms and 1 ms.
  for (let i = 1; i <= 100; ++i) model.show(at(i / 4), [1000 + 2 * i, i]);
  assert.equal(model.cost(0), 8);
  assert.equal(model.cost(1), 4);
  const row = model.quantities().find(({ name }) => name.startsWith("computing"));
  assert.deepEqual(row?.values, ["8 ms", "4 ms"]);
});

test("the clock: at most one picture's time is made up for, and the end is the end", () => {
  const { nextTime, paceFor, watchablePace } = paces;
  assert.equal(nextTime(1, 0.01, 2, 100), 1.02);
  assert.equal(nextTime(1, 100, 3, 100), 1 + 3 / 30);
  assert.equal(nextTime(99.99, 1, 10, 100), 100);
  assert.equal(nextTime(1, -1, 10, 100), 1);
  assert.equal(paceFor(5), 1);
  assert.equal(watchablePace(2), 0.25);
  for (const duration of [1e-3, 1 / 60, 0.3, 60, 3600]) {
    const seconds = duration / paceFor(duration);
    assert.ok(seconds > 1 && seconds < 30, `${duration} s in ${seconds} s`);
  }
});

test("a picture: balls where they are, walls cut by each other, all on the stage", () => {
  const { scene } = opened("billiards_break");
  const frame = /** @type {any} */ (simulation.frame(0));
  const picture = new pictures.Picture(scene, frame);
  const pieces = picture.pieces([frame], 600, 400);
  const discs = pieces.filter(({ kind }) => kind === "disc");
  assert.equal(discs.length, scene.bodies.filter(({ shape }) => shape.type === "sphere").length);
  for (const { at } of /** @type {any[]} */ (discs))
    assert.ok(at[0] > 0 && at[0] < 600 && at[1] > 0 && at[1] < 400, String(at));
  const both = picture.pieces([frame, { ...frame, side: 1 }], 600, 400);
  assert.equal(both.filter((piece) => "dashed" in piece && piece.dashed).length, 16);
  assert.match(pictures.piecesToSvg(pieces), /<circle [^>]*class="face outlined r-ball"/);
  const square = /** @type {const} */ ([
    [0, 0],
    [1, 0],
    [0.5, 0.5],
    [1, 1],
    [0, 1],
  ]);
  assert.equal(pictures.outline(square).length, 4);
});
