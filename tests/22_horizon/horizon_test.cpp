// Named tests use a path that can be computed by hand. Random ones run a billiard with dual numbers
// (automatic differentiation with respect to the start): the derivative is the distance of two
// paths to first order, computed without angles and curvatures. Every test asks for at least two
// different answers, so that no constant passes it.
#include "horizon.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>

namespace {

using namespace contact::testing;
using exercise::Hit;
using Hits = std::vector<Hit>;
constexpr double infinite = std::numeric_limits<double>::infinity();

/// Its mistakes.
enum class Way { one_lens, head_on, added_up, once, at_the_hit, parallel, from_the_last_hit };

double predicted(const Hits& hits, double speed, double error, double tolerance, Way way) {
  double apart = error;
  double angle = 0;
  double time = 0;
  for (const Hit& hit : hits) {
    const double next = apart + angle * hit.flight;
    if (next >= tolerance && way == Way::at_the_hit) return time + hit.flight / speed;
    if (next >= tolerance) break;
    apart = next;
    time += hit.flight / speed;
    const double turned = (way == Way::once ? 1 : 2) * (way == Way::added_up ? error : apart) /
                          (hit.radius * (way == Way::head_on ? 1 : hit.cosine));
    const bool kept = way == Way::one_lens || (way == Way::parallel && std::isinf(hit.radius));
    angle = turned + (kept ? 0 : angle);
  }
  if (way == Way::from_the_last_hit) time = 0;
  return angle > 0 ? time + (tolerance - apart) / angle / speed : infinite;
}

void check(const Hits& hits, double speed, double error, double tolerance, double right) {
  const auto like = [&](Way way) {
    return [&hits, speed, error, tolerance, way] {
      return predicted(hits, speed, error, tolerance, way);
    };
  };
  ask("Until when is the prediction good?")
      .given("hits", hits)
      .given("speed", speed)
      .given("error", error)
      .given("tolerance", tolerance)
      .suspect("cosine-left-out", like(Way::head_on))
      .suspect("normal-turned-once", like(Way::once))
      .suspect("wall-makes-parallel", like(Way::parallel))
      .suspect("angle-of-one-hit-alone", like(Way::one_lens))
      .suspect("errors-added-up", like(Way::added_up))
      .suspect("horizon-at-a-hit", like(Way::at_the_hit))
      .suspect("counted-from-the-last-hit", like(Way::from_the_last_hit))
      .suspect_if("horizon-before-a-hit",
                  [&](const double& got) {
                    return got <= hits[0].flight / speed * (1 + 1e-9) &&
                           std::abs(got - like(Way::from_the_last_hit)()) > 1e-9 * right;
                  })
      .suspect_if("pillar-as-flat",
                  [&](const double& got) {
                    // An angle that a flat wall undoes, or one of a flat wall alone, is forgotten.
                    return std::isinf(got) && std::isfinite(right) &&
                           std::isfinite(like(Way::parallel)()) &&
                           std::isfinite(like(Way::one_lens)());
                  })
      .answer([&] { return exercise::horizon(hits, speed, error, tolerance); })
      // Some ten roundings a hit, eight hits, and at each the error of a position becomes an error
      // of the angle 2/(r cosine) times as large, up to 50: below 1e-12 of the whole.
      .close_to(right, std::isinf(right) ? within(0.0) : within(1e-10 * right));
}

/// A number and its derivative with respect to the start, perpendicular to the path.
struct Dual {
  double value;
  double slope;
};

Dual operator+(Dual a, Dual b) { return {a.value + b.value, a.slope + b.slope}; }
Dual operator-(Dual a, Dual b) { return {a.value - b.value, a.slope - b.slope}; }
Dual operator*(Dual a, Dual b) {
  return {a.value * b.value, a.slope * b.value + a.value * b.slope};
}
Dual operator/(Dual a, Dual b) {
  const double quotient = a.value / b.value;
  return {quotient, (a.slope - quotient * b.slope) / b.value};
}
Dual root(Dual a) { return {std::sqrt(a.value), a.slope / (2 * std::sqrt(a.value))}; }

/// A vector of them in the plane.
struct DualVector {
  Dual x, y;
};

DualVector operator+(DualVector a, DualVector b) { return {a.x + b.x, a.y + b.y}; }
DualVector operator-(DualVector a, DualVector b) { return {a.x - b.x, a.y - b.y}; }
DualVector operator*(Dual s, DualVector a) { return {s * a.x, s * a.y}; }
Dual dot(DualVector a, DualVector b) { return a.x * b.x + a.y * b.y; }
DualVector still(double x, double y) { return {{x, 0}, {y, 0}}; }

struct Pillar {
  double x, y, radius;
};

/// A point that flies with speed 1 in a square room with pillars, and its path so far.
class Billiard {
 public:
  Billiard(std::vector<Pillar> pillars, double side, DualVector place, DualVector velocity)
      : pillars_(std::move(pillars)), side_(side), place_(place), velocity_(velocity) {}

  /// How far apart the two paths are after a flight of that length, to first order.
  double beside(double length) const {
    const double dx = place_.x.slope + velocity_.x.slope * length;
    const double dy = place_.y.slope + velocity_.y.slope * length;
    return std::abs(velocity_.x.value * dy - velocity_.y.value * dx);
  }

