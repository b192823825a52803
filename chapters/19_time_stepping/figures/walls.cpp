// A ball in a room with a leaning wall: one step with all its impacts.
#include <algorithm>
#include <contact/advance.hpp>
#include <contact/figure.hpp>

using Vector2 = Eigen::Matrix<double, 2, 1>;

struct Input {
  Vector2 from;    // the ball's centre, m
  Vector2 to;      // position after a second without walls and gravity, m
  Vector2 lean;    // a point of the leaning wall, which starts at the origin
  double step;     // s
  double k;        // coefficient of restitution
  double most;     // impacts that the rules allow
  double gravity;  // m/s², downwards
};

constexpr int max_shown = 16;
constexpr int pieces = 12;
constexpr int points = (max_shown + 1) * pieces + 1;
constexpr double radius = 0.15;
constexpr double width = 5;  // of the floor, m

struct Output {
  double problem;
  std::array<double, points> x, y;             // the centre's path
  std::array<double, max_shown> hit_x, hit_y;  // the centre at each impact
  double impacts;
  double end;        // 0 used up, 1 rests, 2 out of impacts
  double time_left;  // s
  Vector2 last, velocity;
  Vector2 naive;  // result of a program that tests once a step
  double five;    // goal: five impacts in this step, and the step used up
};

Output compute(const Input& in) {
  Output out{};
  const double size = std::max({in.from.cwiseAbs().maxCoeff(), in.to.cwiseAbs().maxCoeff(),
                                in.lean.cwiseAbs().maxCoeff(), in.gravity});
  if (!(in.step > 0) || !(in.lean.y() > 0)) out.problem = contact::figure::not_positive;
  if (size > 1e6 || in.step > 1e3 || in.k > 1 || in.most > max_shown) {
    out.problem = contact::figure::too_large;
  }
  if (out.problem == 0 && (in.k < 0 || in.most < 1 || in.gravity < 0 || in.lean.norm() < 1e-6)) {
    out.problem = contact::figure::too_small;
  }
  if (out.problem != 0) return out;

  using V = contact::Vector3<double>;
  const V along(in.lean.x(), in.lean.y(), 0);
  const V leaning = V(in.lean.y(), -in.lean.x(), 0) / along.norm();
  const std::vector<contact::Plane<double>> walls{
      {V(0, 1, 0), 0}, {leaning, 0}, {V(-1, 0, 0), -width}};
  // A ball that was dragged into a wall is moved out of it.
  V centre(in.from.x(), in.from.y(), 0);
  for (int round = 0; round < 3; ++round) {
    for (const auto& wall : walls) {
      const double gap = wall.normal.dot(centre) - wall.offset - radius;
      if (gap < 0) centre -= wall.normal * gap;
    }
  }
  const V velocity(in.to.x() - centre.x(), in.to.y() - centre.y(), 0);
  const contact::MotionState<V> start{centre, velocity};
  const V pull(0, -in.gravity, 0);
  const double rest_speed = 0.02;
  const int most = static_cast<int>(in.most);
  const auto after = [&](double t, int impacts) {
    return contact::advance_ballistic<double>(start, pull, radius, t, walls,
                                              contact::impact_rules(in.k, rest_speed, impacts));
  };

  const auto end = after(in.step, most);
  const double moved = in.step - end.time_left;
  // Times and positions of the impacts: with a limit of i impacts the advance stops at the next.
  std::array<double, max_shown + 2> times{};
  for (int i = 0; i < end.impacts; ++i) {
    const auto there = after(in.step, i);
    const auto n = static_cast<std::size_t>(i);
    times[n + 1] = in.step - there.time_left;
    out.hit_x[n] = there.state.position.x();
    out.hit_y[n] = there.state.position.y();
  }
  times[static_cast<std::size_t>(end.impacts) + 1] = moved;

  std::size_t at = 0;
  out.x[at] = centre.x();
  out.y[at++] = centre.y();
  for (int flight = 0; flight <= end.impacts; ++flight) {
    const double begin = times[static_cast<std::size_t>(flight)];
    const double until = times[static_cast<std::size_t>(flight) + 1];
    for (int i = 1; i <= pieces; ++i) {
      const double t = begin + (until - begin) * i / pieces;
      const V centre_then = after(t, max_shown + 1).state.position;
      out.x[at] = centre_then.x();
      out.y[at++] = centre_then.y();
    }
  }
  for (; at < points; ++at) {
    out.x[at] = out.x[at - 1];
    out.y[at] = out.y[at - 1];
  }
  for (auto i = static_cast<std::size_t>(end.impacts); i < max_shown; ++i) {
    out.hit_x[i] = end.state.position.x();
    out.hit_y[i] = end.state.position.y();
  }
  out.impacts = end.impacts;
  out.end = static_cast<double>(static_cast<int>(end.end));
  out.time_left = end.time_left;
  out.last = {end.state.position.x(), end.state.position.y()};
  out.velocity = {end.state.velocity.x(), end.state.velocity.y()};
  // The same step by a program that reflects once and then moves on without a test.
  auto once = after(in.step, 0);
  if (end.impacts > 0) {
    const V normal = walls[static_cast<std::size_t>(once.wall)].normal;
    once.state.velocity = contact::after_bounce<double>(once.state.velocity, normal, in.k);
    once.state = contact::ballistic_motion<V, double>(once.state, pull, once.time_left);
  }
  out.naive = {once.state.position.x(), once.state.position.y()};
  out.five = end.impacts == 5 && end.end == contact::AdvanceEnd::used_up ? 1 : 0;
  return out;
}

FIGURE(Input, FIELDS(from, to, lean, step, k, most, gravity), Output,
       FIELDS(problem, x, y, hit_x, hit_y, impacts, end, time_left, last, velocity, naive, five))
