// A ball hits the ground, soft, harder or rigid: its force over time, whose area is the impulse, and
// its velocity over time.

import {
  defineFigure,
  pretty,
  type Role,
  type Scene,
  type Value,
  type Vec2,
  type Vec3,
} from "@contact/figure";

interface Input {
  hardness: number;
  ratio: number;
  time: number;
  release: number;
}

interface Output {
  rigid: number;
  stiffness: number;
  damping: number;
  at_zero_force: number;
  at_zero_penetration: number;
  restitution: number;
  impulse: number;
  duration: number;
  max_depth: number;
  max_force: number;
  left_overlap: number;
  moment: readonly number[];
  force: readonly number[];
  velocity: readonly number[];
  pulls: number;
  pull_moment: readonly number[];
  pull_force: readonly number[];
  pull_velocity: readonly number[];
  penetration: number;
  half_width: number;
  half_height: number;
  force_now: number;
  centre: Vec3;
  velocity_now: number;
}

const PENETRATION = 1;
const SPEED = 2;
const [FIRST, LAST] = [-0.1, 0.5];
/** The ball: where it is drawn, and world units for a metre. */
const BALL = { x: 1.75, ground: 3.6, metre: 2.3 } as const;
/** The scale from soft to rigid. */
const SCALE = { left: 0.8, right: 9.7, y: 0.95 } as const;
/** Both diagrams: where the first and the last moment are, and the heights of 0. */
const [LEFT, RIGHT] = [4.4, 10.3];
const FORCE = { zero: 5.9, unit: 3.3 / 210, top: 9.3, low: 5.2 } as const;
const VELOCITY = { zero: 3.3, unit: 1.25 / SPEED } as const;

const across = (time: number): number => LEFT + ((RIGHT - LEFT) * (time - FIRST)) / (LAST - FIRST);
const ofForce = (force: number): number =>
  Math.max(FORCE.low, Math.min(FORCE.top, FORCE.zero + FORCE.unit * force));
const ofVelocity = (velocity: number): number => VELOCITY.zero + VELOCITY.unit * velocity;
const ofHardness = (hardness: number): number => SCALE.left + (SCALE.right - SCALE.left) * hardness;
const curve = (
  moments: readonly number[],
  values: readonly number[],
  height: (value: number) => number,
): Vec2[] => moments.map((t, i) => [across(t), height(values[i] ?? 0)]);

function ball(scene: Scene, output: Output): void {
  const { x, ground, metre } = BALL;
  scene.face(
    [
      [0.1, ground],
      [3.4, ground],
      [3.4, ground - 0.35],
      [0.1, ground - 0.35],
    ],
    { role: "surface", fill: 0.25, outline: false },
  );
  scene.line([0.1, ground], [3.4, ground], { role: "surface", width: 2.5 });
  const middle = ground + metre * output.centre[2];
  const outline = Array.from({ length: 64 }, (_, i): Vec2 => {
    const angle = (i * Math.PI) / 32;
    return [
      x + metre * output.half_width * Math.cos(angle),
      middle + metre * output.half_height * Math.sin(angle),
    ];
  });
  scene.face(outline, { role: "ball", fill: 0.5 });
  const length = 0.4 * output.velocity_now;
  scene.arrow([x, middle], [x, middle + length], { role: "b", width: 2.5 });
  if (output.force_now === 0) return;
  const role: Role = output.force_now > 0 ? "hit" : "miss";
  const end = Math.sign(output.force_now) * Math.min(2, 0.25 + Math.abs(output.force_now) / 100);
  scene.arrow([x + 0.5, ground], [x + 0.5, ground + end], { role, width: 3.5 });
}

function scale(scene: Scene, { hardness }: Input): void {
  const y = SCALE.y;
  scene.line([SCALE.left, y], [SCALE.right, y], { role: "muted", width: 2 });
  for (const [at, name] of [
    [0, "soft"],
    [0.5, "harder"],
    [1, "rigid"],
  ] as const) {
    scene.line([ofHardness(at), y - 0.1], [ofHardness(at), y + 0.1], { role: "muted", width: 1.5 });
    scene.label([ofHardness(at), y], name, {
      role: hardness === at ? "ink" : "muted",
      offset: [0, 28],
      anchor: "middle",
    });
  }
}

