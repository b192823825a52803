// Right answers come from both products, each computed without rounding and rounded once, and from
// atan2: their relative error is at most 6 u. The contract allows 36 u: a cross product computed
// plainly is off by 2 √3 u |u||v| (and its length by 4 u of it), a dot product by 3 u |u||v|, and
// the angle by no more than both and the 2 u of atan2: under 14 u π / 2. Every test expects at
// least two different answers.
#include "angle_between.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>

#include <contact/products.hpp>

namespace {

using namespace contact::testing;
using Vector = Eigen::Vector3d;

constexpr double kRoom = 4e-15;

double right_angle(const Vector& u, const Vector& v) {
  return std::atan2(contact::cross_exactly<double>(u, v).norm(),
                    contact::dot_exactly<double, 3>(u, v));
}

/// The usual ways to write the cosine, whose roundings differ.
std::vector<Suspect<double>> by_acos(const Vector& u, const Vector& v) {
  std::vector<Suspect<double>> suspects;
  for (const double cosine : {u.dot(v) / (u.norm() * v.norm()), u.dot(v) / u.norm() / v.norm(),
                              u.dot(v) / v.norm() / u.norm(), u.normalized().dot(v.normalized()),
                              u.dot(v) / std::sqrt(u.squaredNorm() * v.squaredNorm()),
                              u.dot(v) / std::sqrt(u.dot(u)) / std::sqrt(v.dot(v))}) {
    suspects.emplace_back("angle-by-acos",
                          std::function<double()>([cosine] { return std::acos(cosine); }));
    suspects.emplace_back("angle-by-acos", std::function<double()>([cosine] {
                            return std::acos(std::clamp(cosine, -1.0, 1.0));
                          }));
  }
  return suspects;
}

void check(const Vector& u, const Vector& v) {
  const double cosine = u.dot(v) / (u.norm() * v.norm());
  const double sine = u.cross(v).norm() / (u.norm() * v.norm());
  const double right = right_angle(u, v);
  ask("What is the angle between u and v?")
      .given("u", u)
      .given("v", v)
      .suspects(by_acos(u, v))
      .suspect("lengths-forgotten",
               [&]() -> double {
                 // A NaN has many causes, so it is no sign of this one.
                 if (std::abs(u.dot(v)) > 1) throw std::domain_error("no arccosine");
                 return std::acos(u.dot(v));
               })
      .suspect("angle-by-asin", [&]() -> double { return std::asin(std::min(sine, 1.0)); })
      .suspect("quadrant-lost", [&]() -> double { return std::atan(sine / cosine); })
      .suspect("degrees-returned", [&]() -> double { return right * 180 / std::numbers::pi; })
      .answer([&] { return exercise::angle_between(u, v); })
      .close_to(right, within(kRoom));
}

void check_refused(const Vector& u, const Vector& v) {
  ask("What is the angle between u and v?")
      .given("u", u)
      .given("v", v)
      .suspect_if("zero-angle-not-refused", [](const double&) { return true; })
      .answer([&] { return exercise::angle_between(u, v); })
      .throws_invalid_argument();
}

}  // namespace

TEST_CASE("right angles, and none") {
  check({1, 0, 0}, {0, 1, 0});
  check({0, 1, 0}, {0, 1, 0});
  check({0, 0, 1}, {1, 0, 0});
}

TEST_CASE("obtuse angles") {
  check({1, 0, 0}, {-1, 1, 0});
  check({1, 0, 0}, {-1, 0.25, 0});
  check({0, 1, 0}, {0, -1, 0});
  check({1, 0, 0}, {1, 1, 0});
}

TEST_CASE("the lengths do not count") {
  check({0.25, 0, 0}, {0.25, 0.125, 0});
  check({3, 0, 0}, {5, 5, 0});
  check({1e-9, 0, 0}, {1e9, 1e9, 1e9});
}

TEST_CASE("small angles, and angles near π, are accurate") {
  for (const double small : {1e-3, 1e-6, 1e-8, 1e-11}) {
    check({1, 0, 0}, {1, small, 0});
    check({1, 2, 3}, {1 + small, 2, 3});
    check({1, 0, 0}, {-1, small, 0});
  }
}

TEST_CASE("a vector without length is refused") {
  check({1, 0, 0}, {1, 1, 0});
  check({1, 0, 0}, {0, 0, 2});
  check_refused({0, 0, 0}, {1, 2, 3});
  check_refused({1, 2, 3}, {0, 0, 0});
}

TEST_CASE("random vectors agree with both products computed exactly") {
  generators::Random random(seed(0));
  for (int asked = 0; asked < 300; ++asked) {
    const double scale = std::ldexp(1.0, random.integer(-20, 20));
    const Vector u{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(0.1, 1)};
    Vector v{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(0.1, 1)};
    if (random.chance(0.5)) v = u + std::ldexp(1.0, random.integer(-40, -1)) * v;
    if (random.chance(0.5)) v = -v;
    check(u, scale * v);
  }
}
