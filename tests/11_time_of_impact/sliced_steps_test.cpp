// Whether and how deeply bodies overlap is decided by exact numbers: for the discs, the distance of
// the origin from the segment of the centre is compared as a quotient of polynomials of the input.
#include "sliced_steps.hpp"
#include "slices_as_tested.hpp"

#include <support/break_it.hpp>

#include <contact/exact.hpp>

namespace {

using namespace contact::testing;
using contact::Exact;
using exercise::Shot;

constexpr int kFew = 3, kMany = 100;

// ---------------------------------------------------------------- the bullet

/// Whether the disc is on one side of the plate at the start, on the other at the end, and touches
/// it at neither.
bool gets_through(const Shot& shot) {
  const Exact start(shot.start.x()), end = start + Exact(shot.displacement.x());
  const Exact radius(shot.radius), beyond = Exact(shot.size) + radius;
  const auto before = [&](const Exact& x) { return (x + radius).sign() < 0; };
  const auto behind = [&](const Exact& x) { return (x - beyond).sign() > 0; };
  return (before(start) && behind(end)) || (behind(start) && before(end));
}

/// The lengths, in m and along x, on which the disc moves in a slice and touches the plate.
double slice(const Shot& shot) { return std::abs(shot.displacement.x()) / kFew; }
double touching(const Shot& shot) { return shot.size + 2 * shot.radius; }

// ---------------------------------------------------------------- the discs

/// Whether the centres come within a distance of each other during the step.
bool come_within(const Shot& shot, const Exact& distance) {
  const auto dot = [](const Eigen::Vector2d& u, const Eigen::Vector2d& v) {
    return Exact(u.x()) * Exact(v.x()) + Exact(u.y()) * Exact(v.y());
  };
  const Exact at_start = dot(shot.start, shot.start), move = dot(shot.start, shot.displacement);
  const Exact square = dot(shot.displacement, shot.displacement);
  const Exact limit = distance * distance;
  const Exact at_end = at_start + move + move + square;
  if ((at_start - limit).sign() <= 0 || (at_end - limit).sign() <= 0) return true;
  // The nearest point is within the step: at t = -move / square.
  if (move.sign() >= 0 || (move + square).sign() <= 0) return false;
  return ((at_start - limit) * square - move * move).sign() <= 0;
}

bool touch(const Shot& shot) { return come_within(shot, (Exact(shot.radius) + Exact(shot.size))); }
bool overlap_by_a_millimetre(const Shot& shot) {
  return come_within(shot, (Exact(shot.radius) + Exact(shot.size)) - Exact(0.001));
}

/// The closest distance of the centres, to within rounding.
double closest(const Shot& shot) {
  const double square = shot.displacement.squaredNorm();
  const double t =
      square > 0 ? std::clamp(-shot.start.dot(shot.displacement) / square, 0.0, 1.0) : 0;
  return (shot.start + t * shot.displacement).norm();
}

/// Whether the discs touch during a hundredth of the step or longer, to within rounding. What the
/// path would touch before the step or after it does not count.
bool chord_is_long(const Shot& shot) {
  const double radius_sum = shot.radius + shot.size, length = shot.displacement.norm();
  if (length == 0) return touch(shot);
  const Eigen::Vector2d along = shot.displacement / length;
  const double nearest = -shot.start.dot(along), d = (shot.start + nearest * along).norm();
  if (d > radius_sum) return false;
  const double half = std::sqrt((radius_sum - d) * (radius_sum + d));
  const double begin = std::max(nearest - half, 0.0), end = std::min(nearest + half, length);
  return end - begin >= length / kMany;
}

bool found(const Shot& shot, int slices) { return given::meets_disc(shot, slices).has_value(); }

std::string told(const std::optional<double>& t) {
  return t ? "they touch at " + contact::text_of(*t) : "they do not touch";
}

std::string told(const Shot& shot) {
  return "with 3 slices " + told(given::meets_disc(shot, kFew)) + ", with 100 " +
         told(given::meets_disc(shot, kMany));
}

BreakIt<Shot> discs(std::string_view question) {
  return break_it<Shot>(question)
      .rule("every number is finite", [](const Shot& shot) { return all_finite(shot); })
      .rule("each radius is from 0.05 to 0.5 m",
            [](const Shot& shot) {
              return std::min(shot.radius, shot.size) >= 0.05 &&
                     std::max(shot.radius, shot.size) <= 0.5;
            })
      .rule("the displacement is at most 10 m long",
            [](const Shot& shot) { return shot.displacement.norm() <= 10; })
      .rule("the start is at most 100 m from the origin",
            [](const Shot& shot) { return shot.start.norm() <= 100; });
}

}  // namespace

