// One update of the friction of a contact: the impulse that would stop the slip is added to the sum
// so far, and the sum is replaced by the nearest vector of the disc of radius μ times the normal
// impulse.
#include <cmath>
#include <contact/figure.hpp>
#include <contact/vector.hpp>

using Point = contact::Vector2<double>;

struct Input {
  Point sum;              // of the friction impulses before, N·s
  Point slip;             // tangential velocity, m/s
  double effective_mass;  // along every tangent, kg
  double mu;
  double normal;  // sum of the normal impulses, N·s
};

struct Output {
  double problem;
  double limit;          // μ times the normal impulse, N·s
  Point wanted, after;   // the sum that would stop the slip, and the one that is allowed, N·s
  Point change;          // which the bodies get, N·s
  Point left;            // slip afterwards, m/s
  double sticks;         // whether the whole slip is removed
  Point clamped_change;  // what clamps the change instead of the sum gives as the sum, N·s
  Point by_axis;         // what clamps each component by itself gives, N·s
  double change_is_wrong, axis_is_wrong;  // whether those are another sum
  // Goals of questions.
  double outside;     // by_axis is outside the disc by more than a third of its radius
  double takes_back;  // the update reduces the friction that was given
};

namespace {

double length(const Point& p) { return std::sqrt(p.dot(p)); }

// [clamp]
/// The point of the disc nearest to p.
Point clamped(const Point& p, double radius) {
  const double distance = length(p);
  return distance > radius ? Point(p * (radius / distance)) : p;
}
// [/clamp]

// For a limit of 0 its sign is that of the comparison, in each math library.
double clamp_component(double x, double limit) {
  return x < -limit ? -limit : x > limit ? limit : x;
}

}  // namespace

Output compute(const Input& in) {
  Output out{};
  if (!(in.effective_mass > 0)) out.problem = contact::figure::not_positive;
  const double largest = in.sum.cwiseAbs().maxCoeff() + in.slip.cwiseAbs().maxCoeff() +
                         in.effective_mass + in.mu + in.normal;
  if (largest > 1e6) out.problem = contact::figure::too_large;
  if (out.problem == 0 && (in.effective_mass < 1e-6 || in.mu < 0 || in.normal < 0))
    out.problem = contact::figure::too_small;
  if (out.problem != 0) return out;
  // [update]
  out.limit = in.mu * in.normal;
  out.wanted = in.sum - in.slip * in.effective_mass;
  out.after = clamped(out.wanted, out.limit);
  out.change = out.after - in.sum;
  // [/update]
  out.left = in.slip + out.change / in.effective_mass;
  out.sticks = length(out.wanted) <= out.limit ? 1 : 0;
  out.clamped_change = in.sum + clamped(in.slip * -in.effective_mass, out.limit);
  out.by_axis = {clamp_component(out.wanted.x(), out.limit),
                 clamp_component(out.wanted.y(), out.limit)};
  const double close = 1e-9 * (1 + out.limit);
  out.change_is_wrong = length(out.clamped_change - out.after) > close ? 1 : 0;
  out.axis_is_wrong = length(out.by_axis - out.after) > close ? 1 : 0;
  out.outside = out.limit > 0 && length(out.by_axis) > 4 * out.limit / 3 ? 1 : 0;
  out.takes_back = length(out.after) < length(in.sum) - close ? 1 : 0;
  return out;
}

FIGURE(Input, FIELDS(sum, slip, effective_mass, mu, normal), Output,
       FIELDS(problem, limit, wanted, after, change, left, sticks, clamped_change, by_axis,
              change_is_wrong, axis_is_wrong, outside, takes_back))
