// Whether a box contains a point is decided on the stored numbers, without rounding. The expected
// boxes are rounded by some 1e-12. Every test asks for several answers. The first questions each
// bring one mistake to light that no question before did, so that the mistake is known by it.
#include "fit_box.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>
#include <support/shrinkable.hpp>

#include <07_bounding_volumes/boxes_with_mistakes.hpp>

namespace {

using namespace contact::testing;
using namespace boxes_with_mistakes;

constexpr double kTolerance = 1e-9;
constexpr double kLimit = 1000;

bool is_close(const Box& a, const Box& b) {
  return a.axes.allFinite() && (a.axes - b.axes).cwiseAbs().maxCoeff() <= kTolerance &&
         (a.centre - b.centre).cwiseAbs().maxCoeff() <= kTolerance &&
         (a.half_lengths - b.half_lengths).cwiseAbs().maxCoeff() <= kTolerance;
}

/// Centre and axes are right, and each half length is up to 1.1 times as large, or 1 cm larger.
bool has_margin(const Box& got, const Box& right) {
  const Point more = got.half_lengths - right.half_lengths;
  const Point room = (right.half_lengths / 10).cwiseMax(Point::Constant(0.01));
  Box tight = got;
  tight.half_lengths = right.half_lengths;
  return is_close(tight, right) && more.minCoeff() >= -kTolerance && more.maxCoeff() > kTolerance &&
         (room - more).minCoeff() >= 0;
}

void check_box(const Axes& axes, const Points& vertices) {
  const Box right = fit_box(axes, vertices);
  const Range along = range(axes, vertices), along_rows = range(axes.transpose(), vertices);
  const Range in_world = range(Axes::Identity(), vertices);
  const Point middle = (along.low + along.high) / 2;
  ask("Which box with these axes contains the vertices?")
      .given("axes", axes)
      .given("vertices", vertices)
      .suspect("mean-for-centre", [&] { return around(axes, mean(vertices), vertices); })
      .suspect("mean-for-centre", [&] { return with_centre(right, mean(vertices)); })
      .suspect("rows-for-columns", [&] { return box_of(axes, along_rows); })
      .suspect("rows-for-columns",
               [&] { return with_axes(box_of(axes.transpose(), along_rows), axes); })
      .suspect("rows-for-columns", [&] { return with_centre(right, axes.transpose() * middle); })
      .suspect("edges-for-half-lengths",
               [&] {
                 return Box{right.centre, axes, 2 * right.half_lengths};
               })
      .suspect("maximum-from-zero", [&] { return fit_box(axes, vertices, Search::high_from_zero); })
      .suspect("origin-in-the-box", [&] { return fit_box(axes, vertices, Search::both_from_zero); })
      .suspect("low-excludes-high", [&] { return fit_box(axes, vertices, Search::by_else); })
      .suspect("centre-left-in-the-object", [&] { return with_centre(right, middle); })
      .suspect("corner-for-centre", [&] { return with_centre(right, axes * along.low); })
      .suspect("corner-for-centre", [&] { return with_centre(right, axes * along.high); })
      .suspect("symmetric-about-the-origin", [&] { return around(axes, Point::Zero(), vertices); })
      .suspect("world-box-for-object-box",
               [&] { return with_axes(box_of(Axes::Identity(), in_world), axes); })
      .suspect("world-box-for-object-box", [&] { return box_of(axes, in_world); })
      .suspect("axes-not-returned", [&] { return with_axes(right, Axes::Identity()); })
      .suspect("last-point-forgotten",
               [&] { return fit_box(axes, Points(vertices.begin(), vertices.end() - 1)); })
      .suspect_if("margin-too-large", [&](const Box& got) { return has_margin(got, right); })
      .answer([&] { return exercise::fit_box(axes, vertices); })
      .close_to(right, within(kTolerance));
}

void check_contains(const Axes& axes, const Points& vertices) {
  const Box right = fit_box(axes, vertices);
  ask("Which box with these axes contains each of the vertices, without rounding?")
      .given("axes", axes)
      .given("vertices", vertices)
      .suspect_if("points-missed-by-rounding", [&](const Box& got) { return is_close(got, right); })
      .answer([&] { return exercise::fit_box(axes, vertices); })
      .satisfies(
          "contains each vertex: |axis . (p - c)| <= h for the numbers as you return them, where "
          "they may be 1e-9 from those of the smallest box",
          [&](const Box& got) {
            return is_close(got, right) &&
                   contained::in_slabs(axes, got.centre, got.half_lengths, vertices);
          });
}

void check_planes(const Box& box) {
  const auto with = [&](auto face) { return [&box, face] { return faces(box, face); }; };
  using Plane = contact::Plane<double>;
  const Point c = box.centre;
  ask("In which planes are the faces of the box?")
      .given("box", box)
      .suspect("box-normals-inwards", with([=](const Point& n, const Point&, double h) {
                 return Plane{-n, -n.dot(c) - h};
               }))
      .suspect("centre-left-out", with([](const Point& n, const Point&, double h) {
                 return Plane{n, h};
               }))
      .suspect("opposite-face-same-plane", with([=](const Point& n, const Point& axis, double h) {
                 return Plane{n, n.dot(axis) * (axis.dot(c) + h)};
               }))
      .suspect("opposite-face-same-plane", with([=](const Point& n, const Point& axis, double h) {
                 return Plane{n, axis.dot(c) + h};
               }))
      .suspect("offset-sign", with([=](const Point& n, const Point&, double h) {
                 return Plane{n, -n.dot(c) - h};
               }))
      .suspect("edges-for-half-lengths", with([=](const Point& n, const Point&, double h) {
                 return Plane{n, n.dot(c) + 2 * h};
               }))
      .suspect("edges-for-half-lengths", with([=](const Point& n, const Point&, double h) {
                 return Plane{n, n.dot(c) + h / 2};
               }))
      .suspect("rows-for-columns", [&] { return faces(with_axes(box, box.axes.transpose())); })
      .answer([&] { return exercise::face_planes(box); })
      .close_to(faces(box), within(kTolerance));
}

void check_inside(const Box& box, const Point& point) {
  const bool right = is_inside(box, point);
  const Point along = box.axes.transpose() * (point - box.centre), &h = box.half_lengths;
  const auto all_within = [&](const Point& x, const Point& limit) {
    return (x.cwiseAbs() - limit).maxCoeff() <= 0;
  };
  ask("Is the point in the box?")
      .given("box", box)
      .given("point", point)
      .suspect("touching-rejected", [&] { return (along.cwiseAbs() - h).maxCoeff() < 0; })
      .suspect("three-faces-of-six", [&] { return (along - h).maxCoeff() <= 0; })
      .suspect("behind-one-face-is-inside",
               [&] { return (along - h).minCoeff() <= 0 || (-along - h).minCoeff() <= 0; })
      .suspect("centre-left-out", [&] { return all_within(box.axes.transpose() * point, h); })
      .suspect("rows-for-columns", [&] { return all_within(box.axes * (point - box.centre), h); })
      .suspect("axes-ignored", [&] { return all_within(point - box.centre, h); })
      .suspect("edges-for-half-lengths", [&] { return all_within(along, 2 * h); })
      .suspect("edges-for-half-lengths", [&] { return all_within(along, h / 2); })
      .suspect("absolute-epsilon", [&] { return all_within(along, h.array() + 1e-6); })
      .answer([&] { return exercise::is_inside(box, point); })
      .equals(right);
}

const Axes kOblique = rotation(2, 1, -3, 1);
const Axes kTurned = rotation(3, 0, 0, 1);
const Axes kSwapped = rotation(1, 1, 1, 1);  // x, y and z become y, z and x
// The first vertex is not extreme along any axis, and the origin is inside.
const Points kSeven{{1, -1, 0},  {12, 5, -9}, {-2, 16, 5}, {-13, -5, 8},
                    {9, -17, 9}, {3, 2, -30}, {-4, 2, 28}};

}  // namespace

