// Right answers come from exact arithmetic on the numbers as they are stored. The first questions
// of a test each bring one mistake to light that no question before did.
#include "offset_plane.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>
#include <support/shrinkable.hpp>

#include <contact/exact.hpp>

#include <11_time_of_impact/offset_with_mistakes.hpp>

namespace {

using namespace contact::testing;
using contact::Exact;
using exercise::Contact;
using offset_with_mistakes::Ways;
using Plane = contact::Plane<double>;
using Sphere = contact::Sphere<double>;
using Vector = Eigen::Vector3d;
using Touch = std::optional<Contact>;

// ---------------------------------------------------------------- what is right

Exact absolute(const Exact& x) { return x.sign() < 0 ? -x : x; }

Exact exact_distance(const Sphere& sphere, const Plane& plane) {
  using V = contact::Vector3<Exact>;
  return V(plane.normal.cast<Exact>()).dot(V(sphere.centre.cast<Exact>())) - Exact(plane.offset);
}

Touch right_contact(const Sphere& sphere, const Vector& displacement, const Plane& plane,
                    double rise) {
  using V = contact::Vector3<Exact>;
  const V n = plane.normal.cast<Exact>(), c = sphere.centre.cast<Exact>();
  const V move = displacement.cast<Exact>();
  const Exact distance = exact_distance(sphere, plane);
  const Exact gap = absolute(distance) - Exact(sphere.radius);
  const Exact closing = (n.dot(move) - Exact(rise)) * Exact(-distance.sign());
  // The point below a centre c + (u/v) move, at a distance `height` (from the front) over v.
  const auto contact_at = [&](const Exact& u, const Exact& v, const Exact& height) {
    const auto coordinate = [&](int i) {
      return quotient<double>(c[i] * v + u * move[i] - height * n[i], v);
    };
    return Contact{quotient<double>(u, v), {coordinate(0), coordinate(1), coordinate(2)}};
  };
  if (gap.sign() <= 0) return contact_at(Exact(0), Exact(1), distance);
  if ((gap - closing).sign() > 0) return std::nullopt;
  return contact_at(gap, closing, Exact(distance.sign()) * Exact(sphere.radius) * closing);
}

/// The gap is off by 4 u (Σ|nᵢ cᵢ| + |k| + r), the closing distance by 4 u (Σ|nᵢ dᵢ| + |rise|), so
/// t by those over the closing distance and a few u; the point by t's error along the displacement
/// and a few u of its coordinates. 64 instead of 8.
Touch bound(const Sphere& sphere, const Vector& displacement, const Plane& plane, double rise) {
  const double closing = std::abs(plane.normal.dot(displacement) - rise);
  const double size = plane.normal.cwiseAbs().dot(sphere.centre.cwiseAbs()) +
                      plane.normal.cwiseAbs().dot(displacement.cwiseAbs()) + std::abs(rise) +
                      std::abs(plane.offset) + sphere.radius;
  const double t = closing == 0 ? 0 : 64 * 0x1p-53 * (size / closing + 1);
  const double coordinate =
      t * displacement.norm() + 64 * 0x1p-53 * (size + sphere.centre.norm() + displacement.norm());
  return Contact{t, Vector::Constant(coordinate)};
}

// ---------------------------------------------------------------- questions

void check_offset(const Sphere& sphere, const Plane& plane) {
  const bool behind = exact_distance(sphere, plane).sign() < 0;
  const double r = sphere.radius;
  const auto moved = [&](double by) {
    return [&plane, by] { return Plane{plane.normal, plane.offset + by}; };
  };
  ask("On which plane is the centre when the sphere touches?")
      .given("plane", plane)
      .given("sphere", sphere)
      .suspect("plane-not-offset", moved(0))
      .suspect("offset-in-front", moved(r))
      .suspect("offset-away-from-the-sphere", moved(behind ? r : -r))
      .suspect("offset-by-the-diameter", moved(behind ? -2 * r : 2 * r))
      .suspect("normal-reversed-for-the-back",
               [&] {
                 if (!behind) return Plane{plane.normal, plane.offset + r};
                 return Plane{-plane.normal, -plane.offset + r};
               })
      .answer([&] { return exercise::offset_plane(plane, sphere); })
      .close_to({plane.normal, plane.offset + (behind ? -r : r)},
                within(Plane{{0, 0, 0}, 4 * 0x1p-53 * (std::abs(plane.offset) + r)}));
}

void check_contact(const Sphere& sphere, const Vector& displacement, const Plane& plane,
                   double rise) {
  const Exact distance = exact_distance(sphere, plane);
  const bool behind = distance.sign() < 0;
  const Touch right = right_contact(sphere, displacement, plane, rise);
  const bool at_start = right && right->t == 0;
  const auto with = [&](const Ways& ways) {
    return
        [&, ways] { return offset_with_mistakes::meets(sphere, displacement, plane, rise, ways); };
  };
  // A hint must be true of the answer in hand: these are asked only where it is.
  std::vector<Suspect<Touch>> suspects;
  const auto suspect = [&](std::string_view id, bool where, const Ways& ways, bool may_miss) {
    if (where && (may_miss || with(ways)())) suspects.push_back({id, with(ways)});
  };
  suspect("offset-to-one-side", behind && !at_start, {.one_side = true}, false);
  suspect("overlap-at-start-missed", at_start, {.start_missed = true}, true);
  const double closing = plane.normal.dot(displacement) - rise;
  suspect("overlap-left-missed", at_start && (behind ? closing <= 0 : closing >= 0),
          {.leaving_missed = true}, true);
  suspect("contact-point-is-centre", true, {.centre = true}, false);
  suspect("sphere-as-point", true, {.as_point = true}, false);
  suspect("separating-touches", !right, {.away = true}, false);
  suspect("product-of-distances-vanishes", right && !at_start, {.product = true}, true);
  suspect("plane-assumed-at-rest", rise != 0, {.at_rest = true}, true);
  suspect("rise-added", rise != 0, {.added = true}, true);
  suspect("contact-on-the-plane-at-the-start", right && rise != 0, {.old_plane = true}, false);
  suspect("contact-point-opposite", right && !at_start, {.opposite = true}, false);
  suspect("contact-point-opposite-behind", right && !at_start && behind, {.opposite_behind = true},
          false);
  suspect("contact-point-before-the-step", right && !at_start, {.before = true}, false);
  suspect("contact-at-the-end-missed", right && right->t == 1, {.end_missed = true}, true);
  suspect("contact-after-the-step", !right, {.too_late = true}, false);
  ask("When and where does the moving sphere first touch the moving plane?")
      .given("sphere", sphere)
      .given("displacement", displacement)
      .given("plane", plane)
      .given("rise", rise)
      .suspects(std::move(suspects))
      .answer([&] { return exercise::sphere_meets_plane(sphere, displacement, plane, rise); })
      .close_to(right, within(bound(sphere, displacement, plane, rise)));
}

bool are_small(const Sphere& sphere, const Vector& displacement, const Plane& plane, double rise) {
  return sphere.centre.cwiseAbs().maxCoeff() <= 100 && sphere.radius <= 100 &&
         displacement.cwiseAbs().maxCoeff() <= 100 && std::abs(plane.offset) <= 100 &&
         std::abs(rise) <= 100;
}

/// Whether it is beyond doubt on which side the centre is.
bool is_apart(const Sphere& sphere, const Plane& plane) {
  return are_small(sphere, {0, 0, 0}, plane, 0) && sphere.radius >= 0 &&
         std::abs(plane.normal.norm() - 1) <= 1e-15 &&
         std::abs(plane.normal.dot(sphere.centre) - plane.offset) >= 1e-3;
}

/// Whether rounded arithmetic cannot change what is decided.
bool is_clear(const Sphere& sphere, const Vector& displacement, const Plane& plane, double rise) {
  if (!(sphere.radius >= 0) || !are_small(sphere, displacement, plane, rise)) return false;
  if (std::abs(plane.normal.norm() - 1) > 1e-15) return false;
  const double distance = plane.normal.dot(sphere.centre) - plane.offset;
  const double closing = std::abs(plane.normal.dot(displacement) - rise);
  const double gap = std::abs(distance) - sphere.radius;
  return std::min({std::abs(distance), std::abs(gap), std::abs(gap - closing), closing}) >= 1e-3;
}

// The floor z = 1.
const Plane kFloor{{0, 0, 1}, 1};

}  // namespace

