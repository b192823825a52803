/// @file
/// Random discs, and their collisions in exact fractions.
#pragma once

#include <array>
#include <cmath>
#include <contact/disc_collision.hpp>

#include "support/generators.hpp"
#include "support/oracle.hpp"

namespace reference {

using contact::Disc;
using contact::Vector2;
using generators::Random;
using oracle::Rational;

struct Pair {
  Rational dx, dy, wx, wy, radius_sum;
  Rational distance2() const { return dx * dx + dy * dy; }
  Rational speed2() const { return wx * wx + wy * wy; }
  Rational gap() const { return distance2() - radius_sum * radius_sum; }
  Rational approach() const { return -(dx * wx + dy * wy); }
  Rational depth() const {
    const Rational cross = dx * wy - dy * wx;
    return radius_sum * radius_sum * speed2() - cross * cross;
  }
};

template <class S>
Pair exact_pair(const Disc<S>& a, const Disc<S>& b) {
  using oracle::exact;
  return {exact(a.centre.x()) - exact(b.centre.x()), exact(a.centre.y()) - exact(b.centre.y()),
          exact(a.velocity.x()) - exact(b.velocity.x()),
          exact(a.velocity.y()) - exact(b.velocity.y()), exact(a.radius) + exact(b.radius)};
}

template <class S>
Vector2<S> vector_of(Random& random, double size) {
  return Vector2<S>{static_cast<S>(random.uniform(-size, size)),
                    static_cast<S>(random.uniform(-size, size))};
}

enum class Kind { anywhere, touching, grazing, grid, far };

inline constexpr std::array<Kind, 5> all_kinds{Kind::anywhere, Kind::touching, Kind::grazing,
                                               Kind::grid, Kind::far};

/// Two discs: anywhere; with the distance of the centres equal to the radii, to rounding; on paths
/// that graze to within a few ulps; on whole numbers; touching and far from the origin.
template <class S>
std::array<Disc<S>, 2> pair_of(Random& random, Kind kind) {
  const auto number = [&](double low, double high) {
    return static_cast<S>(random.uniform(low, high));
  };
  Disc<S> a{number(0.1, 9), number(0.1, 1), vector_of<S>(random, 3), vector_of<S>(random, 5)};
  Disc<S> b{number(0.1, 9), number(0.1, 1), vector_of<S>(random, 3), vector_of<S>(random, 5)};
  if (kind == Kind::grid) {
    const auto whole = [&] { return S(random.integer(-4, 4)); };
    a.centre = Vector2<S>{whole(), whole()};
    b.centre = Vector2<S>{whole(), whole()};
    a.velocity = Vector2<S>{whole(), whole()};
    b.velocity = Vector2<S>{whole(), whole()};
    a.radius = S(random.integer(0, 3));
    b.radius = S(random.integer(0, 3));
    return {a, b};
  }
  if (kind == Kind::far) b.centre += vector_of<S>(random, 1e6);
  if (kind == Kind::touching || kind == Kind::far) {
    const auto n = contact::line_of_centres(vector_of<S>(random, 1), Vector2<S>(S(0), S(2)));
    a.centre = b.centre + *n * S(a.radius + b.radius);
  }
  if (kind == Kind::grazing) {
    const auto n = *contact::line_of_centres(vector_of<S>(random, 1), Vector2<S>(S(0), S(2)));
    const Vector2<S> along{-n.y(), n.x()};
    S radius_sum = a.radius + b.radius;
    for (int k = random.integer(-3, 3); k != 0; k += k > 0 ? -1 : 1) {
      radius_sum = std::nextafter(radius_sum, k > 0 ? S(9) : S(0));
    }
    a.centre = b.centre + n * radius_sum - along * number(0.1, 4);
    a.velocity = b.velocity + along * number(0.1, 4);
  }
  return {a, b};
}

}  // namespace reference
