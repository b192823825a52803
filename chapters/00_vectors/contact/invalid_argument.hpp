/// @file
/// How a construction refuses its input.
///
/// The book has three kinds of error. A programming error asserts (in debug builds). A
/// *construction* from invalid user input throws std::invalid_argument, by the functions here. A
/// *query* on valid objects is total: it never throws and never turns finite input into NaN.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <concepts>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>

#include <contact/vector.hpp>

namespace contact {

/// A number as text: 17 digits, which determine the double; "?" for a type that is not a
/// floating-point type. With CONTACT_WITHOUT_PRINTF, which a figure in the page defines to be
/// small: "5" or "3 * 2^-2".
template <Ring S>
std::string number_text(const S& x) {
  if constexpr (std::floating_point<S>) {
#ifdef CONTACT_WITHOUT_PRINTF
    if (!std::isfinite(x)) return std::isnan(x) ? "nan" : (x > 0 ? "inf" : "-inf");
    int exponent = 0;
    auto digits = static_cast<long long>(0x1p53 * std::frexp(static_cast<double>(x), &exponent));
    for (exponent -= 53; digits % 2 == 0 && exponent < 0 && digits != 0; ++exponent) digits /= 2;
    const auto whole = [](long long n) {
      std::string text;
      for (long long rest = n < 0 ? -n : n; rest > 0 || text.empty(); rest /= 10)
        text.insert(text.begin(), static_cast<char>('0' + rest % 10));
      return n < 0 ? "-" + text : text;
    };
    return digits == 0 || exponent == 0 ? whole(digits) : whole(digits) + " * 2^" + whole(exponent);
#else
    char text[48];
    std::snprintf(text, sizeof text, "%.17g", static_cast<double>(x));
    return text;
#endif
  } else {
    return "?";
  }
}

/// A vector as text: "(1, 0, -2.5)".
template <class Derived>
std::string vector_text(const Eigen::MatrixBase<Derived>& v) {
  std::string text = "(";
  for (Eigen::Index i = 0; i < v.size(); ++i) {
    if (i > 0) text += ", ";
    const typename Derived::Scalar entry = v.derived().coeff(i);
    text += number_text(entry);
  }
  return text + ")";
}

/// Throws std::invalid_argument with "argument = value: reason".
///
/// Where exceptions are switched off (a figure in the page) it prints the same sentence and aborts;
/// a figure checks its input first, so this is not reached.
[[noreturn]] inline void throw_invalid_argument(const std::string& argument,
                                                const std::string& value,
                                                const std::string& reason) {
  const std::string message = argument + " = " + value + ": " + reason;
#if defined(__cpp_exceptions)
  throw std::invalid_argument(message);
#else
  std::fprintf(stderr, "%s\n", message.c_str());
  std::abort();
#endif
}

/// Throws std::invalid_argument unless x is finite.
template <Ring S>
void require_finite(const char* argument, const S& x) {
  if (!is_finite(x)) throw_invalid_argument(argument, number_text(x), "must be finite");
}

/// Throws std::invalid_argument unless every entry of v is finite.
template <class Derived>
void require_finite(const char* argument, const Eigen::MatrixBase<Derived>& v) {
  if (!all_finite(v)) {
    throw_invalid_argument(argument, vector_text(v), "every coordinate must be finite");
  }
}

}  // namespace contact
