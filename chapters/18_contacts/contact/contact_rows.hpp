/// @file
/// Many contacts at once: the impulses as one vector, and the velocities as a linear function of
/// it.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/SparseCore>

#include <contact/contact_lcp.hpp>
#include <contact/contact_solver.hpp>
#include <contact/rigid_body.hpp>
#include <contact/vector.hpp>

namespace contact {

/// The largest number of couplings (pairs of impulses on the same body) for which
/// active_set_impulses() is tried without friction.
inline constexpr std::size_t max_couplings = 400000;
/// The same with friction, which takes many attempts.
inline constexpr std::size_t max_friction_couplings = 60000;

namespace detail {

template <std::floating_point S>
using Numbers = Eigen::Matrix<S, Eigen::Dynamic, 1>;

/// An unknown impulse: at a contact, along its normal or one of two tangents.
template <std::floating_point S>
struct ImpulseRow {
  std::size_t contact = 0;
  bool normal = true;
  Vector3<S> direction = Vector3<S>::Zero();
  S unit = S(1);  ///< scale of the unknown, N·s
};

/// Scaled velocities along the rows, M y + c, for scaled impulses y. The scales make the diagonal
/// of M equal to 1 for normals. The two tangents of a contact have the same scale, so that its
/// friction cone is round; the stiffer tangent has the diagonal 1. The least velocity is subtracted
/// from normal velocities.
template <std::floating_point S>
struct ImpulseRows {
  std::vector<ImpulseRow<S>> rows;
  std::vector<int> first;  ///< row of each contact's normal; its tangents follow if it has friction
  std::vector<S> cone;     ///< for each contact, the largest scaled friction for a normal of 1
  Eigen::SparseMatrix<S> matrix;
  Numbers<S> constant;
};

/// What a unit impulse along a row changes on one of its bodies, and how the velocity along the row
/// follows from the body's: the entry of two rows of a body is `arm` of one times `turn` of the
/// other, plus the dot product of their directions by the inverse mass.
template <std::floating_point S>
struct RowOnBody {
  int row = 0;
  Vector3<S> along = Vector3<S>::Zero();  ///< the row's direction times its scale, minus on B
  Vector3<S> arm = Vector3<S>::Zero();    ///< lever arm × along
  Vector3<S> turn = Vector3<S>::Zero();   ///< change of the angular velocity
};

/// The rows of all contacts with their scales, by bodies.
/// @param prepared of the same bodies
/// @return for each movable body its rows, in their order; nothing if two immovable bodies touch
template <std::floating_point S>
std::optional<std::vector<std::vector<RowOnBody<S>>>> rows_on_bodies(
    const std::vector<RigidBody<S>>& bodies, const std::vector<PreparedContact<S>>& prepared,
    ImpulseRows<S>& made) {
  std::vector<std::vector<RowOnBody<S>>> of(bodies.size());
  for (std::size_t i = 0; i < prepared.size(); ++i) {
    const PreparedContact<S>& p = prepared[i];
    const BodyContact<S>& contact = p.contact;
    if (!(p.inverse_normal_mass > S(0))) return std::nullopt;  // two immovable bodies
    const S unit = S(1) / std::sqrt(p.inverse_normal_mass);
    const S across = S(1) / std::sqrt(p.inverse_tangent_mass);
    made.first.push_back(static_cast<int>(made.rows.size()));
    made.cone.push_back(contact.friction * unit / across);
    for (std::size_t k = 0; k < (contact.friction > S(0) ? 3 : 1); ++k) {
      const S scale = k == 0 ? unit : across;
      for (const bool on_a : {true, false}) {
        const std::size_t body = index(on_a ? contact.a : contact.b);
        if (!(bodies[body].inverse_mass > S(0))) continue;
        const Vector3<S> along = p.direction[k] * (on_a ? scale : -scale);
        const Vector3<S> lever_arm = contact.point - bodies[body].position;
        const Vector3<S> turn = (on_a ? p.angular_a : p.angular_b)[k] * (on_a ? scale : -scale);
        of[body].push_back(
            {static_cast<int>(made.rows.size()), along, lever_arm.cross(along), turn});
      }
      made.rows.push_back({i, k == 0, p.direction[k], scale});
    }
  }
  return of;
}

/// @param prepared of the same bodies
template <std::floating_point S>
std::optional<ImpulseRows<S>> impulse_rows(const std::vector<RigidBody<S>>& bodies,
                                           const std::vector<PreparedContact<S>>& prepared) {
  ImpulseRows<S> made;
  const auto of = rows_on_bodies(bodies, prepared, made);
  if (!of) return std::nullopt;
  std::size_t couplings = 0;
  for (const auto& list : *of) couplings += list.size() * list.size();
  const bool has_friction = made.rows.size() > prepared.size();
  if (couplings > (has_friction ? max_friction_couplings : max_couplings)) return std::nullopt;
  std::vector<Eigen::Triplet<S>> entries;  // each and its mirror image: symmetric to the bit
  entries.reserve(couplings);
  for (std::size_t body = 0; body < bodies.size(); ++body) {
    const std::vector<RowOnBody<S>>& list = (*of)[body];
    for (std::size_t i = 0; i < list.size(); ++i) {
      for (std::size_t k = 0; k <= i; ++k) {
        const S entry = list[i].along.dot(list[k].along) * bodies[body].inverse_mass +
                        list[i].arm.dot(list[k].turn);
        entries.emplace_back(list[i].row, list[k].row, entry);
        if (i != k) entries.emplace_back(list[k].row, list[i].row, entry);
      }
    }
  }
  const auto count = static_cast<Eigen::Index>(made.rows.size());
  made.matrix.resize(count, count);
  made.matrix.setFromTriplets(entries.begin(), entries.end());
  made.constant.resize(count);
  for (Eigen::Index r = 0; r < count; ++r) {
    const ImpulseRow<S>& row = made.rows[static_cast<std::size_t>(r)];
    const BodyContact<S>& contact = prepared[row.contact].contact;
    const S now = row.direction.dot(relative_velocity(bodies, contact));
    made.constant(r) = row.unit * (row.normal ? now - contact.min_velocity : now);
  }
  return made;
}

}  // namespace detail

}  // namespace contact
