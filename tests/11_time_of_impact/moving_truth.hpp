/// @file
/// Exact answers about vertices, edges and faces that move linearly: whether they meet in a step,
/// and when first.
///
/// All signs are those of polynomials in time with rational coefficients at one of their roots,
/// which Sturm's theorem decides. No method of the chapter is used.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "support/oracle.hpp"

namespace moving_truth {

using oracle::Rational;

/// A polynomial, the constant term first and no 0 at the end; 0 has no terms.
using Polynomial = std::vector<Rational>;

inline Polynomial trimmed(Polynomial p) {
  while (!p.empty() && p.back() == 0) p.pop_back();
  return p;
}
inline Polynomial sum(const Polynomial& p, const Polynomial& q, int sign_of_q = 1) {
  Polynomial r(std::max(p.size(), q.size()), Rational(0));
  for (std::size_t i = 0; i < p.size(); ++i) r[i] = p[i];
  for (std::size_t i = 0; i < q.size(); ++i) r[i] = sign_of_q > 0 ? r[i] + q[i] : r[i] - q[i];
  return trimmed(r);
}
inline Polynomial product(const Polynomial& p, const Polynomial& q) {
  if (p.empty() || q.empty()) return {};
  Polynomial r(p.size() + q.size() - 1, Rational(0));
  for (std::size_t i = 0; i < p.size(); ++i) {
    for (std::size_t j = 0; j < q.size(); ++j) r[i + j] = r[i + j] + p[i] * q[j];
  }
  return trimmed(r);
}
inline Rational at(const Polynomial& p, const Rational& t) {
  Rational value = 0;
  for (std::size_t i = p.size(); i-- > 0;) value = value * t + p[i];
  return value;
}
inline Polynomial derivative(const Polynomial& p) {
  Polynomial r;
  for (std::size_t i = 1; i < p.size(); ++i) r.push_back(p[i] * Rational(static_cast<int>(i)));
  return r;
}

/// Quotient and remainder; the remainder and a quotient of Sturm's chain are scaled by no one.
inline std::pair<Polynomial, Polynomial> divided(Polynomial p, const Polynomial& by) {
  Polynomial quotient(p.size() >= by.size() ? p.size() - by.size() + 1 : 0, Rational(0));
  while (p.size() >= by.size()) {
    const std::size_t shift = p.size() - by.size();
    const Rational factor = p.back() / by.back();
    quotient[shift] = factor;
    for (std::size_t i = 0; i < by.size(); ++i) p[i + shift] = p[i + shift] - factor * by[i];
    p.pop_back();
    p = trimmed(p);
  }
  return {trimmed(quotient), p};
}
inline Polynomial common_divisor(Polynomial p, Polynomial q) {
  while (!q.empty()) {
    Polynomial rest = divided(p, q).second;
    p = std::exchange(q, rest);
  }
  const Rational lead = p.back();
  for (Rational& c : p) c = c / lead;
  return p;
}
/// The same roots, each once.
inline Polynomial square_free(const Polynomial& p) {
  if (p.size() < 3) return p;
  return divided(p, common_divisor(p, derivative(p))).first;
}

/// Sturm's chain of a polynomial that is not 0 and has no double root.
class Sturm {
 public:
  explicit Sturm(const Polynomial& p) : chain_{p} {
    if (p.size() < 2) return;
    chain_.push_back(derivative(p));
    while (chain_.back().size() > 1) {
      Polynomial rest = divided(chain_[chain_.size() - 2], chain_.back()).second;
      if (rest.empty()) break;
      const Rational size = rest.back() < 0 ? Rational(-rest.back()) : rest.back();
      for (Rational& c : rest) c = -c / size;  // a positive factor changes no sign
      chain_.push_back(rest);
    }
  }
  /// The number of roots t with low < t ≤ high.
  int roots(const Rational& low, const Rational& high) const {
    return changes(low) - changes(high);
  }

 private:
  int changes(const Rational& t) const {
    int count = 0, last = 0;
    for (const Polynomial& p : chain_) {
      const int sign = oracle::sign(at(p, t));
      if (sign == 0) continue;
      if (last != 0 && sign != last) ++count;
      last = sign;
    }
    return count;
  }
  std::vector<Polynomial> chain_;
};

/// The only root of a polynomial in low < t ≤ high, or t = low = high.
class Root {
 public:
  Root(const Polynomial& p, Rational low, Rational high)
      : p_(p), sturm_(p), low_(std::move(low)), high_(std::move(high)) {
    if (low_ != high_ && at(p_, high_) == 0) low_ = high_;
  }
  const Rational& low() const { return low_; }
  const Rational& high() const { return high_; }

