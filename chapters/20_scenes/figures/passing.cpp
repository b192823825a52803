// A body flies to a thin plate, with a test for contact once a step: what the tests detect, and
// what is proven about them before.
#include <algorithm>
#include <contact/figure.hpp>
#include <contact/plan/plan_bounds.hpp>
#include <contact/sine_cosine.hpp>

struct Input {
  double height;            // of the body's centre over the plate's middle, m
  double speed;             // downwards, m/s
  double angular_velocity;  // rad/s
  double step;              // s
  double thick;             // the plate, m
  double gravity;           // downwards, m/s²
  double shape;             // 0: a ball, 1: a rod
};

constexpr int samples = 121;
constexpr double seconds = 0.5;
constexpr double radius = 0.1;    // of the ball, and half of the rod's thickness, m
constexpr double half = 0.5;      // half of the rod's, m
constexpr double lowest = -1.25;  // the picture's end, m

struct Output {
  double problem;
  std::array<double, samples> y, sine, cosine;  // the body at each test
  double count;                                 // tests in the picture
  double seen;                                  // the first test that detects the plate; −1: none
  double passes;   // 1 if it comes out below and no test has detected it
  double closing;  // surface points never approach faster, by energy, m/s
  double plain;    // v + ω r + g t, m/s
  double moved;    // in a step, m
  double room;     // twice the sum of the thicknesses, m
  double longest;  // step that is proven, s
  double proven;   // 1 if moved < room
  double tight;    // goal: proven, with more than nine tenths of room
};

namespace {

contact::SceneBody body_of(const Input& in) {
  contact::SceneBody body;
  body.mass = 1;
  body.position = {0, in.height, 0};
  body.velocity = {0, -in.speed, 0};
  body.angular_velocity = {0, 0, in.angular_velocity};
  if (in.shape == 0) {
    body.shape = contact::BallShape{radius};
    body.inertia = contact::Vector3<double>::Constant(0.4 * radius * radius).asDiagonal();
  } else {
    body.shape = contact::BoxShape{{half, radius, radius}};
    const double across = (half * half + radius * radius) / 3;
    body.inertia = contact::Vector3<double>(2 * radius * radius / 3, across, across).asDiagonal();
  }
  return body;
}

}  // namespace

Output compute(const Input& in) {
  Output out{};
  if (!(in.step > 0) || !(in.thick > 0)) out.problem = contact::figure::not_positive;
  if (std::max({std::abs(in.height), std::abs(in.speed), std::abs(in.angular_velocity), in.step,
                in.thick, std::abs(in.gravity)}) > 1e6) {
    out.problem = contact::figure::too_large;
  }
  if (out.problem == 0 && (in.step < seconds / (samples - 1) || in.speed < 0 || in.gravity < 0 ||
                           in.thick < 1e-6 || in.height < half + radius + in.thick)) {
    out.problem = contact::figure::too_small;
  }
  if (out.problem != 0) return out;

  contact::Scene scene;
  scene.gravity = {0, -in.gravity, 0};
  scene.duration = seconds;
  scene.materials.resize(1);
  contact::SceneBody plate;
  plate.shape = contact::BoxShape{{4, in.thick / 2, 4}};
  plate.moves = false;
  scene.bodies = {body_of(in), plate};
  const contact::SceneBounds bounds = contact::scene_bounds(scene);
  // A body that never comes near the plate has no pair.
  if (!bounds.pairs.empty()) {
    out.closing = bounds.pairs.front().closing;
    out.room = 2 * bounds.pairs.front().core;
  }
  const double lever_arm = in.shape == 0 ? 0.0 : std::sqrt(half * half + radius * radius);
  out.plain = in.speed + std::abs(in.angular_velocity) * lever_arm + in.gravity * seconds;
  out.moved = out.closing * in.step;
  out.longest = out.closing > 0 ? out.room / out.closing : seconds;
  out.proven = out.moved < out.room || bounds.pairs.empty() ? 1 : 0;
  out.tight = out.proven > 0 && out.moved > 0.9 * out.room ? 1 : 0;

  out.seen = -1;
  std::size_t n = 0;
  bool below = false;
  for (; n < samples && !below; ++n) {
    const double t = static_cast<double>(n) * in.step;
    if (t > seconds) break;
    const auto turn = contact::sine_cosine(in.angular_velocity * t);
    out.y[n] = in.height - in.speed * t - in.gravity * t * t / 2;
    out.sine[n] = turn.sine;
    out.cosine[n] = turn.cosine;
    // The body's vertical half extent; the plate extends to both sides.
    const double reach =
        in.shape == 0 ? radius : half * std::abs(turn.sine) + radius * std::abs(turn.cosine);
    const bool touches = std::abs(out.y[n]) <= in.thick / 2 + reach;
    if (touches && out.seen < 0) out.seen = static_cast<double>(n);
    out.passes = out.seen < 0 && out.y[n] < 0 ? 1 : 0;
    below = out.y[n] < lowest;
  }
  out.count = static_cast<double>(n);
  for (std::size_t k = n; k < samples; ++k) {
    out.y[k] = out.y[n - 1];
    out.sine[k] = out.sine[n - 1];
    out.cosine[k] = out.cosine[n - 1];
  }
  return out;
}

FIGURE(Input, FIELDS(height, speed, angular_velocity, step, thick, gravity, shape), Output,
       FIELDS(problem, y, sine, cosine, count, seen, passes, closing, plain, moved, room, longest,
              proven, tight))
