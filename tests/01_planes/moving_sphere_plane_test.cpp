// Right answers come from exact arithmetic on the numbers as they are stored. Every test expects at
// least two different answers.
#include "moving_sphere_plane.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>

#include <contact/exact.hpp>

namespace {

using namespace contact::testing;
using contact::Exact;
using exercise::FirstTouch;
using Plane = contact::Plane<double>;
using Sphere = contact::Sphere<double>;
using Vector = Eigen::Vector3d;

Exact absolute(const Exact& x) { return x.sign() < 0 ? -x : x; }

std::optional<FirstTouch> exact_touch(const Sphere& sphere, const Vector& displacement,
                                      const Plane& plane) {
  using V = contact::Vector3<Exact>;
  const V n = plane.normal.cast<Exact>(), c = sphere.centre.cast<Exact>();
  const V move = displacement.cast<Exact>();
  const Exact distance = n.dot(c) - Exact(plane.offset);
  const Exact gap = absolute(distance) - Exact(sphere.radius);
  const Exact closing = n.dot(move) * Exact(-distance.sign());
  // The point below a centre c + (u/v) move, at a distance `height` (from the front) over v.
  const auto touch = [&](const Exact& u, const Exact& v, const Exact& height) {
    const auto coordinate = [&](int i) {
      return quotient<double>(c[i] * v + u * move[i] - height * n[i], v);
    };
    return FirstTouch{quotient<double>(u, v), {coordinate(0), coordinate(1), coordinate(2)}};
  };
  if (gap.sign() <= 0) return touch(Exact(0), Exact(1), distance);
  if ((gap - closing).sign() > 0) return std::nullopt;
  return touch(gap, closing, Exact(distance.sign()) * Exact(sphere.radius) * closing);
}

/// The gap is off by 4 u (Σ|nᵢ cᵢ| + |k| + r), so t by that over the closing distance and a few u;
/// the point by t's error along the displacement and a few u of its coordinates. A normal stored to
/// 2 u moves the contact point by 4 u r. 32 instead of 8.
std::optional<FirstTouch> bound(const Sphere& sphere, const Vector& displacement,
                                const Plane& plane) {
  const double closing = std::abs(plane.normal.dot(displacement));
  const double size = plane.normal.cwiseAbs().dot(sphere.centre.cwiseAbs()) +
                      std::abs(plane.offset) + sphere.radius;
  const double t = closing == 0 ? 0 : 32 * 0x1p-53 * (size / closing + 1);
  const double coordinate =
      t * displacement.norm() + 32 * 0x1p-53 * (size + sphere.centre.norm() + displacement.norm());
  return FirstTouch{t, Vector::Constant(coordinate)};
}

enum class Mistake {
  offset_to_one_side,
  overlap_at_start_missed,
  contact_point_is_centre,
  sphere_as_point,
  separating_touches,
  metres_for_fraction
};

std::optional<FirstTouch> mistaken(const Sphere& sphere, const Vector& displacement,
                                   const Plane& plane, Mistake mistake) {
  const double distance = plane.normal.dot(sphere.centre) - plane.offset;
  const double radius = mistake == Mistake::sphere_as_point ? 0 : sphere.radius;
  const double side = distance < 0 && mistake != Mistake::offset_to_one_side ? -1 : 1;
  const double gap = side * distance - radius;
  const double closing = -side * plane.normal.dot(displacement);
  if (gap <= 0 && mistake == Mistake::overlap_at_start_missed) return std::nullopt;
  if (gap <= 0 && mistake != Mistake::offset_to_one_side) {
    if (mistake == Mistake::contact_point_is_centre) return FirstTouch{0, sphere.centre};
    return FirstTouch{0, sphere.centre - distance * plane.normal};
  }
  double t = mistake == Mistake::separating_touches ? gap / std::abs(closing) : gap / closing;
  if (mistake == Mistake::metres_for_fraction) t *= displacement.norm();
  if (!(t >= 0 && t <= 1)) return std::nullopt;
  const Vector centre = sphere.centre + t * displacement;
  if (mistake == Mistake::contact_point_is_centre) return FirstTouch{t, centre};
  return FirstTouch{t, centre - side * radius * plane.normal};
}

void check(const Sphere& sphere, const Vector& displacement, const Plane& plane,
           std::vector<Mistake> mistakes = {}) {
  constexpr std::string_view kIds[] = {"offset-to-one-side",      "overlap-at-start-missed",
                                       "contact-point-is-centre", "sphere-as-point",
                                       "separating-touches",      "metres-for-fraction"};
  const double distance = plane.normal.dot(sphere.centre) - plane.offset;
  if (std::find(mistakes.begin(), mistakes.end(), Mistake::contact_point_is_centre) ==
      mistakes.end())
    mistakes.push_back(Mistake::contact_point_is_centre);
  std::vector<Suspect<std::optional<FirstTouch>>> suspects;
  for (const Mistake mistake : mistakes) {
    // A hint must be true of the student's case: "from behind" only for a sphere that comes from
    // there, and "the centre" only for an answer at which the centre reaches the plane.
    const bool misses = !mistaken(sphere, displacement, plane, mistake);
    const bool may_miss =
        mistake == Mistake::overlap_at_start_missed || mistake == Mistake::metres_for_fraction;
    if (misses && !may_miss) continue;
    if (mistake == Mistake::offset_to_one_side && distance >= 0) continue;
    suspects.push_back({kIds[static_cast<std::size_t>(mistake)],
                        [&, mistake] { return mistaken(sphere, displacement, plane, mistake); }});
  }
  ask("When and where does the moving sphere first touch the plane?")
      .given("sphere", sphere)
      .given("displacement", displacement)
      .given("plane", plane)
      .suspects(std::move(suspects))
      .answer([&] { return exercise::moving_sphere_plane(sphere, displacement, plane); })
      .close_to(exact_touch(sphere, displacement, plane),
                within(bound(sphere, displacement, plane)));
}

// The floor z = 1.
const Plane kFloor{{0, 0, 1}, 1};

}  // namespace

