// Signs, and which of two numbers is larger, are decided without rounding. Every test asks for a
// hit somewhere, so "nothing, always" earns nothing.
#include "ray_sphere.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>
#include <support/shrinkable.hpp>

#include <04_rays/exact_lines.hpp>

namespace {

using namespace contact::testing;
using exercise::Inside;
using Found = std::optional<Inside>;
using Ray = contact::Ray<double>;
using Sphere = contact::Sphere<double>;
using Vector = Eigen::Vector3d;

Found right(const Ray& ray, const Sphere& sphere) {
  using contact::Exact;
  const exact::Vector m = exact::exactly(ray.origin) - exact::exactly(sphere.centre);
  const exact::Vector d = exact::exactly(ray.direction);
  const Exact r = sphere.radius;
  const auto in = exact::at_most_zero(exact::dot(d, d), exact::dot(d, m), exact::dot(m, m) - r * r);
  if (!in || in->sign_of_exit < 0) return std::nullopt;
  return Inside{in->sign_of_entry < 0 ? 0 : in->entry, in->exit};
}

/// How far a good method may be off: its coordinates are as if they were off by a few thousand
/// units of the last place of the largest one, and what that does to the root is small where the
/// ray passes a quarter of a radius from touching, or exactly touches in round numbers.
Inside bound(const Ray& ray, const Sphere& sphere) {
  const double size = (ray.origin - sphere.centre).norm() + sphere.radius;
  const double off = 0x1p-40 * size / ray.direction.norm();
  return {off, off};
}

enum class Mistake {
  half_b_and_4ac,
  whole_b_and_ac,
  divided_by_two_times_a,
  direction_not_normalised,
  direction_normalised,
  entry_before_start,
  start_inside_missed,
  exit_for_entry,
  sign_of_zero,
  sign_of_minus_zero,
  hits_behind_origin,
  touching_rejected,
};
constexpr std::string_view kIds[] = {"half-b-mixed",           "half-b-mixed",
                                     "divided-by-two-times-a", "direction-not-normalised",
                                     "direction-normalised",   "entry-before-start",
                                     "start-inside-missed",    "exit-for-entry",
                                     "sign-of-zero",           "sign-of-zero",
                                     "hits-behind-origin",     "touching-rejected"};

/// The textbook's way with one mistake in it.
Found mistaken(const Ray& ray, const Sphere& sphere, Mistake mistake) {
  Vector d = ray.direction;
  if (mistake == Mistake::direction_normalised) d.normalize();
  const Vector m = ray.origin - sphere.centre;
  const double a = mistake == Mistake::direction_not_normalised ? 1 : d.dot(d);
  const double b = d.dot(m), c = m.dot(m) - sphere.radius * sphere.radius;
  double discriminant = b * b - a * c;
  if (mistake == Mistake::half_b_and_4ac) discriminant = b * b - 4 * a * c;
  if (mistake == Mistake::whole_b_and_ac) discriminant = 4 * b * b - a * c;
  if (discriminant < 0) return std::nullopt;
  const double root = std::sqrt(discriminant);
  double entry = (-b - root) / a, exit = (-b + root) / a;
  if (mistake == Mistake::whole_b_and_ac) {
    entry = (-2 * b - root) / (2 * a);
    exit = (-2 * b + root) / (2 * a);
  } else if (mistake == Mistake::divided_by_two_times_a) {
    entry = (-b - root) * a;
    exit = (-b + root) * a;
  } else if (b == 0 &&
             (mistake == Mistake::sign_of_zero || mistake == Mistake::sign_of_minus_zero)) {
    const double other = c / (mistake == Mistake::sign_of_zero ? 0.0 : -0.0);
    entry = std::min(0.0, other);
    exit = std::max(0.0, other);
  }
  if (mistake == Mistake::touching_rejected && (discriminant <= 0 || exit <= 0))
    return std::nullopt;
  if (exit < 0 && mistake != Mistake::hits_behind_origin) return std::nullopt;
  if (entry < 0 && mistake == Mistake::start_inside_missed) return std::nullopt;
  if (entry < 0 && mistake == Mistake::exit_for_entry) return Inside{exit, exit};
  if (mistake == Mistake::entry_before_start) return Inside{entry, exit};
  return Inside{std::max(entry, 0.0), exit};
}

/// Asks once. `mistakes` are those that this input tells from everything else.
void check_for(const Ray& ray, const Sphere& sphere, const std::vector<Mistake>& mistakes) {
  std::vector<Suspect<Found>> suspects;
  for (const Mistake mistake : mistakes) {
    suspects.push_back({kIds[static_cast<std::size_t>(mistake)],
                        [&ray, &sphere, mistake] { return mistaken(ray, sphere, mistake); }});
  }
  ask("Where is the ray in the ball?")
      .given("ray", ray)
      .given("sphere", sphere)
      .suspects(std::move(suspects))
      .answer([&] { return exercise::ray_sphere(ray, sphere); })
      .close_to(right(ray, sphere), within(bound(ray, sphere)));
}
void check(const Ray& ray, const Sphere& sphere) {
  check_for(ray, sphere,
            {Mistake::half_b_and_4ac, Mistake::whole_b_and_ac, Mistake::divided_by_two_times_a,
             Mistake::direction_not_normalised, Mistake::direction_normalised,
             Mistake::entry_before_start, Mistake::exit_for_entry, Mistake::sign_of_zero,
             Mistake::sign_of_minus_zero, Mistake::hits_behind_origin});
}

const Sphere kBall{{6, -2, 3}, 3};

}  // namespace

