// Right answers are computed in integers. Every test asks for several answers.
#include "inside_concave.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>
#include <support/shrinkable.hpp>

#include <05_meshes/rays_with_mistakes.hpp>

namespace {

using namespace contact::testing;
using exercise::Where;
using mistakes::Borders;
using solids::Mesh;
using solids::Point;
using solids::Triangle;

void check_triangle(const Point& p, const Triangle& t) {
  const bool in_plane = solids::ahead(t, p) == 0;
  const bool right = solids::on_triangle(t, p);
  const std::array<int, 3> sides = solids::inner_sides(t, p);
  ask("Is the point on the triangle?")
      .given("point", p)
      .given("triangle", t)
      .suspect("plane-for-triangle", [&] { return in_plane; })
      .suspect("triangle-for-its-column", [&] { return mistakes::in_column(t, p, 2); })
      .suspect("same-dimension-dropped", [&] { return in_plane && mistakes::in_column(t, p, 2); })
      .suspect("absolute-epsilon", [&] { return mistakes::on_triangle(t, p, 1e-6); })
      .suspect_if("border-of-triangle-missed",
                  [&](const bool& got) {
                    return !got && right && *std::min_element(sides.begin(), sides.end()) == 0;
                  })
      .answer([&] { return exercise::on_triangle(p, t); })
      .equals(right);
}

Where where(bool inside) { return inside ? Where::inside : Where::outside; }

/// `decide` answers for a point that is not on the surface.
template <class Decide>
std::function<Where()> off_the_surface(bool on, Decide decide) {
  return [on, decide] { return on ? Where::on : where(decide()); };
}

/// What rays in the six directions along the axes give.
std::vector<Suspect<Where>> suspects(const std::vector<Triangle>& all, const Point& p, bool on) {
  std::vector<Suspect<Where>> found;
  const auto add = [&](std::string_view id, auto decide) {
    found.emplace_back(id, off_the_surface(on, decide));
  };
  for (int i = 0; i < 6; ++i) {
    const solids::Vector d = mistakes::along_axis(i);
    add("edge-hit-counted-twice",
        [&all, p, d] { return mistakes::count(all, p, d, Borders::counted) % 2 == 1; });
    add("edge-hit-not-counted",
        [&all, p, d] { return mistakes::count(all, p, d, Borders::left_out) % 2 == 1; });
    add("equal-hits-merged", [&all, p, d] { return mistakes::count_merged(all, p, d) % 2 == 1; });
    add("any-hit-is-inside",
        [&all, p, d] { return mistakes::count(all, p, d, Borders::counted) > 0; });
    add("first-hit-decides", [&all, p, d] { return mistakes::leaves_first(all, p, d); });
  }
  for (int i = 0; i < 3; ++i) {
    add("shared-edge-decided-twice",
        [&all, p, i] { return mistakes::crossings(all, p, i, true) % 2 == 1; });
    add("any-hit-is-inside", [&all, p, i] { return mistakes::crossings(all, p, i, false) > 0; });
    add("walls-on-both-sides", [&all, p, i] { return mistakes::between_walls(all, p, {i}); });
  }
  add("walls-on-both-sides", [&all, p] { return mistakes::between_walls(all, p, {0, 1, 2}); });
  return found;
}

void check(const Mesh& mesh, const Point& p) {
  const std::vector<Triangle> all = solids::triangles(mesh);
  const bool on = solids::on_surface(mesh, p);
  const Where right = on ? Where::on : where(solids::is_inside(mesh, p));
  ask("Where is the point?")
      .given("mesh", mesh)
      .given("point", p)
      .suspects(suspects(all, p, on))
      .suspect("whole-line-counted", off_the_surface(on, [] { return false; }))
      .suspect("concave-as-convex",
               off_the_surface(on,
                               [&] {
                                 return std::all_of(all.begin(), all.end(), [&](const Triangle& t) {
                                   return solids::ahead(t, p) < 0;
                                 });
                               }))
      .suspect("nearest-face-decides",
               off_the_surface(on, [&] { return mistakes::behind_nearest(all, p); }))
      .suspect(
          "first-shell-alone",
          off_the_surface(on, [&] { return solids::is_inside(mistakes::first_shell(mesh), p); }))
      .suspect_if("surface-not-told-apart",
                  [&](const Where& got) { return on && got != Where::on; })
      .answer([&] { return exercise::inside_concave(mesh, p); })
      .equals(right);
}

/// A U of height 10: a base with two walls, open in +y.
Mesh u_shape() {
  return solids::prism({{0, 0}, {30, 0}, {30, 20}, {20, 20}, {20, 8}, {10, 8}, {10, 20}, {0, 20}},
                       {{0, 1, 4}, {0, 4, 5}, {1, 2, 3}, {1, 3, 4}, {0, 5, 6}, {0, 6, 7}}, 0, 10);
}

/// A box with a roof: its ridge is along y.
Mesh house() {
  return solids::moved(solids::prism({{0, 0}, {8, 0}, {8, 5}, {4, 9}, {0, 5}},
                                     {{0, 1, 2}, {0, 2, 4}, {2, 3, 4}}, 0, 12),
                       (Eigen::Matrix3d() << 1, 0, 0, 0, 0, -1, 0, 1, 0).finished(), {0, 12, 0});
}

/// A box with a cavity, and a smaller box beside it.
Mesh several_shells() {
  const Mesh cavity = solids::inside_out(solids::box({8, 8, 8}, {16, 16, 16}));
  return solids::together(solids::together(solids::box({0, 0, 0}, {24, 24, 24}), cavity),
                          solids::box({30, 2, 2}, {40, 12, 12}));
}

/// A roof without a house: a prism along x with the edges of its ends at (±6, 0) and (0, ±6) of the
/// plane of y and z. The upper triangles come last.
Mesh bar() {
  return solids::moved(
      solids::prism({{-6, 0}, {0, -6}, {6, 0}, {0, 6}}, {{0, 1, 2}, {0, 2, 3}}, 0, 20),
      (Eigen::Matrix3d() << 0, 0, 1, 1, 0, 0, 0, 1, 0).finished(), {0, 0, 0});
}

/// An octahedron; its upper triangles come first, or upside down last.
Mesh octahedron(bool upside_down, const Point& centre) {
  const double z = upside_down ? -1 : 1;
  return solids::moved(solids::octahedron(8), Eigen::Vector3d(1, z, z).asDiagonal(), centre);
}

const Triangle kLevel{{2, 1, 3}, {8, 1, 3}, {2, 7, 3}};
const Triangle kOblique{{1, 2, 0}, {7, 2, 3}, {1, 8, 6}};
const Triangle kVertical{{1, 2, 0}, {7, 5, 0}, {3, 3, 9}};

}  // namespace

