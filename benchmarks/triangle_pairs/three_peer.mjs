// node benchmarks/triangle_pairs/three_peer.mjs FOLDER [RUNS]
//
// What fast-triangle-triangle-intersection and three-mesh-bvh say of the pairs of triangles and of
// meshes that `pair_peers --write FOLDER` and `mesh_pair_peers --write FOLDER` kept: medians of
// several runs, and wrong answers. Both compute in double. The book's programs answer the same in
// turn.

import { execFileSync } from "node:child_process";
import fs from "node:fs";
import path from "node:path";
import { fileURLToPath } from "node:url";

// From the benchmarks' own packages.
const modules = new URL("../node_modules/", import.meta.url);
const version = (name) =>
  JSON.parse(fs.readFileSync(new URL(`${name}/package.json`, modules))).version;
const { BufferAttribute, BufferGeometry, Matrix4, Triangle, Vector3 } = await import("three");
const { ExtendedTriangle, MeshBVH, SAH } = await import("three-mesh-bvh");
// Its package names no module for Node, only one for bundlers.
const { trianglesIntersect } = await import(
  new URL("fast-triangle-triangle-intersection/build/index.esm.js", modules).href
);

const [folder, runsAsked] = process.argv.slice(2);
if (!folder) {
  console.error("usage: node benchmarks/triangle_pairs/three_peer.mjs FOLDER [RUNS]");
  process.exit(2);
}
const runs = Number(runsAsked ?? 9);
const program = (name) =>
  fileURLToPath(new URL(`../../build/release/bin/${name}`, import.meta.url));

const numbers = (Type, ...names) => {
  const bytes = fs.readFileSync(path.join(folder, ...names));
  return new Type(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length));
};
const text = (...names) => fs.readFileSync(path.join(folder, ...names), "utf8").trim();
const now = () => process.cpuUsage().user + process.cpuUsage().system; // µs
const spread = (values) => {
  values.sort((a, b) => a - b);
  return [values[Math.floor(values.length / 2)], values[0], values[values.length - 1]];
};
const shown = (value, width, digits = 1) => value.toFixed(digits).padStart(width);
const head = (unit, faults) =>
  `  ${"".padEnd(34)} ${unit.padStart(9)} ${"least - most".padStart(19)} ${"book / this".padStart(11)} ` +
  `${"least - most".padStart(15)}${faults.map((fault) => fault.padStart(10)).join("")}`;
const row = (name, times, shares, faults) => {
  const [time, from, to] = spread(times);
  const [share, low, high] = spread(shares);
  return (
    `  ${name.padEnd(34)} ${shown(time, 9)} ${shown(from, 8)} - ${shown(to, 8)} ` +
    `${shown(share, 11, 3)} ${shown(low, 6, 3)} - ${shown(high, 6, 3)}` +
    faults.map((fault) => shown(fault, 10, 0)).join("")
  );
};

/** Times of `pass` and the book's shares of them; `book` asks the book's program. */
const timed = (pass, per, book) => {
  const times = [];
  const shares = [];
  for (let run = 0; run < runs; run += 1) {
    const start = now();
    pass();
    const time = (now() - start) / per;
    times.push(time);
    shares.push(book() / time);
  }
  return [times, shares];
};

const three = (flat, at) => new Vector3(flat[at], flat[at + 1], flat[at + 2]);
const PAIRS = [
  [
    "fast-triangle-triangle-intersection",
    (a, b, c) => new Triangle(a, b, c),
    (first, second) => trianglesIntersect(first, second) !== null,
  ],
  [
    "three-mesh-bvh, intersectsTriangle",
    (a, b, c) => new ExtendedTriangle(a, b, c),
    (first, second) => first.intersectsTriangle(second, null, true),
  ],
];

