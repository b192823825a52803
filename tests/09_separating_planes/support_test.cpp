// The numbers of right answers are rounded by some 1e-12. Where one point alone is farthest, it is
// compared; elsewhere a point must be in the body and as far as the farthest one. The numbers of a
// question are chosen so that each mistake gives an answer of its own.
#include "support.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>
#include <support/shrinkable.hpp>

#include <09_separating_planes/supports_with_mistakes.hpp>

namespace {

using namespace contact::testing;
using exercise::Body;
using exercise::Cylinder;
using exercise::Ellipsoid;
using supports_with_mistakes::Box;
using supports_with_mistakes::Capsule;
using supports_with_mistakes::rotation;
using supports_with_mistakes::Sphere;
using supports_with_mistakes::Vector;
using supports_with_mistakes::Way;

constexpr double kTolerance = 1e-9;

/// Short directions are taken for zero.
Vector with_epsilon(const Body& body, const Vector& direction) {
  const bool is_short = direction.stableNorm() < 1e-8;
  return supports_with_mistakes::support_of(body, is_short ? Vector::Zero() : direction);
}

/// The square of the length is 0 or infinity.
Vector with_underflow(const Body& body, const Vector& direction) {
  const double square = direction.squaredNorm();
  const bool lost = square == 0 || std::isinf(square);
  return supports_with_mistakes::support_of(body, lost ? Vector::Zero() : direction);
}

/// A question for each kind of body: an answer for one kind says nothing about the others.
std::string_view question_about(const Body& body) {
  constexpr std::array<std::string_view, 5> kQuestions{
      "Which point of the sphere is farthest along the direction?",
      "Which point of the capsule is farthest along the direction?",
      "Which point of the box is farthest along the direction?",
      "Which point of the cylinder is farthest along the direction?",
      "Which point of the ellipsoid is farthest along the direction?"};
  return kQuestions[body.shape.index()];
}

/// One point alone must be farthest.
void check_point(const Body& body, const Vector& direction) {
  const auto with = [&](Way way) {
    return [&, way] { return supports_with_mistakes::support_of(body, direction, way); };
  };
  ask(question_about(body))
      .given("body", body)
      .given("direction", direction)
      .suspect("length-of-the-direction-added", with(Way::not_unit))
      .suspect("opposite-support", with(Way::opposite))
      .suspect("radius-left-out", with(Way::without_radius))
      .suspect("radius-one", with(Way::of_radius_one))
      .suspect("nearer-end-of-the-core", with(Way::at_the_nearer_end))
      .suspect("radius-along-the-core", with(Way::along_the_core))
      .suspect("caps-inside-the-core", with(Way::caps_inside))
      .suspect("body-axes-ignored", with(Way::without_axes))
      .suspect("rows-for-columns", with(Way::by_rows))
      .suspect("signs-of-the-world", with(Way::signs_of_the_world))
      .suspect("edges-for-half-lengths", with(Way::with_edges))
      .suspect("edges-for-half-lengths", with(Way::with_half_the_half))
      .suspect("cylinder-as-capsule", with(Way::as_capsule))
      .suspect("rim-too-near", with(Way::rim_too_near))
      .suspect("ellipsoid-scaled-once", with(Way::scaled_once))
      .suspect("direction-divided-by-the-scale", with(Way::divided))
      .suspect("short-direction-for-zero", [&] { return with_epsilon(body, direction); })
      .suspect("square-of-the-length-lost", [&] { return with_underflow(body, direction); })
      .suspect_if("division-by-zero", [](const Vector& got) { return !got.allFinite(); })
      .answer([&] { return exercise::support(body, direction); })
      .close_to(supports_with_mistakes::support_of(body, direction), within(kTolerance));
}

/// Any direction, also zero.
void check_any(const Body& body, const Vector& direction) {
  const Vector n = supports_with_mistakes::unit(direction);
  const double farthest = supports_with_mistakes::extent(body, n);
  ask("Which point of the body is farthest along the direction? Several are.")
      .given("body", body)
      .given("direction", direction)
      .suspect_if("division-by-zero", [](const Vector& got) { return !got.allFinite(); })
      .answer([&] { return exercise::support(body, direction); })
      .satisfies("is a point of the body, and no other point is more than 1e-9 farther",
                 [&](const Vector& got) {
                   return got.allFinite() &&
                          supports_with_mistakes::outside(body, got) <= kTolerance &&
                          n.dot(got) >= farthest - kTolerance;
                 });
}

void check_difference(const Body& first, const Body& second, const Vector& direction) {
  const auto of = [&](const Body& body, double sign) {
    return supports_with_mistakes::support_of(body, sign * direction);
  };
  ask("Which difference of a point of the first body and one of the second is farthest?")
      .given("first", first)
      .given("second", second)
      .given("direction", direction)
      .suspect("both-along-the-direction", [&] { return Vector(of(first, 1) - of(second, 1)); })
      .suspect("sum-for-difference", [&] { return Vector(of(first, 1) + of(second, -1)); })
      .suspect("sum-for-difference", [&] { return Vector(of(first, 1) + of(second, 1)); })
      .suspect("difference-exchanged", [&] { return Vector(of(second, 1) - of(first, -1)); })
      .suspect("opposite-support", [&] { return Vector(of(first, -1) - of(second, 1)); })
      .suspect("one-body-left-out", [&] { return of(first, 1); })
      .suspect("one-body-left-out", [&] { return Vector(-of(second, -1)); })
      .answer([&] { return exercise::support_of_difference(first, second, direction); })
      .close_to(of(first, 1) - of(second, -1), within(kTolerance));
}

Body sphere() { return {Sphere{{3, -7, 2}, 5}}; }
Body capsule() { return {Capsule{{{4, -2, 9}, {-6, 3, 1}}, 7}}; }
Body box() { return {Box{{5, 1, -3}, rotation(2, 1, -3, 1), {3, 7, 11}}}; }
Body cylinder() { return {Cylinder{{{4, -2, 9}, {-6, 3, 1}}, 7}}; }
Body ellipsoid() { return {Ellipsoid{{5, 1, -3}, rotation(2, 1, -3, 1), {3, 7, 11}}}; }

std::vector<Body> all_bodies() { return {sphere(), capsule(), box(), cylinder(), ellipsoid()}; }

}  // namespace

