// The right time is that of the geometric series, with a relative error below 1e-12 for the k that
// are allowed. The given code must be wrong by far more.
#include "break_the_cut_off.hpp"
#include "rest_after_cut_off.hpp"

#include <support/break_it.hpp>

namespace {

using namespace contact::testing;
using exercise::Drop;

double right_time(const Drop& drop) {
  return std::sqrt(2 * drop.height / 9.81) * (1 + drop.k) / (1 - drop.k);
}

double missing(const Drop& drop) {
  return right_time(drop) - given::rest_after_cut_off(drop.height, drop.k);
}

Judged judged(const Drop& drop, bool wrong) {
  const double right = right_time(drop), share = missing(drop) / right;
  return {wrong, contact::text_of(right - missing(drop)), contact::text_of(right),
          "The given code leaves out " + contact::text_of(missing(drop), {.digits = 2}) + " s, " +
              contact::text_of(100 * share, {.digits = 2}) + " % of the time."};
}

Judged by_a_tenth(const Drop& drop) { return judged(drop, missing(drop) > right_time(drop) / 10); }

BreakIt<Drop> question(std::string_view text, std::string says, double low, double high) {
  return break_it<Drop>(text)
      .rule(std::move(says),
            [=](const Drop& drop) { return drop.height >= low && drop.height <= high; })
      .rule("k is at least 0.001 and at most 0.99999",
            [](const Drop& drop) { return drop.k >= 0.001 && drop.k <= 0.99999; })
      .suspect_if("break-cut-off-is-small",
                  [](const Drop& drop) { return missing(drop) <= right_time(drop) / 10; });
}

}  // namespace

TEST_CASE("the time is wrong by 10 % with k at most a half") {
  question("Which weak bounces end too early?", "the height is from 1e-12 m to 100 m", 1e-12, 100)
      .rule("k is at most 0.5", [](const Drop& drop) { return drop.k <= 0.5; })
      .input("drop", [] { return exercise::weak_bounces(); })
      .judge(by_a_tenth);
}

TEST_CASE("the time is wrong by 10 % from at least 1 m") {
  question("Which ball from high up rests too early?", "the height is from 1 m to 100 m", 1, 100)
      .input("drop", [] { return exercise::from_high_up(); })
      .judge(by_a_tenth);
}

TEST_CASE("the time is wrong by more than a minute") {
  question("Which ball rests a minute too early?", "the height is from 1e-12 m to 1 m", 1e-12, 1)
      .input("drop", [] { return exercise::by_a_minute(); })
      .judge([](const Drop& drop) { return judged(drop, missing(drop) > 60); });
}
