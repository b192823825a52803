/// @file
/// The distance of two convex bodies' cores by the algorithm of Gilbert, Johnson and Keerthi (GJK),
/// rounded.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <contact/gjk_cores.hpp>
#include <contact/gjk_simplex.hpp>
#include <contact/support.hpp>
#include <contact/tolerance.hpp>
#include <contact/vector.hpp>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace contact {

// [gjk-result]
/// A vertex of GJK's simplex: a difference of two points, of A and of B.
template <FloatOrDouble S>
struct GjkVertex {
  Vector3<S> difference = Vector3<S>::Zero();  ///< of_a − of_b, m
  Vector3<S> of_a = Vector3<S>::Zero();  ///< a vertex of A's core, or a point of a smooth A, m
  Vector3<S> of_b = Vector3<S>::Zero();  ///< the same of B, m
  int a = -1;                            ///< which vertex of A's core; −1 for a smooth body
  int b = -1;                            ///< which vertex of B's core
};

/// What GJK found of two bodies A and B. Distances and points are those of the cores, or of the
/// bodies if they are smooth; radii are not subtracted.
template <FloatOrDouble S>
struct GjkResult {
  S distance = S(0);                        ///< |between|, m; 0 if the simplex contains the origin
  S lower = S(0);                           ///< a lower bound up to rounding, from a plane, m
  Vector3<S> between = Vector3<S>::Zero();  ///< from B to A, m: on_a − on_b with more digits
  Vector3<S> on_a = Vector3<S>::Zero();     ///< closest point of A, m
  Vector3<S> on_b = Vector3<S>::Zero();     ///< closest point of B, m
  int count = 0;                            ///< vertices of the simplex, from 1 to 4
  std::array<GjkVertex<S>, 4> simplex;      ///< the first `count` count
  std::array<S, 4> weights{};               ///< of the vertices, > 0, of sum 1 up to rounding
  int iterations = 0;                       ///< pairs of supports computed
  bool converged = false;                   ///< whether `distance` and `lower` agree up to rounding
};

/// Where GJK begins: with the simplex of an earlier result, or along its direction. It changes the
/// time that GJK needs, not what it looks for.
template <FloatOrDouble S>
struct GjkStart {
  Vector3<S> direction = Vector3<S>::Zero();  ///< from B to A, of any length; 0: unknown
  int count = 0;                              ///< vertices of the simplex; 0: none is known
  std::array<int, 4> a{};                     ///< which vertices of the core of A
  std::array<int, 4> b{};                     ///< which vertices of the core of B
  S accuracy = S(0);  ///< ends once distance − lower is at most this, m; 0: as far as possible
};
// [/gjk-result]

/// The start that a result gives for the same bodies a step later.
template <FloatOrDouble S>
GjkStart<S> start_from(const GjkResult<S>& result) {
  GjkStart<S> start;
  start.direction = result.between;
  start.count = result.count;
  for (std::size_t i = 0; i < 4; ++i) {
    start.a[i] = result.simplex[i].a;
    start.b[i] = result.simplex[i].b;
    if (i < static_cast<std::size_t>(result.count) && (start.a[i] < 0 || start.b[i] < 0)) {
      start.count = 0;
    }
  }
  return start;
}

/// One step of GJK, to draw it.
template <FloatOrDouble S>
struct GjkStep {
  int count = 0;           ///< vertices of the simplex
  FourPoints<S> vertices;  ///< differences of points of A and B, m; the first `count` count
  Vector3<S> closest = Vector3<S>::Zero();  ///< the simplex's point closest to the origin, m
  Vector3<S> next = Vector3<S>::Zero();  ///< the vertex of A − B farthest towards the origin, m
};

