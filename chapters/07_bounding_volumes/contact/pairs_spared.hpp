/// @file
/// A scene of many bodies: how many of its pairs each kind of bounding volume spares, and how many
/// pairs whose volumes meet are apart.
#pragma once

#include <array>
#include <cmath>
#include <contact/frame.hpp>
#include <contact/invalid_argument.hpp>
#include <contact/measured_shapes.hpp>
#include <contact/mesh.hpp>
#include <contact/mesh_shapes.hpp>
#include <contact/mesh_tree.hpp>
#include <contact/quaternion.hpp>
#include <contact/vector.hpp>
#include <contact/volume_kinds.hpp>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace contact {

/// A body of a scene: a copy of a shape at a pose.
struct PlacedBody {
  int shape = 0;                  ///< its index
  CoordinateFrame<double> frame;  ///< from the shape's frame to the world
};

namespace pairs_spared_detail {

/// splitmix64 (Steele, Lea and Flood, 2014): whole numbers only, the same on every machine.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  /// In [low, low + length), in 2^20 equal steps.
  double uniform(double low, double length) {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15U);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
    z ^= z >> 31;
    return low + length * (static_cast<double>(z >> 44) * 0x1p-20);
  }

 private:
  std::uint64_t state_;
};

/// The matrix of a rotation, all alike likely, with its entries rounded to multiples of 2^-20.
inline Matrix3<double> any_rotation(Random& random) {
  for (;;) {
    Quaternion<double> q;
    q.w = random.uniform(-1, 2);
    for (int k = 0; k < 3; ++k) q.v[k] = random.uniform(-1, 2);
    const double squared = q.w * q.w + q.v.dot(q.v);
    if (squared < 0.01 || squared > 1) continue;
    Matrix3<double> axes = matrix_of(normalised(q));
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) axes(i, j) = measured_shapes_detail::on_grid(axes(i, j));
    }
    return axes;
  }
}

}  // namespace pairs_spared_detail

// [scattered-bodies]
/// Bodies at random positions in a cube from the origin and in random orientations; body i is a
/// copy of shape i mod `shapes`. The same for equal arguments on every machine.
///
/// Origins and entries of the axes are multiples of 2^-20. So the vertices of measured_shapes() are
/// carried without rounding, and the bodies in the world are exactly the images of the shapes; in
/// return the axes are orthonormal to about 2^-19 only.
/// @param count,shapes at least 1
/// @param side of the cube, m, from 2^-20 to 4,096; rounded down to a multiple of 2^-20
/// @throws std::invalid_argument if an argument is not in its range
inline std::vector<PlacedBody> scattered_bodies(int count, int shapes, double side,
                                                std::uint64_t seed) {
  using namespace pairs_spared_detail;
  if (count < 1) throw_invalid_argument("count", std::to_string(count), "must be at least 1");
  if (shapes < 1) throw_invalid_argument("shapes", std::to_string(shapes), "must be at least 1");
  if (!(side >= measured_shapes_detail::grid && side <= 4096)) {
    throw_invalid_argument("side", number_text(side), "must be from 2^-20 to 4,096");
  }
  Random random(seed);
  std::vector<PlacedBody> bodies;
  for (int i = 0; i < count; ++i) {
    PlacedBody body;
    body.shape = i % shapes;
    for (int k = 0; k < 3; ++k) {
      body.frame.origin[k] = measured_shapes_detail::on_grid(random.uniform(0, side));
    }
    body.frame.axes = any_rotation(random);
    bodies.push_back(std::move(body));
  }
  return bodies;
}
// [/scattered-bodies]

// [scene-counts]
/// How many pairs of a scene meet, and how many may meet by each kind of volume.
struct SceneCounts {
  int pairs = 0;                                        ///< n (n − 1) / 2
  int meet = 0;                                         ///< pairs of bodies with a common point
  std::array<int, all_volume_kinds.size()> may_meet{};  ///< by kind
  std::array<int, all_volume_kinds.size()> missed{};    ///< pairs that meet and were called apart

  /// Pairs that the kind rejects: for these the bodies need not be compared. 0 without pairs.
  /// @throws std::invalid_argument if the kind is none of all_volume_kinds
  int spared(VolumeKind kind) const {
    return pairs - may_meet[volume_kinds_detail::index_of(kind)];
  }
  /// Pairs whose volumes may meet and whose bodies do not. 0 without pairs.
  /// @throws std::invalid_argument if the kind is none of all_volume_kinds
  int false_alarms(VolumeKind kind) const {
    const std::size_t at = volume_kinds_detail::index_of(kind);
    return may_meet[at] - (meet - missed[at]);
  }
};
// [/scene-counts]

namespace pairs_spared_detail {

/// All kinds of volumes of one shape or body.
using Volumes = std::vector<BoundingVolume>;

inline Volumes volumes_of(const Mesh<double>& mesh) {
  Volumes volumes;
  for (const VolumeKind kind : all_volume_kinds) {
    volumes.push_back(bounding_volume(kind, mesh.vertices));
  }
  return volumes;
}

}  // namespace pairs_spared_detail

// [count-pairs]
/// Compares each body with each other one, by every kind of volume and exactly as solid bodies.
/// @param shapes closed, oriented, of one component, all vertices used
/// @param bodies their frames must be nearly orthonormal
/// @return all counts 0 for no body or a single one
/// @throws std::invalid_argument if a shape has no vertex, a coordinate is not finite, a body's
/// shape does not exist, its frame is not nearly orthonormal, or a volume overflows
inline SceneCounts count_pairs(std::span<const MeasuredShape> shapes,
                               std::span<const PlacedBody> bodies) {
  using namespace pairs_spared_detail;
  std::vector<Volumes> of_shapes;
  for (const MeasuredShape& shape : shapes) of_shapes.push_back(volumes_of(shape.mesh));
  std::vector<Volumes> volumes(bodies.size());
  std::vector<MeshTree<double>> solids;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const auto shape = static_cast<std::size_t>(bodies[i].shape);
    if (shape >= shapes.size()) {
      throw_invalid_argument("bodies", std::to_string(bodies[i].shape), "there is no such shape");
    }
    for (const BoundingVolume& v : of_shapes[shape]) {
      volumes[i].push_back(carried(v, bodies[i].frame));
    }
    solids.emplace_back(transformed(shapes[shape].mesh, bodies[i].frame));
  }
  SceneCounts counts;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    for (std::size_t j = i + 1; j < bodies.size(); ++j) {
      const bool meet = solids_meet(solids[i], solids[j]);
      ++counts.pairs;
      counts.meet += meet ? 1 : 0;
      for (std::size_t k = 0; k < all_volume_kinds.size(); ++k) {
        const bool may = may_meet(volumes[i][k], volumes[j][k]);
        counts.may_meet[k] += may ? 1 : 0;
        counts.missed[k] += meet && !may ? 1 : 0;
      }
    }
  }
  return counts;
}
// [/count-pairs]

}  // namespace contact
