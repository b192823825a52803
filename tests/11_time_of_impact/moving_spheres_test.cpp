// Whether spheres touch is decided by exact numbers. The time is the stable form of the smaller
// root, with terms that are rounded once: its relative error is below 2⁻⁵⁰. The first questions of
// a test each bring one mistake to light that no question before did.
#include "moving_spheres.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>
#include <support/shrinkable.hpp>

#include <contact/exact.hpp>

#include <11_time_of_impact/spheres_with_mistakes.hpp>

namespace {

using namespace contact::testing;
using contact::Exact;
using exercise::Contact;
using exercise::MovingSphere;
using spheres_with_mistakes::Ways;
using Vector = Eigen::Vector3d;
using Touch = std::optional<Contact>;

// ---------------------------------------------------------------- what is right

struct Terms {
  Exact square, approach, gap, depth;
  Terms(const MovingSphere& a, const MovingSphere& b) {
    using V = contact::Vector3<Exact>;
    const V d = V(a.centre.cast<Exact>()) - V(b.centre.cast<Exact>());
    const V w = V(a.displacement.cast<Exact>()) - V(b.displacement.cast<Exact>());
    const Exact radius_sum = Exact(a.radius) + Exact(b.radius);
    square = w.dot(w);
    approach = -d.dot(w);
    gap = d.dot(d) - radius_sum * radius_sum;
    depth = approach * approach - square * gap;
  }
  bool at_start() const { return gap.sign() <= 0; }
  /// Whether they touch at some time from the start on, however late.
  bool ever() const {
    return at_start() || (approach.sign() > 0 && depth.sign() >= 0 && square.sign() > 0);
  }
  /// Whether the smaller root is at most 1: the polynomial is not positive at 1, or it is least
  /// before 1.
  bool in_time() const {
    const Exact at_end = square - approach - approach + gap;
    return at_start() || at_end.sign() <= 0 || (square - approach).sign() >= 0;
  }
};

double nearest(const Exact& x) { return rounded<double>(x); }

Touch right_contact(const MovingSphere& a, const MovingSphere& b) {
  const Terms terms(a, b);
  if (!terms.ever() || !terms.in_time()) return std::nullopt;
  double t = 0;
  if (!terms.at_start())
    t = nearest(terms.gap) / (nearest(terms.approach) + std::sqrt(nearest(terms.depth)));
  return spheres_with_mistakes::contact_at(a, b, std::min(t, 1.0), {});
}

/// What the contract grants: t to 2⁻⁴⁰; the point to what that does to it, and a few u of its
/// coordinates.
Touch bound(const MovingSphere& a, const MovingSphere& b, const Contact& right) {
  const double t = 0x1p-40 * right.t;
  const double moved = a.displacement.norm() + b.displacement.norm();
  const double size = a.centre.norm() + b.centre.norm() + moved;
  return Contact{t, Vector::Constant(t * moved + 64 * 0x1p-53 * size)};
}

// ---------------------------------------------------------------- questions

void check(const MovingSphere& a, const MovingSphere& b) {
  const Terms terms(a, b);
  const Touch right = right_contact(a, b);
  const bool later = right && !terms.at_start();
  const auto with = [&](const Ways& ways) {
    return [&, ways] { return spheres_with_mistakes::meet(a, b, ways); };
  };
  // A hint must be true of the answer in hand: these are asked only where it is.
  std::vector<Suspect<Touch>> suspects;
  const auto suspect = [&](std::string_view id, bool where, const Ways& ways, bool may_miss) {
    if (where && (may_miss || with(ways)())) suspects.push_back({id, with(ways)});
  };
  suspect("spheres-separate-then", later, {.later_root = true}, false);
  suspect("other-sphere-at-rest", b.displacement != Vector::Zero(), {.other_at_rest = true}, true);
  suspect("displacements-added", b.displacement != Vector::Zero(), {.added = true}, true);
  suspect("one-radius-alone", true, {.one_radius = true}, true);
  suspect("overlap-at-start-not-found", terms.at_start(), {.start_missed = true}, true);
  suspect("overlap-left-missed", terms.at_start() && terms.approach.sign() <= 0,
          {.leaving_missed = true}, true);
  suspect("contact-when-overlap-ends", terms.at_start(), {.exit_at_start = true}, false);
  suspect("graze-missed", later && terms.depth.sign() == 0, {.graze_missed = true}, true);
  suspect("root-by-a-difference", later, {.cancelled_root = true}, false);
  suspect("depth-by-a-difference", later, {.cancelled_depth = true}, true);
  suspect("closest-for-first", later, {.closest = true}, false);
  suspect("contact-in-the-past", !right, {.away = true}, false);
  suspect("contact-after-the-step", !right, {.too_late = true}, false);
  suspect("contact-at-the-end-missed", right && right->t == 1, {.end_missed = true}, true);
  suspect("middle-for-the-point", true, {.middle = true}, false);
  suspect("ratio-of-radii-reversed", true, {.other_ratio = true}, false);
  suspect("point-of-the-start", later, {.before = true}, false);
  suspect("one-centre-not-moved", later && b.displacement != Vector::Zero(), {.b_before = true},
          false);
  ask("When and where do the spheres first touch?")
      .given("a", a)
      .given("b", b)
      .suspects(std::move(suspects))
      .answer([&] { return exercise::spheres_meet(a, b); })
      .close_to(right, right ? within(bound(a, b, *right)) : within(0x1p-40));
}

/// Whether rounded arithmetic cannot change what is decided, nor the first digits of t.
bool is_clear(const MovingSphere& a, const MovingSphere& b) {
  for (const MovingSphere& one : {a, b}) {
    if (!(one.radius >= 0.1 && one.radius <= 10)) return false;
    if (!(one.centre.cwiseAbs().maxCoeff() <= 100)) return false;
    if (!(one.displacement.cwiseAbs().maxCoeff() <= 100)) return false;
  }
  const Vector d = a.centre - b.centre, w = a.displacement - b.displacement;
  const double radius_sum = a.radius + b.radius;
  const double square = w.squaredNorm(), approach = -d.dot(w);
  const double gap = d.squaredNorm() - radius_sum * radius_sum;
  const double depth = radius_sum * radius_sum * square - d.cross(w).squaredNorm();
  if (std::abs(gap) < 0.05 || square < 0.01 || std::abs(approach) < 1e-3) return false;
  if (std::abs(depth) < 0.01 * radius_sum * radius_sum * square) return false;
  const double t = gap / (approach + std::sqrt(std::max(depth, 0.0)));
  return std::abs(t - 1) >= 1e-3;
}

const MovingSphere kAtRest{{0, 0, 0}, {0, 0, 0}, 1};

}  // namespace

