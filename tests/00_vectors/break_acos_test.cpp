// The right angle comes from the dot product and the cross product without rounding, scaled so that
// nothing overflows. Its relative error is below 1e-14, and the given code must be off by 1e-2.
#include "break_acos.hpp"
#include "angle_by_acos.hpp"

#include <support/break_it.hpp>

#include <contact/exact.hpp>

namespace {

using namespace contact::testing;
using contact::Exact;
using exercise::Pair;

/// The number as the nearest double.
double nearest(const Exact& x) { return rounded<double>(x); }

Eigen::Vector3d scaled(const Eigen::Vector3d& v) {
  int exponent = 0;
  std::frexp(v.cwiseAbs().maxCoeff(), &exponent);
  return v.unaryExpr([&](double x) { return std::ldexp(x, -exponent); });
}

Eigen::Vector3d exact_cross(const Eigen::Vector3d& u, const Eigen::Vector3d& v) {
  const auto at = [&](int i, int j) {
    return nearest(Exact(u[i]) * Exact(v[j]) - Exact(u[j]) * Exact(v[i]));
  };
  return {at(1, 2), at(2, 0), at(0, 1)};
}

double right_angle(const Pair& pair) {
  const Eigen::Vector3d u = scaled(pair.u), v = scaled(pair.v);
  Exact dot;
  for (int i = 0; i < 3; ++i) dot += Exact(u[i]) * Exact(v[i]);
  return std::atan2(exact_cross(u, v).norm(), nearest(dot));
}

bool parallel(const Pair& pair) { return exact_cross(scaled(pair.u), scaled(pair.v)).isZero(0); }

Judged judged(const Pair& pair) {
  const double given = given::angle_by_acos(pair.u, pair.v);
  const double right = right_angle(pair);
  const double off = std::abs(given - right) / right;
  std::string difference;
  if (std::isnan(given))
    difference = "The given code returns NaN, which is no angle.";
  else if (right == 0)
    difference = "The angle is exactly 0.";
  else
    difference = "The relative error is " + contact::text_of(off, {.digits = 2}) + ".";
  return {!(off <= 0.01), contact::text_of(given), contact::text_of(right), difference,
          off > 0 && off <= 1e-6};
}

Judged judged_nan(const Pair& pair) {
  Judged all = judged(pair);
  all.wrong = all.given == "NaN";
  all.within_rounding = false;
  if (!all.wrong) all.difference += " The question asks for vectors for which it is NaN.";
  return all;
}

BreakIt<Pair> question(std::string_view text, double limit) {
  const std::string range = contact::text_of(std::int64_t(limit));
  return break_it<Pair>(text)
      .rule("every coordinate is a whole number from -" + range + " to " + range,
            [limit](const Pair& p) { return all_within(p, limit) && all_whole(p); })
      .rule("no vector is zero", [](const Pair& p) { return !p.u.isZero(0) && !p.v.isZero(0); });
}

}  // namespace

TEST_CASE("the angle of short vectors is NaN") {
  break_it<Pair>("For which vectors does the given code return NaN?")
      .rule("every coordinate is from -1 to 1", [](const Pair& p) { return all_within(p, 1); })
      .rule("both vectors are at least 0.1 long",
            [](const Pair& p) { return p.u.norm() >= 0.1 && p.v.norm() >= 0.1; })
      .suspect_if(
          "break-acos-at-most-one",
          [](const Pair& p) { return p.u.dot(p.v) / std::sqrt(p.u.dot(p.u) * p.v.dot(p.v)) <= 1; })
      .input("pair", [] { return exercise::angle_is_no_number(); })
      .judge(judged_nan);
}

TEST_CASE("the angle of whole numbers is wrong by more than 1 %") {
  question("Which angle does the given code get wrong by more than 1 %?", 1e6)
      .rule("the vectors are not parallel", [](const Pair& p) { return !parallel(p); })
      .input("pair", [] { return exercise::angle_is_lost(); })
      .judge(judged);
}

TEST_CASE("an angle that is neither small nor flat is wrong") {
  break_it<Pair>("Which large angle does the given code get wrong by more than 1 %?")
      .rule("every coordinate is finite", all_finite<Pair>)
      .rule("no vector is zero", [](const Pair& p) { return !p.u.isZero(0) && !p.v.isZero(0); })
      .rule("the angle is from 0.5 to 2.5 rad",
            [](const Pair& p) {
              const double angle = right_angle(p);
              return angle >= 0.5 && angle <= 2.5;
            })
      .input("pair", [] { return exercise::large_angle(); })
      .judge(judged);
}
