/// @file
/// What the ladders of this chapter have in common: answers, how they are judged and told, and
/// slices.
#pragma once

#include <algorithm>
#include <cmath>
#include <contact/sliced_steps.hpp>
#include <string>

#include "support/ladder.hpp"

namespace measured_impact {

inline ladder::Method rounded(const char* id, const char* title, const char* scalar) {
  return {.id = id, .title = title, .scalar = scalar, .exact = false};
}
/// What is proven to be right about every pair.
inline ladder::Method exact(const char* id, const char* title) {
  return {.id = id, .title = title, .scalar = "double", .exact = true};
}

/// Whether the bodies touch in the step, and when: a fraction of the step, 0 if they touch or
/// overlap at the start.
struct Answer {
  bool hit = false;
  double t = 0;
  bool unknown = false;  ///< the method gave up
};
inline Answer hit_at(double t) { return {true, t, false}; }

/// Wrong is to miss a touch, or to invent one; the error is that of the time, as a fraction of the
/// step.
inline ladder::Verdict judge(const Answer& got, const Answer& right) {
  ladder::Verdict verdict;
  verdict.undecided = got.unknown;
  verdict.wrong = !got.unknown && got.hit != right.hit;
  if (!got.unknown && got.hit && right.hit) verdict.error = std::abs(got.t - right.t);
  return verdict;
}

inline ladder::Fact told(const char* name, const Answer& answer) {
  if (answer.unknown) return {name, "gives up"};
  if (!answer.hit) return {name, "no touch"};
  return ladder::number(name, answer.t);
}

/// The first overlap that tests at the ends of slices find, and then halvings of that slice.
template <class Overlap>
Answer by_slices(const Overlap& overlap, int slices, int halvings = 0) {
  const auto found = contact::sliced_step<double>(overlap, 1.0, slices);
  if (!found) return {};
  return hit_at(contact::bisect_impact<double>(overlap, *found, halvings).hit);
}

}  // namespace measured_impact