TEST_CASE("the farthest point of a sphere is its radius from the centre") {
  check_point(sphere(), {2, -3, 6});
  check_point(sphere(), {-1, 0, 0});
  check_point({Sphere{{0, 0, 0}, 1000}}, {4, 4, -7});
}

TEST_CASE("a capsule is a sphere at the farther end of its core") {
  check_point(capsule(), {2, -3, 6});
  check_point(capsule(), {-2, 3, -6});
  check_point(capsule(), {1, 0, 0});
  check_point({Capsule{{{0, 0, 0}, {0, 0, 9}}, 2}}, {3, -4, 1});
}

TEST_CASE("the farthest point of a box is a corner") {
  check_point(box(), {2, -3, 6});
  check_point(box(), {-7, 1, 2});
  check_point({Box{{1, 2, 3}, rotation(1, 0, 0, 0), {4, 5, 6}}}, {1, -1, 2});
  check_point({Box{{1, 2, 3}, rotation(3, 0, 0, 1), {4, 5, 6}}}, {1, 5, -2});
}

TEST_CASE("the farthest point of a cylinder is on the rim of a flat end") {
  check_point(cylinder(), {2, -3, 6});
  check_point(cylinder(), {-1, 9, 2});
  check_point({Cylinder{{{0, 0, 0}, {0, 0, 9}}, 2}}, {3, -4, 1});
  check_point({Cylinder{{{0, 0, 9}, {0, 0, 0}}, 2}}, {3, -4, 1});
}

