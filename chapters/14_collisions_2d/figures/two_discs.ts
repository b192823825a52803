// Two discs at the moment of contact, with the normal and tangential components of their velocities.
// Below: the momenta, tip to tail, before and after.

import { defineFigure, pretty, type Role, type Scene, type Vec2 } from "@contact/figure";

interface Input {
  centre_a: Vec2;
  centre_b: Vec2;
  velocity_a: Vec2;
  velocity_b: Vec2;
  mass_a: number;
  mass_b: number;
  restitution: number;
  way: number;
}

interface Output {
  radius: number;
  touch: Vec2;
  axis: Vec2;
  normal_a: number;
  normal_b: number;
  along_a: Vec2;
  along_b: Vec2;
  approach: number;
  after_a: Vec2;
  after_b: Vec2;
  p_a: Vec2;
  p_b: Vec2;
  p_before: Vec2;
  p_a_after: Vec2;
  p_b_after: Vec2;
  p_after: Vec2;
  energy_before: number;
  energy_after: number;
  product_after: number;
  wrong: number;
}

/** Where the two triangles of momenta begin, and how many kg·m/s are one unit of the drawing. */
const BEFORE: Vec2 = [-3, -5.6];
const AFTER: Vec2 = [2, -5.6];
const PER_UNIT = 1;

const add = (p: Vec2, q: Vec2): Vec2 => [p[0] + q[0], p[1] + q[1]];
const momentum = (p: Vec2): Vec2 => [p[0] / PER_UNIT, p[1] / PER_UNIT];
const long = (v: Vec2): boolean => Math.abs(v[0]) + Math.abs(v[1]) > 0.04;

/** An arrow, or a dot where there is nothing to point with; its tip. */
function arrow(
  scene: Scene,
  from: Vec2,
  v: Vec2,
  role: Role,
  style: { thin?: boolean } = {},
): Vec2 {
  const tip = add(from, v);
  if (!long(v)) scene.dot(from, role, 3);
  else if (style.thin) scene.arrow(from, tip, { role, width: 1.5, dashed: true });
  else scene.arrow(from, tip, { role, width: 3 });
  return tip;
}

/** Offset of a label in pixels, in the direction of its arrow. */
function onwards(v: Vec2): Vec2 {
  const length = Math.hypot(v[0], v[1]) || 1;
  return [(27 * v[0]) / length, 5 - (23 * v[1]) / length];
}

