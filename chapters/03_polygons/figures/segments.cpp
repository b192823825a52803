// Two segments: how and where they meet, by the book's method and by the textbook's, near the
// origin and far from it, in double and in float.
#include <algorithm>
#include <array>
#include <cmath>
#include <contact/figure.hpp>
#include <contact/segments.hpp>

using Point = contact::Vector2<double>;
using contact::Meeting;

struct Input {
  Point a, b;      // ends of the first segment
  Point c, d;      // ends of the second
  double far;      // the segments are moved by 2^far m before they are stored; 0: not moved
  double divided;  // 10: before that they are divided by 10, which makes eighths of a metre inexact
  double single;   // 1: points and methods in float
};

struct Output {
  double problem;
  // What is "moved back" is also multiplied by 10 again, for the drawing.
  std::array<Point, 4> stored;  // a, b, c, d as stored, moved back
  double moved;                 // m, along x; along y it is 0.6 of that
  double meeting;               // of the stored ones: 0 none, 1 crossing, 2 touching, 3 overlapping
  Point point;                  // the book's, moved back
  double along_first, along_second, along_bound;
  double point_bound;                // m
  Point overlap_start, overlap_end;  // moved back
  // By slopes, by parameters: whether they find a point, which one (moved back), and how far it is
  // from the exact one.
  std::array<double, 2> found;
  std::array<Point, 2> found_at;
  std::array<double, 2> off;    // m
  double off_book;              // the same of the book's point
  double by_parameters;         // its meeting
  double by_rounded;            // meeting by orientations as the scalar rounds them
  std::array<double, 3> wrong;  // 1 if slopes, parameters, rounded orientations are wrong
  // Of the ends as given in double, for a reader's function that takes whole numbers: eighths.
  double meeting_as_given;
  double whole;     // 1 if the eighths are whole
  double vertical;  // goal of a question: they cross, and the slopes miss it
};

namespace {

template <class S>
void compute_in(const Input& in, const Point& moved, Output& out) {
  const double divided = in.divided == 10 ? 10 : 1;
  const auto back = [&](const contact::Vector2<S>& p) -> Point {
    return divided * (p.template cast<double>() - moved);
  };
  const auto store = [&](const Point& p) -> contact::Vector2<S> {
    return (p / divided + moved).cast<S>();
  };
  const contact::Segment2<S> first{store(in.a), store(in.b)}, second{store(in.c), store(in.d)};
  out.stored = {back(first.a), back(first.b), back(second.a), back(second.b)};

  const auto found = contact::crossing(first, second);
  const auto exact = contact::crossing_to_last_place(first, second);
  const bool meets = found.meeting != Meeting::none;
  const auto number = [](Meeting meeting) { return double(static_cast<int>(meeting)); };
  out.meeting = number(found.meeting);
  if (meets) {
    out.point = back(found.point);
    out.along_first = double(found.along_first);
    out.along_second = double(found.along_second);
    out.along_bound = double(found.along_bound);
    out.point_bound = double(found.point_bound);
    out.overlap_start = back(found.overlap.a);
    out.overlap_end = back(found.overlap.b);
  }
  const auto off = [&exact](const contact::Vector2<S>& p) {
    return (p.template cast<double>() - exact.point.template cast<double>()).cwiseAbs().maxCoeff();
  };
  if (meets) out.off_book = off(found.point);

  const auto by_slopes = contact::crossing_by_slopes(first, second);
  const auto by_parameters = contact::crossing_by_parameters(first, second);
  const auto keep = [&](std::size_t method, const contact::Vector2<S>& p) {
    out.found[method] = 1;
    out.found_at[method] = back(p);
    if (meets) out.off[method] = off(p);
  };
  if (by_slopes) keep(0, *by_slopes);
  if (by_parameters) keep(1, by_parameters->point);
  out.by_parameters = by_parameters ? number(by_parameters->meeting) : 0;
  out.by_rounded = number(contact::meet_rounded(first, second));
  out.wrong = {by_slopes.has_value() != meets || found.meeting == Meeting::overlapping ? 1.0 : 0.0,
               out.by_parameters != out.meeting ? 1.0 : 0.0,
               out.by_rounded != out.meeting ? 1.0 : 0.0};
  out.vertical = found.meeting == Meeting::crossing && !by_slopes ? 1 : 0;

  const auto whole = [](const Point& p) {
    return (8 * p).eval() == (8 * p).array().round().matrix();
  };
  out.meeting_as_given = number(contact::meet(contact::Segment2<double>{in.a, in.b}, {in.c, in.d}));
  out.whole = whole(in.a) && whole(in.b) && whole(in.c) && whole(in.d) ? 1 : 0;
}

}  // namespace

Output compute(const Input& in) {
  Output out{};
  for (const auto* v : {&in.a, &in.b, &in.c, &in.d}) {
    if (v->cwiseAbs().maxCoeff() > (in.single == 1 ? 1e15 : 1e100))
      out.problem = contact::figure::too_large;
  }
  if (out.problem != 0) return out;
  const int power = static_cast<int>(std::clamp(in.far, 0.0, in.single == 1 ? 21.0 : 50.0));
  if (power > 0) out.moved = std::ldexp(1.0, power);
  const Point moved(out.moved, 0.6 * out.moved);
  in.single == 1 ? compute_in<float>(in, moved, out) : compute_in<double>(in, moved, out);
  return out;
}

FIGURE(Input, FIELDS(a, b, c, d, far, divided, single), Output,
       FIELDS(problem, stored, moved, meeting, point, along_first, along_second, along_bound,
              point_bound, overlap_start, overlap_end, found, found_at, off, off_book,
              by_parameters, by_rounded, wrong, meeting_as_given, whole, vertical))
