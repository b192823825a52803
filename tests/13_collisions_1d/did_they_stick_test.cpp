// All numbers are small whole numbers, and first masses are powers of two, so every right formula
// is exact. Every test asks for at least two different answers, so that no constant passes one.
#include "did_they_stick.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>

namespace {

using namespace contact::testing;
using exercise::Before;
using exercise::Kind;
using exercise::Report;

Kind kind_of(double separation, double closing) {
  if (separation < 0) return Kind::passed_through;
  if (separation == 0) return Kind::together;
  if (separation == closing) return Kind::elastic;
  return separation < closing ? Kind::inelastic : Kind::energy_gained;
}

Report from(double first_after, double restitution) {
  return {first_after, restitution, kind_of(restitution, 1)};
}

void check(const Before& before, double second_after) {
  const double gained = before.second_mass * (second_after - before.second_velocity);
  const double first_after = before.first_velocity - gained / before.first_mass;
  const double closing = before.first_velocity - before.second_velocity;
  const double separation = second_after - first_after;
  const Report right{first_after, separation / closing, kind_of(separation, closing)};
  // e is a quotient, rounded once; in another form perhaps three times.
  const Report room{0, 4 * 0x1p-53 * std::abs(right.restitution), right.kind};
  ask("What kind of collision was it?")
      .given("before", before)
      .given("second_after", second_after)
      .suspect("energy-ratio-for-restitution",
               [&] {
                 const auto energy = [&before](double v1, double v2) {
                   return before.first_mass * v1 * v1 + before.second_mass * v2 * v2;
                 };
                 return from(first_after,
                             energy(first_after, second_after) /
                                 energy(before.first_velocity, before.second_velocity));
               })
      .suspect("restitution-upside-down", [&] { return from(first_after, closing / separation); })
      .suspect("separation-without-sign",
               [&] { return from(first_after, std::abs(separation) / closing); })
      .suspect("momentum-without-mass",
               [&] {
                 const double alike = before.first_velocity + before.second_velocity - second_after;
                 return from(alike, (second_after - alike) / closing);
               })
      .suspect_if("momentum-not-conserved",
                  [&](const Report& got) {
                    const double missing = before.first_mass * (got.first_after - first_after);
                    const double alike =
                        before.first_velocity + before.second_velocity - second_after;
                    return std::abs(missing) > 1e-9 && std::abs(got.first_after - alike) > 1e-9;
                  })
      .answer([&] { return exercise::report(before, second_after); })
      .close_to(right, within(room));
}

}  // namespace

TEST_CASE("the truck and the parked car") {
  // The truck's mass is no power of two, but all quotients here are whole.
  check({3000, 20, 1000, 0}, 15);
  check({3000, 20, 1000, 0}, 30);
  check({3000, 20, 1000, 0}, 21);
}

TEST_CASE("the momentum that the second gains the first has lost") {
  check({4, 6, 1, -2}, 6);
  check({1, 6, 4, -2}, 0);
  check({8, 5, 3, 1}, 4);
}

TEST_CASE("equal speeds of approach and separation are elastic") {
  check({1, 7, 1, -3}, 7);
  check({2, 9, 4, 0}, 6);
  check({2, 9, 4, 0}, 8);
  check({2, 9, 4, 0}, 4);
}

TEST_CASE("bodies that passed through each other are recognised") {
  check({4, 6, 2, 0}, 2);
  check({4, 6, 2, 0}, 0);
  check({4, 6, 2, 0}, 6);
}

TEST_CASE("random collisions are classified right") {
  generators::Random random(seed(0));
  for (int asked = 0; asked < 300; ++asked) {
    const double m1 = std::ldexp(1.0, random.integer(0, 3));
    const double m2 = random.integer(1, 9);
    const double v2 = random.integer(-9, 8);
    const double v1 = v2 + random.integer(1, 9);
    check({m1, v1, m2, v2}, random.integer(-12, 20));
  }
}
