#include "same_averages.hpp"

namespace exercise {

namespace {

/// Of a sample: its mean, and the square of the mean's standard error.
struct Estimate {
  double mean;
  double squared_error;
};

Estimate estimate(const std::vector<double>& values) {
  //? A first pass gives the mean.
  //? gap: sum / count
  double sum = 0;
  for (const double x : values) sum += x;
  const double count = static_cast<double>(values.size());
  const double mean = sum / count;
  //? A second pass adds the squares of the distances from it. They are small numbers, however large
  //? the mean is, so nothing cancels.
  //? gap: (x - mean) * (x - mean)
  double squares = 0;
  for (const double x : values) squares += (x - mean) * (x - mean);
  //? The variance of a value, unbiased, and from it that of the mean of so many.
  //? gap: squares / (count - 1)
  const double variance = squares / (count - 1);
  return {mean, variance / count};
}

}  // namespace

Comparison compare(const std::vector<double>& first, const std::vector<double>& second,
                   double limit) {
  //? Of one value nobody knows how far it is off.
  //? gap: first.size() < 2 || second.size() < 2
  if (first.size() < 2 || second.size() < 2) return Comparison::too_few;
  //? Each sample has its own variance.
  const Estimate a = estimate(first);
  const Estimate b = estimate(second);
  //? The errors are independent, so their squares add up.
  //? gap: a.squared_error + b.squared_error
  const double squared_error = a.squared_error + b.squared_error;
  //? The squares are compared, which needs no root and counts both directions.
  //? gap: distance * distance > limit * limit * squared_error
  const double distance = a.mean - b.mean;
  const bool differ = distance * distance > limit * limit * squared_error;
  //? If both errors are 0, any distance is more than 0 of them.
  return differ ? Comparison::differ : Comparison::agree;
}

}  // namespace exercise
