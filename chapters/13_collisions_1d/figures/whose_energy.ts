// The kinetic energy of two bodies before and after a collision, against the velocity of the frame.
// The dashed curve is what would remain if e² (or e) were the kept fraction of the total.

import { defineFigure, pretty, type Vec2 } from "@contact/figure";

interface Input {
  mass_1: number;
  mass_2: number;
  v_1: number;
  v_2: number;
  e: number;
  frame: number;
  part: number;
}

interface Output {
  approach: number;
  frames: readonly number[];
  before: readonly number[];
  after: readonly number[];
  wrong: readonly number[];
  centre: readonly number[];
  k_before: number;
  k_after: number;
  k_wrong: number;
  k_centre: number;
  lost: number;
  fraction: number;
  centre_velocity: number;
  impossible: number;
}

/** How far 1 m/s is and how high 1 kJ; the last of either that is drawn. */
const FAR = 0.3;
const HIGH = 0.01;
const FASTEST = 30;
const MOST = 620;
const position = (frame: number, energy: number): Vec2 => [FAR * frame, HIGH * energy];

export default defineFigure<Input, Output>({
  title: "Kinetic energy in different frames",
  view: { kind: "2d", x: [-0.9, 9.8], y: [-1.7, 6.7] },
  aspect: 1.3,
  initial: { mass_1: 3000, mass_2: 1000, v_1: 20, v_2: 0, e: 0.5, frame: 5, part: 2 },
  handles: [
    {
      kind: "slide",
      field: "frame",
      label: "velocity of the frame, m/s",
      role: "muted",
      at: (input): Vec2 => position(input.frame, 0),
      along: (): Vec2 => [FAR, 0],
      step: 0.5,
      limit: [0, FASTEST],
    },
    {
      kind: "slide",
      field: "v_1",
      label: "v₁, of the first over the ground, m/s",
      role: "a",
      at: (input): Vec2 => [FAR * input.v_1, -1.05],
      along: (): Vec2 => [FAR, 0],
      step: 0.5,
      limit: [0, FASTEST],
    },
    {
      kind: "slide",
      field: "v_2",
      label: "v₂, of the second over the ground, m/s",
      role: "b",
      at: (input): Vec2 => [FAR * input.v_2, -1.05],
      along: (): Vec2 => [FAR, 0],
      step: 0.5,
      limit: [0, FASTEST],
    },
  ],
  controls: [
    {
      kind: "choice",
      field: "part",
      label: "assumed to be kept",
      options: [
        { value: 2, label: "e² of the total" },
        { value: 1, label: "e of the total" },
      ],
    },
    { kind: "slider", field: "e", label: "e", min: 0, max: 1, step: 0.05 },
    { kind: "slider", field: "frame", label: "frame", min: 0, max: 30, step: 0.5, unit: "m/s" },
    { kind: "slider", field: "mass_1", label: "m_1", min: 500, max: 4000, step: 100, unit: "kg" },
    { kind: "slider", field: "mass_2", label: "m_2", min: 500, max: 4000, step: 100, unit: "kg" },
  ],
  draw(scene, input, output) {
    const axis = { role: "muted", width: 1 } as const;
    scene.arrow(position(0, 0), [9.6, 0], axis).arrow(position(0, 0), position(0, MOST), axis);
    scene.label(position(0, MOST), "K, kJ", { role: "muted", offset: [8, 4] });
    scene.label([9.6, 0], "m/s", { role: "muted", offset: [0, -8], anchor: "end" });
    for (const frame of [10, 20, 30]) {
      scene.line([FAR * frame, -0.06], [FAR * frame, 0.06], axis);
      scene.label(position(frame, 0), pretty(frame), {
        role: "muted",
        offset: [0, 18],
        anchor: "middle",
        size: "small",
      });
    }
    for (const energy of [200, 400, 600]) {
      scene.line([-0.06, HIGH * energy], [0.06, HIGH * energy], axis);
      scene.label(position(0, energy), pretty(energy), {
        role: "muted",
        offset: [-9, 4],
        anchor: "end",
        size: "small",
      });
    }
    scene.line([0, -1.05], [FAR * FASTEST, -1.05], { role: "ghost", width: 1 });
    scene.label([FAR * input.v_1, -1.05], "v_1", { role: "a", offset: [0, 24], anchor: "middle" });
    scene.label([FAR * input.v_2, -1.05], "v_2", { role: "b", offset: [0, 24], anchor: "middle" });
    if (output.problem) return;

    const curve = (energies: readonly number[]): Vec2[] =>
      energies
        .map((energy, i): Vec2 => [output.frames[i] ?? 0, energy])
        .filter(([, energy]) => energy <= MOST)
        .map(([frame, energy]) => position(frame, energy));
    scene.path(curve(output.before), { role: "ink", width: 2 });
    if (!output.approach) {
      scene.label(position(15, 500), "no collision", { role: "muted", anchor: "middle" });
      return;
    }
    scene.path(curve(output.centre), { role: "normal", width: 1.2, dashed: true });
    scene.path(curve(output.after), { role: "hit", width: 2.5 });
    scene.path(curve(output.wrong), { role: "miss", width: 2.5, dashed: true });
    scene.line(position(input.frame, 0), position(input.frame, MOST), {
      role: "muted",
      width: 1,
      dashed: true,
    });
    for (const [energy, name, role, down] of [
      [output.k_before, "before", "ink", -6],
      [output.k_after, "after", "hit", 4],
      [output.k_centre, "clay", "normal", 14],
      [output.k_wrong, input.part === 1 ? "e K" : "e² K", "miss", 18],
    ] as const) {
      if (energy > MOST) continue;
      scene.dot(position(input.frame, energy), role, 4.5, role === "miss");
      scene.label(position(input.frame, energy), name, { role, offset: [9, down], size: "small" });
    }
  },
  values: (input, output) => [
    { name: "K", meaning: "before, in the frame", value: output.k_before, unit: "kJ" },
    { name: "K′", meaning: "after", value: output.k_after, unit: "kJ", role: "hit" },
    {
      name: input.part === 1 ? "e K" : "e² K",
      meaning: !output.approach
        ? "no collision"
        : output.impossible
          ? "less than clay keeps: impossible"
          : "assumed to be kept",
      value: output.approach ? output.k_wrong : "—",
      unit: "kJ",
      role: "miss",
    },
    {
      name: "½ M v_c²",
      meaning: "of the centre of mass: always kept",
      value: output.k_centre,
      unit: "kJ",
      role: "normal",
    },
    { name: "ΔK", meaning: "lost, in every frame", value: output.lost, unit: "kJ" },
    {
      name: "ΔK/K",
      meaning: output.approach
        ? `while 1 − e² is ${pretty(1 - input.e * input.e, 3)}`
        : "no collision",
      value: output.approach ? output.fraction : "—",
    },
  ],
  describe(input, output) {
    if (!output.approach) return "The bodies do not approach, so nothing is lost.";
    const part = input.part === 1 ? "e" : "e²";
    const start = `In the frame at ${pretty(input.frame, 3)} m/s, ${pretty(output.k_after, 3)} kJ remain of ${pretty(output.k_before, 3)} kJ; ${part} of the total would be ${pretty(output.k_wrong, 3)} kJ`;
    return output.impossible
      ? `${start}, less than a perfectly inelastic collision keeps.`
      : `${start}.`;
  },
});
