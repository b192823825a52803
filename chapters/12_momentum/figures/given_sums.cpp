// The sums of the first impulses of a list by different methods, in one type: their errors.
#include <algorithm>
#include <cmath>
#include <contact/exact.hpp>
#include <contact/figure.hpp>
#include <contact/impulse_sum.hpp>
#include <vector>

inline constexpr std::size_t terms = 128;

struct Input {
  std::array<double, terms> impulses;  // N·s
  double type;                         // 0: single precision, the impulses rounded to it; 1: double
  double count;                        // how many are added where the sums are read off
};

inline constexpr std::size_t ways = 5;

struct Output {
  double problem;
  // After each number of impulses, relative to the sum of their magnitudes.
  std::array<double, terms> recursive, halves, kahan, compensated, book;
  double count;
  std::array<double, ways> read;    // the sums after so many, N·s, in this order
  std::array<double, ways> errors;  // and their errors
  double right;                     // the exact sum, rounded, N·s
  double size;                      // the sum of the magnitudes, N·s
};

namespace {

template <class S>
void sum(const Input& in, Output& out) {
  const auto at = static_cast<std::size_t>(out.count);
  std::vector<S> some;
  contact::Exact exact;
  double size = 0;
  for (std::size_t k = 0; k < terms; ++k) {
    const auto impulse = static_cast<S>(in.impulses[k]);
    some.push_back(impulse);
    exact += contact::Exact(double(impulse));
    size += std::abs(double(impulse));
    const auto nearest = rounded<double>(exact);
    const auto rest = rounded<double>(exact - contact::Exact(nearest));
    const std::array<double, ways> sums{
        double(contact::total_recursive(some)), double(contact::total_pairwise(some)),
        double(contact::total_kahan(some)), double(contact::total_compensated(some)),
        // The book's sum is one of doubles, whatever they come from.
        contact::total_impulse(std::vector<double>(some.begin(), some.end()))};
    std::array<double, ways> errors{};
    for (std::size_t i = 0; i < ways; ++i)
      errors[i] = size > 0 ? std::abs((sums[i] - nearest) - rest) / size : 0;
    out.recursive[k] = errors[0];
    out.halves[k] = errors[1];
    out.kahan[k] = errors[2];
    out.compensated[k] = errors[3];
    out.book[k] = errors[4];
    if (k + 1 != at) continue;
    out.read = sums;
    out.errors = errors;
    out.right = nearest;
    out.size = size;
  }
}

}  // namespace

Output compute(const Input& in) {
  Output out{};
  for (const double impulse : in.impulses) {
    if (std::abs(impulse) > 1e30) out.problem = contact::figure::too_large;
  }
  if (out.problem != 0) return out;
  out.count = std::nearbyint(std::clamp(in.count, 1.0, double(terms)));
  if (in.type == 0)
    sum<float>(in, out);
  else
    sum<double>(in, out);
  return out;
}

FIGURE(Input, FIELDS(impulses, type, count), Output,
       FIELDS(problem, recursive, halves, kahan, compensated, book, count, read, errors, right,
              size))
