// A large impulse, many small ones, and the large one reversed: the sums by different methods.
#include <algorithm>
#include <cmath>
#include <contact/error_free.hpp>
#include <contact/figure.hpp>
#include <contact/impulse_sum.hpp>

struct Input {
  double power;  // the large impulse is 2^power N·s; power is rounded down
  double small;  // each small impulse, N·s; rounded to single precision
  double count;  // position of the reading; rounded to a sample
};

inline constexpr std::size_t samples = 51;
inline constexpr std::size_t each = 20;  // small impulses from sample to sample

struct Output {
  double problem;
  double power;
  double count;
  std::array<double, samples> recursive, halves, kahan, compensated, in_double, right;  // N·s
  std::array<double, 6> read;  // in this order
  double coarse;       // from the large impulse to the next number in single precision, N·s
  double first_digit;  // of the small impulse: the power of two
};

template <class S>
std::vector<S> impulses(S large, S small, std::size_t count) {
  std::vector<S> all(count + 2, small);
  all.front() = large;
  all.back() = -large;
  return all;
}

Output compute(const Input& in) {
  Output out{};
  const double power = std::round(in.power);
  if (!(in.small > 0)) out.problem = contact::figure::not_positive;
  if (power > 100 || in.small > 1e6) out.problem = contact::figure::too_large;
  if (out.problem == 0 && (power < -100 || in.small < 1e-6)) {
    out.problem = contact::figure::too_small;
  }
  if (out.problem != 0) return out;

  out.power = power;
  const auto large = static_cast<float>(std::ldexp(1.0, static_cast<int>(power)));
  const auto small = static_cast<float>(in.small);
  for (std::size_t k = 0; k < samples; ++k) {
    const auto floats = impulses(large, small, k * each);
    const auto doubles = impulses<double>(large, small, k * each);
    out.recursive[k] = double(contact::total_recursive(floats));
    out.halves[k] = double(contact::total_pairwise(floats));
    out.kahan[k] = double(contact::total_kahan(floats));
    out.compensated[k] = double(contact::total_compensated(floats));
    out.in_double[k] = contact::total_recursive(doubles);
    out.right[k] = contact::total_exactly(doubles);
  }
  const double asked = std::clamp(in.count / each, 0.0, double(samples - 1));
  const auto at = static_cast<std::size_t>(std::round(asked));
  out.count = static_cast<double>(at * each);
  out.read = {out.recursive[at],   out.halves[at],    out.kahan[at],
              out.compensated[at], out.in_double[at], out.right[at]};
  out.coarse = double(contact::ulp(large));
  out.first_digit = std::ilogb(small);
  return out;
}

FIGURE(Input, FIELDS(power, small, count), Output,
       FIELDS(problem, power, count, recursive, halves, kahan, compensated, in_double, right, read,
              coarse, first_digit))
