// Right components are the formula without rounding, rounded once; a right axis is the difference
// of the centres divided by its length. Every test asks for at least two different answers, so that
// no constant passes one.
#include "line_of_centres.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>

#include <contact/exact.hpp>

namespace {

using namespace contact::testing;
using contact::Exact;
using exercise::Components;
using Vector = Eigen::Vector2d;
using Axis = std::optional<Vector>;

void check_axis(const Vector& a, const Vector& b) {
  const Vector d = a - b;
  const Axis right = a == b ? Axis() : Axis(d / std::sqrt(d.x() * d.x() + d.y() * d.y()));
  auto answer =
      ask("What is the unit vector of the line of impact, from B to A?")
          .given("centre_a", a)
          .given("centre_b", b)
          .suspect_if("division-by-zero", [](const Axis& got) { return got && !got->allFinite(); })
          .suspect("axis-not-normalised", [&] { return Axis(d); })
          .suspect("axis-reversed", [&] { return Axis(-d / d.norm()); })
          .answer([&] { return exercise::line_of_centres(a, b); });
  if (!right) return std::move(answer).equals(right);
  // Six roundings in either computation: a difference, two squares and their sum, a root, a
  // quotient.
  std::move(answer).close_to(right, within(Axis(Vector(12 * 0x1p-53, 12 * 0x1p-53))));
}

void check_parts(const Vector& velocity, const Vector& axis) {
  const Exact reach = Exact(axis.x()) * Exact(velocity.x()) + Exact(axis.y()) * Exact(velocity.y());
  const auto normal = [&](int k) { return reach * Exact(axis(k)); };
  const auto tangential = [&](int k) { return Exact(velocity(k)) - normal(k); };
  const auto vector = [](const auto& part) {
    return Vector(quotient<double>(part(0), Exact(1.0)), quotient<double>(part(1), Exact(1.0)));
  };
  const Components right{vector(normal), vector(tangential)};
  // Two products and a sum, a product and a difference; the sum may be as large as |v|.
  const double bound = 8 * 0x1p-53 * (std::abs(velocity.x()) + std::abs(velocity.y()));
  const Vector room(bound, bound);
  ask("What are the normal and tangential components of the velocity?")
      .given("velocity", velocity)
      .given("axis", axis)
      .suspect("parts-exchanged",
               [&]() -> Components {
                 return {right.tangential, right.normal};
               })
      .suspect("projection-without-sign",
               [&]() -> Components {
                 const Vector part = std::abs(axis.dot(velocity)) * axis;
                 return {part, velocity - part};
               })
      .answer([&] { return exercise::components(velocity, axis); })
      .close_to(right, within(Components{room, room}));
}

}  // namespace

TEST_CASE("the axis has length 1 and points from B to A") {
  check_axis({3, 4}, {0, 0});
  check_axis({0, 0}, {3, 4});
  check_axis({1, -2}, {1, 3});
  check_axis({0.5, 0.25}, {-1.5, 0.25});
}

TEST_CASE("coincident centres have no axis") {
  check_axis({2, 1}, {1, 1});
  check_axis({1, 1}, {1, 1});
  check_axis({-0.5, 8}, {-0.5, 8});
}

TEST_CASE("the tangential component is the rest") {
  check_parts({5, 2}, {1, 0});
  check_parts({5, 2}, {0, 1});
  check_parts({10, 5}, {0.6, 0.8});
}

TEST_CASE("a component against the axis is negative") {
  check_parts({-5, 2}, {1, 0});
  check_parts({5, 2}, {-1, 0});
  check_parts({-10, 5}, {0.6, -0.8});
}

TEST_CASE("random velocities agree with exact arithmetic") {
  generators::Random random(seed(0));
  const auto vector = [&] { return Vector{random.uniform(-9, 9), random.uniform(-9, 9)}; };
  for (int asked = 0; asked < 200; ++asked) {
    const Vector a = vector();
    const Vector b = vector();
    check_axis(a, b);
    const Vector d = a - b;
    check_parts(vector(), d / std::sqrt(d.x() * d.x() + d.y() * d.y()));
  }
}
