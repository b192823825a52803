#include "oracle.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

namespace oracle {
namespace {

using std::numeric_limits;

/// The number of type Float nearest to x, found by walking from GMP's conversion, which cuts off.
template <class Float>
Float nearest_of(const Rational& x) {
  if (x == 0) return Float(0);
  if (x < 0) return -nearest_of<Float>(-x);
  const Float largest = numeric_limits<Float>::max();
  const Rational last_ulp = exact(largest) - exact(std::nextafter(largest, Float(0)));
  if (x >= exact(largest) + last_ulp / 2) return numeric_limits<Float>::infinity();
  if (x >= exact(largest)) return largest;
  // Nothing below here overflows; the conversion is only a first guess.
  Float low = static_cast<Float>(mpq_get_d(x.backend().data()));
  if (!(low < largest)) low = std::nextafter(largest, Float(0));
  while (exact(low) > x) low = std::nextafter(low, Float(0));
  Float high = std::nextafter(low, largest);
  while (exact(high) <= x) {
    low = high;
    high = std::nextafter(low, largest);
  }
  const Rational below = x - exact(low);
  const Rational above = exact(high) - x;
  if (below != above) return below < above ? low : high;
  int exponent = 0;  // a tie: the one whose last bit is 0
  const Float step = high - low;
  const Float count = std::frexp(low / step, &exponent);
  return std::fmod(std::ldexp(count, exponent), Float(2)) == 0 ? low : high;
}

double up(const Rational& x) {
  const double value = nearest(x);
  if (!std::isfinite(value)) return value;
  return exact(value) < x ? std::nextafter(value, numeric_limits<double>::infinity()) : value;
}

Rational from_mpfr(mpfr_srcptr x) {
  if (mpfr_number_p(x) == 0) throw std::domain_error("an interval has an end that is not a number");
  Rational result;
  mpfr_get_q(result.backend().data(), x);
  return result;
}

bool is_square(const Integer& n, Integer& root) {
  root = boost::multiprecision::sqrt(n);
  return root * root == n;
}

/// √d to within 2^-bits relative to 1/denominator: floor and ceiling at a scale of 4^bits.
Enclosure enclose_root(const Rational& d, unsigned bits) {
  const Integer p = numerator(d);
  const Integer q = denominator(d);
  const Integer root = boost::multiprecision::sqrt(Integer((p * q) << (2 * bits)));
  const Rational scale = Rational(Integer(q << bits));
  return {Rational(root) / scale, Rational(Integer(root + 1)) / scale};
}

}  // namespace

Rational exact(double x) {
  if (!std::isfinite(x)) throw std::invalid_argument("oracle::exact: not a finite number");
  Rational result;
  mpq_set_d(result.backend().data(), x);
  return result;
}

int sign(const Rational& x) { return x.sign(); }
double nearest(const Rational& x) { return nearest_of<double>(x); }
float nearest_float(const Rational& x) { return nearest_of<float>(x); }
contact::Vector3<double> nearest(const Vector& v) {
  return {nearest(v.x()), nearest(v.y()), nearest(v.z())};
}

double error(double got, const Rational& right) {
  if (!std::isfinite(got)) return numeric_limits<double>::infinity();
  return up(abs(exact(got) - right));
}

double error(const contact::Vector3<double>& got, const Vector& right) {
  double worst = 0;
  for (int i = 0; i < 3; ++i) worst = std::max(worst, error(got(i), right(i)));
  return worst;
}

Rational parse_rational(const std::string& text) {
  const auto bad = [&text] {
    return std::invalid_argument("\"" + text + "\" is neither p/q nor a decimal number");
  };
  const auto whole = [&](std::string digits) {
    const bool negative = !digits.empty() && digits.front() == '-';
    if (negative) digits.erase(0, 1);
    if (digits.empty() || digits.find_first_not_of("0123456789") != std::string::npos) throw bad();
    digits.erase(0, std::min(digits.find_first_not_of('0'), digits.size() - 1));  // 010 is ten here
    const Integer n(digits);
    return negative ? Integer(-n) : n;
  };
  if (const auto slash = text.find('/'); slash != std::string::npos) {
    const Integer q = whole(text.substr(slash + 1));
    if (q <= 0) throw bad();
    return Rational(whole(text.substr(0, slash)), q);
  }
  if (const auto point = text.find('.'); point != std::string::npos) {
    const std::string fraction = text.substr(point + 1);
    if (fraction.empty() || fraction.front() == '-') throw bad();
    Integer q = 1;
    for (std::size_t i = 0; i < fraction.size(); ++i) q *= 10;
    return Rational(whole(text.substr(0, point) + fraction), q);
  }
  return Rational(whole(text));
}

std::string text(const Rational& x) { return x.str(); }

Surd operator-(const Surd& x) { return {-x.a, -x.b, x.d}; }
Surd operator+(const Surd& x, const Rational& y) { return {x.a + y, x.b, x.d}; }
Surd operator*(const Surd& x, const Rational& y) { return {x.a * y, x.b * y, x.d}; }
Surd divided_by_root(const Rational& x, const Rational& d) {
  if (d <= 0) throw std::invalid_argument("oracle::divided_by_root: d must be positive");
  return {0, x / d, d};
}

int sign(const Surd& x) {
  if (x.d < 0) throw std::invalid_argument("oracle::sign: the root of a negative number");
  const int first = sign(x.a);
  const int second = sign(x.b) * sign(x.d);
  if (first == 0 || second == 0 || first == second) return first != 0 ? first : second;
  return first * sign(Rational(x.a * x.a - x.b * x.b * x.d));
}

int compare(const Surd& x, const Surd& y) {
  // The sign of u + v with u = (x.a - y.a) + x.b √x.d and v = -y.b √y.d.
  const Surd u{x.a - y.a, x.b, x.d};
  const Surd v{0, -y.b, y.d};
  const int first = sign(u);
  const int second = sign(v);
  if (first == 0 || second == 0 || first == second) return first != 0 ? first : second;
  // Opposite signs: the larger square decides. u² lies in the field of √x.d and v² is rational.
  const Surd difference{u.a * u.a + u.b * u.b * u.d - v.b * v.b * v.d, 2 * u.a * u.b, u.d};
  return first * sign(difference);
}

Enclosure enclose(const Surd& x, unsigned bits) {
  if (x.d < 0) throw std::invalid_argument("oracle::enclose: the root of a negative number");
  Integer p;
  Integer q;
  if (is_square(numerator(x.d), p) && is_square(denominator(x.d), q)) {
    const Rational value = x.a + x.b * Rational(p, q);
    return {value, value};
  }
  const Enclosure root = enclose_root(x.d, bits);
  const Rational one = x.a + x.b * root.low;
  const Rational other = x.a + x.b * root.high;
  return one < other ? Enclosure{one, other} : Enclosure{other, one};
}

double nearest(const Surd& x) {
  // An irrational number is no tie, so this ends: from some precision on no rounding boundary lies
  // between the ends.
  for (unsigned bits = 128;; bits *= 2) {
    const Enclosure between = enclose(x, bits);
    const double low = nearest(between.low);
    if (low == nearest(between.high)) return low;
  }
}

double error(double got, const Surd& right) {
  if (!std::isfinite(got)) return numeric_limits<double>::infinity();
  const Rational stored = exact(got);
  for (unsigned bits = 128;; bits *= 2) {
    const Enclosure distance = enclose(right + -stored, bits);
    const Rational largest = std::max(abs(distance.low), abs(distance.high));
    if (distance.width() == 0 || distance.width() * (Integer(1) << 60) <= largest)
      return up(largest);
  }
}

std::vector<Surd> Quadratic::roots() const {
  if (a == 0) {
    if (b == 0 && c == 0) throw std::invalid_argument("every number is a root of 0");
    if (b == 0) return {};
    return {Surd{-c / b, 0, 0}};
  }
  const Rational d = discriminant();
  if (d < 0) return {};
  const Rational middle = -b / (2 * a);
  if (d == 0) return {Surd{middle, 0, 0}};
  const Rational half = abs(1 / (2 * a));
  return {Surd{middle, -half, d}, Surd{middle, half, d}};
}

Interval::Interval(unsigned bits) {
  mpfi_init2(value_, static_cast<mpfr_prec_t>(bits));
  mpfi_set_si(value_, 0);
}
Interval::Interval(const Rational& x, unsigned bits) : Interval(bits) {
  mpfi_set_q(value_, x.backend().data());
}
Interval::Interval(const Rational& low, const Rational& high, unsigned bits) : Interval(bits) {
  const Interval first(low, bits);
  const Interval last(high, bits);
  mpfi_union(value_, first.value_, last.value_);
}
Interval::Interval(const Interval& other) : Interval(other.bits()) {
  mpfi_set(value_, other.value_);
}
Interval& Interval::operator=(const Interval& other) {
  if (this != &other) {
    mpfi_set_prec(value_, static_cast<mpfr_prec_t>(other.bits()));
    mpfi_set(value_, other.value_);
  }
  return *this;
}
Interval::~Interval() { mpfi_clear(value_); }

Rational Interval::low() const { return from_mpfr(&value_->left); }
Rational Interval::high() const { return from_mpfr(&value_->right); }

std::optional<int> Interval::sign() const {
  if (mpfi_nan_p(value_) != 0) return std::nullopt;
  if (mpfi_is_strictly_pos(value_) != 0) return 1;
  if (mpfi_is_strictly_neg(value_) != 0) return -1;
  if (mpfi_is_zero(value_) != 0) return 0;
  return std::nullopt;
}

Interval operator+(const Interval& x, const Interval& y) {
  Interval result(std::max(x.bits(), y.bits()));
  mpfi_add(result.value_, x.value_, y.value_);
  return result;
}
Interval operator-(const Interval& x, const Interval& y) {
  Interval result(std::max(x.bits(), y.bits()));
  mpfi_sub(result.value_, x.value_, y.value_);
  return result;
}
Interval operator*(const Interval& x, const Interval& y) {
  Interval result(std::max(x.bits(), y.bits()));
  mpfi_mul(result.value_, x.value_, y.value_);
  return result;
}
Interval operator/(const Interval& x, const Interval& y) {
  Interval result(std::max(x.bits(), y.bits()));
  mpfi_div(result.value_, x.value_, y.value_);
  return result;
}
Interval operator-(const Interval& x) {
  Interval result(x.bits());
  mpfi_neg(result.value_, x.value_);
  return result;
}
Interval sqrt(const Interval& x) {
  Interval result(x.bits());
  mpfi_sqrt(result.value_, x.value_);
  return result;
}
Interval sin(const Interval& x) {
  Interval result(x.bits());
  mpfi_sin(result.value_, x.value_);
  return result;
}
Interval cos(const Interval& x) {
  Interval result(x.bits());
  mpfi_cos(result.value_, x.value_);
  return result;
}
Interval tan(const Interval& x) {
  Interval result(x.bits());
  mpfi_tan(result.value_, x.value_);
  return result;
}
Interval asin(const Interval& x) {
  Interval result(x.bits());
  mpfi_asin(result.value_, x.value_);
  return result;
}
Interval acos(const Interval& x) {
  Interval result(x.bits());
  mpfi_acos(result.value_, x.value_);
  return result;
}
Interval atan(const Interval& x) {
  Interval result(x.bits());
  mpfi_atan(result.value_, x.value_);
  return result;
}
Interval exp(const Interval& x) {
  Interval result(x.bits());
  mpfi_exp(result.value_, x.value_);
  return result;
}
Interval log(const Interval& x) {
  Interval result(x.bits());
  mpfi_log(result.value_, x.value_);
  return result;
}
Interval Interval::pi(unsigned bits) {
  Interval result(bits);
  mpfi_const_pi(result.value_);
  return result;
}

DecidedSign decide_sign(const Expression& expression, unsigned max_bits) {
  unsigned bits = 64;
  for (;; bits *= 2) {
    const auto sign = expression(bits).sign();
    if (sign.has_value() || 2 * bits > max_bits) return {sign, bits};
  }
}

std::optional<double> nearest_value(const Expression& expression, unsigned max_bits) {
  for (unsigned bits = 64; bits <= max_bits; bits *= 2) {
    const Interval between = expression(bits);
    const double low = nearest(between.low());
    if (low == nearest(between.high())) return low;
  }
  return std::nullopt;
}

double Enclosure::error(double got) const {
  if (!std::isfinite(got)) return numeric_limits<double>::infinity();
  const Rational stored = exact(got);
  return up(std::max(abs(stored - low), abs(stored - high)));
}

Enclosure enclose(const Interval& x) { return {x.low(), x.high()}; }

Enclosure enclose_integral(const std::function<Interval(const Interval&)>& f, const Rational& a,
                           const Rational& b, unsigned pieces, unsigned bits) {
  if (pieces == 0) throw std::invalid_argument("oracle::enclose_integral: pieces must be positive");
  const Rational step = (b - a) / pieces;
  Interval total(bits);
  for (unsigned i = 0; i < pieces; ++i) {
    const Rational from = a + step * i;
    total = total + f(Interval(from, from + step, bits)) * Interval(step, bits);
  }
  return enclose(total);
}

Vector ballistic(const Vector& position, const Vector& velocity, const Vector& acceleration,
                 const Rational& t) {
  const Rational half_square = t * t / 2;
  return position + velocity * t + acceleration * half_square;
}

}  // namespace oracle
