// Right answers are computed exactly and rounded once (the speed: its dot product and its squared
// length, rounded once each). Every test expects at least two different answers, so that no
// constant passes.
#include "parallel_and_perpendicular.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>

#include <contact/exact.hpp>

namespace {

using namespace contact::testing;
using contact::Exact;
using exercise::Components;
using Vector = Eigen::Vector3d;

Exact exact_dot(const Vector& a, const Vector& b) {
  Exact sum;
  for (int k = 0; k < 3; ++k) sum += Exact(a(k)) * Exact(b(k));
  return sum;
}
double rounded_to_double(const Exact& x) { return quotient<double>(x, Exact(1.0)); }

/// Σ |a||b|, coordinate by coordinate.
double size(const Vector& a, const Vector& b) { return a.cwiseAbs().dot(b.cwiseAbs()); }

void check_speed(const Vector& v, const Vector& d) {
  const double length = std::sqrt(rounded_to_double(exact_dot(d, d)));
  const double right = rounded_to_double(exact_dot(v, d)) / length;
  // A dot product (3 u), a length (3 u) and a quotient; or a unit vector first (4 u and 3 u); and
  // 3 u of the right answer's own. Doubled.
  const double bound = 20 * 0x1p-53 * size(v, d) / length;
  ask("What is the component of the velocity along the direction?")
      .given("velocity", v)
      .given("direction", d)
      .suspect("direction-not-normalised", [&]() -> double { return v.dot(d); })
      .suspect("speed-along-without-sign",
               [&]() -> double { return std::abs(v.dot(d)) / d.norm(); })
      .suspect("cosine-for-speed", [&]() -> double { return v.dot(d) / (v.norm() * d.norm()); })
      .answer([&] { return exercise::speed_along(v, d); })
      .close_to(right, within(bound));
}

void check_split(const Vector& v, const Vector& d) {
  const Exact dd = exact_dot(d, d);
  const Exact vd = exact_dot(v, d);
  Components right;
  Components bound;
  // A dot product (3 u), two lengths (7 u at most), a quotient, two products; then a difference.
  // Doubled.
  const double share = size(v, d) / d.squaredNorm();
  for (int k = 0; k < 3; ++k) {
    right.parallel(k) = quotient<double>(vd * Exact(d(k)), dd);
    right.perpendicular(k) = quotient<double>(Exact(v(k)) * dd - vd * Exact(d(k)), dd);
    bound.parallel(k) = 26 * 0x1p-53 * share * std::abs(d(k));
    bound.perpendicular(k) = bound.parallel(k) + 4 * 0x1p-53 * std::abs(v(k));
  }
  const auto parts = [&](double factor) {
    const Vector parallel = factor * d;
    return Components{parallel, v - parallel};
  };
  ask("What are the parts of the velocity along the direction and perpendicular to it?")
      .given("velocity", v)
      .given("direction", d)
      .suspect("direction-not-normalised", [&] { return parts(v.dot(d)); })
      .suspect("length-divided-once", [&] { return parts(v.dot(d) / d.norm()); })
      .suspect("speed-along-without-sign",
               [&] { return parts(std::abs(v.dot(d)) / d.squaredNorm()); })
      .answer([&] { return exercise::split(v, d); })
      .close_to(right, within(bound));
}

}  // namespace

TEST_CASE("a speed along a direction has a sign") {
  check_speed({3, -4, 0}, {0, 1, 0});
  check_speed({3, 4, 0}, {0, 1, 0});
  check_speed({3, -4, 12}, {0, 0, -1});
  check_speed({5, 0, 0}, {0, 1, 0});
}

TEST_CASE("the length of the direction does not count") {
  check_speed({10, 5, 0}, {3, 4, 0});
  check_speed({10, 5, 0}, {30, 40, 0});
  check_speed({1, 2, 3}, {0.125, 0.25, 0.25});
}

TEST_CASE("the two parts of a velocity that hits a slope") {
  check_split({2, -10, 0}, {3, 4, 0});
  check_split({2, -10, 0}, {-3, -4, 0});
  check_split({1, 2, 3}, {0, 0, 5});
  check_split({4, 6, 8}, {2, 3, 4});
  check_split({4, -8, 0}, {2, 1, 0});
}

TEST_CASE("a direction without length is refused") {
  check_speed({3, -4, 0}, {0, 2, 0});
  check_speed({3, -4, 0}, {2, 0, 0});
  const Vector velocity(3, -4, 0);
  const Vector nowhere(0, 0, 0);
  ask("What is the component of the velocity along the direction?")
      .given("velocity", velocity)
      .given("direction", nowhere)
      .suspect_if("zero-direction-not-refused", [](const double&) { return true; })
      .answer([&] { return exercise::speed_along(velocity, nowhere); })
      .throws_invalid_argument();
  ask("What are the parts of the velocity along the direction and perpendicular to it?")
      .given("velocity", velocity)
      .given("direction", nowhere)
      .suspect_if("zero-direction-not-refused", [](const Components&) { return true; })
      .answer([&] { return exercise::split(velocity, nowhere); })
      .throws_invalid_argument();
}

TEST_CASE("random velocities agree with exact arithmetic") {
  generators::Random random(seed(0));
  for (int asked = 0; asked < 300; ++asked) {
    const Vector v{random.uniform(-9, 9), random.uniform(-9, 9), random.uniform(-9, 9)};
    const double scale = std::ldexp(1.0, random.integer(-20, 20));
    const Vector d =
        scale * Vector{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(0.1, 1)};
    check_speed(v, d);
    check_split(v, d);
  }
}
