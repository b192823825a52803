/// @file
/// Disjoint or overlapping by GJK cut short: as soon as a plane or common points prove it.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>
#include <optional>

#include <contact/bounded_differences.hpp>
#include <contact/certified_cores.hpp>
#include <contact/exact_support.hpp>
#include <contact/gjk_cores.hpp>
#include <contact/gjk_simplex.hpp>
#include <contact/inside_points.hpp>
#include <contact/outward.hpp>
#include <contact/products.hpp>
#include <contact/proximity_cases.hpp>
#include <contact/support.hpp>
#include <contact/vector.hpp>

namespace contact::detail {

/// A point from which the centre of a body is not far, for a first direction.
template <ConvexBody Body>
Vector3<double> rough_centre(const Body& body) {
  if constexpr (requires { body.core; }) {
    return gjk_detail::times<double>(0.5, Vector3<double>(body.core.start + body.core.end));
  } else if constexpr (requires { body.corner; }) {
    return body.corner + (body.first_edge + body.second_edge) * 0.5;
  } else if constexpr (requires { body.vertices; }) {
    Vector3<double> sum = Vector3<double>::Zero();
    for (const Vector3<double>& v : body.vertices) sum += v;
    return sum * (1 / static_cast<double>(body.vertices.size()));
  } else if constexpr (requires { body.a; }) {
    return (body.a + body.b + body.c) * (1.0 / 3);
  } else {
    return body.centre;
  }
}

/// GJK without a guarantee that it ends with the distance: what it finds is tried as a proof.
template <ConvexBody A, ConvexBody B>
class EarlyDecision {
 public:
  EarlyDecision(const A& a, const B& b)
      : a_(a),
        b_(b),
        core_a_(a),
        core_b_(b),
        centre_a_(rough_centre(a)),
        centre_b_(rough_centre(b)),
        reach_(double(radius_of(a)) + double(radius_of(b))) {}

  // [early-run]
  /// Each vertex w farthest against the direction v shows whether v may separate: if v · w > (rₐ +
  /// r_b) |v|. Each simplex may prove an overlap that has the origin inside or closer than the
  /// radii. The first that is proved is the answer; a vertex that is known already, or a simplex
  /// that is no closer than the last, ends the search. Then the origin may be on a face of the
  /// simplex up to rounding, and vertices on both sides of it prove an overlap.
  Proximity run() {
    Vector3<double> v = centre_a_ - centre_b_;
    if (v == Vector3<double>::Zero()) v = Vector3<double>::UnitX();
    double squared = dot3<double>(v, v), nearest = std::numeric_limits<double>::infinity();
    for (int step = 0; step < max_steps; ++step) {
      if (!(squared > shortest * shortest && squared < longest * longest)) break;
      const KeyA p = core_a_.farthest(gjk_detail::times<double>(-1, v));
      const KeyB q = core_b_.farthest(v);
      const Vector3<double> w = difference(p, q);
      const double along = dot3<double>(w, v);
      if (along > 0 && along * along > reach_ * reach_ * squared) {
        if (separation_down(a_, b_, v) > 0) return Proximity::disjoint;
        if (++failed_ > max_failures) break;
      }
      if (is_known(w)) break;
      append(p, q, w);
      const SimplexPoint<double> closest = closest_of_simplex(w_, count_);
      reduce(closest);
      v = closest.point;
      squared = dot3<double>(v, v);
      if (count_ == 4 || squared < reach_ * reach_) {
        if (is_proved_to_overlap()) return Proximity::overlapping;
        if (++failed_ > max_failures) break;
      }
      if (!(squared < nearest)) break;
      nearest = squared;
    }
    return is_surrounded() ? Proximity::overlapping : Proximity::undecided;
  }
  // [/early-run]

 private:
  using KeyA = typename gjk_detail::GjkCore<A>::Key;
  using KeyB = typename gjk_detail::GjkCore<B>::Key;
  static constexpr int max_steps = 40, max_failures = 2;
  static constexpr double longest = 0x1p200, shortest = 0x1p-150;

  const A& a_;
  const B& b_;
  gjk_detail::GjkCore<A> core_a_;
  gjk_detail::GjkCore<B> core_b_;
  Vector3<double> centre_a_, centre_b_;
  double reach_;  // sum of the radii, rounded
  FourPoints<double> w_;
  std::array<KeyA, 4> of_a_;
  std::array<KeyB, 4> of_b_;
  std::array<double, 6> weights_{};
  int count_ = 0, failed_ = 0;

  static std::size_t at(int i) { return static_cast<std::size_t>(i); }

