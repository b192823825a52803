// close_points.hpp: points that coincide up to rounding count once, in the plane and in space, and
// points between others not at all.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/contact_manifold.hpp>
#include <contact/contact_world.hpp>
#include <contact/hull_manifold.hpp>
#include <contact/manifold_2d.hpp>
#include <limits>
#include <set>
#include <vector>

#include "09_separating_planes/random_poses.hpp"
#include "support/generators.hpp"

namespace close_points_test {
namespace {

using contact::ContactManifold;
using contact::detail::face_size;
using contact::detail::flatness;
using contact::detail::keep_outline;
using contact::detail::merge_close_points;
using generators::Random;
using generators::tried;

using V = contact::Vector3<double>;
using V2 = contact::Vector2<double>;
using Box = contact::OrientedBox<double>;
using Hull = contact::ConvexHull<double>;
using P = contact::Polygon<double>;

ContactManifold<double> of_points(const std::vector<V>& points) {
  ContactManifold<double> manifold{V(0, 0, 1), {}};
  for (int i = 0; i < int(points.size()); ++i) {
    manifold.points.push_back({points[std::size_t(i)], -0.5 * i, {contact::vertex_feature(i), {}}});
  }
  return manifold;
}
/// Which of the points are kept, by their features.
std::vector<int> kept(const std::vector<V>& points, double size) {
  auto manifold = of_points(points);
  merge_close_points(manifold, size);
  std::vector<int> numbers;
  for (const auto& p : manifold.points) {
    const int i = p.features.of_a.first;
    CHECK(p.point == points[std::size_t(i)]);
    CHECK(p.distance == -0.5 * i);
    numbers.push_back(i);
  }
  return numbers;
}

Hull hull_of(const Box& box) {
  Hull hull;
  for (int k = 0; k < 8; ++k) hull.vertices.push_back(contact::box_corner(box, k));
  return hull;
}

/// A box of edge 2 on another one of edge 2, both rotated alike, but for a few units of rounding.
struct Stacked {
  Box above, below;
};
Stacked stacked(Random& random, double noise) {
  const contact::Matrix3<double> axes = random_poses::turn(random);
  const V half(1, 1, 1), up = axes.col(2);
  const V at(random.uniform(-4, 4), random.uniform(-4, 4), random.uniform(-4, 4));
  const auto little = [&] { return random.uniform(-noise, noise); };
  Box above{V(at + up * 2.0 + V(little(), little(), little())), axes, half};
  const contact::Quaternion<double> turn{1, V(little(), little(), little())};
  above.axes = contact::matrix_of(contact::normalised(turn)) * axes;
  return {above, {at, axes, half}};
}

P square(double x, double y, double size) {
  return {V2(x, y), V2(x + size, y), V2(x + size, y + size), V2(x, y + size)};
}

}  // namespace

TEST_CASE("of points closer than 2^-20 of the size the first stays, in order, with its features") {
  CHECK(kept({}, 1).empty());
  const double near = 0x1p-20, far = 0x1.1p-20;
  CHECK(kept({V(0, 0, 0), V(near, -near, near), V(far, 0, 0)}, 1) == std::vector<int>{0, 2});
  CHECK(kept({V(0, 0, 0), V(near, 0, 0), V(2 * near, 0, 0), V(3 * near, 0, 0)}, 1) ==
        std::vector<int>{0, 2});
  CHECK(kept({V(3, 0, 0), V(1, 0, 0), V(3, 0, near), V(2, 0, 0), V(1, 0, 0)}, 1) ==
        std::vector<int>{0, 1, 3});
  // Without a size only equal points are one.
  CHECK(kept({V(0, 0, 0), V(0x1p-1074, 0, 0), V(0, 0, 0)}, 0) == std::vector<int>{0, 1});
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  auto broken = of_points({V(nan, 0, 0), V(nan, 0, 0)});
  merge_close_points(broken, 1.0);
  CHECK(broken.points.size() == 2);
}

TEST_CASE("the size of a face is between the radius of the circle in it and twice that") {
  CHECK(face_size<double>({}) == 0);
  CHECK(face_size<double>({V(1, 2, 3)}) == 0);
  CHECK(face_size<double>({V(0, 0, 0), V(3, 4, 0)}) == 5);
  CHECK(face_size<double>({V(0, 0, 0), V(1, 0, 0), V(2, 0, 0)}) == 0);
  CHECK(face_size<double>({V(1, 1, 1), V(1, 1, 1), V(1, 1, 1)}) == 0);
  CHECK(face_size<double>({V(0, 0, 7), V(4, 0, 7), V(0, 3, 7)}) == 1);  // the circle itself
  CHECK(face_size<double>({V(0, 0, 0), V(2, 0, 0), V(2, 2, 0), V(0, 2, 0)}) == 1);
  const double width = 0x1p-30;
  const double needle = face_size<double>({V(0, 0, 0), V(1, 0, 0), V(1, 0, width), V(0, 0, width)});
  CHECK(needle >= width / 2);
  CHECK(needle <= width);
}

TEST_CASE("a box on an equal box has four points, however rounding has moved it") {
  Random random(1891);
  for (int i = 0; i < tried(2000); ++i) {
    const auto [above, below] = stacked(random, std::ldexp(1.0, -25 - i % 30));
    CAPTURE(i);
    CHECK(contact::contact_manifold(above, below, 1e-3).points.size() == 4);
    CHECK(contact::contact_manifold(hull_of(above), below, 1e-3).points.size() == 4);
    CHECK(contact::contact_manifold(hull_of(above), hull_of(below), 1e-3).points.size() == 4);
    // Only rotated: edges cross in their middle.
    const Box rotated{V(below.centre + below.axes.col(2) * 2.0), above.axes, above.half_lengths};
    CHECK(contact::contact_manifold(rotated, below, 1e-3).points.size() == 4);
    CHECK(contact::contact_manifold(hull_of(rotated), hull_of(below), 1e-3).points.size() == 4);
    // Half of it over the edge, so that two of its sides are above two of the other's.
    const Box beside{V(above.centre + below.axes.col(0)), above.axes, above.half_lengths};
    CHECK(contact::contact_manifold(beside, below, 1e-3).points.size() == 4);
    CHECK(contact::contact_manifold(hull_of(beside), below, 1e-3).points.size() == 4);
  }
}

TEST_CASE("a stack at rest has the same number of points in every step") {
  for (const double offset : {0.0, 1e-9, 0.1}) {
    std::vector<contact::ShapedBody<double>> bodies{contact::ground<double>({V(0, 0, 1), 0})};
    for (int i = 0; i < 3; ++i) {
      bodies.push_back(contact::solid_box<double>(1, V(1, 1, 1), V(offset * (i % 2), 0, 0.5 + i)));
    }
    for (auto& body : bodies) body.friction = 0.5;
    contact::StepMemory<double> memory;
    std::set<std::size_t> counts;
    for (int step = 0; step < tried(60); ++step) {
      contact::step_contacts(bodies, memory);
      counts.insert(memory.found.contacts.size());
    }
    CAPTURE(offset);
    CHECK(counts == std::set<std::size_t>{12});
  }
}

TEST_CASE("a needle on a table keeps both its sides") {
  for (const double width : {1e-2, 1e-5, 1e-9}) {
    const Box needle{V(0.3, 0.2, width / 2), contact::Matrix3<double>::Identity(),
                     V(1, width / 2, width / 2)};
    const Box table{V(0, 0, -1), contact::Matrix3<double>::Identity(), V(4, 4, 1)};
    CHECK(contact::contact_manifold(needle, table, width / 4).points.size() == 4);
    // A hull's face that is narrower than 2^-20 of its length counts as an edge.
    const auto of_hulls = contact::contact_manifold(hull_of(needle), table, width / 4);
    CHECK(of_hulls.points.size() == (width > 0x1p-20 ? 4u : 2u));
  }
}

TEST_CASE("points between others are left out, and the vertices of the outline stay, in order") {
  const auto outline = [](const std::vector<V>& points, double size) {
    auto manifold = of_points(points);
    keep_outline(manifold, size);
    std::vector<int> numbers;
    for (const auto& p : manifold.points) numbers.push_back(p.features.of_a.first);
    return numbers;
  };
  using Numbers = std::vector<int>;
  const double little = 0x1p-21;
  CHECK(outline({V(0, 0, 0), V(1, 0, 0)}, 1) == Numbers{0, 1});
  CHECK(outline({V(0, 0, 0), V(1, 0, 0), V(0, 1, 0)}, 1) == Numbers{0, 1, 2});
  CHECK(outline({V(0, 0, 0), V(1, little, 0), V(2, 0, 0)}, 1) == Numbers{0, 2});
  CHECK(outline({V(1, 0, 0), V(2, 0, 0), V(0, 0, 0)}, 1) == Numbers{1, 2});
  CHECK(outline({V(0, 0, 0), V(1, -little, 0), V(2, 0, 0), V(2, 1, 0), V(2 + little, 2, 0),
                 V(0, 2, 0), V(0, 2, little), V(-little, 1, 0)},
                1) == Numbers{0, 2, 4, 5});
  // Both the first and the one that is as far below it as two vertices are in the middle of a side.
  CHECK(outline({V(0, 1, 0), V(-1, 1, 0), V(-1, -1, 0), V(0, -1, 0), V(1, -1, 0), V(1, 1, 0)}, 1) ==
        Numbers{1, 2, 4, 5});
  // First in the list, but between the last and the second.
  CHECK(outline({V(1, 0, 0), V(2, 0, 0), V(2, 2, 0), V(0, 2, 0), V(0, 0, 0)}, 1) ==
        Numbers{1, 2, 3, 4});
  CHECK(outline({V(0, 0, 0), V(1, -0x1.1p-20, 0), V(2, 0, 0), V(1, 1, 0)}, 1) ==
        Numbers{0, 1, 2, 3});
  // Of many points on an arc no removed one is farther from the others' outline than that.
  std::vector<V> arc;
  for (int i = 0; i < 8000; ++i) arc.emplace_back(std::cos(i * 2e-4), std::sin(i * 2e-4), 0);
  const Numbers left = outline(arc, 1);
  CHECK(left.size() > 500);
  CHECK(left.size() < 8000);
  CHECK(left.front() == 0);
  CHECK(left.back() == 7999);
  for (std::size_t k = 0; k + 1 < left.size(); ++k) {
    for (int i = left[k]; i <= left[k + 1]; ++i) {
      CHECK(contact::detail::is_on_segment<double>(arc[std::size_t(i)], arc[std::size_t(left[k])],
                                                   arc[std::size_t(left[k + 1])], 0x1p-20));
    }
  }
  // Sizes far from 1.
  for (const double scale : {0x1p-700, 0x1p+400}) {
    CHECK(outline({V(0, 0, 0), V(scale, 0, 0), V(2 * scale, 0, 0), V(0, scale, 0)}, scale) ==
          Numbers{0, 2, 3});
  }
}

TEST_CASE("no two points of a manifold coincide up to rounding, whatever the bodies") {
  Random random(1892);
  for (int i = 0; i < tried(2000); ++i) {
    const auto [above, below] = stacked(random, 1e-12);
    const double slide = random.chance(0.5) ? 1 : random.uniform(0, 1);
    const Box moved{V(above.centre + below.axes.col(0) * slide), above.axes, above.half_lengths};
    const auto manifold = contact::contact_manifold(moved, below, 1e-3);
    CHECK(manifold.points.size() == 4);
    for (std::size_t k = 0; k < manifold.points.size(); ++k) {
      for (std::size_t m = 0; m < k; ++m) {
        const V between = manifold.points[k].point - manifold.points[m].point;
        CHECK(between.cwiseAbs().maxCoeff() > flatness<double>);
      }
    }
  }
}

TEST_CASE("capsules and edges whose overlap is a point up to rounding have one point") {
  using contact::Capsule;
  for (const double over : {0.0, 0x1p-52, 0x1p-40}) {
    const Capsule<double> a{{V(0, 0, 1), V(1, 0, 1)}, 0.5};
    const Capsule<double> b{{V(1 - over, 0, 0), V(2, 0, 0)}, 0.5};
    CHECK(contact::contact_manifold(a, b, 0.01).points.size() == 1);
    const Box table{V(2 - over, 0, 0), contact::Matrix3<double>::Identity(), V(1, 1, 0.5)};
    CHECK(contact::contact_manifold(a, table, 0.01).points.size() == 1);
  }
  const Capsule<double> longer{{V(0, 0, 1), V(1.125, 0, 1)}, 0.5};
  CHECK(contact::contact_manifold(longer, Capsule<double>{{V(1, 0, 0), V(2, 0, 0)}, 0.5}, 0.01)
            .points.size() == 2);
}

TEST_CASE("in the plane an overlap of 2^-20 of the shorter edge or less is one point") {
  for (const double over : {0.0, 0x1p-52, 0x1p-40, 0x1p-21}) {
    const auto manifold =
        contact::contact_manifold_2d(square(0, 1, 1), square(1 - over, 0, 1), 0.0);
    REQUIRE(manifold.points.size() == 1);
    CHECK(std::abs(manifold.points[0].point.x() - 1) <= over);
    CHECK(manifold.points[0].point.y() == 1);
  }
  const auto two = contact::contact_manifold_2d(square(0, 1, 1), square(1 - 0x1p-19, 0, 1), 0.0);
  CHECK(two.points.size() == 2);
  // A small square on a large one: its own size counts.
  CHECK(contact::contact_manifold_2d(square(0.5, 1, 0x1p-30), square(0, 0, 1), 0.0).points.size() ==
        2);
}

TEST_CASE("in float points within 2^-12 of the size are one") {
  using F = contact::Vector3<float>;
  ContactManifold<float> manifold{F(0, 0, 1), {}};
  for (const float x : {0.0F, 0x1p-12F, 0x1.1p-12F})
    manifold.points.push_back({F(x, 0, 0), 0.0F, {}});
  merge_close_points(manifold, 1.0F);
  CHECK(manifold.points.size() == 2);
}

}  // namespace close_points_test
