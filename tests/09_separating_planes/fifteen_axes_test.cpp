// Gaps are computed without rounding from the stored numbers, and rounded in the end. Which axis is
// first among equal ones is beyond doubt in every question. The numbers of a question are chosen so
// that each mistake gives an answer of its own.
#include "fifteen_axes.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>
#include <support/shrinkable.hpp>

#include <09_separating_planes/gaps_with_mistakes.hpp>

namespace {

using namespace contact::testing;
using exercise::LargestGap;
using gaps_with_mistakes::Along;
using gaps_with_mistakes::Axes;
using gaps_with_mistakes::Box;
using gaps_with_mistakes::rotation;
using gaps_with_mistakes::Search;
using gaps_with_mistakes::Vector;

constexpr double kTolerance = 1e-9;

void check_along(const Box& first, const Box& second, const Vector& direction) {
  const auto with = [&](Along way) {
    return [&, way] { return gaps_with_mistakes::gap_with(way, first, second, direction); };
  };
  ask("How large is the gap between the boxes along the line?")
      .given("first", first)
      .given("second", second)
      .given("direction", direction)
      .suspect("direction-not-normalised", with(Along::not_divided))
      .suspect("edges-for-half-lengths", with(Along::with_edges))
      .suspect("edges-for-half-lengths", with(Along::with_half_of_the_half))
      .suspect("rows-for-columns", with(Along::by_rows))
      .suspect("box-axes-ignored", with(Along::without_axes))
      .suspect("half-lengths-cancel", with(Along::without_magnitude))
      .suspect("centre-distance-not-projected", with(Along::by_distance_of_centres))
      .suspect("gap-on-one-side", with(Along::on_one_side))
      .suspect("one-box-twice", with(Along::with_the_first_twice))
      .suspect("overlap-called-zero", with(Along::not_below_zero))
      .suspect("gap-reversed", with(Along::reversed))
      .suspect("common-part-for-depth", with(Along::by_common_part))
      .answer([&] { return exercise::gap_along(first, second, direction); })
      .close_to(
          gaps_with_mistakes::gap_along(first, second, gaps_with_mistakes::exactly(direction)),
          within(kTolerance));
}

void check_largest(const Box& first, const Box& second) {
  const auto gaps = gaps_with_mistakes::all_gaps(first, second);
  const LargestGap right = gaps_with_mistakes::largest_of(gaps);
  const auto with = [&](const Search& search) {
    return [&, search] { return gaps_with_mistakes::search(first, second, search); };
  };
  const auto gap_of = [&](int axis) {
    return axis >= 0 && axis < 15 ? gaps[static_cast<std::size_t>(axis)]
                                  : -std::numeric_limits<double>::infinity();
  };
  ask("Which of the fifteen axes has the largest gap, and how large is it?")
      .given("first", first)
      .given("second", second)
      .suspect("edge-axes-left-out", with({.axes = 6}))
      .suspect("normals-of-one-box", with({.of_second = false}))
      .suspect("cross-product-not-unit", with({.cross_unit = false}))
      .suspect("edges-numbered-by-the-second", with({.by_second = true}))
      .suspect("first-separating-axis", with({.first_positive = true}))
      .suspect("gap-nearest-to-zero", with({.nearest_to_zero = true}))
      .suspect_if("largest-gap-from-zero",
                  [&](const LargestGap& got) {
                    return right.gap < 0 && std::abs(got.gap) < 1e-300 &&
                           !std::isnan(gap_of(got.axis));
                  })
      .suspect_if("parallel-edges-as-an-axis",
                  [&](const LargestGap& got) {
                    return std::isfinite(got.gap) && std::isnan(gap_of(got.axis));
                  })
      .suspect_if("later-of-equal-gaps",
                  [&](const LargestGap& got) {
                    return got.axis != right.axis && std::abs(got.gap - right.gap) <= kTolerance &&
                           std::abs(gap_of(got.axis) - right.gap) < gaps_with_mistakes::kEqual;
                  })
      .suspect_if("division-by-zero",
                  [&](const LargestGap& got) { return !std::isfinite(got.gap); })
      .answer([&] { return exercise::largest_gap(first, second); })
      .close_to(right, within(LargestGap{kTolerance, 0}));
}

const Axes kWorld = Axes::Identity();
const Axes kTurned = rotation(3, 0, 0, 1), kOblique = rotation(2, 1, -3, 1);

}  // namespace

