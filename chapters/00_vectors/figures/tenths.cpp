// a tenths and b tenths, as a computer stores them, and the numbers near their sum.
#include <array>
#include <cmath>
#include <contact/error_free.hpp>
#include <contact/exact.hpp>
#include <contact/figure.hpp>
#include <limits>

struct Input {
  double a;       // tenths; rounded to a whole number
  double b;       // tenths; the same
  double digits;  // 24: float; 53: double
};

struct Output {
  double problem;
  double a, b;                         // whole tenths
  double stored_a, stored_b;           // the numbers nearest to a/10 and b/10
  double sum;                          // of the two, rounded
  double nearest;                      // the number nearest to (a + b)/10
  double spacing;                      // one ulp of the sum
  double decimal_at;                   // (a + b)/10, in ulps from the sum
  double exact_at;                     // the sum of the stored numbers before it is rounded
  double nearest_at;                   // the number nearest to (a + b)/10
  double error_a, error_b;             // stored − decimal, in ulps of the sum
  std::array<double, 7> neighbour_at;  // the number itself in the middle, in ulps from it
  double equal;
  double differs_in_float;  // goal of a question: single precision, and the sum is not the nearest
};

template <class S>
void compare(const Input& in, Output& out) {
  using contact::Exact;
  const Exact ten(10);
  const auto tenths = [&ten](const Exact& n) { return quotient<S>(n, ten); };
  const S a = tenths(Exact(in.a));
  const S b = tenths(Exact(in.b));
  const S sum = a + b;
  const S nearest = tenths(Exact(in.a) + Exact(in.b));
  const S unit = contact::ulp(sum);
  out.stored_a = double(a);
  out.stored_b = double(b);
  out.sum = double(sum);
  out.nearest = double(nearest);
  out.spacing = double(unit);

  const Exact ulp{double(unit)};
  const auto in_ulps = [&ulp](const Exact& distance) { return quotient<double>(distance, ulp); };
  const auto in_ulps_of_tenths = [&](const Exact& distance) {
    return quotient<double>(distance, ten * ulp);
  };
  const Exact from{double(sum)};
  out.decimal_at = in_ulps_of_tenths(Exact(in.a) + Exact(in.b) - ten * from);
  out.exact_at = in_ulps(Exact(double(a)) + Exact(double(b)) - from);
  out.nearest_at = in_ulps(Exact(double(nearest)) - from);
  out.error_a = in_ulps_of_tenths(ten * Exact(double(a)) - Exact(in.a));
  out.error_b = in_ulps_of_tenths(ten * Exact(double(b)) - Exact(in.b));
  S below = sum;
  S above = sum;
  for (std::size_t i = 1; i <= 3; ++i) {
    below = std::nextafter(below, S(0));
    above = std::nextafter(above, std::numeric_limits<S>::infinity());
    out.neighbour_at[3 - i] = in_ulps(Exact(double(below)) - from);
    out.neighbour_at[3 + i] = in_ulps(Exact(double(above)) - from);
  }
  out.equal = sum == nearest ? 1 : 0;
}

Output compute(const Input& given) {
  Output out{};
  const Input in{std::round(given.a), std::round(given.b), given.digits};
  if (!(in.a > 0) || !(in.b > 0)) out.problem = contact::figure::not_positive;
  if (in.a > 1e15 || in.b > 1e15) out.problem = contact::figure::too_large;
  if (out.problem != 0) return out;
  out.a = in.a;
  out.b = in.b;
  if (in.digits < 53) {
    compare<float>(in, out);
    out.differs_in_float = 1 - out.equal;
  } else {
    compare<double>(in, out);
  }
  return out;
}

FIGURE(Input, FIELDS(a, b, digits), Output,
       FIELDS(problem, a, b, stored_a, stored_b, sum, nearest, spacing, decimal_at, exact_at,
              nearest_at, error_a, error_b, neighbour_at, equal, differs_in_float))
