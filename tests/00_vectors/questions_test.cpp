#include "support/questions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <contact/angle.hpp>
#include <contact/frame.hpp>
#include <contact/products.hpp>
#include <contact/vector.hpp>
#include <limits>
#include <numbers>
#include <set>

#include "support/generators.hpp"

#define CONTACT_FIGURE_NO_MAIN
#include <contact/figure.hpp>
namespace products {
#include "figures/products.cpp"
}
namespace tenths {
#include "figures/tenths.cpp"
}
namespace frames {
#include "figures/frames.cpp"
}

namespace questions_test {

using contact::Vector3;

namespace {

/// The wagon of two questions: at (2, 1), facing along the world's y.
contact::CoordinateFrame<double> wagon() {
  contact::CoordinateFrame<double> frame;
  frame.origin = {2, 1, 0};
  frame.axes.col(0) = Vector3<double>(0, 1, 0);
  frame.axes.col(2) = Vector3<double>(0, 0, 1);
  frame.axes.col(1) = Vector3<double>(frame.axes.col(2)).cross(Vector3<double>(frame.axes.col(0)));
  return frame;
}

template <std::size_t N>
int index_of(const Vector3<double>& right, const std::array<Vector3<double>, N>& options) {
  const auto found = std::find(options.begin(), options.end(), right);
  return found == options.end() ? -1 : static_cast<int>(found - options.begin());
}

}  // namespace

KEY("dot-sign") {
  // Among random pairs, what the angle is (by the law of cosines) when the dot product is negative.
  generators::Random random(1);
  std::array<int, 3> seen{};
  for (int i = 0; i < 1000; ++i) {
    const auto a = generators::point(random, generators::Family::random);
    const auto b = generators::point(random, generators::Family::random);
    if (a.dot(b) >= 0) continue;
    const double opposite = (a - b).squaredNorm();
    const double right_angle = a.squaredNorm() + b.squaredNorm();
    ++seen[opposite < right_angle ? 0 : opposite == right_angle ? 1 : 2];
  }
  return static_cast<int>(std::max_element(seen.begin(), seen.end()) - seen.begin());
}

KEY("along-normal") {
  return contact::dot_accurately(Vector3<double>(3, -4, 0), Vector3<double>(0, 1, 0));
}

KEY("cross-direction") {
  const Vector3<double> a(0, 0, 0);
  const Vector3<double> b(1, 0, 0);
  const Vector3<double> c(0, 1, 0);
  const Vector3<double> normal =
      contact::cross_accurately(Vector3<double>(b - a), Vector3<double>(c - a));
  if (normal.z() > 0) return 0;
  if (normal.z() < 0) return 1;
  return normal.x() > 0 ? 2 : 3;
}

KEY("triangle-by-cross") {
  return contact::cross_accurately(Vector3<double>(3, 0, 0), Vector3<double>(0, 0, 4)).norm() / 2;
}

KEY("make-perpendicular") {
  const double winning = products::compute({{1, 1, 0}, {1, -1, 0.5}}).perpendicular;
  return questions::Construct{winning,
                              products::compute({{1, 1, 0}, {1, -0.9, 0.5}}).perpendicular};
}

KEY("down-and-back") {
  const double winning = products::compute({{1, 0, 0}, {-1, -1, 0}}).down_and_back;
  return questions::Construct{winning, products::compute({{1, 0, 0}, {1, -1, 0}}).down_and_back};
}

KEY("stone-in-wagon") {
  return index_of(
      contact::position_in_frame(wagon(), {2, 4, 0}),
      std::array<Vector3<double>, 4>{Vector3<double>{3, 0, 0}, {0, 3, 0}, {4, -2, 0}, {2, 4, 0}});
}

KEY("wind-in-wagon") {
  return index_of(
      contact::direction_in_frame(wagon(), {0, 5, 0}),
      std::array<Vector3<double>, 4>{Vector3<double>{4, 2, 0}, {5, 0, 0}, {0, 5, 0}, {2, 6, 0}});
}

KEY("ahead-and-left") {
  // Facing along (3, 4)/5: 2 ahead and 1 to the left is (1.2 - 0.8, 1.6 + 0.6) from the origin.
  const double winning = frames::compute({{1, 1}, {1.5, 2}, {1.4, 3.2}}).ahead_and_left;
  return questions::Construct{winning, frames::compute({{1, 1}, {2, 0}, {3, 2}}).ahead_and_left};
}

KEY("stopping-distance") {
  // In other units the same distance must come out. A metre is 1000 mm, a second is 1/60 minute;
  // only the right formula's value changes by just a factor of 1000.
  const auto formulas = [](double v, double a) {
    return std::array{v / (2 * a), 2 * a / (v * v), v * v / (2 * a), v * v * a / 2};
  };
  const auto in_metres = formulas(20, 8);
  const auto in_others = formulas(20.0 * 1000 * 60, 8.0 * 1000 * 3600);
  int right = -1;
  for (std::size_t i = 0; i < in_metres.size(); ++i) {
    if (std::abs(in_others[i] / in_metres[i] - 1000) > 1e-9) continue;
    if (right >= 0) return -1;
    right = static_cast<int>(i);
  }
  return right;
}

KEY("feet-per-second") { return 20 * 0.3048; }

KEY("sine-of-thirty") { return std::sin(30.0); }

KEY("tenth-sum") {
  const tenths::Output out = tenths::compute({1, 2, 53});
  // None is stored exactly, the exact sum is rounded, and the result is a neighbour of the nearest.
  const tenths::Output three = tenths::compute({3, 3, 53});
  const bool none_as_meant = out.error_a != 0 && out.error_b != 0 && three.error_a != 0;
  const bool neighbour = out.equal == 0 && std::abs(out.nearest_at) == 1;
  const bool additions_can_be_exact = 0.25 + 0.5 == 0.75;
  return none_as_meant && neighbour && additions_can_be_exact ? 1 : -1;
}

KEY("wrong-in-single") {
  const double winning = tenths::compute({1, 6, 24}).differs_in_float;
  return questions::Construct{winning, tenths::compute({1, 2, 24}).differs_in_float};
}

KEY("cancellation") {
  const double big = std::ldexp(1.0, 53);
  return (big + 1.0) - big;
}

KEY("squares-apart") {
  const double a = 100000001;
  const double b = 100000000;
  return a * a - b * b;
}

KEY("side-steps") {
  // The steps that must precede each step.
  const std::vector<std::set<int>> needs{{4}, {0}, {}, {0, 1}, {2}};
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

KEY("ulp-far-away") { return 1000.0 * double(contact::ulp(10000.0f)); }

KEY("small-angle") {
  const Vector3<double> u(1, 0, 0);
  const Vector3<double> v(1, 1e-9, 0);  // unit to the last bit
  const double cosine = u.dot(v);
  const std::array<double, 3> got{std::acos(cosine), *contact::angle_between(u, v),
                                  2 * std::acos(std::sqrt((1 + cosine) / 2))};
  const auto good = [](double angle) { return std::abs(angle - 1e-9) <= 1e-20; };
  if (std::count_if(got.begin(), got.end(), good) != 1) return -1;
  return static_cast<int>(std::find_if(got.begin(), got.end(), good) - got.begin());
}

KEY("first-angle") { return 1e9 * std::acos(std::nextafter(1.0, 0.0)); }

KEY("badly-asked") {
  // The lines y = 0 and y = x sin θ / cos θ, and the second one half a millimetre higher.
  const double angle = 0.001 * std::numbers::pi / 180;
  const double moved = 0.0005 / std::sin(angle);
  return moved > 10 && moved < 100 ? 2 : -1;
}

KEY("split-a-velocity") {
  const Vector3<double> v(2, 4, 0), n(0.6, 0.8, 0);
  const double along = v.dot(n);
  const Vector3<double> rest = v - along * n;
  return questions::Gaps{{"along", along}, {"rest-x", rest.x()}, {"rest-y", rest.y()}};
}

KEY("why-acos-fails") {
  const double pi = std::numbers::pi;
  const auto off = [](double angle) { return std::abs(std::acos(std::cos(angle)) - angle); };
  return questions::Claim{off(pi - 1e-9) > 0.5e-9, off(pi / 2 - 1e-9) > 1e-15};
}

}  // namespace questions_test
