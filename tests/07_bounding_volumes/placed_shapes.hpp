/// @file
/// The measured shapes in the world, and volumes around them of whatever kind: how large each is,
/// and whether a point is in it. Eigen only: the ladder uses them in the page.
#pragma once

#include <contact/aabb.hpp>
#include <contact/box_around.hpp>
#include <contact/enclosing_radius.hpp>
#include <contact/frame.hpp>
#include <contact/measured_shapes.hpp>
#include <contact/mesh.hpp>
#include <contact/mesh_edges.hpp>
#include <contact/mesh_shapes.hpp>
#include <contact/oriented_box.hpp>
#include <contact/pairs_spared.hpp>
#include <contact/ray_kdop.hpp>
#include <contact/shapes.hpp>
#include <contact/slab_volumes.hpp>
#include <contact/vector.hpp>
#include <contact/volume_kinds.hpp>
#include <cstddef>
#include <support/generators.hpp>
#include <type_traits>
#include <variant>
#include <vector>

namespace placed_shapes {

using Point = contact::Vector3<double>;
using Points = std::vector<Point>;

/// A volume of a body, of whatever kind.
using Volume =
    std::variant<std::monostate, contact::Sphere<double>, contact::Aabb<double>,
                 contact::OrientedBox<double>, contact::Kdop<double>, contact::Mesh<double>>;

inline double size_of(const Volume& volume) {
  return std::visit(
      []<class V>(const V& of) -> double {
        if constexpr (std::is_same_v<V, std::monostate>) {
          return 0;
        } else if constexpr (std::is_same_v<V, contact::Mesh<double>>) {
          return contact::mesh_volume(of).value;
        } else {
          return contact::volume(of);
        }
      },
      volume);
}
/// A hull is made of the points, which are in it by definition.
inline bool holds(const Volume& volume, const Point& p) {
  return std::visit(
      [&p]<class V>(const V& of) {
        if constexpr (std::is_same_v<V, contact::Aabb<double>>) {
          return contact::boxes_touch(of, contact::Aabb<double>{p, p});
        } else if constexpr (std::is_same_v<V, std::monostate> ||
                             std::is_same_v<V, contact::Mesh<double>>) {
          return true;
        } else {
          return contact::contains(of, p);
        }
      },
      volume);
}

inline const std::vector<contact::MeasuredShape>& all() {
  static const std::vector<contact::MeasuredShape> shapes = contact::measured_shapes();
  return shapes;
}

/// A shape in the world. Its frame carries the vertices without rounding; in return its axes are
/// orthonormal to about 2^-19 only, so that volumes differ by as much (`scattered_bodies`).
struct Placed {
  int shape = 0;
  contact::CoordinateFrame<double> frame;
  Points vertices;
};
inline Placed placed(generators::Random& random, int shape) {
  Placed body;
  body.shape = shape;
  body.frame = contact::scattered_bodies(1, 1, 64, random.bits())[0].frame;
  const contact::Mesh<double>& mesh = all()[static_cast<std::size_t>(shape)].mesh;
  body.vertices = contact::transformed(mesh, body.frame).vertices;
  return body;
}

}  // namespace placed_shapes
