// A bullet at 800 m/s and a wall of 5 cm: sampled at 60 frames a second, and by the segment of each
// frame. Then a ball that passes a box: the enlarged box, and the rounded one.
#include <contact/ball_box.hpp>
#include <contact/first_in_scene.hpp>
#include <cstdio>
#include <vector>

using namespace contact;

int main() {
  // [bullet]
  const std::vector<Primitive<double>> scene{Aabb<double>{{50, -2, 0}, {50.05, 2, 3}}};
  for (const double speed : {2.0, 20.0, 200.0, 800.0}) {
    int by_samples = 0, by_segments = 0;
    constexpr int shots = 1000;
    for (int k = 0; k < shots; ++k) {
      const Vector3<double> step(speed / 60, 0, 0);
      const Vector3<double> start(step.x() * k / shots, 0, 1);  // spread over one frame
      const int frames = static_cast<int>(60 * 60 / speed) + 1;
      by_samples += bullet_by_samples<double>(start, step, frames, scene) ? 1 : 0;
      by_segments += bullet_by_segments<double>(start, step, frames, scene) ? 1 : 0;
    }
    std::printf("%3g m/s, %7.3f m a frame: stopped by samples %4d, by segments %4d of %d\n", speed,
                speed / 60, by_samples, by_segments, shots);
  }
  // [/bullet]

  const Aabb<double> box{{0, 0, 0}, {2, 2, 2}};
  const Segment<double> path{{-3.6, 2, 1}, {2, -3.6, 1}};
  for (const double radius : {0.5, 1.0, 1.25}) {
    std::printf("ball of radius %-4g past an edge: enlarged box %-4s rounded box %s\n", radius,
                ball_hits_enlarged_box(path, radius, box) ? "hit," : "no,",
                ball_hits_box(path, radius, box) ? "hit" : "no");
  }
}
