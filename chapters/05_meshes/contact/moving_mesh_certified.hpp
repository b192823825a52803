/// @file
/// A moving point against a moving mesh with an answer that is proved: hit, free, or undecided.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include <contact/convex_part.hpp>
#include <contact/enclosed_path.hpp>
#include <contact/exact.hpp>
#include <contact/locate_in_mesh.hpp>
#include <contact/mesh.hpp>
#include <contact/mesh_edges.hpp>
#include <contact/moving_mesh.hpp>
#include <contact/running_error.hpp>
#include <contact/vector.hpp>

namespace contact {

namespace detail {

// [separating-direction]
/// Whether a direction proves that a segment and a triangle are further apart than `margin`: along
/// it, each vertex of the triangle is further than each end of the segment by more than margin
/// times its length.
inline bool proves_apart(const Vector3<double>& direction, const Segment<double>& segment,
                         const Triangle<double>& triangle, double margin) {
  const Triple<RunningError> n = triple<RunningError>(direction);
  const RunningError wanted(RunningError::up(margin * length_at_most(n)));
  for (const Vector3<double>& p : {segment.start, segment.end}) {
    for (const Vector3<double>& v : {triangle.a, triangle.b, triangle.c}) {
      const RunningError apart =
          dot(n, minus(triple<RunningError>(v), triple<RunningError>(p))) - wanted;
      if (apart.certain_sign() <= 0) return false;
    }
  }
  return true;
}
// [/separating-direction]

/// The point of a segment next to p, rounded.
inline Vector3<double> next_on_segment(const Vector3<double>& p, const Vector3<double>& a,
                                       const Vector3<double>& b) {
  const Vector3<double> d = b - a;
  const double whole = d.dot(d);
  const double t = whole > 0 ? std::clamp(d.dot(Vector3<double>(p - a)) / whole, 0.0, 1.0) : 0.0;
  return a + d * t;
}

/// A direction from a segment to a triangle along which they are probably furthest apart: between
/// their closest points, which are an end and a point of the triangle, or of two edges.
inline Vector3<double> direction_between(const Segment<double>& segment,
                                         const Triangle<double>& triangle) {
  const std::array<Vector3<double>, 3> v{triangle.a, triangle.b, triangle.c};
  Vector3<double> best = triangle.a - segment.start;
  const auto offer = [&best](const Vector3<double>& between) {
    if (between.dot(between) < best.dot(best)) best = between;
  };
  const Vector3<double> n = (v[1] - v[0]).cross(v[2] - v[0]);
  for (const Vector3<double>& p : {segment.start, segment.end}) {
    bool above = n.dot(n) > 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector3<double>& from = v[k];
      const Vector3<double> edge = v[(k + 1) % 3] - from;
      above = above && n.cross(edge).dot(p - from) >= 0;
      offer(next_on_segment(p, from, v[(k + 1) % 3]) - p);
    }
    if (above) offer(n * (n.dot(v[0] - p) / n.dot(n)));
  }
  const Vector3<double> d = segment.end - segment.start;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector3<double>& from = v[k];
    offer(from - next_on_segment(from, segment.start, segment.end));
    const Vector3<double> e = v[(k + 1) % 3] - from, w = from - segment.start;
    const Vector3<double> across = d.cross(e);
    const double whole = across.dot(across);
    if (!(whole > 0)) continue;
    const double s = std::clamp(across.dot(w.cross(e)) / whole, 0.0, 1.0);
    const Vector3<double> p = next_on_segment(segment.start + d * s, from, from + e);
    offer(p - next_on_segment(p, segment.start, segment.end));
  }
  return unit_or_zero(best);
}

/// Whether it is certain that a segment and a triangle are further apart than `margin`.
inline bool certainly_apart(const Segment<double>& segment, const Triangle<double>& triangle,
                            double margin) {
  for (int k = 0; k < 3; ++k) {
    const double low = std::min(segment.start[k], segment.end[k]);
    const double high = std::max(segment.start[k], segment.end[k]);
    const double room = 2 * margin + 0x1p-50 * (std::abs(low) + std::abs(high));
    if (std::min({triangle.a[k], triangle.b[k], triangle.c[k]}) > high + room ||
        std::max({triangle.a[k], triangle.b[k], triangle.c[k]}) < low - room) {
      return true;
    }
  }
  const Vector3<double> direction = direction_between(segment, triangle);
  return all_finite(direction) && proves_apart(direction, segment, triangle, margin);
}

