// A rod of 1 kg and 2 m at 45 degrees: its lower right end meets a rough floor at (-0.6, -1) m/s,
// while the rod rotates at -1 rad/s; friction 1/2. The impact by five laws.
#include <contact/impact_friction.hpp>
#include <cstdio>

using V = contact::Vector3<double>;

void print(const char* law, const contact::PlanarContact<double>& c,
           const contact::Impact<double>& impact, double before) {
  std::printf("%-8s %8.4f %8.4f %8.4f %8.4f   x %.2f\n", law, impact.end().tangential,
              impact.end().impulse, impact.end().slip, -impact.end().normal / c.normal,
              1 + contact::energy_change(impact) / before);
}

int main() {
  const double s = std::sqrt(0.5);
  const V none(0, 0, 0);
  const V angular_velocity(0, 0, -1);
  const V r(s, -s, 0);  // from the middle to the lower right end
  const auto rod = contact::rigid_body<double>(
      1, contact::detail::diagonal<double>(1.0 / 3, 1.0 / 3, 1.0 / 3), V(-r),
      V(-0.6, -1, 0) - V(angular_velocity.cross(r)), angular_velocity);
  const auto floor = contact::immovable<double>(none, none, none);
  const auto c = contact::planar_contact<double>(rod, floor, {none, {0, 1, 0}}, {1, 0, 0});
  std::printf("inverse effective mass: k_tt = %.2f, k_tn = %.2f, k_nn = %.2f 1/kg\n", c.k_tt,
              c.k_tn, c.k_nn);
  const double before = contact::kinetic_energy(rod);
  for (const double e : {1.0, 0.5}) {
    std::printf("e = %g    p_t      p_n      slip'  -un'/un   energy\n", e);
    print("Newton", c, contact::newton_impact(c, e, 0.5), before);
    print("Poisson", c, contact::poisson_impact(c, e, 0.5), before);
    print("Stronge", c, contact::stronge_impact(c, e, 0.5), before);
    print("joint", c, *contact::joint_impact(c, e, 0.5), before);
    print("clamped", c, contact::clamped_impact(c, e, 0.5), before);
  }
  const auto path = contact::newton_impact(c, 1.0, 0.5);
  std::printf("Newton, e = 1, (slip, u_n):");
  for (std::size_t k = 0; k < path.count; ++k) {
    std::printf(" (%.2f, %.2f)", path.path[k].slip, path.path[k].normal);
  }
  std::printf("\n");
}
