/// @file
/// Many contacts with friction: Coulomb's law by a semismooth Newton method, and an interior-point
/// method that provides its start.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <Eigen/SparseLU>

#include <contact/contact_lcp.hpp>
#include <contact/contact_rows.hpp>
#include <contact/vector.hpp>

namespace contact {

namespace detail {

/// The entries of one contact: normal and two tangents, 0 for tangents without friction.
template <std::floating_point S>
Vector3<S> numbers_of(const ImpulseRows<S>& problem, std::size_t contact, const Numbers<S>& all) {
  const Eigen::Index n = problem.first[contact];
  if (!(problem.cone[contact] > S(0))) return {all(n), S(0), S(0)};
  return {all(n), all(n + 1), all(n + 2)};
}

template <std::floating_point S>
void set_numbers(const ImpulseRows<S>& problem, std::size_t contact, const Vector3<S>& some,
                 Numbers<S>& all) {
  const Eigen::Index n = problem.first[contact];
  for (Eigen::Index k = 0; k < (problem.cone[contact] > S(0) ? 3 : 1); ++k) all(n + k) = some(k);
}

/// The block-diagonal matrix of one block for each contact.
template <std::floating_point S>
Eigen::SparseMatrix<S> blocks(const ImpulseRows<S>& problem,
                              const std::vector<Matrix3<S>>& of_contact) {
  std::vector<Eigen::Triplet<S>> entries;
  for (std::size_t i = 0; i < of_contact.size(); ++i) {
    const int n = problem.first[i];
    const int size = problem.cone[i] > S(0) ? 3 : 1;
    for (int row = 0; row < size; ++row)
      for (int column = 0; column < size; ++column)
        entries.emplace_back(n + row, n + column, of_contact[i](row, column));
  }
  Eigen::SparseMatrix<S> made(problem.matrix.rows(), problem.matrix.cols());
  made.setFromTriplets(entries.begin(), entries.end());
  return made;
}

/// M with a small number added to its diagonal, so that it can be factorised where it is singular.
template <std::floating_point S>
Eigen::SparseMatrix<S> firm_matrix(const ImpulseRows<S>& problem) {
  Eigen::SparseMatrix<S> firm = problem.matrix;
  for (Eigen::Index r = 0; r < firm.rows(); ++r)
    firm.coeffRef(r, r) += S(0x1p16) * std::numeric_limits<S>::epsilon();
  return firm;
}

/// The scaled velocities M y + c, and the sums of the magnitudes of their terms.
template <std::floating_point S>
struct VelocitiesAndSizes {
  Numbers<S> velocities, sizes;
};

/// The terms are those of M y, if M is assembled; else those of the velocities of the bodies and of
/// their velocities along the rows, whose sums are larger where terms of an entry of M cancel.
template <std::floating_point S>
VelocitiesAndSizes<S> velocities_and_sizes(const ImpulseRows<S>& problem, const Numbers<S>& y) {
  VelocitiesAndSizes<S> sums{problem.constant, problem.constant.cwiseAbs()};
  if (problem.matrix.rows() == y.size()) {
    for (Eigen::Index k = 0; k < y.size(); ++k) {  // a column is a row: symmetric
      S velocity(0);
      S size(0);
      for (typename Eigen::SparseMatrix<S>::InnerIterator it(problem.matrix, k); it; ++it) {
        const S term = it.value() * y(it.row());
        velocity += term;
        size += std::abs(term);
      }
      sums.velocities(k) = velocity + problem.constant(k);
      sums.sizes(k) += size;
    }
    return sums;
  }
  for (const RowsOnBody<S>& body : problem.bodies) {
    BodyChange<S> change;
    BodyChange<S> size;
    for (const RowOnBody<S>& row : body.rows) {
      const Vector3<S> along = row.along * y(row.row);
      const Vector3<S> turn = row.turn * y(row.row);
      change.velocity += along;
      change.angular_velocity += turn;
      size.velocity += along.cwiseAbs();
      size.angular_velocity += turn.cwiseAbs();
    }
    change.velocity *= body.inverse_mass;
    size.velocity *= body.inverse_mass;
    for (const RowOnBody<S>& row : body.rows) {
      sums.velocities(row.row) +=
          row.along.dot(change.velocity) + row.arm.dot(change.angular_velocity);
      sums.sizes(row.row) +=
          row.along.cwiseAbs().dot(size.velocity) + row.arm.cwiseAbs().dot(size.angular_velocity);
    }
  }
  return sums;
}

/// Relative tolerance of velocities and impulses, as a fraction of the sum of absolute terms.
template <std::floating_point S>
inline constexpr S coulomb_rounding = S(0x1p14) * std::numeric_limits<S>::epsilon();

// [coulomb-error]
/// The residual of Coulomb's law in units of rounding, maximal over contacts. The conditions: no
/// impulse pulls and no contact closes; a contact that pushes does not open (complementarity);
/// friction is inside its cone; and the friction of a sliding contact is on the boundary of the
/// cone, opposite to the slip.
template <std::floating_point S>
S complementarity_residual(const ImpulseRows<S>& problem, const Numbers<S>& y) {
  const auto [velocity, sizes] = velocities_and_sizes<S>(problem, y);
  const S pushes = coulomb_rounding<S> *
                   std::max(y.cwiseAbs().maxCoeff(), problem.constant.cwiseAbs().maxCoeff());
  S most(0);
  for (std::size_t i = 0; i < problem.first.size(); ++i) {
    const Vector3<S> x = numbers_of<S>(problem, i, y);
    const Vector3<S> w = numbers_of<S>(problem, i, velocity);
    const Vector3<S> size = numbers_of<S>(problem, i, sizes) * coulomb_rounding<S>;
    if (!(pushes > S(0)) || !(size(0) > S(0))) continue;  // no motion and no impulse
    const S open = std::max(std::abs(x(0)) / pushes, -w(0) / size(0));
    most = std::max({most, -x(0) / pushes, std::min(std::abs(w(0)) / size(0), open)});
    if (!(problem.cone[i] > S(0))) continue;
    const S allowed = problem.cone[i] * std::max(S(0), x(0));
    const S slip = std::sqrt(w(1) * w(1) + w(2) * w(2));
    const S rounding = std::max({size(1), size(2), std::numeric_limits<S>::min()});
    most = std::max(most, (std::sqrt(x(1) * x(1) + x(2) * x(2)) - allowed) / pushes);
    if (!(slip > rounding)) continue;
    const S one = x(1) + allowed * w(1) / slip;
    const S two = x(2) + allowed * w(2) / slip;
    const S turned = allowed * (S(2) * rounding / slip);  // rounding rotates the slip
    most = std::max(
        most, std::min(slip / rounding, std::sqrt(one * one + two * two) / (pushes + turned)));
  }
  return most;
}

template <std::floating_point S>
bool obeys_coulomb(const ImpulseRows<S>& problem, const Numbers<S>& y) {
  return complementarity_residual<S>(problem, y) <= S(1);
}
// [/coulomb-error]

// [coulomb-law]
/// The residual of Coulomb's law at one contact, which is 0 where the law holds, and its
/// derivatives with respect to impulse and velocity.
template <std::floating_point S>
struct CoulombResidual {
  Vector3<S> value = Vector3<S>::Zero();
  Matrix3<S> d_impulse = Matrix3<S>::Zero();
  Matrix3<S> d_velocity = Matrix3<S>::Zero();
};

/// The Alart–Curnier function (1991) of Coulomb's law at one contact.
///
/// If normal impulse minus normal velocity is positive, the contact is active and its normal
/// velocity has to be 0; otherwise its normal impulse has to be 0. If friction minus slip is inside
/// the disc that the normal allows, the contact sticks and its slip has to be 0; otherwise its
/// friction has to be the point on the boundary of the disc in that direction.
/// @param cone the largest friction for a normal impulse of 1
/// @param x, w impulse and velocity: normal and two tangents
template <std::floating_point S>
CoulombResidual<S> coulomb_residual(const S& cone, const Vector3<S>& x, const Vector3<S>& w) {
  CoulombResidual<S> law;
  const bool pushes = x(0) - w(0) > S(0);
  law.value(0) = pushes ? w(0) : x(0);
  (pushes ? law.d_velocity : law.d_impulse)(0, 0) = S(1);
  const S allowed = pushes ? cone * (x(0) - w(0)) : S(0);
  const Vector3<S> trial(S(0), x(1) - w(1), x(2) - w(2));
  const S length = std::sqrt(trial(1) * trial(1) + trial(2) * trial(2));
  if (!(length > allowed)) {
    for (Eigen::Index k = 1; k < 3; ++k) {
      law.value(k) = w(k);
      law.d_velocity(k, k) = S(1);
    }
    return law;
  }
  const Vector3<S> rim = trial / length;
  for (Eigen::Index k = 1; k < 3; ++k) {
    law.value(k) = x(k) - allowed * rim(k);
    for (Eigen::Index m = 1; m < 3; ++m) {
      law.d_velocity(k, m) = ((k == m ? S(1) : S(0)) - rim(k) * rim(m)) * (allowed / length);
      law.d_impulse(k, m) = (k == m ? S(1) : S(0)) - law.d_velocity(k, m);
    }
    if (!pushes) continue;
    law.d_impulse(k, 0) = -cone * rim(k);
    law.d_velocity(k, 0) = cone * rim(k);
  }
  return law;
}
// [/coulomb-law]

template <std::floating_point S>
std::vector<CoulombResidual<S>> coulomb_residuals(const ImpulseRows<S>& problem,
                                                  const Numbers<S>& y) {
  const Numbers<S> velocity = problem.matrix * y + problem.constant;
  std::vector<CoulombResidual<S>> laws;
  for (std::size_t i = 0; i < problem.first.size(); ++i)
    laws.push_back(coulomb_residual<S>(problem.cone[i], numbers_of<S>(problem, i, y),
                                       numbers_of<S>(problem, i, velocity)));
  return laws;
}

template <std::floating_point S>
S squared_residual(const std::vector<CoulombResidual<S>>& laws) {
  S sum(0);
  for (const CoulombResidual<S>& law : laws) sum += law.value.dot(law.value);
  return sum;
}

/// The largest number of halvings in the line search of solve_friction_newton().
inline constexpr int max_halvings = 7;

// [newton]
/// Solves for impulses y that satisfy Coulomb's law at all contacts, by a semismooth Newton method
/// (Alart and Curnier 1991; Acary, Brémond and Huber 2018 compare it with others).
///
/// Normal impulse, friction and its direction are solved together, so mass ratios do not slow it
/// down. A step is halved until the residual decreases. If no fraction decreases it, the best
/// fraction is taken, because the residual may have to increase across a kink.
/// @param max_steps largest number of steps
/// @return the complementarity_residual() of y, which is the best iterate
template <std::floating_point S>
S solve_friction_newton(const ImpulseRows<S>& problem, int max_steps, Numbers<S>& y) {
  const Eigen::SparseMatrix<S> firm = firm_matrix<S>(problem);
  Numbers<S> here = y;
  auto laws = coulomb_residuals<S>(problem, here);
  S least = complementarity_residual<S>(problem, here);
  int stays = 0;
  for (int step = 0; step < max_steps && least > S(0x1p-10); ++step) {
    std::vector<Matrix3<S>> d_impulse;
    std::vector<Matrix3<S>> d_velocity;
    Numbers<S> value(y.size());
    for (std::size_t i = 0; i < laws.size(); ++i) {
      d_impulse.push_back(laws[i].d_impulse);
      d_velocity.push_back(laws[i].d_velocity);
      set_numbers<S>(problem, i, laws[i].value, value);
    }
    const Eigen::SparseMatrix<S> of_velocity = blocks<S>(problem, d_velocity);
    const Eigen::SparseMatrix<S> of_impulse = blocks<S>(problem, d_impulse);
    Eigen::SparseMatrix<S> slope = of_velocity * firm;
    slope += of_impulse;
    slope.makeCompressed();
    const Eigen::SparseLU<Eigen::SparseMatrix<S>> eliminated(slope);
    if (eliminated.info() != Eigen::Success) break;
    Numbers<S> change = Numbers<S>::Zero(y.size());
    for (int round = 0; round < 3; ++round) {  // iterative refinement, for the changed diagonal
      const Numbers<S> moved = problem.matrix * change;
      const Numbers<S> left = value + of_velocity * moved + of_impulse * change;
      change -= eliminated.solve(left);
    }
    if (!change.allFinite()) break;
    const S before = squared_residual(laws);
    const Numbers<S> from = here;
    S best = std::numeric_limits<S>::infinity();
    S part(1);
    for (int half = 0; half <= max_halvings; ++half, part /= S(2)) {
      const Numbers<S> there = from + change * part;
      auto then = coulomb_residuals<S>(problem, there);
      const S after = squared_residual(then);
      if (after < best) {
        best = after;
        here = there;
        laws = std::move(then);
      }
      if (after < before) break;
    }
    const S error = complementarity_residual<S>(problem, here);
    if (!(error < least / S(2)) && least <= S(1) && ++stays == 2) break;
    if (!(error < least)) continue;
    least = error;
    y = here;
  }
  return least;
}
// [/newton]

// [second-order-cone]
/// a ∘ b in the Jordan algebra of the second-order cone: (a·b, a₀ b₁ + b₀ a₁).
template <std::floating_point S>
Vector3<S> cone_product(const Vector3<S>& a, const Vector3<S>& b) {
  return {a.dot(b), a(0) * b(1) + b(0) * a(1), a(0) * b(2) + b(0) * a(2)};
}

/// The x with a ∘ x = b, for a inside the cone.
template <std::floating_point S>
Vector3<S> cone_quotient(const Vector3<S>& a, const Vector3<S>& b) {
  const S square = a(0) * a(0) - a(1) * a(1) - a(2) * a(2);
  const S first = (a(0) * b(0) - a(1) * b(1) - a(2) * b(2)) / square;
  return {first, (b(1) - a(1) * first) / a(0), (b(2) - a(2) * first) / a(0)};
}

/// The largest t ≤ 1 for which x + t d is in the cone, for x inside the cone.
template <std::floating_point S>
S max_step_in_cone(const Vector3<S>& x, const Vector3<S>& d) {
  const auto product = [](const Vector3<S>& a, const Vector3<S>& b) {
    return a(0) * b(0) - a(1) * b(1) - a(2) * b(2);
  };
  // x + t d is on the boundary where square t² + 2 mixed t + here = 0.
  const S square = product(d, d);
  const S mixed = product(x, d);
  const S here = product(x, x);
  S step_length = d(0) < S(0) ? std::min(S(1), -x(0) / d(0)) : S(1);
  const S root = mixed * mixed - square * here;
  if (!(root >= S(0))) return step_length;
  const S sum = -(mixed + (mixed > S(0) ? std::sqrt(root) : -std::sqrt(root)));
  for (const S& t : {here / sum, sum / square})
    if (t > S(0)) step_length = std::min(step_length, t);
  return step_length;
}

/// The Nesterov–Todd scaling (1998): the symmetric W with W z = W⁻¹ x, for x and z inside the cone.
template <std::floating_point S>
struct ConeScaling {
  Matrix3<S> direct;
  Matrix3<S> inverse;
};

template <std::floating_point S>
ConeScaling<S> cone_scaling(const Vector3<S>& x, const Vector3<S>& z) {
  const auto size = [](const Vector3<S>& a) {
    const S across = std::sqrt(a(1) * a(1) + a(2) * a(2));
    return std::sqrt((a(0) - across) * (a(0) + across));
  };
  const Vector3<S> one = x / size(x);
  const Vector3<S> two = z / size(z);
  const S middle = std::sqrt((S(1) + one.dot(two)) * S(2));
  Vector3<S> v((one(0) + two(0)) / middle + S(1), (one(1) - two(1)) / middle,
               (one(2) - two(2)) / middle);
  v /= std::sqrt(S(2) * v(0));
  const S factor = std::sqrt(size(x) / size(z));
  const Vector3<S> mirrored(v(0), -v(1), -v(2));
  const Matrix3<S> mirror = Vector3<S>(S(1), S(-1), S(-1)).asDiagonal();
  return {(v * v.transpose() * S(2) - mirror) * factor,
          (mirrored * mirrored.transpose() * S(2) - mirror) / factor};
}
// [/second-order-cone]

/// The number of steps of solve_friction_cones().
inline constexpr int max_cone_steps = 40;

// [interior-point]
/// Solves for impulses y with friction inside its cones, by an interior-point method.
///
/// Impulses in their cones that minimise ½ y·M y + c·y add no energy, and no contact closes; but a
/// sliding contact opens, by μ times its slip (Anitescu and Tasora 2010). With this opening
/// subtracted, the minimum satisfies Coulomb's law (De Saxcé and Feng 1998). So the required
/// opening is updated with the slip in every step (Acary, Cadoux, Lemaréchal and Malick 2011),
/// which need not converge. The steps are Mehrotra's predictor–corrector steps with Nesterov–Todd
/// scaling.
///
/// Impulses that are not unique, as for a table on four legs, come out evenly distributed.
/// @param follow whether the opening is updated with the slip
template <std::floating_point S>
void solve_friction_cones(const ImpulseRows<S>& problem, bool follow, Numbers<S>& y) {
  const std::size_t contacts = problem.first.size();
  const Eigen::Index count = y.size();
  // In x, which is y with normal impulses multiplied by μ, each cone has slope 1.
  Numbers<S> scale = Numbers<S>::Ones(count);
  for (std::size_t i = 0; i < contacts; ++i)
    if (problem.cone[i] > S(0)) scale(problem.first[i]) = S(1) / problem.cone[i];
  const Eigen::SparseMatrix<S> matrix =
      scale.asDiagonal() * firm_matrix<S>(problem) * scale.asDiagonal();
  const Numbers<S> constant = scale.cwiseProduct(problem.constant);
  const S largest = constant.cwiseAbs().maxCoeff();
  if (!(largest > S(0))) {
    y.setZero();
    return;
  }
  Numbers<S> middle = Numbers<S>::Zero(count);
  for (std::size_t i = 0; i < contacts; ++i) middle(problem.first[i]) = S(1);
  Numbers<S> x = middle * std::max(largest, -constant.dot(middle) / middle.dot(matrix * middle));
  Numbers<S> z = middle * largest;
  S least = std::numeric_limits<S>::infinity();
  for (int step = 0; step < max_cone_steps; ++step) {
    const Numbers<S> impulses = scale.cwiseProduct(x);
    const S error = follow ? complementarity_residual<S>(problem, impulses) : x.dot(z);
    if (error < least) {
      least = error;
      y = impulses;
    }
    Numbers<S> value = matrix * x + constant - z;
    std::vector<ConeScaling<S>> scaling;
    std::vector<Matrix3<S>> squares;
    std::vector<Vector3<S>> both;  // W z = W⁻¹ x
    for (std::size_t i = 0; i < contacts; ++i) {
      const Vector3<S> zi = numbers_of<S>(problem, i, z);
      const Vector3<S> w = numbers_of<S>(problem, i, z) + numbers_of<S>(problem, i, value);
      if (follow) value(problem.first[i]) += std::sqrt(w(1) * w(1) + w(2) * w(2));
      scaling.push_back(cone_scaling<S>(numbers_of<S>(problem, i, x), zi));
      squares.push_back(scaling[i].inverse * scaling[i].inverse);
      both.push_back(scaling[i].direct * zi);
    }
    const Eigen::SparseMatrix<S> whole = matrix + blocks<S>(problem, squares);
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<S>> eliminated(whole);
    if (eliminated.info() != Eigen::Success) return;
    Numbers<S> dx(count);
    Numbers<S> dz(count);
    const auto solve = [&](const auto& wanted) {
      Numbers<S> right(count);
      for (std::size_t i = 0; i < contacts; ++i)
        set_numbers<S>(problem, i, scaling[i].inverse * cone_quotient<S>(both[i], wanted(i)),
                       right);
      right -= value;
      dx = eliminated.solve(right);
      dx += eliminated.solve(Numbers<S>(right - whole * dx));
      dz = matrix * dx + value;
    };
    const auto longest = [&] {
      S step_length(1);
      for (std::size_t i = 0; i < contacts; ++i) {
        step_length = std::min(step_length, max_step_in_cone<S>(numbers_of<S>(problem, i, x),
                                                                numbers_of<S>(problem, i, dx)));
        step_length = std::min(step_length, max_step_in_cone<S>(numbers_of<S>(problem, i, z),
                                                                numbers_of<S>(problem, i, dz)));
      }
      return step_length;
    };
    solve([&](std::size_t i) { return Vector3<S>(-cone_product<S>(both[i], both[i])); });
    const S ahead = longest();
    const S now = x.dot(z);
    const S left = std::max(S(0), (x + dx * ahead).dot(z + dz * ahead) / now);
    const S centre = std::clamp(left * left * left, S(1e-8), S(1)) * now / S(contacts);
    std::vector<Vector3<S>> wanted;
    for (std::size_t i = 0; i < contacts; ++i) {
      const Vector3<S> first = scaling[i].inverse * numbers_of<S>(problem, i, dx);
      const Vector3<S> second = scaling[i].direct * numbers_of<S>(problem, i, dz);
      wanted.push_back(-cone_product<S>(both[i], both[i]) - cone_product<S>(first, second));
      wanted.back()(0) += centre;
    }
    solve([&](std::size_t i) { return wanted[i]; });
    const S step_length = S(0.99) * longest();
    if (!(step_length > S(0x1p-20)) || !dx.allFinite() || !dz.allFinite()) return;
    x += dx * step_length;
    z += dz * step_length;
  }
}
// [/interior-point]

// [coulomb]
/// Solves for impulses y that satisfy Coulomb's law: by Newton's method from the initial y, or, if
/// that does not come close, from the result of solve_friction_cones().
/// @return whether the law is satisfied up to rounding
template <std::floating_point S>
bool solve_friction(const ImpulseRows<S>& problem, Numbers<S>& y) {
  const S close(0x1p-5);
  S least = solve_friction_newton<S>(problem, 10, y);
  if (least <= close) return true;
  Numbers<S> other = y;
  solve_friction_cones<S>(problem, true, other);
  for (int again = 0; again < 2 && least > close; ++again) {
    const S error = solve_friction_newton<S>(problem, 24, other);
    if (!(error < least)) continue;
    least = error;
    y = other;
  }
  return least <= S(1);
}
// [/coulomb]

}  // namespace detail

}  // namespace contact
