/// @file
/// Inertia tensors: of simple shapes and of closed meshes, about another point, in rotated axes,
/// and of composite bodies.
#pragma once

#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include <contact/invalid_argument.hpp>
#include <contact/vector.hpp>

namespace contact {

// [mass-properties]
/// Mass, centre of mass and inertia tensor of a rigid body.
template <Ring S>
struct MassProperties {
  S mass = S(0);                           ///< kg
  Vector3<S> centre = Vector3<S>::Zero();  ///< centre of mass, m
  /// About the centre of mass, in the axes in which `centre` is given, kg·m². Symmetric.
  Matrix3<S> inertia = Matrix3<S>::Zero();
};
// [/mass-properties]

namespace detail {

template <Ring S>
void require_size(const char* argument, const S& x) {
  if (!is_finite(x) || !(S(0) < x)) {
    throw_invalid_argument(argument, number_text(x), "must be finite and greater than 0");
  }
}

template <Ring S>
Matrix3<S> diagonal(const S& x, const S& y, const S& z) {
  Matrix3<S> m = Matrix3<S>::Zero();
  m(0, 0) = x;
  m(1, 1) = y;
  m(2, 2) = z;
  return m;
}

}  // namespace detail

// [simple-shapes]
/// The inertia tensor of a solid sphere about its centre: 2/5 m r² about every axis.
/// @param mass kg, finite and greater than 0
/// @param radius m, finite and greater than 0
/// @return kg·m², off by a few u
/// @throws std::invalid_argument naming the argument and its value
template <Scalar S>
Matrix3<S> sphere_inertia(const S& mass, const S& radius) {
  detail::require_size("mass", mass);
  detail::require_size("radius", radius);
  const S i = S(2) * mass * radius * radius / S(5);
  return detail::diagonal<S>(i, i, i);
}

/// The inertia tensor of a solid box about its centre, along its edges: about x, m (b² + c²)/12.
/// @param mass kg, finite and greater than 0
/// @param size whole lengths of the edges (not halves) along x, y and z, m, each finite and greater
/// than 0
/// @return kg·m², off by a few u
/// @throws std::invalid_argument naming the argument and its value
template <Scalar S>
Matrix3<S> box_inertia(const S& mass, const Vector3<S>& size) {
  detail::require_size("mass", mass);
  for (int k = 0; k < 3; ++k) detail::require_size("size", S(size(k)));
  const S x = size.x() * size.x();
  const S y = size.y() * size.y();
  const S z = size.z() * size.z();
  return detail::diagonal<S>(mass * (y + z) / S(12), mass * (z + x) / S(12),
                             mass * (x + y) / S(12));
}

/// The inertia tensor of a solid cylinder about its centre, with its axis along z: m r²/2 about the
/// axis and m (3 r² + h²)/12 about a perpendicular one.
/// @param mass kg, finite and greater than 0
/// @param radius, height m, finite and greater than 0
/// @return kg·m², off by a few u
/// @throws std::invalid_argument naming the argument and its value
template <Scalar S>
Matrix3<S> cylinder_inertia(const S& mass, const S& radius, const S& height) {
  detail::require_size("mass", mass);
  detail::require_size("radius", radius);
  detail::require_size("height", height);
  const S r2 = radius * radius;
  const S transverse = mass * (S(3) * r2 + height * height) / S(12);
  return detail::diagonal<S>(transverse, transverse, mass * r2 / S(2));
}

/// The inertia tensor of a solid capsule about its centre, with its axis along z: a cylinder and
/// two half spheres of one density.
///
/// A half sphere has its centre of mass 3/8 r from its flat face; at h/2 from the centre of the
/// capsule, each of its kilograms adds 2/5 r² + h²/4 + 3/8 h r about a perpendicular axis.
/// @param mass of the whole, kg, finite and greater than 0
/// @param radius m, finite and greater than 0
/// @param height of the cylinder alone, without the caps, m, finite and not negative
/// @return kg·m², off by a few u
/// @throws std::invalid_argument naming the argument and its value
template <Scalar S>
Matrix3<S> capsule_inertia(const S& mass, const S& radius, const S& height) {
  detail::require_size("mass", mass);
  detail::require_size("radius", radius);
  if (!is_finite(height) || height < S(0)) {
    throw_invalid_argument("height", number_text(height), "must be finite and not negative");
  }
  const S r2 = radius * radius;
  const S h2 = height * height;
  // Volumes π r² h and 4/3 π r³: their shares need no π.
  const S whole = S(3) * height + S(4) * radius;
  const S middle = mass * (S(3) * height / whole);
  const S caps = mass * (S(4) * radius / whole);
  const S along = middle * r2 / S(2) + caps * (S(2) * r2 / S(5));
  const S transverse = middle * (S(3) * r2 + h2) / S(12) +
                       caps * (S(2) * r2 / S(5) + h2 / S(4) + S(3) * height * radius / S(8));
  return detail::diagonal<S>(transverse, transverse, along);
}
// [/simple-shapes]

/// The moment of inertia of a thin rod about any perpendicular axis through its middle: m l²/12.
/// About its own line it has none, so its tensor has no inverse; in a plane one number is enough.
/// @param mass kg, finite and greater than 0
/// @param length of the whole rod, m, finite and greater than 0
/// @return kg·m², off by a few u
/// @throws std::invalid_argument naming the argument and its value
template <Scalar S>
S rod_inertia(const S& mass, const S& length) {
  detail::require_size("mass", mass);
  detail::require_size("length", length);
  return mass * length * length / S(12);
}

// [parallel-axis]
/// The parallel-axis theorem: m (|d|² 1 − d dᵀ), the difference between a body's inertia tensor
/// about a point and that about its centre of mass.
///
/// Add it to go from the centre of mass to the point, subtract it to go back. Between two other
/// points, go through the centre of mass.
/// @param mass kg
/// @param d from the centre of mass to the point, m; its sign does not matter
/// @return kg·m²
template <Ring S>
Matrix3<S> parallel_axis(const S& mass, const Vector3<S>& d) {
  const S length_squared = d.x() * d.x() + d.y() * d.y() + d.z() * d.z();
  Matrix3<S> moved;
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) {
      const S here = i == k ? S(length_squared - d(i) * d(k)) : S(-(d(i) * d(k)));
      moved(i, k) = mass * here;
    }
  }
  return moved;
}
// [/parallel-axis]