// [certain-crossing]
/// Whether every continuous curve that stays within `margin` of the segment, each of its points
/// with the segment's point of the same parameter, crosses the triangle.
///
/// Its ends are on different sides of the plane, so it crosses the plane. It can do so only next to
/// the part of the segment that is within `margin` of the plane; this part is inside all three
/// edges by more than `margin`.
inline bool certainly_crosses(const Segment<double>& segment, const Triangle<double>& triangle,
                              double margin) {
  const auto a = triple<RunningError>(triangle.a);
  const std::array<Triple<RunningError>, 3> v{a, triple<RunningError>(triangle.b),
                                              triple<RunningError>(triangle.c)};
  const auto start = triple<RunningError>(segment.start), end = triple<RunningError>(segment.end);
  const auto n = cross(minus(v[1], v[0]), minus(v[2], v[0]));
  RunningError h0 = dot(n, minus(start, a)), h1 = dot(n, minus(end, a));
  const RunningError thick(RunningError::up(margin * length_at_most(n)));
  if (h0.value < 0) {
    h0 = -h0;
    h1 = -h1;
  }
  if ((h0 - thick).certain_sign() <= 0 || (h1 + thick).certain_sign() >= 0) return false;
  const RunningError fall = h0 - h1;
  for (const RunningError& t : {(h0 - thick) / fall, (h0 + thick) / fall}) {
    const auto p = plus(start, times(minus(end, start), t));
    for (std::size_t k = 0; k < 3; ++k) {
      const auto inwards = cross(n, minus(v[(k + 1) % 3], v[k]));
      const RunningError wanted(RunningError::up(margin * length_at_most(inwards)));
      if ((dot(inwards, minus(p, v[k])) - wanted).certain_sign() <= 0) return false;
    }
  }
  return true;
}
// [/certain-crossing]

/// Whether the edges of a mesh run as often in one direction as in the other: then its winding
/// number can change only on its triangles.
inline bool is_balanced(const Mesh<double>& mesh) {
  const auto balance = mesh_check_detail::edge_balance(mesh);
  return std::all_of(balance.begin(), balance.end(),
                     [](const auto& edge) { return edge.second == 0; });
}

}  // namespace detail

/// What is proved about a moving point and a moving mesh.
enum class MotionVerdict {
  hit,       ///< they have a point in common during the step
  free,      ///< they have none
  undecided  ///< neither is proved
};

/// The answer with what it proves.
struct MotionAnswer {
  MotionVerdict verdict = MotionVerdict::undecided;  ///< what is proved
  double from = 0;    ///< no contact before this fraction of the step; 1 if free
  double to = 1;      ///< if hit: there is a contact at or before this fraction
  int triangle = -1;  ///< that is crossed between from and to, if one triangle proves it
  int chords = 0;     ///< how many were tested
};

namespace detail {

// [certify]
/// Goes through the step from left to right; a chord that proves nothing is replaced by two.
class MotionCertifier {
 public:
  MotionCertifier(const RigidMotion<double>& motion, const Segment<double>& path,
                  const Mesh<double>& mesh, int max_chords, double resolution)
      : path_(motion, path), mesh_(mesh), max_chords_(max_chords), resolution_(resolution) {}

