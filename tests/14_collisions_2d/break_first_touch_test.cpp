// Whether the discs touch is decided without rounding. The time is that of the stable form of the
// smaller root, from terms without rounding: its relative error is below 1e-15, and the given code
// must be wrong by 1e-2.
#include "break_first_touch.hpp"
#include "time_of_touch.hpp"

#include <support/break_it.hpp>

#include <contact/exact.hpp>

namespace {

using namespace contact::testing;
using contact::Exact;
using exercise::Approach;

Exact dot(const Eigen::Vector2d& u, const Eigen::Vector2d& v) {
  return Exact(u.x()) * Exact(v.x()) + Exact(u.y()) * Exact(v.y());
}

struct Terms {
  Exact a, b, c, discriminant;
  explicit Terms(const Approach& all)
      : a(dot(all.velocity, all.velocity)),
        b(dot(all.position, all.velocity)),
        c(dot(all.position, all.position) - Exact(all.radii) * Exact(all.radii)),
        discriminant(b * b - a * c) {}
  bool overlap() const { return c.sign() <= 0; }
  bool approach() const { return b.sign() < 0; }
};

bool overlap_and_approach(const Approach& all) {
  const Terms terms(all);
  return terms.overlap() && terms.approach();
}

bool touch_later(const Approach& all) {
  const Terms terms(all);
  return !terms.overlap() && terms.approach() && terms.discriminant.sign() >= 0;
}

double nearest(const Exact& x) { return rounded<double>(x); }

double right_time(const Approach& all) {
  const Terms terms(all);
  if (terms.overlap()) return 0;
  return nearest(terms.c) / (std::sqrt(nearest(terms.discriminant)) - nearest(terms.b));
}

std::string told(const std::optional<double>& time) {
  return time ? contact::text_of(*time) : "they never touch";
}

Judged judged(const Approach& all) {
  const std::optional<double> given = given::time_of_touch(all.position, all.velocity, all.radii);
  const double right = right_time(all);
  if (!given) return {true, told(given), told(right), "They do touch."};
  const double off = std::abs(*given - right);
  const bool near = off <= 0.01 * right;
  return {!near, told(given), told(right),
          "The difference is " + contact::text_of(off, {.digits = 2}) + " s.",
          off > 0 && off <= 1e-9 * right};
}

BreakIt<Approach> question(std::string_view text) {
  return break_it<Approach>(text)
      .rule("no number is larger than 1e9",
            [](const Approach& all) { return all_within(all, 1e9); })
      .rule("the sum of the radii is at least 0.001 m",
            [](const Approach& all) { return all.radii >= 0.001; })
      .rule("the speed is at least 1e-6 m/s",
            [](const Approach& all) { return all.velocity.norm() >= 1e-6; });
}

}  // namespace

TEST_CASE("discs that overlap and approach touch now") {
  question("Of which overlapping discs is the given code wrong?")
      .rule("the discs overlap and approach", overlap_and_approach)
      .input("approach", [] { return exercise::overlapping(); })
      .judge(judged);
}

TEST_CASE("the time is wrong by more than 1 %") {
  question("Which time is wrong by more than 1 %?")
      .rule("the discs do not overlap and touch later", touch_later)
      .input("approach", [] { return exercise::time_is_wrong(); })
      .judge(judged);
}

TEST_CASE("head-on discs are said to miss") {
  question("Which discs are aimed at each other and are said to miss?")
      .rule("the y components are zero",
            [](const Approach& all) { return all.position.y() == 0 && all.velocity.y() == 0; })
      .rule("the discs do not overlap and touch later", touch_later)
      .suspect_if("break-disc-is-near",
                  [](const Approach& all) { return all.position.norm() <= 1e6 * all.radii; })
      .input("approach", [] { return exercise::head_on(); })
      .judge([](const Approach& all) {
        Judged judgement = judged(all);
        judgement.wrong = judgement.given == "they never touch";
        judgement.within_rounding = false;
        return judgement;
      });
}
