// node benchmarks/meshes/three_peer.mjs FOLDER [RUNS]
//
// What three-mesh-bvh says of the rays that `mesh_peers --write FOLDER` kept: medians of several runs,
// and wrong answers. It computes in double. The book's program answers the same rays in turn.

import { execFileSync } from "node:child_process";
import fs from "node:fs";
import path from "node:path";
import { fileURLToPath } from "node:url";

// From the benchmarks' own packages.
const modules = new URL("../node_modules/", import.meta.url);
const version = (name) =>
  JSON.parse(fs.readFileSync(new URL(`${name}/package.json`, modules))).version;
const { BufferAttribute, BufferGeometry, DoubleSide, Ray, Vector3 } = await import("three");
const { MeshBVH, SAH } = await import("three-mesh-bvh");

const [folder, runsAsked] = process.argv.slice(2);
if (!folder) {
  console.error("usage: node benchmarks/meshes/three_peer.mjs FOLDER [RUNS]");
  process.exit(2);
}
const runs = Number(runsAsked ?? 15);
const program = fileURLToPath(new URL("../../build/release/bin/mesh_peers", import.meta.url));

const numbers = (Type, ...names) => {
  const bytes = fs.readFileSync(path.join(folder, ...names));
  return new Type(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length));
};
const now = () => process.cpuUsage().user + process.cpuUsage().system; // µs
const spread = (values) => {
  values.sort((a, b) => a - b);
  return [values[Math.floor(values.length / 2)], values[0], values[values.length - 1]];
};
const shown = (value, width, digits = 1) => value.toFixed(digits).padStart(width);

console.log(
  `three-mesh-bvh ${version("three-mesh-bvh")}, three.js ${version("three")}, node ${process.version}`,
);
for (const scene of fs.readdirSync(folder).sort()) {
  const vertices = numbers(Float32Array, scene, "vertices.f32");
  const triangles = numbers(Uint32Array, scene, "triangles.i32");
  const build = () => {
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(vertices, 3));
    geometry.setIndex(new BufferAttribute(triangles.slice(), 1));
    return new MeshBVH(geometry, { strategy: SAH, indirect: true });
  };
  const builds = [];
  let tree = build();
  for (let run = 0; run < runs; run += 1) {
    const start = now();
    tree = build();
    builds.push((now() - start) / 1000);
  }
  const [median, least, most] = spread(builds);
  console.log(
    `\n${scene}, ${triangles.length / 3} triangles: building the tree ${median.toFixed(1)} ms, ` +
      `${least.toFixed(1)} - ${most.toFixed(1)}`,
  );

  const neighbours = (one, other) => {
    const corners = (i) => triangles.slice(3 * i, 3 * i + 3);
    return corners(one).some((v) => corners(other).includes(v));
  };
  const list = fs
    .readFileSync(path.join(folder, scene, "families.tsv"), "utf8")
    .trim()
    .split("\n");
  for (const [name, title] of list.map((line) => line.split("\t"))) {
    if (!name.startsWith("rays")) continue;
    const flat = numbers(Float32Array, scene, `${name}.f32`);
    const right = numbers(Int32Array, scene, `${name}.right.i32`);
    const rays = [...right.keys()].map(
      (i) =>
        new Ray(
          new Vector3(...flat.slice(6 * i, 6 * i + 3)),
          new Vector3(...flat.slice(6 * i + 3, 6 * i + 6)),
        ),
    );
    const answers = new Int32Array(rays.length);
    const pass = () => {
      for (let i = 0; i < rays.length; i += 1) {
        answers[i] = tree.raycastFirst(rays[i], DoubleSide)?.faceIndex ?? -1;
      }
    };
    for (let i = 0; i < 5; i += 1) pass();
    const times = [];
    const shares = [];
    for (let run = 0; run < runs; run += 1) {
      const start = now();
      pass();
      const ns = ((now() - start) * 1000) / rays.length;
      times.push(ns);
      const book = Number(
        execFileSync(program, ["--ask", path.join(folder, scene), name], { encoding: "utf8" }),
      );
      shares.push(book / ns);
    }
    const count = (is) => right.filter((triangle, i) => is(answers[i], triangle)).length;
    const missed = count((got, triangle) => got < 0 && triangle >= 0);
    const invented = count((got, triangle) => got >= 0 && triangle < 0);
    const later = count((got, triangle) => got >= 0 && triangle >= 0 && !neighbours(got, triangle));
    const [time, from, to] = spread(times);
    const [share, low, high] = spread(shares);
    console.log(`
${title}, ${rays.length} rays: the first hit
  ${"".padEnd(34)} ns a ray       least - most book / this    least - most    missed  invented     later
  ${"three-mesh-bvh, raycastFirst".padEnd(32)} ${shown(time, 10)} ${shown(from, 8)} - ${shown(to, 8)} ${shown(share, 11, 3)} ${shown(low, 6, 3)} - ${shown(high, 6, 3)} ${shown(missed, 9, 0)} ${shown(invented, 9, 0)} ${shown(later, 9, 0)}`);
  }
}