TEST_CASE("a point is on a triangle, not only in its plane") {
  check_triangle({4, 3, 3}, kLevel);
  check_triangle({4, 3, 5}, kLevel);
  check_triangle({7, 6, 3}, kLevel);
  check_triangle({0, 2, 3}, kLevel);
  check_triangle({3, 3, 2}, kVertical);
  check_triangle({5, 4, 8}, kVertical);
  check_triangle({9, 6, 1}, kVertical);
  for (const Triangle& t : {kLevel, kOblique, kVertical}) {
    check_triangle(t.a, t);
    check_triangle(t.b, t);
    check_triangle(t.c, t);
    check_triangle(t.a + t.b - t.c, t);
    check_triangle(2 * t.b - t.a, t);
  }
  check_triangle({5, 1, 3}, kLevel);
  check_triangle({3, 4, 3}, kOblique);
  check_triangle({4, 2, 2}, kOblique);
  check_triangle({5, 4, 0}, kVertical);
}

TEST_CASE("a small distance from the plane is not zero") {
  // A quarter and half of a micrometre from the plane, on either side.
  const Triangle large{{-843, -867, -713}, {898, -881, -114}, {-338, 828, 886}};
  check_triangle(large.b, large);
  check_triangle({20, -155, 187}, large);
  check_triangle({-323, -610, -315}, large);
  const Point middle = ((large.a + large.b + large.c) / 3).array().round().matrix();
  for (const double x : {-1, 0, 1}) {
    for (const double y : {-1, 0, 1}) {
      for (const double z : {-1, 0, 1}) check_triangle(middle + Point(x, y, z), large);
    }
  }
}

TEST_CASE("a point is inside, outside or on a concave solid") {
  // All around it, so that a ray in each direction meets the house.
  for (const Point& outside : {Point(-5, 5, 2), Point(15, 5, 2), Point(3, -5, 2), Point(3, 17, 2),
                               Point(3, 5, -4), Point(3, 5, 14)})
    check(house(), outside);
  check(house(), {3, 5, 2});
  check(house(), {7, 11, 4});
  // The triangle with the nearest centroid has the point behind its plane.
  check(solids::box({0, 0, 0}, {24, 24, 24}), {4, -2, 5});
  check(u_shape(), {4, 13, 3});
  check(u_shape(), {25, 15, 6});
  check(u_shape(), {15, 14, 5});
  check(u_shape(), {13, 3, 2});
  check(u_shape(), {10, 12, 4});
  check(u_shape(), {13, 8, 5});
  check(u_shape(), {13, 8, 12});
  check(u_shape(), {30, 20, 10});
}