  MotionAnswer decide() {
    std::vector<std::size_t> all(mesh_.triangles.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
    answer_.from = 1;
    open_.push_back({0, 1, all});
    while (!open_.empty()) {
      Part part = std::move(open_.back());
      open_.pop_back();
      if (settle(part)) return answer_;
    }
    if (answer_.verdict == MotionVerdict::hit) {
      answer_.from = std::min(answer_.from, gap_.value_or(1.0));
      return answer_;
    }
    if (close_gap(1)) return answer_;
    answer_.verdict = undecided_ ? MotionVerdict::undecided : MotionVerdict::free;
    answer_.to = 1;
    return answer_;
  }

 private:
  /// A part of the step, and the triangles that the path may meet in it.
  struct Part {
    double s0, s1;
    std::vector<std::size_t> triangles;
  };
  EnclosedPath path_;
  const Mesh<double>& mesh_;
  int max_chords_;
  double resolution_;
  MotionAnswer answer_;
  std::vector<Part> open_;
  std::optional<bool> balanced_;  ///< found when it is first needed
  std::optional<double> gap_;     ///< where the parts that are not decided begin
  bool undecided_ = false;

  /// True if a hit is proved.
  bool settle(Part& part) {
    ++answer_.chords;
    const EnclosedPath::Sample p0 = path_.sample(part.s0), p1 = path_.sample(part.s1);
    const Segment<double> chord{p0.at, p1.at};
    const double margin =
        RunningError::up(path_.chord_error(part.s0, part.s1) + larger_bound(p0.error, p1.error));
    const bool usable = std::isfinite(margin) && all_finite(p0.at) && all_finite(p1.at);
    if (usable) {
      std::erase_if(part.triangles, [&](std::size_t i) {
        return certainly_apart(chord, triangle_of(mesh_, i), margin);
      });
    }
    if (part.triangles.empty()) return close_gap(part.s0);
    for (const std::size_t i : part.triangles) {
      if (!usable || !certainly_crosses(chord, triangle_of(mesh_, i), margin)) continue;
      answer_.to = part.s1;
      answer_.triangle = static_cast<int>(i);
      answer_.verdict = MotionVerdict::hit;
      open_.clear();  // what is later does not matter any more
      if (part.s1 - part.s0 <= resolution_ || !divide(part)) {
        answer_.from = std::min(answer_.from, gap_.value_or(part.s0));
        return true;
      }
      return false;
    }
    if (usable && divide(part)) return false;
    if (!gap_) gap_ = part.s0;
    return false;
  }

  /// Replaces a part by its halves, the left one first, unless the limit is reached.
  bool divide(Part& part) {
    if (answer_.chords + static_cast<int>(open_.size()) + 2 > max_chords_) return false;
    if (part.s1 - part.s0 <= 0x1p-30) return false;
    const double middle = (part.s0 + part.s1) / 2;
    open_.push_back({middle, part.s1, part.triangles});
    open_.push_back({part.s0, middle, std::move(part.triangles)});
    return true;
  }

  /// Ends a run of undecided parts. If its ends are off the surface and the winding numbers differ,
  /// the path has crossed the surface between them, through an edge or a vertex, or grazing.
  bool close_gap(double end) {
    if (!gap_) return false;
    const double begin = *gap_;
    gap_.reset();
    answer_.from = std::min(answer_.from, begin);
    undecided_ = true;
    if (!balanced_) balanced_ = is_balanced(mesh_);
    if (!*balanced_) return false;
    const std::optional<int> before = winding_at(begin), after = winding_at(end);
    if (!before || !after || *before == *after) return false;
    answer_.to = end;
    answer_.triangle = -1;
    answer_.verdict = MotionVerdict::hit;
    return true;
  }

  /// The winding number of a point of the path, if no triangle is within its rounding error.
  std::optional<int> winding_at(double s) const {
    const EnclosedPath::Sample p = path_.sample(s);
    if (!all_finite(p.at) || !std::isfinite(p.error)) return std::nullopt;
    for (std::size_t i = 0; i < mesh_.triangles.size(); ++i) {
      if (!certainly_apart({p.at, p.at}, triangle_of(mesh_, i), p.error)) return std::nullopt;
    }
    return locate_in_mesh(p.at, mesh_).winding;
  }
};
// [/certify]

/// Whether a segment and a triangle have a point in common, exactly; triangles without area have
/// none. Then also t, from the first to the last common point, as quotients.
struct ExactMeeting {
  Exact first, last, below;
};
inline std::optional<ExactMeeting> exact_meeting(const Vector3<Exact>& p, const Vector3<Exact>& q,
                                                 const Triangle<double>& triangle) {
  const auto exact = [](const Vector3<double>& v) {
    return Vector3<Exact>(Exact(v.x()), Exact(v.y()), Exact(v.z()));
  };
  const std::array<Vector3<Exact>, 3> v{exact(triangle.a), exact(triangle.b), exact(triangle.c)};
  const Vector3<Exact> ab = v[1] - v[0], ac = v[2] - v[0], from = p - v[0], d = q - p;
  const Vector3<Exact> n = ab.cross(ac);
  Exact below = -Exact(n.dot(d)), start = n.dot(from);
  Exact low, high(1.0), scale(1.0);  // of t, times scale
  if (below.sign() != 0) {
    if (below.sign() < 0) {
      below = -below;
      start = -start;
    }
    if (start.sign() < 0 || start > below) return std::nullopt;
    low = high = start;
    scale = below;
  } else if (start.sign() != 0 || Exact(n.dot(n)).sign() == 0) {
    return std::nullopt;
  }
  // Inside an edge: at + t rate ≥ 0.
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector3<Exact> edge = v[(k + 1) % 3] - v[k];
    const Vector3<Exact> inwards = n.cross(edge);
    const Exact at = inwards.dot(Vector3<Exact>(p - v[k])), rate = inwards.dot(d);
    if (below.sign() != 0) {
      if ((at * scale + rate * low).sign() < 0) return std::nullopt;
      continue;
    }
    if (rate.sign() == 0) {
      if (at.sign() < 0) return std::nullopt;
      continue;
    }
    const Exact size = abs(rate);
    const Exact cut = rate.sign() > 0 ? -at : at;  // over size
    if (rate.sign() > 0 ? cut * scale > low * size : cut * scale < high * size) {
      (rate.sign() > 0 ? high : low) *= size;
      (rate.sign() > 0 ? low : high) = cut * scale;
      scale *= size;
    }
    if (low > high) return std::nullopt;
  }
  return ExactMeeting{low, high, scale};
}

inline MotionAnswer decide_translation(const RigidMotion<double>& motion,
                                       const Segment<double>& path, const Mesh<double>& mesh) {
  const auto exact = [](const Vector3<double>& v) {
    return Vector3<Exact>(Exact(v.x()), Exact(v.y()), Exact(v.z()));
  };
  const auto turned = [&](const Vector3<Exact>& v) {
    return Vector3<Exact>(exact(motion.start.axes.col(0)).dot(v),
                          exact(motion.start.axes.col(1)).dot(v),
                          exact(motion.start.axes.col(2)).dot(v));
  };
  const Vector3<Exact> origin = exact(motion.start.origin);
  const Vector3<Exact> p = turned(exact(path.start) - origin);
  const Vector3<Exact> q = turned(exact(path.end) - origin - exact(motion.displacement));
  const EnclosedPath rough(motion, path);
  const EnclosedPath::Sample p0 = rough.sample(0), p1 = rough.sample(1);
  const double margin = larger_bound(p0.error, p1.error);
  MotionAnswer answer;
  answer.chords = 1;
  std::optional<ExactMeeting> first;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const Triangle<double> triangle = triangle_of(mesh, i);
    if (std::isfinite(margin) && certainly_apart({p0.at, p1.at}, triangle, margin)) continue;
    const auto meeting = exact_meeting(p, q, triangle);
    if (!meeting) continue;
    if (first && !(meeting->first * first->below < first->first * meeting->below)) continue;
    first = meeting;
    answer.triangle = static_cast<int>(i);
  }
  answer.verdict = first ? MotionVerdict::hit : MotionVerdict::free;
  answer.from = answer.to = 1;
  if (first) {
    const double t = quotient<double>(first->first, first->below);
    answer.from = t > 0 ? std::nextafter(t, 0.0) : 0.0;
    answer.to = t < 1 ? std::nextafter(t, 1.0) : 1.0;
  }
  return answer;
}