TEST_CASE("the direction is scaled twice for an ellipsoid") {
  check_point(ellipsoid(), {2, -3, 6});
  check_point(ellipsoid(), {-7, 1, 2});
  check_point({Ellipsoid{{1, 2, 3}, rotation(1, 0, 0, 0), {4, 5, 60}}}, {1, -1, 2});
  check_point({Ellipsoid{{1, 2, 3}, rotation(3, 0, 0, 1), {1000, 1, 60}}}, {3, 4, 12});
}

TEST_CASE("a direction has any length") {
  for (const double length : {1e-20, 1e-250, 1e-170, 1e20, 1e170, 1e249, 1.0 / 7}) {
    for (const Body& body : all_bodies()) check_point(body, length * Vector(2, -3, 6));
  }
  check_point(sphere(), {1e-250, 1e250, 3});
  check_point(sphere(), {0, -1e-250, 0});
}

TEST_CASE("along the zero direction any point of the body is farthest") {
  for (const Body& body : all_bodies()) check_any(body, Vector::Zero());
}

TEST_CASE("of several farthest points any is right") {
  const Body along_z{Cylinder{{{0, 0, -4}, {0, 0, 9}}, 2}};
  check_any(along_z, {0, 0, 3});
  check_any(along_z, {0, 0, -3});
  check_any(along_z, {3, 4, 0});
  check_any({Capsule{{{0, 0, -4}, {0, 0, 9}}, 2}}, {3, 4, 0});
  check_any(cylinder(), {-10, 5, -8});
  check_any(cylinder(), {10, -5, 8});
  check_any(cylinder(), {1, 2, 0});
  check_any({Box{{1, 2, 3}, rotation(1, 0, 0, 0), {4, 5, 6}}}, {0, 0, -2});
  check_any({Box{{1, 2, 3}, rotation(3, 0, 0, 1), {4, 5, 6}}}, {4, 3, 0});
}

TEST_CASE("the difference of two bodies has the difference of opposite points") {
  check_difference(sphere(), capsule(), {2, -3, 6});
  check_difference(box(), cylinder(), {-7, 1, 2});
  check_difference(ellipsoid(), ellipsoid(), {1, 4, -2});
  for (const Body& first : all_bodies())
    for (const Body& second : all_bodies()) check_difference(first, second, {5, -3, 1});
}

TEST_CASE("random bodies have no point that is farther") {
  generators::Random random(seed(0));
  const auto judged = [](const Body& body, const Vector& n) {
    return supports_with_mistakes::is_body(body) && supports_with_mistakes::is_unique(body, n) &&
           n.cwiseAbs().maxCoeff() <= 1e6 && n == n.array().round().matrix();
  };
  const auto judged_pair = [&](const Body& first, const Body& second, const Vector& n) {
    return judged(first, n) && judged(second, n);
  };
  for (int asked = 0; asked < 200; ++asked) {
    const int size = asked % 3 == 0 ? 1000 : 9;
    const auto whole = [&](int limit) {
      const double x = random.integer(-limit, limit), y = random.integer(-limit, limit);
      return Vector(x, y, random.integer(-limit, limit));
    };
    const auto body = [&]() -> Body {
      const int kind = random.integer(0, 4);
      const Vector at = whole(size);
      const double radius = random.integer(1, size);
      if (kind == 0) return {Sphere{at, radius}};
      const Vector end = whole(size);
      if (kind == 1) return {Capsule{{at, end}, radius}};
      if (kind == 2) return {Cylinder{{at, end}, radius}};
      const int w = random.integer(1, 4), x = random.integer(-4, 4);
      const int y = random.integer(-4, 4), z = random.integer(-4, 4);
      const Vector half = end.cwiseAbs().cwiseMax(1);
      if (kind == 3) return {Box{at, rotation(w, x, y, z), half}};
      return {Ellipsoid{at, rotation(w, x, y, z), half}};
    };
    const Body first = body(), second = body();
    const Vector n = whole(asked % 2 == 0 ? 9 : 100);
    if (judged(first, n)) shrinkable(check_point, judged, first, n);
    if (judged_pair(first, second, n)) shrinkable(check_difference, judged_pair, first, second, n);
    if (supports_with_mistakes::is_body(first)) check_any(first, n);
  }
}
