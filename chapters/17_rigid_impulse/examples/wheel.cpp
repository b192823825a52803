// A wheel of radius 0.5 m rolls at 3 m/s: its points have all speeds from 0 to 6 m/s.
#include <contact/rigid_impulse.hpp>
#include <cstdio>

const char* name(contact::Closing closing) {
  switch (closing) {
    case contact::Closing::approaching:
      return "closing";
    case contact::Closing::touching:
      return "touching";
    default:
      return "separating";
  }
}

int main() {
  using V = contact::Vector3<double>;
  const double radius = 0.5;
  const auto inertia = contact::cylinder_inertia<double>(10, radius, 0.1);
  const V centre(0, 0, radius);
  const auto wheel = contact::rigid_body<double>(10, inertia, centre, {3, 0, 0}, {0, 6, 0});
  for (const auto& [what, p] :
       {std::pair{"hub", V(0, 0, 0.5)}, std::pair{"top", V(0, 0, 1)},
        std::pair{"front", V(0.5, 0, 0.5)}, std::pair{"road", V(0, 0, 0)}}) {
    const V v = contact::velocity_at(wheel, p);
    const V reversed = wheel.velocity + V(V(p - centre).cross(wheel.angular_velocity));
    std::printf("%-6s (%g, %g, %g) m/s    with r x w: (%g, %g, %g)\n", what, v.x(), v.y(), v.z(),
                reversed.x(), reversed.y(), reversed.z());
  }

  // The end of a plank whose middle rises still collides if it rotates fast enough.
  const auto road = contact::immovable<double>({0, 0, -1}, {0, 0, 0}, {0, 0, 0});
  const contact::ContactPoint<double> end{{1, 0, 0}, {0, 0, 1}};
  std::printf("plank: middle rises at 1 m/s, right end 1 m away touches the ground\n");
  for (const double angular_velocity : {0.5, 1.0, 2.0}) {
    const auto plank =
        contact::rigid_body<double>(6, contact::box_inertia<double>(6, {2, 0.2, 0.1}), {0, 0, 0},
                                    {0, 0, 1}, {0, angular_velocity, 0});
    std::printf("  spin %g rad/s: v_n = %4.1f m/s, %s\n", angular_velocity,
                contact::normal_velocity(plank, road, end),
                name(contact::closing_case(plank, road, end)));
  }
}
