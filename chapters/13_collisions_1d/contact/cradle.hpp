/// @file
/// A row of touching balls, as in Newton's cradle: resolved one pair at a time, or simultaneously
/// with springs.
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <vector>

#include <contact/collision_1d.hpp>
#include <contact/vector.hpp>

namespace contact {

/// Which of several approaching pairs collides next.
enum class PairOrder {
  left_to_right,  ///< repeatedly from the first pair to the last
  right_to_left,  ///< repeatedly from the last pair to the first
  fastest_first   ///< always the pair with the largest closing speed; of equals the leftmost
};

/// The outcome for a row.
template <Ring S>
struct RowOutcome {
  std::vector<S> velocities;  ///< m/s, in the order of the balls
  int collisions = 0;         ///< of pairs
  bool settled = false;       ///< whether no neighbours approach any more
};

// [collide-row]
/// A row of balls that touch their neighbours: approaching pairs collide, one at a time, until none
/// approaches.
///
/// Balls of equal mass with e = 1 exchange velocities, so every order sorts them, with the same
/// result. With other masses or e < 1 the result depends on the order.
/// @param row of line_body(), by coordinate
/// @param e coefficient of restitution of every pair, from 0 to 1
/// @param order see PairOrder
/// @param limit on the number of collisions. For small e there may be infinitely many, and then the
/// row is not settled when the limit is reached
/// @return momentum is conserved up to γ(8) of Σ m|v| per collision
template <Scalar S>
RowOutcome<S> collide_row(std::vector<LineBody<S>> row, const S& e, PairOrder order, int limit) {
  RowOutcome<S> outcome;
  const std::size_t pairs = row.empty() ? 0 : row.size() - 1;
  const auto collides = [&row](std::size_t i) { return detail::collides(row[i], row[i + 1]); };
  std::size_t next = 0;  // where the iteration continues
  while (true) {
    std::size_t chosen = pairs;
    for (std::size_t step = 0; step < pairs; ++step) {
      std::size_t i = (next + step) % pairs;
      if (order == PairOrder::right_to_left) i = pairs - 1 - i;
      if (order == PairOrder::fastest_first) i = step;
      if (!collides(i)) continue;
      const bool faster = chosen < pairs && closing_speed(row[i], row[i + 1]) >
                                                closing_speed(row[chosen], row[chosen + 1]);
      if (chosen == pairs || faster) chosen = i;
      if (order != PairOrder::fastest_first) {
        next = (next + step + 1) % pairs;
        break;
      }
    }
    outcome.settled = chosen == pairs;
    if (outcome.settled || outcome.collisions == limit) break;
    const LineCollision<S> after = collide(row[chosen], row[chosen + 1], e);
    row[chosen].velocity = after.first;
    row[chosen + 1].velocity = after.second;
    ++outcome.collisions;
  }
  for (const LineBody<S>& ball : row) outcome.velocities.push_back(ball.velocity);
  return outcome;
}
// [/collide-row]

// [all-at-once]
/// The same row with all approaching pairs resolved at once (Jacobi), each as if it were alone, and
/// the changes of velocity added. This is repeated until no pair approaches.
///
/// For comparison only: a ball between two others gets two impulses, each computed as if the other
/// did not exist. Momentum is conserved. Energy is lost even with e = 1: the impulses J and J' are
/// opposite, and with both at once the ball has J J'/m less than with each alone. If no ball is hit
/// from both sides, the result is right.
/// @param row, e see collide_row()
/// @param limit on the number of iterations
/// @return velocities, and the number of collisions of pairs
template <Scalar S>
RowOutcome<S> collide_simultaneously(std::vector<LineBody<S>> row, const S& e, int limit) {
  RowOutcome<S> outcome;
  for (int round = 0; !outcome.settled && round <= limit; ++round) {
    const std::vector<LineBody<S>> before = row;
    outcome.settled = true;
    for (std::size_t i = 0; i + 1 < row.size(); ++i) {
      if (!detail::collides(before[i], before[i + 1])) continue;
      outcome.settled = false;
      if (round == limit) break;
      const LineCollision<S> after = collide(before[i], before[i + 1], e);
      row[i].velocity += after.first - before[i].velocity;
      row[i + 1].velocity += after.second - before[i + 1].velocity;
      ++outcome.collisions;
    }
  }
  for (const LineBody<S>& ball : row) outcome.velocities.push_back(ball.velocity);
  return outcome;
}
// [/all-at-once]

/// The contact force as a function of the depth d.
enum class ContactSpring {
  linear,  ///< force = k d
  hertz    ///< force = k d^(3/2), as elastic spheres do (Hertz, 1882)
};

// [row-on-springs]
/// The same row with simultaneous contacts: between neighbours is a spring that pushes when it is
/// compressed and never pulls. The balls have finite masses and move until no spring is compressed.
///
/// Simultaneous contacts need a force law, and time for the force to act. The velocities afterwards
/// do not depend on the stiffness k, only on its *ratio* from contact to contact (here all are
/// equal) and on the shape of the law. Kinetic energy is conserved.
/// @param row of line_body(), by coordinate, touching and uncompressed
/// @param law see ContactSpring
/// @param steps number of leapfrog (velocity Verlet) steps in the time in which sound would cross
/// the row; the error is proportional to 1/steps²
/// @return velocities when no spring is compressed; settled = false if that took too long
template <std::floating_point S>
RowOutcome<S> row_on_springs(const std::vector<LineBody<S>>& row, ContactSpring law, int steps) {
  const std::size_t n = row.size();
  RowOutcome<S> outcome;
  std::vector<S>& v = outcome.velocities;
  S mass(0);
  S fastest(0);
  for (const LineBody<S>& ball : row) {
    assert(std::isfinite(ball.mass));
    v.push_back(ball.velocity);
    mass = std::max(mass, ball.mass);
    fastest = std::max(fastest, std::abs(ball.velocity - row.front().velocity));
  }
  // Units in which the largest mass, the stiffness and the largest relative velocity are 1.
  if (n < 2 || fastest == S(0)) {
    outcome.settled = true;
    return outcome;
  }
  const S dt = S(4) * S(n) / S(steps);
  std::vector<S> x(n, S(0));
  std::vector<S> a(n, S(0));
  const auto apply_forces = [&] {
    bool pressed = false;
    std::fill(a.begin(), a.end(), S(0));
    for (std::size_t i = 0; i + 1 < n; ++i) {
      const S d = x[i] - x[i + 1];
      if (!(d > S(0))) continue;
      pressed = true;
      const S force = law == ContactSpring::linear ? d : d * std::sqrt(d);
      a[i] -= force / (row[i].mass / mass);
      a[i + 1] += force / (row[i + 1].mass / mass);
    }
    return pressed;
  };
  for (S& velocity : v) velocity /= fastest;
  apply_forces();
  for (int step = 0; step < 20 * steps && !outcome.settled; ++step) {
    for (std::size_t i = 0; i < n; ++i) {
      v[i] += a[i] * dt / S(2);
      x[i] += v[i] * dt;
    }
    const bool pressed = apply_forces();
    for (std::size_t i = 0; i < n; ++i) v[i] += a[i] * dt / S(2);
    outcome.settled = !pressed;
    for (std::size_t i = 0; i + 1 < n; ++i) outcome.settled &= !(v[i] > v[i + 1]);
  }
  for (S& velocity : v) velocity *= fastest;
  return outcome;
}
// [/row-on-springs]

}  // namespace contact
