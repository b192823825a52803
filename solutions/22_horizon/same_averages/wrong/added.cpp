// misconception: standard-errors-added
// caught by: two errors add as squares
// seen: https://github.com/OpenIntroStat/oilabs-tidy/issues/29
//   a lab asks whether two intervals overlap
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
  const double error = std::sqrt(a.squared_error) + std::sqrt(b.squared_error);
  const double distance = a.mean - b.mean;
  const bool differ = distance * distance > limit * limit * error * error;
  return differ ? Comparison::differ : Comparison::agree;
}

}  // namespace exercise
