// moving_triangles.hpp: moving vertices, faces and edges meet exactly when fractions say so.
#include <array>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/moving_triangles.hpp>
#include <contact/translating_impact.hpp>
#include <limits>
#include <optional>

#include "families_points.hpp"
#include "moving_truth.hpp"
#include "support/generators.hpp"
#include "support/oracle.hpp"

namespace {

using contact::FeatureImpact;
using contact::MovingEdge;
using contact::MovingTriangle;
using contact::MovingVertex;
using generators::Random;

using Corner = contact::Vector3<double>;
using MaybeImpact = std::optional<FeatureImpact<double>>;

/// The four moving points of a question, as a vertex and a face or as two edges.
struct Question {
  std::array<Corner, 4> start, end;
  bool edges = false;

  MaybeImpact answer() const {
    if (edges) {
      return contact::edge_edge_impact<double>({{start[0], start[1]}, {end[0], end[1]}},
                                               {{start[2], start[3]}, {end[2], end[3]}});
    }
    return contact::vertex_face_impact<double>(
        {start[0], end[0]}, {{start[1], start[2], start[3]}, {end[1], end[2], end[3]}});
  }
  std::optional<moving_truth::Root> truth() const {
    moving_truth::Four four;
    for (std::size_t i = 0; i < 4; ++i) {
      four.start[i] = oracle::exact(start[i]);
      four.displacement[i] = oracle::exact(end[i]) - oracle::exact(start[i]);
    }
    return edges ? moving_truth::edge_edge(four) : moving_truth::vertex_face(four);
  }
  Question times(double factor) const {
    Question scaled = *this;
    for (std::size_t i = 0; i < 4; ++i) {
      scaled.start[i] *= factor;
      scaled.end[i] *= factor;
    }
    return scaled;
  }
};

Question question(Random& random, families::Points family, bool edges) {
  const families::MovingPoints points = families::points(random, family, edges);
  return {points.start, points.end, edges};
}

Corner whole_corner(Random& random, int size) {
  return Corner{double(random.integer(-size, size)), double(random.integer(-size, size)),
                double(random.integer(-size, size))};
}

/// A question whose features certainly meet at `meeting`, a multiple of 1/16: positions then are
/// whole numbers with a common point at whole weights, and displacements are multiples of 16.
Question certain_meeting(Random& random, bool edges, double meeting) {
  std::array<Corner, 4> then, displacement;
  for (std::size_t i = 0; i < 4; ++i) {
    then[i] = whole_corner(random, 20) * 8;
    displacement[i] = whole_corner(random, 6) * 16;
  }
  const int first = random.integer(0, 8), second = random.integer(0, 8 - first);
  if (edges) {
    const Corner on_first = then[0] + (then[1] - then[0]) * (first / 8.0);
    const Corner on_second = then[2] + (then[3] - then[2]) * (random.integer(0, 8) / 8.0);
    const Corner by = on_second - on_first;
    then[0] += by;
    then[1] += by;
  } else {
    then[0] = then[1] + (then[2] - then[1]) * (first / 8.0) + (then[3] - then[1]) * (second / 8.0);
  }
  Question made;
  made.edges = edges;
  for (std::size_t i = 0; i < 4; ++i) {
    made.start[i] = then[i] - displacement[i] * meeting;
    made.end[i] = then[i] + displacement[i] * (1 - meeting);
  }
  return made;
}

bool encloses(const FeatureImpact<double>& found, moving_truth::Root& truth) {
  const double nearest = truth.nearest();  // at most half an ulp from the time
  return std::nextafter(nearest, 2.0) >= found.t && std::nextafter(nearest, -1.0) <= found.t_high;
}

}  // namespace

TEST_CASE("moving vertices, faces and edges meet if and only if fractions say so", "[moving]") {
  Random random(1101);
  for (const families::Points family : families::all_points) {
    for (int round = 0; round < generators::tried(80); ++round) {
      const Question asked = question(random, family, round % 2 == 1);
      const MaybeImpact found = asked.answer();
      std::optional<moving_truth::Root> truth = asked.truth();
      INFO(families::name(family) << ", round " << round);
      REQUIRE(found.has_value() == truth.has_value());
      if (found) CHECK(encloses(*found, *truth));
    }
  }
}

