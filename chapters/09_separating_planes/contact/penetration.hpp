/// @file
/// The depth of penetration of two convex bodies by an expanding polytope (EPA), with exact
/// orientation predicates.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>
#include <vector>

#include <contact/exact_gjk.hpp>
#include <contact/exact_support.hpp>
#include <contact/gjk.hpp>
#include <contact/gjk_cores.hpp>
#include <contact/gjk_simplex.hpp>
#include <contact/orientation.hpp>
#include <contact/signed_distance_result.hpp>
#include <contact/support.hpp>
#include <contact/tolerance.hpp>
#include <contact/vector.hpp>

namespace contact {

// [penetration]
/// How deep the cores of two bodies A and B are in each other. on_a − on_b = −depth normal, up to
/// `excess`.
template <FloatOrDouble S>
struct Penetration {
  S depth = S(0);   ///< m: a translation of A by it along the normal separates; < 0: disjoint
  S excess = S(0);  ///< the shortest such translation is at most this shorter, up to rounding, m
  Vector3<S> normal = Vector3<S>::Zero();  ///< unit vector, from B to A
  Vector3<S> on_a = Vector3<S>::Zero();    ///< of A's core, or of a smooth A, m
  Vector3<S> on_b = Vector3<S>::Zero();    ///< of B's core, or of a smooth B, m
  int iterations = 0;                      ///< pairs of supports computed
};
// [/penetration]

namespace detail {

/// The polytope of differences of points of A and B that grows until one of its faces is also a
/// plane of support of all differences.
template <ConvexBody A, ConvexBody B>
class ExpandingPolytope {
 public:
  using S = ScalarOf<A>;
  ExpandingPolytope(const A& a, const B& b) : a_(a), b_(b) {}

  Penetration<ScalarOf<A>> run();

 private:
  struct Vertex {
    Vector3<S> w, of_a, of_b;  // w = of_a − of_b
    DifferenceIndex of;        // which vertices, of polytopes
  };
  struct Face {
    std::array<int, 3> v;  // counter-clockwise, seen from outside
    Vector3<S> normal;     // outward, unit vector
    S offset;              // normal · w on the face
    S support;  // largest normal · w of all differences if that is the offset, else infinity
    bool tested = false;
  };

  const A& a_;
  const B& b_;
  std::vector<Vertex> vertices_;
  std::vector<Face> faces_;
  S size_ = S(0);    // largest coordinate
  S extent_ = S(0);  // largest coordinate of a difference
  int iterations_ = 0;
  S min_support_ = std::numeric_limits<S>::infinity();  // of all faces whose support is known

  static constexpr bool smooth = SmoothBody<A> || SmoothBody<B>;
  static constexpr int max_iterations = 160;

