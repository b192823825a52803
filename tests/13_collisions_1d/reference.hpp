/// @file
/// Random collisions on a line.
#pragma once

#include <array>
#include <cmath>
#include <contact/block_count.hpp>
#include <contact/collision_1d.hpp>
#include <limits>

#include "support/generators.hpp"
#include "support/oracle.hpp"

namespace reference {

using contact::LineBody;
using generators::Random;
using oracle::Rational;

template <class S>
constexpr S infinity = std::numeric_limits<S>::infinity();

template <class S>
LineBody<Rational> exactly(const LineBody<S>& body) {
  return {oracle::exact(body.mass), oracle::exact(body.velocity)};
}

template <class S>
struct Pair {
  LineBody<S> first, second;
  S e;
};

enum class Kind { random, whole, alike, slow, spread };

/// Two bodies: nothing special; whole numbers; of one mass; a few ulps from one velocity; of any
/// size.
template <class S>
Pair<S> pair(Random& random, Kind kind) {
  const int wide = std::is_same_v<S, float> ? 15 : 100;
  const auto number = [&](double low, double high) {
    if (kind == Kind::whole) return static_cast<S>(random.integer(int(low), int(high)));
    if (kind == Kind::spread) return static_cast<S>(random.magnitude(-wide, wide));
    return static_cast<S>(random.uniform(low, high));
  };
  const S m1 = std::max(std::abs(number(0, 9)), S(0x1p-40));
  const S m2 = kind == Kind::alike ? m1 : std::max(std::abs(number(0, 9)), S(0x1p-40));
  const S v1 = number(-9, 9);
  S v2 = number(-9, 9);
  if (kind == Kind::slow) {
    v2 = v1;
    for (int k = random.integer(0, 5); k > 0; --k) v2 = std::nextafter(v2, -infinity<S>);
  }
  constexpr std::array<double, 4> whole_e{0, 1, 0.5, 0.25};
  const S e = random.chance(0.5) ? static_cast<S>(random.uniform())
                                 : static_cast<S>(whole_e[random.bits() % 4]);
  return {contact::line_body(m1, v1), contact::line_body(m2, v2), e};
}

inline Rational exactly(const contact::DoubleDouble& x) {
  return oracle::exact(x.high()) + oracle::exact(x.low());
}

}  // namespace reference
