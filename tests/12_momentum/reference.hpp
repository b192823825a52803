/// @file
/// Random impulses and bodies, and their sums in fractions.
#pragma once

#include <cmath>
#include <utility>
#include <vector>

#include "support/generators.hpp"

namespace reference {

using generators::Random;

enum class Push { one_way, both_ways, zero_total, spread };

/// Impulses: all of one sign; of both signs; of both signs with the negative sum as the last; of
/// sizes from 1 to 10^16, where the large ones cancel.
template <class S>
std::vector<S> impulses(Random& random, Push push) {
  const int n = random.integer(1, 60);
  std::vector<S> terms;
  for (int i = 0; i < n; ++i) {
    double x = random.uniform(0.001, 1);
    if (push != Push::one_way) x = random.uniform(-1, 1);
    if (push == Push::spread) x = random.magnitude(0, 53);
    terms.push_back(static_cast<S>(x));
  }
  if (push == Push::zero_total) {
    for (int i = 0; i < n; ++i) terms.push_back(-terms[static_cast<std::size_t>(i)]);
  }
  if (push == Push::spread) {
    for (int i = 0; i < n; ++i) {
      const S x = terms[static_cast<std::size_t>(i)];
      if (std::abs(x) > S(1000)) terms.push_back(-x);
    }
  }
  for (std::size_t i = terms.size(); i > 1; --i) {
    std::swap(terms[i - 1], terms[static_cast<std::size_t>(random.integer(0, int(i) - 1))]);
  }
  return terms;
}

}  // namespace reference