  const Vector3<S>& w(int i) const { return vertices_[static_cast<std::size_t>(i)].w; }
  Vertex farthest(const Vector3<S>& n) {
    ++iterations_;
    DifferenceIndex of;
    Vector3<S> p, q;
    if constexpr (smooth) {
      p = support(a_, n);
      q = support(b_, Vector3<S>(-n));
    } else {
      of = {support_vertex(a_, n), support_vertex(b_, Vector3<S>(-n))};
      p = vertex(a_, of.a);
      q = vertex(b_, of.b);
    }
    const Vector3<S> between = p - q;
    size_ = std::max({size_, p.cwiseAbs().maxCoeff(), q.cwiseAbs().maxCoeff()});
    extent_ = std::max(extent_, between.cwiseAbs().maxCoeff());
    return {between, p, q, of};
  }
  /// By how much a face may fail to be a plane of support: rounding, and for smooth bodies, on
  /// which faces get smaller and smaller, 2^-40 of the largest difference.
  S tolerance() const {
    constexpr S u = tolerance::unit_roundoff<S>;
    constexpr S curved = std::same_as<S, double> ? S(0x1p-40) : S(0x1p-20);
    return std::max(16 * u * size_, smooth ? curved * extent_ : S(0));
  }
  static Vector3<double> wide(const Vector3<S>& v) { return v.template cast<double>(); }
  /// Whether p is in front of the face, without error.
  bool is_visible(const Face& f, const Vector3<S>& p) const {
    return orient_3d(wide(w(f.v[0])), wide(w(f.v[1])), wide(w(f.v[2])), wide(p)) > 0;
  }
  /// Whether three points are certainly not in line. A difference is off by u of itself, so a
  /// product of two by γ(3), and a coordinate of the cross product by less than 8 u of its terms.
  static bool certainly_not_in_line(const Vector3<S>& p, const Vector3<S>& q, const Vector3<S>& r) {
    constexpr S least = std::numeric_limits<S>::min() / std::numeric_limits<S>::epsilon();
    const Vector3<S> d = q - p, e = r - p;
    for (int i = 0; i < 3; ++i) {
      const S one = d((i + 1) % 3) * e((i + 2) % 3), other = d((i + 2) % 3) * e((i + 1) % 3);
      const S room = 8 * tolerance::unit_roundoff<S> * (std::abs(one) + std::abs(other));
      if (room > least && std::abs(one - other) > room) return true;
    }
    return false;
  }
  /// The unit normal of three vertices, exact but for the last rounding.
  Vector3<S> exact_normal(int i, int j, int k) const {
    const Vector3<Exact> p = exact_vector<S>(w(i));
    const Vector3<Exact> d = exact_vector<S>(w(j)) - p, e = exact_vector<S>(w(k)) - p;
    const Vector3<double> direction = rounded_direction(d.cross(e));
    return unit_of_any_size<double>(direction).template cast<S>();
  }
  Face face(int i, int j, int k) const {
    const Vector3<S> e = w(j) - w(i), f = w(k) - w(i), g = w(k) - w(j);
    // From the two shorter edges, whose cross product is the most accurate.
    const S ee = e.dot(e), ff = f.dot(f), gg = g.dot(g), longest = std::max({ee, ff, gg});
    Vector3<S> n = e.cross(f);
    if (ee == longest) n = f.cross(g);
    if (ff == longest) n = e.cross(g);
    const bool thin = smooth && !(n.dot(n) > min_height() * min_height() * longest);
    if (!thin && !(n.dot(n) > S(0x1p-20) * longest * std::min({ee, ff, gg}))) {
      n = exact_normal(i, j, k);
    } else {
      n = unit_of_any_size<S>(n);
    }
    constexpr S infinity = std::numeric_limits<S>::infinity();
    return {{i, j, k}, n, thin ? infinity : n.dot(w(i)), infinity, thin};
  }
  /// Faces of smooth bodies that are thinner are not tested: their normals are rounding, as between
  /// points on the rim of a cap. Their neighbours bound what is beyond them.
  S min_height() const {
    constexpr S curved = std::same_as<S, double> ? S(0x1p-32) : S(0x1p-16);
    return std::max(64 * tolerance::unit_roundoff<S> * size_, curved * extent_);
  }
  /// The point of a face that is closest to the origin.
  SimplexPoint<S> closest(const Face& f) const {
    return closest_of_simplex<S>({w(f.v[0]), w(f.v[1]), w(f.v[2]), Vector3<S>::Zero()}, 3);
  }

