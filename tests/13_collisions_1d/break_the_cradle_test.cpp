// Equal elastic balls exchange their velocities, so at the end the velocities are sorted. They are
// whole numbers and nothing is rounded: the answers are compared exactly.
#include "break_the_cradle.hpp"
#include "one_pass.hpp"

#include <support/break_it.hpp>

namespace {

using namespace contact::testing;
using Row = std::vector<double>;

int approaching(const Row& row) {
  int pairs = 0;
  for (std::size_t i = 0; i + 1 < row.size(); ++i) pairs += row[i] > row[i + 1];
  return pairs;
}

/// Whether a single ball comes in from the left, and all others are at rest.
bool one_from_the_left(const Row& row) {
  return row[0] > 0 && std::all_of(row.begin() + 1, row.end(), [](double v) { return v == 0; });
}

Judged judged(const Row& row) {
  const Row given = given::one_pass(row);
  Row right = row;
  std::sort(right.begin(), right.end());
  const int left = approaching(given);
  const std::string difference =
      left == 0 ? "No neighbours approach after the one pass: the given code is right here."
                : "After the one pass " + std::to_string(left) +
                      (left == 1 ? " pair still approaches." : " pairs still approach.");
  return {given != right, contact::text_of(given), contact::text_of(right), difference};
}

BreakIt<Row> question(std::string_view text, std::size_t least, std::size_t most) {
  return break_it<Row>(text)
      .rule("there are " +
                (least == most ? std::to_string(least)
                               : std::to_string(least) + " to " + std::to_string(most)) +
                " balls",
            [=](const Row& row) { return row.size() >= least && row.size() <= most; })
      .rule("every velocity is a whole number from -10 to 10",
            [](const Row& row) { return all_within(row, 10) && all_whole(row); })
      .suspect_if("break-cradle-at-rest", [](const Row& row) { return approaching(row) == 0; })
      .suspect_if("break-cradle-from-the-left", one_from_the_left);
}

}  // namespace

TEST_CASE("one of three balls moves") {
  question("Of which row of three is the given code wrong?", 3, 3)
      .rule("exactly one ball moves",
            [](const Row& row) { return std::count(row.begin(), row.end(), 0.0) == 2; })
      .input("velocities", [] { return exercise::three_balls(); })
      .judge(judged);
}

TEST_CASE("no ball moves to the left") {
  question("Of which row is the given code wrong, although no ball moves to the left?", 2, 8)
      .rule("no velocity is negative",
            [](const Row& row) {
              return std::all_of(row.begin(), row.end(), [](double v) { return v >= 0; });
            })
      .input("velocities", [] { return exercise::all_to_the_right(); })
      .judge(judged);
}

TEST_CASE("only one pair approaches") {
  question("Of which row is the given code wrong, although only one pair approaches?", 2, 8)
      .rule("exactly one pair of neighbours approaches",
            [](const Row& row) { return approaching(row) == 1; })
      .input("velocities", [] { return exercise::one_pair_approaches(); })
      .judge(judged);
}
