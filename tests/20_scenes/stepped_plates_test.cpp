// Thin plates, frusta and wedges as convex hulls: they rest on all their lowest vertices.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/frame.hpp>
#include <contact/pose.hpp>
#include <contact/scene/make_scene_run.hpp>
#include <contact/scene/scene_runs.hpp>
#include <contact/signed_distance.hpp>
#include <contact/stepped/hull_contact.hpp>
#include <vector>

#include "plan_scenes.hpp"
#include "stepped_scenes.hpp"

using contact::ContactManifold;
using contact::Scene;
using plan_scenes::Point;
using plan_scenes::run_of;

namespace {

/// Two rectangles, one above the other: a plate, a frustum or a pyramid that is cut off.
std::vector<Point> two_storeys(double lower, double upper, double height) {
  std::vector<Point> points;
  for (int k = 0; k < 8; ++k) {
    const double half = k & 4 ? upper : lower;
    points.emplace_back(k & 1 ? half : -half, k & 2 ? half : -half, k & 4 ? height : 0);
  }
  return points;
}

std::vector<Point> moved_by(std::vector<Point> points, const Point& by) {
  for (Point& p : points) p += by;
  return points;
}

ContactManifold<double> on_slab(const std::vector<Point>& body, const Point& half_lengths,
                                double margin) {
  const auto slab = two_storeys(1, 1, 1);
  std::vector<Point> points;
  for (const Point& p : slab) {
    points.emplace_back(p.x() * half_lengths.x(), p.y() * half_lengths.y(),
                        (p.z() - 1) * half_lengths.z());
  }
  const contact::ConvexHull<double> above{body, 0}, below{points, 0};
  return contact::face_contact(body, points, 0, contact::signed_distance(above, below), margin);
}

/// Whether the points are those at z = 0, each once.
bool are_at(const ContactManifold<double>& found, const std::vector<Point>& wanted) {
  const auto is_found = [&](const Point& p) {
    return std::count_if(found.points.begin(), found.points.end(), [&](const auto& point) {
             return (point.point - p).norm() < 1e-12 && std::abs(point.distance) < 1e-12;
           }) == 1;
  };
  return found.points.size() == wanted.size() &&
         std::all_of(wanted.begin(), wanted.end(), is_found);
}

}  // namespace

TEST_CASE("a plate, a frustum and a foot touch a floor with all vertices of their lower face") {
  for (const double lower : {0.5, 0.4, 0.6}) {
    for (const double height : {0.05, 0.002}) {
      auto body = two_storeys(lower, 0.5, height);
      const std::vector<Point> lowest(body.begin(), body.begin() + 4);
      for (int turn = 0; turn < 8; ++turn) {
        CAPTURE(lower, height, turn);
        CHECK(are_at(on_slab(body, Point(2, 2, 1), 0.001), lowest));
        std::reverse(body.begin(), body.end());
        CHECK(are_at(on_slab(body, Point(2, 2, 1), 0.001), lowest));
        std::reverse(body.begin(), body.end());
        std::rotate(body.begin(), body.begin() + 3, body.end());
      }
    }
  }
}

TEST_CASE("a plate that lies below another body touches it with all vertices of its upper face") {
  const auto plate = moved_by(two_storeys(0.5, 0.4, 0.05), Point(0, 0, -0.05));
  const auto lid = two_storeys(2, 2, 1);
  const contact::ConvexHull<double> above{lid, 0}, below{plate, 0};
  const auto found =
      contact::face_contact(lid, plate, 0, contact::signed_distance(above, below), 0.001);
  CHECK(are_at(found, {plate.begin() + 4, plate.end()}));
}

TEST_CASE("a frustum across a beam touches it where its lower edges cross the beam's") {
  const auto found = on_slab(two_storeys(0.4, 0.5, 0.05), Point(2, 0.125, 1), 0.001);
  CHECK(are_at(found, {Point(0.4, 0.125, 0), Point(-0.4, 0.125, 0), Point(0.4, -0.125, 0),
                       Point(-0.4, -0.125, 0)}));
}

TEST_CASE("a plate that rocks on an edge is given the vertices of its lower face as points") {
  auto plate = two_storeys(0.5, 0.5, 0.05);
  for (Point& p : plate) p = Point(p.x(), p.y(), p.z() + (p.x() + 0.5) / 64 + (p.y() + 0.5) / 128);
  const auto found = on_slab(plate, Point(2, 2, 1), 0.125);
  REQUIRE(found.points.size() == 4);
  double sum = 0;
  for (const auto& point : found.points) sum += point.distance;
  CHECK(std::abs(sum - 4 * (0.5 / 64 + 0.5 / 128)) < 1e-12);
}

TEST_CASE("a wedge on its edge touches a floor at two points, a pyramid on its tip at one") {
  const std::vector<Point> wedge{Point(-0.5, 0, 0), Point(0.5, 0, 0),  Point(0.5, 1, 1),
                                 Point(-0.5, 1, 1), Point(0.5, -1, 1), Point(-0.5, -1, 1)};
  CHECK(are_at(on_slab(wedge, Point(2, 2, 1), 0.125), {wedge[0], wedge[1]}));
  const auto tip = two_storeys(0, 0.5, 0.5);
  CHECK(are_at(on_slab({tip.begin() + 3, tip.end()}, Point(2, 2, 1), 0.125), {tip[3]}));
}

TEST_CASE("two closest points that are deeper than all vertices are among the points") {
  const auto plate = two_storeys(0.5, 0.5, 0.05);
  const auto floor = moved_by(two_storeys(2, 2, 1), Point(0, 0, -1));
  const Point deep(0.25, 0, -0.0625);
  const contact::SignedDistance<double> gap{-0.0625, Point::UnitZ(), deep, Point(0.25, 0, 0)};
  const auto found = contact::face_contact(plate, floor, 0, gap, 0.001);
  REQUIRE(found.points.size() == 5);
  CHECK(found.points.back().distance == -0.0625);
}

TEST_CASE("plates and frusta that fall obliquely onto a box come to rest level on it") {
  for (const double lower : {0.5, 0.4}) {
    for (const bool reversed : {false, true}) {
      contact::HullShape shape{moved_by(two_storeys(lower, 0.5, 0.0625), Point(0, 0, -0.03125))};
      if (reversed) std::reverse(shape.points.begin(), shape.points.end());
      Scene scene = stepped_scenes::with_gravity(0, 0.5, 1, 1e-6);
      plan_scenes::wall(scene, Point::UnitZ(), 0);
      plan_scenes::add(scene, contact::BoxShape{Point(2, 2, 0.5)}, 30, {0, 0, 0.5});
      plan_scenes::add(scene, shape, 1, {0, 0, 1.25});
      scene.bodies.back().angular_velocity = Point(0.5, 0.25, 0);
      auto run = run_of(scene);
      run->advance(1);
      const auto frame = contact::frame_of<double>({run->position(2), run->orientation(2)});
      for (const Point& p : shape.points) {
        CAPTURE(lower, reversed, p.x(), p.y(), p.z());
        const double above = contact::position_in_world(frame, p).z() - 1;
        CHECK(std::abs(above - (p.z() + 0.03125)) < 1e-5);
      }
    }
  }
}
