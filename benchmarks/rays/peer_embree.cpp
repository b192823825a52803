// Embree's balls, one in each scene.
#include <embree3/rtcore.h>

#include <limits>

#include "peers.hpp"

namespace {

/// A device and its scenes, released together.
struct Scenes {
  RTCDevice device = nullptr;
  std::vector<RTCScene> scenes;

  Scenes() = default;
  Scenes(const Scenes&) = delete;
  Scenes& operator=(const Scenes&) = delete;
  ~Scenes() {
    for (RTCScene scene : scenes) rtcReleaseScene(scene);
    if (device != nullptr) rtcReleaseDevice(device);
  }
};

}  // namespace

peers::Ask peers::embree(const Questions<BallOfFloats>& questions, const char* device,
                         bool robust) {
  auto all = std::make_shared<Scenes>();
  all->device = rtcNewDevice(device);
  for (const BallOfFloats& ball : questions.bodies) {
    RTCScene scene = rtcNewScene(all->device);
    if (robust) rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    RTCGeometry geometry = rtcNewGeometry(all->device, RTC_GEOMETRY_TYPE_SPHERE_POINT);
    auto* vertex = static_cast<float*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4, 4 * sizeof(float), 1));
    for (std::size_t k = 0; k < 3; ++k) vertex[k] = ball.centre[k];
    vertex[3] = ball.radius;
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene);
    all->scenes.push_back(scene);
  }
  return [all, rays = questions.rays](std::vector<char>& answers) {
    in_turn(rays, all->scenes, answers, [](const RayOfFloats& from, RTCScene scene) {
      RTCIntersectContext context;
      rtcInitIntersectContext(&context);
      RTCRay ray{};
      ray.org_x = from.origin[0];
      ray.org_y = from.origin[1];
      ray.org_z = from.origin[2];
      ray.dir_x = from.direction[0];
      ray.dir_y = from.direction[1];
      ray.dir_z = from.direction[2];
      ray.tnear = 0;
      ray.tfar = std::numeric_limits<float>::infinity();
      ray.mask = ~0U;
      rtcOccluded1(scene, &context, &ray);
      return ray.tfar < 0;  // how it says that something is hit
    });
  };
}