// [rotated]
/// A body's inertia tensor in the axes of the world: R I Rᵀ. Its inverse transforms the same way.
/// @param inertia about the centre of mass, in the body's axes, kg·m²
/// @param rotation R: its columns are the body's axes in world coordinates
/// @return kg·m², exactly symmetric
template <Ring S>
Matrix3<S> rotated(const Matrix3<S>& inertia, const Matrix3<S>& rotation) {
  const Matrix3<S> half = rotation * inertia;
  Matrix3<S> turned = half * rotation.transpose();
  for (int i = 0; i < 3; ++i) {
    for (int k = i + 1; k < 3; ++k) turned(k, i) = turned(i, k);
  }
  return turned;
}
// [/rotated]

// [together]
/// A composite body: several parts fixed to each other.
///
/// Masses add, centres of mass are averaged with their masses as weights, and each part's tensor is
/// moved to the common centre of mass. A hole is a part with negative mass and negated tensor.
/// @return nothing if the masses add up to 0 (or there are no parts)
template <Scalar S>
std::optional<MassProperties<S>> combine(const std::vector<MassProperties<S>>& parts) {
  MassProperties<S> whole;
  Vector3<S> moment = Vector3<S>::Zero();
  for (const MassProperties<S>& part : parts) {
    whole.mass = whole.mass + part.mass;
    moment = moment + part.centre * part.mass;
  }
  if (whole.mass == S(0)) return std::nullopt;
  whole.centre = moment / whole.mass;
  for (const MassProperties<S>& part : parts) {
    whole.inertia = whole.inertia + part.inertia +
                    parallel_axis<S>(part.mass, Vector3<S>(part.centre - whole.centre));
  }
  return whole;
}
// [/together]