TEST_CASE("the box has the given axes and contains the vertices") {
  check_box(kOblique, kSeven);
  check_box(kOblique, {{0, 1, 0}, {12, 5, -9}, {-2, 16, 5}, {-13, -5, 8}, {9, -17, 9}, {1, 2, -1}});
  check_box(kTurned, {{1, 2, 0}, {7, 0, -2}, {-4, 9, 5}, {5, -20, 1}, {-12, 3, 0}});
  check_box(kSwapped, {{0, 0, 1}, {7, -3, -2}, {-4, 9, 5}, {-5, 2, 4}});
  check_box(Axes::Identity(), {{0, 0, 1}, {7, -3, -2}, {-4, 9, 5}, {-5, 2, 4}});
  check_box(rotation(1, 2, 3, 4), {{0, 1, 0},
                                   {-1000, -1000, -1000},
                                   {1000, 1000, 1000},
                                   {1000, -1000, 999},
                                   {-998, 1000, -1000}});
}

TEST_CASE("coordinates along an axis may all be negative, and the first may be the largest") {
  check_box(kTurned, {{62, 70, 50}, {90, 80, 70}, {60, 95, 45}, {40, 51, 61}, {75, 50, 60}});
  check_box(kTurned,
            {{-62, -70, -50}, {-90, -80, -70}, {-60, -95, -45}, {-40, -51, -61}, {-75, -50, -40}});
  check_box(kTurned, {{90, 80, 70}, {60, 95, 50}, {40, 51, 61}, {55, 60, 60}});
  check_box(kOblique, {{40, 12, 30}, {2, 5, 8}, {-7, 3, 1}, {3, 3, 3}});
  check_box(Axes::Identity(), {{9, 9, 9}, {1, 2, 3}});
  check_box(Axes::Identity(), {{-9, -9, -9}, {-1, -2, -3}});
}

