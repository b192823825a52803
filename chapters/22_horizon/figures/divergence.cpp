// A billiard with four posts, played twice from positions that are very close together.
#include "figures/four_posts.hpp"

#include <algorithm>
#include <contact/events/hard_spheres.hpp>
#include <contact/figure.hpp>

using Vector2 = Eigen::Matrix<double, 2, 1>;
using four_posts::ball_radius;
using four_posts::height;
using four_posts::posts;
using four_posts::width;

struct Input {
  Vector2 from;   // the ball's centre, m
  Vector2 to;     // where it is aimed
  double digits;  // the second begins 10^−digits m to the right
  double post;    // radius of the posts, m
  double shown;   // impacts that are followed
};

constexpr int most = 40;

struct Output {
  double problem;
  std::array<double, most + 1> x, y, other_x, other_y;  // both balls at each impact of the first
  std::array<double, most + 1> apart;                   // m
  std::array<double, most + 1> lens;                    // the distance by the lens formula, m
  double impacts;                                       // followed
  double on_posts;                                      // of them
  double diverged;  // impacts until they are a ball's radius apart; 0: not yet
  double way;       // mean distance from post to post, m
  double quick;     // goal: a radius apart within 25 impacts, from 1e-15 m
};

namespace {

constexpr contact::HardSphereEffects plane{
    .dimension = 2, .gravity = false, .sizes = true, .restitution = false, .grid = false};

using Place = std::array<double, 2>;

class Impacts : public contact::HardSphereObserver {
 public:
  bool on_hit(const contact::HardSphereHit& hit) override {
    time[count] = hit.time;
    on_post[count] = hit.partner <= posts.size();
    return ++count < most;
  }
  std::array<double, most> time{};
  std::array<bool, most> on_post{};
  std::size_t count = 0;
};

contact::HardSphereSetup room_with_posts(double post) {
  contact::HardSphereSetup setup;
  setup.balls.push_back({.radius = ball_radius, .mass = 1});
  for (const Place& p : posts)
    setup.balls.push_back({.position = {p[0], p[1], 0}, .radius = post, .moves = false});
  setup.walls = {{{1, 0, 0}, 0}, {{-1, 0, 0}, -width}, {{0, 1, 0}, 0}, {{0, -1, 0}, -height}};
  return setup;
}

}  // namespace

Output compute(const Input& in) {
  Output out{};
  if (!(in.post > 0)) out.problem = contact::figure::not_positive;
  if (in.post > four_posts::largest_post || in.digits > 15 || in.shown > most ||
      std::max(in.from.cwiseAbs().maxCoeff(), in.to.cwiseAbs().maxCoeff()) > 1e3) {
    out.problem = contact::figure::too_large;
  }
  if (out.problem == 0 && (in.post < four_posts::least_post || in.digits < 1 || in.shown < 1 ||
                           (in.to - in.from).norm() < 1e-3)) {
    out.problem = contact::figure::too_small;
  }
  if (out.problem != 0) return out;

  // A ball that overlaps a post or a wall is moved out of it.
  Vector2 from = in.from;
  const double reach = in.post + ball_radius;
  for (int round = 0; round < 3; ++round) {
    for (const Place& place : posts) {
      const Vector2 p(place[0], place[1]);
      const Vector2 d = from - p;
      const double distance = d.norm();
      if (distance >= 1.01 * reach) continue;
      from = p + (distance > 0 ? Vector2(d / distance) : Vector2(1, 0)) * (1.02 * reach);
    }
    from.x() = std::clamp(from.x(), 1.01 * ball_radius, width - 1.01 * ball_radius);
    from.y() = std::clamp(from.y(), 1.01 * ball_radius, height - 1.01 * ball_radius);
  }
  Vector2 aim = in.to - from;
  if (!(aim.norm() > 1e-9)) aim = Vector2(1, 0);
  aim /= aim.norm();
  double gap = 1;
  for (int k = 0; k < static_cast<int>(in.digits); ++k) gap /= 10;

  contact::HardSphereSetup setup = room_with_posts(in.post);
  setup.balls[0].position = {from.x(), from.y(), 0};
  setup.balls[0].velocity = {aim.x(), aim.y(), 0};
  contact::HardSpheres<plane> one(setup);
  Impacts impacts;
  contact::HardSpheres<plane>(setup).advance(1e3, most, &impacts);
  setup.balls[0].position.x() += gap;
  contact::HardSpheres<plane> other(setup);

  const auto count = std::min(impacts.count, static_cast<std::size_t>(in.shown));
  out.impacts = static_cast<double>(count);
  double lens = gap;
  double last = 0;
  for (std::size_t k = 0; k <= most; ++k) {
    if (k > 0 && k <= count) {
      const double now = impacts.time[k - 1];
      one.advance(now);
      other.advance(now);
      if (impacts.on_post[k - 1]) {
        // [lens]
        // At 1 m/s the distance between two impacts on posts equals the time. Before the first one
        // the paths are parallel.
        if (out.on_posts > 0) {
          lens *= 1 + 2 * (now - last) / reach;
          out.way = (out.way * (out.on_posts - 1) + (now - last)) / out.on_posts;
        }
        // [/lens]
        out.on_posts += 1;
        last = now;
      }
    }
    const contact::Vector3<double> here = one.position(0);
    const contact::Vector3<double> there = other.position(0);
    out.x[k] = here.x();
    out.y[k] = here.y();
    out.other_x[k] = there.x();
    out.other_y[k] = there.y();
    out.apart[k] = (here - there).norm();
    out.lens[k] = std::min(lens, 5.0);
    if (out.diverged == 0 && out.apart[k] > ball_radius && k <= count)
      out.diverged = static_cast<double>(k);
  }
  out.quick = out.diverged > 0 && out.diverged <= 25 && gap < 2e-15 ? 1 : 0;
  return out;
}

FIGURE(Input, FIELDS(from, to, digits, post, shown), Output,
       FIELDS(problem, x, y, other_x, other_y, apart, lens, impacts, on_posts, diverged, way,
              quick))
