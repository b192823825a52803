// Right answers are fractions of exact numbers, rounded once. Every test asks for at least two
// different answers, so that no constant passes one.
#include "fly_apart.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>

#include <contact/exact.hpp>

namespace {

using namespace contact::testing;
using contact::Exact;
using exercise::Remainder;
using Vector = Eigen::Vector2d;

Exact square(const Vector& v) { return Exact(v.x()) * Exact(v.x()) + Exact(v.y()) * Exact(v.y()); }

Remainder exact_rest(double mass, const Vector& v, double piece, const Vector& w) {
  const Exact left = Exact(mass) - Exact(piece);
  Vector velocity(0, 0);
  Exact momentum2;
  for (int k = 0; k < 2; ++k) {
    const Exact p = Exact(mass) * Exact(v(k)) - Exact(piece) * Exact(w(k));
    velocity(k) = quotient<double>(p, left);
    momentum2 += p * p;
  }
  // ½ m w² + p²/(2 (M − m)) − ½ M v²
  const Exact twice = Exact(piece) * square(w) * left + momentum2 - Exact(mass) * square(v) * left;
  return {velocity, quotient<double>(twice, Exact(2.0) * left)};
}

void check(double mass, const Vector& v, double piece, const Vector& w) {
  const Remainder right = exact_rest(mass, v, piece, w);
  const double left = mass - piece;
  const double scale = mass * v.norm() + piece * w.norm();
  // Two products, a difference, a quotient by a difference: 6 u of the momenta. An energy is off by
  // m v' times that, and by 8 u of the sum of its terms.
  const double off = 8 * 0x1p-53 * scale / left;
  const double speed = right.velocity.norm();
  const double energies =
      mass * v.squaredNorm() + piece * w.squaredNorm() + left * right.velocity.squaredNorm();
  const double energy_off = 2 * left * (speed + off) * off + 8 * 0x1p-53 * energies;
  const auto energy = [](double m, const Vector& velocity) {
    return m * velocity.squaredNorm() / 2;
  };
  const auto with = [&](const Vector& rest, double rest_mass) -> Remainder {
    return {rest, energy(piece, w) + energy(rest_mass, rest) - energy(mass, v)};
  };
  ask("What is the velocity of the remainder, and what kinetic energy is gained?")
      .given("mass", mass)
      .given("velocity", v)
      .given("piece_mass", piece)
      .given("piece_velocity", w)
      .suspect("whole-mass-after", [&] { return with((mass * v - piece * w) / mass, mass); })
      .suspect("recoil-forwards", [&] { return with((mass * v + piece * w) / left, left); })
      .suspect("relative-for-ground", [&] { return with(v - piece / left * w, left); })
      .suspect("energy-taken-for-conserved",
               [&]() -> Remainder {
                 return {right.velocity, 0};
               })
      .suspect("energy-of-piece-alone",
               [&]() -> Remainder {
                 return {right.velocity, energy(piece, w) - energy(mass, v)};
               })
      .answer([&] { return exercise::send_out(mass, v, piece, w); })
      .close_to(right, within(Remainder{Vector(off, off), energy_off}));
}

void check_refused(double mass, double piece) {
  const Vector v(1, 2);
  const Vector w(-3, 0);
  ask("What is the velocity of the remainder, and what kinetic energy is gained?")
      .given("mass", mass)
      .given("velocity", v)
      .given("piece_mass", piece)
      .given("piece_velocity", w)
      .suspect_if("mass-not-refused", [](const Remainder&) { return true; })
      .answer([&] { return exercise::send_out(mass, v, piece, w); })
      .throws_invalid_argument();
}

}  // namespace

TEST_CASE("from rest the two pieces leave in opposite directions") {
  check(210, {0, 0}, 4, {16, 0});
  check(8, {0, 0}, 2, {3, -6});
}

TEST_CASE("the momentum of a moving nucleus is conserved") {
  check(8, {2, 1}, 2, {2, -6});
  check(8, {2, 1}, 4, {0, 0});
  check(210, {-3, 1}, 4, {16, 2});
}

TEST_CASE("kinetic energy is gained") {
  check(8, {0, 0}, 2, {6, 0});
  check(8, {1, 0}, 2, {6, 3});
  check(8, {1, 0}, 2, {1, 0});
}

TEST_CASE("an invalid mass of the piece is refused") {
  check(8, {2, 1}, 2, {2, -6});
  check(8, {2, 1}, 7.5, {2, -6});
  check_refused(8, 8);
  check_refused(8, 9);
  check_refused(8, 0);
  check_refused(8, -1);
  check_refused(8, std::numeric_limits<double>::quiet_NaN());
}

TEST_CASE("random decays agree with exact arithmetic") {
  generators::Random random(seed(0));
  const auto vector = [&] { return Vector{random.uniform(-9, 9), random.uniform(-9, 9)}; };
  for (int asked = 0; asked < 200; ++asked) {
    const double mass = random.uniform(1, 250);
    const Vector v = vector();
    const double piece = mass * random.uniform(0.01, 0.9);
    check(mass, v, piece, vector());
  }
}
