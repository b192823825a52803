// The angle between two nearly parallel vectors, from its cosine and from both products: the error
// of each, in float and in double.
#include <algorithm>
#include <array>
#include <cmath>
#include <contact/angle.hpp>
#include <contact/arc.hpp>
#include <contact/exact.hpp>
#include <contact/figure.hpp>

using Flat = contact::Vector2<double>;

struct Input {
  Flat u;         // m
  double k;       // v is u plus a perpendicular vector of length 10^-k |u|
  double turned;  // 1: v is reversed, and the angle is near π; 0: it is near 0
};

constexpr std::size_t steps = 18;

struct Output {
  double problem;
  double k;                                  // a whole number
  Flat v;                                    // m
  double shared;                             // 1 if v is stored as u, or as −u
  std::array<double, 2> angle;               // of the stored vectors; first float, then double
  std::array<double, 2> by_cosine, by_both;  // what comes out
  std::array<double, 2> cosine_error, both_error;  // relative to the angle; −1 if that is 0
  std::array<double, 2 * steps> cosine_curve, both_curve;  // the errors for k = 0 … 17
};

namespace {

// WRONG: near angle 0 the cosine is flat, and rounding it loses the angle. The arccosine itself is
// accurate to the last digits.
template <class S>
S angle_by_cosine(const contact::Vector3<S>& u, const contact::Vector3<S>& v) {
  const S cosine = contact::dot_recursive(u, v) / (u.norm() * v.norm());
  const double c = std::clamp(double(cosine), -1.0, 1.0);
  return S(contact::portable_angle(std::sqrt((1 - c) * (1 + c)), c));
}

template <class S>
S angle_by_both(const contact::Vector3<S>& u, const contact::Vector3<S>& v) {
  const auto both = contact::both_products(u, v);
  return S(contact::portable_angle(double(both.cross_norm), double(both.dot)));
}

/// The angle of the stored vectors; its tangent is rounded once.
double true_angle(const Flat& u, const Flat& v) {
  using contact::Exact;
  const Exact across = Exact(u.x()) * Exact(v.y()) - Exact(u.y()) * Exact(v.x());
  const Exact along = Exact(u.x()) * Exact(v.x()) + Exact(u.y()) * Exact(v.y());
  const double tangent = quotient<double>(across, along);
  return contact::portable_angle(std::abs(tangent), along.sign());
}

Flat nearly(const Input& in, double k) {
  double power = 1;
  for (; k > 0; --k) power *= 10;
  const Flat across(-in.u.y() / power, in.u.x() / power);
  return in.turned == 1 ? Flat(-in.u - across) : Flat(in.u + across);
}

template <class S>
void ask(const Input& in, Output& out) {
  constexpr std::size_t type = sizeof(S) == sizeof(double) ? 1 : 0;
  const auto stored = [](const Flat& p) { return contact::Vector3<S>(S(p.x()), S(p.y()), S(0)); };
  const auto u = stored(in.u);
  for (std::size_t k = 0; k < steps; ++k) {
    const auto v = stored(nearly(in, double(k)));
    const double angle = true_angle({u.x(), u.y()}, {v.x(), v.y()});
    const double by_cosine = angle_by_cosine<S>(u, v);
    const double by_both = angle_by_both<S>(u, v);
    const auto error = [angle](double x) { return angle > 0 ? std::abs(x - angle) / angle : -1; };
    out.cosine_curve[type * steps + k] = error(by_cosine);
    out.both_curve[type * steps + k] = error(by_both);
    if (double(k) != out.k) continue;
    out.angle[type] = angle;
    out.by_cosine[type] = by_cosine;
    out.by_both[type] = by_both;
    out.cosine_error[type] = error(by_cosine);
    out.both_error[type] = error(by_both);
  }
}

}  // namespace

Output compute(const Input& in) {
  Output out{};
  const double size = in.u.cwiseAbs().maxCoeff();
  if (size > 1e12) out.problem = contact::figure::too_large;
  if (size < 1e-12) out.problem = contact::figure::too_small;
  if (size == 0) out.problem = contact::figure::zero_direction;
  if (out.problem != 0) return out;
  out.k = in.k > 0 ? std::min(std::round(in.k), double(steps - 1)) : 0;
  out.v = nearly(in, out.k);
  out.shared = out.v == in.u || out.v == -in.u ? 1 : 0;
  ask<float>(in, out);
  ask<double>(in, out);
  return out;
}

FIGURE(Input, FIELDS(u, k, turned), Output,
       FIELDS(problem, k, v, shared, angle, by_cosine, by_both, cosine_error, both_error,
              cosine_curve, both_curve))
