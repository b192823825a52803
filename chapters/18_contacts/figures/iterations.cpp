// Two contacts of one body without friction, in the plane of their impulses: the lines on which
// each contact no longer closes, and how Gauss-Seidel and Jacobi iterations approach the solution,
// which a block solve of both finds at once.
#include <algorithm>
#include <array>
#include <cmath>
#include <contact/contact_lcp.hpp>
#include <contact/figure.hpp>
#include <contact/two_contacts.hpp>
#include <cstddef>
#include <vector>

using Point = contact::Vector2<double>;
using Vector = contact::Vector3<double>;

constexpr std::size_t most = 40;            // iterations
constexpr double mass = 1, inertia = 0.25;  // kg, kg·m²
constexpr double low = -0.4, high = 2.6;    // of the plane of impulses, N·s
constexpr double settled = 1e-9;            // m/s

struct Input {
  double first, second;     // lever arms of the contacts, m to the right of the centre of mass
  double velocity;          // of the centre of mass before, m/s upwards
  double angular_velocity;  // before, rad/s, counter-clockwise
  Point start;              // impulses before the first iteration (warm start), N·s
  double relaxation;        // of Gauss-Seidel, from 0.1 to 1.9
  double share;             // of the change that a Jacobi iteration applies
  double shown;             // iterations that are drawn
};

struct Output {
  double problem;
  double mass, inertia;
  Point lever_arms, b;  // m; velocities of the contacts before, m/s
  Point row1, row2;     // of the matrix A of inverse effective masses, 1/kg
  // Whether the lines (A x + b)_i = 0 meet the drawn plane, and where they enter and leave it.
  Point crosses;
  std::array<Point, 2> line1, line2;
  Point impulses;   // of the block solve, N·s
  double which;     // contacts that push: 0 none, 1 the first, 2 the second, 3 both
  double singular;  // A has no inverse
  // Impulses of Gauss-Seidel after each contact's update, and of Jacobi after each iteration.
  std::array<Point, 2 * most + 1> gauss_seidel;
  std::array<Point, most + 1> jacobi;
  // Residuals of complementarity after each iteration, m/s.
  std::array<double, most + 1> gauss_seidel_residual, jacobi_residual;
  double needed, jacobi_needed;  // iterations to a residual of 1e-9 m/s; −1: more than 40
  Point now, velocities;         // impulses and velocities of Gauss-Seidel as drawn
  double coupling;               // a₁₂ / √(a₁₁ a₂₂)
  double rate;                   // its square
  // Goals of questions.
  double slow;     // Gauss-Seidel needs more than 40 iterations, and A has an inverse
  double at_once;  // one iteration of Gauss-Seidel is enough, from 0, and both contacts push
  double repeats;  // Jacobi returns to the impulses of the iteration before the last
};

namespace {

struct Problem {
  std::array<std::array<double, 2>, 2> a{};
  std::array<double, 2> b{};
};

Problem make(const Input& in, Output& out) {
  const contact::Matrix3<double> axes = contact::Matrix3<double>::Identity();
  const Vector zero = Vector::Zero();
  const std::vector<contact::RigidBody<double>> bodies{
      contact::rigid_body_from_axes<double>(mass, Vector(inertia, inertia, inertia), axes, zero,
                                            Vector(0, in.velocity, 0),
                                            Vector(0, 0, in.angular_velocity)),
      contact::immovable<double>(zero, zero, zero)};
  const std::vector<contact::BodyContact<double>> contacts{
      {0, 1, Vector(in.first, 0, 0), Vector(0, 1, 0), 0, 0},
      {0, 1, Vector(in.second, 0, 0), Vector(0, 1, 0), 0, 0}};
  const auto matrix = contact::inverse_effective_mass_matrix(bodies, contacts);
  Problem problem;
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t k = 0; k < 2; ++k) problem.a[i][k] = matrix[i][k];
    problem.b[i] = contact::contact_velocity(bodies, contacts[i]);
  }
  const auto solved = contact::solve_two_contacts<double>(
      {matrix[0][0], matrix[0][1], matrix[1][1]}, problem.b[0], problem.b[1]);
  if (solved) {
    out.impulses = {solved->first, solved->second};
    out.which = double(static_cast<int>(solved->pushes));
  }
  return problem;
}

/// The velocity of contact i with impulses x.
double velocity(const Problem& problem, std::size_t i, const Point& x) {
  return problem.a[i][0] * x[0] + problem.a[i][1] * x[1] + problem.b[i];
}

// [update]
/// The impulse of contact i that makes its velocity 0, if no impulse pulls, as long as the other
/// impulse stays as it is.
double updated(const Problem& problem, std::size_t i, const Point& x, double relaxation) {
  const double old = x[Eigen::Index(i)];
  return std::max(0.0, old - relaxation * velocity(problem, i, x) / problem.a[i][i]);
}
// [/update]

