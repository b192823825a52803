// Tests with wrong answers whose simplest failing input is known. Part of exercise_specimen.cpp.
#pragma once

#include <cmath>
#include <numeric>
#include <string>
#include <vector>

#include <support/shrinkable.hpp>

namespace shrinking_specimen {

using namespace contact::testing;

struct Shape {
  std::vector<Eigen::Vector2d> points;
  bool closed = true;
  int rounds = 0;
  std::optional<double> width;
};

/// Wrong if more than two points lie to the right of 10.
inline void check_shape(const Shape& shape) {
  int far = 0;
  for (const auto& point : shape.points) far += point.x() > 10 ? 1 : 0;
  ask("How many are far?")
      .given("shape", shape)
      .answer([&] { return std::min(far, 2); })
      .equals(far);
}

/// Wrong above 7.3; throws above a hundred, which is another mistake.
inline void check_number(double x) {
  ask("What is twice x?")
      .given("x", x)
      .answer([&] {
        if (x > 100) throw std::runtime_error("too large");
        return x > 7.3 ? 0.0 : 2 * x;
      })
      .equals(2 * x);
}

inline void check_normal(const Eigen::Vector3d& normal) {
  ask("How long is it?")
      .given("normal", normal)
      .answer([] { return 2.0; })
      .close_to(1, within(0.1));
}

inline void check_todo(int n) {
  ask("n?").given("n", n).answer([&]() -> int { contact::todo(); }).equals(n);
}

}  // namespace shrinking_specimen

TEST_CASE("looked at: numbers") {
  using namespace shrinking_specimen;
  for (const double x : {1.5, 2.25, 3.0, 4.0, 7.0, 812.75, 99.123, 8.5})
    shrinkable(
        check_number, [](double) { return true; }, x);
  check_number(50);
}

TEST_CASE("looked at: a shape") {
  using namespace shrinking_specimen;
  Shape shape;
  for (int i = 0; i < 40; ++i) shape.points.push_back({5.37 * i, 0.123 + i});
  shape.rounds = -17;
  shape.width = 2.5;
  shrinkable(
      check_shape, [](const Shape&) { return true; }, shape);
}

TEST_CASE("looked at: only what is judged") {
  using namespace shrinking_specimen;
  const auto is_unit = [](const Eigen::Vector3d& n) { return std::abs(n.norm() - 1) < 1e-12; };
  shrinkable(check_normal, is_unit, Eigen::Vector3d(Eigen::Vector3d(0.3, -0.8, 0.1).normalized()));
}

TEST_CASE("looked at: not attempted") {
  using namespace shrinking_specimen;
  shrinkable(
      check_todo, [](int) { return true; }, 12);
}