TEST_CASE("a sphere meets one at rest") {
  check({{-9, 0, 0}, {16, 0, 0}, 2}, kAtRest);
  check({{-6, 1, 0.5}, {16, 0, 0}, 2}, kAtRest);
  check({{-4, 1, -8}, {2, 0, 16}, 0.5}, kAtRest);
  check({{-6, 1, 7}, {8, 0, 0}, 2}, {{0, 1, 7}, {0, 0, 0}, 1});
  check({{-0.5, 0, 0}, {0.5, 0, 0}, 0.125}, {{0, 0, 0}, {0, 0, 0}, 0.25});
}

TEST_CASE("both spheres move") {
  check({{-6, 1, 0}, {16, 0, 0}, 2}, {{6, 0, 0}, {-4, 0, 0}, 1});
  check({{-6, 0, 0}, {8, 0, 0}, 2}, {{6, 0, 0}, {-8, 0, 0}, 1});
  check({{-6, 0, 0}, {8, 0, 0}, 2}, {{0, 0, 0}, {3, 0, 0}, 1});
  check({{-6, 1, 0}, {8, 2, 1}, 1.5}, {{3, -1, 2}, {-4, 3, -1}, 1});
  check({{0, 0, 0}, {0, 0, 0}, 2}, {{0, 9, 0}, {0, -12, 0}, 1});
}

TEST_CASE("paths that cross at different times do not collide") {
  check({{-6, 0, 0}, {8, 0, 0}, 2}, {{0, 0, 0}, {0, 0, 0}, 1});
  check({{-8, 0, 0}, {16, 0, 0}, 1}, {{0, -24, 0}, {0, 32, 0}, 1});
  check({{-8, 0, 0}, {16, 0, 0}, 1}, {{0, -8, 0}, {0, 16, 0}, 1});
}

