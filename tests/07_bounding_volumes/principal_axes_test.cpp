// The rules are decided in integers and by the exact hull of the book. The given code's volumes are
// compared as it computes them, and rounding cannot decide: a ratio counts if rounding alone keeps
// it below the limit.
#include "principal_axes.hpp"
#include "principal_box.hpp"

#include <support/break_it.hpp>

#include <07_bounding_volumes/whole_points.hpp>
#include <contact/convex_hull.hpp>

namespace {

using namespace contact::testing;
using exercise::Body;
using whole_points::Point;
using Points = std::vector<Point>;

constexpr double kRounding = 1e-9;

double aligned_volume(const Points& points) {
  Eigen::AlignedBox3d box;
  for (const Point& p : points) box.extend(p);
  return box.volume();
}

bool has_volume(const Points& points) { return contact::convex_hull(points).dimension == 3; }

/// Of equal points only the first can be a vertex, so none is stored twice.
bool all_vertices(const Points& points) {
  return contact::convex_hull(points).vertices.size() == points.size();
}

Points with_added(const Body& body) {
  Points all = body.points;
  all.push_back(body.added);
  return all;
}

/// Whether the last of these is inside the hull of the others or on it: otherwise it is a vertex.
bool belongs_to_the_others(const Points& points) {
  const std::vector<int> vertices = contact::convex_hull(points).vertices;
  return std::find(vertices.begin(), vertices.end(), static_cast<int>(points.size()) - 1) ==
         vertices.end();
}

/// Whether the exact covariance is diagonal, and the given code's axes are x, y and z.
bool is_unmixed(const Points& points) {
  for (int i = 0; i < 3; ++i) {
    std::int64_t sum_i = 0, sum_j = 0, product = 0;
    const int j = (i + 1) % 3;
    for (const Point& p : points) {
      const auto x = static_cast<std::int64_t>(p[i]), y = static_cast<std::int64_t>(p[j]);
      sum_i += x;
      sum_j += y;
      product += x * y;
    }
    if (product * std::ssize(points) != sum_i * sum_j) return false;
  }
  return given::principal_box(points).axes.cwiseAbs().colwise().maxCoeff().minCoeff() >=
         1 - kRounding;
}

/// Whether each axis of the one box is within 10 degrees of an axis of the other.
bool hardly_turned(const Points& before, const Points& after) {
  constexpr double kCosine = 0.98480775301220802;
  const Eigen::Matrix3d cosines =
      given::principal_box(before).axes.transpose() * given::principal_box(after).axes;
  return cosines.cwiseAbs().colwise().maxCoeff().minCoeff() >= kCosine;
}

/// The three edges of a cube from its first vertex, if the points are the vertices of a cube.
std::optional<Points> edges_of_cube(const Points& points) {
  if (points.size() != 8) return std::nullopt;
  const auto length = [](const Point& v) { return whole_points::dot(v, v); };
  std::int64_t shortest = 0;
  for (const Point& p : points) {
    const std::int64_t d = length(p - points[0]);
    if (d > 0 && (shortest == 0 || d < shortest)) shortest = d;
  }
  Points edges;
  for (const Point& p : points) {
    if (shortest > 0 && length(p - points[0]) == shortest) edges.push_back(p - points[0]);
  }
  if (edges.size() != 3) return std::nullopt;
  for (std::size_t i = 0; i < 3; ++i) {
    if (whole_points::dot(edges[i], edges[(i + 1) % 3]) != 0) return std::nullopt;
  }
  for (unsigned corner = 0; corner < 8; ++corner) {
    Point at = points[0];
    for (unsigned i = 0; i < 3; ++i) {
      if ((corner >> i & 1U) != 0) at += edges[i];
    }
    if (std::find(points.begin(), points.end(), at) == points.end()) return std::nullopt;
  }
  return edges;
}

double volume_of_cube(const Points& points) {
  const Points edges = edges_of_cube(points).value();
  return std::abs(edges[0].cross(edges[1]).dot(edges[2]));
}

bool is_aligned(const Points& edges) {
  return std::all_of(edges.begin(), edges.end(),
                     [](const Point& e) { return (e.array() != 0).count() == 1; });
}

std::string text(double x) { return contact::text_of(x, {.digits = 4}); }

Judged judged(const Points& points, double volume, double right, double times,
              const std::string& of) {
  const Point lengths = given::principal_box(points).lengths;
  const double ratio = volume / right;
  return {ratio >= times * (1 - kRounding), "volume " + text(volume), "volume " + text(right),
          "The given code's box has " + text(ratio) + " times the volume of " + of +
              "; its lengths are " + text(lengths.x()) + ", " + text(lengths.y()) + " and " +
              text(lengths.z()) + "."};
}

bool is_listed(const Points& points) { return points.size() >= 4 && points.size() <= 20; }

}  // namespace

