#include <07_bounding_volumes/carried_truth.hpp>
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/pairs_spared.hpp>
#include <contact/polyhedra_meet.hpp>
#include <cstddef>
#include <span>
#include <stdexcept>
#include <vector>

namespace pairs_spared_test {

using contact::all_volume_kinds;
using contact::count_pairs;
using contact::MeasuredShape;
using contact::Mesh;
using contact::name_of;
using contact::PlacedBody;
using contact::scattered_bodies;
using contact::SceneCounts;
using contact::VolumeKind;

int of(const SceneCounts& counts, VolumeKind kind) {
  return counts.may_meet[static_cast<std::size_t>(kind)];
}
/// A crowd of all shapes: bodies meet, and others do not.
SceneCounts crowd(std::uint64_t seed) {
  const auto shapes = contact::measured_shapes();
  return count_pairs(shapes, scattered_bodies(20, 5, 25, seed));
}

TEST_CASE("scattered bodies are the same for the same seed and differ for another") {
  const auto bodies = scattered_bodies(10, 3, 8, 7), same = scattered_bodies(10, 3, 8, 7),
             other = scattered_bodies(10, 3, 8, 8);
  for (std::size_t i = 0; i < 10; ++i) {
    CHECK(bodies[i].shape == static_cast<int>(i) % 3);
    CHECK(bodies[i].frame.origin == same[i].frame.origin);
    CHECK(bodies[i].frame.axes == same[i].frame.axes);
    CHECK(bodies[i].frame.origin != other[i].frame.origin);
    CHECK(bodies[i].frame.axes != other[i].frame.axes);
  }
}

TEST_CASE("scattered bodies are in their cube, nearly orthonormal and right-handed") {
  for (const PlacedBody& body : scattered_bodies(200, 1, 8, 1)) {
    CHECK(body.frame.origin.minCoeff() >= 0);
    CHECK(body.frame.origin.maxCoeff() < 8);
    const contact::Matrix3<double> off =
        body.frame.axes.transpose() * body.frame.axes - contact::Matrix3<double>::Identity();
    CHECK(off.cwiseAbs().maxCoeff() < 0x1p-18);
    CHECK(body.frame.axes.determinant() > 0);
  }
}

TEST_CASE("scattered bodies are carried without rounding") {
  const auto shapes = contact::measured_shapes();
  for (const PlacedBody& body : scattered_bodies(10, 5, 4096, 2)) {
    const auto& vertices = shapes[static_cast<std::size_t>(body.shape)].mesh.vertices;
    for (std::size_t i = 0; i < vertices.size(); i += 10) {
      REQUIRE(oracle::exact(contact::position_in_world(body.frame, vertices[i])) ==
              carried_truth::image(body.frame, oracle::exact(vertices[i])));
    }
  }
}

TEST_CASE("scattered bodies refuse counts below 1 and sides out of range") {
  CHECK_THROWS_AS(scattered_bodies(0, 1, 1, 1), std::invalid_argument);
  CHECK_THROWS_AS(scattered_bodies(1, 0, 1, 1), std::invalid_argument);
  CHECK_THROWS_AS(scattered_bodies(1, 1, 0, 1), std::invalid_argument);
  CHECK_THROWS_AS(scattered_bodies(1, 1, 4097, 1), std::invalid_argument);
  CHECK_THROWS_AS(scattered_bodies(1, 1, std::nan(""), 1), std::invalid_argument);
}

TEST_CASE("no kind misses a pair of a scene whose bodies meet") {
  int met = 0;
  for (const std::uint64_t seed : {1U, 2U}) {
    const SceneCounts counts = crowd(seed);
    for (const VolumeKind kind : all_volume_kinds) {
      INFO(name_of(kind) << ", seed " << seed);
      CHECK(counts.missed[static_cast<std::size_t>(kind)] == 0);
      CHECK(counts.spared(kind) + counts.meet + counts.false_alarms(kind) == counts.pairs);
    }
    met += counts.meet;
  }
  CHECK(met > 20);
}

TEST_CASE("kinds that are inside others spare at least as many pairs") {
  const SceneCounts counts = crowd(3);
  CHECK(counts.pairs == 190);
  for (const VolumeKind kind : all_volume_kinds) {
    INFO(name_of(kind));
    CHECK(of(counts, VolumeKind::hull) <= of(counts, kind));
  }
  CHECK(counts.meet <= of(counts, VolumeKind::hull));
  CHECK(of(counts, VolumeKind::dop_26) <= of(counts, VolumeKind::dop_14));
  CHECK(of(counts, VolumeKind::dop_26) <= of(counts, VolumeKind::dop_18));
  CHECK(of(counts, VolumeKind::dop_14) <= of(counts, VolumeKind::aabb));
  CHECK(of(counts, VolumeKind::dop_18) <= of(counts, VolumeKind::aabb));
}

TEST_CASE("as many bodies meet as the test of all edges and faces finds") {
  const auto shapes = contact::measured_shapes();
  const auto bodies = scattered_bodies(10, 5, 16, 4);
  std::vector<Mesh<double>> meshes;
  for (const PlacedBody& body : bodies) {
    meshes.push_back(
        contact::transformed(shapes[static_cast<std::size_t>(body.shape)].mesh, body.frame));
  }
  int meet = 0;
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    for (std::size_t j = i + 1; j < meshes.size(); ++j) {
      meet += contact::polyhedra_meet(meshes[i], meshes[j]).meet ? 1 : 0;
    }
  }
  CHECK(count_pairs(shapes, bodies).meet == meet);
  CHECK(meet > 5);
}

}  // namespace pairs_spared_test
