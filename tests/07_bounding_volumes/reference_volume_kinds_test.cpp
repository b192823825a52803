#include <07_bounding_volumes/carried_truth.hpp>
#include <07_bounding_volumes/volume_families.hpp>
#include <algorithm>
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/volume_kinds.hpp>
#include <limits>
#include <numbers>
#include <set>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

namespace volume_kinds_test {

using carried_truth::any_frame;
using carried_truth::image;
using contact::all_volume_kinds;
using contact::bounding_volume;
using contact::BoundingVolume;
using contact::carried;
using contact::CoordinateFrame;
using contact::Kdop;
using contact::may_meet;
using contact::MeshTree;
using contact::name_of;
using contact::Sphere;
using contact::volume;
using contact::VolumeKind;
using generators::Random;
using volume_families::Family;
using Point = contact::Vector3<double>;
using Points = std::vector<Point>;

Family family_of(int i) {
  return volume_families::all[static_cast<std::size_t>(i) % volume_families::all.size()];
}
Points drawn(Random& random, int i, int count) {
  return volume_families::points<double>(random, family_of(i), count);
}
/// Whether a point, as a fraction, is in a volume; a stored one in a hull.
bool inside(const BoundingVolume& bounding, const oracle::Vector& exact, const Point& stored) {
  return std::visit(
      [&]<class V>(const V& shape) {
        if constexpr (std::is_same_v<V, MeshTree<double>>) {
          return contact::locate_in_mesh(stored, shape).where != contact::Where::outside;
        } else {
          return carried_truth::inside(shape, exact);
        }
      },
      bounding.shape);
}

TEST_CASE("a volume of every kind contains the points that made it") {
  Random random(1);
  for (int i = 0; i < generators::tried(88); ++i) {
    const Points points = drawn(random, i, 16);
    for (const VolumeKind kind : all_volume_kinds) {
      INFO(name_of(kind) << ", " << volume_families::name(family_of(i)) << ", set " << i);
      const BoundingVolume made = bounding_volume(kind, points);
      for (const Point& p : points) REQUIRE(inside(made, oracle::exact(p), p));
    }
  }
}

TEST_CASE("a carried volume of every kind but the hull contains the exact images") {
  Random random(2);
  for (int i = 0; i < generators::tried(88); ++i) {
    const Points points = drawn(random, i, 12);
    const auto frame = any_frame<double>(random);
    for (const VolumeKind kind : all_volume_kinds) {
      if (kind == VolumeKind::hull) continue;
      INFO(name_of(kind) << ", " << volume_families::name(family_of(i)) << ", set " << i);
      const BoundingVolume made = carried(bounding_volume(kind, points), frame);
      const BoundingVolume again = carried(made, frame);
      for (const Point& p : points) {
        const oracle::Vector once = image(frame, oracle::exact(p));
        REQUIRE(inside(made, once, p));
        REQUIRE(inside(again, image(frame, once), p));
      }
    }
  }
}

TEST_CASE("boxes and slabs that are made again are not larger than carried ones") {
  Random random(3);
  const Points points = volume_families::points<double>(random, Family::mesh_vertices, 40);
  const auto frame = any_frame<double>(random);
  for (const VolumeKind kind :
       {VolumeKind::aabb, VolumeKind::dop_14, VolumeKind::dop_18, VolumeKind::dop_26}) {
    INFO(name_of(kind));
    BoundingVolume made = bounding_volume(kind, points);
    const double again = volume(carried(made, frame));
    made.extremes.clear();
    CHECK(again < volume(carried(made, frame)));
  }
}

/// The point of a set that is furthest in a direction.
Point furthest(const Points& points, const Point& direction) {
  return *std::max_element(points.begin(), points.end(), [&](const Point& p, const Point& q) {
    return direction.dot(p) < direction.dot(q);
  });
}
/// The points reflected in v, rounded. v is kept as it is, and often the only point that both have.
Points reflected(const Points& points, const Point& v) {
  Points result;
  for (const Point& p : points) result.push_back(v + (v - p));
  return result;
}

TEST_CASE("no kind says that two bodies are apart that touch in a vertex") {
  Random random(4);
  for (int i = 0; i < generators::tried(176); ++i) {
    const Points points = drawn(random, i, 12);
    const Point direction = carried_truth::any_direction(random);
    const Points other = reflected(points, furthest(points, direction));
    const auto frame = any_frame<double>(random);
    for (const VolumeKind kind : all_volume_kinds) {
      INFO(name_of(kind) << ", " << volume_families::name(family_of(i)) << ", set " << i);
      const BoundingVolume a = bounding_volume(kind, points), b = bounding_volume(kind, other);
      REQUIRE(may_meet(a, b));
      REQUIRE(may_meet(carried(a, frame), carried(b, frame)));
    }
  }
}

TEST_CASE("no kind says that two bodies are apart that meet") {
  Random random(5);
  int met = 0, apart = 0;
  for (int i = 0; i < generators::tried(220); ++i) {
    const Points points = drawn(random, i, 10);
    Point size = Point::Zero();
    for (const Point& p : points) size = size.cwiseMax((p - points[0]).cwiseAbs());
    Point away = carried_truth::any_direction(random);
    away *= random.uniform(0, 1.5);
    Points other = points;
    for (Point& p : other) p += size.cwiseProduct(away);
    const bool meet = may_meet(bounding_volume(VolumeKind::hull, points),
                               bounding_volume(VolumeKind::hull, other));
    met += meet ? 1 : 0;
    apart += meet ? 0 : 1;
    if (!meet) continue;
    for (const VolumeKind kind : all_volume_kinds) {
      INFO(name_of(kind) << ", " << volume_families::name(family_of(i)) << ", set " << i);
      REQUIRE(may_meet(bounding_volume(kind, points), bounding_volume(kind, other)));
    }
  }
  CHECK(met > generators::tried(220) / 8);
  CHECK(apart > generators::tried(220) / 8);
}

TEST_CASE("slabs of more normals are inside those of fewer, and slabs inside the box") {
  Random random(6);
  for (int i = 0; i < generators::tried(88); ++i) {
    const Points points = drawn(random, i, 16);
    const auto slabs = [&](VolumeKind kind) {
      return std::get<Kdop<double>>(bounding_volume(kind, points).shape);
    };
    const auto box =
        std::get<contact::Aabb<double>>(bounding_volume(VolumeKind::aabb, points).shape);
    const Kdop<double> dop_14 = slabs(VolumeKind::dop_14), dop_18 = slabs(VolumeKind::dop_18),
                       dop_26 = slabs(VolumeKind::dop_26);
    // The normals of the 26-DOP are the axes, then the other ones of the 14-DOP and of the 18-DOP.
    const auto same = [&](const Kdop<double>& dop, std::size_t i26, std::size_t k) {
      return dop.normals[k] == dop_26.normals[i26] && dop.low[k] == dop_26.low[i26] &&
             dop.high[k] == dop_26.high[i26];
    };
    INFO(volume_families::name(family_of(i)) << ", set " << i);
    for (std::size_t k = 0; k < 7; ++k) REQUIRE(same(dop_14, k, k));
    for (std::size_t k = 0; k < 9; ++k) REQUIRE(same(dop_18, k < 3 ? k : k + 4, k));
    for (int k = 0; k < 3; ++k) {
      REQUIRE(box.low[k] == dop_18.low[static_cast<std::size_t>(k)]);
      REQUIRE(box.high[k] == dop_18.high[static_cast<std::size_t>(k)]);
    }
  }
}

TEST_CASE(
    "the smallest sphere is larger than the grown one at most by the rounding of its centre") {
  Random random(7);
  for (int i = 0; i < generators::tried(440); ++i) {
    const Points points = drawn(random, i, 16);
    const auto sphere = [&](VolumeKind kind) {
      return std::get<Sphere<double>>(bounding_volume(kind, points).shape);
    };
    const Sphere<double> smallest = sphere(VolumeKind::smallest_sphere);
    const double ulp = std::numeric_limits<double>::epsilon();
    const double room = ulp * (smallest.centre.cwiseAbs().sum() + 2 * smallest.radius);
    INFO(volume_families::name(family_of(i)) << ", set " << i);
    REQUIRE(smallest.radius <= sphere(VolumeKind::grown_sphere).radius + room);
  }
}

TEST_CASE(
    "the smallest box is not larger than the box and the principal box of the hull's vertices") {
  Random random(8);
  for (int i = 0; i < generators::tried(44); ++i) {
    const Points all = volume_families::points<double>(random, Family::in_box, 30);
    Points points;
    for (const int v : contact::convex_hull(all).vertices) {
      points.push_back(all[static_cast<std::size_t>(v)]);
    }
    const double smallest = volume(bounding_volume(VolumeKind::smallest_box, all));
    INFO("set " << i);
    REQUIRE(smallest <= volume(bounding_volume(VolumeKind::object_box, points)) * (1 + 1e-12));
    REQUIRE(smallest <= volume(bounding_volume(VolumeKind::principal_box, points)) * (1 + 1e-12));
  }
}

TEST_CASE("no volume is smaller than that of the hull") {
  Random random(9);
  for (const Family family : {Family::in_box, Family::on_ball, Family::cospherical, Family::grid,
                              Family::mesh_vertices}) {
    const Points points = volume_families::points<double>(random, family, 40);
    const double hull = volume(bounding_volume(VolumeKind::hull, points));
    REQUIRE(hull > 0);
    for (const VolumeKind kind : all_volume_kinds) {
      INFO(name_of(kind) << ", " << volume_families::name(family));
      CHECK(volume(bounding_volume(kind, points)) >= hull * (1 - 1e-9));
    }
  }
}

TEST_CASE("volumes of the unit cube's bounding volumes") {
  Points cube;
  for (int i = 0; i < 8; ++i) cube.push_back({double(i & 1), double(i >> 1 & 1), double(i >> 2)});
  const auto of = [&](VolumeKind kind) { return volume(bounding_volume(kind, cube)); };
  const double sphere = std::numbers::pi * std::sqrt(3.0) / 2;
  CHECK(std::abs(of(VolumeKind::smallest_sphere) - sphere) <= 1e-12);
  CHECK(of(VolumeKind::grown_sphere) >= sphere - 1e-12);  // which diagonal it starts from is open
  CHECK(of(VolumeKind::principal_box) >= 1 - 1e-12);      // its axes are arbitrary
  for (const VolumeKind kind :
       {VolumeKind::aabb, VolumeKind::object_box, VolumeKind::smallest_box, VolumeKind::dop_14,
        VolumeKind::dop_18, VolumeKind::dop_26, VolumeKind::hull}) {
    INFO(name_of(kind));
    CHECK(std::abs(of(kind) - 1) <= 1e-12);
  }
  CHECK(volume(contact::convex_hull(cube), cube) == 1);
}

TEST_CASE("a hull carried is the hull of the carried points") {
  Random random(10);
  const Points points = volume_families::points<double>(random, Family::on_ball, 30);
  const auto frame = any_frame<double>(random);
  const auto made = carried(bounding_volume(VolumeKind::hull, points), frame);
  const auto& vertices = std::get<MeshTree<double>>(made.shape).mesh().vertices;
  REQUIRE(vertices.size() == contact::convex_hull(points).vertices.size());
  for (const Point& v : vertices) {
    CHECK(std::any_of(points.begin(), points.end(),
                      [&](const Point& p) { return contact::position_in_world(frame, p) == v; }));
  }
}

TEST_CASE("hulls without a volume meet where they have a common point") {
  const auto hull = [](const Points& points) { return bounding_volume(VolumeKind::hull, points); };
  const auto point = hull({{1, 1, 0}}), segment = hull({{0, 0, 0}, {2, 2, 0}});
  const auto square = hull({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {2, 2, 0}});
  const auto box = hull({{-1, -1, -1}, {9, -1, -1}, {-1, 9, -1}, {-1, -1, 9}});
  CHECK(may_meet(point, segment));
  CHECK(may_meet(point, square));
  CHECK(may_meet(square, segment));
  CHECK(may_meet(box, point));
  CHECK(may_meet(segment, box));
  CHECK_FALSE(may_meet(point, hull({{1, 1, 1e-300}})));
  CHECK_FALSE(may_meet(square, hull({{1, 1, 1}, {1, 1, 1e-300}})));
}

TEST_CASE("a body inside another meets it") {
  Random random(11);
  Points inner = volume_families::points<double>(random, Family::on_ball, 40), outer;
  const Point middle = (inner[0] + inner[1] + inner[2] + inner[3]) / 4;
  for (const Point& p : inner) outer.push_back(middle + 100 * (p - middle));
  for (const VolumeKind kind : all_volume_kinds) {
    INFO(name_of(kind));
    CHECK(may_meet(bounding_volume(kind, inner), bounding_volume(kind, outer)));
    CHECK(may_meet(bounding_volume(kind, outer), bounding_volume(kind, inner)));
  }
}

TEST_CASE("volumes of two kinds are not compared") {
  const Points points{{0, 0, 0}, {1, 2, 3}};
  const auto box = bounding_volume(VolumeKind::smallest_box, points);
  const auto other = bounding_volume(VolumeKind::object_box, points);
  CHECK_THROWS_AS(may_meet(box, other), std::invalid_argument);
}

TEST_CASE("a volume is not made of no point or one that is not finite") {
  for (const VolumeKind kind : all_volume_kinds) {
    INFO(name_of(kind));
    CHECK_THROWS_AS(bounding_volume(kind, Points{}), std::invalid_argument);
    CHECK_THROWS_AS(bounding_volume(kind, Points{{0, 0, 0}, {0, std::nan(""), 0}}),
                    std::invalid_argument);
  }
}

TEST_CASE("volumes of scales from 1e-150 to 1e150 contain their points and meet themselves") {
  Random random(12);
  for (const double scale : {1e-150, 1e-30, 1e30, 1e150}) {
    for (const Family family : {Family::in_box, Family::coplanar, Family::grid}) {
      const Points points = volume_families::scaled<double>(
          volume_families::points<double>(random, family, 12), scale);
      for (const VolumeKind kind : all_volume_kinds) {
        INFO(name_of(kind) << ", " << volume_families::name(family) << ", " << scale);
        const BoundingVolume made = bounding_volume(kind, points);
        for (const Point& p : points) REQUIRE(inside(made, oracle::exact(p), p));
        REQUIRE(may_meet(made, made));
      }
    }
  }
}

TEST_CASE("each kind has a name of its own") {
  std::set<std::string> names;
  for (const VolumeKind kind : all_volume_kinds) names.insert(name_of(kind));
  CHECK(names.size() == all_volume_kinds.size());
}

}  // namespace volume_kinds_test
