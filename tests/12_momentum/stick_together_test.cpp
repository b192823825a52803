// Right answers are sums without rounding, rounded once. Every test asks for at least two different
// answers, so that no constant passes one.
#include "stick_together.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>
#include <support/shrinkable.hpp>

#include <contact/exact.hpp>

namespace {

using namespace contact::testing;
using contact::Exact;
using exercise::Body;
using Bodies = std::vector<Body>;
using Vector = Eigen::Vector3d;

Exact momentum(const Bodies& bodies, int k) {
  Exact sum;
  for (const Body& body : bodies) sum += Exact(body.mass) * Exact(body.velocity(k));
  return sum;
}
Exact mass(const Bodies& bodies) {
  Exact sum;
  for (const Body& body : bodies) sum += Exact(body.mass);
  return sum;
}
/// Σ m |v|.
Vector scale(const Bodies& bodies) {
  Vector sum(0, 0, 0);
  for (const Body& body : bodies) sum += body.mass * body.velocity.cwiseAbs();
  return sum;
}
double rounded_mass(const Bodies& bodies) {
  double sum = 0;
  for (const Body& body : bodies) sum += body.mass;
  return sum;
}

Vector with_speeds(const Bodies& bodies, bool as_length) {
  Vector sum(0, 0, 0);
  for (const Body& body : bodies) {
    sum += as_length ? Vector(body.mass * body.velocity.norm(), 0, 0)
                     : Vector(body.mass * body.velocity.cwiseAbs());
  }
  return sum;
}

/// n products and sums, a quotient and the sum of the masses: (2 n + 4) u of Σ m |v|, in any order.
double roundings(const Bodies& bodies) {
  return (2 * static_cast<double>(bodies.size()) + 4) * 0x1p-53;
}

void check_momentum(const Bodies& bodies) {
  const auto coordinate = [&](int k) { return quotient<double>(momentum(bodies, k), Exact(1.0)); };
  const Vector right{coordinate(0), coordinate(1), coordinate(2)};
  ask("What is the total momentum of the bodies?")
      .given("bodies", bodies)
      .suspect("speeds-for-velocities", [&] { return with_speeds(bodies, false); })
      .suspect("speeds-for-velocities", [&] { return with_speeds(bodies, true); })
      .answer([&] { return exercise::total_momentum(bodies); })
      .close_to(right, within(Vector(roundings(bodies) * scale(bodies))));
}

void check_velocity(const Bodies& bodies) {
  const Exact whole = mass(bodies);
  const auto coordinate = [&](int k) { return quotient<double>(momentum(bodies, k), whole); };
  const Vector right{coordinate(0), coordinate(1), coordinate(2)};
  const double m = rounded_mass(bodies);
  ask("What is the velocity of the bodies after they have stuck together?")
      .given("bodies", bodies)
      .suspect("mean-of-velocities",
               [&]() -> Vector {
                 Vector sum(0, 0, 0);
                 for (const Body& body : bodies) sum += body.velocity;
                 return sum / static_cast<double>(bodies.size());
               })
      .suspect("speeds-for-velocities", [&]() -> Vector { return with_speeds(bodies, false) / m; })
      .suspect("speeds-for-velocities", [&]() -> Vector { return with_speeds(bodies, true) / m; })
      .suspect_if("mass-of-one",
                  [&](const Vector& got) {
                    if (bodies.size() < 2) return false;
                    for (const Body& body : bodies) {
                      const Vector alone = right * m / body.mass;
                      if ((got - alone).norm() <= 1e-12 * alone.norm()) return true;
                    }
                    return false;
                  })
      .answer([&] { return exercise::velocity_together(bodies); })
      .close_to(right, within(Vector(roundings(bodies) * scale(bodies) / m)));
}

void check_refused(const Bodies& bodies) {
  ask("What is the velocity of the bodies after they have stuck together?")
      .given("bodies", bodies)
      .suspect_if("mass-not-refused", [](const Vector&) { return true; })
      .answer([&] { return exercise::velocity_together(bodies); })
      .throws_invalid_argument();
}

const Bodies kPlayers{{90, {6, 0, 0}}, {80, {-7, 0, 0}}};

}  // namespace

TEST_CASE("momenta add as vectors") {
  check_momentum({{2, {3, 0, 0}}, {2, {0, 4, 0}}});
  check_momentum(kPlayers);
  check_momentum({{5, {1, 2, -3}}, {5, {-1, -2, 3}}});
  check_momentum({});
}

TEST_CASE("two players on a line move on with one velocity") {
  check_velocity(kPlayers);
  check_velocity({{90, {6, 0, 0}}, {80, {7, 0, 0}}});
  check_velocity({{60, {2, 0, 0}}, {60, {-2, 0, 0}}});
}

TEST_CASE("the heavier body counts for more") {
  check_velocity({{1, {8, 0, 0}}, {3, {0, 4, 0}}});
  check_velocity({{1, {8, 0, 0}}, {7, {0, 0, 0}}});
}

TEST_CASE("the order of sticking together does not matter") {
  const Bodies three{{1, {8, 0, 4}}, {3, {0, 4, 0}}, {4, {-2, 1, 8}}};
  check_velocity(three);
  // The first two have become one body of 4 kg at (2, 3, 1) m/s.
  check_velocity({{4, {2, 3, 1}}, three[2]});
  check_velocity({{1, {8, 0, 4}}, {3, {0, 4, 0}}});
}

TEST_CASE("invalid masses are refused") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  check_velocity(kPlayers);
  check_velocity({{1, {8, 0, 0}}, {3, {0, 4, 0}}});
  check_refused({{90, {6, 0, 0}}, {0, {-7, 0, 0}}});
  check_refused({{-1, {6, 0, 0}}, {80, {-7, 0, 0}}});
  check_refused({{90, {6, 0, 0}}, {nan, {-7, 0, 0}}});
  check_refused({});
}

TEST_CASE("random bodies agree with exact arithmetic") {
  generators::Random random(seed(0));
  const auto have_mass = [](const Bodies& bodies) {
    return !bodies.empty() && std::all_of(bodies.begin(), bodies.end(),
                                          [](const auto& body) { return body.mass > 0; });
  };
  for (int asked = 0; asked < 300; ++asked) {
    Bodies bodies;
    for (int n = random.integer(1, 8); n > 0; --n) {
      const double m = random.uniform(0.1, 50);
      const Vector v{random.uniform(-9, 9), random.uniform(-9, 9), random.uniform(-9, 9)};
      bodies.push_back({m, v});
    }
    shrinkable(check_momentum, have_mass, bodies);
    shrinkable(check_velocity, have_mass, bodies);
  }
}