  void halve() {
    if (low_ == high_) return;
    const Rational middle = (low_ + high_) / 2;
    if (at(p_, middle) == 0) {
      low_ = high_ = middle;
    } else if (sturm_.roots(low_, middle) > 0) {
      high_ = middle;
    } else {
      low_ = middle;
    }
  }
  /// The sign of a polynomial at this root.
  int sign_of(const Polynomial& q) {
    if (q.empty()) return 0;
    if (low_ == high_) return oracle::sign(at(q, low_));
    const Polynomial both = common_divisor(p_, q);
    if (both.size() > 1 && Sturm(both).roots(low_, high_) > 0) return 0;
    const Sturm others(square_free(q));
    while (low_ != high_ && (at(q, high_) == 0 || others.roots(low_, high_) > 0)) halve();
    return oracle::sign(at(q, high_));
  }
  /// The nearest double: the interval is halved until both ends round alike.
  double nearest() {
    for (int i = 0; i < 2200 && oracle::nearest(low_) != oracle::nearest(high_); ++i) halve();
    return oracle::nearest(high_);
  }
  bool operator<(Root& other) {
    while (true) {
      if (high_ <= other.low_ && (low_ != high_ || high_ != other.low_)) return true;
      if (other.high_ <= low_) return false;
      const Polynomial both = common_divisor(p_, other.p_);
      if (both.size() > 1) {
        const Rational low = std::max(low_, other.low_), high = std::min(high_, other.high_);
        if (low == high ? at(both, low) == 0 : Sturm(both).roots(low, high) > 0) return false;
      }
      if (low_ == high_ && other.low_ == other.high_) return low_ < other.low_;
      halve();
      other.halve();
    }
  }