TEST_CASE("one vertex, equal ones and flat objects have a box") {
  check_box(kOblique, {{3, -1, 4}});
  check_box(kTurned, {{3, -1, 4}, {3, -1, 4}});
  check_box(kTurned, {{0, 0, 5}, {3, 1, 5}, {9, 3, 5}, {6, 2, 5}});
  check_box(kOblique, {{0, 0, 5}, {3, 1, 5}, {9, 3, 5}, {6, 2, 5}});
  check_box(Axes::Identity(), {{0, 0, 5}, {3, 1, 5}, {9, 3, 5}, {2, 8, 5}});
}

TEST_CASE("the box contains every vertex without rounding") {
  check_contains(kOblique, kSeven);
  check_contains(kTurned, {{1, 2, 3}, {7, 0, -2}, {4, 9, 5}, {5, -20, 1}, {2, 3, 0}});
  check_contains(kOblique, {{3, -1, 4}});
  check_contains(kTurned, {{0, 0, 5}, {3, 1, 5}, {9, 3, 5}, {6, 2, 5}});
  check_contains(rotation(1, 2, 3, 4), {{-1000, 999, -1000}, {1000, 1000, 998}, {997, -1000, 31}});
  check_contains(Axes::Identity(), {{1, 2, 3}, {7, 0, -2}});
}

TEST_CASE("normals of faces point outwards") {
  check_planes({{3, -7, 11}, kOblique, {5, 2, 8}});
  check_planes({{30, 20, 10}, kTurned, {1, 4, 9}});
  check_planes({{0, 0, 0}, kSwapped, {1, 2, 3}});
  check_planes({{-900, 1000, 1}, rotation(1, 2, 3, 4), {1000, 0, 1}});
}

