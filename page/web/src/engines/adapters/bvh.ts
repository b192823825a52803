// three-mesh-bvh: rays at meshes.

import { BufferAttribute, BufferGeometry, DoubleSide, Ray, Vector3 } from "three";
import { MeshBVH } from "three-mesh-bvh";
import { dependencies } from "../../../../package.json";
import type { Adapter, Engine } from "../types.ts";

const engine: Engine = {
  meshHits(mesh, rays) {
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(mesh.vertices, 3));
    geometry.setIndex(new BufferAttribute(mesh.triangles, 1));
    const tree = new MeshBVH(geometry, { indirect: true });
    return rays.map(({ origin, direction, length }) => {
      const ray = new Ray(new Vector3(...origin), new Vector3(...direction));
      return tree.raycastFirst(ray, DoubleSide, 0, length)?.distance ?? Number.POSITIVE_INFINITY;
    });
  },
};

export const bvh: Adapter = {
  id: "bvh",
  title: "three-mesh-bvh",
  version: dependencies["three-mesh-bvh"],
  dimension: 3,
  licence: "MIT",
  promise:
    "Raycasting and spatial queries of three.js meshes, accelerated by a tree of boxes; how exact they are is not said.",
  source: "https://github.com/gkjohnson/three-mesh-bvh",
  iterations: "none",
  switches: "none: it simulates nothing",
  load: async () => engine,
};
