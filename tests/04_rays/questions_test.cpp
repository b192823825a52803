#include "support/questions.hpp"

#define CONTACT_FIGURE_NO_MAIN
#include <array>
#include <cmath>
#include <contact/ball_box.hpp>
#include <contact/figure.hpp>
#include <contact/first_in_scene.hpp>
#include <contact/ray_box.hpp>
#include <contact/ray_cone.hpp>
#include <contact/ray_cylinder.hpp>
#include <contact/ray_sphere.hpp>
#include <limits>

namespace slabs_figure {
#include "figures/slabs.cpp"
}

namespace questions_test {

namespace {

using contact::Aabb;
using contact::Ray;
using contact::Sphere;
using contact::Vector3;

const Sphere<double> ball{{5, 3, 0}, 5};

Ray<double> along_x(double length) { return {{0, 0, 0}, {length, 0, 0}}; }

}  // namespace

KEY("into-a-ball") { return contact::passage(along_x(1), ball).value().entry; }

KEY("direction-of-length-two") { return contact::passage(along_x(2), ball).value().entry; }

KEY("one-root-behind") {
  const Ray<double> ray{{0, 0, 0}, {1, 0, 0}};
  const Sphere<double> around{{0.5, 0, 0}, 2.5};
  const auto line = contact::passage(ray, around).value();
  CHECK(line.entry == -2);
  CHECK(line.exit == 3);
  const auto hit = contact::first_hit(ray, around);
  if (!hit) return 3;
  return hit->t == 0 && hit->inside ? 2 : (hit->t == 3 ? 0 : 1);
}

KEY("digits-of-the-radius") {
  // The last distance at which r² changes c, found from far to near among powers of 2^(1/16).
  float distance = 1e9F;
  const auto changes = [](float m) {
    const float square = m * m;
    const float c = square - 1.0F;
    return c != square;
  };
  while (!changes(distance)) distance *= 0.957603F;
  const std::array options{60.0, 5e3, 2e7, 3e8};
  int nearest = 0;
  for (int i = 0; i < 4; ++i) {
    const auto off = [&](int k) {
      return std::abs(std::log(options.at(static_cast<std::size_t>(k)) / double(distance)));
    };
    if (off(i) < off(nearest)) nearest = i;
  }
  return nearest;
}

KEY("why-the-nearest-point") {
  // A ball of radius 1, half a radius beside the line: the error of the entry, at growing distance.
  const auto worst = [](auto passage_by) {
    double error = 0;
    for (int k = 1; k <= 6; ++k) {
      const Ray<double> ray{{-std::pow(10.0, k), 0.3, 0.1}, {1, 0, 0}};
      const Sphere<double> unit{{0, 0, 0}, 1};
      const auto found = passage_by(ray, unit);
      const auto right = contact::passage(ray, unit);
      if (!found) return std::numeric_limits<double>::infinity();
      error = std::max(error, std::abs(found->entry - right->entry));
    }
    return error;
  };
  const double squares =
      worst([](const auto& r, const auto& s) { return contact::passage_by_lecture(r, s); });
  const double nearest =
      worst([](const auto& r, const auto& s) { return contact::passage_by_nearest_point(r, s); });
  return questions::Claim{nearest < 1e-9, squares < 1e-9};
}

KEY("which-root-cancels") {
  const float half = 100.0F, root = std::sqrt(half * half - 1.0F);
  const double exact_root = std::sqrt(9999.0);
  const auto lost = [](double got, double exact) { return std::abs(got - exact) / exact > 1e-5; };
  const bool larger = lost(half + root, 100 + exact_root);
  const bool smaller = lost(half - root, 1 / (100 + exact_root));
  if (larger && smaller) return 2;
  if (!larger && !smaller) return 3;
  return larger ? 0 : 1;
}

KEY("latest-entry") {
  const Aabb<double> box{{4, 1, -1}, {8, 5, 1}};
  return contact::passage(Ray<double>{{0, 0, 0}, {2, 1, 0}}, box).value().entry;
}

KEY("slabs-apart") {
  // The times as distances: a direction of ones, and a box from the times of entry and exit.
  const Aabb<double> box{{1, 2, 4}, {3, 6, 5}};
  const auto hit = contact::first_hit(Ray<double>{{0, 0, 0}, {1, 1, 1}}, box);
  if (!hit) return 2;
  return hit->t == 4 ? 0 : (hit->t == 1 ? 1 : 3);
}

KEY("zero-times-infinity") {
  const double zero = 0;
  const double found = (2.0 - 2.0) * (1 / zero);
  if (std::isnan(found)) return 2;
  return std::isinf(found) ? 1 : 0;
}

KEY("branchless-wrong") {
  slabs_figure::Input in{};
  in.low = {-1, -1}, in.high = {1, 1};
  in.z = {-1, 1, 0, 0};
  in.method = 2;
  in.divided = 1;
  in.origin = {1, -3}, in.through = {1, 0};  // in the plane of the right face
  const double winning = slabs_figure::compute(in).says_wrongly;
  in.origin.x() = in.through.x() = 0;
  return questions::Construct{winning, slabs_figure::compute(in).says_wrongly};
}

KEY("into-a-cylinder") {
  const contact::Cylinder<double> tube{{{0, 0, 0}, {0, 1, 0}}, 3};
  const Ray<double> ray{{-5, 7, 0}, {1, 2, 0}};
  const auto found = contact::passage_of_infinite_cylinder(ray, tube).value();
  CHECK(std::abs(found.exit - 8) < 1e-9);
  return found.entry;
}

KEY("along-the-axis") {
  // Without the part along the axis nothing of the direction is left; inside, c is negative.
  const Vector3<double> axis(0, 1, 0), direction(0, 2, 0), m(1, -7, 1);
  const Vector3<double> across = direction - axis * axis.dot(direction);
  const Vector3<double> off = m - axis * axis.dot(m);
  const double a = across.dot(across), b = across.dot(off), c = off.dot(off) - 9;
  const contact::Cylinder<double> capped{{{0, 0, 0}, {0, 4, 0}}, 3};
  const auto found = contact::passage(Ray<double>{m, direction}, capped);
  CHECK(found.has_value());
  return a == 0 && b == 0 && c < 0 ? 2 : (found ? 0 : 1);
}

KEY("mirror-of-a-cone") {
  // A steep line past the apex of a cone about the y axis: the samples that are in the nappe.
  const contact::Cone<double> cone{{0, 0, 0}, {0, 1, 0}, 1};
  const Ray<double> ray{{0.5, 0, 0}, {0.1, 1, 0}};
  const auto roots = contact::passage_of_double_cone(ray, cone).value();
  const auto in_nappe = [&](double t) {
    const Vector3<double> x = ray.origin + t * ray.direction;
    return x.y() >= 0 && x.x() * x.x() + x.z() * x.z() <= x.y() * x.y();
  };
  CHECK((ray.origin + roots.entry * ray.direction).y() < 0);
  const double span = roots.exit - roots.entry;
  int between = 0, beyond = 0;
  for (int k = 1; k < 100; ++k) {
    if (in_nappe(roots.entry + span * k / 100)) ++between;
    if (in_nappe(roots.exit + k)) ++beyond;
  }
  if (between > 0) return 0;
  return beyond == 99 ? 1 : (beyond == 0 ? 2 : 3);
}

KEY("past-an-edge") {
  const Aabb<double> box{{-4, -4, -9}, {0, 0, 9}};
  const contact::Segment<double> path{{0.9, 0.9, -3}, {0.9, 0.9, 3}};
  CHECK_FALSE(contact::ball_hits_box(path, 1.0, box));
  CHECK(contact::ball_hits_enlarged_box(path, 1.0, box).has_value());
  // The radius from which it touches, by bisection.
  double misses = 0, touches = 4;
  for (int i = 0; i < 50; ++i) {
    const double middle = (misses + touches) / 2;
    (contact::ball_hits_box(path, middle, box) ? touches : misses) = middle;
  }
  return touches;
}

KEY("share-of-the-bullets") {
  // A thousand walls, each a thousandth of a frame's way further: which of them a frame sees.
  const double way = 900.0 / 60;
  int seen = 0;
  for (int k = 0; k < 1000; ++k) {
    const double front = 100 + (k + 0.5) * way / 1000;
    const std::array<contact::Primitive<double>, 1> wall{
        Aabb<double>{{front, -9, -9}, {front + 0.3, 9, 9}}};
    if (contact::bullet_by_samples<double>({0, 0, 0}, {way, 0, 0}, 20, wall)) ++seen;
    CHECK(contact::bullet_by_segments<double>({0, 0, 0}, {way, 0, 0}, 20, wall).has_value());
  }
  return seen / 10.0;
}

KEY("the-first-of-a-scene") {
  return questions::only_order(
      {{"first", {"kept"}}, {"segment", {}}, {"kept", {"passages"}}, {"passages", {"segment"}}});
}

KEY("what-a-ray-leaves-out") {
  // A ball that passes an edge: it touches the box, and the segment of its centre does not.
  const Aabb<double> box{{-1, -1, -1}, {0, 0, 1}};
  const contact::Segment<double> path{{0.005, 0.005, -3}, {0.005, 0.005, 3}};
  const bool ball_hits = contact::ball_hits_box(path, 0.01, box);
  const bool segment_hits = contact::hits_box(path, box);
  // A wall that moves: at every time between 0 and 1 the point is in front of where the wall was.
  const contact::Segment<double> rests{{2, 0, 0}, {2, 0, 0}};
  const contact::Segment<double> in_the_wall_frame{{2, 0, 0}, {-2, 0, 0}};
  const bool moving_hits = contact::hits_box(in_the_wall_frame, box);
  return ball_hits != segment_hits && moving_hits != contact::hits_box(rests, box) ? 1 : 0;
}

}  // namespace questions_test