/// The same question with all lengths times a power of two, so that the largest is near 1. Nothing
/// if it is not far from 1 already, or if a length would be rounded.
struct ScaledQuestion {
  Segment<double> path;
  Mesh<double> mesh;
  RigidMotion<double> motion;
};
inline std::optional<ScaledQuestion> scaled_question(const Segment<double>& path,
                                                     const Mesh<double>& mesh,
                                                     const RigidMotion<double>& motion) {
  ScaledQuestion scaled{path, mesh, motion};
  std::vector<Vector3<double>*> lengths{&scaled.path.start, &scaled.path.end,
                                        &scaled.motion.start.origin, &scaled.motion.displacement};
  for (Vector3<double>& vertex : scaled.mesh.vertices) lengths.push_back(&vertex);
  double largest = 0;
  for (const Vector3<double>* v : lengths) largest = std::max(largest, v->cwiseAbs().maxCoeff());
  int power = 0;
  std::frexp(largest, &power);
  if (std::abs(power) < 100) return std::nullopt;
  for (Vector3<double>* v : lengths) {
    for (int k = 0; k < 3; ++k) {
      const double x = std::ldexp((*v)[k], -power);
      if (std::ldexp(x, power) != (*v)[k]) return std::nullopt;
      (*v)[k] = x;
    }
  }
  return scaled;
}

}  // namespace detail

