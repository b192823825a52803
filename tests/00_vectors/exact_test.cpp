#include <Eigen/Core>
#include <Eigen/Geometry>
#include <bit>
#include <boost/multiprecision/gmp.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/exact.hpp>
#include <contact/vector.hpp>
#include <cstdint>
#include <limits>
#include <random>

namespace {

using contact::Exact;
using Rational = boost::multiprecision::mpq_rational;

static_assert(contact::Ring<Exact>);
static_assert(!contact::Scalar<Exact>);  // a third is not dyadic

// Any finite double: every bit pattern but those of infinities and NaNs is as likely as another, so
// half of the numbers are beyond 2^511 or below 2^-511, and sums meet every distance between
// exponents.
double any_double(std::mt19937_64& bits) {
  for (;;) {
    const double x = std::bit_cast<double>(bits());
    if (std::isfinite(x)) return x;
  }
}

// Numbers that cancel: few bits, near exponents, zeros, subnormals and the ends of the range.
double awkward_double(std::mt19937_64& bits) {
  const auto pick = bits() % 8;
  const double sign = (bits() & 1) != 0 ? 1.0 : -1.0;
  if (pick == 0) return sign * 0.0;
  if (pick == 1) return sign * std::numeric_limits<double>::denorm_min() * double(bits() % 5);
  if (pick == 2) return sign * std::numeric_limits<double>::max();
  if (pick == 3) return sign * std::ldexp(1.0, int(bits() % 2098) - 1074);
  if (pick == 4) return sign * (1.0 + double(bits() % 3) * std::numeric_limits<double>::epsilon());
  if (pick == 5) return sign * double(bits() % 4096);
  return any_double(bits);
}

// The rational nearest to which a double must lie is in [below, above], the halfway points to its
// neighbours.
template <class Float>
bool is_nearest(const Rational& value, Float result) {
  constexpr Float largest = std::numeric_limits<Float>::max();
  constexpr Float infinity = std::numeric_limits<Float>::infinity();
  const auto beyond = [&] {  // halfway between the largest number and the power of two above it
    return Rational(largest) +
           (Rational(largest) - Rational(std::nextafter(largest, Float(0)))) / 2;
  };
  if (std::isinf(result)) return result > 0 ? value >= beyond() : value <= -beyond();
  const auto middle = [&](Float neighbour) {
    if (std::isinf(neighbour)) return neighbour > 0 ? beyond() : Rational(-beyond());
    return Rational((Rational(result) + Rational(neighbour)) / 2);
  };
  const Rational below = middle(std::nextafter(result, -infinity));
  const Rational above = middle(std::nextafter(result, infinity));
  const bool even =
      (std::bit_cast<std::conditional_t<sizeof(Float) == 4, std::uint32_t, std::uint64_t>>(result) &
       1) == 0;
  return even ? below <= value && value <= above : below < value && value < above;
}

int order(const Rational& x, const Rational& y) { return x.compare(y) > 0 ? 1 : (x < y ? -1 : 0); }
int order(const Exact& x, const Exact& y) { return x > y ? 1 : (x < y ? -1 : 0); }

}  // namespace

TEST_CASE("an Exact made from a double is that double") {
  std::mt19937_64 bits(1);
  for (int i = 0; i < 20000; ++i) {
    const double x = awkward_double(bits);
    REQUIRE(rounded<double>(Exact(x)) == x);
    REQUIRE(Exact(x).sign() == (x > 0) - (x < 0));
  }
  REQUIRE(Exact(-0.0) == Exact());
  REQUIRE(Exact(5e-324).sign() == 1);
}

