/// @file
/// A segment against a mesh that moves: the delta matrix, the path of the point in the body's
/// frame, and how far the chord that replaces this path is from it.
///
/// Matrices, frames and paths are added and multiplied without a division. So a number that is not
/// finite, or an overflow, makes all that depends on it NaN or infinite, and a query with it has no
/// hit.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>
#include <optional>

#include <contact/arc.hpp>
#include <contact/frame.hpp>
#include <contact/invalid_argument.hpp>
#include <contact/mesh.hpp>
#include <contact/mesh_hits.hpp>
#include <contact/quaternion.hpp>
#include <contact/sine_cosine.hpp>
#include <contact/tolerance.hpp>
#include <contact/vector.hpp>

namespace contact {

/// Four rows of four numbers: a homogeneous matrix.
template <Ring S>
using Matrix4 = Eigen::Matrix<S, 4, 4>;

// [delta-matrix]
/// The matrix of a frame for column vectors: world = M · (x, y, z, 1)ᵀ. For row vectors it is the
/// transpose: world = (x, y, z, 1) · Mᵀ.
template <Ring S>
Matrix4<S> homogeneous_matrix(const CoordinateFrame<S>& frame) {
  Matrix4<S> m = Matrix4<S>::Identity();
  m.template block<3, 3>(0, 0) = frame.axes;
  m.template block<3, 1>(0, 3) = frame.origin;
  return m;
}

/// The inverse of the matrix of a frame, for column vectors: the transposed axes, and the origin
/// carried back. No division.
/// @param m of a frame: orthonormal axes. Otherwise it is not the inverse
template <Ring S>
Matrix4<S> inverse_of_frame_matrix(const Matrix4<S>& m) {
  const Matrix3<S> back = m.template block<3, 3>(0, 0).transpose();
  Matrix4<S> inverse = Matrix4<S>::Identity();
  inverse.template block<3, 3>(0, 0) = back;
  inverse.template block<3, 1>(0, 3) = -(back * m.template block<3, 1>(0, 3));
  return inverse;
}

/// M_Δ = M₁ M₀⁻¹ for column vectors: carries a point that is fixed in the body from where it is in
/// the world at pose 0 to where it is at pose 1.
/// @param m0,m1 of the body's frame at both times
template <Ring S>
Matrix4<S> delta_matrix(const Matrix4<S>& m0, const Matrix4<S>& m1) {
  return m1 * inverse_of_frame_matrix(m0);
}

/// M_Δ = M₀⁻¹ M₁ for row vectors, as the lecture writes it: a' = a · M_Δ. It is the transpose of
/// the matrix for columns. With matrices for columns the product M₀⁻¹ M₁ is another motion: the
/// same one in the coordinates of the body at pose 0, so it is right only for points given in them,
/// unless M₀ and M₁ commute.
/// @param m0,m1 matrices for row vectors, the transposes of `homogeneous_matrix`
template <Ring S>
Matrix4<S> delta_matrix_rows(const Matrix4<S>& m0, const Matrix4<S>& m1) {
  const Matrix4<S> back = inverse_of_frame_matrix<S>(m0.transpose()).transpose();
  return back * m1;
}

/// M · (a, 1)ᵀ.
template <Ring S>
Vector3<S> carried_column(const Matrix4<S>& m, const Vector3<S>& a) {
  const Eigen::Matrix<S, 4, 1> column(a.x(), a.y(), a.z(), S(1));
  const Eigen::Matrix<S, 4, 1> carried = m * column;
  return {carried(0), carried(1), carried(2)};
}
/// (a, 1) · M.
template <Ring S>
Vector3<S> carried_row(const Vector3<S>& a, const Matrix4<S>& m) {
  const Eigen::Matrix<S, 1, 4> row(a.x(), a.y(), a.z(), S(1));
  const Eigen::Matrix<S, 1, 4> carried = row * m;
  return {carried(0), carried(1), carried(2)};
}
/// The same without the matrix: into the body's frame at pose 0, and out of it at pose 1.
template <Ring S>
Vector3<S> carried_in_body(const CoordinateFrame<S>& pose0, const CoordinateFrame<S>& pose1,
                           const Vector3<S>& a) {
  return position_in_world(pose1, position_in_frame(pose0, a));
}
// [/delta-matrix]

// [delta-rounding]
/// A bound on the rounding error of each coordinate of a' = M_Δ a, with the matrix rounded as well:
/// γ(10) (|o₁| + Σ(|o₀| + |a|)), for origins o₀ and o₁, where exact means: with the stored axes.
///
/// A term passes through at most ten roundings: three in −A₀ᵀo₀, four in the product of the
/// matrices, three in that with a. Each row of |A₁||A₀ᵀ| has entries of at most 1 (Cauchy–Schwarz),
/// a few u more for stored axes.
///
/// The error grows with the distance from the world's origin, because the matrix rotates about it.
/// If a' is not finite, the bound is infinite.
template <std::floating_point S>
S delta_matrix_rounding(const CoordinateFrame<S>& pose0, const CoordinateFrame<S>& pose1,
                        const Vector3<S>& a) {
  const S size = pose1.origin.cwiseAbs().maxCoeff() +
                 S(1.001) * (pose0.origin.cwiseAbs().sum() + a.cwiseAbs().sum());
  const Matrix4<S> delta = delta_matrix(homogeneous_matrix(pose0), homogeneous_matrix(pose1));
  if (!all_finite(carried_column(delta, a))) return std::numeric_limits<S>::infinity();
  return S(1.001) * tolerance::gamma<S>(10) * size + S(64) * tolerance::underflow_unit<S>;
}

/// The same bound for `carried_in_body`: u |o₁| + γ(8) Σ|a − o₀|. The world's origin enters only by
/// the rounding of the result itself. If this is not finite, the bound is infinite.
template <std::floating_point S>
S carried_in_body_rounding(const CoordinateFrame<S>& pose0, const CoordinateFrame<S>& pose1,
                           const Vector3<S>& a) {
  if (!all_finite(carried_in_body(pose0, pose1, a))) return std::numeric_limits<S>::infinity();
  const S away = S(1.001) * Vector3<S>(a - pose0.origin).cwiseAbs().sum();
  return S(1.001) * (tolerance::unit_roundoff<S> * pose1.origin.cwiseAbs().maxCoeff() +
                     tolerance::gamma<S>(8) * away) +
         S(64) * tolerance::underflow_unit<S>;
}
// [/delta-rounding]

// [segment-against-moving-mesh]
/// The chord in the body's frame: from the point's coordinates in the body at pose 0 to those at
/// pose 1. There the mesh is at rest.
/// @param path of the point, in the world, m
template <Ring S>
Segment<S> chord_in_body(const Segment<S>& path, const CoordinateFrame<S>& pose0,
                         const CoordinateFrame<S>& pose1) {
  return {position_in_frame(pose0, path.start), position_in_frame(pose1, path.end)};
}

/// The first hit of a moving point on a moving mesh, both poses known: the chord in the body's
/// frame against the mesh.
///
/// t is the fraction of the step, the point is in the body's frame. Except for rounding of the
/// chord (γ(4) times the distances from the body's origin) the answer is exact if the body does not
/// rotate. If it rotates, the point's path in the body is curved, and `chord_bound` says how far it
/// is from the chord: within this distance of the mesh's edge or surface a hit can be missed or
/// invented. A chord of length 0, as of a point that is at rest in the body, has no hit, even on
/// the mesh.
/// @param path of the point, in the world, from start (at pose 0) to end (at pose 1), m
/// @param mesh in the body's frame, m
template <FloatOrDouble S>
std::optional<MeshHit<S>> segment_against_moving_mesh(const Segment<S>& path, const Mesh<S>& mesh,
                                                      const CoordinateFrame<S>& pose0,
                                                      const CoordinateFrame<S>& pose1) {
  return first_mesh_hit(chord_in_body(path, pose0, pose1), mesh);
}

/// The same as the lecture has it: a' = M_Δ a, and the segment from a' to b against the mesh where
/// it is in the end. The hit is in world coordinates, at pose 1.
/// @param delta for column vectors
/// @param mesh_at_end in world coordinates at pose 1, m
template <FloatOrDouble S>
std::optional<MeshHit<S>> segment_against_mesh_by_delta(const Segment<S>& path,
                                                        const Mesh<S>& mesh_at_end,
                                                        const Matrix4<S>& delta) {
  return first_mesh_hit(Segment<S>{carried_column(delta, path.start), path.end}, mesh_at_end);
}

/// With only the present pose: the point's path against the mesh where it is now, as if it had been
/// there all the time. It misses a mesh that moved over the point, and hits one that arrived after
/// the point had left.
template <FloatOrDouble S>
std::optional<MeshHit<S>> segment_against_present_mesh(const Segment<S>& path, const Mesh<S>& mesh,
                                                       const CoordinateFrame<S>& pose1) {
  return first_mesh_hit(chord_in_body(path, pose1, pose1), mesh);
}
// [/segment-against-moving-mesh]

// [rigid-motion]
/// The motion of a body during a step, at the fraction s from 0 to 1 of it: its origin is at start
/// + s · displacement, and it has rotated by s · |rotation| about the fixed axis along `rotation`.
template <Ring S>
struct RigidMotion {
  CoordinateFrame<S> start;                      ///< the body's frame at s = 0
  Vector3<S> displacement = Vector3<S>::Zero();  ///< of the body's origin, in the world, m
  Vector3<S> rotation = Vector3<S>::Zero();      ///< rotation vector, in the body's axes, rad
};
// [/rigid-motion]

/// v without its component along the unit vector k; v itself if k = 0.
template <std::floating_point S>
Vector3<S> perpendicular_part(const Vector3<S>& v, const Vector3<S>& k) {
  return v - k * k.dot(v);
}

/// The frame at a fraction of the step. Without rotation its axes are exactly those of the start.
/// The rotation must be finite: `exponential` may take one with NaN for 0.
template <std::floating_point S>
CoordinateFrame<S> frame_at(const RigidMotion<S>& motion, S s) {
  return {
      motion.start.origin + motion.displacement * s,
      Matrix3<S>(motion.start.axes * matrix_of(exponential<S>(Vector3<S>(motion.rotation * s))))};
}

/// The motion from one pose to another by the smallest angle, at constant velocity and angular
/// velocity. Two poses do not tell how often the body has turned between them.
///
/// @return the rotation is off by a few u; if the axes are equal it is exactly 0. For a half turn
/// both directions are possible, and one is taken. For axes that differ and are not finite it is
/// NaN
template <std::floating_point S>
RigidMotion<S> motion_between(const CoordinateFrame<S>& pose0, const CoordinateFrame<S>& pose1) {
  RigidMotion<S> motion{pose0, pose1.origin - pose0.origin, Vector3<S>::Zero()};
  if (pose0.axes == pose1.axes) return motion;
  const Quaternion<S> turn = quaternion_of<S>(Matrix3<S>(pose0.axes.transpose() * pose1.axes));
  const S largest = turn.v.cwiseAbs().maxCoeff();
  if (largest == S(0) && all_finite(turn.v)) return motion;
  const Vector3<S> share = turn.v / largest;
  const S length = std::sqrt(share.dot(share));
  const S half = static_cast<S>(portable_angle(double(largest * length), double(turn.w)));
  motion.rotation = share * (S(2) * half / length);
  return motion;
}

// [path-in-body]
/// The point's coordinates in the body's frame at a fraction s of the step: the frame's origin is
/// subtracted from the point's position, and the difference turned back.
///
/// Without rotation this is a straight line. With it, it is the arc of a circle if the point does
/// not move relative to the origin, and a spiral in general. The rotation must be finite, as in
/// `frame_at`.
template <std::floating_point S>
Vector3<S> path_in_body(const RigidMotion<S>& motion, const Segment<S>& path, S s) {
  const Vector3<S> start = path.start - motion.start.origin;
  const Vector3<S> travel = Vector3<S>(path.end - path.start) - motion.displacement;
  const Vector3<S> unturned = motion.start.axes.transpose() * Vector3<S>(start + travel * s);
  if (motion.rotation == Vector3<S>::Zero()) return unturned;
  return matrix_of(exponential<S>(Vector3<S>(motion.rotation * -s))) * unturned;
}
// [/path-in-body]

// [chord-bound]
/// How far the path in the body's frame can be from the chord, at the same fraction of the step:
/// (θ² r + 2 θ d)/8; in each of n equal substeps 1/n² of it.
///
/// Let y(s) be the point's position relative to the body's origin in the axes of pose 0: linear in
/// s, with y' = δ. In the turning axes the point is at q(s) = E(−sθ) y(s), where E(φ) is the
/// rotation by φ about the axis k. Differentiating twice gives q'' = E(−sθ) (θ² k×(k×y) − 2 θ k×δ),
/// of length at most θ² r + 2 θ d. A curve with |q''| ≤ m differs from its chord at s by at most m
/// s(1 − s)/2, and so by at most m/8. The second term is the Coriolis term: it remains for a path
/// through the origin.
///
/// Hypotheses, each of which is needed: the point and the body's origin move along straight lines
/// at constant velocity, the body rotates about a fixed axis through its origin at constant rate,
/// and θ is the whole angle, not modulo a turn.
/// @param angle θ, rad, not negative
/// @param distance r, m: the largest distance of the point from the body's origin, or from the axis
/// through it, at the start or the end (between them it is not larger)
/// @param displacement d, m: |displacement of the point − that of the body's origin|, or the part
/// of it that is perpendicular to the axis
/// @param substeps n, not 0: then the bound is infinite, or NaN where it would be 0
/// @return m; 0 if the angle is 0. Attained in the limit of small angles by either term alone
template <Scalar S>
S chord_bound(const S& angle, const S& distance, const S& displacement, int substeps = 1) {
  return angle * (angle * distance + S(2) * displacement) / S(8) / (S(substeps) * S(substeps));
}

/// The same for a motion and a path, with distances from the axis. Off by a few u of the distances
/// from the origin, at every scale, unless the bound itself is below the normal numbers of S;
/// exactly 0 for a translation, infinite if something overflows or is not finite, or for a rotation
/// in 0 substeps.
template <std::floating_point S>
S chord_bound(const RigidMotion<S>& motion, const Segment<S>& path, int substeps = 1) {
  constexpr S endless = std::numeric_limits<S>::infinity();
  const Vector3<S> start = path.start - motion.start.origin;
  const Vector3<S> travel = Vector3<S>(path.end - path.start) - motion.displacement;
  const Vector3<S> end = start + travel;
  if (!all_finite(motion.rotation) || !all_finite(motion.start.axes) || !all_finite(start) ||
      !all_finite(travel) || !all_finite(end)) {
    return endless;
  }
  const S largest = motion.rotation.cwiseAbs().maxCoeff();
  if (!(largest > S(0))) return S(0);
  const Vector3<S> share = motion.rotation / largest;
  const S length = std::sqrt(share.dot(share));
  const Vector3<S> k = share / length;
  // Scaled by a power of two, so that no square overflows or underflows.
  const auto off_axis = [&](Vector3<S> v) {
    int power = 0;
    std::frexp(v.cwiseAbs().maxCoeff(), &power);
    for (int i = 0; i < 3; ++i) v[i] = std::ldexp(v[i], -power);
    const Vector3<S> across = perpendicular_part<S>(motion.start.axes.transpose() * v, k);
    return std::ldexp(std::sqrt(across.dot(across)), power);
  };
  const S distance = std::max(off_axis(start), off_axis(end));
  const S bound = chord_bound<S>(largest * length, distance, off_axis(travel), substeps);
  return bound >= S(0) ? bound : endless;
}
// [/chord-bound]

// [substeps]
/// A hit on one of the chords of several substeps.
template <Ring S>
struct SubstepHit {
  int substep = 0;  ///< from 0
  S time = S(0);    ///< fraction of the whole step
  MeshHit<S> hit;   ///< its t is the fraction of the substep, its point in the body's frame
};

/// The first hit with the path replaced by n chords, whose ends are on it. The chords' distance
/// from the path is chord_bound(motion, path, n); nothing is proved about hits and misses within
/// it. A chord of length 0, or with a coordinate that is not finite, has no hit; without a finite
/// rotation there is none at all.
/// @param mesh in the body's frame, m
/// @param substeps n ≥ 1; fewer give no hit
template <FloatOrDouble S>
std::optional<SubstepHit<S>> moving_by_substeps(const Segment<S>& path, const Mesh<S>& mesh,
                                                const RigidMotion<S>& motion, int substeps) {
  if (!all_finite(motion.rotation)) return std::nullopt;
  Vector3<S> from = path_in_body<S>(motion, path, S(0));
  for (int i = 0; i < substeps; ++i) {
    const Vector3<S> to = path_in_body<S>(motion, path, S(i + 1) / S(substeps));
    if (const auto hit = first_mesh_hit(Segment<S>{from, to}, mesh)) {
      return SubstepHit<S>{i, (S(i) + hit->hit.t) / S(substeps), *hit};
    }
    from = to;
  }
  return std::nullopt;
}
// [/substeps]

}  // namespace contact
