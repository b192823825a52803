// three-mesh-bvh asked where a segment first meets a mesh. Of its settings those are taken that are best at this
// question: both sides of each triangle, a tree by the surface area heuristic, and a ray that ends with the segment.

import { BufferAttribute, BufferGeometry, DoubleSide, Ray, Vector3 } from "three";
import { MeshBVH, SAH } from "three-mesh-bvh";
import { dependencies } from "../../../package.json";
import type { PeerCode } from "../ladder-peers.ts";

/** Numbers of a question: which mesh, start, end. */
const SIZE = 7;

/** The trees of meshes that follow one another: numbers of vertices and of triangles, coordinates, triangles. */
function treesOf(given: Float64Array): MeshBVH[] {
  const trees: MeshBVH[] = [];
  for (let at = 0; at < given.length; ) {
    const indices = at + 2 + 3 * given[at]!;
    const end = indices + 3 * given[at + 1]!;
    const geometry = new BufferGeometry();
    // They are floats, so nothing is rounded.
    const coordinates = Float32Array.from(given.subarray(at + 2, indices));
    geometry.setAttribute("position", new BufferAttribute(coordinates, 3));
    geometry.setIndex(new BufferAttribute(Uint32Array.from(given.subarray(indices, end)), 1));
    // Indirect: triangles keep their numbers. That takes no longer.
    trees.push(new MeshBVH(geometry, { strategy: SAH, indirect: true }));
    at = end;
  }
  return trees;
}

/**
 * A power of two that makes a direction 1 to 2 long. three.js asks for length 1, which would be rounded: such a ray
 * passes beside the vertex that it is aimed at. Nor may it be shorter: three-mesh-bvh compares the end of the ray with
 * distances to triangles, but with t at boxes, and would lose boxes before the end.
 */
const scale = (length: number): number => (length > 0 ? 2 ** -Math.floor(Math.log2(length)) : 1);

/** Told: the triangle that is met first, -1 if there is none, and t of the point, in lengths of the segment. */
export function bvh(given: Float64Array): PeerCode {
  const trees = treesOf(given);
  return {
    version: dependencies["three-mesh-bvh"],
    note: "its trees are built before, as the book's are",
    prepare(questions) {
      const meshes: MeshBVH[] = [];
      const rays: Ray[] = [];
      const lengths: number[] = [];
      for (let at = 0; at < questions.length; at += SIZE) {
        meshes.push(trees[questions[at]!]!);
        const start = new Vector3().fromArray(questions, at + 1);
        const along = new Vector3().fromArray(questions, at + 4).sub(start);
        const length = along.length();
        lengths.push(length);
        rays.push(new Ray(start, along.multiplyScalar(scale(length))));
      }
      const hits: ReturnType<MeshBVH["raycastFirst"]>[] = rays.map(() => null);
      return {
        pass() {
          for (let i = 0; i < rays.length; i += 1)
            hits[i] = meshes[i]!.raycastFirst(rays[i]!, DoubleSide, 0, lengths[i]!);
        },
        answers: () =>
          Float64Array.from(
            hits.flatMap((hit, i) =>
              hit ? [hit.faceIndex!, hit.distance / lengths[i]!] : [-1, Number.NaN],
            ),
          ),
      };
    },
  };
}
