/// @file
/// Methods of textbooks and tutorials, to compare with: closest points with an epsilon, separating
/// axes with an epsilon, GJK that only says yes or no.
#pragma once

#include <algorithm>
#include <cmath>
#include <contact/box_axes.hpp>
#include <contact/support.hpp>
#include <contact/vector.hpp>
#include <vector>

namespace hard_methods {

using V = contact::Vector3<double>;
using Capsule = contact::Capsule<double>;
using Box = contact::OrientedBox<double>;

/// The closest points of two segments as in most textbooks: a 2 × 2 system, with an epsilon for
/// parallel lines, and two clamps in sequence.
inline double textbook_distance(const Capsule& a, const Capsule& b) {
  const V d = a.core.end - a.core.start;
  const V e = b.core.end - b.core.start;
  const V w = a.core.start - b.core.start;
  const double dd = d.dot(d), ee = e.dot(e), f = e.dot(w);
  double s = 0, t = 0;
  const double epsilon = 1e-12;
  if (dd <= epsilon && ee <= epsilon) {
  } else if (dd <= epsilon) {
    t = std::clamp(f / ee, 0.0, 1.0);
  } else if (ee <= epsilon) {
    s = std::clamp(-d.dot(w) / dd, 0.0, 1.0);
  } else {
    const double c = d.dot(w), de = d.dot(e), det = dd * ee - de * de;
    s = det > epsilon ? std::clamp((de * f - c * ee) / det, 0.0, 1.0) : 0.0;
    t = (de * s + f) / ee;
    if (t < 0) {
      t = 0;
      s = std::clamp(-c / dd, 0.0, 1.0);
    } else if (t > 1) {
      t = 1;
      s = std::clamp((de - c) / dd, 0.0, 1.0);
    }
  }
  const V between = (a.core.start + d * s) - (b.core.start + e * t);
  return between.norm() - a.radius - b.radius;
}

/// The separation of two boxes along normalised axes; cross products are normalised however short
/// they are, and left out only if they are not longer than `skip_below`.
inline double textbook_room(const Box& a, const Box& b, double skip_below) {
  double most = -INFINITY;
  for (int k = 0; k < contact::box_axis_count; ++k) {
    const V n = contact::box_axis(a, b, k);
    const double length = n.norm();
    if (!(length > skip_below)) continue;
    most = std::max(most, contact::separation_along<double>(a, b, V(n / length)));
  }
  return most;
}

/// Whether two boxes meet as in OBBTree and most copies of it: a small number is added to each
/// |aᵢ · bⱼ|, so that cross products of almost parallel edges separate nothing.
inline bool meet_with_added_epsilon(const Box& a, const Box& b) {
  constexpr double epsilon = 1e-6;
  const contact::Matrix3<double> r = a.axes.transpose() * b.axes;
  const V t = a.axes.transpose() * V(b.centre - a.centre);
  const contact::Matrix3<double> size = r.cwiseAbs() + contact::Matrix3<double>::Constant(epsilon);
  const V& g = a.half_lengths;
  const V& h = b.half_lengths;
  for (int i = 0; i < 3; ++i) {
    if (std::abs(t(i)) > g(i) + V(size.row(i)).dot(h)) return false;
    if (std::abs(V(r.col(i)).dot(t)) > V(size.col(i)).dot(g) + h(i)) return false;
    for (int k = 0; k < 3; ++k) {
      const int i1 = (i + 1) % 3, i2 = (i + 2) % 3, k1 = (k + 1) % 3, k2 = (k + 2) % 3;
      const double of_a = g(i1) * size(i2, k) + g(i2) * size(i1, k);
      const double of_b = h(k1) * size(i, k2) + h(k2) * size(i, k1);
      if (std::abs(t(i2) * r(i1, k) - t(i1) * r(i2, k)) > of_a + of_b) return false;
    }
  }
  return true;
}

namespace detail {

/// The simplex of a tutorial, its newest vertex first.
struct Tutorial {
  std::vector<V> simplex;
  V direction;

  void keep(std::vector<V> vertices, const V& towards) {
    simplex = std::move(vertices);
    direction = towards;
  }
  void line() {
    const V a = simplex[0], b = simplex[1], ab = b - a;
    if (ab.dot(-a) > 0) return keep({a, b}, ab.cross(-a).cross(ab));
    keep({a}, -a);
  }
  void triangle() {
    const V a = simplex[0], b = simplex[1], c = simplex[2];
    const V ab = b - a, ac = c - a, n = ab.cross(ac);
    if (n.cross(ac).dot(-a) > 0) {
      if (ac.dot(-a) > 0) return keep({a, c}, ac.cross(-a).cross(ac));
      keep({a, b}, direction);
      return line();
    }
    if (ab.cross(n).dot(-a) > 0) {
      keep({a, b}, direction);
      return line();
    }
    if (n.dot(-a) > 0) return keep({a, b, c}, n);
    keep({a, c, b}, -n);
  }
  /// Whether the origin is in the tetrahedron.
  bool tetrahedron() {
    const V a = simplex[0], b = simplex[1], c = simplex[2], d = simplex[3];
    const V ab = b - a, ac = c - a, ad = d - a;
    if (ab.cross(ac).dot(-a) > 0) {
      keep({a, b, c}, direction);
    } else if (ac.cross(ad).dot(-a) > 0) {
      keep({a, c, d}, direction);
    } else if (ad.cross(ab).dot(-a) > 0) {
      keep({a, d, b}, direction);
    } else {
      return true;
    }
    triangle();
    return false;
  }
};

/// The farthest point of the whole body.
template <class Body>
V farthest(const Body& body, const V& n) {
  const V core = contact::support(body, n);
  const double radius = contact::radius_of(body);
  return radius > 0 ? V(core + n.normalized() * radius) : core;
}

}  // namespace detail

/// Whether two bodies meet by the GJK of tutorials: yes if a tetrahedron of differences contains
/// the origin, no if a support does not pass it, and yes after 64 steps.
template <class A, class B>
bool meet_by_tutorial(const A& a, const B& b) {
  const auto farthest = [&](const V& n) {
    return V(detail::farthest(a, n) - detail::farthest(b, V(-n)));
  };
  detail::Tutorial state;
  state.simplex = {farthest(V::UnitX())};
  state.direction = -state.simplex[0];
  for (int step = 0; step < 64; ++step) {
    const V next = farthest(state.direction);
    if (next.dot(state.direction) <= 0) return false;
    state.simplex.insert(state.simplex.begin(), next);
    if (state.simplex.size() == 2)
      state.line();
    else if (state.simplex.size() == 3)
      state.triangle();
    else if (state.tetrahedron())
      return true;
  }
  return true;
}

}  // namespace hard_methods