namespace gjk_detail {

/// How often GJK computes supports at most.
inline constexpr int max_iterations = 255;

/// Lengths whose products of four neither over- nor underflow.
template <FloatOrDouble S>
inline constexpr S longest_length = std::same_as<S, float> ? S(0x1p30) : S(0x1p200);
template <FloatOrDouble S>
inline constexpr S shortest_length = std::same_as<S, float> ? S(0x1p-20) : S(0x1p-150);

/// The loop, for two bodies and with a function that is told each step.
template <ConvexBody A, ConvexBody B, class Record>
class GjkLoop {
 public:
  using S = ScalarOf<A>;
  GjkLoop(const A& a, const B& b, const Record& record)
      : body_a_(a), body_b_(b), a_(a), b_(b), record_(record) {}

  /// Runs until nothing can be improved.
  /// @return false if a length was out of range, so that nothing is known
  bool run(const GjkStart<S>& start);
  GjkResult<ScalarOf<A>> result() const;

 private:
  using KeyA = typename GjkCore<A>::Key;
  using KeyB = typename GjkCore<B>::Key;

  const A& body_a_;
  const B& body_b_;
  GjkCore<A> a_;
  GjkCore<B> b_;
  const Record& record_;

  FourPoints<S> w_;  // the simplex
  std::array<KeyA, 4> of_a_;
  std::array<KeyB, 4> of_b_;
  int count_ = 0;
  SimplexPoint<S> closest_;
  S squared_ = S(0);          // |closest|²
  S lowest_along_ = S(0);     // the smallest w · closest of A − B
  S largest_squared_ = S(0);  // of all w
  int iterations_ = 0;
  S accuracy_squared_ = S(0);
  bool exactly_ = false;     // whether the simplex was solved without rounding
  bool exact_only_ = false;  // whether all are from now on
  S min_squared_ = std::numeric_limits<S>::infinity();  // |closest|² of those that were
  bool converged_ = false;

  static constexpr std::size_t at(int i) { return static_cast<std::size_t>(i); }

