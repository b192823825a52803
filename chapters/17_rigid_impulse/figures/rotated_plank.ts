// A plank that is hit from above, in the frame of its centre of mass: its orientation a moment
// later, and the same if the tensor is left in the body's axes.

import { defineFigure, pretty, type Scene, type Vec3, vectorAt } from "@contact/figure";

interface Input {
  tip: Vec3;
  at: number;
  impulse: number;
  shape: number;
  time: number;
}

interface Output {
  half: Vec3;
  point: Vec3;
  axis: Vec3;
  moments: Vec3;
  angular_impulse: Vec3;
  angular_velocity: Vec3;
  wrong_angular_velocity: Vec3;
  sphere_angular_velocity: Vec3;
  momentum: Vec3;
  wrong_momentum: Vec3;
  energy: number;
  wrong_energy: number;
  size: number;
  wrong_size: number;
  agree: number;
  first: readonly number[];
  later: readonly number[];
  wrong: readonly number[];
}

const ORIGIN: Vec3 = [0, 0, 0];
/** How many metres long 1 rad/s is, and 1 N·s. */
const PER_SPIN = 0.45;
const PER_IMPULSE = 0.4;
const times = (v: Vec3, s: number): Vec3 => [v[0] * s, v[1] * s, v[2] * s];
/** The vertices of a box's six faces; a vertex's bits are the signs of its x, y and z. */
const FACES = [
  [0, 2, 6, 4],
  [1, 3, 7, 5],
  [0, 1, 5, 4],
  [2, 3, 7, 6],
  [0, 1, 3, 2],
  [4, 5, 7, 6],
] as const;

export default defineFigure<Input, Output>({
  title: "Hitting a rotated plank",
  view: { kind: "3d", target: [0, 0, 0], azimuth: -70, elevation: 28, span: 3.3 },
  aspect: 1.2,
  initial: { tip: [0.95, 0.95, 0], at: 0.8, impulse: 1.5, shape: 0, time: 0.4 },
  handles: [
    {
      kind: "point",
      field: "tip",
      label: "where the plank points",
      role: "surface",
      move: "level",
      step: 0.05,
      limit: [-1.4, 1.4],
    },
    {
      kind: "slide",
      field: "at",
      label: "point of the hit, in half lengths from its middle",
      role: "ray",
      at: (_input, output): Vec3 => output.point,
      along: (_input, output): Vec3 => times(output.axis, output.half[0]),
      step: 0.05,
      limit: [-1, 1],
    },
  ],
  controls: [
    {
      kind: "choice",
      field: "shape",
      label: "the body",
      options: [
        { value: 0, label: "a plank" },
        { value: 1, label: "a cube" },
      ],
    },
    { kind: "slider", field: "impulse", label: "J", min: 0, max: 3, step: 0.1, unit: "N·s" },
    { kind: "slider", field: "time", label: "t", min: 0, max: 1, step: 0.01, unit: "s", play: 4 },
  ],
  draw(scene, input, output) {
    scene.line(ORIGIN, input.tip, { role: "muted", width: 1, dashed: true, through: true });
    if (output.problem) return;
    box(scene, output.first, { role: "muted", fill: 0, dashed: true });
    box(scene, output.later, { role: "hit", fill: 0.2, hides: true });
    box(scene, output.wrong, { role: "miss", fill: 0.05, dashed: true });
    // The tip of the arrow is clear of the handle.
    const [x, y, z] = output.point;
    const tail: Vec3 = [x, y, z + 0.15 + PER_IMPULSE * input.impulse];
    scene.arrow(tail, [x, y, z + 0.15], { role: "ray", width: 3, through: true });
    scene.label(tail, "J", { role: "ray", offset: [10, 0] });
    scene.arrow(ORIGIN, times(output.sphere_angular_velocity, PER_SPIN), {
      role: "b",
      width: 2,
      dashed: true,
      through: true,
    });
    scene.arrow(ORIGIN, times(output.angular_velocity, PER_SPIN), {
      role: "hit",
      width: 3,
      through: true,
    });
    scene.label(times(output.angular_velocity, PER_SPIN), "ω", { role: "hit", offset: [12, 2] });
    scene.arrow(ORIGIN, times(output.wrong_angular_velocity, PER_SPIN), {
      role: "miss",
      width: 3,
      dashed: true,
      through: true,
    });
    scene.label(times(output.wrong_angular_velocity, PER_SPIN), "ω by I_body", {
      role: "miss",
      offset: [-14, -18],
      anchor: "middle",
    });
  },
  values: (_input, output) => [
    {
      name: "r × J",
      meaning: "angular impulse",
      value: output.angular_impulse,
      unit: "N·m·s",
      role: "ray",
    },
    {
      name: "ω",
      meaning: "R I⁻¹ Rᵀ (r × J)",
      value: output.angular_velocity,
      unit: "rad/s",
      role: "hit",
    },
    {
      name: "ω",
      meaning: "I⁻¹ (r × J): wrong",
      value: output.wrong_angular_velocity,
      unit: "rad/s",
      role: "miss",
    },
    {
      name: "ω",
      meaning: "(r × J) / mean moment, as for a sphere: wrong",
      value: output.sphere_angular_velocity,
      unit: "rad/s",
      role: "b",
    },
    { name: "L", meaning: "equals r × J", value: output.momentum, unit: "N·m·s", role: "hit" },
    {
      name: "L",
      meaning: "of the wrong ω",
      value: output.wrong_momentum,
      unit: "N·m·s",
      role: "miss",
    },
    { name: "K", meaning: "of the rotation", value: output.energy, unit: "J", role: "hit" },
    {
      name: "K",
      meaning: "of the wrong rotation",
      value: output.wrong_energy,
      unit: "J",
      role: "miss",
    },
  ],
  describe(_input, output) {
    if (output.agree)
      return `In this orientation both tensors give the same angular velocity, ${pretty(output.size, 3)} rad/s.`;
    return `It rotates at ${pretty(output.size, 3)} rad/s. With the tensor in its own axes it would rotate at ${pretty(output.wrong_size, 3)} rad/s about another axis, with ${pretty(output.wrong_energy, 3)} J instead of ${pretty(output.energy, 3)} J.`;
  },
});

function box(scene: Scene, corners: readonly number[], style: Parameters<Scene["face"]>[1]): void {
  for (const face of FACES) {
    const points = face.map((corner) => vectorAt(corners, corner));
    scene.face(points, { ...style, outline: true });
  }
}
