// Right answers are computed exactly and rounded once. Each coordinate may have a relative error of
// 4 u: Kahan's difference of products is off by 2 u, one with twice the digits by little more than
// 1 u, and the right answer by 1 u. Every test expects at least two different answers.
#include "last_digits.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>

#include <contact/products.hpp>

namespace {

using namespace contact::testing;
using Vector = Eigen::Vector3d;

Vector fused_once(const Vector& u, const Vector& v) {
  return {std::fma(u.y(), v.z(), -(u.z() * v.y())), std::fma(u.z(), v.x(), -(u.x() * v.z())),
          std::fma(u.x(), v.y(), -(u.y() * v.x()))};
}

void check(const Vector& u, const Vector& v) {
  const Vector right = contact::cross_exactly<double>(u, v);
  const Vector room = 4 * 0x1p-53 * right.cwiseAbs();
  ask("What is the cross product of u and v?")
      .given("u", u)
      .given("v", v)
      .suspect("products-rounded", [&]() -> Vector { return u.cross(v); })
      .suspect("fused-once", [&] { return fused_once(u, v); })
      .suspect("differences-cure-all", [&]() -> Vector { return u.cross(Vector(v - u)); })
      .suspect_if("absolute-epsilon",
                  [&](const Vector& got) {
                    // A zero that rounding gives too has another cause.
                    if (got == u.cross(v)) return false;
                    for (int k = 0; k < 3; ++k) {
                      if (std::abs(got(k) - right(k)) <= room(k)) continue;
                      const bool small = std::abs(right(k)) <= 1e-6 * u.norm() * v.norm();
                      if (got(k) != 0 || !small) return false;
                    }
                    return true;
                  })
      .answer([&] { return exercise::cross(u, v); })
      .close_to(right, within(room));
}

}  // namespace

TEST_CASE("whole numbers give whole numbers") {
  check({1, 0, 0}, {0, 1, 0});
  check({3, -1, 2}, {4, 5, -6});
  check({0, 0, 0}, {1, 2, 3});
  check({-7, 8, 9}, {10, -11, 12});
}

TEST_CASE("parallel vectors give zero, and nearly parallel ones do not") {
  check({0.1, 0.3, 0.7}, {0.1, 0.3, 0.7});
  check({0.1, 0.3, 0.7}, {-0.2, -0.6, -1.4});
  check({1, 1, 1}, {1 + 0x1p-50, 1, 1});
  check({1, 1 + 0x1p-50, 1}, {1, 1, 1});
}

TEST_CASE("the difference of nearly equal products is accurate") {
  check({1 + 0x1p-30, 1, 0}, {1, 1 - 0x1p-30, 0});
  check({1 + 0x1p-27, 1 + 0x1p-26, 3}, {1, 1 + 0x1p-27, 3});
  check({0.1, 0.3, 0.7}, {0.3, 0.9, 2.1});
  check({1e50, 1e40, 1}, {1e-40, 1e-50, 1});
}

TEST_CASE("random edges of slivers agree with exact arithmetic") {
  generators::Random random(seed(0));
  for (int asked = 0; asked < 300; ++asked) {
    const Vector u{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    const double share = random.uniform(0.5, 2);
    const double small = std::ldexp(1.0, random.integer(-52, -10));
    const Vector off{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    check(u, share * u + small * off);
  }
}
