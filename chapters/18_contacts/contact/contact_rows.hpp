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

template <std::floating_point S>
std::optional<ImpulseRows<S>> impulse_rows(const std::vector<RigidBody<S>>& bodies,
                                           const std::vector<BodyContact<S>>& contacts) {
  ImpulseRows<S> made;
  std::vector<std::vector<std::pair<int, bool>>> of(bodies.size());  // rows, whether towards A
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const BodyContact<S>& contact = contacts[i];
    const PreparedContact<S> p = prepared<S>(bodies, contact);
    if (!(p.inverse_normal_mass > S(0))) return std::nullopt;  // two immovable bodies
    const S unit = S(1) / std::sqrt(p.inverse_normal_mass);
    const S across = S(1) / std::sqrt(p.inverse_tangent_mass);
    made.first.push_back(static_cast<int>(made.rows.size()));
    made.cone.push_back(contact.friction * unit / across);
    for (std::size_t k = 0; k < (contact.friction > S(0) ? 3 : 1); ++k) {
      for (const auto& [body, towards] : {std::pair{contact.a, true}, std::pair{contact.b, false}})
        if (bodies[index(body)].inverse_mass > S(0))
          of[index(body)].push_back({static_cast<int>(made.rows.size()), towards});
      made.rows.push_back({i, k == 0, p.direction[k], k == 0 ? unit : across});
    }
  }
  std::size_t couplings = 0;
  for (const auto& list : of) couplings += list.size() * list.size();
  const bool has_friction = made.rows.size() > contacts.size();
  if (couplings > (has_friction ? max_friction_couplings : max_couplings)) return std::nullopt;
  std::vector<Eigen::Triplet<S>> entries;
  entries.reserve(couplings);
  for (std::size_t body = 0; body < bodies.size(); ++body) {
    for (const auto& [row, towards] : of[body]) {
      for (const auto& [column, other_towards] : of[body]) {
        const ImpulseRow<S>& one = made.rows[index(row)];
        const ImpulseRow<S>& two = made.rows[index(column)];
        const S part =
            body_inverse_effective_mass<S>(bodies[body], contacts[one.contact].point, one.direction,
                                           contacts[two.contact].point, two.direction) *
            one.unit * two.unit;
        entries.emplace_back(row, column, towards == other_towards ? part : -part);
      }
    }
  }
  const auto count = static_cast<Eigen::Index>(made.rows.size());
  made.matrix.resize(count, count);
  made.matrix.setFromTriplets(entries.begin(), entries.end());
  made.constant.resize(count);
  for (Eigen::Index r = 0; r < count; ++r) {
    const ImpulseRow<S>& row = made.rows[static_cast<std::size_t>(r)];
    const BodyContact<S>& contact = contacts[row.contact];
    const S now = row.direction.dot(relative_velocity(bodies, contact));
    made.constant(r) = row.unit * (row.normal ? now - contact.min_velocity : now);
  }
  return made;
}

}  // namespace detail

}  // namespace contact
