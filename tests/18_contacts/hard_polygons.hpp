/// @file
/// Contact points of convex polygons in the plane: exact answers, and methods as they are often
/// written.
#pragma once

#include <algorithm>
#include <cmath>
#include <contact/manifold_2d.hpp>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include "hard_scale.hpp"
#include "support/hard_cases.hpp"

namespace hard_polygons {

using hard_cases::Case;
using hard_cases::Json;
using oracle::Rational;
using V2 = contact::Vector2<double>;
using Polygon = contact::Polygon<double>;
using Manifold = contact::ContactManifold2d<double>;

inline Polygon polygon(const Case& c, const std::string& name) {
  Polygon made;
  const std::vector<double> all = c.numbers(name);
  for (std::size_t i = 0; i + 1 < all.size(); i += 2) made.emplace_back(all[i], all[i + 1]);
  return made;
}
/// From B to A, of any length.
inline V2 direction(const Case& c) {
  const std::vector<double> n = c.numbers("side");
  return {n.at(0), n.at(1)};
}

template <class S>
contact::Vector2<S> exactly(const V2& v) {
  if constexpr (std::is_same_v<S, Rational>) {
    return {oracle::exact(v.x()), oracle::exact(v.y())};
  } else {
    return v.cast<S>();
  }
}
template <class S>
S along(const contact::Vector2<S>& n, const contact::Vector2<S>& v) {
  return S(S(n.x() * v.x()) + S(n.y() * v.y()));
}

/// Positions perpendicular to the direction n, in units of its length: of the parts of B within
/// `room` of its top and of A within the margin of that.
template <class S>
std::vector<S> common_part(const Polygon& a, const Polygon& b, const V2& side, double margin,
                           double room) {
  const auto n = exactly<S>(side);
  const contact::Vector2<S> t(S(S(0) - n.y()), n.x());
  const S unit(std::sqrt(side.dot(side)));  // a whole number for the directions of the corpus
  S top = along<S>(n, exactly<S>(b[0]));
  for (const V2& v : b) top = std::max(top, along<S>(n, exactly<S>(v)));
  std::vector<S> on_b, on_a;
  for (const V2& v : b) {
    const auto p = exactly<S>(v);
    if (along<S>(n, p) >= top - S(room) * unit) on_b.push_back(S(along<S>(t, p) / unit));
  }
  for (const V2& v : a) {
    const auto p = exactly<S>(v);
    if (along<S>(n, p) - top <= S(margin) * unit) on_a.push_back(S(along<S>(t, p) / unit));
  }
  if (on_a.empty()) return {};
  const auto [low_a, high_a] = std::minmax_element(on_a.begin(), on_a.end());
  const auto [low_b, high_b] = std::minmax_element(on_b.begin(), on_b.end());
  if (on_a.size() == 1 && on_b.size() == 1) return {S((on_a[0] + on_b[0]) / S(2))};
  const S low = std::max(*low_a, *low_b), high = std::min(*high_a, *high_b);
  if (high < low) return {};
  return {low, high};
}

struct Found {
  V2 normal = V2::Zero();
  std::vector<double> at;
};
inline Found found(const Manifold& m, const V2& side) {
  Found f{m.normal, {}};
  const V2 t = V2(-side.y(), side.x()) / std::sqrt(side.dot(side));
  for (const auto& p : m.points) f.at.push_back(t.dot(p.point));
  return f;
}
inline bool right(const Case& c, Found f, const Json& answer) {
  const V2 side = direction(c), up = side / std::sqrt(side.dot(side));
  const Json& at = answer.at("at");
  if (f.at.size() != at.size()) return false;
  if (!at.empty() && !((f.normal - up).cwiseAbs().maxCoeff() <= 0x1p-9)) return false;
  std::sort(f.at.begin(), f.at.end());
  for (std::size_t i = 0; i < at.size(); ++i) {
    const double wanted = hard_cases::unhex(at.at(i));
    if (!(std::abs(f.at[i] - wanted) <= 0x1p-16 * c.number("size"))) return false;
  }
  return true;
}

/// Reference edge, incident edge and clipping, without what the book adds.
template <class S>
contact::ContactManifold2d<S> clipped(const contact::Polygon<S>& a, const contact::Polygon<S>& b,
                                      const S& margin, bool only_a, bool whole) {
  const auto of_a = contact::max_edge_separation<S>(a, b),
             of_b = contact::max_edge_separation<S>(b, a);
  if (of_a.edge < 0 || of_b.edge < 0) return {};  // all vertices coincide
  const bool is_a = only_a || !(of_b.separation > of_a.separation);
  const auto& best = is_a ? of_a : of_b;
  const auto& reference = is_a ? a : b;
  const auto& incident = is_a ? b : a;
  contact::ContactManifold2d<S> m;
  m.normal = is_a ? contact::Vector2<S>(-best.normal) : best.normal;
  const int other = contact::incident_edge<S>(incident, best.normal);
  const auto add = [&](const contact::Vector2<S>& p) {
    const S height = best.normal.dot(contact::Vector2<S>(p - reference[std::size_t(best.edge)]));
    if (height <= margin) m.points.push_back({p, height, {}});
  };
  if (whole) {
    for (const int i : {other, (other + 1) % int(incident.size())}) add(incident[std::size_t(i)]);
    return m;
  }
  for (const auto& p :
       contact::detail::part_over_edge<S>(reference, best.edge, best.normal, incident, other)) {
    add(p.position);
  }
  return m;
}

inline void add(hard_cases::Runner& runner) {
  runner.question("points in the plane", [](const Case& c) {
    Json at = Json::array();
    const auto part =
        common_part<Rational>(polygon(c, "a"), polygon(c, "b"), direction(c), c.number("margin"),
                              0x1p-20 * hard_scale::unit_of_length(c));
    const bool one = part.size() == 2 &&
                     part[1] - part[0] <= Rational(0x1p-20) * oracle::exact(c.number("size"));
    for (const Rational& x : part) {
      at.push_back(hard_cases::hex(x));
      if (one) break;
    }
    return Json{{"class", "a"}, {"at", at}};
  });
  using P = const Polygon&;
  const auto method = [&runner](const char* name, auto find) {
    runner.method("points in the plane", name, [find](const Case& c, const Json& answer) {
      const Manifold m = find(polygon(c, "a"), polygon(c, "b"), c.number("margin"));
      return right(c, found(m, direction(c)), answer);
    });
  };
  const auto keep_deepest = [](Manifold m) {
    const auto least = std::min_element(m.points.begin(), m.points.end(),
                                        [](auto& p, auto& q) { return p.distance < q.distance; });
    if (!m.points.empty()) m.points = {*least};
    return m;
  };
  method("the deepest point alone", [=](P a, P b, double margin) {
    return keep_deepest(clipped<double>(a, b, margin, false, false));
  });
  method("the mean of the points", [](P a, P b, double margin) {
    Manifold m = clipped<double>(a, b, margin, false, false);
    if (m.points.size() == 2) {
      m.points[0].point = (m.points[0].point + m.points[1].point) / 2;
      m.points.pop_back();
    }
    return m;
  });
  method("A's edge as the reference",
         [](P a, P b, double margin) { return clipped<double>(a, b, margin, true, false); });
  method("the whole incident edge",
         [](P a, P b, double margin) { return clipped<double>(a, b, margin, false, true); });
  method("clipping without a tolerance",
         [](P a, P b, double margin) { return clipped<double>(a, b, margin, false, false); });
  method("the same in float", [](P a, P b, double margin) {
    contact::Polygon<float> one, other;
    for (const V2& v : a) one.push_back(v.cast<float>());
    for (const V2& v : b) other.push_back(v.cast<float>());
    const auto narrow = clipped<float>(one, other, static_cast<float>(margin), false, false);
    Manifold m{narrow.normal.cast<double>(), {}};
    for (const auto& p : narrow.points) m.points.push_back({p.point.cast<double>(), 0, {}});
    return m;
  });
  method("vertices inside, by <=", [](P a, P b, double margin) {
    const auto of_b = contact::max_edge_separation<double>(b, a);
    Manifold m{of_b.normal, {}};
    const V2 start = b[std::size_t(of_b.edge)], end = b[(std::size_t(of_b.edge) + 1) % b.size()];
    for (const V2& v : a) {
      const double t = V2(end - start).dot(V2(v - start)), whole = V2(end - start).squaredNorm();
      const double height = of_b.normal.dot(V2(v - start));
      if (0 <= t && t <= whole && height <= margin) m.points.push_back({v, height, {}});
    }
    return m;
  });
  method("normal from the nearest vertices", [](P a, P b, double margin) {
    Manifold m = contact::contact_manifold_2d(a, b, margin);
    double least = INFINITY;
    for (const V2& p : a) {
      for (const V2& q : b) {
        if (!((p - q).norm() < least)) continue;
        least = (p - q).norm();
        m.normal = least > 0 ? V2((p - q) / least) : V2(0, 0);
      }
    }
    return m;
  });
  // Exchanged, the polygons must give the opposite normal and the same points, to the last bit.
  method("book", [](P a, P b, double margin) {
    const Manifold m = contact::contact_manifold_2d(a, b, margin);
    const Manifold back = contact::exchanged(contact::contact_manifold_2d(b, a, margin));
    bool same = m.normal == back.normal && m.points.size() == back.points.size();
    for (std::size_t i = 0; same && i < m.points.size(); ++i) {
      same = m.points[i].point == back.points[i].point &&
             m.points[i].distance == back.points[i].distance &&
             m.points[i].features == back.points[i].features;
    }
    if (!same) throw std::logic_error("not the same with the polygons exchanged");
    return m;
  });
}

}  // namespace hard_polygons
