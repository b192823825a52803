// Extremes and distances are compared in integers, as multiples of 1/8, and whether a point is in a
// sphere is decided without rounding. The expected spheres are rounded by some 1e-12, as each step
// adds some ulps of 1000 and enlarges no earlier error. Every test asks for several answers. The
// first questions each bring one mistake to light that no question before did, so that the mistake
// is known by it.
#include "grow_sphere.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>
#include <support/shrinkable.hpp>

#include <07_bounding_volumes/contained.hpp>
#include <07_bounding_volumes/spheres_with_mistakes.hpp>

namespace {

using namespace contact::testing;
using namespace spheres_with_mistakes;
using exercise::ExtremePair;

constexpr double kTolerance = 1e-9;

ExtremePair in_exercise(const Pair& pair) { return {pair.low, pair.high}; }

void check_extremes(const Points& points) {
  const Pair right = most_distant_extremes(points);
  const auto is_longer = [&](const ExtremePair& got) {
    return square_distance(at(points, got.low), at(points, got.high)) >
           square_distance(at(points, right.low), at(points, right.high));
  };
  ask("Which two points are the most distant extremes?")
      .given("points", points)
      .suspect("extent-for-distance",
               [&] { return in_exercise(best_pair(points, extremes_along, extent_along)); })
      .suspect("extremes-of-one-axis", [&] { return in_exercise(extremes_along(0, points)); })
      .suspect("maximum-from-zero",
               [&] { return in_exercise(farthest_pair(points, extremes_from_zero)); })
      .suspect("low-excludes-high",
               [&] { return in_exercise(farthest_pair(points, extremes_by_else)); })
      .suspect("last-of-equal-extremes",
               [&] { return in_exercise(farthest_pair(points, last_extremes_along)); })
      .suspect("last-of-equal-extremes",
               [&] { return in_exercise(farthest_pair(points, extremes_along, true)); })
      .suspect_if("farthest-of-all-points",
                  [&](const ExtremePair& got) {
                    return is_farthest_of_all({got.low, got.high}, points) && is_longer(got);
                  })
      .answer([&] { return exercise::most_distant_extremes(points); })
      .equals(in_exercise(right));
}

void check_start(const Point& low, const Point& high) {
  const Sphere right = start_sphere(low, high);
  const double extent = (high - low).cwiseAbs().maxCoeff();
  ask("Which is the smallest sphere around the two points?")
      .given("low", low)
      .given("high", high)
      .suspect("diameter-for-radius",
               [&] {
                 return Sphere{right.centre, 2 * right.radius};
               })
      .suspect("difference-for-midpoint",
               [&] {
                 return Sphere{(high - low) / 2, right.radius};
               })
      .suspect("difference-for-midpoint",
               [&] {
                 return Sphere{(low - high) / 2, right.radius};
               })
      .suspect("extent-for-radius",
               [&] {
                 return Sphere{right.centre, extent / 2};
               })
      .answer([&] { return exercise::start_sphere(low, high); })
      .close_to(right, within(kTolerance));
}

void check_grown(const Sphere& sphere, const Point& point) {
  const Point to_point = point - sphere.centre;
  const double distance = to_point.norm(), radius = mean_radius(sphere, point);
  const bool outside = distance > sphere.radius;
  const Sphere right = grown_by(sphere, point);
  // Another sphere for a point outside.
  const auto instead = [&](const Point& centre, double other_radius) {
    return outside ? Sphere{centre, other_radius} : sphere;
  };
  const Point unit = to_point / distance;
  ask("Which is the smallest sphere around the sphere and the point?")
      .given("sphere", sphere)
      .given("point", point)
      .suspect("centre-stays", [&] { return instead(sphere.centre, distance); })
      .suspect("centre-moves-too-far",
               [&] { return instead(sphere.centre + (distance - sphere.radius) * unit, radius); })
      .suspect("centre-moves-away",
               [&] { return instead(sphere.centre - (radius - sphere.radius) * unit, radius); })
      .suspect("centre-to-the-middle",
               [&] { return instead(sphere.centre + to_point / 2, radius); })
      .suspect("centre-moves-with-the-new-radius",
               [&] { return instead(sphere.centre + (distance - radius) / 2 * unit, radius); })
      .suspect("radius-to-the-point", [&] { return instead(right.centre, distance); })
      .suspect("shrinks-to-a-point-inside", [&] { return grown(sphere, point); })
      .suspect("square-against-length",
               [&] { return distance * distance > sphere.radius ? grown(sphere, point) : sphere; })
      .suspect_if(
          "division-by-zero",
          [](const Sphere& got) { return !got.centre.allFinite() || !std::isfinite(got.radius); })
      .answer([&] { return exercise::grown_by(sphere, point); })
      .close_to(right, within(kTolerance));
}

bool is_close(const Sphere& a, const Sphere& b) {
  return (a.centre - b.centre).cwiseAbs().maxCoeff() <= kTolerance &&
         std::abs(a.radius - b.radius) <= kTolerance;
}

/// The centre is right, and the radius is up to 1.1 times as large, or up to 1 cm larger.
bool has_margin(const Sphere& got, const Sphere& right) {
  const double more = got.radius - right.radius;
  return is_close({got.centre, 0}, {right.centre, 0}) && more > kTolerance &&
         more <= std::max(right.radius / 10, 0.01);
}

void check_sphere(const Points& points) {
  const Sphere right = grow_sphere(points);
  ask("Which sphere grows from the points?")
      .given("points", points)
      .suspect("start-sphere-alone", [&] { return start_of(points); })
      .suspect("only-the-farthest-point", [&] { return grown_once(points); })
      .suspect("start-at-first-point",
               [&] {
                 Sphere sphere{points[0], 0};
                 for (const Point& p : points) sphere = grown_by(sphere, p);
                 return sphere;
               })
      .suspect("mean-for-centre", [&] { return around_mean(points); })
      .suspect("box-centre-for-centre", [&] { return around_box_centre(points); })
      .suspect("last-point-forgotten",
               [&] {
                 Sphere sphere = start_of(points);
                 for (std::size_t i = 0; i + 1 < points.size(); ++i)
                   sphere = grown_by(sphere, points[i]);
                 return sphere;
               })
      .suspect_if("margin-too-large", [&](const Sphere& got) { return has_margin(got, right); })
      .suspect_if(
          "division-by-zero",
          [](const Sphere& got) { return !got.centre.allFinite() || !std::isfinite(got.radius); })
      .answer([&] { return exercise::grow_sphere(points); })
      .close_to(right, within(kTolerance));
}

void check_contains(const Points& points) {
  const Sphere right = grow_sphere(points);
  const auto contains = [&](const Sphere& got) {
    return contained::in_ball(got.centre, got.radius, points) && is_close(got, right);
  };
  ask("Which sphere that grows from the points contains each of them, without rounding?")
      .given("points", points)
      .suspect_if("points-missed-by-rounding",
                  [&](const Sphere& got) { return is_close(got, right); })
      .answer([&] { return exercise::grow_sphere(points); })
      .satisfies(
          "contains each point: |p - c| <= r for the numbers as you return them, where they may be "
          "1e-9 from those of the recipe",
          contains);
}

const Points kSeven{{3, 1, 0},  {-2, 5, 1},  {0, -3, 2}, {4, 2, -5},
                    {-1, 0, 6}, {2, -4, -3}, {5, 4.5, 5}};

}  // namespace

