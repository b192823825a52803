// Right answers come from a second implementation in long double, which follows the impact segment
// by segment; the reference has its own tests against exact fractions. Every test asks for at least
// two different answers, so that no constant passes one.
#include "rod_on_floor.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>

#include <algorithm>

namespace {

using namespace contact::testing;
using exercise::Body;
using exercise::Motion;
using Vector = Eigen::Vector2d;
using Real = long double;

enum class Law { newton, poisson, stronge };
enum class Slip { coulomb, never_stops, stays_stopped };

struct Contact {
  Real slip, sink, tt, tn, nn;
};

Contact contact_of(const Body& body, const Vector& point) {
  const Real x = Real(point.x()) - body.centre.x();
  const Real y = Real(point.y()) - body.centre.y();
  const Real m = 1 / Real(body.mass);
  const Real i = 1 / Real(body.inertia);
  return {body.velocity.x() - body.angular_velocity * y,
          body.velocity.y() + body.angular_velocity * x, m + y * y * i, -x * y * i, m + x * x * i};
}

Motion pushed(const Body& body, const Vector& point, Real t, Real n) {
  const Real x = Real(point.x()) - body.centre.x();
  const Real y = Real(point.y()) - body.centre.y();
  return {{double(body.velocity.x() + t / body.mass), double(body.velocity.y() + n / body.mass)},
          double(body.angular_velocity + (x * n - y * t) / body.inertia)};
}

/// The impulses of the impact, tangential and normal.
std::pair<Real, Real> impact(const Contact& c, Real e, Real mu, Law law, Slip way) {
  Real slip = c.slip;
  Real sink = c.sink;
  Real t = 0;
  Real n = 0;
  Real work = 0;    // of the normal impulse
  Real turned = 0;  // normal impulse at greatest compression; 0 before it
  Real owed = 0;    // work to be given back
  for (int piece = 0; piece < 8; ++piece) {
    Real pull = slip > 0 ? -mu : mu;
    bool stays = false;
    if (slip == 0) {
      stays = std::abs(c.tn) <= mu * c.tt || way == Slip::stays_stopped;
      pull = stays ? -c.tn / c.tt : c.tn > 0 ? -mu : mu;
    }
    const Real rate = c.nn + c.tn * pull;
    const Real drift = stays ? 0 : c.tt * pull + c.tn;
    Real by = std::numeric_limits<Real>::infinity();
    if (turned == 0) {
      if (rate > 0) by = -sink / rate;
    } else if (law == Law::newton) {
      by = (-e * c.sink - sink) / rate;
    } else if (law == Law::poisson) {
      by = (1 + e) * turned - n;
    } else {
      const Real left = std::max(owed - work, Real(0));
      by = (std::sqrt(sink * sink + 2 * rate * left) - sink) / rate;
    }
    const bool can_stop = way != Slip::never_stops && slip * drift < 0;
    const bool stops = can_stop && -slip / drift < by;
    if (stops) by = -slip / drift;
    if (!std::isfinite(by)) break;
    work += sink * by + rate * by * by / 2;
    t += pull * by;
    n += by;
    slip = stops ? 0 : slip + drift * by;
    sink += rate * by;
    if (stops) continue;
    if (turned != 0) break;
    turned = n;
    sink = 0;
    owed = -e * e * work;
    work = 0;
  }
  return {t, n};
}

Motion by_law(const Body& body, const Vector& point, Real e, Real mu, Law law,
              Slip way = Slip::coulomb) {
  const Contact c = contact_of(body, point);
  if (!(c.sink < 0)) return {body.velocity, body.angular_velocity};
  const auto [t, n] = impact(c, e, mu, law, way);
  return pushed(body, point, t, n);
}

void check(const Body& body, const Vector& point, double e, double friction) {
  const Contact c = contact_of(body, point);
  const bool sinks = c.sink < 0;
  const Motion right = by_law(body, point, e, friction, Law::stronge);
  // At most four segments of some ten roundings. A rounding has the magnitude of the velocities,
  // and grows by at most the ratio of the largest inverse effective mass to the smallest that
  // occurs, det/k_tt = (1/m)(1/m + |r|²/I)/k_tt, or k_nn reduced by Coulomb friction.
  const Real det = c.tt * c.nn - c.tn * c.tn;
  const Real pressed = std::abs(c.nn - friction * std::abs(c.tn));
  const Real least = std::min(det / c.tt, std::max(pressed, Real(0x1p-6)));
  const Real worst = (c.nn + c.tt) / least * (1 + friction);
  const double speed =
      body.velocity.norm() + std::abs(body.angular_velocity) * (1 + (point - body.centre).norm());
  const auto room =
      double(64 * 0x1p-53L * worst * worst * speed * (1 + 1 / Real((point - body.centre).norm())));
  ask("What is the motion of the body after the impact with the floor?")
      .given("body", body)
      .given("point", point)
      .given("e", e)
      .given("friction", friction)
      .suspect_if("separating-pushed",
                  [&](const Motion& got) {
                    // NaN differs from every velocity, and says nothing of an impulse.
                    return !sinks && std::isfinite(got.angular_velocity) &&
                           got.velocity.allFinite() && got.velocity != body.velocity;
                  })
      .suspect("newtons-restitution", [&] { return by_law(body, point, e, friction, Law::newton); })
      .suspect("poissons-restitution",
               [&] { return by_law(body, point, e, friction, Law::poisson); })
      .suspect("slip-never-stops",
               [&] { return by_law(body, point, e, friction, Law::stronge, Slip::never_stops); })
      .suspect("slip-stays-stopped",
               [&] { return by_law(body, point, e, friction, Law::stronge, Slip::stays_stopped); })
      .suspect("friction-after-the-normal",
               [&] {
                 if (!sinks) return right;
                 const Real n = -(1 + Real(e)) * c.sink / c.nn;
                 const Real most = friction * n;
                 const Real t = std::clamp(-(c.slip + c.tn * n) / c.tt, -most, most);
                 return pushed(body, point, t, n);
               })
      .suspect("coupling-left-out",
               [&] {
                 if (!sinks) return right;
                 Contact alone = c;
                 alone.tn = 0;
                 const auto [t, n] = impact(alone, e, friction, Law::stronge, Slip::coulomb);
                 return pushed(body, point, t, n);
               })
      .answer([&] { return exercise::after_floor(body, point, e, friction); })
      .close_to(right, within(room));
}

}  // namespace