  bool begin();
  bool add(const Vertex& p);
  Penetration<ScalarOf<A>> flat() const;
  void use_exact_plane(const Face& f, Penetration<S>& found) const;
  bool descend(Penetration<S>& found);
  Penetration<ScalarOf<A>> result();
};

// [epa-begin]
/// A first tetrahedron with a volume: the farthest points along a direction, perpendicular to the
/// line through them, and to the plane through the three.
/// @return false if there is none, because all differences are in a plane; what there is of
/// vertices spans it
template <ConvexBody A, ConvexBody B>
bool ExpandingPolytope<A, B>::begin() {
  const auto differs = [this](const Vertex& p) {
    const auto count = vertices_.size();
    if (count == 1) return p.w != w(0);
    if (count == 2) {
      if (certainly_not_in_line(w(0), w(1), p.w)) return true;
      const Vector3<Exact> d = exact_vector<S>(w(1)) - exact_vector<S>(w(0));
      const Vector3<Exact> e = exact_vector<S>(p.w) - exact_vector<S>(w(0));
      return d.cross(e) != Vector3<Exact>::Zero();
    }
    return orient_3d(wide(w(0)), wide(w(1)), wide(w(2)), wide(p.w)) != 0;
  };
  const auto try_along = [&](const Vector3<S>& n) {
    Vertex best = farthest(n);
    const Vertex other = farthest(Vector3<S>(-n));
    const S along = n.dot(w(0));
    if (std::abs(n.dot(other.w) - along) > std::abs(n.dot(best.w) - along)) best = other;
    if (!differs(best)) return false;
    vertices_.push_back(best);
    return true;
  };
  vertices_.push_back(farthest(Vector3<S>::UnitX()));
  bool found = false;
  for (int i = 0; i < 3 && !found; ++i) found = try_along(Vector3<S>::Unit(i));
  if (!found) return false;
  const Vector3<S> d = unit_of_any_size<S>(Vector3<S>(w(1) - w(0)));
  const Vector3<S> across = perpendicular_to<S>(d);
  if (!try_along(across) && !try_along(Vector3<S>(d.cross(across)))) return false;
  if (!try_along(exact_normal(0, 1, 2))) return false;
  if (orient_3d(wide(w(0)), wide(w(1)), wide(w(2)), wide(w(3))) > 0) {
    std::swap(vertices_[0], vertices_[1]);
  }
  faces_ = {face(0, 1, 2), face(0, 3, 1), face(1, 3, 2), face(2, 3, 0)};
  return true;
}
// [/epa-begin]

// [epa-add]
/// Replaces the faces in front of which p is by those between their outline and p.
/// @return false if p is in front of none
template <ConvexBody A, ConvexBody B>
bool ExpandingPolytope<A, B>::add(const Vertex& p) {
  std::vector<std::array<int, 2>> edges;
  std::vector<Face> kept;
  kept.reserve(faces_.size() + 2);
  for (const Face& f : faces_) {
    if (!is_visible(f, p.w)) {
      kept.push_back(f);
      continue;
    }
    for (std::size_t i = 0; i < 3; ++i) edges.push_back({f.v[i], f.v[(i + 1) % 3]});
  }
  if (edges.empty()) return false;
  const int index = static_cast<int>(vertices_.size());
  vertices_.push_back(p);
  for (const auto& edge : edges) {
    const std::array<int, 2> reverse{edge[1], edge[0]};
    if (std::find(edges.begin(), edges.end(), reverse) != edges.end()) continue;
    kept.push_back(face(edge[0], edge[1], index));
  }
  faces_ = std::move(kept);
  return true;
}
// [/epa-add]

// [epa-run]
/// The face whose plane has the least offset is tested first: if no difference is in front of it,
/// its plane is one of support, and no other has a smaller offset. The point of that plane that is
/// closest to the origin may be on another face in the same plane: then such faces are tested too.
template <ConvexBody A, ConvexBody B>
Penetration<ScalarOf<A>> ExpandingPolytope<A, B>::run() {
  if (!begin()) return flat();
  bool done = false;
  while (!done && iterations_ < max_iterations) {
    Face* next = nullptr;
    for (Face& f : faces_) {
      if (f.tested) continue;
      if (next == nullptr || f.offset < next->offset) next = &f;
    }
    if (next == nullptr || !(next->offset <= min_support_ + tolerance())) break;
    const Vertex p = farthest(next->normal);
    const S along = next->normal.dot(p.w);
    const bool supports = along - next->offset <= tolerance();
    if (!supports && add(p)) continue;
    next->tested = true;
    if (!supports) continue;  // rounding alone has placed p in front of the face
    next->support = along;
    min_support_ = std::min(min_support_, along);
    done = length<S>(closest(*next).point) <= along + tolerance();
  }
  return result();
}
// [/epa-run]

/// Of the faces whose plane of support has the least offset the one with the closest point. Without
/// any such plane, because there were too many steps, of all faces that with the least support,
/// plus the distance by which the closest point is beside the normal.
template <ConvexBody A, ConvexBody B>
Penetration<ScalarOf<A>> ExpandingPolytope<A, B>::result() {
  constexpr S infinity = std::numeric_limits<S>::infinity();
  Penetration<S> found;
  S least = infinity, lower = infinity, nearest = infinity;
  for (const Face& f : faces_) {
    least = std::min(least, f.support);
    lower = std::min(lower, f.offset);
  }
  const bool known = std::isfinite(least);
  const Face* best = nullptr;
  SimplexPoint<S> best_point;
  for (const Face& f : faces_) {
    if (known ? !(f.support <= least + tolerance()) : !std::isfinite(f.offset)) continue;
    const SimplexPoint<S> point = closest(f);
    S rank = length<S>(point.point);
    if (!known) {
      rank = f.normal.dot(farthest(f.normal).w) +
             length<S>(Vector3<S>(point.point - f.normal * f.offset));
    }
    if (best == nullptr || rank < nearest) {
      best = &f;
      best_point = point;
      nearest = rank;
    }
  }
  if (best == nullptr) return flat();  // all faces are too thin
  found.normal = -best->normal;
  found.depth = best->normal.dot(farthest(best->normal).w);
  if constexpr (!smooth) use_exact_plane(*best, found);
  if constexpr (smooth) {
    if (!known && descend(found)) {
      found.excess = std::max(S(found.depth - lower), S(0));
      found.iterations = iterations_;
      return found;
    }
  }
  found.excess = std::max(S(found.depth - lower), S(0));
  found.iterations = iterations_;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vertex& v = vertices_[static_cast<std::size_t>(best->v[i])];
    found.on_a += v.of_a * best_point.weights[i];
    found.on_b += v.of_b * best_point.weights[i];
  }
  return found;
}

// [epa-descend]
/// From the best direction downhill to a local minimum of the support, for smooth bodies whose
/// depth is similar in many directions: there faces get smaller too slowly.
///
/// The gradient on the sphere is the part of the farthest difference that is perpendicular to the
/// normal. Its change over a small angle gives the step (Newton's method along the gradient).
/// @return whether the gradient has become small, so that the two points are opposite
template <ConvexBody A, ConvexBody B>
bool ExpandingPolytope<A, B>::descend(Penetration<S>& found) {
  constexpr S angle = std::same_as<S, double> ? S(0x1p-20) : S(0x1p-9);
  constexpr S small = std::same_as<S, double> ? S(0x1p-26) : S(0x1p-12);
  Vector3<S> n = -found.normal;
  Vertex p = farthest(n);
  for (int i = 0; i < 40; ++i) {
    const S support = n.dot(p.w);
    const Vector3<S> gradient = p.w - n * support;
    const S slope = length<S>(gradient);
    if (slope <= small * extent_) {
      if (support > found.depth + tolerance()) return false;
      found.normal = -n;
      found.depth = support;
      found.on_a = p.of_a;
      found.on_b = p.of_b;
      return true;
    }
    const Vector3<S> down = gradient / -slope;
    const auto at = [&](const S& t) { return unit_of_any_size<S>(Vector3<S>(n + down * t)); };
    const Vector3<S> beside = at(angle);
    const S slope_beside = -down.dot(farthest(beside).w) + beside.dot(down) * support;
    const S curvature = (slope - slope_beside) / angle;
    S step = curvature > S(0) ? std::min(S(slope / curvature), S(1)) : S(1);
    Vertex next = farthest(at(step));
    for (int k = 0; k < 30 && !(at(step).dot(next.w) < support); ++k) {
      step /= S(2);
      next = farthest(at(step));
    }
    if (!(at(step).dot(next.w) < support)) return false;
    n = at(step);
    p = next;
  }
  return false;
}
// [/epa-descend]

/// The plane of a face through exact differences of vertices, rounded once: that through rounded
/// ones is turned by u divided by the smallest height of the face.
template <ConvexBody A, ConvexBody B>
void ExpandingPolytope<A, B>::use_exact_plane(const Face& f, Penetration<S>& found) const {
  const auto first = in_double(a_);
  const auto second = in_double(b_);
  std::array<Vector3<Exact>, 3> exact;
  for (std::size_t i = 0; i < 3; ++i) {
    exact[i] = exact_difference(first, second, vertices_[static_cast<std::size_t>(f.v[i])].of).w;
  }
  const Vector3<Exact> n =
      Vector3<Exact>(exact[1] - exact[0]).cross(Vector3<Exact>(exact[2] - exact[0]));
  const Vector3<double> direction = rounded_direction(n);
  const Vector3<double> unit = normalised<double>(direction);
  if (!(unit.dot(f.normal.template cast<double>()) > 0.5)) return;
  const Exact scale = std::max({abs(n.x()), abs(n.y()), abs(n.z())});
  const Exact offset = n.dot(exact[0]);
  found.normal = Vector3<S>(-unit.template cast<S>());
  found.depth = static_cast<S>(quotient<double>(offset, scale) / length(direction));
}

/// Differences in a plane, on a line or all equal: the depth is 0, perpendicular to them.
template <ConvexBody A, ConvexBody B>
Penetration<ScalarOf<A>> ExpandingPolytope<A, B>::flat() const {
  Penetration<S> found;
  found.iterations = iterations_;
  if (vertices_.size() >= 3) {
    found.normal = exact_normal(0, 1, 2);
  } else {
    found.normal = perpendicular_to<S>(
        vertices_.size() == 2 ? unit_of_any_size<S>(Vector3<S>(w(1) - w(0))) : Vector3<S>::Zero());
  }
  const GjkResult<S> near = gjk(a_, b_);
  found.on_a = near.on_a;
  found.on_b = near.on_b;
  return found;
}

}  // namespace detail