TEST_CASE("no meeting of moving features by construction is missed or found too late", "[moving]") {
  Random random(1102);
  for (int round = 0; round < generators::tried(10000); ++round) {
    const double meeting = random.integer(0, 16) / 16.0;
    const Question asked = certain_meeting(random, round % 2 == 1, meeting);
    const MaybeImpact found = asked.answer();
    INFO("round " << round);
    REQUIRE(found.has_value());
    REQUIRE(found->t <= meeting);
  }
}

TEST_CASE("bounds of a first meeting are close to each other", "[moving]") {
  Random random(1103);
  for (int round = 0; round < generators::tried(5000); ++round) {
    const Question asked = question(random, families::Points::random, round % 2 == 1);
    const MaybeImpact found = asked.answer();
    if (!found) continue;
    REQUIRE(found->t >= 0);
    REQUIRE(found->t <= found->t_high);
    REQUIRE(found->t_high <= 1);
    REQUIRE(found->t_high - found->t < 0x1p-20);
    REQUIRE_FALSE(std::signbit(found->t));
  }
}

TEST_CASE("moving features of any scale meet at the same time", "[moving]") {
  Random random(1104);
  for (const families::Points family : families::all_points) {
    for (int round = 0; round < generators::tried(16); ++round) {
      const Question asked = question(random, family, round % 2 == 1);
      const MaybeImpact found = asked.answer();
      for (const double factor : {0x1p-900, 0x1p-500, 0x1p500, 0x1p900}) {
        const MaybeImpact scaled = asked.times(factor).answer();
        INFO(families::name(family) << ", factor " << factor);
        REQUIRE(scaled.has_value() == found.has_value());
        if (found) CHECK((scaled->t <= found->t_high && found->t <= scaled->t_high));
      }
    }
  }
}

TEST_CASE("moving features with subnormal coordinates are decided", "[moving]") {
  constexpr double tiny = std::numeric_limits<double>::denorm_min();
  const MovingTriangle<double> face{
      {Corner(-tiny, -tiny, 0), Corner(tiny, -tiny, 0), Corner(0, tiny, 0)},
      {Corner(-tiny, -tiny, 0), Corner(tiny, -tiny, 0), Corner(0, tiny, 0)}};
  const auto through =
      contact::vertex_face_impact<double>({Corner(0, 0, tiny), Corner(0, 0, -3 * tiny)}, face);
  REQUIRE(through);
  CHECK(through->t <= 0.25);
  CHECK(through->t_high >= 0.25);
  CHECK_FALSE(contact::vertex_face_impact<double>(
      {Corner(tiny, tiny, tiny), Corner(tiny, tiny, -tiny)}, face));
}

TEST_CASE("displacements whose difference overflows are decided", "[moving]") {
  constexpr double huge = 0x1p1023;
  const MovingTriangle<double> face{
      {Corner(-huge, -huge, 0), Corner(huge, -huge, 0), Corner(0, huge, 0)},
      {Corner(-huge, -huge, 0), Corner(huge, -huge, 0), Corner(0, huge, 0)}};
  const auto through =
      contact::vertex_face_impact<double>({Corner(0, 0, huge), Corner(0, 0, -huge)}, face);
  REQUIRE(through);
  CHECK(through->t <= 0.5);
  CHECK(through->t_high >= 0.5);
}

