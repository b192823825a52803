import assert from "node:assert/strict";
import test from "node:test";
import { load } from "./load.mjs";

const { SpaceView } = await load("view3.ts");
const { FlatView } = await load("view2.ts");
const { Scene } = await load("scene.ts");
const { shapesToSvg } = await load("shapes.ts");

const near = (got, wanted, within = 1e-6) => {
  assert.equal(got.length, wanted.length);
  for (const [i, value] of got.entries())
    assert.ok(Math.abs(value - wanted[i]) <= within, `${got} is not ${wanted}`);
};
const space = (more = {}) => {
  const view = new SpaceView({
    kind: "3d",
    target: [1, 2, 3],
    azimuth: -60,
    elevation: 20,
    span: 4,
    ...more,
  });
  view.resize(400, 300);
  return view;
};

test("the target is in the middle, and up is up", () => {
  for (const projection of ["perspective", "orthographic"]) {
    const view = space({ projection });
    near(view.toScreen([1, 2, 3]), [200, 150]);
    const above = view.toScreen([1, 2, 4]);
    near([above[0]], [200]);
    assert.ok(above[1] < 150);
  }
});

test("from −90° the x axis points right", () => {
  const view = space({ azimuth: -90, elevation: 0, projection: "orthographic" });
  near(view.toScreen([2, 2, 3]), [200 + 300 / 4, 150]);
});

test("the span fits the smaller side, also in a tall picture", () => {
  const view = space({ azimuth: -90, elevation: 0, projection: "orthographic" });
  view.resize(200, 600);
  near(view.toScreen([3, 2, 3]), [200, 300]);
  const deep = space({ azimuth: -90, elevation: 0 });
  deep.resize(200, 600);
  near(deep.toScreen([3, 2, 3]), [200, 300]);
});

test("a point dragged to where it is stays there; a level move keeps the height, a vertical one y", () => {
  const view = space();
  const point = [0.3, 1.4, 2.2];
  near(view.dragged(point, view.toScreen(point), "picture"), point);
  near(view.dragged(point, view.toScreen(point), "level"), point);
  const [x, y] = view.toScreen(point);
  const moved = view.dragged(point, [x + 25, y - 8], "level");
  near([moved[2]], [2.2]);
  near(view.toScreen(moved), [x + 25, y - 8]);
  const vertical = view.dragged(point, [x + 25, y - 8], "vertical");
  near([vertical[1]], [1.4]);
  near(view.toScreen(vertical), [x + 25, y - 8]);
  near(view.toScreen(view.dragged(point, [x - 30, y + 12], "picture")), [x - 30, y + 12]);
});

test("what is behind the eye has no place", () => {
  const view = space();
  const { x, y, z } = view.camera.position;
  assert.equal(view.toScreen([2 * x - 1, 2 * y - 2, 2 * z - 3]), undefined);
});

test("looking somewhere is where the eye is", () => {
  const view = space();
  view.look({ azimuth: 35, elevation: -12 });
  near([view.eye.azimuth, view.eye.elevation], [35, -12]);
});

test("arrow keys follow the picture", () => {
  const view = space({ azimuth: -90 });
  assert.deepEqual(view.keyStep("ArrowRight"), [1, 0, 0]);
  near(view.keyStep("ArrowUp"), [0, 1, 0]);
  assert.deepEqual(view.keyStep("PageUp"), [0, 0, 1]);
  assert.equal(view.keyStep("Tab"), undefined);
  const [x] = view.toScreen([1, 2, 3]);
  for (const azimuth of [-170, -100, -30, 20, 80, 140]) {
    view.look({ azimuth, elevation: 15 });
    const step = view.keyStep("ArrowRight");
    assert.ok(view.toScreen([1 + step[0], 2 + step[1], 3 + step[2]])[0] > x, `azimuth ${azimuth}`);
  }
});

test("the part of a line behind a face is dashed, the rest is not", () => {
  const view = space({ target: [0, 0, 0], azimuth: -90, elevation: 30 });
  const scene = new Scene();
  const square = [
    [-1, -1, 0],
    [1, -1, 0],
    [1, 1, 0],
    [-1, 1, 0],
  ];
  scene.face(square, { role: "surface", hides: true });
  scene.line([0, 0, 1], [0, 0, -0.5], { role: "ray" });
  const lines = view.project(scene).filter(({ kind, role }) => kind === "line" && role === "ray");
  assert.deepEqual(lines.map(({ dashed }) => dashed).sort(), [false, true]);
  const hidden = lines.find(({ dashed }) => dashed);
  near(hidden.points[0], view.toScreen([0, 0, 0]), 0.5);
  near(hidden.points[1], view.toScreen([0, 0, -0.5]), 0.5);
});

