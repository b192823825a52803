// Convex hulls that meet balls, boxes, capsules and each other, step by step.
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/scene/make_scene_run.hpp>
#include <contact/scene/scene_runs.hpp>
#include <contact/stepped/hull_contact.hpp>
#include <vector>

#include "plan_scenes.hpp"
#include "stepped_scenes.hpp"

using contact::Scene;
using contact::SceneShape;
using plan_scenes::Point;
using plan_scenes::run_of;
using stepped_scenes::total_momentum;
using stepped_scenes::with_gravity;

namespace {

/// The corners of a box about the origin.
contact::HullShape box_as_hull(const Point& half_lengths) {
  contact::HullShape hull;
  for (int k = 0; k < 8; ++k) {
    const Point sign(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1);
    hull.points.emplace_back(sign.cwiseProduct(half_lengths));
  }
  return hull;
}

/// A regular tetrahedron about the origin.
contact::HullShape tetrahedron(double size) {
  return {{Point(size, size, size), Point(size, -size, -size), Point(-size, size, -size),
           Point(-size, -size, size)}};
}

/// Two bodies that move towards each other without gravity.
Scene two_bodies(const SceneShape& first, const SceneShape& second, const Point& beside) {
  Scene scene = plan_scenes::empty(0.5, 0.25, 1, 1e-9);
  plan_scenes::add(scene, first, 2, {-1, 0, 0}, {4, 0, 0});
  plan_scenes::add(scene, second, 1, Point(Point(1, 0, 0) + beside), {-4, 0, 0});
  return scene;
}

}  // namespace

TEST_CASE("a box stored as a hull hits other bodies as a box does") {
  const Point half(0.25, 0.375, 0.5);
  const contact::BoxShape box{half};
  const contact::HullShape hull = box_as_hull(half);
  const std::vector<SceneShape> others{contact::BallShape{0.25}, contact::CapsuleShape{0.25, 0.125},
                                       contact::BoxShape{Point(0.25, 0.25, 0.25)}};
  for (std::size_t i = 0; i < others.size(); ++i) {
    for (const Point& beside : {Point(0, 0, 0), Point(0, 0.1875, 0.125)}) {
      const auto with_box = run_of(two_bodies(box, others[i], beside));
      const auto with_hull = run_of(two_bodies(hull, others[i], beside));
      with_box->advance(0.5);
      with_hull->advance(0.5);
      CAPTURE(i, beside.y());
      REQUIRE(with_hull->counts().hits > 0);
      for (std::size_t b = 0; b < 2; ++b) {
        CHECK((with_hull->position(b) - with_box->position(b)).norm() < 1e-7);
        CHECK((with_hull->velocity(b) - with_box->velocity(b)).norm() < 1e-7);
        CHECK((with_hull->angular_velocity(b) - with_box->angular_velocity(b)).norm() < 1e-6);
      }
    }
  }
}

TEST_CASE("hulls that hit each other obliquely keep their momentum and gain no energy") {
  const contact::HullShape stone = tetrahedron(0.25);
  for (const Point& beside : {Point(0, 0.0625, 0.03125), Point(0, -0.125, 0.25)}) {
    const Scene scene = two_bodies(stone, stone, beside);
    auto run = run_of(scene);
    const Point momentum = total_momentum(scene, *run);
    const double energy = run->energy();
    run->advance(1);
    CAPTURE(beside.y());
    REQUIRE(run->counts().hits > 0);
    CHECK((total_momentum(scene, *run) - momentum).norm() < 1e-12);
    CHECK(run->energy() < energy);
    CHECK(run->counts().largest_overlap < 1e-9);
  }
}

TEST_CASE("a stack of hulls on a box comes to rest face on face, as a stack of boxes does") {
  const Point half(0.25, 0.25, 0.125);
  std::vector<Point> of_boxes;
  for (const bool hulls : {false, true}) {
    const SceneShape box = contact::BoxShape{half};
    const SceneShape shape = hulls ? SceneShape(box_as_hull(half)) : box;
    Scene scene = with_gravity(0, 0.5, 1, 1e-6);
    plan_scenes::wall(scene, Point::UnitZ(), 0);
    plan_scenes::add(scene, box, 3, {0, 0, 0.125});
    plan_scenes::add(scene, shape, 2, {0.0625, 0, 0.5});
    plan_scenes::add(scene, shape, 1, {0, 0.0625, 1});
    auto run = run_of(scene);
    run->advance(1);
    for (std::size_t b = 1; b < 4; ++b) {
      CAPTURE(hulls, b);
      CHECK(std::abs(run->position(b).z() - (0.25 * double(b) - 0.125)) < 1e-6);
      if (!hulls) of_boxes.push_back(run->position(b));
      if (hulls) CHECK((run->position(b) - of_boxes[b - 1]).norm() < 1e-3);
    }
  }
}

TEST_CASE("a fast hull does not pass a thin hull") {
  Scene scene = plan_scenes::empty(0, 0, 1, 1e-6);
  plan_scenes::add(scene, box_as_hull(Point(0.001, 0.5, 0.5)), 5, {0, 0, 0});
  plan_scenes::add(scene, tetrahedron(0.05), 1, {-10, 0, 0}, {800, 0, 0});
  auto run = run_of(scene);
  run->advance(0.05);
  CHECK(run->counts().hits > 0);
  CHECK(run->position(1).x() < run->position(0).x());
}

TEST_CASE("two faces of hulls meet at the corners of their common part") {
  const Point up = Point::UnitZ();
  const contact::SignedDistance<double> gap{0.25, up, Point(0, 0, 0.25), Point(0, 0, 0)};
  const auto square = [](double x, double y, double z, double half) {
    return std::vector<Point>{Point(x - half, y - half, z), Point(x + half, y - half, z),
                              Point(x + half, y + half, z), Point(x - half, y + half, z),
                              Point(x, y, z * 8)};
  };
  const auto found =
      contact::face_contact(square(1, 1, 0.25, 1), square(0, 0, -0.0, 1), 0, gap, 0.5);
  REQUIRE(found.points.size() == 4);
  for (const auto& point : found.points) {
    CHECK(std::abs(point.distance - 0.25) < 1e-15);
    CHECK(std::abs(point.point.z() - 0.125) < 1e-15);
    CHECK(std::abs(std::abs(point.point.x() - 0.5) - 0.5) < 1e-15);
    CHECK(std::abs(std::abs(point.point.y() - 0.5) - 0.5) < 1e-15);
  }
  CHECK(contact::face_contact(square(1, 1, 0.25, 1), square(0, 0, 0, 1), 0, gap, 0.125)
            .points.empty());
}

TEST_CASE("an edge over a face meets it at two points, crossing edges at one") {
  const contact::SignedDistance<double> gap{0, Point::UnitZ(), Point::Zero(), Point::Zero()};
  const std::vector<Point> face{Point(-1, -1, 0), Point(1, -1, 0), Point(1, 1, 0), Point(-1, 1, 0),
                                Point(0, 0, -1)};
  const std::vector<Point> edge{Point(-4, 0.5, 0), Point(0.5, 0.5, 0), Point(0, 0, 3)};
  const auto two = contact::face_contact(edge, face, 0, gap, 0.125);
  REQUIRE(two.points.size() == 2);
  CHECK(std::abs(two.points[0].point.x() + two.points[1].point.x() + 0.5) < 1e-14);
  const std::vector<Point> crossing{Point(0, -1, 0), Point(0, 1, 0), Point(0, 0, -3)};
  CHECK(contact::face_contact(edge, crossing, 0, gap, 0.125).points.size() == 1);
}
