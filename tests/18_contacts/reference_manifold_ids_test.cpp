// manifold_ids.hpp: points that slide, points whose features rounding changes, and each impulse at
// most once.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/contact_manifold.hpp>
#include <contact/manifold_ids.hpp>
#include <utility>
#include <vector>

#include "support/generators.hpp"

namespace manifold_ids_test {
namespace {

using contact::ContactManifold;
using contact::edge_feature;
using contact::matched_points;
using contact::OrientedBox;
using contact::PointFeatures;
using contact::vertex_feature;
using generators::Random;
using generators::tried;

using V = contact::Vector3<double>;
using Box = OrientedBox<double>;
using Manifold = ContactManifold<double>;

Box box_at(const V& centre, const V& half) {
  return {centre, contact::Matrix3<double>::Identity(), half};
}
/// The same, rotated about the vertical axis.
Box turned(const V& centre, const V& half, double sine) {
  const double cosine = std::sqrt(1 - sine * sine);
  contact::Matrix3<double> axes;
  axes << cosine, -sine, 0, sine, cosine, 0, 0, 0, 1;
  return {centre, axes, half};
}

int count_matched(const std::vector<int>& matched) {
  return int(std::count_if(matched.begin(), matched.end(), [](int k) { return k >= 0; }));
}
/// How many points have features that some point of the previous manifold has.
int count_same_features(const Manifold& now, const Manifold& previous) {
  return int(std::count_if(now.points.begin(), now.points.end(), [&previous](const auto& p) {
    return std::any_of(previous.points.begin(), previous.points.end(),
                       [&p](const auto& q) { return p.features == q.features; });
  }));
}

}  // namespace

TEST_CASE("a sliding box keeps its points by their features, however far it slides in a step") {
  const Box table = box_at(V(0, 0, -1), V(50, 50, 1));
  Manifold previous = contact::contact_manifold(box_at(V(-40, 0, 1), V(1, 2, 1)), table, 1e-3);
  for (int step = 1; step < 20; ++step) {
    const Box box = box_at(V(-40 + 4 * step, 0, 1), V(1, 2, 1));
    const Manifold now = contact::contact_manifold(box, table, 1e-3);
    REQUIRE(now.points.size() == 4);
    const std::vector<int> matched = matched_points(now, previous, 0.01);
    for (std::size_t i = 0; i < 4; ++i) {
      REQUIRE(matched[i] >= 0);
      const V moved = now.points[i].point - previous.points[std::size_t(matched[i])].point;
      CHECK((moved - V(4, 0, 0)).norm() <= 1e-12);
    }
    previous = now;
  }
}

TEST_CASE("a box on an equal box keeps its points by distance where rounding changes features") {
  Random random(1841);
  const Box below = box_at(V(0, 0, -1), V(1, 1, 1));
  Manifold previous = contact::contact_manifold(box_at(V(0, 0, 1), V(1, 1, 1)), below, 1e-3);
  int changed = 0;
  for (int step = 0; step < tried(500); ++step) {
    const double x = random.uniform(-1e-12, 1e-12);
    const double y = random.uniform(-1e-12, 1e-12);
    const Box above = turned(V(x, y, 1), V(1, 1, 1), random.uniform(-1e-12, 1e-12));
    const Manifold now = contact::contact_manifold(above, below, 1e-3);
    const std::vector<int> matched = matched_points(now, previous, 0.01);
    changed += count_same_features(now, previous) < int(now.points.size()) ? 1 : 0;
    for (std::size_t i = 0; i < now.points.size(); ++i) {
      if (matched[i] < 0) continue;
      const V moved = now.points[i].point - previous.points[std::size_t(matched[i])].point;
      CHECK(moved.norm() <= 0.01);
    }
    for (const double side : {-1.0, 1.0}) {
      for (const double other : {-1.0, 1.0}) {
        bool keeps = false;
        for (std::size_t i = 0; i < now.points.size(); ++i) {
          const bool here = (now.points[i].point - V(side, other, 0)).norm() <= 1e-9;
          keeps = keeps || (here && matched[i] >= 0);
        }
        CHECK(keeps);
      }
    }
    previous = now;
  }
  CHECK(changed > tried(100));
}

TEST_CASE("rounding of a resting box does not change the order of its points") {
  Random random(1843);
  for (const double size : {0.75, 1.25}) {
    Manifold previous;
    const Box below = box_at(V(0, 0, -1), V(1, 1, 1));
    for (int step = 0; step < tried(200); ++step) {
      const V centre{random.uniform(-1e-14, 1e-14), random.uniform(-1e-14, 1e-14), 1};
      const Box above = turned(centre, V(size, size, 1), random.uniform(-1e-14, 1e-14));
      const Manifold now = contact::contact_manifold(above, below, 1e-3);
      REQUIRE(now.points.size() == 4);
      CHECK((now.normal - V(0, 0, 1)).norm() <= 1e-13);
      for (std::size_t i = 0; step > 0 && i < 4; ++i) {
        CHECK((now.points[i].point - previous.points[i].point).norm() <= 1e-12);
        CHECK(now.points[i].features == previous.points[i].features);
      }
      previous = now;
    }
  }
}

TEST_CASE("each previous point is matched at most once, whatever the features") {
  Random random(1842);
  const auto manifold = [&random] {
    Manifold made;
    made.normal = V(0, 0, 1);
    const int count = random.integer(0, 6);
    for (int i = 0; i < count; ++i) {
      const double x = random.integer(0, 3);
      const double y = random.integer(0, 3);
      const int feature = random.integer(0, 2);
      made.points.push_back({V(x, y, 0), 0, PointFeatures{vertex_feature(feature), {}}});
    }
    return made;
  };
  int matches = 0;
  for (int i = 0; i < tried(10000); ++i) {
    const Manifold now = manifold();
    const Manifold previous = manifold();
    std::vector<int> matched = matched_points(now, previous, 1.5);
    REQUIRE(matched.size() == now.points.size());
    std::erase(matched, -1);
    matches += int(matched.size());
    std::sort(matched.begin(), matched.end());
    CHECK(std::adjacent_find(matched.begin(), matched.end()) == matched.end());
  }
  CHECK(matches > tried(10000));
}

TEST_CASE("a point near two previous ones takes the closer, and one far from all takes none") {
  Manifold previous;
  previous.normal = V(0, 0, 1);
  for (const double x : {0.0, 1.0}) {
    previous.points.push_back({V(x, 0, 0), 0, PointFeatures{vertex_feature(int(x)), {}}});
  }
  Manifold now = previous;
  now.points[0] = {V(0.75, 0, 0), 0, PointFeatures{edge_feature(2, 3), {}}};
  now.points[1] = {V(9, 0, 0), 0, PointFeatures{edge_feature(3, 4), {}}};
  CHECK(matched_points(now, previous, 0.8) == std::vector<int>{1, -1});
  // Point 1 by its features, so what is left is farther.
  now.points[1].features = previous.points[1].features;
  CHECK(matched_points(now, previous, 0.8) == std::vector<int>{0, 1});
  CHECK(matched_points(now, previous, 0.7) == std::vector<int>{-1, 1});
}

TEST_CASE("nothing is matched if the bodies touch at other faces") {
  const Box table = box_at(V(0, 0, -1), V(5, 5, 1));
  const Manifold on_top = contact::contact_manifold(box_at(V(4.5, 0, 1), V(1, 1, 1)), table, 0.01);
  const Manifold beside = contact::contact_manifold(box_at(V(6, 0, -1), V(1, 1, 1)), table, 0.01);
  REQUIRE(on_top.normal == V(0, 0, 1));
  REQUIRE(beside.normal == V(1, 0, 0));
  REQUIRE(!beside.points.empty());
  CHECK(count_matched(matched_points(beside, on_top, 100.0)) == 0);
  CHECK(count_matched(matched_points(on_top, on_top, 0.0)) == int(on_top.points.size()));
}

}  // namespace manifold_ids_test
