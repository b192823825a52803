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

namespace {

using namespace contact::testing;
using exercise::ExtremePair;
using Point = Eigen::Vector3d;
using Points = std::vector<Point>;
using Sphere = contact::Sphere<double>;

constexpr double kTolerance = 1e-9;
constexpr double kParts = 8;
constexpr double kLimit = 1000;

const Point& at(const Points& points, int i) { return points[static_cast<std::size_t>(i)]; }

std::int64_t eighths(double x) { return static_cast<std::int64_t>(x * kParts); }

/// In units of 1/64 m².
std::int64_t square_distance(const Point& a, const Point& b) {
  std::int64_t sum = 0;
  for (int k = 0; k < 3; ++k)
    sum += (eighths(a[k]) - eighths(b[k])) * (eighths(a[k]) - eighths(b[k]));
  return sum;
}

// ---------------------------------------------------------------- the most distant extremes

ExtremePair extremes_along(int axis, const Points& points) {
  const auto less = [axis](const Point& a, const Point& b) { return a[axis] < b[axis]; };
  const auto low = std::min_element(points.begin(), points.end(), less);
  const auto high = std::max_element(points.begin(), points.end(), less);
  return {static_cast<int>(low - points.begin()), static_cast<int>(high - points.begin())};
}

/// The same with the last one of equal points.
ExtremePair last_extremes_along(int axis, const Points& points) {
  const Points reversed(points.rbegin(), points.rend());
  const ExtremePair pair = extremes_along(axis, reversed);
  const int last = static_cast<int>(points.size()) - 1;
  return {last - pair.low, last - pair.high};
}

/// Each point is compared with the largest coordinate only if it is not below the smallest one.
ExtremePair extremes_by_else(int axis, const Points& points) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  ExtremePair pair{0, 0};
  for (int i = 0; i < static_cast<int>(points.size()); ++i) {
    const double x = at(points, i)[axis];
    if (x < low) {
      low = x;
      pair.low = i;
    } else if (x > high) {
      high = x;
      pair.high = i;
    }
  }
  return pair;
}

/// The largest coordinate is searched for from 0.
ExtremePair extremes_from_zero(int axis, const Points& points) {
  ExtremePair pair{extremes_along(axis, points).low, 0};
  double high = 0;
  for (int i = 0; i < static_cast<int>(points.size()); ++i) {
    if (at(points, i)[axis] <= high) continue;
    high = at(points, i)[axis];
    pair.high = i;
  }
  return pair;
}

double extent_along(int axis, const ExtremePair& pair, const Points& points) {
  return at(points, pair.high)[axis] - at(points, pair.low)[axis];
}
std::int64_t square_distance(int /*axis*/, const ExtremePair& pair, const Points& points) {
  return square_distance(at(points, pair.low), at(points, pair.high));
}

/// The first of the three pairs with the largest measure, or the last one.
template <class Search, class Measure>
ExtremePair best_pair(const Points& points, const Search& search, const Measure& measure,
                      bool last = false) {
  ExtremePair best = search(0, points);
  auto largest = measure(0, best, points);
  for (int axis = 1; axis < 3; ++axis) {
    const ExtremePair pair = search(axis, points);
    const auto size = measure(axis, pair, points);
    if (size < largest || (size == largest && !last)) continue;
    best = pair;
    largest = size;
  }
  return best;
}

template <class Search>
ExtremePair farthest_pair(const Points& points, const Search& search, bool last = false) {
  const auto measure = [](int axis, const ExtremePair& pair, const Points& of) {
    return square_distance(axis, pair, of);
  };
  return best_pair(points, search, measure, last);
}

ExtremePair most_distant_extremes(const Points& points) {
  return farthest_pair(points, extremes_along);
}