/** The axes of both diagrams, and the moment of the drawing. */
function axes(scene: Scene, { time }: Input): void {
  const axis = { role: "muted", width: 1 } as const;
  const small = { role: "muted", size: "small" } as const;
  for (const zero of [FORCE.zero, VELOCITY.zero]) scene.line([LEFT, zero], [RIGHT, zero], axis);
  scene.line([across(0), FORCE.low], [across(0), FORCE.top], axis);
  scene.line([across(0), ofVelocity(-1.25 * SPEED)], [across(0), ofVelocity(1.25 * SPEED)], axis);
  for (const newtons of [100, 200]) {
    const y = ofForce(newtons);
    scene.line([across(0) - 0.06, y], [across(0) + 0.06, y], axis);
    scene.label([across(0), y], pretty(newtons), { ...small, offset: [-8, 4], anchor: "end" });
  }
  for (const speed of [-SPEED, SPEED]) {
    const y = ofVelocity(speed);
    scene.line([across(0) - 0.06, y], [across(0) + 0.06, y], axis);
    scene.label([across(0) - 0.1, y], pretty(speed), {
      ...small,
      offset: [-4, speed > 0 ? 4 : -6],
      anchor: "end",
    });
  }
  for (const t of [0.1, 0.2, 0.3, 0.4]) {
    for (const zero of [FORCE.zero, VELOCITY.zero])
      scene.line([across(t), zero - 0.06], [across(t), zero + 0.06], axis);
    scene.label([across(t), VELOCITY.zero], pretty(t), {
      ...small,
      offset: [0, 17],
      anchor: "middle",
    });
  }
  scene.label([across(0), FORCE.top], "force, N", { role: "hit", offset: [10, 2] });
  scene.label([across(0), ofVelocity(1.25 * SPEED)], "velocity, m/s", {
    role: "b",
    offset: [10, 4],
  });
  scene.label([RIGHT, VELOCITY.zero], "t, s", { ...small, offset: [4, -6], anchor: "end" });
  if (time < FIRST || time > LAST) return;
  const now = { role: "muted", width: 1.2, dashed: true } as const;
  scene.line([across(time), ofVelocity(-1.25 * SPEED)], [across(time), FORCE.top], now);
}

/** The area between a curve and 0, in pieces that are convex. */
function area(
  scene: Scene,
  moments: readonly number[],
  forces: readonly number[],
  role: Role,
): void {
  for (let i = 0; i + 1 < moments.length; i++) {
    const [from, to] = [across(moments[i] ?? 0), across(moments[i + 1] ?? 0)];
    const corners: Vec2[] = [
      [from, FORCE.zero],
      [to, FORCE.zero],
      [to, ofForce(forces[i + 1] ?? 0)],
      [from, ofForce(forces[i] ?? 0)],
    ];
    scene.face(corners, { role, fill: 0.3, outline: false });
  }
}

function soft(scene: Scene, { release }: Input, output: Output): void {
  const { moment, force, velocity, pull_moment, pull_force, pull_velocity } = output;
  const dashed = release !== PENETRATION;
  area(scene, moment, force, "hit");
  const first: Vec2 = [across(0), FORCE.zero];
  const pushes = curve(moment, force, ofForce);
  scene.path([first, ...pushes], { role: "hit", width: 2.5 });
  const v = { role: "b", width: 2.5 } as const;
  scene.line([across(FIRST), ofVelocity(-SPEED)], [across(0), ofVelocity(-SPEED)], v);
  scene.path(curve(moment, velocity, ofVelocity), v);
  if (output.pulls) {
    if (!dashed) area(scene, pull_moment, pull_force, "miss");
    scene.path(curve(pull_moment, pull_force, ofForce), { role: "miss", width: 2.5, dashed });
    if (!dashed)
      scene.path(curve(pull_moment, pull_velocity, ofVelocity), { role: "miss", width: 2.5 });
  }
  const end = output.duration;
  if (end < LAST) {
    const left = ofVelocity(output.restitution * SPEED);
    scene.line([across(end), left], [RIGHT, left], v);
  }
  const peak = Math.max(...force);
  const at = moment[force.indexOf(peak)] ?? 0;
  scene.label([across(at), ofForce(peak)], `${pretty(peak, 3)} N`, {
    role: "hit",
    offset: [12, peak > 170 ? 16 : -6],
    size: "small",
  });
}

function rigid(scene: Scene, output: Output): void {
  scene.arrow([across(0), FORCE.zero], [across(0), FORCE.top], { role: "hit", width: 4 });
  scene.label([across(0), ofForce(110)], "an impulse", { role: "hit", offset: [14, 0] });
  const v = { role: "b", width: 2.5 } as const;
  const left = ofVelocity(output.restitution * SPEED);
  scene.line([across(FIRST), ofVelocity(-SPEED)], [across(0), ofVelocity(-SPEED)], v);
  scene.line([across(0), ofVelocity(-SPEED)], [across(0), left], { ...v, dashed: true });
  scene.line([across(0), left], [RIGHT, left], v);
}