// [certified]
/// Whether a moving point meets a moving mesh during a step: hit, free or undecided, never wrong.
///
/// What is decided is the path of the stored numbers: the point from path.start to path.end, the
/// motion as `RigidMotion` says, in real arithmetic, and the stored mesh, which is its surface: a
/// point that stays inside is free. If the motion comes from `motion_between`, its rounding (a few
/// u of the angle) is outside the proof.
///
/// - Free: each chord is further from each triangle than its margin, which is the bound on the
///   distance of path and chord plus the rounding of the chord's ends. A separating direction
///   proves it.
/// - Hit: a chord passes through a triangle so far from its edges that the path must cross it too;
/// or,
///   for a closed mesh, the winding number differs between two times, so that the path must have
///   crossed the surface, even if at an edge.
/// - Undecided: neither is proved before a limit is reached. Touching stays undecided for every
///   limit.
///
/// A contact at the start with a triangle that has area is decided exactly. With rotation,
/// triangles without area near the path leave the answer undecided.
/// Without rotation the path is straight, its ends are exact, and so is the decision: touching is a
/// hit, and nothing is undecided. Triangles without area are then left out.
///
/// @param path of the point, in the world, m
/// @param mesh in the body's frame, m; any triangles
/// @param max_chords limit of the refinement; at least one chord is tested. Another limit is that
/// no part of the step shorter than 2^-30 of it is divided
/// @param resolution a hit is refined until the first contact is known to this fraction of the
/// step, not below 2^-30, if the limits allow and no earlier part stays undecided
/// @return free if there are no triangles; undecided if a number is not finite, also of a vertex
/// that no triangle uses. Lengths are scaled by a power of two; if their magnitudes are so
/// different that this would round one, or by more than about 1e±60, more is undecided
///
/// Limits: the time is proportional to the triangles near the path times the chords. Point and body
/// move as `chord_bound` requires.
inline MotionAnswer certified_moving_hit(const Segment<double>& path, const Mesh<double>& mesh,
                                         const RigidMotion<double>& motion, int max_chords = 1024,
                                         double resolution = 0x1p-20) {
  const bool finite = all_finite(path.start) && all_finite(path.end) &&
                      all_finite(motion.start.origin) && all_finite(motion.start.axes) &&
                      all_finite(motion.displacement) && all_finite(motion.rotation) &&
                      std::all_of(mesh.vertices.begin(), mesh.vertices.end(),
                                  [](const Vector3<double>& vertex) { return all_finite(vertex); });
  if (!finite) return {};
  if (motion.rotation == Vector3<double>::Zero()) {
    return detail::decide_translation(motion, path, mesh);
  }
  const RigidMotion<double> none{motion.start, Vector3<double>::Zero(), Vector3<double>::Zero()};
  const MotionAnswer start = detail::decide_translation(none, {path.start, path.start}, mesh);
  if (start.verdict == MotionVerdict::hit) return {start.verdict, 0, 0, start.triangle, 1};
  const auto scaled = detail::scaled_question(path, mesh, motion);
  if (!scaled) return detail::MotionCertifier(motion, path, mesh, max_chords, resolution).decide();
  return detail::MotionCertifier(scaled->motion, scaled->path, scaled->mesh, max_chords, resolution)
      .decide();
}
// [/certified]

}  // namespace contact
