// The times follow from the contract, each from the one before. Rounding moves a time by far less
// than what is allowed, and no distance that is asked for is within rounding of the tolerance.
// Every test expects at least two different answers.
#include "advance_safely.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>
#include <support/shrinkable.hpp>

#include <11_time_of_impact/advance_with_mistakes.hpp>

namespace {

using namespace contact::testing;
using advance_with_mistakes::Ways;
using exercise::Advance;
using exercise::Disc;
using exercise::Rod;

void check_distance(const Rod& rod, const Disc& disc, double t) {
  const auto with = [&](const Ways& ways) {
    return [&, ways] { return advance_with_mistakes::distance_at(rod, disc, t, ways); };
  };
  ask("How far is the rod from the disc?")
      .given("rod", rod)
      .given("disc", disc)
      .given("t", t)
      .suspect("rod-beyond-its-ends", with({.line = true}))
      .suspect("ends-of-the-rod-alone", with({.ends_alone = true}))
      .suspect("centre-of-the-rod-alone", with({.centre_alone = true}))
      .suspect("disc-as-its-centre", with({.no_radius = true}))
      .suspect("rod-not-turned", with({.not_turned = true}))
      .suspect("rod-turned-clockwise", with({.clockwise = true}))
      .suspect("rod-turned-by-degrees", with({.degrees = true}))
      .suspect("rod-not-moved", with({.not_moved = true}))
      .answer([&] { return exercise::distance_at(rod, disc, t); })
      .close_to(with({})(), within(1e-12));
}

void check_bound(const Rod& rod) {
  const auto with = [&](const Ways& ways) {
    return [&, ways] { return advance_with_mistakes::speed_bound(rod, ways); };
  };
  ask("Which speed does no point of the rod exceed?")
      .given("rod", rod)
      .suspect("bound-without-rotation", with({.no_rotation = true}))
      .suspect("bound-of-the-rotation-alone", with({.rotation_alone = true}))
      .suspect("angular-velocity-with-its-sign", with({.signed_rotation = true}))
      .suspect("length-for-half-length", with({.whole_length = true}))
      .suspect("speeds-as-if-perpendicular", with({.pythagoras = true}))
      .suspect("square-of-the-speed", with({.squared = true}))
      .answer([&] { return exercise::speed_bound(rod); })
      .close_to(with({})(), within(1e-12));
}

bool are_equal_steps(const std::vector<double>& times) {
  if (times.size() < 4) return false;
  const double step = times[1] - times[0];
  for (std::size_t i = 1; i + 1 < times.size(); ++i)
    if (std::abs(times[i + 1] - times[i] - step) > 1e-9) return false;
  return step > 0;
}

void check(const Rod& rod, const Disc& disc, double duration, double tolerance) {
  const auto with = [&](const Ways& ways) {
    return [&, ways] {
      return advance_with_mistakes::advance_safely(rod, disc, duration, tolerance, ways);
    };
  };
  ask("To which times does the rod advance, and does it touch?")
      .given("rod", rod)
      .given("disc", disc)
      .given("duration", duration)
      .given("tolerance", tolerance)
      .suspect("end-counts-as-a-contact", with({.end_touches = true}))
      .suspect("advance-past-the-end", with({.past_the_end = true}))
      .suspect("tolerance-left-over", with({.keeps_tolerance = true}))
      .suspect("steps-for-times", with({.times_of_steps = true}))
      .suspect_if("sampled-in-equal-steps",
                  [](const Advance& got) { return are_equal_steps(got.times); })
      .answer([&] { return exercise::advance_safely(rod, disc, duration, tolerance); })
      .close_to(with({})(), within(1e-9));
}

/// Whether rounding decides nothing: no distance is close to the tolerance, and no advance ends
/// close to the duration.
bool is_clear(const Rod& rod, const Disc& disc, double duration, double tolerance) {
  if (!(rod.half_length >= 0.1 && rod.half_length <= 10 && rod.centre.norm() <= 20)) return false;
  if (!(std::abs(rod.angle) <= 10 && rod.velocity.norm() <= 20)) return false;
  if (!(std::abs(rod.angular_velocity) <= 10 && disc.centre.norm() <= 20)) return false;
  if (!(disc.radius >= 0 && disc.radius <= 10 && duration > 0.01 && duration <= 10)) return false;
  if (!(tolerance >= 1e-4 && tolerance <= 1)) return false;
  const double bound = advance_with_mistakes::speed_bound(rod, {});
  if (bound < 0.1) return false;
  const Advance right = advance_with_mistakes::advance_safely(rod, disc, duration, tolerance, {});
  if (right.times.size() > 60) return false;
  return std::all_of(right.times.begin(), right.times.end(), [&](double t) {
    const double distance = advance_with_mistakes::distance_at(rod, disc, t, {});
    return std::abs(distance - tolerance) > 1e-7 &&
           std::abs(t + distance / bound - duration) > 1e-7;
  });
}

const Rod kRod{{-6, 0.5}, 2, 0.5, {3, 0.25}, 0.8};
const Disc kDisc{{3, 1}, 0.75};

}  // namespace

