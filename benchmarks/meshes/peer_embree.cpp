// Embree's trees: one mesh in a scene.
#include <embree3/rtcore.h>

#include <algorithm>
#include <limits>

#include "peers.hpp"

namespace {

/// A device and a scene, released together.
struct Scene {
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;

  Scene() = default;
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;
  ~Scene() {
    if (scene != nullptr) rtcReleaseScene(scene);
    if (device != nullptr) rtcReleaseDevice(device);
  }
};

RTCRay ray_of(const peers::Floats& origin, const peers::Floats& direction, float last) {
  RTCRay ray{};
  ray.org_x = origin[0];
  ray.org_y = origin[1];
  ray.org_z = origin[2];
  ray.dir_x = direction[0];
  ray.dir_y = direction[1];
  ray.dir_z = direction[2];
  ray.tnear = 0;
  ray.tfar = last;
  ray.mask = ~0U;
  return ray;
}

constexpr float infinity = std::numeric_limits<float>::infinity();

/// What is computed only to be timed.
volatile float kept = 0;

void build(Scene& all, const peers::MeshOfFloats& mesh, bool robust) {
  if (all.scene != nullptr) rtcReleaseScene(all.scene);
  all.scene = rtcNewScene(all.device);
  if (robust) rtcSetSceneFlags(all.scene, RTC_SCENE_FLAG_ROBUST);
  RTCGeometry geometry = rtcNewGeometry(all.device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0,
                                                               RTC_FORMAT_FLOAT3, 3 * sizeof(float),
                                                               mesh.vertices.size()));
  for (const peers::Floats& v : mesh.vertices) vertices = std::copy(v.begin(), v.end(), vertices);
  auto* indices = static_cast<unsigned*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                              3 * sizeof(unsigned), mesh.triangles.size()));
  for (const std::array<int, 3>& triangle : mesh.triangles) {
    for (const int v : triangle) *indices++ = static_cast<unsigned>(v);
  }
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(all.scene, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(all.scene);
}

}  // namespace

peers::Tree peers::embree(const MeshOfFloats& mesh, const char* device, bool robust) {
  auto all = std::make_shared<Scene>();
  all->device = rtcNewDevice(device);
  Tree tree;
  tree.build = [all, &mesh, robust] { build(*all, mesh, robust); };
  tree.first = [all](const RaysOfFloats& rays, Answers& answers) {
    float sum = 0;
    in_turn(rays.origins.size(), answers, [&](std::size_t i) {
      RTCIntersectContext context;
      rtcInitIntersectContext(&context);
      RTCRayHit query{};
      query.ray = ray_of(rays.origins[i], rays.directions[i], infinity);
      query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
      rtcIntersect1(all->scene, &context, &query);
      if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return -1;
      sum += query.ray.tfar;
      return static_cast<int>(query.hit.primID);
    });
    kept = sum;
  };
  tree.any = [all](const RaysOfFloats& rays, Answers& answers) {
    in_turn(rays.origins.size(), answers, [&](std::size_t i) {
      RTCIntersectContext context;
      rtcInitIntersectContext(&context);
      RTCRay ray = ray_of(rays.origins[i], rays.directions[i], infinity);
      rtcOccluded1(all->scene, &context, &ray);
      return ray.tfar < 0;  // how it says that something is hit
    });
  };
  tree.segment = [all](const RaysOfFloats& rays, Answers& answers) {
    in_turn(rays.origins.size(), answers, [&](std::size_t i) {
      RTCIntersectContext context;
      rtcInitIntersectContext(&context);
      const Floats &start = rays.origins[i], &end = rays.ends[i];
      RTCRay ray = ray_of(start, {end[0] - start[0], end[1] - start[1], end[2] - start[2]}, 1);
      rtcOccluded1(all->scene, &context, &ray);
      return ray.tfar < 0;
    });
  };
  return tree;
}
