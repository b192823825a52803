// Tunnelling: a bullet tested sixty times a second is in front of the wall, then behind it.
#include <contact/plane.hpp>
#include <contact/segment_plane.hpp>
#include <cstdio>

int main() {
  const double speed = 360;       // m/s
  const double frame = 1.0 / 60;  // s
  const auto wall = contact::plane_from_normal_and_point<double>({-1, 0, 0}, {10, 0, 0});

  contact::Vector3<double> position(0, 1.5, 0);  // m
  const contact::Vector3<double> velocity(speed, 0, 0);
  for (int i = 0; i < 3; ++i) {
    const contact::Vector3<double> next = position + velocity * frame;
    std::printf("frame %d: %g m to %g m, signed distances %g m and %g m", i, position.x(), next.x(),
                contact::signed_distance(wall, position), contact::signed_distance(wall, next));
    if (const auto hit = contact::segment_plane<double>({position, next}, wall)) {
      std::printf(": hit at %.4f of the step, %.5f s after the shot", hit->t, (i + hit->t) * frame);
    }
    std::printf("\n");
    position = next;
  }
}
