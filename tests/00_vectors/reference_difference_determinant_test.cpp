// difference_determinant.hpp against the exact type: numbers of every span, on both sides of each
// limit of the integers that it uses.
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/orientation.hpp>
#include <limits>
#include <optional>
#include <support/generators.hpp>

namespace difference_determinant_test {

using contact::Vector2;
using contact::Vector3;
using Triple = Vector3<double>;

/// ± a whole number of the given bits, times 2^exponent.
double whole(generators::Random& random, int bits, int exponent) {
  const double m = std::ldexp(random.uniform(), bits);
  return std::ldexp(random.chance(0.5) ? std::floor(m) : -std::floor(m), exponent);
}
/// Multiples of 2^-span below 1, many near 0, with at most 53 bits each.
double of_span(generators::Random& random, int span) {
  const int bits = random.integer(1, std::min(span, 53));
  return whole(random, bits, random.integer(-span, -bits));
}
Triple point(generators::Random& random, int span) {
  const double x = of_span(random, span), y = of_span(random, span);
  return {x, y, of_span(random, span)};
}
/// Rounded, a point of the plane a, b, c; for b = 0 and few bits exactly in it.
Triple nearly_in_plane(generators::Random& random, const Triple& a, const Triple& b,
                       const Triple& c) {
  const double s = whole(random, 3, -1), t = whole(random, 3, -1);
  return a + s * (b - a) + t * (c - a);
}

struct Seen {
  int zeros = 0, taken = 0, left = 0, whole = 0;
};

/// The sign that the integers give, if any, is that of the exact type.
void require_3d(const Triple& a, const Triple& b, const Triple& c, const Triple& d, Seen& seen) {
  contact::difference_detail::Differences<9> numbers;
  for (int i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(i);
    numbers.set(k, d[i], a[i]);
    numbers.set(3 + k, b[i], a[i]);
    numbers.set(6 + k, c[i], a[i]);
  }
  const int right = contact::orient_3d_exactly(a, b, c, d);
  const std::optional<int> sign = determinant_sign(numbers);
  if (sign) REQUIRE(*sign == right);
  const std::optional<int> of_whole = contact::difference_detail::whole_volume_sign(a, b, c, d);
  if (of_whole) REQUIRE(*of_whole == right);
  REQUIRE(contact::orient_3d_in_doubt(a, b, c, d) == right);
  seen.whole += of_whole.has_value();
  ++(sign ? seen.taken : seen.left);
  seen.zeros += right == 0;
}
void require_2d(const Vector2<double>& a, const Vector2<double>& b, const Vector2<double>& c,
                Seen& seen) {
  contact::difference_detail::Differences<4> numbers;
  for (int i = 0; i < 2; ++i) {
    const auto k = static_cast<std::size_t>(i);
    numbers.set(k, b[i], a[i]);
    numbers.set(2 + k, c[i], a[i]);
  }
  const int right = contact::orient_2d_exactly(a, b, c);
  const std::optional<int> sign = determinant_sign(numbers);
  if (sign) REQUIRE(*sign == right);
  REQUIRE(contact::orient_2d_in_doubt(a, b, c) == right);
  ++(sign ? seen.taken : seen.left);
  seen.zeros += right == 0;
}

TEST_CASE("determinants of differences have the exact sign, whatever their numbers span") {
  generators::Random random(1);
  for (int span = 1; span <= 220; ++span) {
    Seen seen;
    for (int i = 0; i < generators::tried(160); ++i) {
      const Triple a = i % 3 == 0 ? Triple::Zero() : point(random, span);
      const Triple b = point(random, span), c = point(random, span);
      const Triple d = i % 2 == 0 ? nearly_in_plane(random, a, b, c) : point(random, span);
      require_3d(a, b, c, d, seen);
      require_3d(d, c, a, b, seen);
      require_2d(a.head<2>(), b.head<2>(), c.head<2>(), seen);
      const Vector2<double> on = (a + whole(random, 3, -1) * (b - a)).head<2>();
      require_2d(a.head<2>(), b.head<2>(), on, seen);
    }
    REQUIRE(seen.zeros > 0);
    // Differences of numbers below 1 are below 2, and rounding adds nothing below their last bits.
    if (span <= 110) REQUIRE(seen.left == 0);
    // Points in a plane are sums of few multiples of halves; four equal points are left to others.
    if (span <= 30) REQUIRE(seen.whole > 2 * generators::tried(150));
  }
}

TEST_CASE("determinants of differences have the exact sign next to the largest integers") {
  generators::Random random(2);
  Seen seen;
  for (const int bits : {18, 19, 20, 21, 34, 35, 36, 37, 52, 53, 54, 55, 56}) {
    const double largest = std::ldexp(1.0, bits) - 1;
    const auto draw = [&] {
      const double x = largest - random.integer(0, 2);
      return random.chance(0.5) ? x : -x;
    };
    for (int i = 0; i < generators::tried(4000); ++i) {
      const Triple a = i % 2 == 0 ? Triple::Zero() : Triple(draw(), 0, 0);
      const Triple b(draw(), draw(), draw()), c(draw(), draw(), draw());
      require_3d(a, b, c, Triple(draw(), draw(), draw()), seen);
      require_2d(a.head<2>(), b.head<2>(), c.head<2>(), seen);
    }
  }
  REQUIRE(seen.zeros > generators::tried(10000) / 2);
  REQUIRE(seen.left == 0);
}

TEST_CASE("volumes of whole multiples have the exact sign next to the largest") {
  generators::Random random(4);
  Seen seen;
  for (const int bits : {39, 40, 41, 42}) {
    const double largest = std::ldexp(1.0, bits);
    for (const double away : {0.0, 1.0, 0x1p50, 0x1p52, -0x1p61}) {
      const auto draw = [&] {
        const double x = largest - random.integer(0, 2);
        return away + (random.chance(0.5) ? x : random.integer(0, 2));
      };
      for (int i = 0; i < generators::tried(1000); ++i) {
        const Triple a(draw(), draw(), draw()), b(draw(), draw(), draw());
        const Triple c(draw(), draw(), draw());
        require_3d(a, b, c, i % 2 == 0 ? a : Triple(draw(), draw(), draw()), seen);
      }
    }
  }
  REQUIRE(seen.whole > generators::tried(5000) / 2);
  REQUIRE(seen.zeros < seen.taken);
}

TEST_CASE("determinants of differences have the exact sign at every scale") {
  generators::Random random(3);
  Seen seen;
  for (int i = 0; i < generators::tried(40000); ++i) {
    const int exponent = random.integer(-1074, 1020);
    const auto draw = [&] { return std::ldexp(random.integer(-3, 3), exponent); };
    const Triple a(draw(), draw(), draw()), b(draw(), draw(), draw()), c(draw(), draw(), draw());
    const Triple d(draw(), draw(), draw());
    require_3d(a, b, c, d, seen);
    require_2d(a.head<2>(), b.head<2>(), c.head<2>(), seen);
  }
  REQUIRE(seen.zeros > generators::tried(1000) / 2);
}

TEST_CASE("a difference that overflows, and the smallest number beside the largest, are decided") {
  constexpr double largest = std::numeric_limits<double>::max();
  constexpr double smallest = std::numeric_limits<double>::denorm_min();
  Seen seen;
  const auto turn = [&](double low, double high, double off) {
    require_2d({low, 0}, {high, off}, {0, 0}, seen);
    require_3d({low, 0, 0}, {high, 0, 0}, {0, high, 0}, {0, 0, off}, seen);
    require_3d({0, 0, low}, {high, 0, low}, {0, high, low}, {0, 0, low + off}, seen);
  };
  for (const double off : {-smallest, 0.0, smallest}) {
    for (const double high : {smallest, 0x1p-1022, 0x1p-901, 0x1p-900, 1.0, 0x1p900, largest}) {
      turn(-largest, high, off);
      turn(-1, high, off);
      turn(0, high, off);
    }
  }
  for (const double off : {-0x1p-400, 0.0, 0x1p-400}) {
    turn(0, 0x1p800, off);
    require_2d({off, 0}, {0x1p800, 0x1p800}, {-0x1p800, -0x1p800}, seen);
    require_3d({off, 0, 0}, {0x1p800, 0x1p800, 0}, {0, 0, 1}, {-0x1p800, -0x1p800, 0}, seen);
  }
  REQUIRE(seen.left > 0);
  REQUIRE(seen.taken > 0);
}

TEST_CASE("a sum of products is known from its residue and its rounded value") {
  using contact::difference_detail::sign_from_residue;
  REQUIRE(sign_from_residue(-0x1p60, static_cast<std::uint64_t>(-1)) == -1);
  REQUIRE(sign_from_residue(-0x1p60, 1) == 1);
  REQUIRE(sign_from_residue(0x1p60, 0) == 0);
  REQUIRE(sign_from_residue(0x1p61, static_cast<std::uint64_t>(-1)) == 1);
  REQUIRE(sign_from_residue(-0x1p70, 0) == -1);
}

}  // namespace difference_determinant_test
