// The two points of the exercise that breaks the horizon, in pairs of doubles and in MPFR.
#include <catch2/catch_test_macros.hpp>

#include <boost/multiprecision/mpfr.hpp>

#include <22_horizon/double_double.hpp>
#include <22_horizon/twins.hpp>
#include <support/generators.hpp>

namespace {

using Long = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<100>,
                                           boost::multiprecision::et_off>;
using twins::DoubleDouble;

Long value(const DoubleDouble& x) { return Long(x.high) + Long(x.low); }

TEST_CASE("sums, products, quotients and roots of pairs of doubles have 30 digits") {
  generators::Random random(22);
  for (int i = 0; i < generators::tried(4000); ++i) {
    const auto any = [&random] {
      const double high = random.magnitude(-20, 20);
      return twins::fast_sum(high, high * random.uniform(-1, 1) * 0x1p-53);
    };
    const DoubleDouble x = any(), y = any();
    const Long a = value(x), b = value(y);
    const auto is_near = [](const DoubleDouble& got, const Long& right, const Long& size) {
      return abs(value(got) - right) <= size * 1e-30;
    };
    CHECK(is_near(x + y, a + b, abs(a) + abs(b)));
    CHECK(is_near(x - y, a - b, abs(a) + abs(b)));
    CHECK(is_near(x * y, a * b, abs(a * b)));
    CHECK(is_near(x / y, a / b, abs(a / b)));
    CHECK(is_near(sqrt(x * x), abs(a), abs(a)));
    CHECK((x < y) == (a < b));
  }
}

TEST_CASE("both points are as far apart in pairs of doubles as in 100 digits") {
  generators::Random random(23);
  int followed = 0;
  while (followed < generators::tried(160)) {
    double x = random.uniform(), y = random.uniform();
    double dx = random.uniform(-1, 1), dy = random.uniform(-1, 1);
    // A third of the paths graze the post (0, 0), at its edge to 1e-13 to 1e-8 m.
    if (followed % 3 == 0) {
      const double length = std::hypot(dx, dy);
      const double edge = twins::radius - std::pow(10, random.uniform(-13, -8));
      const double before = random.uniform(0.1, 0.5);
      dx /= length;
      dy /= length;
      x = -dy * edge - before * dx;
      y = dx * edge - before * dy;
    }
    const bool in_cell = std::min(x, y) >= 0 && std::max(x, y) <= 1;
    if (!in_cell || !twins::is_outside<DoubleDouble>({x, y})) continue;
    ++followed;
    const auto found = twins::follow<DoubleDouble>(x, y, dx, dy, 15, 1e-3);
    const auto right = twins::follow<Long>(x, y, dx, dy, 15, 1e-3);
    CAPTURE(x, y, dx, dy);
    REQUIRE(found.size() == right.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      CHECK(std::abs(found[i].flight - right[i].flight) <= 1e-9);
      CHECK(std::abs(found[i].cosine - right[i].cosine) <= 1e-9);
      CHECK(std::abs(found[i].apart - right[i].apart) <= 1e-7 * right[i].apart);
    }
  }
}

TEST_CASE("head on between two posts the distance grows as first order says") {
  // At (0, 0) and (1, 1): the matrix of a hit and a flight, from the exercise `horizon`.
  const double gap = std::sqrt(2.0) - 2 * twins::radius;
  const auto found = twins::follow<DoubleDouble>(0.5, 0.5, 1, 1, 15, 1e-3);
  REQUIRE(found.size() == 15);
  double apart = twins::beside, angle = 0;
  for (const twins::Hit& hit : found) {
    CHECK(std::abs(hit.apart - apart) <= 1e-4 * apart);
    angle += 2 * apart / twins::radius;
    apart += angle * gap;
  }
}

}  // namespace
