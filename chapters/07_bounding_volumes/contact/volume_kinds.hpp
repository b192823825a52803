/// @file
/// Bounding volumes of ten kinds behind one interface: made in the object's frame, carried into the
/// world, compared, measured.
#pragma once

#include <array>
#include <cmath>
#include <contact/aabb.hpp>
#include <contact/box_around.hpp>
#include <contact/carried_points.hpp>
#include <contact/carried_volumes.hpp>
#include <contact/convex_hull.hpp>
#include <contact/frame.hpp>
#include <contact/grown_sphere.hpp>
#include <contact/hull.hpp>
#include <contact/invalid_argument.hpp>
#include <contact/locate_in_mesh.hpp>
#include <contact/mesh.hpp>
#include <contact/mesh_edges.hpp>
#include <contact/mesh_pairs.hpp>
#include <contact/mesh_shapes.hpp>
#include <contact/mesh_tree.hpp>
#include <contact/oriented_box.hpp>
#include <contact/principal_axes.hpp>
#include <contact/ray_kdop.hpp>
#include <contact/shapes.hpp>
#include <contact/slab_volumes.hpp>
#include <contact/smallest_box.hpp>
#include <contact/smallest_sphere.hpp>
#include <contact/vector.hpp>
#include <contact/volumes_meet.hpp>
#include <cstddef>
#include <numbers>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace contact {

// [volume-kinds]
/// A kind of bounding volume: its shape, and how it is made.
enum class VolumeKind {
  grown_sphere,     ///< the lecture's, with a radius that reaches every point
  smallest_sphere,  ///< the smallest one
  aabb,             ///< along the axes of the world
  object_box,       ///< along the axes of the object's frame
  principal_box,    ///< along the principal axes of the points
  smallest_box,     ///< the smallest one that the search finds
  dop_14,           ///< slabs along the axes and the diagonals of a cube
  dop_18,           ///< slabs along the axes and the diagonals of its faces
  dop_26,           ///< slabs along all of these
  hull              ///< the convex hull
};
/// All kinds, in the order of VolumeKind.
inline constexpr std::array<VolumeKind, 10> all_volume_kinds{
    VolumeKind::grown_sphere, VolumeKind::smallest_sphere, VolumeKind::aabb,
    VolumeKind::object_box,   VolumeKind::principal_box,   VolumeKind::smallest_box,
    VolumeKind::dop_14,       VolumeKind::dop_18,          VolumeKind::dop_26,
    VolumeKind::hull};
// [/volume-kinds]

namespace volume_kinds_detail {

/// The position of a kind in all_volume_kinds; throws if it is none of them.
inline std::size_t index_of(VolumeKind kind) {
  const auto at = static_cast<std::size_t>(kind);
  if (at >= all_volume_kinds.size()) {
    throw_invalid_argument("kind", std::to_string(static_cast<int>(kind)), "there is no such kind");
  }
  return at;
}

}  // namespace volume_kinds_detail

/// The name of a kind, for tables.
/// @throws std::invalid_argument if the kind is none of all_volume_kinds
inline const char* name_of(VolumeKind kind) {
  constexpr std::array<const char*, all_volume_kinds.size()> names{
      "grown sphere", "smallest sphere", "AABB",   "object's box", "principal box",
      "smallest box", "14-DOP",          "18-DOP", "26-DOP",       "hull"};
  return names[volume_kinds_detail::index_of(kind)];
}

// ---------------------------------------------------------------- volumes in m³

