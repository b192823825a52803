#include "ray_box.hpp"

namespace exercise {

std::optional<Entry> ray_box(const contact::Ray<double>& ray, const Box& box) {
  //? In no slab yet, so the ray is in all of them from −∞ to ∞.
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Entry latest{-infinity, -1};
  double earliest_exit = infinity;
  for (int axis = 0; axis < 3; ++axis) {
    const double from = ray.origin[axis], along = ray.direction[axis];
    //? A coordinate that does not change is in its slab for every t or for none.
    //? gap: from < box.low[axis] || from > box.high[axis]
    if (along == 0) {
      if (from < box.low[axis] || from > box.high[axis]) return std::nullopt;
      continue;
    }
    //? A ray that goes down the axis meets the upper face first.
    //? gap: along > 0
    double entry = (box.low[axis] - from) / along;
    double exit = (box.high[axis] - from) / along;
    if (!(along > 0)) std::swap(entry, exit);
    //? It is in the box from the latest entry to the earliest exit. Of equal entries the first
    //? stays, which is that of the lowest axis.
    //? gap: entry > latest.t
    //? gap: std::min(earliest_exit, exit)
    if (entry > latest.t) latest = {entry, axis};
    earliest_exit = std::min(earliest_exit, exit);
  }
  //? Beside the box a slab is left before the last one is entered; behind the start all of it has
  //? been left.
  //? gap: latest.t > earliest_exit
  //? gap: earliest_exit < 0
  if (latest.t > earliest_exit || earliest_exit < 0) return std::nullopt;
  //? Entered before the start: the ray starts inside.
  if (latest.t < 0) return Entry{0, -1};
  return latest;
}

}  // namespace exercise
