/// @file
/// What the book's answers are compared with: arithmetic that does not round, or that says how far
/// it may be off.
///
/// Four classes of answer (a hard case names its class):
///
/// | class | answer | what serves |
/// |---|---|---|
/// | (a) | rational in the input | Rational, exact(), sign(), nearest() |
/// | (b) | with one square root, a + b √d | Surd, Quadratic, sign(), compare(), nearest() |
/// | (c) | transcendental | Interval, decide_sign(), nearest_value() |
/// | (d) | integrals and motions | Enclosure, enclose_integral(), ballistic() |
///
/// Typical use, on floats as they are stored, of class (a); NaN has an infinite error:
///
///     using namespace oracle;
///     const Vector a = exact(triangle.a), b = exact(triangle.b), x = exact(point);
///     const int side = sign((b - a).dot(x - a));
///     CHECK(error(got, Rational(1) / 3) <= tolerance);
///
/// Everything here is slow (about a microsecond an operation) and right.
#pragma once

#include <mpfi.h>

#include <boost/multiprecision/eigen.hpp>
#include <boost/multiprecision/gmp.hpp>
#include <concepts>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <contact/shapes.hpp>
#include <contact/vector.hpp>

namespace oracle {

// ---------------------------------------------------------------- (a) rational

/// A fraction of two whole numbers of any size.
using Rational = boost::multiprecision::number<boost::multiprecision::gmp_rational,
                                               boost::multiprecision::et_off>;
/// A whole number of any size.
using Integer =
    boost::multiprecision::number<boost::multiprecision::gmp_int, boost::multiprecision::et_off>;
using Vector = contact::Vector3<Rational>;

/// The value of a finite float or double, unchanged. Throws std::invalid_argument for NaN and
/// infinities.
Rational exact(double x);
inline Rational exact(float x) { return exact(static_cast<double>(x)); }

/// A shape's stored numbers, unchanged.
template <std::floating_point S>
Vector exact(const contact::Vector3<S>& v) {
  return {exact(v.x()), exact(v.y()), exact(v.z())};
}
template <std::floating_point S>
contact::Plane<Rational> exact(const contact::Plane<S>& p) {
  return {exact(p.normal), exact(p.offset)};
}
template <std::floating_point S>
contact::Segment<Rational> exact(const contact::Segment<S>& s) {
  return {exact(s.start), exact(s.end)};
}
template <std::floating_point S>
contact::Ray<Rational> exact(const contact::Ray<S>& r) {
  return {exact(r.origin), exact(r.direction)};
}
template <std::floating_point S>
contact::Sphere<Rational> exact(const contact::Sphere<S>& s) {
  return {exact(s.centre), exact(s.radius)};
}
template <std::floating_point S>
contact::Triangle<Rational> exact(const contact::Triangle<S>& t) {
  return {exact(t.a), exact(t.b), exact(t.c)};
}

/// -1, 0 or 1.
int sign(const Rational& x);

/// The double (or float) nearest to x, ties to even; ±infinity beyond the largest.
double nearest(const Rational& x);
float nearest_float(const Rational& x);
contact::Vector3<double> nearest(const Vector& v);

/// |got - right|, rounded up to a double; infinity if got is not finite. So `error(got, right) <=
/// tolerance` is false for NaN, and true only if it is true without rounding.
double error(double got, const Rational& right);
/// The largest of the coordinates' errors.
double error(const contact::Vector3<double>& got, const Vector& right);

/// Reads "p/q", "p", or a decimal such as "-0.125". Throws std::invalid_argument with the text if
/// it is none of these.
Rational parse_rational(const std::string& text);
/// Writes "p/q" in lowest terms, or "p" if q is 1.
std::string text(const Rational& x);

// ---------------------------------------------------------------- (b) one square root

/// The real number a + b √d, with d ≥ 0.
struct Surd {
  Rational a{0};
  Rational b{0};
  Rational d{0};
};

Surd operator-(const Surd& x);
Surd operator+(const Surd& x, const Rational& y);
Surd operator*(const Surd& x, const Rational& y);
/// x / √d for a rational x and d > 0: what normalising a vector gives.
Surd divided_by_root(const Rational& x, const Rational& d);

/// -1, 0 or 1, decided by squaring.
int sign(const Surd& x);
/// Sign of x - y, decided by squaring twice; the roots may differ.
int compare(const Surd& x, const Surd& y);
/// The double nearest to x, ties to even: a rational interval is refined until both ends round
/// alike.
double nearest(const Surd& x);
/// |got - right|, as for a Rational; off by less than one part in 2^60, upwards.
double error(double got, const Surd& right);

/// The polynomial a t² + b t + c.
struct Quadratic {
  Rational a{0};
  Rational b{0};
  Rational c{0};

