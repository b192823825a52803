// The right sum is exact and rounded once.
#include "break_the_sum.hpp"
#include "sum_in_float.hpp"

#include <support/break_it.hpp>

#include <contact/exact.hpp>

namespace {

using namespace contact::testing;
using Impulses = std::vector<double>;

double right_sum(const Impulses& impulses) {
  contact::Exact sum;
  for (const double impulse : impulses) sum += contact::Exact(impulse);
  return rounded<double>(sum);
}

double sum_of_magnitudes(const Impulses& impulses) {
  double sum = 0;
  for (const double impulse : impulses) sum += std::abs(impulse);
  return sum;
}

template <class Wrong>
Judged judged(const Impulses& impulses, Wrong&& wrong) {
  const double given = given::sum_in_float(impulses), right = right_sum(impulses);
  const double off = std::abs(given - right);
  // What single precision may do at each of the additions and conversions, relative to the result.
  const double rounding = 0x1p-23 * static_cast<double>(impulses.size()) * std::abs(right);
  return {wrong(given, right), contact::text_of(given), contact::text_of(right),
          "The difference is " + contact::text_of(off, {.digits = 3}) + " N s.",
          off > 0 && off <= rounding};
}

BreakIt<Impulses> question(std::string_view text, std::size_t least, std::size_t most,
                           double limit) {
  const std::string number = contact::text_of(limit);
  const std::string count =
      least == most ? std::to_string(most) : std::to_string(least) + " to " + std::to_string(most);
  return break_it<Impulses>(text)
      .rule("there are " + count + " impulses",
            [=](const Impulses& all) { return all.size() >= least && all.size() <= most; })
      .rule("every impulse is from -" + number + " to " + number + " N s",
            [limit](const Impulses& all) { return all_within(all, limit); })
      .suspect_if("break-sum-is-exact", [](const Impulses& all) {
        return given::sum_in_float(all) == right_sum(all) && sum_of_magnitudes(all) <= 0x1p24;
      });
}

}  // namespace

TEST_CASE("three whole numbers have the sum zero, and should not") {
  question("Which three impulses lose their sum?", 3, 3, 0x1p25)
      .rule("every impulse is a whole number", all_whole<Impulses>)
      .rule("the sum is not zero", [](const Impulses& all) { return right_sum(all) != 0; })
      .input("impulses", [] { return exercise::three_that_cancel(); })
      .judge([](const Impulses& all) {
        return judged(all, [](double given, double) { return given == 0; });
      });
}

TEST_CASE("the sum of numbers up to 1 is wrong by half of itself") {
  question("Which sum of impulses up to 1 is wrong by half of itself?", 1, 10, 1)
      .rule("the sum is not zero", [](const Impulses& all) { return right_sum(all) != 0; })
      .input("impulses", [] { return exercise::none_above_one(); })
      .judge([](const Impulses& all) {
        return judged(all, [](double given, double right) {
          return std::abs(given - right) > std::abs(right) / 2;
        });
      });
}

TEST_CASE("the sum of positive numbers is wrong by 100") {
  question("Which sum of positive impulses is wrong by more than 100?", 1, 50, 1e9)
      .rule("every impulse is positive",
            [](const Impulses& all) {
              return std::all_of(all.begin(), all.end(), [](double x) { return x > 0; });
            })
      .input("impulses", [] { return exercise::all_positive(); })
      .judge([](const Impulses& all) {
        return judged(all,
                      [](double given, double right) { return std::abs(given - right) > 100; });
      });
}