 private:
  Polynomial p_;
  Sturm sturm_;
  Rational low_, high_;
};

/// The roots in [0, 1] in increasing order; none of the polynomial 0.
inline std::vector<Root> roots_in_step(const Polynomial& given) {
  std::vector<Root> found;
  const Polynomial p = square_free(given);
  if (p.size() < 2) return found;
  if (p[0] == 0) found.emplace_back(p, Rational(0), Rational(0));
  const Sturm sturm(p);
  std::vector<std::pair<Rational, Rational>> open{{Rational(0), Rational(1)}};
  while (!open.empty()) {
    const auto [low, high] = open.back();
    open.pop_back();
    const int count = sturm.roots(low, high);
    if (count == 1) found.emplace_back(p, low, high);
    if (count < 2) continue;
    const Rational middle = (low + high) / 2;
    open.emplace_back(middle, high);
    open.emplace_back(low, middle);
  }
  return found;
}

/// A vector of polynomials.
using Track = std::array<Polynomial, 3>;

inline Track track(const oracle::Vector& start, const oracle::Vector& displacement) {
  Track made;
  for (int k = 0; k < 3; ++k)
    made[static_cast<std::size_t>(k)] = trimmed({start(k), displacement(k)});
  return made;
}
inline Track minus(const Track& p, const Track& q) {
  return {sum(p[0], q[0], -1), sum(p[1], q[1], -1), sum(p[2], q[2], -1)};
}
inline Polynomial dot(const Track& p, const Track& q) {
  return sum(sum(product(p[0], q[0]), product(p[1], q[1])), product(p[2], q[2]));
}
inline Track cross(const Track& p, const Track& q) {
  const auto component = [&](std::size_t i, std::size_t j) {
    return sum(product(p[i], q[j]), product(p[j], q[i]), -1);
  };
  return {component(1, 2), component(2, 0), component(0, 1)};
}
inline bool is_zero(Root& t, const Track& p) {
  return t.sign_of(p[0]) == 0 && t.sign_of(p[1]) == 0 && t.sign_of(p[2]) == 0;
}

/// Four points that move linearly: a vertex and a face, or two edges.
struct Four {
  std::array<oracle::Vector, 4> start, displacement;
  Track at(std::size_t k) const { return track(start[k], displacement[k]); }
};

/// Whether p is on the segment from a to b at a time.
inline bool on_segment(Root& t, const Track& p, const Track& a, const Track& b) {
  const Track from_a = minus(p, a), from_b = minus(p, b);
  return t.sign_of(dot(from_a, from_b)) <= 0 && is_zero(t, cross(from_a, from_b));
}
/// Whether the first of four points is in the triangle of the others at a time.
inline bool in_face(Root& t, const std::array<Track, 4>& x) {
  const Track normal = cross(minus(x[2], x[1]), minus(x[3], x[1]));
  if (t.sign_of(dot(normal, minus(x[0], x[1]))) != 0) return false;
  for (std::size_t k = 0; k < 3; ++k) {
    const Track &a = x[1 + k], &b = x[1 + (k + 1) % 3];
    if (on_segment(t, x[0], a, b)) return true;
  }
  if (is_zero(t, normal)) return false;  // the triangle is its edges
  for (std::size_t k = 0; k < 3; ++k) {
    const Track &a = x[1 + k], &b = x[1 + (k + 1) % 3];
    if (t.sign_of(dot(normal, cross(minus(b, a), minus(x[0], a)))) < 0) return false;
  }
  return true;
}
/// Whether the segments from x[0] to x[1] and from x[2] to x[3] have a common point at a time.
inline bool edges_meet(Root& t, const std::array<Track, 4>& x) {
  const Track first = minus(x[1], x[0]), second = minus(x[3], x[2]), between = minus(x[2], x[0]);
  const Track normal = cross(first, second);
  if (t.sign_of(dot(normal, between)) != 0) return false;
  if (is_zero(t, normal)) {
    return on_segment(t, x[0], x[2], x[3]) || on_segment(t, x[1], x[2], x[3]) ||
           on_segment(t, x[2], x[0], x[1]) || on_segment(t, x[3], x[0], x[1]);
  }
  const Polynomial square = dot(normal, normal);
  for (const Track& along : {second, first}) {
    const Polynomial part = dot(cross(between, along), normal);
    if (t.sign_of(part) < 0 || t.sign_of(sum(square, part, -1)) < 0) return false;
  }
  return true;
}

/// When a set of signs first holds. They can only begin to hold at a root of one of the
/// polynomials, or at 0.
template <class Holds>
std::optional<Root> first_time(const Polynomial& coplanar, const std::vector<Polynomial>& others,
                               const std::array<Track, 4>& x, Holds holds) {
  std::vector<Root> times{Root({}, Rational(0), Rational(0))};
  const auto add = [&times](const Polynomial& p) {
    for (const Root& root : roots_in_step(p)) times.push_back(root);
  };
  if (coplanar.empty()) {
    for (const Polynomial& p : others) add(p);
  } else {
    add(coplanar);
  }
  std::optional<Root> first;
  for (Root& t : times) {
    if (first && !(t < *first)) continue;
    if (holds(t, x)) first = t;
  }
  return first;
}

inline std::array<Track, 4> tracks(const Four& four) {
  return {four.at(0), four.at(1), four.at(2), four.at(3)};
}
inline void add_all(std::vector<Polynomial>& to, const Track& p) {
  to.insert(to.end(), p.begin(), p.end());
}

/// The first time in [0, 1] at which the vertex, point 0, is in the face of points 1, 2 and 3.
inline std::optional<Root> vertex_face(const Four& four) {
  const std::array<Track, 4> x = tracks(four);
  const Track normal = cross(minus(x[2], x[1]), minus(x[3], x[1]));
  const Polynomial coplanar = dot(normal, minus(x[0], x[1]));
  std::vector<Polynomial> others;
  if (coplanar.empty()) {
    add_all(others, normal);
    for (std::size_t k = 0; k < 3; ++k) {
      const Track &a = x[1 + k], &b = x[1 + (k + 1) % 3];
      const Track side = cross(minus(b, a), minus(x[0], a));
      add_all(others, side);
      others.push_back(dot(normal, side));
      others.push_back(dot(minus(x[0], a), minus(x[0], b)));
    }
  }
  return first_time(coplanar, others, x, in_face);
}

/// The first time in [0, 1] at which the edges from point 0 to 1 and from 2 to 3 meet.
inline std::optional<Root> edge_edge(const Four& four) {
  const std::array<Track, 4> x = tracks(four);
  const Track first = minus(x[1], x[0]), second = minus(x[3], x[2]), between = minus(x[2], x[0]);
  const Track normal = cross(first, second);
  const Polynomial coplanar = dot(normal, between);
  std::vector<Polynomial> others;
  if (coplanar.empty()) {
    add_all(others, normal);
    const Polynomial square = dot(normal, normal);
    for (const Track& along : {second, first}) {
      const Polynomial part = dot(cross(between, along), normal);
      others.push_back(part);
      others.push_back(sum(square, part, -1));
    }
    for (const auto& [p, a, b] :
         {std::array<std::size_t, 3>{0, 2, 3}, {1, 2, 3}, {2, 0, 1}, {3, 0, 1}}) {
      add_all(others, cross(minus(x[p], x[a]), minus(x[p], x[b])));
      others.push_back(dot(minus(x[p], x[a]), minus(x[p], x[b])));
    }
  }
  return first_time(coplanar, others, x, edges_meet);
}

}  // namespace moving_truth
