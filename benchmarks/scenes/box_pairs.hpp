/// @file
/// Time of impact of two translating boxes: the book's sweep and Bullet's convex casts. Bullet's
/// headers are included only in their own file.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "summary.hpp"

namespace box_pairs {

/// A box as plain numbers.
struct MovingBox {
  double axes[9];          ///< columns, one after the other
  double centre[3];        ///< m
  double half_lengths[3];  ///< m
  double displacement[3];  ///< in the step, m
};

/// Which of Bullet's convex casts is asked.
enum class Cast { continuous, gjk, subsimplex };

/// The pairs as Bullet holds them, made ready before the clock runs.
class Bullet {
 public:
  /// @param boxes two for each pair
  explicit Bullet(const std::vector<MovingBox>& boxes);
  ~Bullet();
  Bullet(const Bullet&) = delete;
  Bullet& operator=(const Bullet&) = delete;
  /// The fraction of the step at which each pair touches, or nothing.
  std::vector<std::optional<double>> times(Cast cast) const;

 private:
  struct Pairs;
  std::unique_ptr<Pairs> pairs_;
};

/// Pairs of each kind by every method, in turns; what is right is decided by fractions.
/// @param count pairs of each kind
/// @param runs of which medians are taken
void compare_all(int count, int runs, Summary& summary);

}  // namespace box_pairs