/// The three vertices of a triangle of a mesh, as indices into its list of vertices.
using VertexIndices = std::array<std::size_t, 3>;

namespace detail {

/// ∫ dV, ∫ x dV and ∫ x xᵀ dV of the tetrahedra between a point and the triangles of a mesh, with x
/// from that point.
template <Scalar S>
struct Moments {
  S volume = S(0);
  Vector3<S> first = Vector3<S>::Zero();
  Matrix3<S> second = Matrix3<S>::Zero();
};

template <Scalar S>
Moments<S> moments_about(const Vector3<S>& from, const std::vector<Vector3<S>>& vertices,
                         const std::vector<VertexIndices>& triangles) {
  Moments<S> sum;
  for (const VertexIndices& corners : triangles) {
    const Vector3<S> a = vertices[corners[0]] - from;
    const Vector3<S> b = vertices[corners[1]] - from;
    const Vector3<S> c = vertices[corners[2]] - from;
    const S det = a.dot(Vector3<S>(b.cross(c)));  // six times the volume, with its sign
    const Vector3<S> s = a + b + c;
    sum.volume = sum.volume + det / S(6);
    sum.first = sum.first + s * S(det / S(24));
    const Matrix3<S> squares =
        s * s.transpose() + a * a.transpose() + b * b.transpose() + c * c.transpose();
    sum.second = sum.second + squares * S(det / S(120));
  }
  return sum;
}

}  // namespace detail

// [mesh]
/// Mass, centre of mass and inertia tensor of the solid inside a closed mesh.
///
/// Each triangle and an apex near the mesh span a tetrahedron with a signed volume; what lies
/// outside the solid is counted as often with plus as with minus. For a tetrahedron with its apex
/// at 0 and the vertices a, b, c, with D = a · (b × c) and s = a + b + c: the volume is D/6, ∫x is
/// D s/24 and ∫x xᵀ is D (s sᵀ + a aᵀ + b bᵀ + c cᵀ)/120. With C = ∫x xᵀ about the centre of mass
/// the tensor is ρ (tr C · 1 − C). The moments are computed twice, about the first vertex and then
/// about the centre of mass found from them, so that a mesh far from the origin loses no digits
/// that its own coordinates have.
/// @param density kg/m³, finite and greater than 0
/// @param vertices m, finite
/// @param triangles of a closed surface; seen from outside each runs counter-clockwise
/// @return nothing if the volume is not greater than 0: not closed, inside out, or flat. Off by
/// about γ(n + 10) of the sums of the tetrahedra's magnitudes, for n triangles
/// @throws std::invalid_argument naming the argument, if a vertex is not finite or an index is out
/// of range
/// @see Blow and Binstock, *How to find the inertia tensor (or other mass properties) of a 3D solid
/// body represented by a triangle mesh* (2004)
template <Scalar S>
std::optional<MassProperties<S>> mesh_mass(const S& density,
                                           const std::vector<Vector3<S>>& vertices,
                                           const std::vector<VertexIndices>& triangles) {
  detail::require_size("density", density);
  for (const Vector3<S>& vertex : vertices) require_finite("vertices", vertex);
  for (const VertexIndices& corners : triangles) {
    for (const std::size_t corner : corners) {
      if (corner >= vertices.size()) {
        throw_invalid_argument("triangles", std::to_string(corner), "is not in the list");
      }
    }
  }
  if (triangles.empty()) return std::nullopt;
  const Vector3<S>& start = vertices[triangles.front()[0]];
  const auto rough = detail::moments_about(start, vertices, triangles);
  if (!(S(0) < rough.volume)) return std::nullopt;
  const Vector3<S> near = start + Vector3<S>(rough.first / rough.volume);
  const auto fine = detail::moments_about(near, vertices, triangles);
  if (!(S(0) < fine.volume)) return std::nullopt;
  MassProperties<S> body;
  body.mass = density * fine.volume;
  const Vector3<S> rest = fine.first / fine.volume;  // error of the first centre
  body.centre = near + rest;
  const Matrix3<S> second = fine.second - rest * Vector3<S>(rest * fine.volume).transpose();
  const S trace = second(0, 0) + second(1, 1) + second(2, 2);
  body.inertia = detail::diagonal<S>(trace, trace, trace) - second;
  body.inertia = body.inertia * density;
  return body;
}
// [/mesh]