TEST_CASE("a bullet gets through a plate between two tests") {
  break_it<Shot>("Which bullet flies through the plate unseen?")
      .rule("no number is beyond 10 m", [](const Shot& shot) { return all_within(shot, 10); })
      .rule("the radius is at least 0.01 m", [](const Shot& shot) { return shot.radius >= 0.01; })
      .rule("the plate is at least 0.1 m thick", [](const Shot& shot) { return shot.size >= 0.1; })
      .suspect_if("break-bullet-does-not-get-through",
                  [](const Shot& shot) { return !gets_through(shot); })
      .suspect_if("break-slice-is-short",
                  [](const Shot& shot) { return slice(shot) <= touching(shot); })
      .suspect_if("break-test-in-the-plate", [](const Shot&) { return true; })
      .input("shot", [] { return exercise::through_the_plate(); })
      .judge([](const Shot& shot) {
        const auto t = given::meets_plate(shot, kFew);
        const bool through = gets_through(shot);
        return Judged{through && !t, told(t),
                      through ? "they touch" : "the bullet does not get to the other side",
                      "Along x the bullet moves by " +
                          contact::text_of(slice(shot), {.digits = 3}) +
                          " m in a slice, and it touches the plate over " +
                          contact::text_of(touching(shot), {.digits = 3}) + " m."};
      });
}

TEST_CASE("a graze is missed by few slices and by many") {
  discs("Which discs overlap unseen by 3 slices and by 100?")
      .suspect_if("break-discs-do-not-touch", [](const Shot& shot) { return !touch(shot); })
      .suspect_if("break-discs-graze-too-lightly",
                  [](const Shot& shot) { return !overlap_by_a_millimetre(shot); })
      .suspect_if("break-found-by-three-slices",
                  [](const Shot& shot) { return found(shot, kFew) && !found(shot, kMany); })
      .suspect_if("break-chord-is-long", chord_is_long)
      .suspect_if("break-found-by-a-hundred-slices",
                  [](const Shot& shot) { return found(shot, kMany); })
      .input("shot", [] { return exercise::graze_missed_again(); })
      .judge([](const Shot& shot) {
        const bool overlap = overlap_by_a_millimetre(shot);
        return Judged{overlap && !found(shot, kFew) && !found(shot, kMany), told(shot),
                      overlap ? "they overlap by 1 mm or more" : "they do not overlap by 1 mm",
                      "The centres come as near as " +
                          contact::text_of(closest(shot), {.digits = 4}) + " m."};
      });
}

TEST_CASE("many slices lose what few have found") {
  discs("Which discs do 3 slices find and 100 miss?")
      .suspect_if("break-discs-do-not-touch", [](const Shot& shot) { return !touch(shot); })
      .suspect_if("break-discs-graze-too-lightly",
                  [](const Shot& shot) { return !overlap_by_a_millimetre(shot); })
      .suspect_if("break-missed-by-three-slices",
                  [](const Shot& shot) { return !found(shot, kFew); })
      .suspect_if("break-chord-is-long", chord_is_long)
      .suspect_if("break-found-by-a-hundred-slices",
                  [](const Shot& shot) { return found(shot, kMany); })
      .input("shot", [] { return exercise::lost_by_finer_slices(); })
      .judge([](const Shot& shot) {
        const bool overlap = overlap_by_a_millimetre(shot);
        return Judged{overlap && found(shot, kFew) && !found(shot, kMany), told(shot),
                      overlap ? "they overlap by 1 mm or more" : "they do not overlap by 1 mm",
                      "The centres come as near as " +
                          contact::text_of(closest(shot), {.digits = 4}) + " m."};
      });
}