  Vector3<S> difference(const KeyA& p, const KeyB& q) const {
    const Vector3<S> w = minus<S>(a_.base(p), b_.base(q));
    if constexpr (GjkCore<A>::has_offset && GjkCore<B>::has_offset) {
      return plus<S>(w, S(1), minus<S>(a_.offset(p), b_.offset(q)));
    } else if constexpr (GjkCore<A>::has_offset) {
      return plus<S>(w, S(1), a_.offset(p));
    } else if constexpr (GjkCore<B>::has_offset) {
      return minus<S>(w, b_.offset(q));
    } else {
      return w;
    }
  }
  void append(const KeyA& p, const KeyB& q, const Vector3<S>& w) {
    of_a_[at(count_)] = p;
    of_b_[at(count_)] = q;
    w_[at(count_)] = w;
    ++count_;
  }
  bool has(const KeyA& p, const KeyB& q, const Vector3<S>& w) const;
  void begin(const GjkStart<S>& start);
  void solve() {
    exactly_ = exact_only_;
    closest_ = exactly_ ? closest_of_simplex_exactly(w_, count_) : closest_of_simplex(w_, count_);
    squared_ = dot3<S>(closest_.point, closest_.point);
    lowest_along_ = S(0);
  }
  bool solve_exactly();
  void reduce();
  bool in_range() const { return largest_squared_ <= longest_length<S> * longest_length<S>; }
  enum class Step { closer, optimal, doubtful, out_of_range };
  Step step();
  S tolerance_squared() const {
    constexpr S room = S(SmoothBody<A> || SmoothBody<B> ? 128 : 16) * tolerance::unit_roundoff<S>;
    return room * room * largest_squared_;
  }
  bool confirmed() const;
  bool improve_exactly();
};

template <ConvexBody A, ConvexBody B, class Record>
bool GjkLoop<A, B, Record>::has(const KeyA& p, const KeyB& q, const Vector3<S>& w) const {
  for (int i = 0; i < count_; ++i) {
    if constexpr (PolytopeCore<A> && PolytopeCore<B>) {
      if (of_a_[at(i)] == p && of_b_[at(i)] == q) return true;
    } else {
      if (w_[at(i)] == w) return true;
    }
  }
  return false;
}

// [gjk-begin]
template <ConvexBody A, ConvexBody B, class Record>
void GjkLoop<A, B, Record>::begin(const GjkStart<S>& start) {
  if constexpr (PolytopeCore<A> && PolytopeCore<B>) {
    const int of_a = vertex_count(body_a_), of_b = vertex_count(body_b_);
    for (int i = 0; i < std::min(start.count, 4); ++i) {
      const int p = start.a[at(i)], q = start.b[at(i)];
      if (p < 0 || q < 0 || p >= of_a || q >= of_b) continue;
      append(p, q, difference(p, q));
      const Vector3<S>& w = w_[at(count_ - 1)];
      largest_squared_ = std::max(largest_squared_, dot3<S>(w, w));
    }
  }
  accuracy_squared_ = start.accuracy * start.accuracy;
  if (count_ == 0) {
    Vector3<S> direction = start.direction;
    if (direction == Vector3<S>::Zero()) direction = inner_point(body_a_) - inner_point(body_b_);
    const KeyA p = a_.farthest(-direction);
    const KeyB q = b_.farthest(direction);
    append(p, q, difference(p, q));
    largest_squared_ = dot3<S>(w_[0], w_[0]);
    iterations_ = 1;
  }
}
// [/gjk-begin]

/// Leaves only the vertices of the face with the closest point.
template <ConvexBody A, ConvexBody B, class Record>
void GjkLoop<A, B, Record>::reduce() {
  int kept = 0;
  for (int i = 0; i < count_; ++i) {
    if ((closest_.face >> i & 1U) == 0) continue;
    if (kept != i) {
      w_[at(kept)] = w_[at(i)];
      of_a_[at(kept)] = of_a_[at(i)];
      of_b_[at(kept)] = of_b_[at(i)];
      closest_.weights[at(kept)] = closest_.weights[at(i)];
    }
    ++kept;
  }
  count_ = kept;
  closest_.face = (1U << kept) - 1;
}

/// Whether the weights give the closest point: of thin simplices rounding may have made another.
template <ConvexBody A, ConvexBody B, class Record>
bool GjkLoop<A, B, Record>::confirmed() const {
  Vector3<S> sum = Vector3<S>::Zero();
  for (int i = 0; i < count_; ++i) sum = plus<S>(sum, closest_.weights[at(i)], w_[at(i)]);
  const Vector3<S> off = minus(sum, closest_.point);
  return dot3<S>(off, off) <= tolerance_squared();
}

/// Solves the simplex without rounding.
/// @return whether its point is closer than that of any simplex that was solved so before
template <ConvexBody A, ConvexBody B, class Record>
bool GjkLoop<A, B, Record>::solve_exactly() {
  const bool before = std::exchange(exact_only_, true);
  solve();
  exact_only_ = before;
  const bool closer = squared_ < min_squared_;
  min_squared_ = std::min(min_squared_, squared_);
  return closer;
}

// [gjk-step]
/// One pair of supports: says that the closest point is optimal, or adds a vertex. A step is in
/// doubt if its vertex is known already, or if its simplex is no closer than the one before.
template <ConvexBody A, ConvexBody B, class Record>
auto GjkLoop<A, B, Record>::step() -> Step {
  if (squared_ <= tolerance_squared()) return Step::optimal;  // the origin, up to rounding
  const KeyA p = a_.farthest(times<S>(S(-1), closest_.point));
  const KeyB q = b_.farthest(closest_.point);
  const Vector3<S> w = difference(p, q);
  record_(w_, count_, closest_.point, w);
  ++iterations_;
  largest_squared_ = std::max(largest_squared_, dot3<S>(w, w));
  if (!in_range()) return Step::out_of_range;
  lowest_along_ = dot3<S>(w, closest_.point);
  const S gap = squared_ - lowest_along_, before = squared_;
  const S room = std::max(tolerance_squared(), accuracy_squared_);
  if (!(gap > S(0)) || gap * gap <= room * squared_) return Step::optimal;
  if (has(p, q, w)) return Step::doubtful;
  append(p, q, w);
  solve();
  if (!(squared_ < before)) return Step::doubtful;
  reduce();
  return Step::closer;
}
// [/gjk-step]

// [gjk-loop]
/// The last step is believed if its weights give its point. If it is not, or a step is in doubt,
/// the simplex is solved without rounding; if that is no closer than an earlier one solved so, all
/// are from then on. So the loop ends: the numbers in a row of exact ones fall.
template <ConvexBody A, ConvexBody B, class Record>
bool GjkLoop<A, B, Record>::run(const GjkStart<S>& start) {
  begin(start);
  if (!in_range()) return false;
  solve();
  reduce();
  while (iterations_ < max_iterations) {
    const Step taken = step();
    if (taken == Step::out_of_range) return false;
    if (taken == Step::closer) continue;
    converged_ = taken == Step::optimal && (exactly_ || confirmed());
    if (converged_) break;
    const bool settled = exactly_;
    if (!settled && !solve_exactly()) exact_only_ = true;
    reduce();
    if (settled) break;
  }
  return largest_squared_ >= shortest_length<S> * shortest_length<S>;
}
// [/gjk-loop]

template <ConvexBody A, ConvexBody B, class Record>
GjkResult<ScalarOf<A>> GjkLoop<A, B, Record>::result() const {
  GjkResult<S> found;
  // + 0 makes 0 of −0.
  found.between = closest_.point + Vector3<S>::Zero();
  found.distance = std::sqrt(squared_);
  if (lowest_along_ > S(0)) found.lower = std::min(found.distance, lowest_along_ / found.distance);
  found.count = count_;
  found.iterations = iterations_;
  found.converged = converged_;
  for (int i = 0; i < count_; ++i) {
    GjkVertex<S>& v = found.simplex[at(i)];
    v.difference = w_[at(i)];
    v.of_a = plus<S>(a_.base(of_a_[at(i)]), S(1), a_.offset(of_a_[at(i)]));
    v.of_b = plus<S>(b_.base(of_b_[at(i)]), S(1), b_.offset(of_b_[at(i)]));
    if constexpr (PolytopeCore<A>) v.a = of_a_[at(i)];
    if constexpr (PolytopeCore<B>) v.b = of_b_[at(i)];
    found.weights[at(i)] = closest_.weights[at(i)];
    found.on_a = plus<S>(found.on_a, found.weights[at(i)], v.of_a);
    found.on_b = plus<S>(found.on_b, found.weights[at(i)], v.of_b);
  }
  return found;
}

/// A result whose lengths are multiplied by 2^power.
template <FloatOrDouble S>
void multiply_by_power_of_two(GjkResult<S>& found, int power) {
  const auto times = [power](Vector3<S>& v) {
    for (int i = 0; i < 3; ++i) v(i) = std::ldexp(v(i), power);
  };
  found.distance = std::ldexp(found.distance, power);
  found.lower = std::ldexp(found.lower, power);
  for (Vector3<S>* v : {&found.between, &found.on_a, &found.on_b}) times(*v);
  for (GjkVertex<S>& v : found.simplex) {
    for (Vector3<S>* x : {&v.difference, &v.of_a, &v.of_b}) times(*x);
  }
}

/// A step whose lengths are multiplied by 2^power.
template <FloatOrDouble S>
void multiply_by_power_of_two(GjkStep<S>& step, int power) {
  const auto times = [power](Vector3<S>& v) {
    for (int i = 0; i < 3; ++i) v(i) = std::ldexp(v(i), power);
  };
  for (int i = 0; i < step.count; ++i) times(step.vertices[static_cast<std::size_t>(i)]);
  times(step.closest);
  times(step.next);
}

/// GJK with a function that is told each step and by which power of two its lengths are multiplied.
template <ConvexBody A, ConvexBody B, class Record>
GjkResult<ScalarOf<A>> gjk_recorded(const A& a, const B& b, const GjkStart<ScalarOf<A>>& start,
                                    const Record& record) {
  using S = ScalarOf<A>;
  {
    const auto told = [&record](const auto&... step) { record(0, step...); };
    GjkLoop<A, B, decltype(told)> loop(a, b, told);
    if (loop.run(start)) return loop.result();
  }
  const S of_a = largest_number(a), of_b = largest_number(b);
  GjkResult<S> nothing;
  nothing.distance = nothing.lower = std::numeric_limits<S>::infinity();
  if (!std::isfinite(of_a) || !std::isfinite(of_b)) return nothing;
  int power = 0;
  std::frexp(std::max(of_a, of_b), &power);
  power += 3;  // a box reaches at most six times as far
  const A small_a = times_power_of_two(a, -power);
  const B small_b = times_power_of_two(b, -power);
  const auto told = [&record, power](const auto&... step) { record(power, step...); };
  GjkLoop<A, B, decltype(told)> loop(small_a, small_b, told);
  GjkStart<S> same = start;
  same.direction = detail::unit_of_any_size<S>(start.direction);
  same.accuracy = std::ldexp(start.accuracy, -power);
  loop.run(same);
  GjkResult<S> found = loop.result();
  multiply_by_power_of_two(found, power);
  return found;
}

}  // namespace gjk_detail

