// Every test asks for at least two different answers, so that no constant passes one. Random cases
// avoid friction that just stops the slip, though the answer is continuous there.
#include "rough_surface.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>

namespace {

using namespace contact::testing;
using Vector = Eigen::Vector3d;

/// The remaining slip by each rule; `taken` is what friction would take.
template <class Kept>
Vector with(const Vector& v, const Vector& n, double k, const Kept& kept) {
  const double along = v.dot(n);
  const Vector tangent = v - along * n;
  const double slip = tangent.norm();
  const double share = slip > 0 ? kept(slip, -along) : 0;
  return share * tangent - k * along * n;
}

Vector right_answer(const Vector& v, const Vector& n, double k, double mu) {
  if (!(v.dot(n) < 0)) return v;
  return with(v, n, k, [&](double slip, double closing) {
    return std::max(0.0, 1 - mu * (1 + k) * closing / slip);
  });
}

void check(const Vector& v, const Vector& n, double k, double mu) {
  // The normal and the tangential component are each off by some 10 u |v|, and the effect of
  // friction by (1 + k) μ as much: twice 20 (1 + μ) u |v|.
  const double bound = 40 * (1 + mu) * 0x1p-53 * v.norm();
  ask("What is the velocity after the bounce?")
      .given("velocity", v)
      .given("normal", n)
      .given("k", k)
      .given("friction", mu)
      .suspect("bounce-when-separating",
               [&]() -> Vector {
                 return with(v, n, k, [&](double slip, double closing) {
                   return std::max(0.0, 1 - mu * (1 + k) * std::abs(closing) / slip);
                 });
               })
      .suspect("bounce-when-separating",
               [&]() -> Vector {
                 if (v.dot(n) < 0) return right_answer(v, n, k, mu);
                 return with(v, n, k, [&](double slip, double closing) {
                   return 1 - mu * (1 + k) * closing / slip;
                 });
               })
      .suspect("friction-turns-back",
               [&]() -> Vector {
                 // There this formula would speed the slip up.
                 if (!(v.dot(n) < 0)) return v;
                 return with(v, n, k, [&](double slip, double closing) {
                   return 1 - mu * (1 + k) * closing / slip;
                 });
               })
      .suspect("friction-of-the-stop-alone",
               [&]() -> Vector {
                 return with(v, n, k, [&](double slip, double closing) {
                   return std::max(0.0, 1 - mu * closing / slip);
                 });
               })
      .suspect("slip-scaled-by-friction",
               [&]() -> Vector {
                 return with(v, n, k, [&](double, double) { return std::max(0.0, 1 - mu); });
               })
      .answer([&] { return exercise::after_rough_bounce(v, n, k, mu); })
      .close_to(right_answer(v, n, k, mu), within(Vector(bound, bound, bound)));
}

void check_angle(double incidence, double k, double mu) {
  const double right = std::max(0.0, incidence - mu * (1 + k)) / k;
  const double bound = 8 * 0x1p-53 * (incidence + mu * (1 + k)) / k;
  ask("What is the tangent of the angle of rebound?")
      .given("incidence", incidence)
      .given("k", k)
      .given("friction", mu)
      .suspect("rebound-as-incidence", [&] { return std::max(0.0, incidence - mu * (1 + k)); })
      .suspect("friction-turns-back", [&] { return (incidence - mu * (1 + k)) / k; })
      .suspect("friction-of-the-stop-alone", [&] { return std::max(0.0, incidence - mu) / k; })
      .suspect("slip-scaled-by-friction", [&] { return std::max(0.0, 1 - mu) * incidence / k; })
      .answer([&] { return exercise::rebound_tangent(incidence, k, mu); })
      .close_to(right, within(bound));
}

}  // namespace

TEST_CASE("without friction the tangential component is unchanged") {
  check({3, 0, -4}, {0, 0, 1}, 0.5, 0);
  check({0, -2, -4}, {0, 0, 1}, 1, 0);
  check({0, 0, -4}, {0, 0, 1}, 0.5, 0);
}

TEST_CASE("friction acts during the whole change of the normal velocity") {
  check({6, 0, -4}, {0, 0, 1}, 0.5, 0.25);  // 0.25 · 1.5 · 4 = 1.5 of 6
  check({0, 8, -4}, {0, 0, 1}, 1, 0.5);
  check({-5, 1, 2}, {0, 0, -1}, 0.75, 0.125);
  check({0.5, 0, -1}, {0, 0, 1}, 0.5, 0.25);  // 0.25 · 1.5 · 1 = 0.375 of 0.5
}

TEST_CASE("friction stops the slip and does not reverse it") {
  check({1, 0, -4}, {0, 0, 1}, 0.5, 0.5);
  check({0, 2, -8}, {0, 0, 1}, 0.25, 1);
  check({0, 0, -8}, {0, 0, 1}, 0.25, 1);
}

TEST_CASE("a body that moves away is left alone") {
  check({1, 2, -3}, {0, 0, 1}, 0.5, 0.25);
  check({1, 2, 3}, {0, 0, 1}, 0.5, 0.25);
  check({5, 0, 1}, {0, 0, 1}, 0.5, 0.5);
}

TEST_CASE("the angle of rebound") {
  check_angle(1, 1, 0);
  check_angle(1, 0.5, 0);
  check_angle(2, 0.5, 0.5);
  check_angle(0.5, 0.5, 0.5);
}

TEST_CASE("random bounces agree") {
  generators::Random random(seed(0));
  const auto vector = [&] {
    return Vector{random.uniform(-9, 9), random.uniform(-9, 9), random.uniform(-9, 9)};
  };
  for (int asked = 0; asked < 300; ++asked) {
    const Vector v = vector();
    const Vector n = vector().normalized();
    const double k = random.uniform(0.1, 1);
    const double mu = random.uniform(0, 1);
    const double along = v.dot(n);
    if (!(std::abs(along) > 1e-9)) continue;
    check(v, n, k, mu);
    check_angle(random.uniform(0, 3), k, mu);
  }
}
