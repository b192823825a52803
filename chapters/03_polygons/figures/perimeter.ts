// A plank that enters a floor with a peak: the points or the segments that find it, and the normal
// by the chosen rule. An arrow of another face than the book's is red.

import { defineFigure, pretty, type Role, type Value, type Vec2 } from "@contact/figure";

interface Input {
  centre: Vec2;
  front: Vec2;
  peak: Vec2;
  tiles: number;
  spacing: number;
  method: number;
}

interface Output {
  box: readonly number[];
  floor_count: number;
  floor: readonly number[];
  meets: number;
  box_points: number;
  floor_points: number;
  box_point: readonly number[];
  floor_point: readonly number[];
  box_point_hit: readonly number[];
  floor_point_hit: readonly number[];
  points_hit: number;
  points_tests: number;
  hits: number;
  segment_tests: number;
  hit_at: readonly number[];
  normal_of_hit: readonly number[];
  normal_by_end: readonly number[];
  hit_differs: readonly number[];
  end_differs: readonly number[];
  hit_differing: number;
  end_differing: number;
  has_face: number;
  face_of_box: number;
  face_edge: number;
  depth: number;
  normal: Vec2;
  contact_point: Vec2;
  points_miss: number;
  segments_miss: number;
}

const ARROW = 1;

const at = (numbers: readonly number[], i: number): Vec2 => [
  numbers[2 * i] ?? 0,
  numbers[2 * i + 1] ?? 0,
];
const list = (numbers: readonly number[], count: number): Vec2[] =>
  Array.from({ length: count }, (_, i) => at(numbers, i));
const ahead = (from: Vec2, by: Vec2, factor: number): Vec2 => [
  from[0] + by[0] * factor,
  from[1] + by[1] * factor,
];