TEST_CASE("the offset plane is the radius away, on the side of the sphere") {
  check_offset({{0, 0, 9}, 2}, kFloor);
  check_offset({{5, -3, -9}, 2}, kFloor);
  check_offset({{5, -3, 2}, 3}, kFloor);
  check_offset({{5, -3, 0}, 3}, kFloor);
  check_offset({{5, -3, 1}, 0.5}, kFloor);
  check_offset({{0, 0, 4}, 0}, kFloor);
  check_offset({{2, 7, 4}, 1.5}, {{0.6, 0, 0.8}, -3});
  check_offset({{-4, 7, -4}, 1.5}, {{0.6, 0, 0.8}, -3});
}

TEST_CASE("a sphere falls onto a plane at rest") {
  check_contact({{0, 0, 9}, 2}, {0, 0, -8}, kFloor, 0);
  check_contact({{4, 1, 6}, 1}, {8, 0, -16}, kFloor, 0);
  check_contact({{4, 1, 6}, 3}, {-8, 4, -16}, {{0.6, 0, 0.8}, 1}, 0);
  check_contact({{4, 1, 6}, 0}, {8, 0, -16}, kFloor, 0);
  check_contact({{0, 0, 3e-190}, 1e-190}, {0, 0, -4e-190}, {{0, 0, 1}, 0}, 0);
}

