// Named tests use exact numbers, computed by hand. Random ones begin with the answer: they choose
// the first bounce that is left out, then a tolerance between its height and the previous one, and
// an end of the scene between two impacts. Every test asks for at least two different answers, so
// that no constant passes it.
#include "events_or_steps.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>

namespace {

using namespace contact::testing;
using exercise::Ball;
using exercise::Run;

/// The right rule, and its mistakes.
enum class Way {
  right,
  heights_by_k,
  one_bounce,
  no_zeno,
  finite_anyway,
  to_the_end,
  seconds,
  half
};

Run followed(const Ball& ball, double duration, double tolerance, int budget, Way way) {
  const Run steps{false, 0, 0, 0};
  if (way == Way::no_zeno && ball.k < 1) return steps;
  Run run{true, 0, 0, 0};
  double impact = std::sqrt(2 * ball.drop / ball.gravity);
  double flight = (way == Way::half ? 1 : 2) * ball.k * impact;
  double height = ball.drop;
  const double shrink = way == Way::heights_by_k ? ball.k : ball.k * ball.k;
  const bool endless = way == Way::to_the_end && ball.k < 1;
  const bool paid = way == Way::finite_anyway && ball.k == 1;
  for (; (endless || impact <= duration) && run.impacts < 10000; impact += flight / ball.k) {
    if (run.impacts == budget && !paid) return steps;
    ++run.impacts;
    height *= shrink;
    if ((way == Way::seconds ? flight : height) <= tolerance) {
      run.error = height;
      run.early = flight / (way == Way::one_bounce ? 1 : 1 - ball.k);
      return run;
    }
    flight *= ball.k;
  }
  return run;
}

void check(const Ball& ball, double duration, double tolerance, int budget, const Run& right) {
  const auto like = [&](Way way) {
    return [&ball, duration, tolerance, budget, way] {
      return followed(ball, duration, tolerance, budget, way);
    };
  };
  ask("Is the ball followed from impact to impact, and with which error?")
      .given("ball", ball)
      .given("duration", duration)
      .given("tolerance", tolerance)
      .given("budget", budget)
      .suspect("loss-means-steps", like(Way::no_zeno))
      .suspect("budget-for-losses-only", like(Way::finite_anyway))
      .suspect("end-of-scene-ignored", like(Way::to_the_end))
      .suspect("height-times-k", like(Way::heights_by_k))
      .suspect("seconds-against-metres", like(Way::seconds))
      .suspect("series-cut-after-one", like(Way::one_bounce))
      .suspect("half-flights", like(Way::half))
      .suspect("first-impact-not-counted",
               [&right] {
                 return Run{right.events, right.impacts - 1, right.error, right.early};
               })
      .suspect("end-excluded",
               [&] {
                 return followed(ball, std::nextafter(duration, -1.0), tolerance, budget,
                                 Way::right);
               })
      .answer([&] { return exercise::plan_run(ball, duration, tolerance, budget); })
      // Powers of k by some thirty products, or by a power; a quotient that grows with 1 / (1 − k).
      .close_to(right, within(1e-12 * (right.error + right.early)));
}

const Run steps{false, 0, 0, 0};
/// Its impacts are at 1/2, 1, 5/4, 11/8 ... s, and its bounces rise to 1/4, 1/16, 1/64 ... m.
const Ball half{1, 8, 0.5};
/// Its impacts are at 1/2, 3/2, 5/2 ... s.
const Ball elastic{1, 8, 1};

}  // namespace

TEST_CASE("bounces above the tolerance are followed") {
  check({1, 8, 0.75}, 20, 0.5, 100, {true, 2, 0.31640625, 2.25});
  check(half, 10, 0.03125, 100, {true, 3, 0.015625, 0.25});
  check(half, 10, 0.0625, 100, {true, 2, 0.0625, 0.5});
  check(half, 10, 0.3, 100, {true, 1, 0.25, 1});
  check({1, 8, 0}, 10, 0.03125, 100, {true, 1, 0, 0});
}

TEST_CASE("all later bounces are left out too") {
  // Bounces of 3/4 and 9/16 of a second; the second rises to (3/4)⁴.
  check({1, 8, 0.75}, 20, 0.5, 100, {true, 2, 0.31640625, 2.25});
  check({1, 8, 0.75}, 20, 0.75, 100, {true, 1, 0.5625, 3});
  // With less gravity, bounces of the same height take longer.
  check({1, 2, 0.5}, 20, 0.03125, 100, {true, 3, 0.015625, 0.5});
}

TEST_CASE("the scene may end before the ball rests") {
  check(half, 1.1875, 0.00390625, 100, {true, 2, 0, 0});
  check(half, 1.25, 0.00390625, 100, {true, 3, 0, 0});
  check(half, 1.46875, 0.00390625, 100, {true, 4, 0.00390625, 0.125});
  check(half, 0.25, 0.03125, 100, {true, 0, 0, 0});
}

TEST_CASE("an elastic ball needs a budget") {
  check(elastic, 10, 0.03125, 10, {true, 10, 0, 0});
  check(elastic, 10.5, 0.03125, 10, steps);
  check(elastic, 86400, 0.03125, 1000, steps);
  check(elastic, 2.25, 0.5, 3, {true, 2, 0, 0});
}

TEST_CASE("one impact beyond the budget") {
  check(half, 10, 0.03125, 3, {true, 3, 0.015625, 0.25});
  check(half, 10, 0.03125, 2, steps);
  check(half, 1.1875, 0.03125, 2, {true, 2, 0, 0});
  check(half, 0.25, 0.03125, 0, {true, 0, 0, 0});
  check(half, 0.5, 0.03125, 0, steps);
}

TEST_CASE("random balls agree") {
  generators::Random random(seed(0));
  for (int asked = 0; asked < 300; ++asked) {
    const double drop = random.uniform(0.2, 20);
    const double gravity = random.uniform(1, 20);
    const bool loses = random.chance(0.8);
    const double k = loses ? random.uniform(0.3, 0.93) : 1;
    const int left_out = random.integer(1, 12);  // the number of the first bounce that is
    const bool whole = loses && random.chance(0.5);
    const int before = random.integer(0, left_out - 1);
    // Impact n + 1 comes 1 + 2 (k + ... + kⁿ) falls after the start.
    const auto impact = [&](int n) {
      double falls = 1;
      for (int i = 1; i < n; ++i) falls += 2 * std::pow(k, i);
      return n == 0 ? 0 : falls * std::sqrt(2 * drop / gravity);
    };
    const double between = random.uniform(0.1, 0.9);
    const double high = std::pow(k, 2 * left_out) * drop;
    const double tolerance = loses ? high * (1 + between * (1 / (k * k) - 1)) : drop * between;
    const double rest = impact(left_out);
    const double duration = whole
                                ? rest * (1 + between)
                                : impact(before) + between * (impact(before + 1) - impact(before));
    Run right{true, whole ? left_out : before, 0, 0};
    if (whole) {
      right.error = high;
      right.early = 2 * std::pow(k, left_out) * impact(1) / (1 - k);
    }
    const int budget = std::max(0, right.impacts + random.integer(-2, 3));
    if (budget < right.impacts) right = steps;
    check({drop, gravity, k}, duration, tolerance, budget, right);
  }
}
