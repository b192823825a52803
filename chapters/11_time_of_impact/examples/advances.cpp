// A long box turns towards a wall: conservative advancement, with one bound on the speed of all
// points, and with bounds along the normal of the wall.
#include <contact/conservative_advancement.hpp>
#include <contact/turning_impact.hpp>
#include <cstdio>

namespace {

using Vector = contact::Vector3<double>;

/// A box of 2 m × 0.1 m × 0.1 m, 1.5 m from the wall, that moves by 0.8 m and turns by 1.5 rad.
contact::RotatingBox<double> rod() {
  contact::RotatingBox<double> box;
  box.position = {0, 0, 0};
  box.half_lengths = {1, 0.05, 0.05};
  box.orientation = contact::exponential<double>(Vector(0, 0, 1.5));
  box.velocity = {0.8, 0, 0};
  box.angular_velocity = {0, 0, -1.5};
  return box;
}

/// The wall is solid from x = 1.5 m on.
double distance_at(double t) {
  const contact::CoordinateFrame<double> frame = contact::frame_at(rod(), t);
  const Vector extent = frame.axes.cwiseAbs() * rod().half_lengths;
  return 1.5 - frame.origin.x() - extent.x();
}

}  // namespace

int main() {
  contact::RotatingBox<double> wall;
  wall.half_lengths = {1, 1, 1};
  const double speed = contact::approach_bound(rod(), wall);
  std::printf("no point approaches by more than %.4f m in the step\n", speed);
  std::printf("advance  time    distance, m\n");
  int advance = 0;
  const auto told = [&](double t) {
    const double distance = distance_at(t);
    std::printf("%7d  %.4f  %.4f\n", ++advance, t, distance);
    return distance;
  };
  contact::conservative_advancement(told, speed, 1.0, 0.01, 100);

  const contact::CoordinateFrame<double> start = contact::frame_at(rod(), 0.0);
  const contact::OrientedBox<double> box{start.origin, start.axes, rod().half_lengths};
  const contact::TurningMotion<double> motion{start.origin, rod().velocity, rod().angular_velocity};
  const contact::HalfSpace<double> half_space{{Vector(-1, 0, 0), -1.5}};
  const auto found = contact::turning_impact(box, motion, half_space, 0.01);
  std::printf("with bounds along the normal: %d advances, to %.4f\n", found.advances, found.t);
}