/// 4/3 π r³, rounded: 0 for a point, ∞ after an overflow, NaN for a radius NaN, negative for a
/// negative radius. The centre does not matter.
template <FloatOrDouble S>
double volume(const Sphere<S>& sphere) {
  const auto r = static_cast<double>(sphere.radius);
  return 4 * std::numbers::pi / 3 * r * r * r;
}
/// The product of the edges, rounded.
/// @return 0 if an edge is 0; else NaN if a number is NaN, ±∞ or NaN if one is infinite, and ±∞
/// after an overflow. Each edge with low > high changes the sign.
template <FloatOrDouble S>
double volume(const Aabb<S>& box) {
  double product = 1;
  for (int k = 0; k < 3; ++k) {
    if (box.low[k] == box.high[k]) return 0;
    product *= static_cast<double>(box.high[k]) / 2 - static_cast<double>(box.low[k]) / 2;
  }
  return 8 * product;  // of halves, which do not overflow
}
/// Eight times the product of the half lengths and the determinant of the axes, which is nearly 1;
/// rounded.
/// @return 0 if a half length is 0; else NaN if one is NaN, ±∞ or NaN if one is infinite, and ±∞
/// after an overflow. Each negative half length changes the sign. Axes that are 0 give 0, or NaN
/// after an overflow; if they are not finite, the result is not.
template <FloatOrDouble S>
double volume(const OrientedBox<S>& box) {
  const Matrix3<double> axes = box.axes.template cast<double>();
  const Vector3<double> half = box.half_lengths.template cast<double>();
  if ((half.array() == 0).any()) return 0;
  return 8 * half.x() * half.y() * half.z() * std::abs(axes.determinant());
}
/// The hull as a closed mesh of its own vertices. A hull of a point or a segment becomes one
/// triangle without area, a flat one has each face twice. One of no points is a mesh without any.
/// Coordinates are copied, also those that are not finite.
/// @param points those that the hull was made of
inline Mesh<double> mesh_of(const Hull& hull, std::span<const Vector3<double>> points) {
  Mesh<double> mesh;
  std::vector<int> numbers(points.size(), 0);
  for (const int vertex : hull.vertices) {
    const auto at = static_cast<std::size_t>(vertex);
    numbers[at] = static_cast<int>(mesh.vertices.size());
    mesh.vertices.push_back(points[at]);
  }
  const auto number = [&numbers](int vertex) { return numbers[static_cast<std::size_t>(vertex)]; };
  for (const auto& [a, b, c] : triangles(hull)) {
    mesh.triangles.push_back({number(a), number(b), number(c)});
  }
  if (hull.dimension == 0) mesh.triangles.push_back({0, 0, 0});
  if (hull.dimension == 1) mesh.triangles.push_back({0, 1, 1});
  return mesh;
}
/// The volume of a hull; 0 if it is flat or has no vertex, ∞ if it is beyond the largest number,
/// NaN or ±∞ if a coordinate of its vertices is not finite.
inline double volume(const Hull& hull, std::span<const Vector3<double>> points) {
  Mesh<double> mesh = mesh_of(hull, points);
  double largest = 0;
  for (const auto& vertex : mesh.vertices)
    largest = std::max(largest, vertex.cwiseAbs().maxCoeff());
  // Far coordinates are scaled by a power of two: a product of three would overflow before the sum.
  constexpr int large = 300;
  if (!(largest > 0x1p300) || !std::isfinite(largest)) return mesh_volume(mesh).value;
  const int exponent = std::ilogb(largest) - large;
  for (auto& vertex : mesh.vertices) vertex *= std::ldexp(1.0, -exponent);
  return std::ldexp(mesh_volume(mesh).value, 3 * exponent);
}

// [solids-meet]
/// Whether two solid bodies have a point in common: their surfaces meet, or one of them is inside
/// the other. Exact for the stored vertices; touching counts.
/// @param a, b trees over closed and oriented meshes of one component each, also concave ones. If
/// the surfaces do not meet, all of one is on one side of the other, so one vertex decides.
/// @return false if a mesh has no triangles. A triangle with a coordinate that is not finite counts
/// as missing, so that the mesh is open; with all of them missing the result is false.
inline bool solids_meet(const MeshTree<double>& a, const MeshTree<double>& b) {
  if (a.mesh().triangles.empty() || b.mesh().triangles.empty()) return false;
  if (any_meeting(a, b)) return true;
  return locate_in_mesh(triangle_of(a.mesh(), 0).a, b).where != Where::outside ||
         locate_in_mesh(triangle_of(b.mesh(), 0).a, a).where != Where::outside;
}
// [/solids-meet]

// ---------------------------------------------------------------- one interface

// [bounding-volume]
/// A bounding volume of any kind, in the object's frame or carried into the world. In double, as
/// hulls are.
struct BoundingVolume {
  /// What a volume is stored as.
  using Shape = std::variant<Sphere<double>, Aabb<double>, OrientedBox<double>, Kdop<double>,
                             MeshTree<double>>;
  VolumeKind kind = VolumeKind::grown_sphere;  ///< says which alternative `shape` holds
  Shape shape;                                 ///< a hull as a mesh with a tree of boxes
  /// The vertices of the hull in the object's frame: `carried` makes boxes and slabs along the axes
  /// of the world from them. Empty for other kinds, and after `carried`.
  std::vector<Vector3<double>> extremes;
};
// [/bounding-volume]

namespace volume_kinds_detail {

/// The number of slabs' planes of a kind; 0 if it has none.
inline int slab_planes(VolumeKind kind) {
  switch (kind) {
    case VolumeKind::dop_14:
      return 14;
    case VolumeKind::dop_18:
      return 18;
    case VolumeKind::dop_26:
      return 26;
    default:
      return 0;
  }
}
inline bool is_made_again(VolumeKind kind) {
  return kind == VolumeKind::aabb || slab_planes(kind) > 0;
}

/// The shape in the object's frame.
inline BoundingVolume::Shape shape_of(VolumeKind kind, std::span<const Vector3<double>> points,
                                      const Mesh<double>& hull) {
  switch (kind) {
    case VolumeKind::grown_sphere:
      return grown_sphere<double>(points);
    case VolumeKind::smallest_sphere:
      return smallest_sphere<double>(points).sphere;
    case VolumeKind::aabb:
      return aabb_of_points<double>(points);
    case VolumeKind::object_box:
      return box_with_axes<double>(Matrix3<double>::Identity(), points);
    case VolumeKind::principal_box:
      return principal_box<double>(points);
    case VolumeKind::smallest_box:
      return smallest_box<double>(points);
    case VolumeKind::hull:
      return MeshTree<double>(hull);
    default:
      return kdop_of_points<double>(kdop_normals<double>(slab_planes(kind)), hull.vertices);
  }
}

}  // namespace volume_kinds_detail

