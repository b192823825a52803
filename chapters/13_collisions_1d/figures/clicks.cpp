// Two blocks and a wall: the velocities of both as a point that is reflected on a circle.
#include <contact/block_count.hpp>
#include <contact/figure.hpp>

struct Input {
  double ratio;  // M/m
  double step;   // number of collisions so far
};

struct Output {
  double problem;
  double clicks;                // certain count
  std::array<double, 33> x, y;  // √M V and √m v after each collision, as parts of √(2K); the last
                                // is repeated
  double large, small;      // velocities after `step` collisions, relative to the initial one
  double done;              // number of collisions shown: step, or all
  double slope_x, slope_y;  // the direction in which V = v
};

Output compute(const Input& in) {
  Output out{};
  if (!(in.ratio >= 1)) out.problem = contact::figure::too_small;
  if (in.ratio > 100) out.problem = contact::figure::too_large;
  if (out.problem != 0) return out;
  out.clicks = static_cast<double>(contact::count_collisions(in.ratio).value_or(0));
  const double root = std::sqrt(in.ratio);
  auto large = contact::line_body(in.ratio, 1.0);
  auto small = contact::line_body(1.0, 0.0);
  const auto wall = contact::line_body(std::numeric_limits<double>::infinity(), 0.0);
  for (std::size_t i = 0; i < out.x.size(); ++i) {
    out.x[i] = large.velocity;
    out.y[i] = small.velocity / root;
    const auto k = static_cast<double>(i);
    if (k <= in.step && k <= out.clicks) {
      out.large = large.velocity;
      out.small = small.velocity;
      out.done = k;
    }
    if (k >= out.clicks) continue;
    if (i % 2 == 0) {
      const auto after = contact::collide(large, small, 1.0);
      large.velocity = after.first;
      small.velocity = after.second;
    } else {
      small.velocity = contact::collide(small, wall, 1.0).first;
    }
  }
  out.slope_x = root / std::sqrt(in.ratio + 1);
  out.slope_y = 1 / std::sqrt(in.ratio + 1);
  return out;
}

FIGURE(Input, FIELDS(ratio, step), Output,
       FIELDS(problem, clicks, x, y, large, small, done, slope_x, slope_y))
