/// @file
/// Where two bodies rest on each other: the vertices of the common part of two faces, in fractions,
/// and contact points as they are often chosen.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <contact/hull_manifold.hpp>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "hard_boxes.hpp"
#include "hard_scale.hpp"
#include "support/hard_cases.hpp"

namespace hard_regions {

using hard_boxes::Box;
using hard_cases::Case;
using hard_cases::Json;
using oracle::Rational;
using V = contact::Vector3<double>;
using Hull = contact::ConvexHull<double>;
using Capsule = contact::Capsule<double>;
using Manifold = contact::ContactManifold<double>;

// ------------------------------------------------------------------------------- in the plane

template <class S>
using Point = std::array<S, 2>;
template <class S>
using Points = std::vector<Point<S>>;

template <class S>
S orientation(const Point<S>& p, const Point<S>& q, const Point<S>& r) {
  return S(S(q[0] - p[0]) * S(r[1] - p[1]) - S(q[1] - p[1]) * S(r[0] - p[0]));
}

/// The vertices of the convex hull, counter-clockwise, without points on edges.
template <class S>
Points<S> outline(Points<S> points) {
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  Points<S> hull;
  for (int chain = 0; chain < 2; ++chain) {
    const std::size_t first = hull.size();
    for (const Point<S>& p : points) {
      while (hull.size() >= first + 2 &&
             !(orientation<S>(hull[hull.size() - 2], hull.back(), p) > S(0))) {
        hull.pop_back();
      }
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

/// The part of a polygon with n · x ≤ k; a point of the polygon may appear more than once.
template <class S>
Points<S> clipped(const Points<S>& polygon, const Point<S>& n, const S& k) {
  Points<S> kept;
  const auto above = [&](const Point<S>& p) { return S(S(n[0] * p[0]) + S(n[1] * p[1]) - k); };
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point<S>& here = polygon[i];
    const Point<S>& next = polygon[(i + 1) % polygon.size()];
    const S h = above(here), g = above(next);
    if (!(h > S(0))) kept.push_back(here);
    if ((h < S(0) && g > S(0)) || (h > S(0) && g < S(0))) {
      const S part = h / S(h - g);
      kept.push_back(
          {S(here[0] + S(next[0] - here[0]) * part), S(here[1] + S(next[1] - here[1]) * part)});
    }
  }
  return kept;
}

/// The part of the convex hull of `low` over that of `face`: of a segment, between its ends.
template <class S>
Points<S> common_part(const Points<S>& low, const Points<S>& face) {
  Points<S> part = outline(low);
  const Points<S> sides = outline(face);
  for (std::size_t i = 0; i < sides.size() && sides.size() > 1; ++i) {
    const Point<S>& p = sides[i];
    const Point<S>& q = sides[(i + 1) % sides.size()];
    const Point<S> along{S(q[0] - p[0]), S(q[1] - p[1])};
    const Point<S> out = sides.size() == 2 ? Point<S>{S(S(0) - along[0]), S(S(0) - along[1])}
                                           : Point<S>{along[1], S(S(0) - along[0])};
    part = clipped<S>(part, out, S(S(out[0] * p[0]) + S(out[1] * p[1])));
  }
  return part;
}

inline double gap(const Point<double>& p, const Point<double>& q) {
  return std::max(std::abs(p[0] - q[0]), std::abs(p[1] - q[1]));
}
/// The outline without vertices that coincide, or lie between others, up to `room`.
inline Points<double> simplified(const Points<Rational>& region, double room) {
  Points<double> points;
  for (const Point<Rational>& p : outline(region)) {
    const Point<double> rounded{oracle::nearest(p[0]), oracle::nearest(p[1])};
    const bool known = std::any_of(points.begin(), points.end(),
                                   [&](const auto& q) { return gap(rounded, q) <= room; });
    if (!known) points.push_back(rounded);
  }
  for (std::size_t i = 0; i < points.size() && points.size() > 2;) {
    const Point<double>& p = points[i];
    const Point<double>& before = points[(i + points.size() - 1) % points.size()];
    const Point<double>& after = points[(i + 1) % points.size()];
    const double length = std::hypot(after[0] - before[0], after[1] - before[1]);
    if (std::abs(orientation<double>(before, after, p)) <= room * length) {
      points.erase(points.begin() + static_cast<std::ptrdiff_t>(i));
      i = 0;
    } else {
      ++i;
    }
  }
  return points;
}

// ------------------------------------------------------------------------------------- bodies

struct Body {
  std::variant<Box, Hull, Capsule> shape;
  double radius = 0;
  double room = 0x1p-20;    ///< vertices that lie deeper by this much belong to the highest face
  std::vector<V> vertices;  ///< of the core, as stored or rounded
  std::vector<oracle::Vector> exact;
};
inline Body of_box(const Box& b) {
  Body body;
  body.shape = b;
  const auto exact = shape_oracle::exact(b);
  for (int k = 0; k < 8; ++k) {
    body.vertices.push_back(contact::box_corner(b, k));
    body.exact.push_back(contact::box_corner<Rational>(exact, k));
  }
  return body;
}
/// "a_half" is a box's; "a_points" are the vertices of a hull, or the two ends of a capsule's core.
inline Body body(const Case& c, const std::string& name) {
  Body made;
  if (c.has(name + "_half")) made = of_box(hard_boxes::box(c, name));
  made.room = 0x1p-20 * hard_scale::unit_of_length(c);
  if (c.has(name + "_half")) return made;
  if (c.has(name + "_radius")) made.radius = c.number(name + "_radius");
  const std::vector<double> all = c.numbers(name + "_points");
  for (std::size_t i = 0; i + 2 < all.size(); i += 3) {
    made.vertices.emplace_back(all[i], all[i + 1], all[i + 2]);
    made.exact.push_back(oracle::exact(made.vertices.back()));
  }
  if (made.vertices.size() == 2) {
    made.shape = Capsule{{made.vertices[0], made.vertices[1]}, made.radius};
  } else {
    Hull hull;
    hull.vertices = made.vertices;
    hull.radius = made.radius;
    made.shape = hull;
  }
  return made;
}
/// The direction from B to A is a coordinate axis: "side", from 1 to 3, negative for the other
/// direction.
struct Side {
  int axis;
  double sign;
  V up() const {
    V n = V::Zero();
    n(axis) = sign;
    return n;
  }
  template <class Vector>
  auto height(const Vector& v) const -> std::decay_t<decltype(v(0))> {
    using S = std::decay_t<decltype(v(0))>;
    return sign > 0 ? S(v(axis)) : S(S(0) - v(axis));
  }
  template <class S>
  Point<S> flat(const contact::Vector3<S>& v) const {
    return {v((axis + 1) % 3), v((axis + 2) % 3)};
  }
};
inline Side side(const Case& c) {
  const double number = c.number("side");
  return {static_cast<int>(std::abs(number)) - 1, number > 0 ? 1.0 : -1.0};
}

template <class S>
contact::Vector3<S> vertex_of(const Body& body, std::size_t i) {
  if constexpr (std::is_same_v<S, Rational>) {
    return body.exact[i];
  } else {
    return body.vertices[i].template cast<S>();
  }
}
/// B's vertices within 2^-20 units of length of its highest one, and how high that is.
template <class S>
std::pair<Points<S>, S> top(const Body& b, const Side& s) {
  S highest = s.height(vertex_of<S>(b, 0));
  for (std::size_t i = 1; i < b.vertices.size(); ++i) {
    highest = std::max(highest, S(s.height(vertex_of<S>(b, i))));
  }
  Points<S> face;
  for (std::size_t i = 0; i < b.vertices.size(); ++i) {
    const auto v = vertex_of<S>(b, i);
    if (s.height(v) >= highest - S(b.room)) face.push_back(s.flat<S>(v));
  }
  return {face, S(highest + S(b.radius))};
}
/// A's vertices whose surface is within the margin of B's top.
template <class S>
Points<S> bottom(const Body& a, const Side& s, const S& top_of_b, double margin) {
  Points<S> low;
  for (std::size_t i = 0; i < a.vertices.size(); ++i) {
    const auto v = vertex_of<S>(a, i);
    if (s.height(v) - S(a.radius) - top_of_b <= S(margin)) low.push_back(s.flat<S>(v));
  }
  return low;
}
template <class S>
Points<S> region(const Body& a, const Body& b, const Side& s, double margin) {
  const auto [face, height] = top<S>(b, s);
  return common_part<S>(bottom<S>(a, s, height, margin), face);
}

// ------------------------------------------------------------------------------------- answers

/// What a method says: normals, and points seen along them.
struct Found {
  std::vector<V> normals;
  Points<double> at;
};
inline Json listed(const Points<double>& points) {
  Json at = Json::array();
  for (const Point<double>& p : points) {
    at.push_back(hard_cases::hex(p[0]));
    at.push_back(hard_cases::hex(p[1]));
  }
  return at;
}
/// As many points as there are, each within 2^-16 of the size, and normals within 2^-9.
inline bool right(const Case& c, const Found& found, const Json& answer) {
  const V up = side(c).up();
  for (const V& n : found.normals) {
    if (!((n - up).cwiseAbs().maxCoeff() <= 0x1p-9)) return false;
  }
  const Json& at = answer.at("at");
  if (found.at.size() != at.size() / 2 || (found.normals.empty() && !at.empty())) return false;
  for (std::size_t i = 0; i + 1 < at.size(); i += 2) {
    const Point<double> wanted{hard_cases::unhex(at.at(i)), hard_cases::unhex(at.at(i + 1))};
    const bool there = std::any_of(found.at.begin(), found.at.end(), [&](const auto& p) {
      return gap(p, wanted) <= 0x1p-16 * c.number("size");
    });
    if (!there) return false;
  }
  return true;
}

inline Manifold manifold(const Body& a, const Body& b, double margin) {
  return std::visit(
      [margin](const auto& one, const auto& other) {
        return contact::contact_manifold(one, other, margin);
      },
      a.shape, b.shape);
}
inline contact::SignedDistance<double> distance(const Body& a, const Body& b) {
  return std::visit(
      [](const auto& one, const auto& other) { return contact::signed_distance(one, other); },
      a.shape, b.shape);
}
inline bool is_same(const Manifold& one, const Manifold& other) {
  if (one.normal != other.normal || one.points.size() != other.points.size()) return false;
  for (std::size_t i = 0; i < one.points.size(); ++i) {
    const auto& p = one.points[i];
    const auto& q = other.points[i];
    if (p.point != q.point || p.distance != q.distance || p.features != q.features) return false;
  }
  return true;
}
inline Found found(const Manifold& m, const Side& s) {
  if (m.points.empty()) return {};
  Found f{{m.normal}, {}};
  for (const auto& p : m.points) f.at.push_back(s.flat<double>(p.point));
  return f;
}
inline Found at(const Points<double>& points, const Side& s) {
  return points.empty() ? Found{} : Found{{s.up()}, points};
}

/// A's vertices within the margin whose projection is in B's face, by ≤.
inline Points<double> inside(const Body& a, const Body& b, const Side& s, double margin) {
  const auto [face, height] = top<double>(b, s);
  const Points<double> sides = outline(face);
  Points<double> kept;
  for (const Point<double>& p : bottom<double>(a, s, height, margin)) {
    bool in = sides.size() > 2;
    for (std::size_t i = 0; i < sides.size() && in; ++i) {
      in = 0 <= orientation<double>(sides[i], sides[(i + 1) % sides.size()], p);
    }
    if (in) kept.push_back(p);
  }
  return kept;
}
inline Point<double> mean(const Points<double>& points) {
  Point<double> sum{0, 0};
  for (const Point<double>& p : points) {
    sum[0] += p[0] / static_cast<double>(points.size());
    sum[1] += p[1] / static_cast<double>(points.size());
  }
  return sum;
}
inline V between_nearest_vertices(const Body& a, const Body& b) {
  double least = std::numeric_limits<double>::infinity();
  V best = V::Zero();
  for (const V& p : a.vertices) {
    for (const V& q : b.vertices) {
      if ((p - q).norm() >= least) continue;
      least = (p - q).norm();
      best = p - q;
    }
  }
  return least > 0 ? V(best / least) : best;
}
template <class S>
Points<double> in_arithmetic(const Body& a, const Body& b, const Side& s, double margin) {
  Points<double> points;
  for (const Point<S>& p : region<S>(a, b, s, margin)) points.push_back({p[0], p[1]});
  return points;
}

inline void add(hard_cases::Runner& runner) {
  runner.question("support", [](const Case& c) {
    const auto part = region<Rational>(body(c, "a"), body(c, "b"), side(c), c.number("margin"));
    return Json{{"class", "a"}, {"at", listed(simplified(part, 0x1p-20 * c.number("size")))}};
  });
  const auto method = [&runner](const char* name, auto find) {
    runner.method("support", name, [find](const Case& c, const Json& answer) {
      return right(c, find(body(c, "a"), body(c, "b"), side(c), c.number("margin")), answer);
    });
  };
  using B = const Body&;
  method("the deepest point", [](B a, B b, const Side& s, double margin) {
    const auto near = distance(a, b);
    return near.distance <= margin ? Found{{near.normal}, {s.flat<double>(near.on_a)}} : Found{};
  });
  method("the mean of the vertices inside", [](B a, B b, const Side& s, double margin) {
    Points<double> all = inside(a, b, s, margin);
    if (!all.empty()) all = {mean(all)};
    return at(all, s);
  });
  method("vertices inside, by <=",
         [](B a, B b, const Side& s, double margin) { return at(inside(a, b, s, margin), s); });
  method("eight points on a half-space", [](B a, B b, const Side& s, double margin) {
    return at(bottom<double>(a, s, top<double>(b, s).second, margin), s);
  });
  method("clipping without a tolerance", [](B a, B b, const Side& s, double margin) {
    return at(in_arithmetic<double>(a, b, s, margin), s);
  });
  method("clipping in float", [](B a, B b, const Side& s, double margin) {
    return at(in_arithmetic<float>(a, b, s, margin), s);
  });
  method("the first four of clipping", [](B a, B b, const Side& s, double margin) {
    Points<double> all = in_arithmetic<double>(a, b, s, margin);
    if (all.size() > 4) all.resize(4);
    return at(all, s);
  });
  method("normal from the nearest vertices", [](B a, B b, const Side& s, double margin) {
    Found f = found(manifold(a, b, margin), s);
    if (!f.normals.empty()) f.normals = {between_nearest_vertices(a, b)};
    return f;
  });
  // Exchanged, the bodies must give the opposite normal and the same points, to the last bit.
  method("book", [](B a, B b, const Side& s, double margin) {
    const Manifold m = manifold(a, b, margin);
    if (!is_same(m, contact::exchanged(manifold(b, a, margin)))) {
      throw std::logic_error("not the same with the bodies exchanged");
    }
    return found(m, s);
  });
}

}  // namespace hard_regions