TEST_CASE("the distance is that of the rod as it is at the time") {
  check_distance(kRod, kDisc, 1);
  check_distance(kRod, {{-3, 5}, 0.75}, 1);
  check_distance(kRod, {{-3, 0.75}, 0.75}, 1);
  check_distance({{1, 2}, 3, 1.25, {0, 0}, -2}, {{2, -4}, 1}, 0.75);
  check_distance({{1, 2}, 3, 0, {0, 0}, 0}, {{0, 4}, 0}, 0);
}

TEST_CASE("the bound is the speed of the centre and that of an end about it") {
  check_bound({{0, 0}, 1.5, 0.25, {6, 2}, 2});
  check_bound({{7, -3}, 1.5, 0.25, {6, 2}, -2});
  check_bound({{0, 0}, 2, 0.25, {0, 0}, -3});
  check_bound({{0, 0}, 2, 0.25, {-0.25, 0}, 0});
  check_bound({{0, 0}, 2, 0.25, {0, 0}, 0});
}

TEST_CASE("a rod advances to the disc until it is near enough") {
  check(kRod, kDisc, 4, 0.01);
  check(kRod, kDisc, 4, 0.5);
  check({{0, 4}, 3, 0, {0, 0}, 1.5}, {{0, 1.5}, 0.25}, 2, 0.001);
  check({{-5, 0}, 1, 0, {4, 0}, 0}, {{3, 0}, 1}, 3, 0.25);
  check({{-5, 0}, 1, 0, {4, 0}, 3}, {{3, 0}, 1}, 3, 0.01);
}

TEST_CASE("a rod that stays clear advances to the end") {
  check(kRod, {{3, 9}, 0.75}, 4, 0.01);
  check(kRod, kDisc, 1, 0.01);
  check({{0, 4}, 3, 0, {0, 0}, 1.5}, {{0, -1.5}, 0.25}, 2, 0.001);
  check({{0, 4}, 3, 0, {0, 0}, 0}, {{0, 1.5}, 0.25}, 2, 0.001);
  check({{0, 4}, 3, 0, {2, 0}, 1}, {{0, 0}, 0.25}, 0, 0.001);
  check(kRod, kDisc, 4, 0.01);
}

TEST_CASE("a rod that is near enough at the start touches at 0") {
  check({{0, 4}, 3, 0, {2, 0}, 1}, {{1, 3.5}, 0.25}, 2, 0.5);
  check({{0, 4}, 3, 0, {2, 0}, 1}, {{1, 3.5}, 1}, 2, 0.5);
  check({{0, 4}, 3, 0, {0, 0}, 0}, {{1, 3.5}, 1}, 0, 0.5);
  check({{0, 4}, 3, 0, {2, 0}, 1}, {{1, 3.5}, 0.25}, 2, 0.25);
  check({{0, 4}, 3, 0, {2, 0}, 1}, {{1, 3.5}, 0.25}, 2, 0.125);
}

TEST_CASE("random rods agree") {
  generators::Random random(seed(0));
  for (int asked = 0; asked < 200;) {
    const double x = random.uniform(-8, 8), y = random.uniform(-8, 8);
    const double half_length = random.uniform(0.5, 4), angle = random.uniform(-3, 3);
    const double v = random.uniform(-5, 5), w = random.uniform(-5, 5);
    const Rod rod{{x, y}, half_length, angle, {v, w}, random.uniform(-4, 4)};
    const double to_x = random.uniform(-8, 8), to_y = random.uniform(-8, 8);
    const Disc disc{{to_x, to_y}, random.uniform(0, 2)};
    const double duration = random.uniform(0.5, 4), tolerance = random.uniform(0.001, 0.1);
    if (!is_clear(rod, disc, duration, tolerance)) continue;
    ++asked;
    check_distance(rod, disc, duration);
    check_bound(rod);
    shrinkable(check, is_clear, rod, disc, duration, tolerance);
  }
}
