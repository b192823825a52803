// The closest point of a simplex: without error against all faces in fractions, and rounded.
#include <09_separating_planes/random_poses.hpp>
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/gjk_simplex.hpp>
#include <optional>
#include <support/generators.hpp>
#include <support/oracle.hpp>
#include <utility>
#include <vector>

namespace gjk_simplex_test {
namespace {

using contact::closest_of_simplex;
using contact::closest_of_simplex_exactly;
using contact::FourPoints;
using contact::SimplexPoint;
using generators::Random;
using oracle::Rational;
using oracle::Vector;
using Point = contact::Vector3<double>;

constexpr double u = 0x1p-53;

/// The point of the affine hull of some points that is closest to the origin, if it is in the hull
/// of the points: by elimination from the equations of the weights.
std::optional<Vector> foot_inside(const std::vector<Vector>& w) {
  const std::size_t n = w.size() - 1;
  std::vector<std::vector<Rational>> m(n, std::vector<Rational>(n + 1));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      m[i][j] = Vector(w[i + 1] - w[0]).dot(Vector(w[j + 1] - w[0]));
    }
    m[i][n] = -Vector(w[i + 1] - w[0]).dot(w[0]);
  }
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    while (pivot < n && m[pivot][k] == 0) ++pivot;
    if (pivot == n) return std::nullopt;  // dependent: a smaller face has the point
    std::swap(m[k], m[pivot]);
    for (std::size_t i = 0; i < n; ++i) {
      if (i == k) continue;
      const Rational factor = m[i][k] / m[k][k];
      for (std::size_t j = k; j <= n; ++j) m[i][j] -= factor * m[k][j];
    }
  }
  Rational rest = 1;
  Vector foot = w[0];
  for (std::size_t i = 0; i < n; ++i) {
    const Rational weight = m[i][n] / m[i][i];
    if (weight < 0) return std::nullopt;
    rest -= weight;
    foot = foot + Vector(Vector(w[i + 1] - w[0]) * weight);
  }
  if (rest < 0) return std::nullopt;
  return foot;
}

/// The closest point of all feet that are inside their faces.
Vector closest_in_fractions(const FourPoints<double>& w, int count) {
  std::optional<Vector> best;
  for (unsigned set = 1; set < 1U << count; ++set) {
    std::vector<Vector> face;
    for (std::size_t i = 0; i < 4; ++i) {
      if ((set >> i & 1U) != 0) face.push_back(oracle::exact(w[i]));
    }
    const auto foot = foot_inside(face);
    if (foot && (!best || foot->dot(*foot) < best->dot(*best))) best = foot;
  }
  return *best;
}

FourPoints<double> whole_points(Random& random, int most) {
  FourPoints<double> w;
  for (Point& p : w) {
    const int x = random.integer(-most, most), y = random.integer(-most, most);
    p = Point(x, y, random.integer(-most, most));
  }
  return w;
}
FourPoints<double> any_points(Random& random) {
  FourPoints<double> w;
  for (Point& p : w) p = random_poses::any_point(random, 1);
  return w;
}
/// Points that are nearly in a plane, on a line or equal, near the origin or not.
FourPoints<double> thin_points(Random& random) {
  const Point along = random_poses::direction(random), beside = random_poses::direction(random);
  const double width = std::abs(random.magnitude(-60, 0)), height = random.magnitude(-60, 0);
  const Point away = random_poses::any_point(random, 1) * height;
  FourPoints<double> w;
  for (Point& p : w) {
    const double x = random.uniform(-1, 1), y = random.uniform(-1, 1) * width;
    p = away + along * x + beside * y;
  }
  return w;
}

void check_exactly(const FourPoints<double>& w, int count) {
  const SimplexPoint<double> found = closest_of_simplex_exactly(w, count);
  REQUIRE(found.point == oracle::nearest(closest_in_fractions(w, count)));
  Rational sum = 0;
  Vector back = Vector::Zero();
  double largest = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const bool of_face = (found.face >> i & 1U) != 0;
    REQUIRE((found.weights[i] > 0) == of_face);
    if (!of_face) continue;
    REQUIRE(static_cast<int>(i) < count);
    sum += oracle::exact(found.weights[i]);
    back = back + Vector(oracle::exact(w[i]) * oracle::exact(found.weights[i]));
    largest = std::max(largest, w[i].norm());
  }
  REQUIRE(oracle::error(1, sum) <= 4 * u);
  REQUIRE(oracle::error(found.point, back) <= 8 * u * largest);
}

TEST_CASE("the closest point of a simplex without error is that of all faces in fractions") {
  Random random(1);
  for (int count = 1; count <= 4; ++count) {
    for (int i = 0; i < generators::tried(300); ++i) {
      check_exactly(whole_points(random, random.integer(1, 5)), count);
      check_exactly(any_points(random), count);
      check_exactly(thin_points(random), count);
    }
  }
}

