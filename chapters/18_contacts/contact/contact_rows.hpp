/// @file
/// Many contacts at once: the impulses as one vector, and the velocities as a linear function of
/// it.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>
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

/// A movable body and its rows, in their order.
template <std::floating_point S>
struct RowsOnBody {
  S mass = S(0);
  S inverse_mass = S(0);
  Matrix3<S> inertia = Matrix3<S>::Zero();
  std::vector<RowOnBody<S>> rows;
};

/// Scaled velocities along the rows, M y + c, for scaled impulses y. The scales make the diagonal
/// of M equal to 1 for normals. The two tangents of a contact have the same scale, so that its
/// friction cone is round; the stiffer tangent has the diagonal 1. The least velocity is subtracted
/// from normal velocities.
///
/// M is J W Jᵀ, with the velocities J along the rows and the inverse masses W of the bodies. Its
/// entries are computed where they are needed: see assemble().
template <std::floating_point S>
struct ImpulseRows {
  std::vector<ImpulseRow<S>> rows;
  std::vector<int> first;  ///< row of each contact's normal; its tangents follow if it has friction
  std::vector<S> cone;     ///< for each contact, the largest scaled friction for a normal of 1
  std::vector<RowsOnBody<S>> bodies;   ///< the movable ones with a contact
  std::vector<std::array<int, 2>> on;  ///< for each row, its bodies: A, B; −1 for none
  Eigen::SparseMatrix<S> matrix;       ///< M, or without entries: see assemble()
  Numbers<S> constant;
};

/// The rows of all contacts with their scales, and the bodies that they move.
/// @param prepared of the same bodies
/// @return whether there is no contact of two immovable bodies
template <std::floating_point S>
bool add_rows(const std::vector<RigidBody<S>>& bodies,
              const std::vector<PreparedContact<S>>& prepared, ImpulseRows<S>& made) {
  std::vector<std::size_t> contacts(bodies.size(), 0);
  for (const PreparedContact<S>& p : prepared)
    for (const int body : {p.contact.a, p.contact.b}) ++contacts[index(body)];
  std::vector<int> number(bodies.size(), -1);
  for (std::size_t body = 0; body < bodies.size(); ++body) {
    const RigidBody<S>& one = bodies[body];
    if (!(one.inverse_mass > S(0)) || contacts[body] == 0) continue;
    number[body] = static_cast<int>(made.bodies.size());
    made.bodies.push_back({one.mass, one.inverse_mass, one.inertia, {}});
    made.bodies.back().rows.reserve(3 * contacts[body]);
  }
  made.rows.reserve(3 * prepared.size());
  made.on.reserve(3 * prepared.size());
  for (std::size_t i = 0; i < prepared.size(); ++i) {
    const PreparedContact<S>& p = prepared[i];
    const BodyContact<S>& contact = p.contact;
    if (!(p.inverse_normal_mass > S(0))) return false;  // two immovable bodies
    const S unit = S(1) / std::sqrt(p.inverse_normal_mass);
    const S across = S(1) / std::sqrt(p.inverse_tangent_mass);
    made.first.push_back(static_cast<int>(made.rows.size()));
    made.cone.push_back(contact.friction * unit / across);
    for (std::size_t k = 0; k < (contact.friction > S(0) ? 3 : 1); ++k) {
      const S scale = k == 0 ? unit : across;
      for (const bool on_a : {true, false}) {
        const std::size_t body = index(on_a ? contact.a : contact.b);
        if (number[body] < 0) continue;
        const Vector3<S> along = p.direction[k] * (on_a ? scale : -scale);
        const Vector3<S> lever_arm = contact.point - bodies[body].position;
        const Vector3<S> turn = (on_a ? p.angular_a : p.angular_b)[k] * (on_a ? scale : -scale);
        made.bodies[index(number[body])].rows.push_back(
            {static_cast<int>(made.rows.size()), along, lever_arm.cross(along), turn});
      }
      made.rows.push_back({i, k == 0, p.direction[k], scale});
      made.on.push_back({number[index(contact.a)], number[index(contact.b)]});
    }
  }
  return true;
}

/// What the impulses of the rows on one body do to each other through it: entry (i, k) is the
/// scaled velocity along the i-th of them by the k-th. Symmetric to the bit.
template <std::floating_point S>
Eigen::Matrix<S, Eigen::Dynamic, Eigen::Dynamic> couplings_on(const std::vector<RowOnBody<S>>& rows,
                                                              const S& inverse_mass) {
  const auto count = static_cast<Eigen::Index>(rows.size());
  Eigen::Matrix<S, Eigen::Dynamic, Eigen::Dynamic> block(count, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const RowOnBody<S>& row = rows[static_cast<std::size_t>(i)];
    for (Eigen::Index k = 0; k <= i; ++k) {
      const RowOnBody<S>& earlier = rows[static_cast<std::size_t>(k)];
      block(i, k) = block(k, i) =
          row.along.dot(earlier.along) * inverse_mass + row.arm.dot(earlier.turn);
    }
  }
  return block;
}

/// Of one body, its rows in their order and their couplings with one of them; none if it is
/// immovable.
template <std::floating_point S>
struct CoupledRows {
  const std::vector<RowOnBody<S>>* rows = nullptr;
  const S* couplings = nullptr;
};