const comparePairs = (name, title) => {
  const flat = numbers(Float64Array, "pairs", `${name}.f64`);
  const right = numbers(Int8Array, "pairs", `${name}.right.i8`);
  const count = right.length;
  console.log(`\n${title}, ${count} pairs, ${right.filter((is) => is === 1).length} meet`);
  console.log(head("ns a pair", ["missed", "invented"]));
  const book = () =>
    Number(
      execFileSync(program("pair_peers"), ["--ask", path.join(folder, "pairs"), name], {
        encoding: "utf8",
      }),
    );
  for (const [method, triangle, meet] of PAIRS) {
    const firsts = [];
    const seconds = [];
    for (let i = 0; i < count; i += 1) {
      const at = 18 * i;
      firsts.push(triangle(three(flat, at), three(flat, at + 3), three(flat, at + 6)));
      seconds.push(triangle(three(flat, at + 9), three(flat, at + 12), three(flat, at + 15)));
    }
    const answers = new Int8Array(count);
    const pass = () => {
      for (let i = 0; i < count; i += 1) {
        // What it keeps of a triangle is made anew, as for pairs that come one after the other.
        firsts[i].needsUpdate = true;
        seconds[i].needsUpdate = true;
        answers[i] = meet(firsts[i], seconds[i]) ? 1 : 0;
      }
    };
    for (let i = 0; i < 5; i += 1) pass();
    const [times, shares] = timed(pass, count / 1000, book);
    const missed = right.filter((is, i) => is === 1 && answers[i] === 0).length;
    const invented = right.filter((is, i) => is === 0 && answers[i] === 1).length;
    console.log(row(method, times, shares, [missed, invented]));
  }
};

const meshOf = (scene, name) => ({
  vertices: Float32Array.from(numbers(Float64Array, "meshes", scene, `${name}.f64`)),
  triangles: numbers(Uint32Array, "meshes", scene, `${name}.i32`),
});
const tree = ({ vertices, triangles }) => {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(vertices, 3));
  geometry.setIndex(new BufferAttribute(triangles, 1));
  return new MeshBVH(geometry, { strategy: SAH, indirect: true });
};

const compareMeshes = (scene) => {
  const title = text("meshes", scene, "title.txt");
  const pairs = numbers(Int32Array, "meshes", scene, "right.i32");
  const meshes = [meshOf(scene, "first"), meshOf(scene, "second")];
  let [first, second] = meshes.map(tree);
  const size = meshes[1].triangles.length / 3;
  const right = new Set();
  for (let i = 0; i < pairs.length; i += 2) right.add(pairs[i] * size + pairs[i + 1]);
  const here = new Matrix4();
  const about = `\n${title}, 2 x ${size} triangles, ${right.size} pairs meet:`;
  const book = (what) => () =>
    Number(
      execFileSync(
        program("mesh_pair_peers"),
        ["--ask", path.join(folder, "meshes", scene), what],
        {
          encoding: "utf8",
        },
      ),
    );
  const build = () => {
    [first, second] = meshes.map(tree);
  };
  build();
  console.log(`${about} building`);
  console.log(head("ms", []));
  console.log(row("three-mesh-bvh", ...timed(build, 1000, book("build")), []));

  let met = false;
  const any = () => {
    met = first.bvhcast(second, here, {
      intersectsTriangles: (one, other) => one.intersectsTriangle(other, null, true),
    });
  };
  any();
  console.log(`${about} whether any two meet`);
  console.log(head("us", ["wrong"]));
  const anyTimes = timed(any, 1, () => 1000 * book("any")());
  console.log(row("three-mesh-bvh, bvhcast", ...anyTimes, [met === (right.size === 0) ? 1 : 0]));

  let found = [];
  const all = () => {
    found = [];
    first.bvhcast(second, here, {
      intersectsTriangles: (one, other, i, j) => {
        // i and j are positions in the trees' orders.
        if (one.intersectsTriangle(other, null, true)) {
          found.push(first.resolveTriangleIndex(i) * size + second.resolveTriangleIndex(j));
        }
        return false;
      },
    });
  };
  all();
  console.log(`${about} all pairs that meet`);
  console.log(head("ms", ["missed", "invented"]));
  const allTimes = timed(all, 1000, book("all"));
  const got = new Set(found);
  const missed = [...right].filter((pair) => !got.has(pair)).length;
  const invented = [...got].filter((pair) => !right.has(pair)).length;
  console.log(row("three-mesh-bvh, bvhcast", ...allTimes, [missed, invented]));
};

const names = ["fast-triangle-triangle-intersection", "three-mesh-bvh", "three"];
console.log(
  `${names.map((name) => `${name} ${version(name)}`).join(", ")}, node ${process.version}`,
);
// Each triangle without area is told to the console.
console.warn = () => {};
console.error = () => {};
if (fs.existsSync(path.join(folder, "pairs"))) {
  for (const line of text("pairs", "families.tsv").split("\n")) comparePairs(...line.split("\t"));
}
if (fs.existsSync(path.join(folder, "meshes"))) {
  for (const scene of fs.readdirSync(path.join(folder, "meshes")).sort()) compareMeshes(scene);
}