TEST_CASE("a ray passes through the ball or beside it") {
  // So near that each mistaken formula has a hit, and each another one.
  check({{2.875, -1.5, 3}, {1, 0, 0}}, kBall);
  check({{0, 0, 3}, {1, 0, 0}}, kBall);
  check({{6, -2, -5}, {0, 0, 1}}, kBall);
  check({{0, 2, 3}, {1, 0, 0}}, kBall);
  check({{7, 5, 4}, {0, -1, 0}}, kBall);
  check({{9, 1, -8}, {0, 0, 1}}, kBall);
}

TEST_CASE("t is in multiples of the direction as it is given") {
  check({{0, 0, 3}, {4, 0, 0}}, kBall);
  check({{6, -2, -5}, {0, 0, 0.25}}, kBall);
  check({{0, 0, 0}, {2, -1, 1}}, kBall);
  check({{0, 0, 0}, {0x1p-30, 0, 0x1p-31}}, kBall);
  check({{10, -20, 11}, {-0x1p30, 0x1.1p32, -0x1p31}}, kBall);
}

TEST_CASE("a ray that starts in the ball is in it from the start") {
  const auto check_inside = [](const Ray& ray) {
    check_for(ray, kBall,
              {Mistake::entry_before_start, Mistake::start_inside_missed, Mistake::exit_for_entry,
               Mistake::sign_of_zero, Mistake::sign_of_minus_zero});
  };
  check_inside({{5, -1, 3}, {2, 1, 0}});
  check_inside({{7, -3, 4}, {2, 1, 0}});
  // The start is the point of the line that is nearest to the centre.
  check_inside({{6, -2, 3}, {0, 2, 0}});
  check_inside({{6, -1, 3}, {2, 0, 1}});
  check_inside({{6, -2, 1}, {-1, 2, 0}});
}

TEST_CASE("a ball behind the start is missed") {
  check({{0, 0, 3}, {2, 0, 0}}, kBall);
  check({{0, 0, 3}, {-2, 0, 0}}, kBall);
  check({{10, -4, 4}, {2, -1, 1}}, kBall);
  check({{6, -2, 3.5}, {0, 0, 3}}, {{6, -2, 0}, 3});
}

TEST_CASE("a ray that touches is in the ball at one point") {
  const auto check_touching = [](const Ray& ray, const Sphere& sphere) {
    check_for(ray, sphere, {Mistake::touching_rejected});
  };
  check_touching({{0, 1, 3}, {2, 0, 0}}, kBall);
  check_touching({{9, -2, -5}, {0, 0, 1}}, kBall);
  check_touching({{6, -2, 14}, {0, 0, -4}}, {{6, -2, 3}, 0});
  // The start is on the sphere: the ray leads away from it, along it, and into it.
  check_touching({{9, -2, 3}, {2, 1, 0}}, kBall);
  check_touching({{9, -2, 3}, {0, 2, 0}}, kBall);
  check_touching({{9, -2, 3}, {-2, 1, 0}}, kBall);
  check_touching({{0, 1.5, 3}, {2, 0, 0}}, kBall);
}

