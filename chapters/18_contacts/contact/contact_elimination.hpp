/// @file
/// Many contacts: the equations of an active set, by elimination of the impulses or of the
/// velocities of the bodies.
#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <contact/contact_coulomb.hpp>
#include <contact/contact_lcp.hpp>
#include <contact/contact_rows.hpp>
#include <contact/vector.hpp>

namespace contact {

namespace detail {

/// The largest number of unknowns that are eliminated in the order of the list.
inline constexpr Eigen::Index max_in_order = 192;

/// Calls `solve` with the LDLᵀ factorisation of a symmetric matrix, of which the part on and above
/// the diagonal is given. Few unknowns are eliminated in the order of the list: another would cost
/// more than it saves. With this index and this triangle Eigen then reads the part without a copy.
template <class Part, class Solve>
bool with_factors(const Part& part, const Solve& solve) {
  if (part.rows() <= max_in_order)
    return solve(
        Eigen::SimplicialLDLT<Part, Eigen::Upper, Eigen::NaturalOrdering<Eigen::Index>>(part));
  return solve(Eigen::SimplicialLDLT<Part, Eigen::Upper>(part));
}

template <std::floating_point S>
using UpperPart = Eigen::SparseMatrix<S, Eigen::ColMajor, Eigen::Index>;

/// The number added to a diagonal of 1, so that a singular matrix can be factorised.
template <std::floating_point S>
inline constexpr S firmness = S(0x1p16) * std::numeric_limits<S>::epsilon();

/// Iterative refinement of y in the chosen rows.
/// @param correct adds to y a correction for the negative velocities of the chosen rows; of the
/// other rows these are 0
/// @return the largest velocity that is left in a chosen row
template <std::floating_point S, class Correct>
S refine(const ImpulseRows<S>& problem, const std::vector<bool>& chosen, Numbers<S>& y,
         const Correct& correct) {
  S last = std::numeric_limits<S>::infinity();
  for (int round = 0;; ++round) {
    Numbers<S> right = -velocities(problem, y);
    for (std::size_t r = 0; r < chosen.size(); ++r)
      if (!chosen[r]) right(static_cast<Eigen::Index>(r)) = S(0);
    const S left = right.cwiseAbs().maxCoeff();
    if (round == 8 || !(left < last / S(2))) return left;
    last = left;
    correct(right, y);
  }
}

// [eliminate-rows]
/// Solves M y + c = 0 in the chosen rows, for y in these rows, by elimination of the rows: for few
/// rows.
///
/// M may be singular there, as for a table on four legs. A small number is added to its diagonal,
/// and iterative refinement removes the error: of all solutions the result is one near the initial
/// y.
/// @param number the number of each chosen row
/// @return whether the solve succeeded
template <std::floating_point S>
bool eliminate_rows(const ImpulseRows<S>& problem, const std::vector<bool>& chosen, Numbers<S>& y) {
  std::vector<int> number(chosen.size(), -1);
  int rows = 0;
  for (std::size_t r = 0; r < chosen.size(); ++r)
    if (chosen[r]) number[r] = rows++;
  UpperPart<S> part(rows, rows);
  part.reserve(problem.matrix.nonZeros() / 2 + rows);
  for (int k = 0; k < problem.matrix.outerSize(); ++k) {
    const int column = number[static_cast<std::size_t>(k)];
    if (column < 0) continue;
    part.startVec(column);
    for (typename Eigen::SparseMatrix<S>::InnerIterator it(problem.matrix, k); it; ++it) {
      const int row = number[static_cast<std::size_t>(it.row())];
      if (row >= 0 && row <= column)
        part.insertBack(row, column) = row == column ? it.value() + firmness<S> : it.value();
    }
  }
  part.finalize();
  return with_factors(part, [&](const auto& factors) {
    if (factors.info() != Eigen::Success) return false;
    refine(problem, chosen, y, [&](const Numbers<S>& velocity, Numbers<S>& changed) {
      Numbers<S> right(rows);
      for (std::size_t r = 0; r < chosen.size(); ++r)
        if (chosen[r]) right(number[r]) = velocity(static_cast<Eigen::Index>(r));
      const Numbers<S> change = factors.solve(right);
      for (std::size_t r = 0; r < chosen.size(); ++r)
        if (chosen[r]) changed(static_cast<Eigen::Index>(r)) += change(number[r]);
    });
    return y.allFinite();
  });
}
// [/eliminate-rows]

template <std::floating_point S>
using Matrix6 = Eigen::Matrix<S, 6, 6>;

/// The matrix F = Jᵀ J + ε W⁻¹ of eliminate_bodies(), on and above the diagonal.
template <std::floating_point S>
UpperPart<S> damping_matrix(const ImpulseRows<S>& problem, const std::vector<bool>& chosen) {
  using Key = std::pair<int, int>;  // column, row
  std::map<Key, Matrix6<S>> blocks;
  std::vector<std::array<const RowOnBody<S>*, 2>> of(chosen.size(), {nullptr, nullptr});
  for (std::size_t body = 0; body < problem.bodies.size(); ++body) {
    const RowsOnBody<S>& one = problem.bodies[body];
    const int at = static_cast<int>(body);
    Matrix6<S>& block = blocks[{at, at}];
    block.setZero();
    block.diagonal().template head<3>().setConstant(firmness<S> * one.mass);
    block.template bottomRightCorner<3, 3>() = one.inertia * firmness<S>;
    for (const RowOnBody<S>& row : one.rows) {
      const std::size_t r = index(row.row);
      if (!chosen[r]) continue;
      of[r][problem.on[r][0] == at ? 0 : 1] = &row;
      const S x[6] = {row.along.x(), row.along.y(), row.along.z(),
                      row.arm.x(),   row.arm.y(),   row.arm.z()};
      for (Eigen::Index k = 0; k < 6; ++k)
        for (Eigen::Index i = 0; i <= k; ++i) block(i, k) += x[i] * x[k];
    }
  }
  Matrix6<S>* block = nullptr;
  Key last{-1, -1};
  for (std::size_t r = 0; r < chosen.size(); ++r) {
    if (of[r][0] == nullptr || of[r][1] == nullptr) continue;
    const auto [a, b] = problem.on[r];
    const Key key{std::max(a, b), std::min(a, b)};
    if (key != last) {
      const auto [found, added] = blocks.try_emplace(key);
      block = &found->second;
      if (added) block->setZero();
      last = key;
    }
    const RowOnBody<S>& low = *of[r][a < b ? 0 : 1];
    const RowOnBody<S>& high = *of[r][a < b ? 1 : 0];
    const S x[6] = {low.along.x(), low.along.y(), low.along.z(),
                    low.arm.x(),   low.arm.y(),   low.arm.z()};
    const S z[6] = {high.along.x(), high.along.y(), high.along.z(),
                    high.arm.x(),   high.arm.y(),   high.arm.z()};
    for (Eigen::Index k = 0; k < 6; ++k)
      for (Eigen::Index i = 0; i < 6; ++i) (*block)(i, k) += x[i] * z[k];
  }
  const auto size = static_cast<Eigen::Index>(6 * problem.bodies.size());
  UpperPart<S> part(size, size);
  part.reserve(static_cast<Eigen::Index>(36 * blocks.size()));
  for (auto first = blocks.begin(); first != blocks.end();) {
    auto end = first;
    const int column = first->first.first;
    while (end != blocks.end() && end->first.first == column) ++end;
    for (int k = 0; k < 6; ++k) {
      part.startVec(6 * column + k);
      for (auto it = first; it != end; ++it) {
        const int row = it->first.second;
        for (int i = 0; i < (row == column ? k + 1 : 6); ++i)
          part.insertBack(6 * row + i, 6 * column + k) = it->second(i, k);
      }
    }
    first = end;
  }
  part.finalize();
  return part;
}

// [eliminate-bodies]
/// Solves M y + c = 0 in the chosen rows, for y in these rows, by elimination of the velocities of
/// the bodies: for more rows than velocities, where M = J W Jᵀ is singular. Ten boxes on each other
/// have 120 rows and 60 velocities.
///
/// Impulses y = −J z, as if each row were a damper and z velocities of the bodies, are the smallest
/// that have their effect. If they have to change the velocities along the rows by r, then
/// J W Jᵀ J z = −r, and with F = Jᵀ J + ε W⁻¹ and a small ε this is z = −F⁻¹ W⁻¹ F⁻¹ Jᵀ r: Jᵀ r
/// has no component along which F is nearly singular. Iterative refinement removes the error of ε:
/// of all solutions the result is the one nearest to the initial y.
/// @return whether velocities up to rounding are left in the rows: if not, they exclude each other,
/// or the masses differ so much that F has lost too many digits
template <std::floating_point S>
bool eliminate_bodies(const ImpulseRows<S>& problem, const std::vector<bool>& chosen,
                      Numbers<S>& y) {
  const UpperPart<S> part = damping_matrix(problem, chosen);
  return with_factors(part, [&](const auto& factors) {
    if (factors.info() != Eigen::Success) return false;
    const auto correct = [&](const Numbers<S>& velocity, Numbers<S>& changed) {
      Numbers<S> sum = Numbers<S>::Zero(part.rows());
      for (std::size_t body = 0; body < problem.bodies.size(); ++body) {
        auto of_body = sum.template segment<6>(static_cast<Eigen::Index>(6 * body));
        for (const RowOnBody<S>& row : problem.bodies[body].rows) {
          of_body.template head<3>() += row.along * velocity(row.row);
          of_body.template tail<3>() += row.arm * velocity(row.row);
        }
      }
      Numbers<S> z = factors.solve(sum);
      for (std::size_t body = 0; body < problem.bodies.size(); ++body) {
        auto of_body = z.template segment<6>(static_cast<Eigen::Index>(6 * body));
        of_body.template head<3>() *= problem.bodies[body].mass;
        of_body.template tail<3>() =
            Vector3<S>(problem.bodies[body].inertia * of_body.template tail<3>());
      }
      z = factors.solve(Numbers<S>(z));
      for (std::size_t body = 0; body < problem.bodies.size(); ++body) {
        const auto of_body = z.template segment<6>(static_cast<Eigen::Index>(6 * body));
        for (const RowOnBody<S>& row : problem.bodies[body].rows) {
          if (!chosen[index(row.row)]) continue;
          changed(row.row) +=
              row.along.dot(of_body.template head<3>()) + row.arm.dot(of_body.template tail<3>());
        }
      }
    };
    const S left = refine(problem, chosen, y, correct);
    if (!y.allFinite()) return false;
    const auto sizes = velocities_and_sizes<S>(problem, y).sizes;
    return left <= S(0x1p8) * std::numeric_limits<S>::epsilon() * sizes.maxCoeff();
  });
}
// [/eliminate-bodies]

/// Solves M y + c = 0 in the chosen rows, for y in these rows: by elimination of the fewer, rows or
/// velocities of bodies.
/// @return whether the solve succeeded
template <std::floating_point S>
bool eliminate(ImpulseRows<S>& problem, const std::vector<bool>& chosen, Numbers<S>& y) {
  const auto rows = static_cast<std::size_t>(std::count(chosen.begin(), chosen.end(), true));
  if (rows == 0) return true;
  if (rows > 6 * problem.bodies.size()) {
    Numbers<S> solved = y;
    if (eliminate_bodies<S>(problem, chosen, solved)) {
      y = solved;
      return true;
    }
  }
  assemble(problem);
  return eliminate_rows<S>(problem, chosen, y);
}

}  // namespace detail

}  // namespace contact
