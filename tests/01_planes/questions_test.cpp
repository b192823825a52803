#include "support/questions.hpp"

#include <algorithm>
#include <cmath>
#include <contact/moving_sphere_plane.hpp>
#include <contact/plane.hpp>
#include <contact/segment_plane.hpp>
#include <contact/sphere_plane.hpp>
#include <set>

#define CONTACT_FIGURE_NO_MAIN
#include <contact/figure.hpp>
namespace moving_sphere {
#include "figures/moving_sphere.cpp"
}
namespace segment_plane {
#include "figures/segment_plane.cpp"
}

namespace questions_test {

using Vector = contact::Vector3<double>;

KEY("slope-distance") {
  const auto plane = contact::plane_from_normal_and_point<double>({-3, 0, 4}, {0, 0, 2});
  return contact::signed_distance(plane, Vector(4, 0, 0));
}

KEY("bullet-fraction") {
  const auto wall = contact::plane_from_normal_and_point<double>({-1, 0, 0}, {10, 0, 0});
  return contact::segment_plane<double>({{6, 0, 0}, {12, 0, 0}}, wall)->t;
}

KEY("both-ends-on") {
  const auto plane = contact::plane_from_normal_and_point<double>({0, 0, 1}, {0, 0, 0});
  const auto hit = contact::segment_plane<double>({{1, 2, 0}, {3, 4, 0}}, plane);
  if (!hit) return 3;
  if (std::isnan(hit->t)) return 2;
  return hit->t == 0 ? 0 : 1;
}

KEY("long-normal") {
  const contact::RawPlane<double> raw{{3, 0, 4}, 0};  // |N| = 5
  const auto says = [&raw](double side) {
    const contact::Sphere<double> sphere{side * Vector(1.2, 0, 1.6), 3};  // 2 m away
    return std::abs(raw.normal.dot(sphere.centre) - raw.offset) <= sphere.radius;
  };
  if (says(1) != says(-1)) return 2;
  return says(1) ? 0 : 1;
}

KEY("moving-sphere-steps") {
  // The steps that must precede each step: those that compute its input, and for the division, the
  // two tests that make it safe.
  const std::vector<std::set<int>> needs{{1, 2, 3, 4, 5}, {}, {5}, {1}, {2, 5}, {1, 3}};
  std::vector<int> order;
  std::set<int> done;
  while (order.size() < needs.size()) {
    std::vector<int> possible;
    for (int i = 0; i < static_cast<int>(needs.size()); ++i) {
      const auto& before = needs[static_cast<std::size_t>(i)];
      if (done.count(i) == 0 &&
          std::includes(done.begin(), done.end(), before.begin(), before.end())) {
        possible.push_back(i);
      }
    }
    if (possible.size() != 1)
      return std::vector<int>{};  // with two right orders the question has no single answer
    order.push_back(possible.front());
    done.insert(possible.front());
  }
  return order;
}

KEY("touch-time") {
  const auto wall = contact::plane_from_normal_and_point<double>({-1, 0, 0}, {3.25, 0, 0});
  const double step = 1;
  return step * contact::moving_sphere_plane<double>({{0, 0, 0}, 0.25}, {6 * step, 0, 0}, wall)->t;
}

KEY("polygon-edge") {
  const double radius = 0.5;
  const auto floor = contact::plane_from_normal_and_point<double>({0, 0, 1}, {0, 0, 0});
  const Vector start(1.25, 0, 3);
  const Vector way(0, 0, -6);
  const auto touch = contact::moving_sphere_plane<double>({start, radius}, way, floor);
  const bool offset_square =
      touch && std::abs(touch->centre.x()) <= 1 && std::abs(touch->centre.y()) <= 1;
  double nearest = 1e300;  // of the centre to the square, along the path
  for (int i = 0; i <= 1000; ++i) {
    const Vector c = start + (i / 1000.0) * way;
    const Vector on_square(std::clamp(c.x(), -1.0, 1.0), std::clamp(c.y(), -1.0, 1.0), 0);
    nearest = std::min(nearest, (c - on_square).norm());
  }
  if (offset_square) return 0;
  return nearest <= radius ? 1 : 2;
}

KEY("touch-half-way") {
  moving_sphere::Input state{{0, 0, 1}, {0, 0, 0}, {0, 0, -3}, 1, {1, 0, 4}};
  const double winning = moving_sphere::compute(state).half_way_from_behind;
  state.centre.z() = 3;
  state.displacement.z() = -4;  // at half of the displacement, but from the front
  return questions::Construct{winning, moving_sphere::compute(state).half_way_from_behind};
}

KEY("cross-at-a-quarter") {
  segment_plane::Input state{{0, 0, 2}, {0, 0, 1}, {0, 0, -1}, {0, 0, 7}};
  const double winning = segment_plane::compute(state).quarter_from_behind;
  std::swap(state.start, state.end);
  return questions::Construct{winning, segment_plane::compute(state).quarter_from_behind};
}

KEY("three-points") {
  // (0, 2, 1) is a point of the plane: 3 · 2 + 4 · 1 = 10.
  const auto plane = contact::plane_from_normal_and_point<double>({0, 3, 4}, {0, 2, 1});
  return questions::Gaps{{"first", contact::signed_distance(plane, Vector(0, 2, 6))},
                         {"second", contact::signed_distance(plane, Vector(7, 0, 0))},
                         {"third", contact::signed_distance(plane, Vector(1, -5, 0))}};
}

KEY("why-squares") {
  // A sphere of radius 3 m, 2 m from a plane: the decision for normals of the lengths 1 and 5.
  const auto decided = [](bool squared, double length) {
    const double value = 2 * length;
    return squared ? value * value <= 9 * length * length : std::abs(value) <= 3;
  };
  return questions::Claim{decided(true, 1) == decided(true, 5),
                          decided(false, 1) == decided(false, 5)};
}

}  // namespace questions_test
