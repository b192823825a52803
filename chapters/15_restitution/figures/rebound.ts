// A ball that meets a surface. The velocity is split into its normal and its tangential component;
// the dashed arrow is the reflection by a mirror.

import { defineFigure, pretty, type Vec2 } from "@contact/figure";

interface Input {
  from: Vec2;
  facing: Vec2;
  k: number;
  friction: number;
  turns: number;
  beside: number;
}

interface Output {
  approaching: number;
  normal: Vec2;
  before: Vec2;
  after: Vec2;
  normal_before: Vec2;
  along_before: Vec2;
  normal_after: Vec2;
  along_after: Vec2;
  mirror: Vec2;
  wrong: Vec2;
  untested: Vec2;
  angle_in: number;
  angle_out: number;
  closing: number;
  parting: number;
  kept: number;
  stays: number;
}

const ORIGIN: Vec2 = [0, 0];
const plus = (a: Vec2, b: Vec2): Vec2 => [a[0] + b[0], a[1] + b[1]];
const times = (a: Vec2, s: number): Vec2 => [a[0] * s, a[1] * s];

export default defineFigure<Input, Output>({
  title: "Incidence and rebound",
  view: { kind: "2d", x: [-5.4, 5.4], y: [-1.6, 5] },
  aspect: 1.45,
  initial: { from: [-3, 4], facing: [0, 2.4], k: 0.6, friction: 0, turns: 0, beside: 0 },
  handles: [
    {
      kind: "point",
      field: "from",
      label: "origin of the ball's path",
      role: "ray",
      step: 0.1,
      limit: [-4.8, 4.8],
    },
    {
      kind: "point",
      field: "facing",
      label: "normal of the surface",
      role: "normal",
      step: 0.1,
      limit: [-3, 4],
    },
  ],
  controls: [
    { kind: "slider", field: "k", label: "k", min: 0, max: 1, step: 0.01 },
    { kind: "slider", field: "friction", label: "μ", min: 0, max: 1, step: 0.01 },
    {
      kind: "choice",
      field: "turns",
      label: "the body",
      options: [
        { value: 0, label: "does not rotate" },
        { value: 1, label: "is a solid ball" },
      ],
    },
    {
      kind: "choice",
      field: "beside",
      label: "beside v′",
      options: [
        { value: 0, label: "the mirror" },
        { value: 1, label: "−k v" },
        { value: 2, label: "no test for approach" },
      ],
    },
  ],
  draw(scene, input, output) {
    if (output.problem) {
      scene.arrow(input.from, ORIGIN, { role: "ray", width: 2.5 });
      return;
    }
    const { normal, after } = output;
    const along: Vec2 = [normal[1], -normal[0]];
    scene.face(
      [
        times(along, -7),
        times(along, 7),
        plus(times(along, 7), times(normal, -0.35)),
        plus(times(along, -7), times(normal, -0.35)),
      ],
      { role: "surface", fill: 0.25, outline: false },
    );
    scene.line(times(along, -7), times(along, 7), { role: "surface", width: 2.5 });
    scene.arrow(ORIGIN, input.facing, { role: "normal", width: 2, dashed: true });
    scene.label(input.facing, "N", { role: "normal", offset: [10, -6] });

    scene.arrow(input.from, ORIGIN, { role: "ray", width: 3 });
    scene.label(times(input.from, 0.55), "v", { role: "ray", offset: [-16, 2], anchor: "end" });
    if (!output.approaching) {
      scene.arrow(ORIGIN, after, { role: "ray", width: 3 });
      scene.label(after, "v stays", { role: "ray", offset: [8, 14] });
      if (input.beside === 2) {
        scene.arrow(ORIGIN, output.untested, { role: "miss", width: 3, dashed: true });
        scene.label(output.untested, "no test", { role: "miss", offset: [8, 4] });
      }
      return;
    }
    // The components of v before the impact, and of v' after it.
    const foot = times(output.along_before, -1);
    scene.line(input.from, foot, { role: "a", width: 1.5, dashed: true });
    scene.line(foot, ORIGIN, { role: "b", width: 1.5, dashed: true });
    const edge = output.along_after;
    scene.arrow(edge, after, { role: "a", width: 2 });
    scene.arrow(ORIGIN, edge, { role: "b", width: 2 });

    if (input.beside === 2) {
      scene.arrow(ORIGIN, output.untested, { role: "miss", width: 6, dashed: true });
    } else if (input.beside) {
      scene.arrow(ORIGIN, output.wrong, { role: "miss", width: 5, dashed: true });
      const left = output.wrong[0] < 0;
      scene.label(times(output.wrong, 0.5), "−k v", {
        role: "miss",
        offset: [left ? -12 : 12, 16],
        anchor: left ? "end" : "start",
      });
    } else {
      scene.arrow(ORIGIN, output.mirror, { role: "muted", width: 1.5, dashed: true });
      scene.label(output.mirror, "k = 1, μ = 0", {
        role: "muted",
        offset: [0, -10],
        anchor: "middle",
        size: "small",
      });
    }
    scene.arrow(ORIGIN, after, { role: "hit", width: 3 });
    scene.label(after, "v′", { role: "hit", offset: [10, 4] });
    scene.dot(ORIGIN, "ink", 4);
  },
  values: (_input, output) => [
    { name: "v", meaning: "before", value: output.before, unit: "m/s", role: "ray" },
    { name: "v′", meaning: "after", value: output.after, unit: "m/s", role: "hit" },
    {
      name: output.approaching ? "−k v" : "v′",
      meaning: output.approaching ? "everything reversed: wrong" : "without the test: wrong",
      value: output.approaching ? output.wrong : output.untested,
      unit: "m/s",
      role: "miss",
    },
    { name: "−v·N", meaning: "approach speed", value: output.closing, unit: "m/s", role: "a" },
    { name: "v′·N", meaning: "separation speed", value: output.parting, unit: "m/s", role: "a" },
    { name: "θ", meaning: "incidence, from N", value: output.angle_in, unit: "°" },
    {
      name: "θ′",
      meaning: "rebound, from N",
      value: output.stays ? "—" : output.angle_out,
      unit: "°",
    },
    { name: "K′/K", meaning: "kinetic energy left", value: output.kept },
  ],
  describe(_input, output) {
    if (!output.approaching)
      return "The ball moves away from the surface, or along it: there is no bounce.";
    if (output.stays)
      return `The ball comes in at ${pretty(output.angle_in, 3)}° from the normal and stops: its velocity is 0.`;
    return `The ball comes in at ${pretty(output.angle_in, 3)}° from the normal and leaves at ${pretty(output.angle_out, 3)}°, with ${pretty(output.parting, 3)} m/s along the normal instead of ${pretty(output.closing, 3)} m/s.`;
  },
});