  Vector3<double> difference(const KeyA& p, const KeyB& q) const {
    const Vector3<double> base = gjk_detail::minus<double>(core_a_.base(p), core_b_.base(q));
    const Vector3<double> offset = gjk_detail::minus<double>(core_a_.offset(p), core_b_.offset(q));
    return gjk_detail::plus<double>(base, 1, offset);
  }
  bool is_known(const Vector3<double>& w) const {
    return std::any_of(w_.begin(), w_.begin() + count_,
                       [&w](const Vector3<double>& x) { return x == w; });
  }
  void append(const KeyA& p, const KeyB& q, const Vector3<double>& w) {
    of_a_[at(count_)] = p;
    of_b_[at(count_)] = q;
    w_[at(count_)] = w;
    ++count_;
  }
  /// Leaves only the vertices of the face with the closest point.
  void reduce(const SimplexPoint<double>& closest) {
    int kept = 0;
    for (int i = 0; i < count_; ++i) {
      if ((closest.face >> i & 1U) == 0) continue;
      w_[at(kept)] = w_[at(i)];
      of_a_[at(kept)] = of_a_[at(i)];
      of_b_[at(kept)] = of_b_[at(i)];
      weights_[at(kept++)] = closest.weights[at(i)];
    }
    count_ = kept;
  }

  /// A vertex of a core, or a point that is certainly in a smooth body and close to its vertex.
  template <PolytopeCore Body>
  static std::optional<PositionAndOffset> member(const Body& body, int key,
                                                 const Vector3<double>&) {
    return vertex_from_position(body, key);
  }
  template <SmoothBody Body, class Key>
  static std::optional<PositionAndOffset> member(const Body& body, const Key& key,
                                                 const Vector3<double>& centre) {
    const auto inside =
        certainly_pulled(body, Vector3<double>(key.base + key.offset), centre, coarse_pull);
    if (!inside) return std::nullopt;
    return PositionAndOffset{*inside};
  }

  // [early-overlap]
  /// Whether bounds prove that the simplex has the origin inside, or is closer to it than the
  /// radii: for its differences are those of points of both cores, or of smooth bodies. As for
  /// overlap_proved(), no plane separates the bodies then, not even one that both touch.
  bool is_proved_to_overlap() const {
    BoundedDifferences differences(offset_size(a_) + offset_size(b_));
    for (std::size_t i = 0; i < at(count_); ++i) {
      if (!add_pair(differences, of_a_[i], of_b_[i])) return false;
    }
    const double reach = sum_down(radius_of(a_), radius_of(b_));
    return (reach > 0 && differences.distance_up(weights_) < reach) ||
           differences.certainly_surround() || (count_ == 4 && has_common_inner_point());
  }
  // [/early-overlap]

  // [early-surrounded]
  /// Whether three vertices and the farthest ones on both sides of their plane certainly surround
  /// the origin, also where it is in the plane itself: for each pair of them, the plane through
  /// both and the origin has vertices certainly on both sides. By surrounds_origin() that suffices.
  bool is_surrounded() const {
    if (count_ < 3) return false;
    int least = 3;
    for (int i = 0; i < 3 && count_ == 4; ++i) {
      if (weights_[at(i)] < weights_[at(least)]) least = i;
    }
    BoundedDifferences differences(offset_size(a_) + offset_size(b_));
    std::array<Vector3<double>, 3> corner;
    std::size_t found = 0;
    for (int i = 0; i < count_; ++i) {
      if (i == least) continue;
      if (!add_pair(differences, of_a_[at(i)], of_b_[at(i)])) return false;
      corner[found++] = w_[at(i)];
    }
    const Vector3<double> n =
        cross_plain(Vector3<double>(corner[1] - corner[0]), Vector3<double>(corner[2] - corner[0]));
    const Vector3<double> opposite = -n;
    if (!add_pair(differences, core_a_.farthest(n), core_b_.farthest(opposite)) ||
        !add_pair(differences, core_a_.farthest(opposite), core_b_.farthest(n))) {
      return false;
    }
    for (std::size_t i = 0; i < differences.count(); ++i) {
      for (std::size_t j = i + 1; j < differences.count(); ++j) {
        bool positive = false, negative = false;
        for (std::size_t k = 0; k < differences.count(); ++k) {
          const int sign = k == i || k == j ? 0 : differences.certain_sign_of_volume(i, j, k);
          positive = positive || sign > 0;
          negative = negative || sign < 0;
        }
        if (!positive || !negative) return false;
      }
    }
    return true;
  }
  // [/early-surrounded]
  bool add_pair(BoundedDifferences& differences, const KeyA& p, const KeyB& q) const {
    const auto of_a = member(a_, p, centre_a_);
    const auto of_b = member(b_, q, centre_b_);
    if (of_a && of_b) differences.add(*of_a, *of_b);
    return of_a && of_b;
  }