export default defineFigure<Input, Output>({
  title: "Which face was hit?",
  view: { kind: "2d", x: [-5, 5], y: [-3.3, 3.3] },
  aspect: 1.35,
  initial: {
    centre: [1.4, 0],
    front: [1.6, 0.9],
    peak: [-2.5, 0.75],
    tiles: 6,
    spacing: 1,
    method: 2,
  },
  handles: [
    {
      kind: "point",
      field: "peak",
      label: "the peak of the floor",
      role: "b",
      step: 0.25,
      limit: [-4, 3],
    },
    {
      kind: "point",
      field: "front",
      from: "centre",
      label: "the direction of the plank",
      role: "a",
      step: 0.25,
      limit: [-2, 2],
    },
    {
      kind: "point",
      field: "centre",
      label: "the middle of the plank",
      role: "a",
      step: 0.25,
      limit: [-4, 4],
    },
  ],
  controls: [
    {
      kind: "choice",
      field: "method",
      label: "Perimeter",
      options: [
        { value: 0, label: "points" },
        { value: 1, label: "segments: normal of the one hit" },
        { value: 2, label: "segments: normal by the nearer end" },
        { value: 3, label: "segments: least penetration" },
      ],
    },
    { kind: "slider", field: "tiles", label: "tiles", min: 1, max: 12, step: 1 },
    { kind: "slider", field: "spacing", label: "spacing", min: 0.2, max: 4, step: 0.2, unit: "m" },
    { kind: "numbers", field: "centre", label: "plank", role: "a", step: 0.25 },
    { kind: "numbers", field: "front", label: "direction", role: "a", step: 0.25 },
    { kind: "numbers", field: "peak", label: "peak", role: "b", step: 0.25 },
  ],
  draw(scene, input, output) {
    if (output.problem) {
      scene.label(input.centre, "the plank", { role: "a", offset: [0, -18], anchor: "middle" });
      return;
    }
    const box = list(output.box, 4);
    const floor = list(output.floor, output.floor_count);
    scene.face(floor, { role: "b", fill: 0.12 });
    scene.face(box, { role: "a", fill: 0.16 });
    scene.line(input.centre, ahead(input.centre, input.front, 1), {
      role: "a",
      width: 1,
      dashed: true,
    });

    if (input.method === 0) {
      for (const [points, hit, role] of [
        [list(output.floor_point, output.floor_points), output.floor_point_hit, "b"],
        [list(output.box_point, output.box_points), output.box_point_hit, "a"],
      ] as const)
        for (const [i, point] of points.entries()) {
          if (hit[i]) scene.dot(point, "hit", 6);
          else scene.dot(point, role, 3);
        }
      if (output.points_miss)
        scene.label([0, 2.9], "they meet, and no point says so", {
          role: "miss",
          anchor: "middle",
        });
      return;
    }

    for (const end of floor) scene.dot(end, "b", 2.5);
    for (const end of box) scene.dot(end, "a", 2.5);
    if (output.segments_miss)
      scene.label([0, 2.9], "one is inside the other, and no segments meet", {
        role: "miss",
        anchor: "middle",
      });
    if (output.has_face) {
      const outline = output.face_of_box ? box : floor;
      const from = outline[output.face_edge] ?? input.centre;
      const to = outline[(output.face_edge + 1) % outline.length] ?? input.centre;
      scene.line(from, to, { role: "hit", width: 5 });
    }
    for (let i = 0; i < output.hits; i++) {
      const point = at(output.hit_at, i);
      if (input.method === 3) {
        scene.dot(point, "ink", 4);
        continue;
      }
      const [normals, other] =
        input.method === 1
          ? [output.normal_of_hit, output.hit_differs]
          : [output.normal_by_end, output.end_differs];
      const role: Role = other[i] ? "miss" : "hit";
      const normal = at(normals, i);
      const tip = ahead(point, normal, ARROW);
      scene.arrow(point, tip, { role, width: 3, dashed: other[i] === 1 });
      scene.dot(point, role, 5, other[i] === 1);
    }
    const differing = [0, output.hit_differing, output.end_differing, 0][input.method] ?? 0;
    if (differing)
      scene.label([0, 2.9], `the normal of another face at ${differing} of ${output.hits} points`, {
        role: "miss",
        anchor: "middle",
      });
    if (input.method === 3 && output.has_face) {
      const tip = ahead(output.contact_point, output.normal, ARROW);
      scene.arrow(output.contact_point, tip, { role: "hit", width: 3 });
      scene.label(tip, "n", { role: "hit", offset: [8, 4] });
    }
  },
  values(_input, output) {
    const rule = (name: string, meaning: string, differing: number): Value => ({
      name,
      meaning,
      value: output.hits ? `${differing} of ${output.hits}` : "–",
      role: differing ? "miss" : "hit",
    });
    return [
      {
        name: "points",
        meaning: `hit, of ${output.box_points + output.floor_points}`,
        value: `${output.points_hit}${output.points_miss ? ", missed" : ""}`,
        role: output.points_miss ? "miss" : "ink",
      },
      {
        name: "segments",
        meaning: `pairs that meet, of ${output.segment_tests}`,
        value: `${output.hits}${output.segments_miss ? ", missed" : ""}`,
        role: output.segments_miss ? "miss" : "ink",
      },
      { name: "tests", meaning: "of points with edges", value: output.points_tests },
      { name: "tests", meaning: "of pairs of segments", value: output.segment_tests },
      rule("segment hit", "another face than the book’s", output.hit_differing),
      rule("nearer end", "another face than the book’s", output.end_differing),
      {
        name: "n",
        meaning: output.has_face
          ? `the book’s, of the ${output.face_of_box ? "plank" : "floor"}`
          : "the book’s",
        value: output.has_face ? output.normal : "–",
        role: "hit",
      },
      {
        name: "depth",
        meaning: "behind that face",
        value: output.has_face ? output.depth : "–",
        unit: "m",
        role: "hit",
      },
    ];
  },
  describe(_input, output) {
    if (!output.meets) return "The plank and the floor do not meet.";
    if (output.segments_miss)
      return `One is inside the other: no segments meet, and ${output.points_hit} points are inside.`;
    const points = output.points_miss
      ? "no point is inside"
      : `${output.points_hit} points are hit`;
    return `They meet at ${output.hits} pairs of segments; ${points}. The face is one of the ${output.face_of_box ? "plank" : "floor"}, ${pretty(output.depth)} m deep. The segment hit gives another face at ${output.hit_differing} of the common points, the nearer end at ${output.end_differing}.`;
  },
});
