/// @file
/// Exact checks of certified answers about two bodies: that what they offer as a proof is one.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <contact/certificates.hpp>
#include <contact/exact.hpp>
#include <contact/proximity.hpp>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "pair_bodies.hpp"
#include "pair_cores.hpp"
#include "pair_families.hpp"
#include "pair_proofs.hpp"
#include "pair_truth.hpp"
#include "support/oracle.hpp"

namespace pair_checks {

using contact::Proximity;
using oracle::Rational;
using oracle::Vector;
using pair_bodies::Body;

/// The value of an exact number: the sum of the doubles that are taken from it one by one.
inline Rational rational_of(contact::Exact x) {
  Rational sum = 0, unit = 1;
  const contact::Exact up = contact::Exact(0x1p600), down = contact::Exact(0x1p-600);
  while (x.sign() != 0) {
    const double part = rounded<double>(x);
    if (!std::isfinite(part)) {
      x = x * down;
      unit = unit * oracle::exact(0x1p600);
    } else if (std::abs(part) < 0x1p-400) {
      x = x * up;
      unit = unit * oracle::exact(0x1p-600);
    } else {
      sum += unit * oracle::exact(part);
      x = x - contact::Exact(part);
    }
  }
  return sum;
}
inline Vector rational_of(const contact::Vector3<contact::Exact>& v) {
  return {rational_of(v.x()), rational_of(v.y()), rational_of(v.z())};
}

/// The case of a sign.
inline Proximity case_of(int sign) {
  if (sign == 0) return Proximity::touching;
  return sign > 0 ? Proximity::disjoint : Proximity::overlapping;
}

/// The normal of a plane as the book means it.
inline Vector normal_of(const contact::SeparatingPlane& plane) {
  const auto& n = plane.exact_normal;
  const bool exact = n.x().sign() != 0 || n.y().sign() != 0 || n.z().sign() != 0;
  return exact ? rational_of(n) : oracle::exact(plane.normal);
}

/// A pair of points of a common point; nothing where a point is outside of its body.
struct Differences {
  std::vector<Vector> all;
  Rational radius{0};
  bool are_members = true;
};
inline Differences differences(const Body& a, const Body& b,
                               const contact::CommonPointProof& common) {
  Differences made;
  bool cores_of_a = true, cores_of_b = true;
  const auto point = [&](const Body& body, const contact::Member& member, bool& of_core) {
    if (member.vertex < 0) {
      of_core = false;
      const Vector p = oracle::exact(member.point);
      if (pair_proofs::inside(body, p) < 0) made.are_members = false;
      return p;
    }
    Vector v(0, 0, 0);
    std::visit(
        [&](const auto& x) {
          if constexpr (contact::PolytopeCore<std::decay_t<decltype(x)>>) {
            v = pair_truth::core_of(x).vertices.at(static_cast<std::size_t>(member.vertex));
          } else {
            made.are_members = false;
          }
        },
        body);
    return v;
  };
  for (std::size_t i = 0; i < static_cast<std::size_t>(common.count); ++i) {
    const Vector p = point(a, common.of_a.at(i), cores_of_a);
    made.all.push_back(p - point(b, common.of_b.at(i), cores_of_b));
  }
  const auto radius = [](const Body& body) {
    return std::visit([](const auto& x) { return oracle::exact(contact::radius_of(x)); }, body);
  };
  if (cores_of_a) made.radius += radius(a);
  if (cores_of_b) made.radius += radius(b);
  return made;
}
/// How the origin lies to the hull of the differences of a common point, enlarged by the radii of
/// those bodies of which it names vertices: −1: strictly inside, so that the bodies overlap; 0: on
/// its surface; 1: outside, or the points are not those of the bodies.
inline int side_of_common(const Body& a, const Body& b, const contact::CommonPointProof& common) {
  const Differences w = differences(a, b, common);
  if (w.all.empty() || !w.are_members) return 1;
  const pair_truth::Core origin{{Vector(0, 0, 0)}, {}, {}, 0};
  return pair_truth::truth(pair_truth::core_of_points(w.all, w.radius), origin).sign;
}

/// What is wrong with a certified answer; empty: nothing. An answer that is undecided needs no
/// proof.
inline std::string fault_of(const Body& a, const Body& b,
                            const contact::CertifiedProximity& answer) {
  if (answer.state == Proximity::undecided) return {};
  std::string fault;
  if (answer.state != Proximity::overlapping) {
    const int gap = pair_proofs::gap_sign(a, b, normal_of(answer.plane));
    if (answer.state == Proximity::disjoint && gap <= 0) fault += "the plane does not separate; ";
    if (answer.state == Proximity::touching && gap < 0) fault += "a plane with points behind it; ";
  }
  if (answer.state != Proximity::disjoint) {
    const int side = side_of_common(a, b, answer.common);
    if (answer.state == Proximity::overlapping && side >= 0) fault += "no inner common point; ";
    if (answer.state == Proximity::touching && side > 0) fault += "no common point; ";
  }
  return fault;
}

/// The stored numbers of a body, for a report.
inline std::string text_of(Body body) {
  std::string text = std::string(pair_bodies::name(pair_bodies::kind_of(body))) + " {";
  const auto number = [&text](double x) {
    char digits[40];
    std::snprintf(digits, sizeof digits, "%a, ", x);
    text += digits;
  };
  const auto vector = [&](const pair_bodies::V& v) {
    text += "(";
    for (int i = 0; i < 3; ++i) number(v(i));
    text += ") ";
  };
  pair_bodies::detail::visit(body, vector, vector, number);
  const auto axes = [&](const auto& framed) {
    for (int i = 0; i < 3; ++i) vector(framed.axes.col(i));
  };
  if (const auto* box = std::get_if<contact::OrientedBox<double>>(&body)) axes(*box);
  if (const auto* round = std::get_if<contact::Ellipsoid<double>>(&body)) axes(*round);
  return text + "}";
}
inline std::string text_of(const pair_families::Pair& pair) {
  return text_of(pair.a) + "\n" + text_of(pair.b);
}

/// Calls with the pairs of each two kinds and each family, `count` of each.
template <class Take, class Call>
void each_pair(std::uint64_t seed, int count, const Take& take, const Call& call) {
  generators::Random random(seed);
  for (const pair_bodies::Kind a : pair_bodies::all_kinds) {
    for (const pair_bodies::Kind b : pair_bodies::all_kinds) {
      if (!take(a, b)) continue;
      for (const pair_families::Family family : pair_families::all) {
        // At least one, also where sanitizers leave an eighth.
        for (int i = 0; i < std::max(count, 1); ++i) {
          call(pair_families::pair(random, a, b, family), family);
        }
      }
    }
  }
}
inline bool polytopes(pair_bodies::Kind a, pair_bodies::Kind b) {
  return a <= b && !pair_bodies::is_smooth(a) && !pair_bodies::is_smooth(b);
}
inline bool smooth(pair_bodies::Kind a, pair_bodies::Kind b) {
  return a <= b && (pair_bodies::is_smooth(a) || pair_bodies::is_smooth(b));
}

}  // namespace pair_checks
