#include "support/questions.hpp"

#define CONTACT_FIGURE_NO_MAIN
#include <algorithm>
#include <array>
#include <cmath>
#include <contact/box_around.hpp>
#include <contact/carried_volumes.hpp>
#include <contact/enclosing_radius.hpp>
#include <contact/figure.hpp>
#include <contact/grown_sphere.hpp>
#include <contact/hull_2d.hpp>
#include <contact/measured_shapes.hpp>
#include <contact/perimeter.hpp>
#include <contact/principal_axes.hpp>
#include <contact/sine_cosine.hpp>
#include <contact/slab_volumes.hpp>
#include <contact/smallest_circle.hpp>
#include <contact/smallest_sphere.hpp>
#include <contact/sphere_of_spheres.hpp>
#include <contact/volume_kinds.hpp>
#include <contact/volumes_meet.hpp>
#include <span>
#include <string_view>
#include <vector>

namespace two_bodies_figure {
#include "figures/two_bodies.cpp"
}

namespace questions_test {

namespace {

using contact::Sphere;
using contact::Vector3;
using Points = std::vector<Vector3<double>>;
using Span = std::span<const Vector3<double>>;

Vector3<double> at(double x, double y, double z) { return {x, y, z}; }

Sphere<double> smallest(const Points& points) {
  return contact::smallest_sphere(Span(points)).sphere;
}

/// A rod of length 2 without thickness, at a distance from the first.
Points rod(double aside) { return {at(-1, aside, 0), at(1, aside, 0)}; }

/// The frame that turns by 45° about z: both entries are √½, rounded.
contact::CoordinateFrame<double> turned_by_an_eighth() {
  const double half = std::sqrt(0.5);
  contact::CoordinateFrame<double> frame;
  frame.axes << half, -half, 0, half, half, 0, 0, 0, 1;
  return frame;
}

}  // namespace

KEY("rods-side-by-side") {
  CHECK(contact::may_meet(smallest(rod(0)), smallest(rod(2))));
  CHECK_FALSE(contact::may_meet(smallest(rod(0)), smallest(rod(2 + 1e-12))));
  return 2 * smallest(rod(0)).radius;
}

KEY("grow-once") {
  const Points points{at(3, 0, 0), at(-3, 0, 0), at(0, 3, 0)};
  const Sphere<double> before = contact::sphere_grown_as_given(Span(points));
  CHECK(before.radius == 3);
  const Sphere<double> after = contact::enclosing_sphere(before, Sphere<double>{at(5, 0, 0), 0});
  CHECK(after.centre == at(1, 0, 0));
  return after.radius;
}

KEY("centroid-of-vertices") {
  Points points(9, at(0, 0, 0));
  points.push_back(at(10, 0, 0));
  CHECK(smallest(points).radius == 5);
  return contact::centroid_sphere(Span(points)).radius;
}

KEY("obtuse-triangle") {
  const double x = (36.0 + 9 - 16) / 12;
  const Points points{at(0, 0, 0), at(6, 0, 0), at(x, std::sqrt(9 - x * x), 0)};
  CHECK(std::abs((points[2] - points[1]).norm() - 4) < 1e-12);
  CHECK(contact::smallest_sphere(Span(points)).support_count == 2);
  return smallest(points).radius;
}

KEY("why-it-ends") {
  // A point outside makes the smallest sphere larger, one inside does not.
  const Points pair{at(-1, 0, 0), at(1, 0, 0)};
  const auto grows = [&](const Vector3<double>& point) {
    Points more = pair;
    more.push_back(point);
    return smallest(more).radius > smallest(pair).radius;
  };
  return questions::Claim{grows(at(0, 1.5, 0)), grows(at(0, 0.5, 0))};
}

KEY("outside-its-own") {
  // The lecture's sphere of some points, and a point body exactly at the one that it misses.
  int missed = 0;
  for (int n = 0; n < 50; ++n) {
    Points points;
    for (int i = 0; i < 6; ++i) {
      points.push_back(at((7 * n + 3 * i) % 11, (5 * n + i * i) % 13, (n + 2 * i) % 7) / 10);
    }
    const Sphere<double> given = contact::sphere_grown_as_given(Span(points));
    for (const Vector3<double>& p : points) {
      const Sphere<double> touching{p, 0};
      if (!contact::contains(given, p) && !contact::may_meet(given, touching)) ++missed;
      CHECK(contact::may_meet(contact::grown_sphere(Span(points)), touching));
    }
  }
  return missed > 0 ? 0 : 1;
}

KEY("inner-vertices") {
  Points plain, divided;
  for (int k = 0; k < 8; ++k) {
    plain.push_back(at((k & 1) != 0 ? 4 : 0, (k & 2) != 0 ? 2 : 0, (k & 4) != 0 ? 1 : 0));
  }
  divided = plain;
  for (int i = 0; i < 1000; ++i) divided.push_back(at(i % 10, i / 10 % 10, i / 100) / 64);
  std::vector<int> changed;
  const auto box = contact::aabb_of_points(Span(plain)),
             other = contact::aabb_of_points(Span(divided));
  if (box.low != other.low || box.high != other.high) changed.push_back(0);
  if (smallest(plain).radius != smallest(divided).radius) changed.push_back(1);
  const auto half = [](const Points& points) {
    return contact::principal_box(Span(points)).half_lengths.prod();
  };
  if (half(divided) > 1.01 * half(plain)) changed.push_back(2);
  const auto normals = contact::kdop_normals<double>(14);
  const auto dop = contact::kdop_of_points(normals, Span(plain));
  const auto other_dop = contact::kdop_of_points(normals, Span(divided));
  if (dop.low != other_dop.low || dop.high != other_dop.high) changed.push_back(3);
  CHECK(changed.size() == 1);
  return changed.front();
}

KEY("diagonal-slab") {
  const Points square{at(0, 0, 0), at(2, 0, 0), at(2, 2, 0), at(0, 2, 0)};
  const auto dop = contact::kdop_of_points({at(1, 1, 0)}, Span(square));
  CHECK(dop.high[0] - dop.low[0] == 4);
  return (dop.high[0] - dop.low[0]) / dop.normals[0].norm();
}

KEY("fourteen-overlaps") {
  // Two segments whose 14-DOPs overlap in all seven directions, and a plane between the 14-DOPs.
  const auto normals = contact::kdop_normals<double>(14);
  const Points one{at(9, 7, 18), at(3, 19, -17)}, two{at(5, -19, 18), at(18, 13, 13)};
  const auto a = contact::kdop_of_points(normals, Span(one));
  const auto b = contact::kdop_of_points(normals, Span(two));
  CHECK(contact::may_meet(a, b));
  double first = -1e300, second = 1e300;
  for (const auto& v : contact::kdop_vertices(a)) first = std::max(first, at(3, -4, 0).dot(v));
  for (const auto& v : contact::kdop_vertices(b)) second = std::min(second, at(3, -4, 0).dot(v));
  return first < second - 1 ? 1 : 0;
}

KEY("boxed-again") {
  contact::Aabb<double> box{at(-1, -1, -1), at(1, 1, 1)};
  for (int step = 0; step < 3; ++step) box = contact::aabb_of_carried(box, turned_by_an_eighth());
  return box.high.x();
}

KEY("sagitta-of-a-turn") { return 1 - std::sqrt(0.5); }

KEY("make-hulls-fail") {
  // A rod in the notch of an L, and far from it.
  two_bodies_figure::Input in{};
  in.a = {0, 0};
  in.b = {0.4, 1};
  in.turn_a = {1, 0};
  in.turn_b = {0, 1};
  in.shape_a = 2;
  in.shape_b = 1;
  const double winning = two_bodies_figure::compute(in).hulls_wrong;
  in.b = {5, 5};
  return questions::Construct{winning, two_bodies_figure::compute(in).hulls_wrong};
}

KEY("which-for-the-rod") {
  using contact::VolumeKind;
  for (const auto& shape : contact::measured_shapes()) {
    if (std::string_view(shape.name) != "rod") continue;
    const Points& points = shape.mesh.vertices;
    const std::array kinds{VolumeKind::smallest_sphere, VolumeKind::aabb, VolumeKind::dop_26,
                           VolumeKind::smallest_box};
    std::array<double, 4> volumes{};
    for (std::size_t i = 0; i < 4; ++i) {
      volumes[i] = contact::volume(contact::bounding_volume(kinds[i], Span(points)));
    }
    const auto least = std::min_element(volumes.begin(), volumes.end());
    return static_cast<int>(least - volumes.begin());
  }
  return -1;
}

KEY("numbers-to-store") {
  const auto normals = contact::kdop_normals<double>(18);
  return questions::Gaps{{"sphere", sizeof(Sphere<double>) / sizeof(double)},
                         {"dop", 2 * static_cast<double>(normals.size())},
                         {"obb", sizeof(contact::OrientedBox<double>) / sizeof(double)}};
}

}  // namespace questions_test