export default defineFigure<Input, Output>({
  title: "Soft, harder, rigid: one impulse",
  view: { kind: "2d", x: [0, 10.6], y: [0, 9.7] },
  aspect: 1.09,
  initial: { hardness: 0, ratio: 0, time: 0.1, release: 0 },
  handles: [
    {
      kind: "slide",
      field: "hardness",
      label: "from soft to rigid",
      role: "ball",
      at: ({ hardness }): Vec2 => [ofHardness(hardness), SCALE.y],
      along: (): Vec2 => [SCALE.right - SCALE.left, 0],
      step: 0.01,
      limit: [0, 1],
    },
    {
      kind: "slide",
      field: "time",
      label: "time, s",
      role: "b",
      at: ({ time }): Vec2 => [across(time), VELOCITY.zero],
      along: (): Vec2 => [(RIGHT - LEFT) / (LAST - FIRST), 0],
      step: 0.005,
      limit: [FIRST, LAST],
    },
  ],
  controls: [
    { kind: "slider", field: "hardness", label: "soft to rigid", min: 0, max: 1, step: 0.01 },
    {
      kind: "slider",
      field: "time",
      label: "time",
      min: FIRST,
      max: LAST,
      step: 0.001,
      unit: "s",
      play: 4,
    },
    { kind: "slider", field: "ratio", label: "damping ratio", min: 0, max: 1.5, step: 0.01 },
    {
      kind: "choice",
      field: "release",
      label: "the contact ends",
      options: [
        { value: 0, label: "at zero force" },
        { value: 1, label: "at zero penetration" },
      ],
    },
    {
      kind: "states",
      label: "Contact",
      options: [
        { label: "soft", fields: { hardness: 0 } },
        { label: "harder", fields: { hardness: 0.5 } },
        { label: "rigid", fields: { hardness: 1 } },
        { label: "a damper that pulls", fields: { hardness: 0.1, ratio: 0.5, release: 1 } },
      ],
    },
  ],
  draw(scene, input, output) {
    scale(scene, input);
    axes(scene, input);
    if (output.problem) return;
    ball(scene, output);
    if (output.rigid) rigid(scene, output);
    else soft(scene, input, output);
    scene.label([RIGHT, ofForce(165)], `area ${pretty(output.impulse, 3)} N·s`, {
      role: "hit",
      anchor: "end",
    });
  },
  values({ release }, output): Value[] {
    const { rigid: is_rigid, stiffness, damping, at_zero_force, at_zero_penetration } = output;
    const chosen = release === PENETRATION;
    return [
      {
        name: "k",
        meaning: is_rigid ? "the limit k → ∞" : "stiffness of the contact",
        value: is_rigid ? "rigid" : stiffness,
        unit: "N/m",
      },
      { name: "c", meaning: "its damper", value: is_rigid ? "–" : damping, unit: "N·s/m" },
      {
        name: "J",
        meaning: "impulse, the area under the force",
        value: output.impulse,
        unit: "N·s",
        role: "hit",
      },
      { name: "T", meaning: "duration of the contact", value: output.duration, unit: "s" },
      { name: "d_max", meaning: "greatest penetration", value: output.max_depth, unit: "m" },
      {
        name: "F_max",
        meaning: "greatest force",
        value: is_rigid ? "–" : output.max_force,
        unit: "N",
        role: "hit",
      },
      {
        name: "e_F",
        meaning: `restitution, ends at zero force${chosen ? "" : ": chosen"}`,
        value: at_zero_force,
      },
      {
        name: "e_d",
        meaning: `restitution, ends at zero penetration${chosen ? ": chosen" : ""}`,
        value: at_zero_penetration,
        role: "miss",
      },
      {
        name: "d",
        meaning: output.penetration < 0 ? "negative: a gap, now" : "penetration now",
        value: output.penetration,
        unit: "m",
      },
      { name: "F", meaning: "force now", value: output.force_now, unit: "N" },
    ];
  },
  describe(_input, output) {
    const e = pretty(output.restitution, 3);
    const impulse = pretty(output.impulse, 3);
    if (output.rigid)
      return `Rigid: no force acts over any time. An impulse of ${impulse} N·s changes the velocity at once, by the restitution ${e}.`;
    const lasts = Number.isFinite(output.duration)
      ? `The contact lasts ${pretty(output.duration, 3)} s, and its force has the area ${impulse} N·s, whatever the stiffness.`
      : "The surfaces do not separate: the damper is too strong, and the contact lasts for ever.";
    return `${lasts} Restitution: ${e}. The ball is drawn squashed by its penetration, which the model does not compute.`;
  },
});