TEST_CASE("the box is larger than the axis-aligned one, and each point is a vertex") {
  break_it<Points>("For which points is the box at least twice as large as the axis-aligned one?")
      .rule("there are 4 to 20 points", is_listed)
      .rule("every coordinate is a whole number from -10 to 10",
            [](const Points& points) { return whole_points::all_whole(points, 10); })
      .rule("the points are not all in one plane", has_volume)
      .rule("each point is a vertex of the convex hull, and none is stored twice", all_vertices)
      .suspect_if("break-axes-unmixed", is_unmixed)
      .suspect_if("break-body-is-oblique",
                  [](const Points& points) {
                    return given::principal_volume(points) <=
                           aligned_volume(points) * (1 + kRounding);
                  })
      .suspect_if("break-box-little-larger", [](const Points&) { return true; })
      .input("points", [] { return exercise::larger_than_the_aligned_box(); })
      .judge([](const Points& points) {
        return judged(points, given::principal_volume(points), aligned_volume(points), 2,
                      "the axis-aligned box");
      });
}

TEST_CASE("the box changes if a point of the body is added") {
  break_it<Body>("For which body does one of its points make the box at least twice as large?")
      .rule("there are 4 to 20 points", [](const Body& body) { return is_listed(body.points); })
      .rule("every coordinate is a whole number from -10 to 10",
            [](const Body& body) { return whole_points::all_whole(with_added(body), 10); })
      .rule("the points are not all in one plane",
            [](const Body& body) { return has_volume(body.points); })
      .rule("the added point is inside the convex hull of the others or on it",
            [](const Body& body) { return belongs_to_the_others(with_added(body)); })
      .suspect_if("break-axes-unmixed",
                  [](const Body& body) { return is_unmixed(with_added(body)); })
      .suspect_if("break-point-outweighed",
                  [](const Body& body) { return hardly_turned(body.points, with_added(body)); })
      .suspect_if("break-turned-box-fits", [](const Body&) { return true; })
      .input("body", [] { return exercise::changed_by_a_point(); })
      .judge([](const Body& body) {
        const Points all = with_added(body);
        return judged(all, given::principal_volume(all), given::principal_volume(body.points), 2,
                      "its box without the added point");
      });
}

TEST_CASE("the box of a cube is larger than the cube") {
  break_it<Points>("For which cube does the box have at least 1.5 times its volume?")
      .rule("every coordinate is a whole number from -100 to 100",
            [](const Points& points) { return whole_points::all_whole(points, 100); })
      .rule("the points are the eight vertices of a cube",
            [](const Points& points) { return edges_of_cube(points).has_value(); })
      .suspect_if("break-cube-is-aligned",
                  [](const Points& points) { return is_aligned(edges_of_cube(points).value()); })
      .suspect_if("break-cube-hardly-turned", [](const Points&) { return true; })
      .input("points", [] { return exercise::cube_in_a_large_box(); })
      .judge([](const Points& points) {
        return judged(points, given::principal_volume(points), volume_of_cube(points), 1.5,
                      "the cube");
      });
}