TEST_CASE("a sphere comes from behind") {
  check_contact({{0, 0, -9}, 2}, {0, 0, 16}, kFloor, 0);
  check_contact({{1, 2, -6}, 1}, {4, 0, 12}, kFloor, 0);
  check_contact({{0, 0, -3e-190}, 1e-190}, {0, 0, 4e-190}, {{0, 0, 1}, 0}, 0);
}

TEST_CASE("the plane moves too") {
  check_contact({{0, 0, 9}, 2}, {0, 0, -8}, kFloor, 4);
  check_contact({{0, 0, 9}, 2}, {4, 2, 0}, kFloor, 8);
  check_contact({{1, 2, -6}, 1}, {4, 0, 12}, kFloor, 1);
  check_contact({{0, 0, -9}, 2}, {1, 0, 0}, kFloor, -16);
  check_contact({{0, 0, 9}, 2}, {0, 0, -8}, kFloor, -8);
  check_contact({{0, 0, 9}, 2}, {0, 0, 8}, kFloor, 24);
}

TEST_CASE("a sphere that touches at the start touches at 0") {
  check_contact({{3, 4, 0.5}, 2}, {1, 0, 8}, kFloor, 0);
  check_contact({{3, 4, 2}, 2}, {0, 0, -8}, kFloor, 2);
  check_contact({{3, 4, 3}, 2}, {1, 0, 8}, kFloor, 0);
  check_contact({{3, 4, -1}, 2}, {1, 0, -8}, kFloor, 0);
  check_contact({{5, 4, 2}, 2}, {0, 0, 0}, kFloor, 0);
  check_contact({{5, 4, 1}, 0}, {0, 0, 1}, kFloor, 1);
  check_contact({{0, 0, 9}, 2}, {0, 0, -8}, kFloor, 0);
}

TEST_CASE("a contact at the end of the step counts, and none after it") {
  check_contact({{0, 0, 9}, 2}, {0, 0, -6}, kFloor, 0);
  check_contact({{0, 0, 9}, 2}, {3, 0, -4}, kFloor, 2);
  check_contact({{0, 0, 9}, 2}, {0, 0, -5}, kFloor, 0);
  check_contact({{0, 0, -9}, 2}, {0, 0, 7}, kFloor, 0);
}

TEST_CASE("a sphere that moves away or along does not touch") {
  check_contact({{0, 0, 9}, 2}, {0, 0, 8}, kFloor, 0);
  check_contact({{0, 0, -9}, 2}, {0, 0, -16}, kFloor, 0);
  check_contact({{0, 0, 9}, 2}, {4, 2, 0}, kFloor, 0);
  check_contact({{0, 0, 9}, 2}, {0, 0, 0}, kFloor, 0);
  check_contact({{0, 0, 9}, 2}, {4, 2, 0}, kFloor, -8);
  check_contact({{0, 0, 9}, 2}, {1, 0, 3}, kFloor, 3);
  check_contact({{0, 0, 9}, 2}, {0, 0, -8}, kFloor, 0);
}

TEST_CASE("random spheres and planes agree with exact arithmetic") {
  generators::Random random(seed(0));
  const auto vector = [&](double size) {
    return Vector{random.uniform(-size, size), random.uniform(-size, size),
                  random.uniform(-size, size)};
  };
  for (int asked = 0; asked < 400;) {
    const Vector normal = vector(1), centre = vector(8), displacement = vector(16);
    if (normal.norm() < 0.1) continue;
    const Plane plane{normal.normalized(), random.uniform(-4, 4)};
    const Sphere sphere{centre, random.uniform(0.5, 2)};
    const double rise = random.uniform(-8, 8);
    if (!is_clear(sphere, displacement, plane, rise)) continue;
    ++asked;
    shrinkable(check_offset, is_apart, sphere, plane);
    shrinkable(check_contact, is_clear, sphere, displacement, plane, rise);
  }
}