  /// To the next hit, and away from it.
  Hit next() {
    Dual flight{infinite, 0};
    DualVector normal = still(0, 0);
    double radius = infinite;
    const auto wall = [&](Dual gap, Dual rate, DualVector inwards) {
      if (!(rate.value < 0)) return;
      const double time = gap.value / -rate.value;
      if (!(time > 0) || time >= flight.value) return;
      flight = {time, (gap.slope + time * rate.slope) / -rate.value};
      normal = inwards;
      radius = infinite;
    };
    const Dual side{side_, 0};
    wall(place_.x, velocity_.x, still(1, 0));
    wall(side - place_.x, still(0, 0).x - velocity_.x, still(-1, 0));
    wall(place_.y, velocity_.y, still(0, 1));
    wall(side - place_.y, still(0, 0).y - velocity_.y, still(0, -1));
    for (const Pillar& pillar : pillars_) {
      const DualVector off = place_ - still(pillar.x, pillar.y);
      const Dual along = dot(off, velocity_);
      const Dual squared = along * along - dot(off, off) + Dual{pillar.radius * pillar.radius, 0};
      if (!(along.value < 0) || !(squared.value > 0)) continue;
      const Dual time = still(0, 0).x - along - root(squared);
      if (!(time.value > 1e-9) || time.value >= flight.value) continue;
      flight = time;
      const DualVector out = off + time * velocity_;
      // Divided by its own length and not by the radius: otherwise a position that rounding has
      // moved off the pillar changes the speed, which moves it farther off at the next hit.
      normal = {out.x / root(dot(out, out)), out.y / root(dot(out, out))};
      radius = pillar.radius;
    }
    place_ = place_ + flight * velocity_;
    const Dual into = dot(normal, velocity_);
    velocity_ = velocity_ - Dual{2, 0} * into * normal;
    return {flight.value, radius, -into.value};
  }

 private:
  std::vector<Pillar> pillars_;
  double side_;
  DualVector place_;
  DualVector velocity_;
};

constexpr double ulp = 0x1p-52;

}  // namespace

TEST_CASE("one pillar, head on") {
  // After the hit the paths diverge by 2 ulp / 2 m for each metre.
  check({{3, 2, 1}}, 1, ulp, 5 * ulp, 3 + 4);
  check({{3, 2, 1}}, 2, ulp, 9 * ulp, (3 + 8) / 2.0);
  check({{3, 0.5, 1}}, 1, ulp, 5 * ulp, 3 + 1);
}

TEST_CASE("an oblique hit") {
  check({{3, 2, 0.5}}, 1, ulp, 5 * ulp, 3 + 2);
  check({{1, 1, 0.25}}, 4, ulp, 17 * ulp, (1 + 2) / 4.0);
}

TEST_CASE("from pillar to pillar") {
  // Two ulp apart at the second, at an angle of 1 ulp/m; that adds 1.
  const Hits two{{3, 2, 1}, {1, 4, 1}};
  check(two, 1, ulp, 8 * ulp, 3 + 1 + 3);
  check(two, 1, ulp, 1.75 * ulp, 3 + 0.75);
  // Then four apart, at an angle of 2 + 4.
  const Hits three{{3, 2, 1}, {1, 4, 1}, {1, 2, 1}};
  check(three, 1, ulp, 10 * ulp, 3 + 1 + 1 + 1);
  check(three, 1, ulp, 3 * ulp, 3 + 1 + 0.5);
}

TEST_CASE("flat walls") {
  check({{3, infinite, 1}, {2, infinite, 0.5}}, 1, ulp, 8 * ulp, infinite);
  check({{3, 2, 1}, {1, infinite, 1}}, 1, ulp, 5 * ulp, 3 + 4);
  check({{1, infinite, 0.5}, {3, 2, 1}, {1, infinite, 0.5}, {1, 3, 1}}, 1, ulp, 7 * ulp,
        1 + 3 + 1 + 1 + (7 - 3) / (1 + 2.0));
}

TEST_CASE("random billiards agree with their derivative") {
  generators::Random random(seed(0));
  int asked = 0;
  while (asked < 200) {
    std::vector<Pillar> pillars;
    for (int i = 0; i < 9; ++i) {
      const double radius = random.uniform(0.2, 0.6);
      const double x = 1.5 + 2 * (i % 3) + random.uniform(-0.3, 0.3);
      const double y = 1.5 + 2 * (i / 3) + random.uniform(-0.3, 0.3);
      pillars.push_back({x, y, radius});
    }
    // From a corner, where no pillar is, to where some are.
    const double slope = random.uniform(0.2, 5);
    const double length = std::sqrt(1 + slope * slope);
    const double x = 1 / length;
    const double y = slope / length;
    // The other point starts beside it, at a distance of 1 times the error.
    const DualVector place{{random.uniform(0.1, 0.4), -y}, {0.25, x}};
    Billiard point(pillars, 7, place, still(x, y));
    const int last = random.integer(0, 6);
    const double share = random.uniform(0.05, 0.95);
    const double speed = random.uniform(0.5, 4);
    const double error = random.uniform(1, 4) * ulp;
    Hits hits;
    double before = 0;  // length of the path
    double right = infinite;
    double tolerance = 0;
    bool grazes = false;
    const bool open = random.chance(0.3);  // the horizon is after the last hit
    for (int i = 0; i < 8; ++i) {
      const Billiard here = point;
      const Hit hit = point.next();
      grazes = grazes || hit.cosine < 0.2;
      // The horizon is put into this flight, if the paths diverge in it.
      if (i >= last && std::isinf(right) && here.beside(hit.flight) > 1.01 * here.beside(0)) {
        right = (before + share * hit.flight) / speed;
        tolerance = error * here.beside(share * hit.flight);
      }
      if (open && std::isfinite(right)) break;
      before += hit.flight;
      hits.push_back(hit);
    }
    if (grazes || std::isinf(right)) continue;
    ++asked;
    check(hits, speed, error, tolerance, right);
  }
}
