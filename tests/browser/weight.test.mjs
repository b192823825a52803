// A page stays light before anything is pressed: on a slow line it is there in seconds.

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import path from "node:path";
import { test } from "node:test";
import { completeLessons, notRun, root, site } from "./browser.mjs";

// With the numbers of the ladder, an input for each of its cells that fails, and "try mine". The heaviest are the lessons on
// meshes: each of their three figures has exact arithmetic and a tree of boxes in it.
const LIMIT = 400;

// The page with the scene player, whose first scene moves.
const OPENING = "chapters/20_scenes.html";
const OPENING_LIMIT = 300;

const skip = notRun();
const weigh = path.join(root, "page", "web", "weight.mjs");

test(`${OPENING} with its moving scene is not over ${OPENING_LIMIT} kB`, { skip }, (t) => {
  if (!skip && !completeLessons().includes(OPENING)) return t.skip("not built in this turn");
  const { status, stdout, stderr } = spawnSync(
    process.execPath,
    [weigh, OPENING, "--site", site, "--limit", String(OPENING_LIMIT)],
    { encoding: "utf8" },
  );
  console.log(stdout.trim());
  assert.equal(status, 0, stderr);
});

test(`no lesson whose figures are built is over ${LIMIT} kB compressed`, { skip }, () => {
  const { status, stdout, stderr } = spawnSync(
    process.execPath,
    [weigh, ...completeLessons(), "--site", site, "--limit", String(LIMIT)],
    { encoding: "utf8" },
  );
  console.log(stdout.trim());
  assert.equal(status, 0, stderr);
  assert.match(stdout, /together +\d+\.\d kB/);
});