TEST_CASE("the exact closest point holds for coordinates of any magnitude") {
  Random random(2);
  for (int i = 0; i < generators::tried(200); ++i) {
    const double scale = std::ldexp(1.0, random.integer(-400, 300));
    FourPoints<double> w = random.chance(0.5) ? thin_points(random) : any_points(random);
    for (Point& p : w) p *= scale;
    const int count = random.integer(1, 4);
    REQUIRE(closest_of_simplex_exactly(w, count).point ==
            oracle::nearest(closest_in_fractions(w, count)));
  }
}

TEST_CASE("equal points have the closest point of one of them") {
  const FourPoints<double> w{Point(1, 2, 3), Point(1, 2, 3), Point(1, 2, 3), Point(1, 2, 3)};
  for (int count = 1; count <= 4; ++count) {
    CHECK(closest_of_simplex(w, count).point == w[0]);
    CHECK(closest_of_simplex_exactly(w, count).point == w[0]);
    CHECK(closest_of_simplex_exactly(w, count).face == 1);
  }
}

TEST_CASE("whole points are solved by the rounded method as by the exact one") {
  Random random(3);
  for (int i = 0; i < generators::tried(4000); ++i) {
    const FourPoints<double> w = whole_points(random, 4);
    const int count = random.integer(1, 4);
    const Point found = closest_of_simplex(w, count).point;
    REQUIRE((found - closest_of_simplex_exactly(w, count).point).norm() <= 32 * u * 8);
  }
}

/// Whether no angle of a simplex has a small sine.
bool is_fat(const FourPoints<double>& w, int count) {
  if (count < 3) return true;
  const Point a = w[1] - w[0], b = w[2] - w[0];
  const double area = a.cross(b).norm();
  if (area < 0.2 * a.norm() * b.norm() || area < 0.2 * (b - a).norm() * b.norm()) return false;
  return count < 4 || std::abs(a.cross(b).dot(w[3] - w[0])) > 0.2;
}

TEST_CASE("the rounded closest point of a fat simplex is off by a few u of its coordinates") {
  Random random(4);
  int fat = 0;
  for (int i = 0; i < generators::tried(4000); ++i) {
    const FourPoints<double> w = any_points(random);
    const int count = random.integer(1, 4);
    if (!is_fat(w, count)) continue;
    ++fat;
    const Point found = closest_of_simplex(w, count).point;
    REQUIRE((found - closest_of_simplex_exactly(w, count).point).norm() <= 128 * u);
  }
  CHECK(fat > generators::tried(4000) / 10);
}

TEST_CASE("an edge that passes close to the origin has a closest point with a right direction") {
  Random random(5);
  for (int i = 0; i < generators::tried(2000); ++i) {
    const Point along = random_poses::direction(random), beside = random_poses::direction(random);
    const Point off = beside * std::abs(random.magnitude(-50, -8));
    const double before = random.uniform(0.1, 1), after = random.uniform(0.1, 1);
    const FourPoints<double> w{Point(off - along * before), Point(off + along * after)};
    const Point exact = closest_of_simplex_exactly(w, 2).point;
    const Point found = closest_of_simplex(w, 2).point;
    REQUIRE((found - exact).norm() <= 16 * u * exact.norm());
  }
}

TEST_CASE("a fat triangle close to the origin has a closest point with a right direction") {
  Random random(6);
  for (int i = 0; i < generators::tried(2000); ++i) {
    const contact::Matrix3<double> axes = random_poses::turn(random);
    const Point off = axes.col(2) * std::abs(random.magnitude(-45, -8));
    const Point x = axes.col(0), y = axes.col(1);
    const FourPoints<double> w{Point(off + x), Point(off + y - x * 0.5), Point(off - y - x * 0.5)};
    const Point exact = closest_of_simplex_exactly(w, 3).point;
    const Point found = closest_of_simplex(w, 3).point;
    REQUIRE(found.normalized().cross(exact.normalized()).norm() <= 16 * u);
  }
}

TEST_CASE("the rounded method has the origin inside a tetrahedron as the exact one has") {
  Random random(7);
  int inside = 0;
  for (int i = 0; i < generators::tried(4000); ++i) {
    const FourPoints<double> w = any_points(random);
    const bool exactly = closest_of_simplex_exactly(w, 4).face == 15;
    inside += exactly ? 1 : 0;
    REQUIRE((closest_of_simplex(w, 4).face == 15) == exactly);
  }
  CHECK(inside > generators::tried(4000) / 20);
}

TEST_CASE("floats are solved exactly for their stored numbers") {
  Random random(8);
  for (int i = 0; i < generators::tried(500); ++i) {
    const FourPoints<double> points = any_points(random);
    FourPoints<float> w;
    FourPoints<double> same;
    for (std::size_t k = 0; k < 4; ++k) {
      w[k] = points[k].cast<float>();
      same[k] = w[k].cast<double>();
    }
    const Vector exact = closest_in_fractions(same, 4);
    const auto found = closest_of_simplex_exactly(w, 4);
    for (int k = 0; k < 3; ++k) REQUIRE(found.point(k) == oracle::nearest_float(exact(k)));
  }
}

}  // namespace
}  // namespace gjk_simplex_test
