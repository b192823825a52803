/// @file
/// The terms of a query, exactly, from which the bounds of these tests are computed.
#pragma once

#include <02_triangles/truth.hpp>
#include <boost/multiprecision/eigen.hpp>
#include <contact/tolerance.hpp>
#include <support/oracle.hpp>

namespace reference {

using oracle::Rational;
using oracle::Vector;

inline constexpr double u = contact::tolerance::unit_roundoff<double>;
inline Rational absolute(const Rational& x) { return x < 0 ? Rational(-x) : x; }
inline Vector absolute(const Vector& v) {
  return {absolute(v.x()), absolute(v.y()), absolute(v.z())};
}

inline Rational determinant(const Vector& p, const Vector& q, const Vector& r) {
  return p.dot(q.cross(r));
}

}  // namespace reference