TEST_CASE("the extreme pair with the largest distance counts") {
  // The farthest pair of all is not extreme along any axis.
  check_extremes({{-6, 0, 0},
                  {0, -5.5, 0},
                  {0, 0, -5.75},
                  {6, 0, 0},
                  {0, 5.5, 0},
                  {0, 0, 5.75},
                  {5, 5, 5},
                  {-5, -5, -5}});
  check_extremes({{-3, 0, 0}, {3, 0, 0}, {-2, -2, -9}, {2, 2, 9}});
  check_extremes({{0, 0, 0}, {4, 0, 0}, {1, 3, 8}, {2, 1, -6}});
  // The extent is largest along x, the distance of the extremes along y.
  check_extremes({{-5, 0, 0}, {5, 0, 0}, {-4, -4.5, -4}, {4, 4.5, 4}});
  check_extremes({{0, 0, -1}, {0, 9, 0}, {0, 0, 7}, {0, -1, 0.5}});
  check_extremes(kSeven);
}

TEST_CASE("coordinates may all be negative, and the first point may be extreme") {
  check_extremes({{-9, -1, -1}, {-1, -2, -1}, {-5, -3, -2}, {-2, -4, -3}});
  check_extremes({{9, 1, 4}, {2, 2, 3}, {1, 1, 2}, {5, 3, 3}});
  check_extremes({{9, 1, 4}, {2, 2, 3}, {5, 3, 3}});
  check_extremes({{-3, -9, -2}, {-2, -8, -4}, {-4, -8.5, -900}});
}

TEST_CASE("of equal extremes and equal pairs the first counts") {
  check_extremes({{-5, 1, 0}, {5, 0, 0}, {5, 1, 0}, {-5, 0, 0}});
  check_extremes({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}});
  check_extremes({{2, 3, 4}});
  check_extremes({{2, 3, 4}, {2, 3, 4}, {2, 3, 4}});
  check_extremes({{0, 0, 1}, {0, 3, 1}, {0, 0, 1}, {0, 3, 1}});
  check_extremes({{0, 3, 0}, {0, 0, 0}, {0, 0, 3}, {0, 3, 3}});
}

TEST_CASE("the start sphere has the two points as ends of a diameter") {
  check_start({1, 2, 3}, {4, 6, 3});
  check_start({-2, 0, 5}, {4, 1, -1});
  check_start({10.5, -7, 2}, {10.5, -7, 2});
  check_start({-kLimit, -kLimit, -kLimit}, {kLimit, kLimit, kLimit});
  check_start({0, 0, 0}, {0, 0, 0.125});
}

