// misconception: no-spread-is-too-few
// caught by: means at the limit and beyond
// seen: https://github.com/AndreasMadsen/ttest/issues/1 constant samples have no answer
#include "same_averages.hpp"

namespace exercise {

namespace {

/// Of a sample: its mean, and the square of the mean's standard error.
struct Estimate {
  double mean;
  double squared_error;
};

Estimate estimate(const std::vector<double>& values) {
  double sum = 0;
  for (const double x : values) sum += x;
  const double count = static_cast<double>(values.size());
  const double mean = sum / count;
  double squares = 0;
  for (const double x : values) squares += (x - mean) * (x - mean);
  const double variance = squares / (count - 1);
  return {mean, variance / count};
}

}  // namespace

Comparison compare(const std::vector<double>& first, const std::vector<double>& second,
                   double limit) {
  if (first.size() < 2 || second.size() < 2) return Comparison::too_few;
  const Estimate a = estimate(first);
  const Estimate b = estimate(second);
  const double squared_error = a.squared_error + b.squared_error;
  if (squared_error == 0) return Comparison::too_few;
  const double distance = a.mean - b.mean;
  const bool differ = distance * distance > limit * limit * squared_error;
  return differ ? Comparison::differ : Comparison::agree;
}

}  // namespace exercise