export default defineFigure<Input, Output>({
  title: "Two discs touch",
  view: { kind: "2d", x: [-5, 5], y: [-7.3, 4.2] },
  aspect: 0.9,
  initial: {
    centre_a: [-1.1, 0.6],
    centre_b: [0.9, 1.5],
    velocity_a: [2.7, 0.2],
    velocity_b: [-0.8, 1],
    mass_a: 1,
    mass_b: 1,
    restitution: 1,
    way: 0,
  },
  handles: [
    { kind: "point", field: "centre_b", label: "centre of B", role: "b", limit: [-4, 4] },
    { kind: "point", field: "centre_a", label: "centre of A", role: "a", limit: [-4, 4] },
    {
      kind: "point",
      field: "velocity_a",
      from: "centre_a",
      label: "v_A, velocity of A before",
      role: "a",
      limit: [-4, 4],
    },
    {
      kind: "point",
      field: "velocity_b",
      from: "centre_b",
      label: "v_B, velocity of B before",
      role: "b",
      limit: [-4, 4],
    },
  ],
  controls: [
    { kind: "slider", field: "mass_a", label: "m_A", min: 0.2, max: 4, step: 0.1, unit: "kg" },
    { kind: "slider", field: "mass_b", label: "m_B", min: 0.2, max: 4, step: 0.1, unit: "kg" },
    { kind: "slider", field: "restitution", label: "e", min: 0, max: 1, step: 0.05 },
    {
      kind: "choice",
      field: "way",
      label: "computed",
      options: [
        { value: 0, label: "by the book" },
        { value: 1, label: "without test" },
        { value: 2, label: "all reversed" },
        { value: 3, label: "axis not normalised" },
      ],
    },
    { kind: "numbers", field: "velocity_a", label: "v_A", role: "a" },
    { kind: "numbers", field: "velocity_b", label: "v_B", role: "b" },
    { kind: "numbers", field: "centre_a", label: "c_A", role: "a" },
    { kind: "numbers", field: "centre_b", label: "c_B", role: "b" },
  ],
  draw(scene, input, output) {
    const { centre_a, centre_b, velocity_a, velocity_b } = input;
    if (output.problem) {
      scene.dot(centre_a, "a").dot(centre_b, "b", 4.5, true);
      return;
    }
    const far = 9;
    scene.line(
      [output.touch[0] - far * output.axis[0], output.touch[1] - far * output.axis[1]],
      [output.touch[0] + far * output.axis[0], output.touch[1] + far * output.axis[1]],
      { role: "normal", width: 1, dashed: true },
    );
    scene.ball(centre_a, output.radius, { role: "a", fill: 0.14 });
    scene.ball(centre_b, output.radius, { role: "b", fill: 0.14 });
    scene.dot(output.touch, "normal", 4);
    for (const [centre, velocity, part, after, role, name] of [
      [centre_a, velocity_a, output.along_a, output.after_a, "a", "A"],
      [centre_b, velocity_b, output.along_b, output.after_b, "b", "B"],
    ] as const) {
      const foot = add(centre, part);
      const tip = add(centre, velocity);
      if (long(velocity)) {
        scene.line(foot, tip, { role: "muted", width: 1 });
        scene.line(centre, foot, { role: "normal", width: 3 });
        scene.arrow(centre, tip, { role, width: 1.5, dashed: true });
        scene.label(tip, `v_${name}`, { role, offset: onwards(velocity), anchor: "middle" });
      }
      arrow(scene, centre, after, output.wrong ? "miss" : role);
      if (long(after)) {
        scene.label(add(centre, after), `v_${name}′`, {
          role: output.wrong ? "miss" : role,
          offset: onwards(after),
          anchor: "middle",
        });
      }
    }
    scene.line([-5, -2.9], [5, -2.9], { role: "ghost", width: 1 });
    for (const [corner, title, p_a, p_b, sum] of [
      [BEFORE, "momenta before", output.p_a, output.p_b, output.p_before],
      [AFTER, "momenta after", output.p_a_after, output.p_b_after, output.p_after],
    ] as const) {
      scene.label([corner[0] - 1.6, -2.9], title, {
        role: "muted",
        offset: [0, 18],
        size: "small",
      });
      const end = arrow(scene, corner, momentum(p_a), "a");
      const tip = arrow(scene, end, momentum(p_b), "b");
      scene.label(tip, "p_B", { role: "b", offset: onwards(p_b), anchor: "middle" });
      scene.label(corner, "p_A", { role: "a", offset: [-4, 20], anchor: "end", size: "small" });
      arrow(scene, corner, momentum(sum), "normal", { thin: true });
    }
  },
  values: (_input, output) => [
    { name: "n", meaning: "axis, from B to A", value: output.axis, role: "normal" },
    {
      name: "n·v_A",
      meaning: "along the axis",
      value: output.normal_a,
      unit: "m/s",
      role: "a",
    },
    { name: "n·v_B", meaning: "along the axis", value: output.normal_b, unit: "m/s", role: "b" },
    { name: "v_A′", meaning: "A afterwards", value: output.after_a, unit: "m/s", role: "a" },
    { name: "v_B′", meaning: "B afterwards", value: output.after_b, unit: "m/s", role: "b" },
    {
      name: "v_A′·v_B′",
      meaning: "0 if perpendicular",
      value: output.product_after,
      unit: "m²/s²",
    },
    { name: "K", meaning: "energy before", value: output.energy_before, unit: "J" },
    { name: "K′", meaning: "energy after", value: output.energy_after, unit: "J" },
  ],
  describe(_input, output) {
    const motion = output.approach
      ? "The discs approach and collide."
      : "The discs touch and do not approach, so nothing happens.";
    const speeds = `A leaves at (${pretty(output.after_a[0], 3)}, ${pretty(output.after_a[1], 3)}) m/s and B at (${pretty(output.after_b[0], 3)}, ${pretty(output.after_b[1], 3)}) m/s`;
    if (output.wrong) return `${motion} This method is wrong here: by it, ${speeds}.`;
    return `${motion} ${speeds}.`;
  },
});
