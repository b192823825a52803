// misconception: variances-pooled
// caught by: two errors add as squares
// seen: https://github.com/zalando/expan/pull/245 said to be Welch, and pooled
#include "same_averages.hpp"

namespace exercise {

namespace {

/// Of a sample.
struct Estimate {
  double mean;
  double count;
  double squares;
};

Estimate estimate(const std::vector<double>& values) {
  double sum = 0;
  for (const double x : values) sum += x;
  const double count = static_cast<double>(values.size());
  const double mean = sum / count;
  double squares = 0;
  for (const double x : values) squares += (x - mean) * (x - mean);
  return {mean, count, squares};
}

}  // namespace

Comparison compare(const std::vector<double>& first, const std::vector<double>& second,
                   double limit) {
  if (first.size() < 2 || second.size() < 2) return Comparison::too_few;
  const Estimate a = estimate(first);
  const Estimate b = estimate(second);
  const double squared_error =
      (a.squares + b.squares) / (a.count + b.count - 2) * (1 / a.count + 1 / b.count);
  const double distance = a.mean - b.mean;
  const bool differ = distance * distance > limit * limit * squared_error;
  return differ ? Comparison::differ : Comparison::agree;
}

}  // namespace exercise