/// Writes a column of the matrix: its couplings on both bodies of its contact, merged.
/// @param row, entry where the column begins in the matrix
/// @return the number of its entries
template <std::floating_point S>
int write_column(const CoupledRows<S>& one, const CoupledRows<S>& two, int* row, S* entry) {
  const std::size_t rows_one = one.rows->size();
  const std::size_t rows_two = two.rows->size();
  std::size_t i = 0;
  std::size_t k = 0;
  int written = 0;
  for (; i < rows_one || k < rows_two; ++written) {
    const int first = i < rows_one ? (*one.rows)[i].row : std::numeric_limits<int>::max();
    const int second = k < rows_two ? (*two.rows)[k].row : std::numeric_limits<int>::max();
    row[written] = std::min(first, second);
    entry[written] = first <= second ? one.couplings[i++] : S(0);
    if (second <= first) entry[written] += two.couplings[k++];
  }
  return written;
}

/// The number of pairs of rows on the same body.
template <std::floating_point S>
std::size_t couplings_of(const ImpulseRows<S>& problem) {
  std::size_t couplings = 0;
  for (const RowsOnBody<S>& body : problem.bodies) couplings += body.rows.size() * body.rows.size();
  return couplings;
}

/// Computes the entries of M, if this has not been done yet. A step at rest does without.
template <std::floating_point S>
void assemble(ImpulseRows<S>& problem) {
  const auto count = static_cast<Eigen::Index>(problem.rows.size());
  if (problem.matrix.rows() == count) return;
  problem.matrix.resize(count, count);
  problem.matrix.resizeNonZeros(
      static_cast<Eigen::Index>(couplings_of(problem)));  // or fewer: see below
  std::vector<Eigen::Matrix<S, Eigen::Dynamic, Eigen::Dynamic>> blocks;
  for (const RowsOnBody<S>& body : problem.bodies)
    blocks.push_back(couplings_on(body.rows, body.inverse_mass));
  const std::vector<RowOnBody<S>> none;
  std::vector<Eigen::Index> next(blocks.size(), 0);  // of each body, the column of its next row
  const auto coupled = [&](int body) -> CoupledRows<S> {
    if (body < 0) return {&none, nullptr};
    const std::size_t at = index(body);
    return {&problem.bodies[at].rows, blocks[at].col(next[at]++).data()};
  };
  int written = 0;
  for (Eigen::Index r = 0; r < count; ++r) {
    const auto [a, b] = problem.on[static_cast<std::size_t>(r)];
    const CoupledRows<S> one = coupled(std::min(a, b));
    const CoupledRows<S> two = coupled(std::max(a, b));
    problem.matrix.outerIndexPtr()[r] = written;
    written += write_column(one, two, problem.matrix.innerIndexPtr() + written,
                            problem.matrix.valuePtr() + written);
  }
  problem.matrix.outerIndexPtr()[count] = written;
  problem.matrix.resizeNonZeros(written);
}

/// The rows of all contacts, without the entries of M.
/// @param prepared of the same bodies
/// @return nothing if two immovable bodies touch, or for too many couplings
template <std::floating_point S>
std::optional<ImpulseRows<S>> impulse_rows(const std::vector<RigidBody<S>>& bodies,
                                           const std::vector<PreparedContact<S>>& prepared) {
  ImpulseRows<S> made;
  if (!add_rows(bodies, prepared, made)) return std::nullopt;
  const bool has_friction = made.rows.size() > prepared.size();
  if (couplings_of(made) > (has_friction ? max_friction_couplings : max_couplings))
    return std::nullopt;
  const auto count = static_cast<Eigen::Index>(made.rows.size());
  made.constant.resize(count);
  for (Eigen::Index r = 0; r < count; ++r) {
    const ImpulseRow<S>& row = made.rows[static_cast<std::size_t>(r)];
    const BodyContact<S>& contact = prepared[row.contact].contact;
    const S now = row.direction.dot(relative_velocity(bodies, contact));
    made.constant(r) = row.unit * (row.normal ? now - contact.min_velocity : now);
  }
  return made;
}

/// The change of the velocities of a body by scaled impulses y of its rows.
template <std::floating_point S>
struct BodyChange {
  Vector3<S> velocity = Vector3<S>::Zero();
  Vector3<S> angular_velocity = Vector3<S>::Zero();
};

template <std::floating_point S>
BodyChange<S> change_of(const RowsOnBody<S>& body, const Numbers<S>& y) {
  BodyChange<S> sum;
  for (const RowOnBody<S>& row : body.rows) {
    sum.velocity += row.along * y(row.row);
    sum.angular_velocity += row.turn * y(row.row);
  }
  sum.velocity *= body.inverse_mass;
  return sum;
}

/// The scaled velocities M y + c, through the velocities of the bodies.
template <std::floating_point S>
Numbers<S> velocities(const ImpulseRows<S>& problem, const Numbers<S>& y) {
  Numbers<S> sum = problem.constant;
  for (const RowsOnBody<S>& body : problem.bodies) {
    const BodyChange<S> change = change_of(body, y);
    for (const RowOnBody<S>& row : body.rows)
      sum(row.row) += row.along.dot(change.velocity) + row.arm.dot(change.angular_velocity);
  }
  return sum;
}

/// y · M y: twice the kinetic energy of the bodies that impulses y move from rest.
template <std::floating_point S>
S squared_change(const ImpulseRows<S>& problem, const Numbers<S>& y) {
  S sum(0);
  for (const RowsOnBody<S>& body : problem.bodies) {
    const BodyChange<S> change = change_of(body, y);
    for (const RowOnBody<S>& row : body.rows)
      sum += y(row.row) * (row.along.dot(change.velocity) + row.arm.dot(change.angular_velocity));
  }
  return sum;
}

}  // namespace detail

}  // namespace contact