/// Whether no two of the points are farther from each other.
bool is_farthest_of_all(const ExtremePair& pair, const Points& points) {
  const int count = static_cast<int>(points.size());
  if (std::min(pair.low, pair.high) < 0 || std::max(pair.low, pair.high) >= count) return false;
  const std::int64_t distance = square_distance(at(points, pair.low), at(points, pair.high));
  return std::all_of(points.begin(), points.end(), [&](const Point& a) {
    return std::all_of(points.begin(), points.end(),
                       [&](const Point& b) { return square_distance(a, b) <= distance; });
  });
}

void check_extremes(const Points& points) {
  const ExtremePair right = most_distant_extremes(points);
  const auto is_longer = [&](const ExtremePair& got) {
    return square_distance(at(points, got.low), at(points, got.high)) >
           square_distance(at(points, right.low), at(points, right.high));
  };
  ask("Which two points are the most distant extremes?")
      .given("points", points)
      .suspect("extent-for-distance",
               [&] { return best_pair(points, extremes_along, extent_along); })
      .suspect("extremes-of-one-axis", [&] { return extremes_along(0, points); })
      .suspect("maximum-from-zero", [&] { return farthest_pair(points, extremes_from_zero); })
      .suspect("low-excludes-high", [&] { return farthest_pair(points, extremes_by_else); })
      .suspect("last-of-equal-extremes", [&] { return farthest_pair(points, last_extremes_along); })
      .suspect("last-of-equal-extremes",
               [&] { return farthest_pair(points, extremes_along, true); })
      .suspect_if(
          "farthest-of-all-points",
          [&](const ExtremePair& got) { return is_farthest_of_all(got, points) && is_longer(got); })
      .answer([&] { return exercise::most_distant_extremes(points); })
      .equals(right);
}

// ---------------------------------------------------------------- the start

Sphere start_sphere(const Point& low, const Point& high) {
  return {low + (high - low) / 2, std::sqrt(double(square_distance(low, high))) / (2 * kParts)};
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

// ---------------------------------------------------------------- one step

/// A sphere of this radius that touches the point and whose centre is towards the old one.
Sphere touching(const Point& point, double radius, const Sphere& sphere) {
  const Point from_point = sphere.centre - point;
  return {point + from_point * (radius / from_point.norm()), radius};
}
double mean_radius(const Sphere& sphere, const Point& point) {
  return (sphere.radius + (sphere.centre - point).norm()) / 2;
}
Sphere grown(const Sphere& sphere, const Point& point) {
  return touching(point, mean_radius(sphere, point), sphere);
}
Sphere grown_by(const Sphere& sphere, const Point& point) {
  return (point - sphere.centre).norm() > sphere.radius ? grown(sphere, point) : sphere;
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

// ---------------------------------------------------------------- the whole sphere

Sphere start_of(const Points& points) {
  const ExtremePair pair = most_distant_extremes(points);
  return start_sphere(at(points, pair.low), at(points, pair.high));
}

Sphere grow_sphere(const Points& points) {
  Sphere sphere = start_of(points);
  for (const Point& p : points) sphere = grown_by(sphere, p);
  return sphere;
}

/// Grows once, by the point that is farthest from the centre of the start sphere.
Sphere grown_once(const Points& points) {
  const Sphere start = start_of(points);
  const auto nearer = [&](const Point& a, const Point& b) {
    return (a - start.centre).squaredNorm() < (b - start.centre).squaredNorm();
  };
  return grown_by(start, *std::max_element(points.begin(), points.end(), nearer));
}

Sphere around(const Point& centre, const Points& points) {
  double radius = 0;
  for (const Point& p : points) radius = std::max(radius, (p - centre).norm());
  return {centre, radius};
}
Sphere around_mean(const Points& points) {
  Point sum = Point::Zero();
  for (const Point& p : points) sum += p;
  return around(sum / double(points.size()), points);
}
Sphere around_box_centre(const Points& points) {
  Point low = points[0], high = points[0];
  for (const Point& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return around((low + high) / 2, points);
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

TEST_CASE("a point inside changes nothing") {
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
