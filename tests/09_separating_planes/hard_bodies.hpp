/// @file
/// The bodies of the corpus of hard cases, and exact answers about them.
#pragma once

#include <contact/convex_bodies.hpp>
#include <contact/convex_shapes.hpp>
#include <contact/support.hpp>
#include <contact/vector.hpp>
#include <cstddef>
#include <optional>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "pair_bodies.hpp"
#include "pair_proofs.hpp"
#include "pair_truth.hpp"
#include "support/hard_cases.hpp"
#include "support/oracle.hpp"

namespace hard_bodies {

using hard_cases::Case;
using hard_cases::CorpusError;
using oracle::Rational;
using oracle::Surd;
using oracle::Vector;
using pair_bodies::Body;
using V = contact::Vector3<double>;
using HalfSpace = contact::HalfSpace<double>;

/// Nine numbers, column after column; without them, the world's axes.
inline contact::Matrix3<double> axes_of(const Case& c, const std::string& field) {
  contact::Matrix3<double> axes = contact::Matrix3<double>::Identity();
  if (!c.has(field)) return axes;
  const std::vector<double> all = c.numbers(field);
  for (int i = 0; i < 9; ++i) axes(i % 3, i / 3) = all.at(static_cast<std::size_t>(i));
  return axes;
}

/// A body of the corpus:
///
/// | fields of NAME | body |
/// |---|---|
/// | centre, radius | sphere |
/// | centre, half, axes | box |
/// | centre, semi, axes | ellipsoid |
/// | start, end, radius | capsule |
/// | cap, cap_to, radius | cylinder |
/// | corner, first_edge, second_edge, radius | lozenge |
/// | triangle | triangle |
/// | vertices, radius | hull of points, three numbers each; the radius may be left out |
inline Body body(const Case& c, const std::string& name) {
  const auto has = [&](const char* field) { return c.has(name + field); };
  const auto at = [&](const char* field) { return c.vector(name + field); };
  if (has("_half")) {
    return contact::OrientedBox<double>{at("_centre"), axes_of(c, name + "_axes"), at("_half")};
  }
  if (has("_semi")) {
    return contact::Ellipsoid<double>{at("_centre"), axes_of(c, name + "_axes"), at("_semi")};
  }
  if (has("_triangle")) return c.triangle(name + "_triangle");
  const double radius = has("_radius") ? c.number(name + "_radius") : 0.0;
  if (has("_vertices")) {
    const std::vector<double> all = c.numbers(name + "_vertices");
    contact::ConvexHull<double> hull{{}, radius};
    for (std::size_t i = 0; i + 2 < all.size(); i += 3) {
      hull.vertices.emplace_back(all[i], all[i + 1], all[i + 2]);
    }
    return hull;
  }
  if (has("_corner")) {
    return contact::Lozenge<double>{at("_corner"), at("_first_edge"), at("_second_edge"), radius};
  }
  if (has("_cap")) return contact::Cylinder<double>{{at("_cap"), at("_cap_to")}, radius};
  if (has("_centre")) return contact::Sphere<double>{at("_centre"), radius};
  return contact::Capsule<double>{{at("_start"), at("_end")}, radius};
}

/// The second body, if it is a half-space: its normal and offset.
inline std::optional<HalfSpace> half_space(const Case& c) {
  if (!c.has("b_normal")) return std::nullopt;
  return HalfSpace{{c.vector("b_normal"), c.number("b_offset")}};
}

/// Calls f with the bodies in their own types; a half-space comes second.
template <class F>
auto with(const Case& c, const F& f) {
  if (const auto h = half_space(c)) {
    return std::visit([&](const auto& a) { return f(a, *h); }, body(c, "a"));
  }
  return pair_bodies::with(body(c, "a"), body(c, "b"), f);
}
/// Whether the two bodies are of the types A and B.
template <class A, class B>
bool are(const Case& c) {
  return with(c, []<class X, class Y>(const X&, const Y&) {
    return std::is_same_v<X, A> && std::is_same_v<Y, B>;
  });
}

/// A body's numbers, of which an error is a multiple of u.
inline double size_of(const Body& b) { return pair_bodies::size_of(b); }
inline double size_of(const HalfSpace& h) { return std::abs(h.boundary.offset); }

/// @name In float
/// @{
inline contact::Vector3<float> narrow(const V& v) { return v.cast<float>(); }
inline contact::Segment<float> narrow(const contact::Segment<double>& s) {
  return {narrow(s.start), narrow(s.end)};
}
inline contact::Sphere<float> narrow(const contact::Sphere<double>& b) {
  return {narrow(b.centre), float(b.radius)};
}
inline contact::Capsule<float> narrow(const contact::Capsule<double>& b) {
  return {narrow(b.core), float(b.radius)};
}
inline contact::Cylinder<float> narrow(const contact::Cylinder<double>& b) {
  return {narrow(b.core), float(b.radius)};
}
inline contact::Lozenge<float> narrow(const contact::Lozenge<double>& b) {
  return {narrow(b.corner), narrow(b.first_edge), narrow(b.second_edge), float(b.radius)};
}
inline contact::Triangle<float> narrow(const contact::Triangle<double>& b) {
  return {narrow(b.a), narrow(b.b), narrow(b.c)};
}
inline contact::ConvexHull<float> narrow(const contact::ConvexHull<double>& b) {
  contact::ConvexHull<float> made{{}, float(b.radius)};
  for (const V& v : b.vertices) made.vertices.push_back(narrow(v));
  return made;
}
inline contact::OrientedBox<float> narrow(const contact::OrientedBox<double>& b) {
  return {narrow(b.centre), b.axes.cast<float>(), narrow(b.half_lengths)};
}
inline contact::Ellipsoid<float> narrow(const contact::Ellipsoid<double>& b) {
  return {narrow(b.centre), b.axes.cast<float>(), narrow(b.half_lengths)};
}
inline contact::HalfSpace<float> narrow(const HalfSpace& h) {
  return {{narrow(h.boundary.normal), float(h.boundary.offset)}};
}
/// @}

// ---------------------------------------------------------------- exact answers

struct Exactly {
  int sign = 0;
  std::optional<Surd> distance;  ///< signed, m; nothing where it has two square roots, or no proof
};

/// All x with n · x ≤ k, for n of any length: (smallest n · x − k)/|n|.
inline Exactly exactly(const Body& a, const HalfSpace& h) {
  const Vector n = oracle::exact(h.boundary.normal);
  const Surd lowest = -pair_proofs::support(a, Vector(-n)) + -oracle::exact(h.boundary.offset);
  const int sign = oracle::sign(lowest);
  const Rational squared = n.dot(n);
  if (lowest.b == 0 || lowest.d == 0) {
    return {sign, oracle::divided_by_root(lowest.a, squared)};
  }
  if (lowest.d == squared) {  // a radius
    return {sign, oracle::divided_by_root(lowest.a, squared) + lowest.b};
  }
  if (squared == 1) return {sign, lowest};
  return {sign, {}};
}

/// A cylinder or an ellipsoid: the case names a point of each core, the closest ones. The plane
/// perpendicular to the line between them must separate the cores by their distance.
inline Exactly by_points(const Case& c, Body a, Body b) {
  Rational radii = 0;
  for (Body* body : {&a, &b}) {
    std::visit(
        [&](auto& x) {
          if constexpr (contact::PolytopeCore<std::decay_t<decltype(x)>>) {
            if constexpr (requires { x.radius; }) {
              radii += oracle::exact(x.radius);
              x.radius = 0;
            }
          }
        },
        *body);
  }
  const Vector p = oracle::exact(c.vector("point_of_a")), q = oracle::exact(c.vector("point_of_b"));
  const Vector n = p - q;
  const Surd low = -pair_proofs::support(a, Vector(-n)) + Rational(-n.dot(n));
  if (pair_proofs::inside(a, p) < 0 || pair_proofs::inside(b, q) < 0 ||
      oracle::compare(low, pair_proofs::support(b, n)) != 0) {
    throw CorpusError(c.name() + ": point_of_a and point_of_b are not the closest points");
  }
  const Surd distance = Surd{0, 1, n.dot(n)} + Rational(-radii);
  return {oracle::sign(distance), distance};
}

/// A cylinder or an ellipsoid: the case names a direction and a point, which must prove the answer.
inline Exactly by_proof(const Case& c, const Body& a, const Body& b) {
  const auto sign = pair_proofs::proved(a, b, oracle::exact(c.vector("direction")),
                                        oracle::exact(c.vector("point")));
  if (!sign) throw CorpusError(c.name() + ": direction and point prove nothing");
  return {*sign, {}};
}

inline Exactly exactly(const Case& c) {
  const Body a = body(c, "a");
  if (const auto h = half_space(c)) return exactly(a, *h);
  const Body b = body(c, "b");
  if (c.has("point_of_a")) return by_points(c, a, b);
  if (c.has("direction")) return by_proof(c, a, b);
  std::optional<Exactly> found;
  pair_bodies::with_polytopes(a, b, [&](const auto& x, const auto& y) {
    const auto truth = pair_truth::truth(x, y);
    found = Exactly{truth.sign, truth.distance};
  });
  if (!found) throw CorpusError(c.name() + ": a smooth body needs a proof");
  return *found;
}

}  // namespace hard_bodies