  static Vector3<double> point_of(const PositionAndOffset& p) { return p.position + p.offset; }

  // [early-common-point]
  /// Whether a point near the weighted mean of the tetrahedron's, or halfway from it to one of
  /// them, is certainly inside a smooth body, and in the other one: of bodies that overlap by
  /// little the tetrahedron is too thin.
  ///
  /// An inner point of one body that the other contains proves an overlap: a plane with both on its
  /// two sides, perhaps touched, would have the inner point strictly on one side and not on the
  /// other.
  bool has_common_inner_point() const {
    if constexpr (SmoothBody<A> && SmoothBody<B>) {
      Vector3<double> p = Vector3<double>::Zero();
      for (std::size_t i = 0; i < 4; ++i) {
        p += (of_a_[i].base + of_a_[i].offset) * weights_[i];
      }
      if (is_inner_nearby(p)) return true;
      for (std::size_t i = 0; i < 4; ++i) {
        const Vector3<double> of_a = of_a_[i].base + of_a_[i].offset;
        const Vector3<double> of_b = of_b_[i].base + of_b_[i].offset;
        if (is_inner_nearby((p + of_a) * 0.5) || is_inner_nearby((p + of_b) * 0.5)) return true;
      }
      return false;
    } else if constexpr (SmoothBody<A>) {
      return has_inner_point_of_core(a_, b_, of_b_);
    } else if constexpr (SmoothBody<B>) {
      return has_inner_point_of_core(b_, a_, of_a_);
    } else {
      return false;
    }
  }
  /// Whether a point near p is certainly inside of both, farther inside one of them.
  bool is_inner_nearby(const Vector3<double>& p) const {
    const double size = p.cwiseAbs().maxCoeff() + (p - centre_a_).cwiseAbs().maxCoeff();
    for (double share = 0x1p-48; share < 0x1p-5; share *= 64) {
      if (is_inside_both(farther_inside(a_, p, centre_a_, share * size)) ||
          is_inside_both(farther_inside(b_, p, centre_b_, share * size))) {
        return true;
      }
    }
    return false;
  }
  bool is_inside_both(const Vector3<double>& p) const {
    return certainly_inside(a_, p) && certainly_inside(b_, p);
  }
  /// The same for a smooth body and four vertices of a core: of their weighted mean, of themselves
  /// and of the points halfway from it.
  ///
  /// A computed point is off by less than r = 64 u of the largest coordinate: a vertex has at most
  /// six roundings, the mean seven more. The body is convex and has the six points at 2 r along the
  /// axes inside, so also the ball of r about the point, and the exact point of the core.
  template <SmoothBody Body, PolytopeCore Core>
  bool has_inner_point_of_core(const Body& body, const Core& core,
                               const std::array<int, 4>& of_core) const {
    std::array<Vector3<double>, 4> corner;
    Vector3<double> mean = Vector3<double>::Zero();
    double largest = 0, sum = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const PositionAndOffset p = vertex_from_position(core, of_core[i]);
      corner[i] = point_of(p);
      mean += corner[i] * weights_[i];
      sum += weights_[i];
      largest = std::max(largest, p.position.cwiseAbs().maxCoeff());
    }
    largest += offset_size(core);
    if (!(std::abs(sum - 1) < 0x1p-50)) return false;
    const double room = 0x1p-46 * largest;
    const auto is_inner = [&](const Vector3<double>& p) {
      for (int i = 0; i < 3; ++i) {
        const Vector3<double> step = Vector3<double>::Unit(i) * room;
        if (!certainly_inside(body, Vector3<double>(p + step)) ||
            !certainly_inside(body, Vector3<double>(p - step))) {
          return false;
        }
      }
      return true;
    };
    if (is_inner(mean)) return true;
    return std::any_of(corner.begin(), corner.end(), [&](const Vector3<double>& p) {
      return is_inner(p) || is_inner(Vector3<double>((p + mean) * 0.5));
    });
  }
  // [/early-common-point]
};

// [early-decision]
/// Whether two bodies are disjoint or overlap, if GJK comes upon a proof before it knows their
/// distance; undecided means nothing.
///
/// A result of disjoint is proved by separation_down(), which bounds the separation along a
/// direction with all rounding; a result of overlapping by bounds on the differences of points of
/// both bodies. So it is right wherever direction and points came from.
template <ConvexBody A, ConvexBody B>
Proximity early_decision(const A& a, const B& b) {
  if (!is_convex_body(a) || !is_convex_body(b)) return Proximity::undecided;
  return EarlyDecision<A, B>(a, b).run();
}
// [/early-decision]

}  // namespace contact::detail
