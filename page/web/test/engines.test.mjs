// "Ask the engines": that each engine is used rightly, that the exact answers are, and that asking again gives what is
// recorded (page/engines/recorded.json; node page/engines/record.mjs writes it). engines/queries and
// 20_scenes/scene_player are the book's own modules.

import assert from "node:assert/strict";
import fs from "node:fs";
import { before, describe, test } from "node:test";
import { loadAll, recordFile, written } from "../../engines/engines.mjs";

const record = JSON.parse(fs.readFileSync(recordFile, "utf8"));
/** What takes longer than this is asked again only in the nightly run, ms. */
const LONG = process.env.CONTACT_ALL ? 60_000 : 400;

/** @type {import("../../engines/engines.mjs").Library} */
let library;
/** @type {{ adapter: import("../src/engines/types.ts").Adapter, engine: import("../src/engines/types.ts").Engine }[]} */
let asked = [];
before(async () => {
  ({ library, asked } = await loadAll());
});

/** @param {(one: typeof asked[number]) => void} check */
const eachWorld = (check) => {
  const worlds = asked.filter(({ engine }) => engine.world);
  assert.ok(worlds.length >= 8);
  for (const one of worlds) check(one);
};

/** The settings of an engine with another step. @param {typeof asked[number]} one @param {number} step */
const withStep = ({ adapter }, step) => ({ ...library.defaultsOf(adapter), step });

describe("each engine is used rightly", () => {
  test("free fall of 1 s converges to the closed form, as the step does or faster", () => {
    const scene = {
      gravity: /** @type {const} */ ([0, -10, 0]),
      restitution: 0.5,
      friction: 0.5,
      bodies: [library.ball(0.5, [0, 20, 0], { mass: 1, velocity: [1, 0, 0] })],
    };
    eachWorld((one) => {
      const error = (/** @type {number} */ step) => {
        const [body] = library.finish(one.engine, scene, withStep(one, step), 1) ?? [];
        return Math.hypot((body?.position[0] ?? 0) - 1, (body?.position[1] ?? 0) - 15);
      };
      assert.ok(error(1 / 600) < 0.01, `${one.adapter.id}: ${error(1 / 600)}`);
      assert.ok(error(1 / 600) <= error(1 / 60) / 5 + 1e-4, one.adapter.id);
    });
  });

  test("a free body rotates by its angular velocity", () => {
    const scene = {
      gravity: /** @type {const} */ ([0, 0, 0]),
      restitution: 0,
      friction: 0,
      bodies: [library.box([0.5, 0.25, 0.5], [1, 2, 0], { mass: 2, spin: [0, 0, 1] })],
    };
    eachWorld((one) => {
      const [body] = library.finish(one.engine, scene, withStep(one, 1 / 240), 1) ?? [];
      const angle = library.planeAngle(body?.orientation ?? [0, 0, 0, 1]);
      assert.ok(Math.abs(angle - 1) < 1e-3, `${one.adapter.id}: ${angle}`);
    });
  });

  test("a rotated box begins as it was given", () => {
    const orientation = library.about([0, 0, 1], 0.5);
    const scene = {
      gravity: /** @type {const} */ ([0, 0, 0]),
      restitution: 0,
      friction: 0,
      bodies: [library.box([0.5, 0.25, 0.5], [1, 2, 0], { mass: 2, orientation })],
    };
    eachWorld((one) => {
      const [body] = library.finish(one.engine, scene, withStep(one, 1 / 60), 1 / 60) ?? [];
      const angle = library.planeAngle(body?.orientation ?? [0, 0, 0, 1]);
      assert.ok(Math.abs(angle - 0.5) < 1e-6, `${one.adapter.id}: ${angle}`);
      assert.ok(Math.abs((body?.position[1] ?? 0) - 2) < 1e-6, one.adapter.id);
    });
  });

  test("a light ball bounces off a heavy one: masses are as given", () => {
    const scene = {
      gravity: /** @type {const} */ ([0, 0, 0]),
      restitution: 1,
      friction: 0,
      bodies: [
        library.ball(0.5, [-2, 0, 0], { mass: 1, velocity: [4, 0, 0] }),
        library.ball(0.5, [0, 0, 0], { mass: 4 }),
      ],
    };
    eachWorld((one) => {
      const end = library.finish(one.engine, scene, withStep(one, 1 / 480), 1) ?? [];
      const [light, heavy] = end.map(({ position }) => position[0]);
      // Momentum: the centre of mass goes on at 0.8 m/s.
      const centre = ((light ?? 0) + 4 * (heavy ?? 0)) / 5;
      assert.ok(Math.abs(centre - 0.4) < 0.02, `${one.adapter.id}: ${centre}`);
      assert.ok((light ?? 0) < -1.5, `${one.adapter.id}: ${light}`);
    });
  });

  test("a ray and a distance of simple bodies have the right sign and size", () => {
    const ray = /** @type {const} */ ({ origin: [-4, 0, 0], direction: [1, 0, 0], length: 8 });
    const square = library.box([0.5, 0.5, 0.5], [0, 0, 0]);
    for (const { adapter, engine } of asked) {
      const hit = engine.ray?.(library.ball(0.25, [1, 0, 0]), ray, true) ?? 4.75;
      assert.ok(Math.abs(hit - 4.75) < 1e-5, `${adapter.id}: ${hit}`);
      const far = engine.distance?.(square, library.ball(0.25, [1, 0, 0]), true) ?? 0.25;
      assert.ok(Math.abs(far - 0.25) < 1e-5, `${adapter.id}: ${far}`);
      const deep = engine.depth?.(square, library.box([0.5, 0.5, 0.5], [0.9, 0, 0]), true) ?? -0.1;
      assert.ok(Math.abs(deep + 0.1) < 1e-5, `${adapter.id}: ${deep}`);
      const time = engine.impact?.(library.ball(0.5, [-5, 0, 0]), [2, 0, 0], square, true) ?? 2;
      assert.ok(Math.abs(time - 2) < 1e-4, `${adapter.id}: ${time}`);
      assert.equal(
        engine.ray?.(library.ball(0.25, [1, 3, 0]), ray, true) ?? Number.POSITIVE_INFINITY,
        Number.POSITIVE_INFINITY,
        adapter.id,
      );
    }
  });
});