TEST_CASE("sums, differences and products agree with rational arithmetic") {
  std::mt19937_64 bits(2);
  for (int i = 0; i < 20000; ++i) {
    const double x = awkward_double(bits), y = awkward_double(bits), z = awkward_double(bits);
    const Rational exact_sum = Rational(x) * Rational(y) - Rational(z) * Rational(x) + Rational(z);
    const Exact ours = Exact(x) * Exact(y) - Exact(z) * Exact(x) + Exact(z);
    CAPTURE(x, y, z);
    REQUIRE(ours.sign() == exact_sum.sign());
    // Compare as values, not only as signs: the difference from the rounded rational has the
    // rational's sign.
    const double probe = any_double(bits);
    REQUIRE(order(ours, Exact(probe)) == order(exact_sum, Rational(probe)));
    REQUIRE(is_nearest<double>(exact_sum, rounded<double>(ours)));
  }
}

TEST_CASE("a sum that cancels to the last bit is zero, and one bit more is not") {
  const double huge = std::numeric_limits<double>::max();
  const double tiny = std::numeric_limits<double>::denorm_min();
  const Exact big = Exact(huge) * Exact(huge) * Exact(huge);
  const Exact small = Exact(tiny) * Exact(tiny) * Exact(tiny);
  REQUIRE((big + small - big) == small);
  REQUIRE((big + small - big - small).sign() == 0);
  REQUIRE(big + small > big);
  REQUIRE(-big - small < -big);
  REQUIRE(abs(-big) == big);
}

TEST_CASE("the determinant of three difference vectors has the rational determinant's sign") {
  std::mt19937_64 bits(3);
  int zeros = 0;
  for (int i = 0; i < 5000; ++i) {
    Eigen::Matrix<double, 3, 4> p;
    const bool grid = i % 2 == 0;
    for (Eigen::Index k = 0; k < 12; ++k) p(k) = grid ? double(bits() % 3) : awkward_double(bits);
    const auto determinant = [&](auto zero) {
      using S = decltype(zero);
      const auto column = [&](Eigen::Index j) {
        return contact::Vector3<S>(S(p(0, j)), S(p(1, j)), S(p(2, j)));
      };
      const contact::Vector3<S> x = column(1) - column(0), y = column(2) - column(0),
                                z = column(3) - column(0);
      return S(x.dot(contact::Vector3<S>(y.cross(z))));
    };
    const Exact ours = determinant(Exact());
    const Rational oracle = determinant(Rational());
    REQUIRE(ours.sign() == oracle.sign());
    REQUIRE(is_nearest<double>(oracle, rounded<double>(ours)));
    zeros += ours.sign() == 0;
  }
  REQUIRE(zeros > 500);  // the grid half does meet coplanar points
}

TEST_CASE("a quotient is rounded once, to even on a tie") {
  std::mt19937_64 bits(4);
  for (int i = 0; i < 20000; ++i) {
    const double x = awkward_double(bits), y = awkward_double(bits), z = awkward_double(bits);
    if (y == 0 || z == 0) continue;
    const Rational value = Rational(x) / (Rational(y) * Rational(z));
    CAPTURE(x, y, z);
    REQUIRE(is_nearest<double>(value, quotient<double>(Exact(x), Exact(y) * Exact(z))));
    REQUIRE(is_nearest<float>(value, quotient<float>(Exact(x), Exact(y) * Exact(z))));
  }
  // Ties, in the normal range and among the subnormals.
  const double ulp = std::numeric_limits<double>::epsilon();
  REQUIRE(rounded<double>(Exact(1.0) + Exact(ulp / 2)) == 1.0);
  REQUIRE(rounded<double>(Exact(1.0 + ulp) + Exact(ulp / 2)) == 1.0 + 2 * ulp);
  REQUIRE(quotient<double>(Exact(5e-324), Exact(2.0)) == 0.0);
  REQUIRE(quotient<double>(Exact(15e-324), Exact(2.0)) == 10e-324);
  REQUIRE(std::isinf(quotient<double>(Exact(1e300), Exact(1e-300))));
  REQUIRE(quotient<double>(Exact(-1.0), Exact(3.0)) == -1.0 / 3.0);
}
