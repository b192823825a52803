// misconception: one-value-has-no-spread
// caught by: one value has no spread
// seen: https://github.com/bencheeorg/benchee/issues/49 a deviation of 0 is expected of one sample
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
  const double variance = count > 1 ? squares / (count - 1) : 0;
  return {mean, variance / count};
}

}  // namespace

Comparison compare(const std::vector<double>& first, const std::vector<double>& second,
                   double limit) {
  if (first.empty() || second.empty()) return Comparison::too_few;
  const Estimate a = estimate(first);
  const Estimate b = estimate(second);
  const double squared_error = a.squared_error + b.squared_error;
  const double distance = a.mean - b.mean;
  const bool differ = distance * distance > limit * limit * squared_error;
  return differ ? Comparison::differ : Comparison::agree;
}

}  // namespace exercise
