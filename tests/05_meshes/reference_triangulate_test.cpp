// Ear clipping against brute force in fractions, and what it refuses.
#include <05_meshes/rings.hpp>
#include <05_meshes/triangulate_truth.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <contact/triangulate.hpp>
#include <optional>
#include <stdexcept>

namespace {

using contact::Polygon;
using contact::PolygonWithHoles;
using contact::SpacePolygon;
using contact::triangulate;
using contact::Vector2;
using contact::Vector3;
using oracle::Rational;
using rings::Random;
using rings::Rings;
using triangulate_truth::Region;
using triangulate_truth::Triangles;

template <class S = double>
PolygonWithHoles<S> with_holes(const Rings& all) {
  PolygonWithHoles<S> polygon;
  for (const Polygon<double>& ring : all) {
    Polygon<S> converted;
    for (const Vector2<double>& v : ring) converted.push_back(v.template cast<S>());
    if (&ring == &all.front()) {
      polygon.outer = converted;
    } else {
      polygon.holes.push_back(converted);
    }
  }
  return polygon;
}

/// The triangles, or nothing if the rings are refused.
template <class S = double>
std::optional<Triangles> asked(const Rings& all) {
  try {
    return triangulate(with_holes<S>(all));
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

/// Compares with the truth; returns whether the rings are valid.
template <class N>
bool compare(const Rings& all) {
  const Region<N> region(all);
  const bool valid = region.valid();
  const std::optional<Triangles> got = asked(all);
  REQUIRE(got.has_value() == valid);
  if (got) REQUIRE(region.fault(*got) == "");
  return valid;
}

TEST_CASE("grid polygons with holes are covered once, also along straight edges") {
  Random random(501);
  const auto keeps = [](const Rings& all) { return Region<double>(all).valid(); };
  int holes = 0, large = 0;
  for (int i = 0; i < generators::tried(10000); ++i) {
    INFO("case " << i);
    const Rings all = rings::on_grid(random, i % 3 == 0 ? 5 : 12, keeps);
    REQUIRE(compare<double>(all));
    holes += static_cast<int>(all.size()) - 1;
    if (all[0].size() > 12) ++large;
  }
  CHECK(holes > generators::tried(5000));
  CHECK(large > generators::tried(500));
}

TEST_CASE("a vertex anywhere on the grid is refused as brute force refuses it") {
  Random random(506);
  const auto keeps = [](const Rings& all) { return Region<double>(all).valid(); };
  const auto any = [](const Rings&) { return true; };
  int valid = 0, refused = 0;
  for (int i = 0; i < generators::tried(10000); ++i) {
    INFO("case " << i);
    Rings all = rings::on_grid(random, 6, keeps);
    const int ring = random.integer(0, static_cast<int>(all.size()) - 1);
    rings::grow(random, all, static_cast<std::size_t>(ring), 1, 0, 6, any);
    ++(compare<double>(all) ? valid : refused);
  }
  CHECK(valid > generators::tried(500));
  CHECK(refused > generators::tried(5000));
}

TEST_CASE("stars with holes are covered once, or refused as brute force refuses them") {
  Random random(502);
  int valid = 0, refused = 0;
  for (int i = 0; i < generators::tried(10000); ++i) {
    INFO("case " << i);
    const bool whole = i % 4 != 0;
    const Rings all = rings::stars(random, whole);
    const bool good = whole ? compare<double>(all) : compare<Rational>(all);
    ++(good ? valid : refused);
  }
  CHECK(valid > generators::tried(3000));
  CHECK(refused > generators::tried(1000));
}

TEST_CASE("what is straight but for the last bits is decided without rounding") {
  Random random(503);
  const auto keeps = [](const Rings& all) { return Region<double>(all).valid(); };
  int valid = 0, refused = 0;
  for (int i = 0; i < generators::tried(2500); ++i) {
    INFO("case " << i);
    Rings on_grid = rings::on_grid(random, 5, keeps);
    if (i % 2 == 0) {  // a vertex anywhere: it may touch an edge
      const auto any = [](const Rings&) { return true; };
      rings::grow(random, on_grid, on_grid.size() - 1, 1, 0, 5, any);
    }
    const Rings all = rings::nearly(random, on_grid);
    ++(compare<Rational>(all) ? valid : refused);
  }
  CHECK(valid > generators::tried(1000));
  CHECK(refused > generators::tried(20));
}

TEST_CASE("floats are triangulated as the doubles that they are") {
  Random random(504);
  for (int i = 0; i < generators::tried(1000); ++i) {
    Rings all = rings::stars(random, false);
    for (Polygon<double>& ring : all) {
      for (Vector2<double>& v : ring) v = v.cast<float>().cast<double>();
    }
    REQUIRE(asked<float>(all) == asked<double>(all));
  }
}

TEST_CASE("a comb, a spiral and a field of holes") {
  Rings comb(1);
  for (int i = 0; i < 200; ++i) comb[0].push_back({double(i), i % 2 == 0 ? 0.0 : 50.0});
  comb[0].push_back({199, -1});
  comb[0].push_back({0, -1});
  CHECK(compare<double>(comb));

  Rings spiral(1);
  for (int i = 0; i < 60; ++i) {
    const double r = i + 2;
    const double x[4] = {r, 0, -r, 0}, y[4] = {0, r, 0, -r};
    spiral[0].push_back({x[i % 4], y[i % 4]});
  }
  for (int i = 59; i >= 0; --i) {
    const double r = i + 1;
    const double x[4] = {r, 0, -r, 0}, y[4] = {0, r, 0, -r};
    spiral[0].push_back({x[i % 4], y[i % 4]});
  }
  CHECK(compare<double>(spiral));

  // All rightmost vertices of a row have one height, and of a column one x: ties everywhere.
  Rings field(1);
  field[0] = {{0, 0}, {30, 0}, {30, 30}, {0, 30}};
  for (int i = 0; i < 9; ++i) {
    for (int j = 0; j < 9; ++j) {
      const double x = 3 * i + 1, y = 3 * j + 1;
      field.push_back({{x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y + 1}});
      if ((i + j) % 2 == 0) field.back() = {{x, y}, {x + 1, y + 1}, {x, y + 2}};
    }
  }
  CHECK(compare<double>(field));
}

TEST_CASE("what triangulate refuses, and what it says") {
  const auto refuses = [](const Rings& all, const std::string& start) {
    INFO(start);
    CHECK_THROWS_MATCHES(triangulate(with_holes(all)), std::invalid_argument,
                         Catch::Matchers::MessageMatches(Catch::Matchers::StartsWith(start)));
  };
  const Polygon<double> square{{0, 0}, {8, 0}, {8, 8}, {0, 8}};
  const double nan = std::numeric_limits<double>::quiet_NaN();
  refuses({{{0, 0}, {1, 0}}}, "outer = 2 vertices: must have at least 3");
  refuses({square, {}}, "holes[0] = 0 vertices");
  refuses({{{0, 0}, {1, nan}, {0, 1}}}, "outer[1] = (1, nan): every coordinate must be finite");
  refuses({{{0, 0}, {1, 0}, {1, 0}, {0, 1}}}, "outer[2] = (1, 0): must differ");
  refuses({{{0, 0}, {1, 0}, {0, 1}, {0, 0}}}, "outer[0] = (0, 0): must differ");
  refuses({{{0, 0}, {2, 2}, {2, 0}, {0, 2}}},
          "outer[0] = (0, 0): the edge from here crosses the edge from outer[2]");
  refuses({{{0, 0}, {2, 0}, {1, 0}, {1, 1}}}, "outer[0] = (0, 0): the edge from here touches");
  refuses({{{0, 0}, {1, 1}, {2, 2}}}, "outer[0] = (0, 0): the edge from here touches");
  refuses({square, {{0, 4}, {2, 3}, {2, 5}}}, "outer[3] = (0, 8): the edge from here touches");
  refuses({square, {{9, 4}, {11, 3}, {11, 5}}},
          "holes[0][0] = (9, 4): must be inside of the outer polygon");
  refuses({square, {{1, 1}, {7, 1}, {4, 7}}, {{4, 2}, {5, 2}, {4, 3}}},
          "holes[1][0] = (4, 2): must not be inside of holes[0]");
  CHECK_THROWS_AS(contact::triangulate_in_space<double>({}), std::invalid_argument);
  CHECK_THROWS_AS(contact::triangulate_in_space<double>({{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}}),
                  std::invalid_argument);
  CHECK_THROWS_AS(contact::triangulate_in_space<double>({{{0, 0, nan}, {1, 1, 1}, {2, 0, 2}}}),
                  std::invalid_argument);
}

TEST_CASE("a polygon in space has triangles with its own front") {
  Random random(505);
  const auto keeps = [](const Rings& all) { return Region<double>(all).valid(); };
  for (int i = 0; i < generators::tried(500); ++i) {
    const Rings flat = rings::on_grid(random, 8, keeps);
    const auto whole = [&random] {
      const int x = random.integer(-3, 3);
      const int y = random.integer(-3, 3);
      const int z = random.integer(-3, 3);
      return Vector3<double>(x, y, z);
    };
    const Vector3<double> u = whole();
    const Vector3<double> v = whole();
    if (u.cross(v).isZero(0)) continue;
    std::vector<SpacePolygon<double>> in_space;
    for (const Polygon<double>& ring : flat) {
      in_space.emplace_back();
      for (const Vector2<double>& p : ring) {
        in_space.back().push_back(Vector3<double>(5, -7, 2) + p.x() * u + p.y() * v);
      }
    }
    Triangles got = contact::triangulate_in_space(in_space);
    // In the plane's own coordinates, a clockwise outer ring has clockwise triangles.
    if (contact::area_sign(flat[0]) < 0) {
      for (auto& t : got) std::swap(t[1], t[2]);
    }
    REQUIRE(Region<double>(flat).fault(got) == "");
  }
}

TEST_CASE("a polygon in space that is not quite flat is triangulated in its main projection") {
  // Without z it would be vertical and thin.
  const std::vector<SpacePolygon<double>> rings{
      {{0, 0, 0}, {4, 0, 0x1p-50}, {4, 4, -0x1p-51}, {2, 1, 0}, {0, 4, 0x1p-52}}};
  CHECK(contact::triangulate_in_space(rings).size() == 3);
}

}  // namespace