TEST_CASE("a ray that meets an edge or a vertex crosses the surface or does not") {
  // Along z the ray touches an edge parallel to x, and then an oblique one.
  check(bar(), {9, 6, -5});
  check(octahedron(true, {0, 0, 0}), {4, 4, -9});
  // From inside to a vertex of three triangles.
  const Mesh tetrahedron = solids::tetrahedron({0, 0, 0}, {20, 2, 1}, {3, 20, -1}, {7, 7, 20});
  check(tetrahedron, {7, 7, 3});
  // In through an edge, out through a triangle.
  check(solids::tetrahedron({0, 0, 0}, {20, 10, 2}, {4, 16, 14}, {16, -3, 15}), {10, 5, -5});
  // Touches two edges.
  const Mesh two = solids::together(octahedron(false, {0, 0, 0}), octahedron(false, {0, 0, 20}));
  check(two, {4, 4, -9});
  for (const Point& axis : {Point(1, 0, 0), Point(0, 1, 0), Point(0, 0, 1)}) {
    for (const double along : {-12, -3, 0, 5}) {
      const Mesh mesh = octahedron(false, {0, 0, 0});
      check(mesh, along * axis);
      check(mesh, along * axis + Point(axis.z(), axis.x(), axis.y()) * 3);
      check(mesh, along * axis + Point(axis.z(), axis.x(), axis.y()) * 8);
    }
  }
}

TEST_CASE("a ray along a triangle crosses the surface or does not") {
  for (const Mesh& mesh : {u_shape(), house(), several_shells()}) {
    for (const double x : {-4, 0, 4, 8, 10, 16, 20, 24}) {
      for (const double y : {-2, 0, 8, 12, 16, 20}) check(mesh, {x, y, 5});
      check(mesh, {x, 8, -3});
      check(mesh, {x, 12, 0});
    }
  }
}

TEST_CASE("a cavity is outside, and so is what is between bodies") {
  check(several_shells(), {34, 5, 4});
  // Between six boxes.
  Mesh around = solids::box({10, -4, -5}, {14, 4, 6});
  for (const Point& centre :
       {Point(-12, 0, 0), Point(0, 12, 0), Point(0, -12, 0), Point(0, 0, 12), Point(0, 0, -12)})
    around =
        solids::together(around, solids::box(centre - Point(4, 5, 3), centre + Point(5, 4, 3)));
  check(around, {1, 2, -1});
  check(around, {12, 1, 2});
  check(several_shells(), {11, 13, 14});
  check(several_shells(), {4, 13, 14});
  check(several_shells(), {27, 5, 4});
  check(several_shells(), {8, 12, 12});
  check(several_shells(), {19, 13, 14});
  check(several_shells(), {45, 5, 4});
}

TEST_CASE("random stars agree with integers") {
  generators::Random random(seed(0));
  using Factors = std::array<int, 26>;
  const auto mesh_of = [](const Factors& factors, int cavity, const Eigen::Matrix3d& map) {
    Mesh mesh = solids::star(factors);
    // The same star, smaller: each of its vertices is nearer to the centre.
    if (cavity != 0) {
      Factors smaller = factors;
      for (int& factor : smaller) factor -= cavity;
      mesh = solids::together(mesh, solids::inside_out(solids::star(smaller)));
    }
    return solids::moved(mesh, map, {1, -2, 3});
  };
  const auto judged = [&](const Factors& factors, int cavity, const Eigen::Matrix3d& map,
                          const Point& p) {
    return cavity >= 0 &&
           std::all_of(factors.begin(), factors.end(),
                       [&](int factor) { return factor > cavity && factor < 9; }) &&
           map == map.array().round().matrix() && map.cwiseAbs().maxCoeff() < 30 &&
           map.determinant() > 0.5 && solids::all_whole(mesh_of(factors, cavity, map), p, 1000);
  };
  const auto check_star = [&](const Factors& factors, int cavity, const Eigen::Matrix3d& map,
                              const Point& p) { check(mesh_of(factors, cavity, map), p); };
  for (int asked = 0; asked < 250;) {
    const int cavity = random.integer(0, 1);
    Factors factors{};
    for (int& factor : factors) factor = cavity + random.integer(1, 3);
    const auto number = [&](int limit) { return double(random.integer(-limit, limit)); };
    // Every second one is as it is, so that rays along the axes meet edges and vertices.
    Eigen::Matrix3d map = Eigen::Matrix3d::Identity();
    if (asked % 2 == 1) {
      for (int i = 0; i < 9; ++i) map(i) = number(9);
    }
    const double x = number(4);
    const double y = number(4);
    const Point p = map * Point(x, y, number(4)) + Point(1, -2, 3);
    if (!judged(factors, cavity, map, p)) continue;
    ++asked;
    shrinkable(check_star, judged, factors, cavity, map, p);
  }
}