TEST_CASE("a gap is measured along a line of any direction") {
  check_along({{1, 2, -3}, kOblique, {1, 2, 4}}, {{15, -4, 9}, rotation(1, 2, 2, -4), {3, 1, 5}},
              {3, -1, 5});
  check_along({{15, -4, 9}, rotation(1, 2, 2, -4), {3, 1, 5}}, {{1, 2, -3}, kOblique, {1, 2, 4}},
              {3, -1, 5});
  check_along({{0, 0, 0}, kWorld, {1, 2, 3}}, {{9, 0, 0}, kWorld, {4, 5, 6}}, {1, 0, 0});
  check_along({{0, 0, 0}, kWorld, {1, 2, 3}}, {{5, 0, 0}, kWorld, {4, 5, 6}}, {-7, 0, 0});
  check_along({{0, 0, 0}, kTurned, {1, 2, 3}}, {{0, 0, 19}, kOblique, {4, 5, 6}}, {0, 0, 2});
  check_along({{-1000, 1000, 3}, kTurned, {900, 2, 3}}, {{1000, 7, -9}, kOblique, {4, 1000, 6}},
              {1000, -999, 1});
}

TEST_CASE("boxes that overlap along a line have a negative gap") {
  check_along({{1, 2, -3}, kOblique, {4, 7, 9}}, {{5, -4, 2}, rotation(1, 2, 2, -4), {6, 8, 5}},
              {3, -1, 5});
  check_along({{0, 0, 0}, kWorld, {10, 20, 30}}, {{3, 0, 0}, kWorld, {1, 2, 3}}, {1, 0, 0});
  check_along({{3, 0, 0}, kWorld, {1, 2, 3}}, {{0, 0, 0}, kWorld, {10, 20, 30}}, {2, 0, 0});
  check_along({{1, 1, 1}, kOblique, {10, 20, 30}}, {{1, 1, 1}, kTurned, {1, 2, 3}}, {4, -2, 1});
  check_along({{1, 1, 1}, kTurned, {7, 2, 3}}, {{1, 1, 1}, kTurned, {7, 2, 3}}, {0, 0, 1});
}

TEST_CASE("a normal of a face may have the largest gap") {
  check_largest({{-3, -3, -1}, rotation(3, -3, 0, 1), {4, 1, 4}},
                {{12, -2, 11}, rotation(3, -3, 1, -2), {3, 1, 5}});
  check_largest({{-3, 0, -1}, rotation(2, -1, -3, -2), {5, 3, 2}},
                {{7, -6, -3}, rotation(1, -3, -2, -3), {5, 3, 4}});
  check_largest({{7, -6, -3}, rotation(1, -3, -2, -3), {5, 3, 4}},
                {{-3, 0, -1}, rotation(2, -1, -3, -2), {5, 3, 2}});
}

TEST_CASE("two edges may have the largest gap") {
  check_largest({{-3, 1, -2}, rotation(3, 2, -2, 3), {3, 1, 3}},
                {{4, -9, -9}, rotation(2, 2, 1, -1), {2, 1, 5}});
  check_largest({{0, 3, 2}, rotation(1, 3, -1, -2), {1, 4, 4}},
                {{-11, -7, 7}, rotation(2, 2, 2, 1), {4, 4, 1}});
  check_largest({{3, 3, 3}, rotation(2, -2, 1, -2), {1, 4, 3}},
                {{-11, 8, 4}, rotation(2, 0, -3, 2), {5, 3, 3}});
  check_largest({{2, -2, -3}, rotation(2, -1, 1, 2), {1, 3, 4}},
                {{5, 12, -3}, rotation(3, -2, -3, -2), {5, 4, 1}});
}

TEST_CASE("the gaps of boxes that overlap are negative, and the largest counts") {
  check_largest({{0, -2, -3}, rotation(3, -1, 0, 3), {4, 1, 5}},
                {{3, -1, -3}, rotation(2, 1, -1, -3), {3, 1, 4}});
  check_largest({{3, -3, -3}, rotation(1, -1, -3, 3), {3, 2, 3}},
                {{3, -1, -3}, rotation(3, 0, 3, -3), {2, 4, 3}});
  check_largest({{3, 2, -3}, rotation(1, -1, -2, -2), {5, 1, 5}},
                {{-3, 3, 1}, rotation(1, 2, -2, -3), {5, 3, 3}});
  check_largest({{-3, 0, 0}, rotation(2, -3, 2, -1), {2, 5, 4}},
                {{-4, 1, -1}, rotation(2, 1, -1, -1), {5, 3, 2}});
  check_largest({{1, 1, 1}, rotation(2, -3, 2, -1), {20, 50, 40}},
                {{1, 1, 1}, rotation(2, 1, -1, -1), {5, 3, 2}});
}

