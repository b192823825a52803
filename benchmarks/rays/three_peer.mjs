// node benchmarks/rays/three_peer.mjs FILE [RUNS]
//
// What three.js, which the page has, says of the rays that `ray_peers --write FILE` kept: medians of
// several runs, and wrong answers. It computes in double. At a ball it wants a direction of length 1.

import fs from "node:fs";

// From the page's own packages.
const { Box3, Ray, REVISION, Sphere, Vector3 } = await import(
  new URL("../../page/node_modules/three/build/three.module.js", import.meta.url).href
);

const [file, runsAsked] = process.argv.slice(2);
if (!file) {
  console.error("usage: node benchmarks/rays/three_peer.mjs FILE [RUNS]");
  process.exit(2);
}
const runs = Number(runsAsked ?? 15);
const bytes = fs.readFileSync(file);
const NUMBERS = 13;

/** The families of the file: title, rays, bodies and right answers. */
function* families() {
  for (let at = 0; at < bytes.length; ) {
    const end = bytes.indexOf("\n", at);
    const [title, count] = bytes.toString("utf8", at, end).split("\t");
    const size = NUMBERS * 4 * Number(count);
    // A copy, since its position in the file need not be a multiple of 4.
    const numbers = new Float32Array(
      bytes.buffer.slice(bytes.byteOffset + end + 1, bytes.byteOffset + end + 1 + size),
    );
    at = end + 1 + size;
    const isBall = title.startsWith("ball");
    const rays = [];
    const bodies = [];
    const right = [];
    for (let i = 0; i < numbers.length; i += NUMBERS) {
      const vector = (from) => new Vector3(...numbers.slice(i + from, i + from + 3));
      const direction = vector(3);
      rays.push(new Ray(vector(0), isBall ? direction.normalize() : direction));
      bodies.push(isBall ? new Sphere(vector(6), numbers[i + 9]) : new Box3(vector(6), vector(9)));
      right.push(numbers[i + 12] === 1);
    }
    yield { title, isBall, rays, bodies, right };
  }
}

const METHODS = {
  ball: [
    ["three.js, intersectsSphere", (ray, ball) => ray.intersectsSphere(ball)],
    ["three.js, intersectSphere", (ray, ball, point) => ray.intersectSphere(ball, point) !== null],
  ],
  box: [["three.js, intersectsBox", (ray, box) => ray.intersectsBox(box)]],
};

const ns = () => Number(process.cpuUsage().user) * 1000;
console.log(`three.js r${REVISION}, node ${process.version}`);
for (const { title, isBall, rays, bodies, right } of families()) {
  const hit = right.filter(Boolean).length;
  console.log(`${title}, ${right.length} rays, ${hit} hit`);
  for (const [name, ask] of METHODS[isBall ? "ball" : "box"]) {
    const point = new Vector3();
    const answers = new Array(right.length);
    const rounds = 10;
    const pass = () => {
      for (let i = 0; i < rays.length; i += 1) answers[i] = ask(rays[i], bodies[i], point);
    };
    for (let i = 0; i < rounds; i += 1) pass();
    const missed = right.filter((is, i) => is && !answers[i]).length;
    const invented = right.filter((is, i) => !is && answers[i]).length;
    const times = [];
    for (let run = 0; run < runs; run += 1) {
      const start = ns();
      for (let i = 0; i < rounds; i += 1) pass();
      times.push((ns() - start) / (rounds * rays.length));
    }
    times.sort((a, b) => a - b);
    const shown = (value, width) => value.toFixed(1).padStart(width);
    console.log(
      `  ${name.padEnd(38)} ${shown(times[Math.floor(runs / 2)], 8)} ${shown(times[0], 7)} - ${shown(times[runs - 1], 7)} ${String(missed).padStart(8)} ${String(invented).padStart(9)}`,
    );
  }
  console.log("");
}