/// The principal axes of a body, about which it rotates without wobbling, and its moments of
/// inertia about them.
template <std::floating_point S>
struct PrincipalAxes {
  Vector3<S> moments = Vector3<S>::Zero();       ///< kg·m², in increasing order
  Matrix3<S> rotation = Matrix3<S>::Identity();  ///< its columns are the axes, right-handed
};

// [principal-axes]
/// The principal axes of a symmetric tensor, by Jacobi's rotations.
///
/// Each rotation makes one pair of off-diagonal entries zero; after a few iterations over the three
/// pairs all are as small as rounding allows.
/// @param inertia symmetric, finite, kg·m²
/// @return moments off by a few u of the largest; R · diag(moments) · Rᵀ gives the tensor back.
/// Where two moments are equal, their axes are any two perpendicular ones
/// @see Golub and Van Loan, *Matrix Computations*, 4th edition, section 8.5
template <std::floating_point S>
PrincipalAxes<S> principal_axes(const Matrix3<S>& inertia) {
  Matrix3<S> a = inertia;
  Matrix3<S> v = Matrix3<S>::Identity();
  constexpr std::array<std::array<int, 2>, 3> pairs{{{0, 1}, {0, 2}, {1, 2}}};
  for (int round = 0; round < 12; ++round) {
    bool done = true;
    for (const auto& [p, q] : pairs) {
      if (std::abs(a(p, q)) <=
          std::numeric_limits<S>::epsilon() / S(4) * std::sqrt(std::abs(a(p, p) * a(q, q)))) {
        continue;
      }
      done = false;
      const S theta = (a(q, q) - a(p, p)) / (S(2) * a(p, q));
      const S t =
          (theta < S(0) ? S(-1) : S(1)) / (std::abs(theta) + std::sqrt(theta * theta + S(1)));
      const S c = S(1) / std::sqrt(t * t + S(1));
      const S s = t * c;
      for (int k = 0; k < 3; ++k) {  // columns
        const S kp = a(k, p);
        const S kq = a(k, q);
        a(k, p) = c * kp - s * kq;
        a(k, q) = s * kp + c * kq;
        const S vp = v(k, p);
        const S vq = v(k, q);
        v(k, p) = c * vp - s * vq;
        v(k, q) = s * vp + c * vq;
      }
      for (int k = 0; k < 3; ++k) {  // rows
        const S pk = a(p, k);
        const S qk = a(q, k);
        a(p, k) = c * pk - s * qk;
        a(q, k) = s * pk + c * qk;
      }
      a(p, q) = a(q, p) = S(0);
    }
    if (done) break;
  }
  std::array<int, 3> order{0, 1, 2};
  for (int i = 0; i < 2; ++i) {
    for (int k = 0; k < 2 - i; ++k) {
      const auto at = static_cast<std::size_t>(k);
      if (a(order[at + 1], order[at + 1]) < a(order[at], order[at])) {
        std::swap(order[at], order[at + 1]);
      }
    }
  }
  PrincipalAxes<S> result;
  for (int k = 0; k < 3; ++k) {
    const int from = order[static_cast<std::size_t>(k)];
    result.moments(k) = a(from, from);
    result.rotation.col(k) = v.col(from);
  }
  const Vector3<S> third = result.rotation.col(0).cross(result.rotation.col(1));
  if (third.dot(result.rotation.col(2)) < S(0)) {
    result.rotation.col(2) = -result.rotation.col(2);
  }
  return result;
}
// [/principal-axes]

}  // namespace contact