TEST_CASE("parallel edges give no axis") {
  check_largest({{0, 0, 0}, kWorld, {1, 2, 3}}, {{4, 1, -1}, kWorld, {4, 5, 6}});
  check_largest({{0, 0, 0}, kWorld, {1, 2, 3}}, {{-9, 1, 2}, kTurned, {4, 5, 6}});
  check_largest({{0, 0, 0}, kWorld, {1, 2, 3}}, {{2, 1, 2}, kTurned, {4, 5, 6}});
  check_largest({{3, -3, 2}, rotation(1, 0, -2, -1) * rotation(1, 0, -2, -2), {1, 4, 1}},
                {{-10, 4, -3}, rotation(-5, 2, -4, -3), {2, 4, 1}});
  check_largest({{-1, 0, -2}, rotation(1, -1, 3, 2) * rotation(2, -1, 2, 3), {1, 2, 1}},
                {{-1, -11, 0}, rotation(-11, 2, 9, 8), {1, 1, 2}});
  check_largest({{0, 3, 3}, rotation(1, -3, 1, 0) * rotation(3, 1, -3, -2), {4, 2, 5}},
                {{8, -7, -3}, rotation(9, -10, -6, 6), {1, 3, 1}});
}

TEST_CASE("of gaps that are equal but for rounding the first counts") {
  check_largest({{0, 0, 0}, kWorld, {1, 2, 3}}, {{12, 12, 12}, kWorld, {6, 5, 4}});
  check_largest({{1, 3, 3}, rotation(1, 1, 3, 2), {5, 3, 3}},
                {{7, -4, -10}, rotation(0, 2, 5, -1), {3, 3, 5}});
  check_largest({{-3, 2, 0}, rotation(3, 2, 0, 2), {5, 1, 1}},
                {{-1, 0, -2}, rotation(1, 2, -2, 5), {4, 4, 1}});
  check_largest({{0, -1, -3}, rotation(3, -1, -2, 2), {2, 2, 4}},
                {{10, 12, -12}, rotation(7, -5, -5, 9), {3, 5, 1}});
  // 2^-30 m is less than 1e-9 m, and twice as much is more.
  check_largest({{0, 0, 0}, kWorld, {1, 2, 3}}, {{9, 9 + 0x1p-30, 0}, kWorld, {6, 5, 4}});
  check_largest({{0, 0, 0}, kWorld, {1, 2, 3}}, {{9, 9 + 0x1p-29, 0}, kWorld, {6, 5, 4}});
}

TEST_CASE("random boxes agree with exact numbers") {
  generators::Random random(seed(0));
  const auto judged = [](const Box& first, const Box& second) {
    return gaps_with_mistakes::is_box(first) && gaps_with_mistakes::is_box(second) &&
           gaps_with_mistakes::is_clear(first, second);
  };
  const auto judged_line = [](const Box& first, const Box& second, const Vector& n) {
    return gaps_with_mistakes::is_box(first) && gaps_with_mistakes::is_box(second) &&
           n == n.array().round().matrix() && !n.isZero(0) && n.cwiseAbs().maxCoeff() <= 1000;
  };
  for (int asked = 0; asked < 60; ++asked) {
    const auto whole = [&](int limit) {
      const double x = random.integer(-limit, limit), y = random.integer(-limit, limit);
      return Vector(x, y, random.integer(-limit, limit));
    };
    const int most = asked % 3 == 0 ? 1 : 4, size = asked % 4 == 0 ? 500 : 6;
    const auto box = [&] {
      const int w = random.integer(1, most), x = random.integer(-most, most);
      const int y = random.integer(-most, most), z = random.integer(-most, most);
      const Vector centre = whole(size), half = whole(size).cwiseAbs();
      return Box{centre, rotation(w, x, y, z), half.cwiseMax(1)};
    };
    const Box first = box(), second = box();
    if (judged(first, second)) shrinkable(check_largest, judged, first, second);
    const Vector n = whole(asked % 2 == 0 ? 1000 : 5);
    if (judged_line(first, second, n)) shrinkable(check_along, judged_line, first, second, n);
  }
}
