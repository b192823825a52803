// The lecture's step of one second with an impact in its middle, and a wedge in which one step has
// four impacts.
#include <contact/advance.hpp>
#include <cstdio>

using Vector = contact::Vector3<double>;

void show(const char* name, const contact::Advance<double>& end) {
  std::printf("%-16s %d impacts, at (%.2f, %.2f) m, velocity (%.2f, %.2f) m/s\n", name, end.impacts,
              end.state.position.x(), end.state.position.z(), end.state.velocity.x(),
              end.state.velocity.z());
}

int main() {
  const contact::Plane<double> floor{Vector(0, 0, 1), 0};
  const auto rules = contact::impact_rules(1.0, 0.0, 100);
  show("half a second:", contact::advance_straight<double>({Vector(0, 0, 0.5), Vector(1, 0, -1)},
                                                           0.0, 1.0, {floor}, rules));
  // A second wall, which makes a wedge of 36.87 degrees with the floor.
  const contact::Plane<double> leaning{Vector(0.6, 0, -0.8), 0};
  for (const int most : {1, 2, 3, 100}) {
    char name[24];
    std::snprintf(name, sizeof name, "at most %d:", most);
    show(name, contact::advance_straight<double>({Vector(2, 0, 1), Vector(-3, 0, -1)}, 0.0, 1.0,
                                                 {floor, leaning},
                                                 contact::impact_rules(1.0, 0.0, most)));
  }
}