// [gjk]
/// The closest points and the distance of the cores of two bodies, rounded.
///
/// The difference A − B is a convex body, and the distance is that of the origin from it. A simplex
/// of its points is improved: its point v closest to the origin, then the point of A − B farthest
/// along −v. Each gives a bound: |v| is at least the distance, and w · v/|v| of the farthest w at
/// most. GJK ends when they agree to 16 u of the longest w, of smooth bodies 128 u.
///
/// It ends for all numbers, after at most 255 steps, and no result is NaN if all are finite. In
/// tests of all kinds with polytopes as cores, random, touching, thin, large and far, the distance
/// is off by less than 64 u of the largest coordinate; of smooth bodies by less than 1024 u where
/// `converged` says so.
///
/// Limits: rounded, so it proves nothing. It does not guarantee that `converged` is true, that
/// `lower` is below the distance (it is rounded), or which side of 0 a distance of a few u is on:
/// bodies that touch or overlap by so little may have a positive distance, and disjoint ones 0.
/// The depth of overlapping cores is not computed. A body with infinite or NaN coordinates has a
/// distance of ∞ and no closest points, or is treated as what is finite of it. A distance beyond
/// the largest number is ∞.
/// @param a, b a hull has at least one vertex; radii and half lengths are not negative
/// @param start any numbers; those that are no vertices are passed over
///
/// Source: Gilbert, Johnson and Keerthi, *A fast procedure for computing the distance between
/// complex objects in three-dimensional space*, IEEE Journal on Robotics and Automation 4 (1988).
/// The bound at the end is van den Bergen's, *A fast and robust GJK implementation for collision
/// detection of convex objects*, Journal of Graphics Tools 4 (1999).
template <ConvexBody A, ConvexBody B>
requires std::same_as<ScalarOf<A>, ScalarOf<B>> GjkResult<ScalarOf<A>> gjk(
    const A& a, const B& b, const GjkStart<ScalarOf<A>>& start = {}) {
  return gjk_detail::gjk_recorded(a, b, start, [](const auto&...) {});
}
// [/gjk]

/// The steps of gjk() on two bodies, the last one that which ended it; none if the first simplex
/// has the origin.
template <ConvexBody A, ConvexBody B>
requires std::same_as<ScalarOf<A>, ScalarOf<B>> std::vector<GjkStep<ScalarOf<A>>> gjk_steps(
    const A& a, const B& b) {
  using S = ScalarOf<A>;
  std::vector<GjkStep<S>> steps;
  int multiplied_by = 0;
  const auto record = [&](int power, const FourPoints<S>& w, int count, const Vector3<S>& closest,
                          const Vector3<S>& next) {
    if (power != multiplied_by) steps.clear();
    multiplied_by = power;
    GjkStep<S> step{count, w, closest, next};
    gjk_detail::multiply_by_power_of_two(step, power);
    steps.push_back(step);
  };
  gjk_detail::gjk_recorded(a, b, {}, record);
  return steps;
}

}  // namespace contact