test("a line that comes out from under a face is whole again", () => {
  const view = space({ target: [0, 0, 0], azimuth: -90, elevation: 80 });
  const scene = new Scene();
  scene.face(
    [
      [-1, -1, 0],
      [1, -1, 0],
      [0, 1, 0],
    ],
    { role: "surface", hides: true },
  );
  scene.line([-3, -0.5, -0.1], [3, -0.5, -0.1], { role: "ray" });
  const lines = view.project(scene).filter(({ kind }) => kind === "line");
  assert.equal(lines.filter(({ dashed }) => dashed).length, 1);
  assert.equal(lines.filter(({ dashed }) => !dashed).length, 2);
});

test("a ball hides what is behind it and not what is before it", () => {
  const view = space({ target: [0, 0, 0], azimuth: -90, elevation: 0 });
  const scene = new Scene();
  scene.ball([0, 0, 0], 0.5, { role: "ball", hides: true });
  scene.line([-2, 1, 0], [2, 1, 0], { role: "ray" });
  scene.line([-2, -1, 0], [2, -1, 0], { role: "hit" });
  const lines = view.project(scene).filter(({ kind }) => kind === "line");
  assert.equal(lines.filter(({ role, dashed }) => role === "ray" && dashed).length, 1);
  assert.equal(lines.filter(({ role, dashed }) => role === "ray" && !dashed).length, 2);
  assert.deepEqual(
    lines.filter(({ role }) => role === "hit").map(({ dashed }) => dashed),
    [false],
  );
});

test("faces are drawn from far to near", () => {
  const view = space({ target: [0, 0, 0], azimuth: -90, elevation: 10 });
  const scene = new Scene();
  for (const [role, y] of [
    ["a", 0],
    ["b", -2],
    ["c", 3],
  ])
    scene.face(
      [
        [-1, y, 0],
        [1, y, 0],
        [0, y, 1],
      ],
      { role },
    );
  const order = view.project(scene).map(({ role }) => role);
  assert.deepEqual(order, ["c", "a", "b"]);
});

test("points far away, behind the eye or not finite leave finite coordinates", () => {
  const far = [1e12, -1e9, 3e11];
  for (const view of [space(), new FlatView({ kind: "2d", x: [-1, 1], y: [-1, 1], grid: 0.5 })]) {
    view.resize(300, 300);
    const scene = new Scene();
    scene.line([0, 0, 0], far, { role: "ray", arrow: true });
    scene.line([0, 0, 0], [Number.NaN, 0, 0], { role: "miss" });
    scene.face([far, [0, 0, 0], [1, 0, 0]], { role: "surface", hides: true });
    scene.patch([0, 0, 0], [0, 0, 0], 1, { role: "surface" });
    scene.ball([0, 0, 0], 1e9, { role: "ball", hides: true });
    const svg = shapesToSvg(view.project(scene));
    assert.doesNotMatch(svg, /NaN|Infinity|undefined|r-miss/);
    for (const [number] of svg.matchAll(/-?\d+(?:\.\d+)?(?=[,"])/g))
      assert.ok(Math.abs(Number(number)) < 5000, number);
  }
});

test("the flat view keeps shape and fits what it must show", () => {
  const view = new FlatView({ kind: "2d", x: [-2, 2], y: [0, 1] });
  view.resize(424, 300);
  near(view.toScreen([0, 0.5]), [212, 150]);
  near(view.toScreen([2, 0.5]), [412, 150]);
  near(view.toScreen([0, 1.5]), [212, 50]);
  near(view.dragged([0, 0], view.toScreen([1.25, 0.75])), [1.25, 0.75]);
});

test("words are escaped, and subscripts lowered", () => {
  const view = new FlatView({ kind: "2d", x: [-1, 1], y: [-1, 1] });
  view.resize(100, 100);
  const svg = shapesToSvg(view.project(new Scene().label([0, 0], "w_a < 1 & 2")));
  assert.match(svg, /w<tspan[^>]*>a<\/tspan>.*&lt; 1 &amp; 2/);
});

test("a path through one point, or through none, draws nothing", () => {
  const flat = new FlatView({ kind: "2d", x: [0, 4], y: [0, 3] });
  flat.resize(400, 300);
  for (const points of [[], [[1, 2]]]) {
    const scene = new Scene().path(points, { role: "ink" });
    assert.deepEqual(flat.project(scene), []);
  }
  for (const points of [[], [[1, 2, 3]]]) {
    const scene = new Scene().path(points, { role: "ink" });
    assert.deepEqual(space().project(scene), []);
  }
});