// [epa]
/// The depth of penetration of the cores of two bodies that meet, rounded.
///
/// The shortest translation that separates leads from the origin to the boundary of the differences
/// of their points (Minkowski difference), that is to a plane of support with the least distance.
/// The polytope is the hull of some differences. Its orientation predicates are exact, so it is
/// convex and closed whatever rounding does to lengths and normals, where other programs go astray
/// with thin bodies; the answer's direction is one whose plane of support was computed.
///
/// The origin may also be outside by little: then the depth is negative.
///
/// Limits: of polytopes, depth and translation are right to a few u of the coordinates; of smooth
/// bodies to 2^-40 of them, which rotates the normal by about 2^-20 (float: 2^-20, 2^-10). The
/// polytope stops after 160 faces, as it does for bodies with the same centre that are equally deep
/// in many directions. Then the best direction found is followed downhill; `excess` bounds by how
/// much the depth can be too large.
/// @param a, b finite, of any size
/// @see van den Bergen, *Proximity Queries and Penetration Depth Computation on 3D Game Objects*,
/// Game Developers Conference 2001
template <ConvexBody A, ConvexBody B>
requires std::same_as<ScalarOf<A>, ScalarOf<B>> Penetration<ScalarOf<A>> penetration(const A& a,
                                                                                     const B& b) {
  using S = ScalarOf<A>;
  const int power =
      detail::scale_power(std::max(gjk_detail::largest_number(a), gjk_detail::largest_number(b)));
  if (power == 0) return detail::ExpandingPolytope<A, B>(a, b).run();
  const A first = gjk_detail::times_power_of_two(a, -power);
  const B second = gjk_detail::times_power_of_two(b, -power);
  Penetration<S> found = detail::ExpandingPolytope<A, B>(first, second).run();
  found.depth = std::ldexp(found.depth, power);
  found.excess = std::ldexp(found.excess, power);
  found.on_a = detail::times_power_of_two(found.on_a, power);
  found.on_b = detail::times_power_of_two(found.on_b, power);
  return found;
}
// [/epa]

}  // namespace contact
