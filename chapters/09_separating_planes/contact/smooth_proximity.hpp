/// @file
/// Disjoint, touching or overlapping with a proof, where a body is a cylinder or an ellipsoid. Such
/// pairs can stay undecided, with bounds of the distance.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

#include <contact/certificates.hpp>
#include <contact/certified_cores.hpp>
#include <contact/exact_gjk.hpp>
#include <contact/gjk.hpp>
#include <contact/inside_points.hpp>
#include <contact/proximity_cases.hpp>
#include <contact/support.hpp>
#include <contact/surrounding_set.hpp>
#include <contact/vector.hpp>

namespace contact {

namespace detail {

/// A point of the whole body, close to the farthest along n.
template <ConvexBody Body>
Member farthest_member(const Body& body, const Vector3<double>& n, const Vector3<double>& inner) {
  if constexpr (PolytopeCore<Body>) {
    const double radius = radius_of(body);
    const Member core{support_vertex(body, n), Vector3<double>::Zero()};
    if (!(radius > 0)) return core;
    const Vector3<double> p =
        Vector3<double>(vertex(body, core.vertex)) + unit_of_any_size<double>(n) * radius;
    const Member pulled = pulled_inside(body, p, inner, no_pull);
    return pulled.vertex == -1 ? pulled : core;
  } else {
    return pulled_inside(body, support(body, n), inner, no_pull);
  }
}

/// The points of GJK's simplex as members: vertices of cores, and points of smooth bodies pulled
/// inside. Without members if some point cannot be.
template <ConvexBody A, ConvexBody B>
CommonPointProof pulled_members(const GjkResult<double>& near, const A& a, const B& b,
                                double first) {
  CommonPointProof common;
  set_members(common, near);
  const Vector3<double> of_a = inner_point(a), of_b = inner_point(b);
  for (std::size_t i = 0; i < std::size_t(near.count); ++i) {
    const GjkVertex<double>& v = near.simplex[i];
    if constexpr (SmoothBody<A>) common.of_a[i] = pulled_inside(a, v.of_a, of_a, first);
    if constexpr (SmoothBody<B>) common.of_b[i] = pulled_inside(b, v.of_b, of_b, first);
    if (common.of_a[i].vertex < -1 || common.of_b[i].vertex < -1) return {};
  }
  return common;
}

/// Directions along which features of a body can touch, of length 1 or 0: axes of a cylinder, edges
/// of a polytope and normals of its faces. Not those of a hull, which has too many.
template <ConvexBody Body>
std::vector<Vector3<double>> feature_directions(const Body& body) {
  using S = ScalarOf<Body>;
  std::vector<Vector3<double>> list;
  const auto add = [&list](const Vector3<double>& d) {
    list.push_back(unit_of_any_size<double>(d));
  };
  if constexpr (std::same_as<Body, Capsule<S>> || std::same_as<Body, Cylinder<S>>) {
    add(body.core.end - body.core.start);
  } else if constexpr (std::same_as<Body, Lozenge<S>>) {
    add(body.first_edge);
    add(body.second_edge);
    add(list[0].cross(list[1]));
  } else if constexpr (std::same_as<Body, Triangle<S>>) {
    add(body.b - body.a);
    add(body.c - body.a);
    add(body.c - body.b);
    add(list[0].cross(list[1]));
  } else if constexpr (std::same_as<Body, OrientedBox<S>>) {
    for (int i = 0; i < 3; ++i) add(body.axes.col(i));
  }
  return list;
}

/// The search for a proof about two bodies of which one is smooth.
template <ConvexBody A, ConvexBody B>
class SmoothSearch {
 public:
  SmoothSearch(const A& a, const B& b)
      : a_(a), b_(b), inner_a_(inner_point(a)), inner_b_(inner_point(b)) {}

  // [smooth-search]
  /// GJK first: its direction may separate, its closest points or its tetrahedron may prove an
  /// overlap. Then directions of features, then normals and supports in turns as for polytopes. All
  /// that is found is proved by bounds or exactly; what is not stays undecided.
  CertifiedProximity run(const GjkStart<double>& start) {
    const GjkResult<double> near = gjk(a_, b_, start);
    const bool apart = try_plane(near.between);
    if (use_members(pulled_members(near, a_, b_, coarse_pull)) || apart) return answer_;
    if (use_members(pulled_members(near, a_, b_, no_pull))) return answer_;
    if (!try_features() && !surround()) try_touching(near);
    return answer_;
  }
  // [/smooth-search]

 private:
  static constexpr int max_steps = 100;
  const A& a_;
  const B& b_;
  Vector3<double> inner_a_, inner_b_;
  CertifiedProximity answer_;
  std::vector<Vector3<double>> almost_;  // normals that may separate weakly

  /// Whether bounds prove that n separates the bodies; the best lower bound of the distance so far.
  bool try_plane(const Vector3<double>& direction) {
    const Vector3<double> n = unit_of_any_size<double>(direction);
    if (!all_finite(n) || n == Vector3<double>::Zero()) return false;
    const double separation = separation_down(a_, b_, n);
    const double low = along_unit_down(separation, n);
    if (!(low > answer_.low)) return separation > 0;
    answer_.low = low;
    answer_.plane.normal = n;
    if (!(separation > 0)) return false;
    answer_.state = Proximity::disjoint;
    return true;
  }
  bool overlapping(const CommonPointProof& common) {
    answer_ = {Proximity::overlapping, {}, common, 0, 0};
    return true;
  }