// [make-volume]
/// The bounding volume of a kind around points in the object's frame: it contains every point.
/// @param points n ≥ 1 points, m, finite
/// @throws std::invalid_argument if there is no point, or an entry is not finite, or the volume
/// overflows; a k-DOP does not, its bounds become infinite. Also if the kind is none of
/// all_volume_kinds
inline BoundingVolume bounding_volume(VolumeKind kind, std::span<const Vector3<double>> points) {
  if (points.empty()) throw_invalid_argument("points", "{}", "a volume needs at least one point");
  for (const Vector3<double>& point : points) require_finite("points", point);
  const bool again = volume_kinds_detail::is_made_again(kind);
  Mesh<double> hull;
  if (again || kind == VolumeKind::hull) {
    hull = mesh_of(convex_hull({points.begin(), points.end()}), points);
  }
  BoundingVolume made{kind, volume_kinds_detail::shape_of(kind, points, hull), {}};
  if (again) made.extremes = std::move(hull.vertices);
  return made;
}
// [/make-volume]

// [carry-volume]
/// The volume in the world of an object whose frame is given.
///
/// Spheres and oriented boxes are carried along. AABB and k-DOPs are made again from the vertices
/// of the hull; a volume that was carried before has none, and its box or slabs are carried instead
/// (aabb_of_carried(), carried()), which makes them larger. All of these contain the exact image of
/// every point, for the frame as stored. The vertices of a hull are rounded: it contains the exact
/// image if nothing was rounded, else all but a few u of the coordinates.
/// @param frame with nearly orthonormal axes
/// @throws std::invalid_argument if the frame is not finite, the volume overflows, or an oriented
/// box is carried and the frame is not nearly orthonormal
inline BoundingVolume carried(const BoundingVolume& volume, const CoordinateFrame<double>& frame) {
  using Shape = BoundingVolume::Shape;
  const auto& extremes = volume.extremes;
  const auto carry = [&]<class V>(const V& shape) -> Shape {
    if constexpr (std::is_same_v<V, MeshTree<double>>) {
      Mesh<double> image = transformed(shape.mesh(), frame);
      for (const Vector3<double>& v : image.vertices) require_finite("frame", v);
      return MeshTree<double>(std::move(image));
    } else if constexpr (std::is_same_v<V, Aabb<double>>) {
      if (extremes.empty()) return aabb_of_carried(shape, frame);
      return aabb_of_carried_points<double>(extremes, frame);
    } else if constexpr (std::is_same_v<V, Kdop<double>>) {
      if (extremes.empty()) return carried(shape, frame);
      return kdop_of_carried<double>(shape.normals, extremes, frame);
    } else {
      return carried(shape, frame);
    }
  };
  return {volume.kind, std::visit(carry, volume.shape), {}};
}
// [/carry-volume]

// [compare-volumes]
/// Whether two volumes of one kind, in one frame, may have a point in common. If they have one, the
/// result is true. Spheres, axis-aligned boxes and hulls are decided exactly, slabs along their own
/// normals alone, oriented boxes within rounding.
/// @return of degenerate or infinite shapes and NaN what may_meet() of these, or solids_meet(),
/// does
/// @throws std::invalid_argument if the kinds differ
inline bool may_meet(const BoundingVolume& a, const BoundingVolume& b) {
  if (a.kind != b.kind || a.shape.index() != b.shape.index()) {
    throw_invalid_argument("b.kind", name_of(b.kind), "must be that of a");
  }
  return std::visit(
      [&b]<class V>(const V& first) {
        const V& second = std::get<V>(b.shape);
        if constexpr (std::is_same_v<V, MeshTree<double>>) {
          return solids_meet(first, second);
        } else {
          return may_meet(first, second);
        }
      },
      a.shape);
}
// [/compare-volumes]

/// How large a volume is, m³, rounded. For the tightness: its ratio to that of the hull.
/// @return as volume() of its shape: 0 if it is stored as a point or as flat; ∞ after an overflow,
/// of a hull perhaps NaN
inline double volume(const BoundingVolume& bounding) {
  return std::visit(
      []<class V>(const V& shape) {
        if constexpr (std::is_same_v<V, MeshTree<double>>) {
          return mesh_volume(shape.mesh()).value;
        } else {
          return volume(shape);
        }
      },
      bounding.shape);
}

}  // namespace contact
