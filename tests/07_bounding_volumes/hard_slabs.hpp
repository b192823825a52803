/// @file
/// The hard cases of slabs: whether those of two bodies overlap, and whether a point is between
/// each pair of planes.
#pragma once

#include <07_bounding_volumes/carried_truth.hpp>
#include <07_bounding_volumes/hard_common.hpp>
#include <algorithm>
#include <cmath>
#include <concepts>
#include <contact/aabb.hpp>
#include <contact/slab_volumes.hpp>
#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <support/hard_cases.hpp>
#include <support/oracle.hpp>
#include <vector>

namespace hard_slabs {

using contact::Kdop;
using contact::Vector3;
using hard_cases::Case;
using hard_cases::Json;
using hard_common::applies;
using hard_common::Points;
using hard_common::points_of;
using oracle::Rational;

// ---------------------------------------------------------------- methods as they are often
// written

/// What a method does with the two intervals along one normal.
enum class Compare { closed, open, within };

template <std::floating_point S>
bool intervals_overlap(const Points<S>& a, const Points<S>& b, const Vector3<S>& n,
                       Compare compare) {
  S low_a = n.dot(a.front()), high_a = low_a, low_b = n.dot(b.front()), high_b = low_b;
  for (const Vector3<S>& p : a) {
    low_a = std::min(low_a, n.dot(p));
    high_a = std::max(high_a, n.dot(p));
  }
  for (const Vector3<S>& p : b) {
    low_b = std::min(low_b, n.dot(p));
    high_b = std::max(high_b, n.dot(p));
  }
  if (compare == Compare::open) return low_a < high_b && low_b < high_a;
  const S room = compare == Compare::within ? S(1e-6) : S(0);
  return low_a <= high_b + room && low_b <= high_a + room;
}
template <std::floating_point S>
bool slabs_overlap(const Case& c, Compare compare, bool unit) {
  for (Vector3<S> n : points_of<S>(c, "normals")) {
    if (unit) n /= std::sqrt(n.dot(n));
    if (!intervals_overlap(points_of<S>(c, "first"), points_of<S>(c, "second"), n, compare)) {
      return false;
    }
  }
  return true;
}
/// Along the three axes, whatever the normals are.
inline bool boxes_overlap(const Case& c) {
  const auto box = [&c](const char* field) {
    const Points<double> points = points_of<double>(c, field);
    return contact::aabb_of_points(hard_common::span_of<double>(points));
  };
  return contact::boxes_touch(box("first"), box("second"));
}

template <std::floating_point S>
Kdop<S> dop_of(const Case& c, const char* points) {
  const Points<S> all = points_of<S>(c, points);
  return contact::kdop_of_points<S>(points_of<S>(c, "normals"), hard_common::span_of<S>(all));
}
template <std::floating_point S>
Kdop<S> stored_dop(const Case& c) {
  Kdop<S> dop{points_of<S>(c, "normals"), {}, {}};
  for (const double x : c.numbers("low")) dop.low.push_back(S(x));
  for (const double x : c.numbers("high")) dop.high.push_back(S(x));
  return dop;
}
template <std::floating_point S>
bool between_rounded(const Case& c, S room) {
  const Kdop<S> dop = stored_dop<S>(c);
  const Vector3<S> p = generators::rounded<S>(c.vector("point"));
  for (std::size_t k = 0; k < dop.normals.size(); ++k) {
    const S at = dop.normals[k].dot(p);
    if (at < dop.low[k] - room || dop.high[k] + room < at) return false;
  }
  return true;
}

// ---------------------------------------------------------------- questions

template <std::floating_point S, class Decide>
void add_method(hard_cases::Runner& runner, const std::string& question, const std::string& name,
                const Decide& decide) {
  runner.method(question, name, applies<S>, [question, decide](const Case& c, const Json& answer) {
    return decide(c) == answer.at(question == "slabs_overlap" ? "overlap" : "inside").get<bool>();
  });
}

/// Whether the exact slabs of two bodies overlap.
inline Json overlap_exactly(const Case& c) {
  bool overlap = true;
  for (const Vector3<double>& normal : points_of<double>(c, "normals")) {
    const auto range = [&](const char* field) {
      std::vector<Rational> at;
      for (const auto& p : points_of<double>(c, field)) {
        at.push_back(oracle::exact(normal).dot(oracle::exact(p)));
      }
      const auto [low, high] = std::minmax_element(at.begin(), at.end());
      return oracle::Enclosure{*low, *high};
    };
    const auto a = range("first"), b = range("second");
    overlap = overlap && a.low <= b.high && b.low <= a.high;
  }
  return {{"class", "a"}, {"overlap", overlap}};
}

/// Adds them to a runner.
inline void add_questions(hard_cases::Runner& runner) {
  runner.question("slabs_overlap", overlap_exactly);
  const auto overlap = [&runner]<std::floating_point S>(S, const std::string& name, Compare compare,
                                                        bool unit) {
    add_method<S>(runner, "slabs_overlap", name,
                  [=](const Case& c) { return slabs_overlap<S>(c, compare, unit); });
  };
  overlap(float(), "rounded to nearest, float", Compare::closed, false);
  overlap(double(), "rounded to nearest, double", Compare::closed, false);
  overlap(double(), "touching rejected, double", Compare::open, false);
  overlap(double(), "within 1e-6, double", Compare::within, false);
  overlap(double(), "unit normals, double", Compare::closed, true);
  add_method<double>(runner, "slabs_overlap", "boxes alone", boxes_overlap);
  add_method<double>(runner, "slabs_overlap", "the book, exact", [](const Case& c) {
    return contact::may_meet(dop_of<double>(c, "first"), dop_of<double>(c, "second"));
  });

  runner.question("between_planes", [](const Case& c) -> Json {
    const bool inside =
        carried_truth::inside(stored_dop<double>(c), oracle::exact(c.vector("point")));
    return {{"class", "a"}, {"inside", inside}};
  });
  add_method<float>(runner, "between_planes", "rounded, float",
                    [](const Case& c) { return between_rounded<float>(c, 0); });
  add_method<double>(runner, "between_planes", "rounded, double",
                     [](const Case& c) { return between_rounded<double>(c, 0); });
  add_method<double>(runner, "between_planes", "within 1e-9, double",
                     [](const Case& c) { return between_rounded<double>(c, 1e-9); });
  runner.method("between_planes", "the book, exact", [](const Case& c, const Json& answer) {
    const bool inside = answer.at("inside").get<bool>();
    return contact::contains(stored_dop<double>(c), c.vector("point")) == inside &&
           (c.type() == "double" ||
            contact::contains(stored_dop<float>(c),
                              generators::rounded<float>(c.vector("point"))) == inside);
  });
}

}  // namespace hard_slabs