/// By how much a contact's velocity would change if its own impulse were corrected.
double residual(const Problem& problem, const Point& x) {
  double largest = 0;
  for (std::size_t i = 0; i < 2; ++i) {
    const double pushes = x[Eigen::Index(i)] * problem.a[i][i];
    largest = std::max(largest, std::abs(std::min(pushes, velocity(problem, i, x))));
  }
  return largest;
}

void iterate(const Problem& problem, const Input& in, Output& out) {
  Point x{std::max(0.0, in.start[0]), std::max(0.0, in.start[1])};
  Point y = x;
  out.gauss_seidel[0] = out.jacobi[0] = x;
  out.needed = out.jacobi_needed = -1;
  for (std::size_t n = 0;; ++n) {
    out.gauss_seidel_residual[n] = residual(problem, x);
    out.jacobi_residual[n] = residual(problem, y);
    if (out.needed < 0 && out.gauss_seidel_residual[n] <= settled) out.needed = double(n);
    if (out.jacobi_needed < 0 && out.jacobi_residual[n] <= settled) out.jacobi_needed = double(n);
    if (n == most) return;
    for (std::size_t i = 0; i < 2; ++i) {
      x[Eigen::Index(i)] = updated(problem, i, x, in.relaxation);
      out.gauss_seidel[2 * n + i + 1] = x;
    }
    const Point alone{updated(problem, 0, y, 1), updated(problem, 1, y, 1)};
    y += (alone - y) * in.share;
    out.jacobi[n + 1] = y;
  }
}

/// The part of the line a · x + c = 0 in the drawn square, from its smallest to its largest
/// position along its direction; returns whether there is one.
bool clip(const std::array<double, 2>& a, double c, std::array<Point, 2>& ends) {
  const Point normal{a[0], a[1]}, direction{-a[1], a[0]};
  const Point foot = normal * (-c / normal.dot(normal));
  double from = -1e9, to = 1e9;
  for (Eigen::Index k = 0; k < 2; ++k) {
    if (direction[k] == 0) {
      if (foot[k] < low || foot[k] > high) return false;
      continue;
    }
    const double one = (low - foot[k]) / direction[k], two = (high - foot[k]) / direction[k];
    from = std::max(from, std::min(one, two));
    to = std::min(to, std::max(one, two));
  }
  ends = {foot + direction * from, foot + direction * to};
  return from < to;
}

}  // namespace

Output compute(const Input& in) {
  Output out{};
  const double largest = std::max({std::abs(in.first), std::abs(in.second), std::abs(in.velocity),
                                   std::abs(in.angular_velocity), in.start.cwiseAbs().maxCoeff()});
  if (largest > 100 || in.relaxation > 1.9 || in.share > 1)
    out.problem = contact::figure::too_large;
  if (in.relaxation < 0.1 || in.share < 0.1) out.problem = contact::figure::too_small;
  if (out.problem != 0) return out;
  const Problem problem = make(in, out);
  out.mass = mass;
  out.inertia = inertia;
  out.lever_arms = {in.first, in.second};
  out.b = {problem.b[0], problem.b[1]};
  out.row1 = {problem.a[0][0], problem.a[0][1]};
  out.row2 = {problem.a[1][0], problem.a[1][1]};
  out.coupling = problem.a[0][1] / std::sqrt(problem.a[0][0] * problem.a[1][1]);
  out.rate = out.coupling * out.coupling;
  // With one lever arm for both, both rows are the same.
  out.singular = in.first == in.second ? 1 : 0;
  out.crosses = {clip(problem.a[0], problem.b[0], out.line1) ? 1.0 : 0.0,
                 clip(problem.a[1], problem.b[1], out.line2) ? 1.0 : 0.0};
  iterate(problem, in, out);
  const auto shown = static_cast<std::size_t>(std::clamp(std::round(in.shown), 0.0, double(most)));
  out.now = out.gauss_seidel[2 * shown];
  out.velocities = {velocity(problem, 0, out.now), velocity(problem, 1, out.now)};
  out.slow = out.needed < 0 && out.singular == 0 ? 1 : 0;
  out.at_once = out.needed == 1 && out.which == 3 && in.start == Point::Zero() ? 1 : 0;
  const double apart = (out.jacobi[most] - out.jacobi[most - 1]).norm();
  const double back = (out.jacobi[most] - out.jacobi[most - 2]).norm();
  out.repeats = apart > 0.1 && back < 1e-9 ? 1 : 0;
  return out;
}

FIGURE(Input, FIELDS(first, second, velocity, angular_velocity, start, relaxation, share, shown),
       Output,
       FIELDS(problem, mass, inertia, lever_arms, b, row1, row2, crosses, line1, line2, impulses,
              which, singular, gauss_seidel, jacobi, gauss_seidel_residual, jacobi_residual, needed,
              jacobi_needed, now, velocities, coupling, rate, slow, at_once, repeats))