TEST_CASE("a point inside is behind all six faces") {
  const Box of_the_world{{30, 20, -10}, Axes::Identity(), {15, 4, 9}};
  check_inside(of_the_world, {30, 20, -10});
  check_inside(of_the_world, {33, 23, -9});
  check_inside(of_the_world, {31, 35, -11});
  check_inside(of_the_world, {31, 5, -11});
  const Box turned{{30, 20, -10}, kTurned, {6, 1, 1}};
  check_inside(turned, {34.25, 17.5, -10});
  check_inside(turned, {35, 20.5, -10});
  check_inside(turned, {33.5, 23, -10.5});
  const Box box{{30, 20, -10}, kOblique, {15, 4, 9}};
  for (const double x : {-40.0, -20.0, -12.0, -5.0, 5.0, 12.0, 20.0, 40.0})
    for (int k = 0; k < 3; ++k) {
      const Point exact = box.centre + x * Point(box.axes.col(k));
      check_inside(box, (exact * 1024).array().round().matrix() / 1024);
    }
  check_inside(box, {0, 0, 0});
  check_inside({{1, 2, 3}, kSwapped, {2, 3, 10}}, {10, 3, 5});
  check_inside({{1, 2, 3}, kSwapped, {2, 3, 10}}, {2, 11, 3});
}

TEST_CASE("a point on a face counts, and one next to it is decided") {
  const double step = std::ldexp(1.0, -30);
  for (const Axes& axes : {Axes(Axes::Identity()), kSwapped}) {
    const Box box{{1, 2, 3}, axes, {4, 5, 6}};
    for (int k = 0; k < 3; ++k) {
      for (const double sign : {1.0, -1.0}) {
        const Point normal = sign * Point(axes.col(k));
        const Point face = box.centre + box.half_lengths[k] * normal;
        check_inside(box, face);
        check_inside(box, face + step * normal);
        check_inside(box, face - step * normal);
      }
    }
    check_inside(box, box.centre + axes * Point(4, -5, 6));
    check_inside(box, box.centre + axes * Point(4, -5 - step, 6));
  }
  check_inside({{1, 2, 3}, kSwapped, {0, 0, 0}}, {1, 2, 3});
  check_inside({{1, 2, 3}, kSwapped, {0, 0, 0}}, {1, 2 + step, 3});
}

TEST_CASE("random boxes agree with the stored numbers") {
  generators::Random random(seed(0));
  const auto judged = [](const Axes& axes, const Points& vertices) {
    return is_rotation(axes) && !vertices.empty() && contained::is_on_grid(vertices, 1, kLimit);
  };
  const auto judged_box = [](const Box& box) {
    return is_rotation(box.axes) && box.half_lengths.minCoeff() >= 0 &&
           contained::is_on_grid(Points{box.centre, box.half_lengths}, 1, kLimit);
  };
  const auto judged_point = [&](const Box& box, const Point& point) {
    return judged_box(box) && contained::is_on_grid(Points{point}, 1 << 30, 2 * kLimit) &&
           is_clear(box, point);
  };
  for (int asked = 0; asked < 250; ++asked) {
    const int size = asked % 2 == 0 ? 9 : 1000;
    const auto whole = [&](int limit) {
      const double x = random.integer(-limit, limit);
      const double y = random.integer(-limit, limit);
      return Point(x, y, random.integer(-limit, limit));
    };
    const int most = asked % 3 == 0 ? 1 : 6;
    const int w = random.integer(1, most), x = random.integer(-most, most);
    const int y = random.integer(-most, most), z = random.integer(-most, most);
    const Axes axes = rotation(w, x, y, z);
    Points vertices;
    const int count = random.integer(1, 9);
    while (static_cast<int>(vertices.size()) < count) vertices.push_back(whole(size));
    shrinkable(check_box, judged, axes, vertices);
    shrinkable(check_contains, judged, axes, vertices);
    const Box box{whole(size), axes, whole(size).cwiseAbs()};
    shrinkable(check_planes, judged_box, box);
    const Point point = whole(2 * size);
    if (judged_point(box, point)) shrinkable(check_inside, judged_point, box, point);
    const Point near_corner = box.centre + axes * box.half_lengths * random.uniform(0.5, 1.2);
    const Point rounded = (near_corner * 1024).array().round().matrix() / 1024;
    if (judged_point(box, rounded)) shrinkable(check_inside, judged_point, box, rounded);
  }
}
