/// @file
/// A point among round posts at all whole coordinates of the plane, and a second one that starts
/// beside it: how far apart they are at each hit.
#pragma once

#include <cmath>
#include <optional>
#include <vector>

namespace twins {

inline constexpr double radius = 0.4;         ///< of the posts, m
inline constexpr double beside = 1e-12;       ///< where the second point starts, to the left, m
inline constexpr double max_flight = 10;      ///< longer ones are not followed, m
inline constexpr double min_distance = 1e-6;  ///< of a start from every post, m

/// A hit of the first point.
struct Hit {
  double flight;  ///< to it from the hit before, or from the start, m
  double cosine;  ///< of the angle between path and normal
  double apart;   ///< distance of the two points at the time of the hit, m
};

template <class S>
struct Vector {
  S x, y;
};
template <class S>
Vector<S> operator+(const Vector<S>& a, const Vector<S>& b) {
  return {a.x + b.x, a.y + b.y};
}
template <class S>
Vector<S> operator-(const Vector<S>& a, const Vector<S>& b) {
  return {a.x - b.x, a.y - b.y};
}
template <class S>
Vector<S> operator*(const S& s, const Vector<S>& a) {
  return {s * a.x, s * a.y};
}
template <class S>
S dot(const Vector<S>& a, const Vector<S>& b) {
  return a.x * b.x + a.y * b.y;
}

/// A point that flies at 1 m/s and is reflected.
template <class S>
class Flight {
 public:
  /// @param direction of length 1
  Flight(Vector<S> position, Vector<S> direction)
      : position_(position), direction_(direction), time_(0.0) {
    find_next();
  }

  bool hits_again() const { return next_.has_value(); }
  S next_time() const { return time_ + *next_; }
  S next_flight() const { return *next_; }

  Vector<S> position_at(const S& time) const { return position_ + (time - time_) * direction_; }

  /// To the next hit, and away from it.
  /// @return the cosine
  S reflect() {
    time_ = time_ + *next_;
    position_ = position_ + *next_ * direction_;
    const Vector<S> out = position_ - post_;
    const Vector<S> normal = S(1.0) / sqrt(dot(out, out)) * out;
    const S cosine = S(0.0) - dot(normal, direction_);
    direction_ = direction_ + S(2.0) * cosine * normal;
    // The length stays 1 but for rounding, which would grow with it.
    direction_ = S(1.0) / sqrt(dot(direction_, direction_)) * direction_;
    find_next();
    return cosine;
  }

 private:
  Vector<S> position_, direction_;
  S time_;  ///< of the last hit
  Vector<S> post_{};
  std::optional<S> next_;  ///< until the next hit

  // A post that is hit after a flight of t is at most 1 m, in x and in y, from the whole
  // coordinates that are nearest to a point of the path at t ± 0.25.
  void find_next() {
    next_.reset();
    const double x = static_cast<double>(position_.x), y = static_cast<double>(position_.y);
    const double dx = static_cast<double>(direction_.x), dy = static_cast<double>(direction_.y);
    for (double along = 0; along <= max_flight; along += 0.5) {
      if (next_ && static_cast<double>(*next_) + 0.5 < along) return;
      const double column = std::round(x + along * dx), row = std::round(y + along * dy);
      for (const double i : {column - 1, column, column + 1})
        for (const double j : {row - 1, row, row + 1}) try_post({S(i), S(j)});
    }
  }

  void try_post(const Vector<S>& post) {
    const Vector<S> off = position_ - post;
    const S along = dot(off, direction_);
    if (!(along < S(0.0))) return;
    const S squared = along * along - dot(off, off) + S(radius) * S(radius);
    if (!(squared > S(0.0))) return;
    const S time = S(0.0) - along - sqrt(squared);
    if (next_ && !(time < *next_)) return;
    next_ = time;
    post_ = post;
  }
};

/// Whether a point is farther than `min_distance` from every post. For tests only near x and y from
/// 0 to 1, whose posts are the four around.
template <class S>
bool is_outside(const Vector<S>& position) {
  for (const double i : {0.0, 1.0}) {
    for (const double j : {0.0, 1.0}) {
      const Vector<S> off = position - Vector<S>{S(i), S(j)};
      if (!(dot(off, off) > (S(radius) + S(min_distance)) * (S(radius) + S(min_distance))))
        return false;
    }
  }
  return true;
}

/// The first hits, at most `hits`: up to the one at whose time the points are farther apart than
/// `limit`, or to the last one before a flight of more than `max_flight`.
template <class S>
std::vector<Hit> follow(double x, double y, double dx, double dy, int hits, double limit) {
  const S length = sqrt(S(dx) * S(dx) + S(dy) * S(dy));
  const Vector<S> direction{S(dx) / length, S(dy) / length};
  const Vector<S> position{S(x), S(y)};
  const Vector<S> left{S(0.0) - direction.y, direction.x};
  Flight<S> first(position, direction);
  Flight<S> second(position + S(beside) * left, direction);
  std::vector<Hit> found;
  while (static_cast<int>(found.size()) < hits && first.hits_again()) {
    const S time = first.next_time();
    const double flight = static_cast<double>(first.next_flight());
    while (second.hits_again() && second.next_time() < time) second.reflect();
    const Vector<S> off = first.position_at(time) - second.position_at(time);
    const double apart = static_cast<double>(sqrt(dot(off, off)));
    found.push_back({flight, static_cast<double>(first.reflect()), apart});
    if (apart > limit || flight > max_flight) break;
  }
  return found;
}

}  // namespace twins