TEST_CASE("moving features with a number that is not finite do not meet", "[moving]") {
  for (const double bad :
       {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    for (std::size_t i = 0; i < 8; ++i) {
      for (const bool edges : {false, true}) {
        Question asked;
        asked.edges = edges;
        for (std::size_t k = 0; k < 4; ++k) asked.start[k] = asked.end[k] = Corner::Zero();
        (i < 4 ? asked.start[i] : asked.end[i - 4]).y() = bad;
        CHECK_FALSE(asked.answer());
      }
    }
  }
}

TEST_CASE("features at rest that have a common point meet at the start", "[moving]") {
  Question asked;
  asked.start = {Corner(0.25, 0.25, 0), Corner(0, 0, 0), Corner(1, 0, 0), Corner(0, 1, 0)};
  asked.end = asked.start;
  const MaybeImpact on_face = asked.answer();
  REQUIRE(on_face);
  CHECK(on_face->t == 0);
  CHECK(on_face->t_high == 0);
  asked.edges = true;
  asked.start = {Corner(-1, 0, 0), Corner(1, 0, 0), Corner(0, 0, 0), Corner(3, 0, 0)};
  asked.end = asked.start;
  const MaybeImpact along_a_line = asked.answer();
  REQUIRE(along_a_line);
  CHECK(along_a_line->t_high == 0);
}

TEMPLATE_TEST_CASE("moving features in float meet when the same numbers in double do", "", float,
                   double) {
  using S = TestType;
  Random random(1105);
  for (int round = 0; round < generators::tried(2000); ++round) {
    const Question asked = certain_meeting(random, round % 2 == 1, random.integer(0, 16) / 16.0);
    const auto at = [](const Corner& x) { return contact::Vector3<S>(x.template cast<S>()); };
    const auto& [s, e, edges] = asked;
    const std::optional<FeatureImpact<S>> found =
        edges ? contact::edge_edge_impact<S>({{at(s[0]), at(s[1])}, {at(e[0]), at(e[1])}},
                                             {{at(s[2]), at(s[3])}, {at(e[2]), at(e[3])}})
              : contact::vertex_face_impact<S>(
                    {at(s[0]), at(e[0])},
                    {{at(s[1]), at(s[2]), at(s[3])}, {at(e[1]), at(e[2]), at(e[3])}});
    const MaybeImpact same = asked.answer();
    REQUIRE(found);
    REQUIRE(same);
    REQUIRE(double(found->t) <= same->t);
    REQUIRE(double(found->t_high) >= same->t_high);
  }
}

TEST_CASE("moving triangles that translate meet when convex bodies that translate do", "[moving]") {
  Random random(1106);
  int meetings = 0;
  for (int round = 0; round < generators::tried(1500); ++round) {
    const bool grid = round % 2 == 1;
    const auto draw = [&] {
      return grid ? whole_corner(random, 3)
                  : Corner{random.uniform(-2, 2), random.uniform(-2, 2), random.uniform(-2, 2)};
    };
    const contact::Triangle<double> a{draw(), draw(), draw()}, b{draw(), draw(), draw()};
    const Corner by = whole_corner(random, 4);
    const auto moved = [&by](const contact::Triangle<double>& at) {
      return contact::Triangle<double>{at.a + by, at.b + by, at.c + by};
    };
    // Only motions that are exact can be compared.
    const auto after = moved(a);
    if (after.a - by != a.a || after.b - by != a.b || after.c - by != a.c) continue;
    const auto found = contact::moving_triangles_impact<double>({a, after}, {b, b});
    const auto expected = contact::translating_impact(a, by, b, Corner(Corner::Zero()));
    INFO("round " << round);
    REQUIRE(found.has_value() == expected.meets);
    if (!found) continue;
    ++meetings;
    CHECK((found->t <= expected.t_high && expected.t <= found->t_high));
  }
  CHECK(meetings > generators::tried(300));
}

TEST_CASE("moving triangles that are in each other at the start meet there", "[moving]") {
  const contact::Triangle<double> flat{Corner(-4, -4, 0), Corner(4, -4, 0), Corner(0, 4, 0)};
  const contact::Triangle<double> through{Corner(0, 0, -1), Corner(0, 0, 3), Corner(0, 20, 3)};
  const auto found = contact::moving_triangles_impact<double>({flat, flat}, {through, through});
  REQUIRE(found);
  CHECK(found->t == 0);
  CHECK(found->t_high == 0);
}