  Rational at(const Rational& t) const { return (a * t + b) * t + c; }
  Rational discriminant() const { return b * b - 4 * a * c; }
  /// The real roots in increasing order, a double root once; for a = 0 the root of the linear
  /// polynomial. Throws std::invalid_argument if all three coefficients are 0.
  std::vector<Surd> roots() const;
};

// ---------------------------------------------------------------- (c) directed rounding

/// A closed interval of multiple-precision floats that is certain to contain the number it stands
/// for. Every operation rounds outwards at the larger precision of its arguments.
///
/// Not boost::multiprecision::mpfi_float (as of Boost 1.74), which lacks two things. Its precision
/// is a number of decimal digits, so 64 bits cannot be asked for (19 digits have 65), nor can bits
/// be doubled. And no fraction can be given a precision of its own: number(Rational, digits) takes
/// the default of the whole process instead, without a word, and a Rational cannot be assigned. So
/// each evaluation would have to change a global variable.
class Interval {
 public:
  explicit Interval(unsigned bits = 64);
  Interval(const Rational& x, unsigned bits);
  Interval(const Rational& low, const Rational& high, unsigned bits);
  Interval(const Interval& other);
  Interval& operator=(const Interval& other);
  ~Interval();

  unsigned bits() const { return static_cast<unsigned>(mpfi_get_prec(value_)); }
  Rational low() const;
  Rational high() const;
  /// The sign of every number in the interval, if they all have the same.
  std::optional<int> sign() const;

  friend Interval operator+(const Interval& x, const Interval& y);
  friend Interval operator-(const Interval& x, const Interval& y);
  friend Interval operator*(const Interval& x, const Interval& y);
  friend Interval operator/(const Interval& x, const Interval& y);
  friend Interval operator-(const Interval& x);
  friend Interval sqrt(const Interval& x);
  friend Interval sin(const Interval& x);
  friend Interval cos(const Interval& x);
  friend Interval tan(const Interval& x);
  friend Interval asin(const Interval& x);
  friend Interval acos(const Interval& x);
  friend Interval atan(const Interval& x);
  friend Interval exp(const Interval& x);
  friend Interval log(const Interval& x);
  static Interval pi(unsigned bits);

 private:
  mpfi_t value_;
};

/// An expression that can be evaluated at any precision: given the bits, an interval round the
/// value.
using Expression = std::function<Interval(unsigned bits)>;

/// A sign found by growing precision, or the fact that it was not found.
struct DecidedSign {
  std::optional<int>
      sign;           ///< nothing: undecided at `bits` bits. A tie must then be settled by algebra.
  unsigned bits = 0;  ///< the precision that decided, or the last one tried
};

/// Doubles the precision from 64 bits until the sign is certain, or until max_bits.
DecidedSign decide_sign(const Expression& expression, unsigned max_bits = 4096);
/// The double nearest to the value, or nothing if both ends did not round alike at max_bits.
std::optional<double> nearest_value(const Expression& expression, unsigned max_bits = 4096);

// ---------------------------------------------------------------- (d) closed forms and enclosures

/// Two fractions that are certain to have the wanted number between them.
struct Enclosure {
  Rational low{0};
  Rational high{0};

  Rational width() const { return high - low; }
  bool contains(const Rational& x) const { return low <= x && x <= high; }
  /// The greatest distance that got can have from the enclosed number, rounded up; infinity if got
  /// is not finite.
  double error(double got) const;
};

Enclosure enclose(const Surd& x, unsigned bits = 128);
Enclosure enclose(const Interval& x);

/// The integral of f from a to b: the interval sum over `pieces` equal parts, f evaluated on whole
/// parts. The width shrinks as 1 / pieces.
Enclosure enclose_integral(const std::function<Interval(const Interval&)>& f, const Rational& a,
                           const Rational& b, unsigned pieces, unsigned bits = 128);

/// Where a body is after time t under constant acceleration: position + velocity t + acceleration
/// t² / 2, exactly.
Vector ballistic(const Vector& position, const Vector& velocity, const Vector& acceleration,
                 const Rational& t);

}  // namespace oracle
