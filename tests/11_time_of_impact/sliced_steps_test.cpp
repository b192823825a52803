// Whether and how deeply bodies overlap is decided by exact numbers: for the discs, the distance of
// the origin from the segment of the centre is compared as a quotient of polynomials of the input.
#include "sliced_steps.hpp"
#include "slices_as_tested.hpp"

#include <support/break_it.hpp>

#include <contact/exact.hpp>

namespace {

using namespace contact::testing;
using contact::Exact;
using exercise::Pass;
using exercise::Shot;

constexpr int kFew = 3, kMany = 100;

// ---------------------------------------------------------------- the bullet

bool starts_before(const Shot& shot) {
  return (Exact(shot.plate) - Exact(shot.start) - Exact(shot.radius)).sign() > 0;
}

bool ends_behind(const Shot& shot) {
  const Exact end = Exact(shot.start) + Exact(shot.displacement) - Exact(shot.radius);
  return (end - Exact(shot.plate) - Exact(shot.thickness)).sign() > 0;
}

bool gets_through(const Shot& shot) {
  Shot mirrored = shot;  // the other side first
  mirrored.start = -shot.start;
  mirrored.displacement = -shot.displacement;
  mirrored.plate = -(shot.plate + shot.thickness);
  return (starts_before(shot) && ends_behind(shot)) ||
         (starts_before(mirrored) && ends_behind(mirrored));
}

bool slice_is_short(const Shot& shot) {
  return std::abs(shot.displacement) / kFew <= shot.thickness + 2 * shot.radius;
}

// ---------------------------------------------------------------- the discs

/// Whether the centres come within a distance of each other during the step.
bool come_within(const Pass& pass, const Exact& distance) {
  const auto dot = [](const Eigen::Vector2d& u, const Eigen::Vector2d& v) {
    return Exact(u.x()) * Exact(v.x()) + Exact(u.y()) * Exact(v.y());
  };
  const Exact at_start = dot(pass.start, pass.start), move = dot(pass.start, pass.displacement);
  const Exact square = dot(pass.displacement, pass.displacement);
  const Exact limit = distance * distance;
  const Exact at_end = at_start + move + move + square;
  if ((at_start - limit).sign() <= 0 || (at_end - limit).sign() <= 0) return true;
  // The nearest point is within the step: at t = -move / square.
  if (move.sign() >= 0 || (move + square).sign() <= 0) return false;
  return ((at_start - limit) * square - move * move).sign() <= 0;
}

bool touch(const Pass& pass) { return come_within(pass, Exact(pass.radii)); }
bool overlap_by_a_millimetre(const Pass& pass) {
  return come_within(pass, Exact(pass.radii) - Exact(0.001));
}

/// The closest distance of the centres, to within rounding.
double closest(const Pass& pass) {
  const double square = pass.displacement.squaredNorm();
  const double t =
      square > 0 ? std::clamp(-pass.start.dot(pass.displacement) / square, 0.0, 1.0) : 0;
  return (pass.start + t * pass.displacement).norm();
}

bool chord_is_long(const Pass& pass) {
  const double d = std::min(closest(pass), pass.radii);
  const double half = std::sqrt((pass.radii - d) * (pass.radii + d));
  return 2 * half >= pass.displacement.norm() / kMany;
}

bool found(const Pass& pass, int slices) {
  return given::disc_meets_disc(pass, slices).has_value();
}

std::string told(const std::optional<double>& t) {
  return t ? "they touch at " + contact::text_of(*t) : "they do not touch";
}

std::string told(const Pass& pass) {
  return "with 3 slices " + told(given::disc_meets_disc(pass, kFew)) + ", with 100 " +
         told(given::disc_meets_disc(pass, kMany));
}

BreakIt<Pass> discs(std::string_view question) {
  return break_it<Pass>(question)
      .rule("every number is finite", [](const Pass& pass) { return all_finite(pass); })
      .rule("the sum of the radii is from 0.1 to 1 m",
            [](const Pass& pass) { return pass.radii >= 0.1 && pass.radii <= 1; })
      .rule("the displacement is at most 10 m long", [](const Pass& pass) {
        return pass.displacement.norm() <= 10 && pass.start.norm() <= 100;
      });
}

}  // namespace

