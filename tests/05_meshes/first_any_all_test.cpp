// Where the segment's line meets a triangle is decided without rounding. Where a test aims at an
// edge or a vertex, all faces are perpendicular to an axis, and every product, sum and quotient of
// the usual formulas is a double, so that programs that compute with them find equal t. A returned
// index is only compared, not used.
#include "first_any_all.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>
#include <support/shrinkable.hpp>

#include <contact/exact.hpp>

namespace {

using namespace contact::testing;
using contact::Exact;
using exercise::Hit;
using Found = std::optional<Hit>;
using Hits = std::vector<Hit>;
using Mesh = contact::Mesh<double>;
using Segment = contact::Segment<double>;
using Vector = Eigen::Vector3d;

/// Where the line of a segment meets a triangle: at t = numerator / denominator.
struct Crossing {
  int triangle = 0;
  Exact numerator, denominator;  ///< the denominator is positive
};

/// What an answer takes account of: the right one of all, and a mistaken one not.
struct Method {
  bool end = true;  ///< the segment has one
  bool rim = true;  ///< edges and vertices belong to a triangle, and the ends to the segment
  bool back = true;
  bool indices = true;  ///< else each three vertices in their order are a triangle
};

using Crossings = std::vector<Crossing>;

int compare(const Crossing& x, const Crossing& y) {
  return (x.numerator * y.denominator - y.numerator * x.denominator).sign();
}

std::optional<Crossing> crossing(const Segment& segment, const contact::Triangle<double>& triangle,
                                 const Method& method) {
  using V = contact::Vector3<Exact>;
  const V a = triangle.a.cast<Exact>();
  const V e1 = triangle.b.cast<Exact>() - a, e2 = triangle.c.cast<Exact>() - a;
  const V start = segment.start.cast<Exact>(), s = start - a;
  const V d = segment.end.cast<Exact>() - start, n = e1.cross(e2);
  const Exact det = -n.dot(d);
  if (det.sign() == 0 || (!method.back && det.sign() < 0)) return std::nullopt;
  const Exact sign = det.sign();
  const Exact t = n.dot(s) * sign, beta = e2.dot(s.cross(d)) * sign;
  const Exact gamma = e1.dot(d.cross(s)) * sign, alpha = det * sign - beta - gamma;
  const int least = std::min({alpha.sign(), beta.sign(), gamma.sign()});
  const int before_end = (det * sign - t).sign();
  if (least < 0 || t.sign() < 0 || (method.end && before_end < 0)) return std::nullopt;
  if (!method.rim && (least == 0 || t.sign() == 0 || before_end == 0)) return std::nullopt;
  return Crossing{0, t, det * sign};
}

/// Every triangle that is met, in the order of the list.
Crossings crossings(const Segment& segment, const Mesh& mesh, const Method& method) {
  Mesh read = mesh;
  if (!method.indices) {
    read.triangles.clear();
    for (int i = 0; i + 2 < static_cast<int>(mesh.vertices.size()); i += 3)
      read.triangles.push_back({i, i + 1, i + 2});
  }
  Crossings all;
  for (std::size_t i = 0; i < read.triangles.size(); ++i) {
    if (auto one = crossing(segment, contact::triangle_of(read, i), method)) {
      one->triangle = static_cast<int>(i);
      all.push_back(*one);
    }
  }
  return all;
}

Crossings sorted(Crossings all) {
  std::stable_sort(all.begin(), all.end(),
                   [](const Crossing& x, const Crossing& y) { return compare(x, y) < 0; });
  return all;
}

/// Without those that `same` as the last one that stays.
template <class Same>
Crossings thinned(const Crossings& all, Same&& same) {
  Crossings kept;
  for (const Crossing& one : all) {
    if (kept.empty() || !same(kept.back(), one)) kept.push_back(one);
  }
  return kept;
}

bool same_point(const Crossing& x, const Crossing& y) { return compare(x, y) == 0; }

Crossings in_order_of_triangles(Crossings all) {
  std::sort(all.begin(), all.end(),
            [](const Crossing& x, const Crossing& y) { return x.triangle < y.triangle; });
  return all;
}

/// Of each point the last triangle.
Crossings thinned_from_behind(Crossings all) {
  std::reverse(all.begin(), all.end());
  all = thinned(all, same_point);
  std::reverse(all.begin(), all.end());
  return all;
}

/// Each hit removes one equal one after it.
Crossings thinned_in_pairs(const Crossings& all) {
  Crossings kept;
  for (std::size_t i = 0; i < all.size(); ++i) {
    kept.push_back(all[i]);
    if (i + 1 < all.size() && same_point(all[i], all[i + 1])) ++i;
  }
  return kept;
}

Hit hit(const Crossing& one) {
  return {one.triangle, quotient<double>(one.numerator, one.denominator)};
}
Hits hits(const Crossings& all) {
  Hits result;
  for (const Crossing& one : all) result.push_back(hit(one));
  return result;
}

Crossings right_ones(const Segment& segment, const Mesh& mesh, const Method& method = {}) {
  return thinned(sorted(crossings(segment, mesh, method)), same_point);
}

Found front(const Crossings& all) { return all.empty() ? Found{} : Found{hit(all.front())}; }
Found back(const Crossings& all) { return all.empty() ? Found{} : Found{hit(all.back())}; }

constexpr double kTolerance = 1e-11;

void check_first(const Segment& segment, const Mesh& mesh) {
  const Crossings listed = crossings(segment, mesh, {}), along = right_ones(segment, mesh);
  const Found right = front(along);
  const auto by = [&](const Method& method) { return front(right_ones(segment, mesh, method)); };
  ask("Where does the segment first meet the mesh?")
      .given("segment", segment)
      .given("mesh", mesh)
      .suspect("first-in-list", [&] { return front(listed); })
      .suspect("last-hit-kept", [&] { return back(listed); })
      .suspect("farthest-hit", [&] { return back(along); })
      .suspect("later-of-equals",
               [&] { return front(thinned_from_behind(sorted(crossings(segment, mesh, {})))); })
      .suspect("hits-beyond-the-end", [&] { return by({.end = false}); })
      .suspect("touching-rejected", [&] { return by({.rim = false}); })
      .suspect("one-sided", [&] { return by({.back = false}); })
      .suspect("soup-for-indices", [&] { return by({.indices = false}); })
      .suspect_if("division-by-zero",
                  [](const Found& got) { return got && !std::isfinite(got->t); })
      .answer([&] { return exercise::first_hit(segment, mesh); })
      .close_to(right, within(kTolerance));
}

/// Where a segment without a hit is.
enum class Where { anywhere, inside, in_the_box };

void check_any(const Segment& segment, const Mesh& mesh, Where where = Where::anywhere) {
  const bool right = !crossings(segment, mesh, {}).empty();
  ask("Does the segment meet the mesh?")
      .given("segment", segment)
      .given("mesh", mesh)
      .suspect_if("surface-taken-for-solid",
                  [&](const bool& got) { return got && !right && where == Where::inside; })
      .suspect_if("mesh-as-its-box",
                  [&](const bool& got) { return got && !right && where == Where::in_the_box; })
      .answer([&] { return exercise::any_hit(segment, mesh); })
      .equals(right);
}

void check_all(const Segment& segment, const Mesh& mesh) {
  const Crossings listed = crossings(segment, mesh, {}), along = sorted(listed);
  const Hits right = hits(thinned(along, same_point));
  const auto by = [&](const Method& method) { return hits(right_ones(segment, mesh, method)); };
  const auto merged = [&](double distance) {
    return hits(thinned(along, [&](const Crossing& x, const Crossing& y) {
      return std::abs(hit(x).t - hit(y).t) < distance;
    }));
  };
  ask("Where does the segment meet the mesh?")
      .given("segment", segment)
      .given("mesh", mesh)
      .suspect("hits-in-list-order",
               [&] { return hits(in_order_of_triangles(thinned(along, same_point))); })
      .suspect("edge-hit-for-each-triangle", [&] { return hits(along); })
      .suspect("equals-not-adjacent", [&] { return hits(sorted(thinned(listed, same_point))); })
      .suspect("vertex-as-an-edge", [&] { return hits(thinned_in_pairs(along)); })
      .suspect("later-of-equals", [&] { return hits(thinned_from_behind(along)); })
      .suspect("absolute-epsilon", [&] { return merged(1e-6); })
      .suspect("absolute-epsilon", [&] { return merged(1e-9); })
      .suspect("hits-beyond-the-end", [&] { return by({.end = false}); })
      .suspect("touching-rejected", [&] { return by({.rim = false}); })
      .suspect("one-sided", [&] { return by({.back = false}); })
      .suspect("soup-for-indices", [&] { return by({.indices = false}); })
      .suspect_if("division-by-zero",
                  [](const Hits& got) {
                    return std::any_of(got.begin(), got.end(),
                                       [](const Hit& one) { return !std::isfinite(one.t); });
                  })
      .answer([&] { return exercise::all_hits(segment, mesh); })
      .close_to(right, within(kTolerance));
}

void check(const Segment& segment, const Mesh& mesh) {
  check_first(segment, mesh);
  check_all(segment, mesh);
  check_any(segment, mesh);
}

/// All points from low to high: triangles 0 and 1 at the low x, 2 and 3 at the high x, and so on.
Mesh box(const Vector& low, const Vector& high) {
  Mesh mesh;
  for (int i = 0; i < 8; ++i) {
    mesh.vertices.emplace_back(i & 1 ? high.x() : low.x(), i & 2 ? high.y() : low.y(),
                               i & 4 ? high.z() : low.z());
  }
  const std::array<std::array<int, 4>, 6> faces{
      {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
  for (const auto& [a, b, c, d] : faces) {
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({a, c, d});
  }
  return mesh;
}
Mesh cube() { return box({-4, -4, -4}, {4, 4, 4}); }

/// One vertex on each half of each axis. Its upper and lower triangles alternate.
Mesh octahedron(const Vector& centre, const std::array<double, 6>& radii) {
  Mesh mesh;
  for (int i = 0; i < 6; ++i) {
    const double radius = radii[static_cast<std::size_t>(i)];
    mesh.vertices.push_back(centre + (i % 2 == 0 ? radius : -radius) * Vector::Unit(i / 2));
  }
  for (const auto& [x, y] : std::array<std::array<int, 2>, 4>{{{0, 2}, {2, 1}, {1, 3}, {3, 0}}}) {
    mesh.triangles.push_back({x, y, 4});
    mesh.triangles.push_back({y, x, 5});
  }
  return mesh;
}
Mesh octahedron() { return octahedron({0, 0, 0}, {4, 4, 4, 4, 4, 4}); }

Mesh joined(const Mesh& x, const Mesh& y) {
  Mesh both = x;
  const int count = static_cast<int>(x.vertices.size());
  both.vertices.insert(both.vertices.end(), y.vertices.begin(), y.vertices.end());
  for (const auto& [a, b, c] : y.triangles)
    both.triangles.push_back({a + count, b + count, c + count});
  return both;
}

/// The same triangles in another order.
Mesh mixed(const Mesh& mesh) {
  Mesh result = mesh;
  const std::size_t count = mesh.triangles.size();
  for (std::size_t i = 0; i < count; ++i) result.triangles[i] = mesh.triangles[5 * i % count];
  return result;
}

/// The upper box comes first in the list.
Mesh two_boxes() { return joined(box({-4, -4, 8}, {4, 4, 16}), cube()); }

}  // namespace

TEST_CASE("the first hit is found wherever its triangle is in the list") {
  check_first({{1, 2, 24}, {1, 2, -8}}, two_boxes());
  check_first({{1, 2, -8}, {1, 2, 24}}, two_boxes());
  check_first({{1, 2, 24}, {1, 2, -8}}, mixed(two_boxes()));
  check_first({{-12, -1, 3}, {20, 2, -1}}, cube());
  // A determinant of exactly 1.
  check_first({{0.25, 0.5, 1.5}, {0.25, 0.5, 0.5}}, box({0, 0, 0}, {1, 1, 1}));
  check_first({{9, 1, 2}, {1, 0.5, 9}}, octahedron());
}

TEST_CASE("all hits come in their order along the segment") {
  check_all({{1, 2, 24}, {1, 2, -8}}, two_boxes());
  check_all({{1, 2, -8}, {1, 2, 24}}, two_boxes());
  check_all({{1, 2, 24}, {1, 2, -8}}, mixed(two_boxes()));
  check_all({{1, 2, 3}, {2, 1, 24}}, two_boxes());
  check_all({{-12, -1, 3}, {20, 2, -1}}, cube());
  check_all({{3, 3, -8}, {3, 3, 8}}, octahedron());
}

TEST_CASE("the segment has a start and an end") {
  check({{1, 2, 24}, {1, 2, 6}}, two_boxes());
  check({{1, 2, 12}, {1, 2, 2}}, two_boxes());
  check({{1, 2, 24}, {1, 2, 20}}, two_boxes());
  check({{1, 2, -6}, {1, 2, -20}}, two_boxes());
  check_first({{-1, 2, 1}, {2, 1, 3}}, cube());
  check_all({{-1, 2, 1}, {2, 1, 3}}, cube());
}

TEST_CASE("any hit is enough, and inside or beside the mesh there is none") {
  check_any({{1, 2, 24}, {1, 2, -8}}, two_boxes());
  check_any({{-12, -1, 3}, {20, 2, -1}}, mixed(cube()));
  check_any({{-12, -1, 3}, {0, -1, 3}}, cube());
  check_any({{3, 3, -8}, {3, 3, 8}}, octahedron(), Where::in_the_box);
  check_any({{-9, 1, 5}, {9, 1, 7}}, two_boxes(), Where::in_the_box);
  check_any({{-1, 2, 1}, {2, 1, 3}}, cube(), Where::inside);
  check_any({{9, 9, 9}, {12, 9, 9}}, cube());
}

TEST_CASE("a hit on an edge counts once") {
  // Through the diagonals of two faces, and through two edges of the cube.
  check({{1, 1, 12}, {1, 1, -20}}, cube());
  check({{1, 1, 12}, {1, 1, -20}}, mixed(cube()));
  check({{8, 1, 8}, {-8, 1, -8}}, cube());
  check({{-8, 1, -8}, {8, 1, 8}}, mixed(cube()));
}

TEST_CASE("a hit at a vertex counts once") {
  check({{8, 8, 8}, {-8, -8, -8}}, cube());
  check({{8, 8, 8}, {-8, -8, -8}}, mixed(cube()));
  check({{-8, 8, -8}, {8, -8, 8}}, mixed(cube()));
  check({{12, 8, 6}, {-20, -8, -2}}, cube());
}

TEST_CASE("touching counts") {
  // The end or the start on a face; an edge and a vertex from outside.
  check({{1, 2, 12}, {1, 2, 4}}, cube());
  check({{1, 2, 4}, {1, 2, 12}}, cube());
  check({{1, 2, -4}, {1, 2, 4}}, cube());
  check({{8, 1, 0}, {0, 1, 8}}, cube());
  check({{0, 12, 0}, {8, -4, 8}}, mixed(cube()));
  check({{4, 4, 4}, {8, 8, 12}}, cube());
}

TEST_CASE("a segment in the plane of a face meets the neighbours") {
  check({{-12, 1, 4}, {20, 1, 4}}, cube());
  check({{0, 1, 4}, {16, 1, 4}}, mixed(cube()));
  check({{-2, 1, 4}, {2, 1, 4}}, cube());
  // Along edges.
  check({{-12, 4, 4}, {20, 4, 4}}, cube());
  check({{4, 4, 24}, {4, 4, -8}}, mixed(two_boxes()));
}

TEST_CASE("two faces close together are two hits") {
  const Mesh plate = box({-4, -4, 0}, {4, 4, 1.0 / 1024});
  check({{1, 2, 524288}, {1, 2, -524288}}, plate);
  check({{1, 2, -524288}, {1, 2, 524288}}, mixed(plate));
}

namespace {

/// An octahedron whose vertices are at different distances from its centre.
struct Star {
  Vector centre;
  std::array<double, 6> radii;
};

/// All in one mesh, the triangles in any order.
Mesh mesh_of(const std::vector<Star>& stars) {
  Mesh all;
  for (const Star& star : stars) all = joined(all, octahedron(star.centre, star.radii));
  return mixed(all);
}

void check_stars(const Segment& segment, const std::vector<Star>& stars) {
  check(segment, mesh_of(stars));
}

/// The contract allows them, and the line of the segment meets or misses every triangle clearly, at
/// clearly different t.
bool beyond_doubt(const Segment& segment, const std::vector<Star>& stars) {
  for (std::size_t i = 0; i < stars.size(); ++i) {
    const auto& radii = stars[i].radii;
    if (!(*std::min_element(radii.begin(), radii.end()) >= 0.5)) return false;
    if (!(*std::max_element(radii.begin(), radii.end()) <= 4)) return false;
    for (std::size_t j = 0; j < i; ++j) {
      if (!((stars[i].centre - stars[j].centre).cwiseAbs().maxCoeff() > 8.1)) return false;
    }
  }
  const Vector d = segment.end - segment.start;
  if (!(d.norm() > 1)) return false;
  const Mesh mesh = mesh_of(stars);
  std::vector<double> all{0, 1};
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto [a, b, c] = contact::triangle_of(mesh, i);
    const Vector e1 = b - a, e2 = c - a, s = segment.start - a, n = e1.cross(e2);
    const double det = -n.dot(d);
    if (!(std::abs(det) > 1e-2 * n.norm() * d.norm())) return false;
    const double beta = e2.dot(s.cross(d)) / det, gamma = e1.dot(d.cross(s)) / det;
    const double least = std::min({beta, gamma, 1 - beta - gamma});
    if (!(std::abs(least) > 1e-3)) return false;
    if (least > 0) all.push_back(n.dot(s) / det);
  }
  std::sort(all.begin(), all.end());
  const auto close = [](double x, double y) { return y - x < 1e-3; };
  return std::adjacent_find(all.begin(), all.end(), close) == all.end();
}

}  // namespace

TEST_CASE("random meshes agree with exact arithmetic") {
  generators::Random random(seed(0));
  const auto vector = [&](double size) {
    return Vector{random.uniform(-size, size), random.uniform(-size, size),
                  random.uniform(-size, size)};
  };
  for (int asked = 0; asked < 100;) {
    std::vector<Star> stars;
    const int count = random.integer(1, 4);
    const Vector along = vector(1).normalized();
    for (int i = 0; i < count; ++i) {
      Star star{12.0 * i * along + vector(1), {}};
      for (double& radius : star.radii) radius = random.uniform(0.5, 4);
      stars.push_back(star);
    }
    std::reverse(stars.begin(), stars.begin() + random.integer(0, count));
    // Mostly along all of them, and now and then backwards.
    Vector start = vector(2), end = vector(2);
    start -= random.uniform(-1, 6) * along;
    end += (12.0 * (count - 1) + random.uniform(-1, 6)) * along;
    if (random.chance(0.5)) std::swap(start, end);
    if (!beyond_doubt({start, end}, stars)) continue;
    ++asked;
    shrinkable(check_stars, beyond_doubt, Segment{start, end}, stars);
  }
}