TEST_CASE("a ball far away is hit or missed like a near one") {
  const auto check_at = [](double steps, const Vector& direction, const Vector& beside,
                           double radius) {
    const Sphere sphere{{1, 2, -1}, radius};
    const Ray ray{sphere.centre + beside - steps * direction, direction};
    const bool far = steps > 1e6;
    ask("Where is the ray in the ball?")
        .given("ray", ray)
        .given("sphere", sphere)
        // Here b² and a c agree in more digits than a double has.
        .suspect_if("discriminant-cancels", [far](const Found&) { return far; })
        .answer([&] { return exercise::ray_sphere(ray, sphere); })
        .close_to(right(ray, sphere), within(bound(ray, sphere)));
  };
  for (const double steps : {8.0, 0x1p27}) {
    check_at(steps, {3, -2, 6}, {2, 3, 0}, 5);
    check_at(steps, {3, -2, 6}, {2, 3, 0}, 2);
    check_at(steps, {-5, 3, 4}, {1, 3, -1}, 5);
    check_at(steps, {-5, 3, 4}, {1, 3, -1}, 2.5);
    check_at(steps, {1, 7, -2}, {0, 2, 7}, 10);
    check_at(steps, {1, 7, -2}, {0, 2, 7}, 5);
  }
}

TEST_CASE("an entry or exit just after the start has all its digits") {
  const auto check_digits = [](const Ray& ray, const Sphere& sphere) {
    const Found expected = right(ray, sphere);
    const Inside allowed{1e-9 * expected->entry, 1e-9 * expected->exit};
    // Both roots are smaller.
    const double large =
        2 * ((ray.origin - sphere.centre).norm() + sphere.radius) / ray.direction.norm();
    ask("Where is the ray in the ball?")
        .given("ray", ray)
        .given("sphere", sphere)
        .suspect_if("root-by-subtraction",
                    [=](const Found& got) {
                      if (!got) return false;
                      const double entry = std::abs(got->entry - expected->entry);
                      const double exit = std::abs(got->exit - expected->exit);
                      return std::max(entry, exit) < 1e-12 * large &&
                             !(entry <= allowed.entry && exit <= allowed.exit);
                    })
        .answer([&] { return exercise::ray_sphere(ray, sphere); })
        .close_to(expected, within(allowed));
  };
  check_digits({{10, 1, 0}, {-1, 0, 0}}, {{0, 0, 0}, 10});
  check_digits({{900'001, 1, 0}, {-1, 0, 0}}, {{1, 0, 0}, 900'000});
  check_digits({{5, -300'000, 7}, {0, 3, 0}}, {{6, 400'000, 7}, 700'000});
  check_digits({{3, 5, 1'000'000}, {0, 0, -7}}, {{2, 4, 0}, 1'000'000});
  // From inside, with radius² = 2 · 470,832² + 1.
  check_digits({{470'832, 470'832, 0}, {3, 3, 0}}, {{0, 0, 0}, 665'857});
  check_digits({{0, -470'830, 470'832}, {0, -0x1p-21, 0x1p-21}}, {{0, 2, 0}, 665'857});
}

TEST_CASE("random rays agree with exact arithmetic") {
  // Not near touching, where a good method may say the one or the other; and not so near the start
  // that an entry has only rounding in it.
  const auto beyond_doubt = [](const Ray& ray, const Sphere& sphere) {
    const Vector m = ray.origin - sphere.centre, d = ray.direction;
    if (!(d.norm() > 1e-3 && sphere.radius > 1e-3)) return false;
    const double beside = d.cross(m).norm() / d.norm();
    return std::abs(beside - sphere.radius) > 1e-2 * sphere.radius &&
           std::abs(m.norm() - sphere.radius) > 1e-2 * sphere.radius &&
           m.norm() < 100 * sphere.radius;
  };
  generators::Random random(seed(0));
  const auto vector = [&](double size) {
    return Vector{random.uniform(-size, size), random.uniform(-size, size),
                  random.uniform(-size, size)};
  };
  for (int asked = 0; asked < 500;) {
    const Sphere sphere{vector(8), random.uniform(0, 8)};
    const Vector origin = vector(12);
    const Vector aim = sphere.centre + 1.5 * sphere.radius * vector(1);
    const Vector direction = random.magnitude(-3, 3) * (aim - origin);
    const Ray ray{origin, direction};
    if (!beyond_doubt(ray, sphere)) continue;
    ++asked;
    shrinkable(check, beyond_doubt, ray, sphere);
  }
}