TEST_CASE("a falling sphere touches when its centre is at the distance of its radius") {
  // A step of one metre first: an answer that is right here and wrong next measures t in metres.
  check({{0, 0, 1.75}, 0.5}, {0, 0, -1}, kFloor, {Mistake::sphere_as_point});
  check({{0, 0, 9}, 2}, {0, 0, -8}, kFloor,
        {Mistake::sphere_as_point, Mistake::metres_for_fraction});
  check({{4, 1, 6}, 1}, {8, 0, -16}, kFloor, {Mistake::sphere_as_point});
  check({{4, 1, 6}, 1}, {8, 0, -4}, kFloor, {Mistake::sphere_as_point});  // touches at the end
}

TEST_CASE("the contact point is on the plane") {
  check({{0, 0, 9}, 2}, {0, 0, -8}, kFloor, {Mistake::contact_point_is_centre});
  check({{4, 1, 6}, 1}, {8, 0, -16}, kFloor, {Mistake::contact_point_is_centre});
  check({{4, 1, 6}, 3}, {-8, 4, -16}, {{0.6, 0, 0.8}, 1}, {Mistake::contact_point_is_centre});
}

TEST_CASE("a sphere can come from behind") {
  check({{0, 0, 9}, 2}, {0, 0, -8}, kFloor);
  check({{0, 0, -9}, 2}, {0, 0, 16}, kFloor, {Mistake::offset_to_one_side});
  check({{1, 2, -6}, 1}, {4, 0, 12}, kFloor, {Mistake::offset_to_one_side});
}

TEST_CASE("a sphere that meets the plane at the start touches at once") {
  check({{3, 4, 2}, 2}, {0, 0, -8}, kFloor, {Mistake::overlap_at_start_missed});
  check({{3, 4, 0.5}, 2}, {1, 0, 8}, kFloor, {Mistake::overlap_at_start_missed});
  check({{3, 4, 3}, 2}, {1, 0, 8}, kFloor, {Mistake::overlap_at_start_missed});
  check({{5, 4, 2}, 2}, {0, 0, 0}, kFloor, {Mistake::overlap_at_start_missed});
  check({{0, 0, 9}, 2}, {0, 0, -8}, kFloor);
}

TEST_CASE("a sphere that moves away, along or not far enough does not touch") {
  check({{0, 0, 9}, 2}, {0, 0, -8}, kFloor);
  check({{0, 0, 9}, 2}, {0, 0, 8}, kFloor, {Mistake::separating_touches});
  check({{0, 0, -9}, 2}, {0, 0, -16}, kFloor, {Mistake::separating_touches});
  check({{0, 0, 9}, 2}, {4, 2, 0}, kFloor);
  check({{0, 0, 9}, 2}, {0, 0, 0}, kFloor);
  check({{0, 0, 9}, 2}, {0, 0, -5}, kFloor);
}

TEST_CASE("random spheres agree with exact arithmetic") {
  generators::Random random(seed(0));
  const auto vector = [&](double size) {
    return Vector{random.uniform(-size, size), random.uniform(-size, size),
                  random.uniform(-size, size)};
  };
  for (int asked = 0; asked < 500;) {
    const Vector normal = vector(1), displacement = vector(16);
    if (normal.norm() < 0.1) continue;
    const Plane plane{normal.normalized(), random.uniform(-4, 4)};
    const Sphere sphere{vector(8), random.uniform(0.5, 2)};
    // Avoid ties, which rounded arithmetic may decide either way, and grazing motion.
    const double distance = plane.normal.dot(sphere.centre) - plane.offset;
    const double closing = std::abs(plane.normal.dot(displacement));
    const double gap = std::abs(distance) - sphere.radius;
    if (std::min({std::abs(distance), std::abs(gap), std::abs(gap - closing), closing}) < 1e-3) {
      continue;
    }
    ++asked;
    check(
        sphere, displacement, plane,
        {Mistake::offset_to_one_side, Mistake::overlap_at_start_missed,
         Mistake::contact_point_is_centre, Mistake::sphere_as_point, Mistake::separating_touches});
  }
}