TEST_CASE("a sphere grows until it touches a point outside") {
  check_grown({{1, 2, 3}, 2}, {1, 2, 13});
  check_grown({{1, 2, 3}, 5}, {4, 14, 3});
  check_grown({{0, 0, 0}, 0}, {3, -4, 12});
  check_grown({{-5, 1, 0}, 0.125}, {7, 1, -3});
  check_grown({{-900, 800, 700}, 1000}, {990, -1000, -1000});
}

TEST_CASE("only a point outside changes the sphere") {
  check_grown({{1, 2, 3}, 9}, {1, 2, 23});
  check_grown({{1, 2, 3}, 9}, {1, 2, 5});
  check_grown({{1, 2, 3}, 9}, {1, 7, 3});
  check_grown({{1, 2, 3}, 9}, {4, 6, 3});
  check_grown({{1, 2, 3}, 5}, {4, 6, 3});
  check_grown({{1, 2, 3}, 5}, {1, 2, 3});
  check_grown({{1, 2, 3}, 0}, {1, 2, 3});
  check_grown({{1, 2, 3}, 0.5}, {1, 2, 3.25});
}

TEST_CASE("every point in order makes the sphere grow") {
  check_sphere({{-9, 0, 0}, {9, 0, 0}, {0, 8, 5}, {0, -8, 5}, {1, 2, -9.5}, {0, 0, 1}});
  check_sphere(kSeven);
  check_sphere({{-6, 0, 0}, {6, 0, 0}, {0, 5, 4}, {0, 5.5, -3}, {1, -5, 5}, {0, 2, 5.875}});
  check_sphere({{-6, 0, 0}, {6, 0, 0}, {0, 5, 4}, {0, -5, -4}});
  check_sphere({{0, 5, 4}, {6, 0, 0}, {0, -5, -4}, {-6, 0, 0}});
  check_sphere({{-6, 0, 0}, {6, 0, 0}, {5, 5, 5}});
  Points reversed = kSeven;
  std::reverse(reversed.begin(), reversed.end());
  check_sphere(reversed);
}

TEST_CASE("one point, equal points and points on a line have a sphere") {
  check_sphere({{2, 3, 4}});
  check_sphere({{-7, 0.5, 4}, {-7, 0.5, 4}, {-7, 0.5, 4}});
  check_sphere({{1, 1, 1}, {2, 2, 2}, {9, 9, 9}, {4, 4, 4}});
  check_sphere({{0, 0, 5}, {3, 0, 5}, {0, 4, 5}, {3, 4, 5}});
  for (const Points& points : std::vector<Points>{{{2, 3, 4}}, {{0, 0, 0}, {0, 0, 0}}})
    check_contains(points);
}

TEST_CASE("the sphere contains every point without rounding") {
  check_contains({{0, 0, 0}, {1, 0, 0}});
  check_contains({{0, 0, 0}, {1, 1, 1}});
  check_contains({{0, 0, 0}, {1, 2, 3}, {7, 3, 1}});
  check_contains({{-6, 0, 0}, {6, 0, 0}, {5, 5, 5}});
  check_contains({{0, 5, 4}, {6, 0, 0}, {0, -5, -4}, {-6, 0, 0}});
  check_contains({{-1000, 3, 999}, {998, -997, -1000}, {5, 1000, 17}, {-20, -1000, 31}});
  check_contains(kSeven);
}

TEST_CASE("random points agree with integers and the recipe") {
  generators::Random random(seed(0));
  const auto judged = [](const Points& points) {
    return !points.empty() && contained::is_on_grid(points, kParts, kLimit);
  };
  const auto judged_step = [](const Sphere& sphere, const Point& point) {
    return contained::is_on_grid(Points{sphere.centre, point}, kParts, kLimit) &&
           contained::is_on_grid(Points{{sphere.radius, 0, 0}}, kParts, kLimit) &&
           sphere.radius >= 0;
  };
  for (int asked = 0; asked < 400; ++asked) {
    const int size = std::array{2, 40, 8000}[static_cast<std::size_t>(asked % 3)];
    const auto point = [&] {
      const double x = random.integer(-size, size);
      const double y = random.integer(-size, size);
      const double z = random.integer(-size, size);
      return Point(x / kParts, y / kParts, z / kParts);
    };
    const int kind = random.integer(0, 4);
    const Point step = Point(1, -2, 1) / kParts;
    const int count = random.integer(1, 12);
    Points points;
    while (static_cast<int>(points.size()) < count) {
      if (kind == 0)
        points.push_back(random.integer(-size, size) / 2 * step);
      else if (kind == 1 && !points.empty() && random.chance(0.5))
        points.push_back(points.front());
      else
        points.push_back(point());
    }
    shrinkable(check_extremes, judged, points);
    shrinkable(check_sphere, judged, points);
    shrinkable(check_contains, judged, points);
    const Sphere sphere{point(), random.integer(0, size) / kParts};
    const Point other = point();
    shrinkable(check_grown, judged_step, sphere, other);
    shrinkable(
        check_start,
        [](const Point& a, const Point& b) {
          return contained::is_on_grid(Points{a, b}, kParts, kLimit);
        },
        points.front(), other);
  }
}