TEST_CASE("spheres that touch or overlap at the start touch at 0") {
  check({{-2, 0, 0}, {8, 0, 0}, 2}, kAtRest);
  check({{-2, 0, 0}, {-4, 0, 0}, 2}, kAtRest);
  check({{-2, 2, 1}, {-4, 1, 0}, 2}, kAtRest);
  check({{-2, 2, 1}, {4, 1, 0}, 2}, kAtRest);
  check({{0.5, 0, 0}, {0, 0, 0}, 2}, kAtRest);
  check({{0, 0, 0}, {3, 0, 0}, 2}, kAtRest);
  check({{-6, 0, 0}, {8, 0, 0}, 2}, kAtRest);
}

TEST_CASE("spheres that move apart, alike or past each other do not touch") {
  check({{-6, 0, 0}, {8, 0, 0}, 2}, kAtRest);
  check({{-6, 0, 0}, {-8, 0, 0}, 2}, kAtRest);
  check({{-6, 0, 0}, {4, 1, 0}, 2}, {{0, 0, 0}, {4, 1, 0}, 1});
  check({{-6, 4, 0}, {16, 0, 0}, 2}, kAtRest);
  check({{-6, 0, 0}, {0, 5, 0}, 2}, kAtRest);
  check({{-6, 0, 0}, {2, 0, 0}, 2}, kAtRest);
  check({{-6, 0, 0}, {0, 0, 0}, 2}, kAtRest);
}

TEST_CASE("a graze and a contact at the end count") {
  check({{-6, 3, 0}, {8, 0, 0}, 2}, kAtRest);
  check({{-8, 0, -5}, {16, 0, 0}, 4}, kAtRest);
  check({{-6, 0, 0}, {3, 0, 0}, 2}, kAtRest);
  check({{-12, 4, 3}, {12, 0, 0}, 4}, kAtRest);
  check({{-6, 3.0625, 0}, {16, 0, 0}, 2}, kAtRest);
}

TEST_CASE("no digits are lost for spheres that nearly touch") {
  // The square of the distance and that of the radii have no rounding, so the contract's 2⁻⁴⁰ is
  // within reach.
  check({{-(1 + 0x1p-20), 0, 0}, {256, 0, 0}, 0.5}, {{0, 0, 0}, {0, 0, 0}, 0.5});
  check({{0, 1 + 0x1p-24, 0}, {64, -128, 0}, 0.25}, {{0, 0, 0}, {0, 0, 32}, 0.75});
  check({{0, 0, 1 + 0x1p-26}, {0, 0, 1}, 0.5}, {{0, 0, 0}, {0, 0, 3}, 0.5});
}

TEST_CASE("no digits are lost for small spheres far apart") {
  check({{-123456.7, 0, 0}, {234567.8, 0, 0}, 1e-4}, {{0, 0, 0}, {0, 0, 0}, 1e-4});
  check({{0, 654321.9, 0}, {0, 0, 0}, 3e-4}, {{0, 0, 0}, {0, 876543.2, 0}, 7e-4});
  check({{0, 0, 33333.3}, {0, 0, -77777.7}, 1e-5}, {{0, 0, 0}, {0, 0, 4444.4}, 5e-5});
  check({{0, 0, 33333.3}, {0, 0, -77777.7}, 1e-5}, {{0, 0.001, 0}, {0, 0, 4444.4}, 5e-5});
}

TEST_CASE("random spheres agree with exact arithmetic") {
  generators::Random random(seed(0));
  const auto vector = [&](double size) {
    return Vector{random.uniform(-size, size), random.uniform(-size, size),
                  random.uniform(-size, size)};
  };
  for (int asked = 0; asked < 400;) {
    const auto sphere = [&] {
      const Vector centre = vector(6), displacement = vector(12);
      return MovingSphere{centre, displacement, random.uniform(0.5, 3)};
    };
    const MovingSphere a = sphere(), b = sphere();
    if (!is_clear(a, b)) continue;
    ++asked;
    shrinkable(check, is_clear, a, b);
  }
}
