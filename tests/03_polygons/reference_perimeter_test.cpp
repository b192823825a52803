#include <03_polygons/reference.hpp>
#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <limits>

namespace {

using namespace polygons;
using contact::PerimeterContact;

const Polygon<double> unit{{0, 0}, {1, 0}, {1, 1}, {0, 1}};

Polygon<double> moved(Polygon<double> polygon, double x, double y) {
  for (auto& v : polygon) v += Vector2<double>(x, y);
  return polygon;
}

TEST_CASE("points on a perimeter are at most the spacing apart and include the vertices") {
  const Polygon<double> polygon{{0, 0}, {3, 0}, {3, 4}};
  const auto points = contact::perimeter_points(polygon, 1.0);
  CHECK(points.size() == 3 + 4 + 5);
  for (const auto& v : polygon) {
    CHECK(std::find(points.begin(), points.end(), v) != points.end());
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    CHECK((points[(i + 1) % points.size()] - points[i]).norm() <= 1 + 1e-15);
  }
  CHECK(contact::perimeter_points(polygon, 0.0) == polygon);
  CHECK(contact::perimeter_points(polygon, -1.0) == polygon);
  CHECK(contact::perimeter_points(polygon, 1e-300) == polygon);
  CHECK(contact::perimeter_points(polygon, std::nan("")) == polygon);
  CHECK(contact::perimeter_points(Polygon<double>{}, 1.0).empty());
}

TEST_CASE("points miss a vertex that enters between them, segments do not") {
  const Polygon<double> floor{{-5, -1}, {5, -1}, {5, 0}, {-5, 0}};
  const Polygon<double> spike{{0.5, -0.25}, {0.75, 1}, {0.25, 1}};
  // The floor's own points, one metre apart, are not in the spike.
  CHECK(contact::hit_points(contact::perimeter_points(floor, 1.0), spike).points.empty());
  CHECK(contact::perimeter_contact(spike, floor).found.hits.size() == 2);
  // And segments miss a body that is wholly inside, which its points do not.
  const Polygon<double> inside = moved({{0, 0}, {0.1, 0}, {0, 0.1}}, 0, -0.5);
  CHECK(contact::perimeter_contact(inside, floor).found.hits.empty());
  CHECK(contact::hit_points(contact::perimeter_points(inside, 1.0), floor).points.size() == 3);
  CHECK(contact::polygons_meet(inside, floor));
}

TEST_CASE("what a test costs is what was compared") {
  const auto points = contact::perimeter_points(unit, 0.1);
  CHECK(contact::hit_points(points, unit).tests == static_cast<std::int64_t>(points.size()) * 4);
  CHECK(contact::perimeter_contact(unit, unit).found.tests == 16);
}

TEST_CASE("a vertex that enters a long edge: three rules, one normal") {
  const Polygon<double> floor{{-5, -1}, {5, -1}, {5, 0}, {-5, 0}};
  const Polygon<double> body = moved({{0, 0}, {1, 1}, {0, 2}, {-1, 1}}, 0.3, -0.125);
  const PerimeterContact<double> contact = contact::perimeter_contact(body, floor);
  REQUIRE(contact.found.hits.size() == 2);
  const Vector2<double> up(0, 1);
  for (const auto& hit : contact.found.hits) {
    CHECK(contact::normal_of_hit_segment(contact, hit) == up);
    CHECK(contact::normal_by_nearer_end(contact, hit) == up);
  }
  const auto face = contact::face_of_least_penetration(contact);
  REQUIRE(face.has_value());
  CHECK(face->normal == up);
  CHECK(face->depth == 0.125);
  CHECK_FALSE(face->of_first);
  CHECK(face->edge == 2);
  CHECK(face->point.x() == Catch::Approx(0.3));
  CHECK(face->point.y() == 0);
}

TEST_CASE("the rule of the nearer end takes a wrong face where a floor has tiles") {
  // Vertices every half metre: a body's tip enters beside one of them.
  const Polygon<double> floor{{-1, -1}, {1, -1}, {1, 0}, {0.5, 0}, {0, 0}, {-0.5, 0}, {-1, 0}};
  const Polygon<double> body = moved({{0, 0}, {1, 1}, {0, 2}, {-1, 1}}, 0.125, -0.1875);
  const PerimeterContact<double> contact = contact::perimeter_contact(body, floor);
  REQUIRE(contact.found.hits.size() == 2);
  int wrong = 0;
  for (const auto& hit : contact.found.hits) {
    if (contact::normal_by_nearer_end(contact, hit).y() < 0.9) ++wrong;
    CHECK(contact::normal_of_hit_segment(contact, hit) == Vector2<double>(0, 1));
  }
  CHECK(wrong > 0);
  CHECK(contact::face_of_least_penetration(contact)->normal == Vector2<double>(0, 1));
}

TEST_CASE("the rule of the hit segment takes a wrong face where the other's vertex enters") {
  const Polygon<double> block = moved(unit, -2, 0.25);  // its right edge at x = −1
  const Polygon<double> wedge = moved({{0, 0}, {1, 1}, {0, 2}, {-1, 1}}, -0.125, -0.25);
  const PerimeterContact<double> contact = contact::perimeter_contact(block, wedge);
  REQUIRE(contact.found.hits.size() == 2);
  for (const auto& hit : contact.found.hits) {
    CHECK(std::abs(contact::normal_of_hit_segment(contact, hit).y()) > 0.7);
    CHECK(contact::normal_by_nearer_end(contact, hit) == Vector2<double>(-1, 0));
  }
  const auto face = contact::face_of_least_penetration(contact);
  REQUIRE(face.has_value());
  CHECK(face->of_first);
  CHECK(face->normal == Vector2<double>(-1, 0));
  CHECK(face->depth == 0.125);
}

TEST_CASE("for overlapping boxes the least penetration is that of the separating axis") {
  Random random(21);
  int boxes = 0;
  for (int i = 0; i < generators::tried(5000); ++i) {
    const double x = random.uniform(-1, 1), y = random.uniform(-1, 1);
    const PerimeterContact<double> contact = contact::perimeter_contact(moved(unit, x, y), unit);
    const auto face = contact::face_of_least_penetration(contact);
    REQUIRE(face.has_value());
    const double least = std::min(1 - std::abs(x), 1 - std::abs(y));
    if (std::abs(std::abs(x) - std::abs(y)) < 1e-9) continue;
    ++boxes;
    CHECK(face->depth == Catch::Approx(least));
    const Vector2<double> right = std::abs(x) > std::abs(y) ? Vector2<double>(x > 0 ? 1 : -1, 0)
                                                            : Vector2<double>(0, y > 0 ? 1 : -1);
    CHECK(face->normal == right);
  }
  CHECK(boxes > generators::tried(4000));
}

TEST_CASE("a thin tip does not take its own side for the face") {
  // The tip's width at the floor is far less than its depth.
  const Polygon<double> floor{{-5, -1}, {5, -1}, {5, 0}, {-5, 0}};
  const Polygon<double> tip{{0, -0.5}, {0.125, 2}, {-0.125, 2}};
  const auto face = contact::face_of_least_penetration(contact::perimeter_contact(tip, floor));
  REQUIRE(face.has_value());
  CHECK(face->normal == Vector2<double>(0, 1));
  CHECK(face->depth == 0.5);
}

TEST_CASE("no contact, no face; a contact of points has none either") {
  CHECK_FALSE(
      contact::face_of_least_penetration(contact::perimeter_contact(unit, moved(unit, 3, 0)))
          .has_value());
  const Polygon<double> point{{0.5, 0}};
  const auto face = contact::face_of_least_penetration(contact::perimeter_contact(point, unit));
  REQUIRE(face.has_value());
  CHECK(face->normal == Vector2<double>(0, -1));
  CHECK(face->depth == 0);
  CHECK_FALSE(
      contact::face_of_least_penetration(contact::perimeter_contact(point, point)).has_value());
}

TEST_CASE("a length is right at every scale") {
  Random random(24);
  for (int i = 0; i < generators::tried(20000); ++i) {
    const double x = random.magnitude(-1070, 1020);
    const double y = random.chance(0.3) ? x * random.uniform() : random.magnitude(-1070, 1020);
    const double length = contact::length_of<double>({x, y});
    // Two roundings of the squares, one of their sum and one of the root: 2u, below two ulps. Below
    // the smallest normal number the unscaled result is rounded once more.
    const Rational square =
        oracle::exact(x) * oracle::exact(x) + oracle::exact(y) * oracle::exact(y);
    const Rational room = oracle::exact(2 * contact::ulp(length));
    const Rational low = oracle::exact(length) - room, high = oracle::exact(length) + room;
    REQUIRE((low <= 0 || low * low <= square));
    REQUIRE(square <= high * high);
  }
  CHECK(contact::length_of<double>({3, 4}) == 5);
  CHECK(contact::length_of<double>({0, 0}) == 0);
  CHECK(contact::length_of<double>({3e300, 4e300}) == Catch::Approx(5e300));
  constexpr double infinity = std::numeric_limits<double>::infinity();
  CHECK(contact::length_of<double>({infinity, 0}) == infinity);
  CHECK(std::isnan(contact::length_of<double>({std::nan(""), 0})));
}

TEST_CASE("a normal is perpendicular, outward and of length 1") {
  Random random(22);
  for (int i = 0; i < 1000; ++i) {
    const Segment2<double> edge{point(random, 1), point(random, 1)};
    const Vector2<double> normal = contact::right_normal(edge);
    CHECK(normal.norm() == Catch::Approx(1));
    CHECK(std::abs(normal.dot(edge.b - edge.a)) <= 1e-15);
    CHECK(contact::cross2<double>(edge.b - edge.a, normal) < 0);
  }
  CHECK(contact::right_normal(Segment2<double>{{1, 1}, {1, 1}}) == Vector2<double>(0, 0));
  CHECK(contact::right_normal(Segment2<double>{{-1e308, 0}, {1e308, 0}}) == Vector2<double>(0, 0));
}

TEST_CASE("polygons meet if edges meet or one contains the other, as in fractions") {
  Random random(23);
  int meets = 0, tried = 0;
  for (int i = 0; i < generators::tried(10000); ++i) {
    const int kind = i % kinds;
    const Polygon<double> p = polygon(random, kind, 1, 4), q = polygon(random, kind, 1, 4);
    bool right = where(exact(q), exact(p[0]), Rule::even_odd) != Where::outside ||
                 where(exact(p), exact(q[0]), Rule::even_odd) != Where::outside;
    for (const auto& s : contact::perimeter_segments(p)) {
      for (const auto& t : contact::perimeter_segments(q)) {
        right = right || common(s, t).meeting != Meeting::none;
      }
    }
    REQUIRE(contact::polygons_meet(p, q) == right);
    REQUIRE(contact::polygons_meet(q, p) == right);
    ++tried;
    meets += right ? 1 : 0;
  }
  CHECK(meets > tried / 10);
  CHECK(meets < tried * 9 / 10);
  CHECK_FALSE(contact::polygons_meet(Polygon<double>{}, unit));
  CHECK_FALSE(contact::polygons_meet(unit, Polygon<double>{}));
  CHECK(contact::polygons_meet(unit, moved(unit, 1, 1)));
}

TEST_CASE("a path through a wall meets its edges in front only") {
  const Polygon<double> wall{{0, 0}, {100, 0}, {100, 100}, {0, 100}, {0, 50}};
  const Segment2<double> path{{50, 50}, {150, 50}};
  const auto hits = contact::edges_on_path(path, wall);
  REQUIRE(hits.size() == 1);
  CHECK(hits[0].second == 1);
  CHECK(hits[0].crossing.point == Vector2<double>(100, 50));
  const Segment2<double> from_outside{{-50, 25}, {150, 25}};
  CHECK(contact::first_edge_on_path(from_outside, wall)->second == 4);
  CHECK(contact::first_edge_on_path(from_outside, wall)->crossing.along_first == 0.25);
  CHECK_FALSE(contact::first_edge_on_path(Segment2<double>{{-9, 0}, {-1, 0}}, wall).has_value());
}

}  // namespace
