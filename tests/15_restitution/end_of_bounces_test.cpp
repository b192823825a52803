// Times of falls that are whole multiples of a power of two, or times well inside a flight: so a
// count does not depend on how a time is rounded. Every test asks for at least two different
// answers, so that no constant passes one.
#include "end_of_bounces.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>

namespace {

using namespace contact::testing;

/// The number of impacts by the time, of a series that begins at `first` and whose flights begin
/// with `flight` and shrink by `ratio`.
int counted(double first, double flight, double ratio, double time) {
  int n = 0;
  for (double impact = first; impact <= time && n < 10000; ++n) {
    impact += flight;
    flight *= ratio;
  }
  return n;
}

void check_end(double drop, double gravity, double k) {
  const double fall = std::sqrt(2 * drop / gravity);
  const double right = fall * ((1 + k) / (1 - k));
  // Quotient and root, 1 + k, 1 - k, quotient and product: 6 u. As a sum, 1 + 2k/(1 − k), the same.
  const double bound = 16 * 0x1p-53 * right;
  ask("When does the ball come to rest?")
      .given("drop", drop)
      .given("gravity", gravity)
      .given("k", k)
      .suspect("half-flights", [&] { return fall / (1 - k); })
      .suspect("first-fall-as-a-flight", [&] { return 2 * fall / (1 - k); })
      .suspect("times-go-with-k-squared", [&] { return fall * (1 + k * k) / (1 - k * k); })
      .suspect("first-fall-left-out", [&] { return fall * 2 * k / (1 - k); })
      .suspect_if("at-rest-too-early", [&](const double& got) { return got <= fall * (1 + 1e-9); })
      .answer([&] { return exercise::rest_time(drop, gravity, k); })
      .close_to(right, within(bound));
}

void check_count(double drop, double gravity, double k, double time, int right) {
  const double fall = std::sqrt(2 * drop / gravity);
  ask("How many impacts have there been?")
      .given("drop", drop)
      .given("gravity", gravity)
      .given("k", k)
      .given("time", time)
      .suspect("first-impact-not-counted", [right] { return std::max(right - 1, 0); })
      .suspect("end-excluded",
               [&] { return counted(fall, 2 * k * fall, k, std::nextafter(time, -1.0)); })
      .suspect("half-flights", [&] { return counted(fall, k * fall, k, time); })
      .suspect("first-fall-as-a-flight", [&] { return counted(2 * fall, 2 * k * fall, k, time); })
      .suspect("times-go-with-k-squared",
               [&] { return counted(fall, 2 * k * k * fall, k * k, time); })
      .answer([&] { return exercise::bounces_by(drop, gravity, k, time); })
      .equals(right);
}

}  // namespace

TEST_CASE("the ball rests after a finite time") {
  check_end(1, 8, 0.75);  // falls for half a second
  check_end(2, 16, 0.875);
  check_end(1, 8, 0.5);
}

TEST_CASE("gravity and height set the scale") {
  check_end(4, 8, 0.5);
  check_end(1, 2, 0.5);
  check_end(1.8, 9.81, 0.8);
}

TEST_CASE("bounces are counted from the first") {
  // Impacts at 1/2, 1, 5/4, 11/8 ... seconds.
  check_count(1, 8, 0.5, 1.3125, 3);
  check_count(1, 8, 0.5, 0, 0);
  check_count(1, 8, 0.5, 0.5, 1);
  check_count(1, 8, 0.5, 0.9375, 1);
  check_count(1, 8, 0.5, 1, 2);
  check_count(1, 8, 0.5, 1.375, 4);
}

TEST_CASE("random drops agree") {
  generators::Random random(seed(0));
  for (int asked = 0; asked < 300; ++asked) {
    const double drop = random.uniform(0.1, 9);
    const double gravity = random.uniform(1, 20);
    const double k = random.uniform(0.2, 0.95);
    check_end(drop, gravity, k);
    const int bounces = random.integer(0, 20);
    const double fall = std::sqrt(2 * drop / gravity);
    double before = 0;
    double flight = fall;
    for (int i = 0; i < bounces; ++i) {
      before += flight;
      flight = i == 0 ? 2 * k * fall : flight * k;
    }
    check_count(drop, gravity, k, before + random.uniform(0.2, 0.8) * flight, bounces);
  }
}