describe("rays at a mesh", () => {
  test("each ray at the middle of a triangle hits it", () => {
    const mesh = {
      vertices: Float32Array.from([1, 1, 1, -1, -1, 1, -1, 1, -1, 1, -1, -1]),
      triangles: Uint32Array.from([0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3]),
    };
    const third = 1 / Math.sqrt(3);
    const directions = [
      [third, -third, -third],
      [-third, third, -third],
      [-third, -third, third],
      [third, third, third],
    ];
    // The faces are at a distance of 1/√3 from the centre; each ray comes from 3 m.
    const rays = directions.map(([x = 0, y = 0, z = 0]) => ({
      origin: /** @type {const} */ ([-3 * x, -3 * y, -3 * z]),
      direction: /** @type {const} */ ([x, y, z]),
      length: 6,
    }));
    for (const { adapter, engine } of asked)
      for (const distance of engine.meshHits?.(mesh, rays) ?? [])
        assert.ok(Math.abs(distance - (3 - third)) < 1e-4, `${adapter.id}: ${distance}`);
  });
});

describe("the exact answers", () => {
  test("an id, a lesson and an exact answer belong to each question", () => {
    const ids = library.QUESTIONS.map(({ id }) => id);
    assert.equal(new Set(ids).size, ids.length);
    assert.ok(ids.length >= 20);
    for (const { id, exact, lesson } of library.QUESTIONS) {
      assert.ok(Number.isFinite(exact.value), id);
      assert.ok(fs.existsSync(new URL(`../../../chapters/${lesson}`, import.meta.url)), id);
    }
  });

  test("the flip of the wing nut has the digits that are said", () => {
    assert.ok(Math.abs(library.flipTime(1 / 2048) - library.flipTime(1 / 4096)) < 1e-9);
  });

  test("the book finds each of them, except where touching balls have no unique answer", () => {
    const [{ adapter, engine }] = /** @type {[typeof asked[number]]} */ (asked);
    assert.equal(adapter.id, "book");
    for (const question of library.QUESTIONS) {
      if (question.id === "cradle-touching") continue;
      const answer = library.ask(question, adapter, engine, library.defaultsOf(adapter));
      assert.ok((answer?.error ?? Number.NaN) < 1e-8, `${question.id}: ${answer?.error}`);
    }
  });
});

describe("the record", () => {
  test("it is of the versions that are installed, and of these questions", () => {
    const said = record.engines.map((/** @type {any} */ { id, version }) => `${id} ${version}`);
    assert.deepEqual(
      said,
      asked.map(({ adapter }) => `${adapter.id} ${adapter.version}`),
    );
    const facts = library.QUESTIONS.map(({ ask: _, ...about }) => about);
    assert.deepEqual(record.questions, JSON.parse(JSON.stringify(facts)));
  });

  test("asked again, all give the recorded values", () => {
    /** @type {string[]} */
    const changed = [];
    /** @param {string} what @param {any} old @param {import("../src/engines/types.ts").Answer | undefined} now */
    const compare = (what, old, now) => {
      if (old?.value !== (now && written(now.value)))
        changed.push(`${what}: recorded ${old?.value}, now ${now?.value}`);
    };
    for (const question of library.QUESTIONS)
      for (const { adapter, engine } of asked) {
        const old = record.answers[question.id][adapter.id];
        const name = `${question.id}, ${adapter.id}`;
        if (!(old?.ms > LONG))
          compare(name, old, library.ask(question, adapter, engine, library.defaultsOf(adapter)));
        if (old?.best && old.best.ms <= LONG)
          compare(
            `${name}, best`,
            old.best,
            library.ask(question, adapter, engine, old.best.settings),
          );
      }
    assert.deepEqual(
      changed,
      [],
      "an engine or the book has changed: node page/engines/record.mjs records it anew",
    );
  });
});