  /// Takes an upper bound of the distance from members, which may prove an overlap.
  bool use_members(const CommonPointProof& common) {
    const BoundedDifferences w = bounded_differences(common, a_, b_);
    const Radii radii = radii_beyond(common, a_, b_);
    const double reach = sum_down(radii.of_a, radii.of_b);
    const double between = w.distance_up(common.weights);
    if (between < reach || w.certainly_surround()) return overlapping(common);
    const double high = sum_up(between, -reach);
    if (high < answer_.high) {
      answer_.high = high;
      answer_.common = common;
    }
    return false;
  }

  /// The same for a direction of features, which is remembered if it may separate weakly.
  bool try_feature(const Vector3<double>& n) {
    const double size = std::abs(support_up(a_, n)) + std::abs(support_up(b_, n));
    if (separation_down(a_, b_, n) > -0x1p-40 * size) almost_.push_back(n);
    return try_plane(n);
  }

  /// Tries directions of features of both, and those perpendicular to one of each.
  bool try_features() {
    const auto of_a = feature_directions(a_), of_b = feature_directions(b_);
    const auto either = [this](const Vector3<double>& n) {
      return try_feature(n) || try_feature(Vector3<double>(-n));
    };
    for (const Vector3<double>& n : of_a) {
      if (either(n)) return true;
    }
    for (const Vector3<double>& n : of_b) {
      if (either(n)) return true;
    }
    for (const Vector3<double>& d : of_a) {
      for (const Vector3<double>& e : of_b) {
        if (either(d.cross(e))) return true;
      }
    }
    return false;
  }

  // [smooth-surround]
  /// Points of both, farthest along normals that do not separate the points so far: until no normal
  /// is left, which proves an overlap, or one separates, or none of the points helps.
  bool surround() {
    SupportingNormals normals;
    std::vector<std::pair<Member, Member>> members;
    Vector3<Exact> n = exact_vector<double>(Vector3<double>::UnitX());
    for (int step = 0; step < max_steps; ++step) {
      const Vector3<double> m = rounded_direction(n);
      if (try_plane(m)) return true;
      const Member p = farthest_member(a_, Vector3<double>(-m), inner_a_);
      const Member q = farthest_member(b_, m, inner_b_);
      if (p.vertex < -1 || q.vertex < -1) return false;
      const int index = static_cast<int>(members.size());
      const ExactDifference w{{index, index}, exact_member(p, a_) - exact_member(q, b_)};
      if (step > 0 && n.dot(w.w).sign() >= 0) return false;
      members.emplace_back(p, q);
      normals.add(w);
      if (normals.empty()) return surrounded(normals.points(), members);
      n = normals.middle();
    }
    return false;
  }
  // [/smooth-surround]
  bool surrounded(const std::vector<ExactDifference>& points,
                  const std::vector<std::pair<Member, Member>>& members) {
    const std::vector<ExactDifference> few = fewest_surrounding(points);
    CommonPointProof common;
    common.count = static_cast<int>(few.size());
    for (std::size_t i = 0; i < few.size(); ++i) {
      std::tie(common.of_a[i], common.of_b[i]) = members[std::size_t(few[i].of.a)];
    }
    set_weights_for_drawing(common, few);
    return overlapping(common);
  }

  // [smooth-touching]
  /// Tries without rounding those normals that separate up to rounding, and for touching some
  /// points that may be common.
  void try_touching(const GjkResult<double>& near) {
    for (const Vector3<double>& n : almost_) {
      const SeparatingPlane plane{n, Vector3<Exact>::Zero()};
      const int sign = exact_separation_sign(a_, b_, exact_vector<double>(n));
      if (sign < 0) continue;
      answer_.plane = plane;
      answer_.low = 0;
      if (sign > 0) answer_.state = Proximity::disjoint;
      if (sign == 0 && find_common_point(near)) {
        answer_.state = Proximity::touching;
        answer_.high = 0;
      }
      if (answer_.state != Proximity::undecided) return;
    }
  }
  // [/smooth-touching]
  bool find_common_point(const GjkResult<double>& near) {
    if (meeting_proved(answer_.common, a_, b_)) return true;
    std::vector<Vector3<double>> points{near.on_a, near.on_b, inner_a_, inner_b_,
                                        Vector3<double>(near.on_a / 2 + near.on_b / 2)};
    for (std::size_t i = 0; i < std::size_t(near.count); ++i) {
      points.push_back(near.simplex[i].of_a);
      points.push_back(near.simplex[i].of_b);
    }
    for (const Vector3<double>& p : points) {
      if (!contains(a_, p) || !contains(b_, p)) continue;
      CommonPointProof common;
      common.count = 1;
      common.of_a[0] = common.of_b[0] = {-1, p};
      common.weights[0] = 1;
      answer_.common = common;
      return true;
    }
    return false;
  }
};

}  // namespace detail

}  // namespace contact