TEST_CASE("a bullet gets through a plate between two tests") {
  break_it<Shot>("Which bullet flies through the plate unseen?")
      .rule("no number is beyond 10 m", [](const Shot& shot) { return all_within(shot, 10); })
      .rule("the radius is at least 0.01 m", [](const Shot& shot) { return shot.radius >= 0.01; })
      .rule("the plate is at least 0.1 m thick",
            [](const Shot& shot) { return shot.thickness >= 0.1; })
      .suspect_if("break-bullet-does-not-get-through",
                  [](const Shot& shot) { return !gets_through(shot); })
      .suspect_if("break-slice-is-short", slice_is_short)
      .suspect_if("break-test-in-the-plate", [](const Shot&) { return true; })
      .input("shot", [] { return exercise::through_the_plate(); })
      .judge([](const Shot& shot) {
        const auto t = given::bullet_meets_plate(shot, kFew);
        const bool through = gets_through(shot);
        return Judged{through && !t, told(t),
                      through ? "they touch" : "the bullet does not get to the other side",
                      "In a slice the bullet moves by " +
                          contact::text_of(std::abs(shot.displacement) / kFew, {.digits = 3}) +
                          " m, and it touches the plate along " +
                          contact::text_of(shot.thickness + 2 * shot.radius, {.digits = 3}) +
                          " m."};
      });
}

TEST_CASE("a graze is missed by few slices and by many") {
  discs("Which discs overlap unseen by 3 slices and by 100?")
      .suspect_if("break-discs-do-not-touch", [](const Pass& pass) { return !touch(pass); })
      .suspect_if("break-discs-graze-too-lightly",
                  [](const Pass& pass) { return !overlap_by_a_millimetre(pass); })
      .suspect_if("break-found-by-three-slices",
                  [](const Pass& pass) { return found(pass, kFew) && !found(pass, kMany); })
      .suspect_if("break-chord-is-long", chord_is_long)
      .suspect_if("break-found-by-a-hundred-slices",
                  [](const Pass& pass) { return found(pass, kMany); })
      .input("pass", [] { return exercise::graze_missed_again(); })
      .judge([](const Pass& pass) {
        const bool overlap = overlap_by_a_millimetre(pass);
        return Judged{overlap && !found(pass, kFew) && !found(pass, kMany), told(pass),
                      overlap ? "they overlap by 1 mm or more" : "they do not overlap by 1 mm",
                      "The centres come as near as " +
                          contact::text_of(closest(pass), {.digits = 4}) + " m."};
      });
}

TEST_CASE("many slices lose what few have found") {
  discs("Which discs do 3 slices find and 100 miss?")
      .suspect_if("break-discs-do-not-touch", [](const Pass& pass) { return !touch(pass); })
      .suspect_if("break-discs-graze-too-lightly",
                  [](const Pass& pass) { return !overlap_by_a_millimetre(pass); })
      .suspect_if("break-missed-by-three-slices",
                  [](const Pass& pass) { return !found(pass, kFew); })
      .suspect_if("break-chord-is-long", chord_is_long)
      .suspect_if("break-found-by-a-hundred-slices",
                  [](const Pass& pass) { return found(pass, kMany); })
      .input("pass", [] { return exercise::lost_by_finer_slices(); })
      .judge([](const Pass& pass) {
        const bool overlap = overlap_by_a_millimetre(pass);
        return Judged{overlap && found(pass, kFew) && !found(pass, kMany), told(pass),
                      overlap ? "they overlap by 1 mm or more" : "they do not overlap by 1 mm",
                      "The centres come as near as " +
                          contact::text_of(closest(pass), {.digits = 4}) + " m."};
      });
}