TEST_CASE("without friction") {
  const Body rod{1, 0.25, {0, 1}, {2, -3}, 0};
  check(rod, {0, 0}, 1, 0);
  check(rod, {0, 0}, 0.5, 0);
  check(rod, {1, 0}, 0.5, 0);
  check(rod, {-1, 0}, 0, 0);
}

TEST_CASE("a point that does not move down is left alone") {
  check({1, 0.25, {0, 1}, {2, 3}, 0}, {0, 0}, 0.5, 0.5);
  check({1, 0.25, {-1, 1}, {0, -1}, 2}, {0, 0}, 0.5, 0.5);
  // The point moves along the floor, and would jam if an impact began.
  check({1, 0.25, {-0.5, 1}, {1, 0}, 0}, {0, 0}, 0.5, 1.5);
}

TEST_CASE("the slip stops and the end sticks") {
  check({1, 0.25, {0, 0.5}, {0.5, -2}, 0}, {0, 0}, 0.5, 1);
  check({1, 0.25, {-0.5, 1}, {1, -2}, 0}, {0, 0}, 0.5, 1.5);
  check({1, 0.25, {0.5, 0.5}, {0.25, -2}, 1}, {0, 0}, 1, 2);
}

TEST_CASE("the end slips during the whole impact") {
  check({1, 0.25, {0, 0.5}, {9, -1}, 0}, {0, 0}, 1, 0.25);
  check({1, 0.25, {-0.5, 0.5}, {9, -1}, 0}, {0, 0}, 0.5, 0.25);
  check({2, 1, {0.5, 0.5}, {-9, -2}, 1}, {0, 0}, 0.5, 0.125);
}

TEST_CASE("the slip stops and reverses") {
  // The lesson's rod, with s = 0.70710678118654757 for √½; and two others.
  const double s = 0.70710678118654757;
  check({1, 1.0 / 3, {-s, s}, {-0.6 + s, -1 + s}, -1}, {0, 0}, 1, 0.5);
  check({1, 1.0 / 3, {-s, s}, {-0.6 + s, -1 + s}, -1}, {0, 0}, 0.5, 0.5);
  check({1, 0.25, {0.5, 0.5}, {0.25, -2}, 0}, {0, 0}, 0.75, 0.25);
}

TEST_CASE("random rods") {
  generators::Random random(seed(0));
  for (int asked = 0; asked < 300; ++asked) {
    const double mass = random.uniform(0.5, 3);
    const double half = random.uniform(0.4, 1.5);
    const double x = random.uniform(-half, half);
    const double y = std::sqrt(half * half - x * x);
    const double vx = random.uniform(-2, 2);
    const double vy = random.uniform(-3, -0.1);
    const Body body{mass, mass * half * half / 3, {x, y}, {vx, vy}, random.uniform(-2, 2)};
    const Contact c = contact_of(body, {0, 0});
    const double friction = random.uniform(0, 1.5);
    // Whether the point moves down, and what follows where the slip stops, must be clear.
    if (std::abs(c.sink) < 0x1p-20 || std::abs(std::abs(c.tn) - friction * c.tt) < 0x1p-6 * c.tt) {
      continue;
    }
    check(body, {0, 0}, random.uniform(0.1, 1), friction);
  }
}
