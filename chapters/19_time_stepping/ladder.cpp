// Positions after some seconds, and the number of impacts until then: a fall, a spring, a bouncing
// ball, two balls and a wall, each in steps of several kinds and without steps.
#include <support/ladder.hpp>

#include <contact/ballistic.hpp>
#include <contact/bouncing.hpp>
#include <contact/double_double.hpp>
#include <contact/fixed_step_bounce.hpp>
#include <contact/rollback.hpp>
#include <contact/spring_motion.hpp>
#include <contact/two_balls_wall.hpp>

namespace {

using contact::BounceState;
using contact::DoubleDouble;
using contact::Integrator;
using contact::MotionState;
using contact::TwoBallsAndWall;

enum class Motion { fall, spring, bounce, two_balls };

/// One of the four motions; members that only the others need keep their defaults. The conversion
/// to float is not timed.
template <class S>
struct Scene {
  MotionState<S> start{S(0), S(0)};
  S gravity = S(0);
  contact::LinearSpring<S> spring;
  contact::BouncingBall<S> ball;
  TwoBallsAndWall<S> balls;
  S time = S(0);
};
struct Input {
  Motion motion = Motion::fall;
  Scene<double> wide;
  Scene<float> narrow;
  double size = 1;  // m, what an error is compared with
};

/// The second position is that of the outer ball.
struct Answer {
  double first = 0;
  double second = 0;
  double hits = 0;
  double size = 1;  // of the exact answer only: what errors are compared with
};

template <class To, class From>
TwoBallsAndWall<To> as(const TwoBallsAndWall<From>& b) {
  return {{To(b.inner.mass), To(b.inner.velocity)},
          {To(b.outer.mass), To(b.outer.velocity)},
          To(b.wall_gap),
          To(b.ball_gap),
          To(b.restitution),
          0};
}

/// Rounded to a multiple of 1/65,536, so that a float holds it and both types get the same input.
double short_number(double x) { return std::nearbyint(x * 0x1p16) * 0x1p-16; }

Input complete(Motion motion, const Scene<double>& wide, double size) {
  const auto narrow = [](double x) { return static_cast<float>(x); };
  Input input{motion, wide, {}, size};
  input.narrow.start = {narrow(wide.start.position), narrow(wide.start.velocity)};
  input.narrow.gravity = narrow(wide.gravity);
  input.narrow.spring = {narrow(wide.spring.angular_frequency)};
  input.narrow.ball = {narrow(wide.ball.height), narrow(wide.ball.velocity),
                       narrow(wide.ball.gravity), narrow(wide.ball.restitution)};
  input.narrow.balls = as<float>(wide.balls);
  input.narrow.time = narrow(wide.time);
  return input;
}

Input fall(generators::Random& random) {
  Scene<double> scene;
  const double height = random.uniform(10, 40);
  const double velocity = random.uniform(-5, 5);
  scene.start = {short_number(height), short_number(velocity)};
  scene.gravity = 9.8125;
  scene.time = short_number(random.uniform(0.5, 2));
  const double t = scene.time;
  return complete(Motion::fall, scene, height + std::abs(velocity) * t + 5 * t * t);
}

Input spring(generators::Random& random) {
  Scene<double> scene;
  const double displacement = random.uniform(-1, 1);
  const double speed = random.uniform(-4, 4);
  scene.start = {short_number(displacement), short_number(speed)};
  scene.spring = {short_number(random.uniform(2, 8))};
  scene.time = short_number(random.uniform(1, 6));
  return complete(Motion::spring, scene,
                  std::abs(displacement) + std::abs(speed) / scene.spring.angular_frequency);
}

/// Thrown upwards from the floor; the time is in the first six flights and not close to an impact.
Input bounce(generators::Random& random) {
  Scene<double> scene;
  const double speed = short_number(random.uniform(3, 8));
  const double k = short_number(random.uniform(0.5, 0.9));
  scene.ball = {0, speed, 9.8125, k};
  double time = 0;
  double flight = 2 * speed / 9.8125;
  for (int n = random.integer(0, 5); n > 0; --n) {
    time += flight;
    flight *= k;
  }
  scene.time = short_number(time + random.uniform(0.1, 0.9) * flight);
  return complete(Motion::bounce, scene, speed * speed / (2 * 9.8125));
}

/// A ball of up to twenty times the mass approaches from the right, with e = 1.
Input two_balls(generators::Random& random) {
  Scene<double> scene;
  const double mass = short_number(random.uniform(1, 20));
  const double speed = short_number(random.uniform(1, 3));
  const double wall_gap = short_number(random.uniform(0.3, 1));
  const double ball_gap = short_number(random.uniform(0.3, 1));
  scene.balls = {{1, 0}, {mass, -speed}, wall_gap, ball_gap, 1, 0};
  scene.time = short_number(random.uniform(0.5, 3));
  return complete(Motion::two_balls, scene, wall_gap + ball_gap + speed * scene.time);
}

// ---------------------------------------------------------------- exact answers

/// Sine and cosine to about 90 bits: a short series, and then ten doublings of the angle.
struct Turned {
  DoubleDouble sine, cosine;
};
Turned turned(DoubleDouble angle) {
  angle = angle * DoubleDouble(0x1p-10);
  const DoubleDouble square = angle * angle;
  DoubleDouble s(0.0);
  DoubleDouble c(0.0);
  for (int k = 10; k >= 1; --k) {
    s = -square * (DoubleDouble(1.0) + s) / DoubleDouble(2.0 * k * (2 * k + 1));
    c = -square * (DoubleDouble(1.0) + c) / DoubleDouble(2.0 * k * (2 * k - 1));
  }
  Turned t{angle * (DoubleDouble(1.0) + s), DoubleDouble(1.0) + c};
  for (int i = 0; i < 10; ++i) {
    const DoubleDouble sine = t.sine * t.cosine;
    t.cosine = t.cosine * t.cosine - t.sine * t.sine;
    t.sine = sine + sine;
  }
  return t;
}

Answer true_positions(const Input& input) {
  const Scene<double>& scene = input.wide;
  const DoubleDouble t(scene.time);
  const DoubleDouble half(0.5);
  const DoubleDouble x(scene.start.position);
  const DoubleDouble v(scene.start.velocity);
  switch (input.motion) {
    case Motion::fall:
      return {(x + v * t - half * DoubleDouble(scene.gravity) * t * t).high(), 0, 0};
    case Motion::spring: {
      const DoubleDouble w(scene.spring.angular_frequency);
      const Turned turn = turned(w * t);
      return {(x * turn.cosine + v / w * turn.sine).high(), 0, 0};
    }
    case Motion::bounce: {
      const DoubleDouble g(scene.ball.gravity);
      DoubleDouble speed(scene.ball.velocity);
      DoubleDouble left = t;
      double hits = 0;
      for (DoubleDouble flight = speed / g * DoubleDouble(2.0); flight <= left; ++hits) {
        left = left - flight;
        speed = speed * DoubleDouble(scene.ball.restitution);
        flight = flight * DoubleDouble(scene.ball.restitution);
      }
      return {(left * (speed - half * g * left)).high(), 0, hits};
    }
    case Motion::two_balls:
      break;
  }
  DoubleDouble left = t;
  const auto end = contact::two_balls_by_events(as<DoubleDouble>(scene.balls), left, 100000);
  return {end.wall_gap.high(), (end.wall_gap + end.ball_gap).high(), static_cast<double>(end.hits)};
}

Answer truth(const Input& input) {
  Answer answer = true_positions(input);
  answer.size = input.size;
  return answer;
}

// ---------------------------------------------------------------- the methods

template <class S>
Answer positions(const TwoBallsAndWall<S>& end) {
  return {double(end.wall_gap), double(end.wall_gap + end.ball_gap), static_cast<double>(end.hits)};
}

struct Steps {
  long long count;
  double length;
};
Steps steps_of(double time, double rate) {
  const auto count = static_cast<long long>(std::ceil(time * rate));
  return {count, time / static_cast<double>(count)};
}

/// Steps of one integrator; a ball below the floor, or an overlap, is reflected at the end of the
/// step.
Answer at_the_end_of_steps(const Input& input, Integrator integrator, double rate) {
  const Scene<double>& scene = input.wide;
  const Steps steps = steps_of(scene.time, rate);
  const auto fall_law = [g = -scene.gravity](double) { return g; };
  switch (input.motion) {
    case Motion::fall:
      return {
          contact::integrate(integrator, scene.start, steps.length, steps.count, fall_law).position,
          0, 0};
    case Motion::spring:
      return {contact::integrate(integrator, scene.start, steps.length, steps.count, scene.spring)
                  .position,
              0, 0};
    case Motion::bounce: {
      MotionState<double> now{scene.ball.height, scene.ball.velocity};
      const auto law = [g = -scene.ball.gravity](double) { return g; };
      double hits = 0;
      for (long long i = 0; i < steps.count; ++i) {
        now = contact::motion_step(integrator, now, steps.length, law);
        if (!(now.position < 0)) continue;
        now.position = 0;
        now.velocity *= -scene.ball.restitution;
        ++hits;
      }
      return {now.position, 0, hits};
    }
    case Motion::two_balls:
      break;
  }
  return positions(contact::two_balls_in_steps(scene.balls, steps.length, steps.count));
}

TwoBallsAndWall<double> moved(TwoBallsAndWall<double> balls, double t) {
  balls.wall_gap += balls.inner.velocity * t;
  balls.ball_gap += (balls.outer.velocity - balls.inner.velocity) * t;
  return balls;
}

/// One step of two balls, rolled back to the last free state before each collision.
TwoBallsAndWall<double> rolled_back(TwoBallsAndWall<double> now, double dt,
                                    const contact::RollbackRules<double>& rules) {
  for (int turns = 0; turns < 100; ++turns) {
    const auto is_free = [&now](double t) {
      const auto there = moved(now, t);
      return there.wall_gap >= 0 && there.ball_gap >= 0;
    };
    auto bracket = contact::last_free_slice<double>(is_free, dt, rules.slices);
    if (bracket) bracket = contact::bisected<double>(is_free, *bracket, rules.width);
    if (!bracket) return moved(now, dt);
    const auto blocked = moved(now, bracket->blocked);
    now = moved(now, bracket->free);
    dt -= bracket->free;
    if (blocked.wall_gap < 0 && now.inner.velocity < 0) {
      now.inner.velocity *= -now.restitution;
      ++now.hits;
    }
    if (blocked.ball_gap < 0 && contact::approaching(now.inner, now.outer)) {
      const auto after = contact::collide(now.inner, now.outer, now.restitution);
      now.inner.velocity = after.first;
      now.outer.velocity = after.second;
      ++now.hits;
    }
  }
  return now;
}

/// Steps of Verlet, rolled back to the last free state before an impact.
Answer by_rolling_back(const Input& input, const contact::RollbackRules<double>& rules) {
  const Scene<double>& scene = input.wide;
  const Steps steps = steps_of(scene.time, 60);
  if (input.motion == Motion::bounce) {
    BounceState<double> now{scene.ball.height, scene.ball.velocity, 0, false};
    for (long long i = 0; i < steps.count; ++i) {
      now = contact::rolled_back_step(now, scene.ball, steps.length, rules);
    }
    return {now.height, 0, now.bounces};
  }
  if (input.motion == Motion::two_balls) {
    auto now = scene.balls;
    for (long long i = 0; i < steps.count; ++i) now = rolled_back(now, steps.length, rules);
    return positions(now);
  }
  return at_the_end_of_steps(input, Integrator::velocity_verlet, 60);
}

/// Steps that advance to the impact: along the lecture's straight lines, or along parabolas.
Answer by_advancing(const Input& input, contact::StepRule rule, Integrator integrator) {
  const Scene<double>& scene = input.wide;
  const Steps steps = steps_of(scene.time, 60);
  if (input.motion == Motion::bounce) {
    const auto end = contact::bounce_in_steps(scene.ball, steps.length, steps.count, rule);
    return {end.height, 0, end.bounces};
  }
  if (input.motion == Motion::two_balls) {
    auto now = scene.balls;
    for (long long i = 0; i < steps.count; ++i) {
      double left = steps.length;
      now = contact::two_balls_by_events(now, left, 100000);
    }
    return positions(now);
  }
  return at_the_end_of_steps(input, integrator, 60);
}

template <class S>
Answer without_steps(Motion motion, const Scene<S>& scene) {
  switch (motion) {
    case Motion::fall:
      return {
          double(contact::ballistic_motion<S, S>(scene.start, -scene.gravity, scene.time).position),
          0, 0};
    case Motion::spring:
      return {double(contact::spring_motion(scene.spring, scene.start, scene.time).position), 0, 0};
    case Motion::bounce: {
      const auto end = contact::follow_bounces(scene.ball, scene.time, S(0));
      return {double(end.height), 0, double(end.bounces)};
    }
    case Motion::two_balls:
      break;
  }
  S left = scene.time;
  return positions(contact::two_balls_by_events(scene.balls, left, 100000));
}

/// The integrator of a method's steps of 1/60 s, if it has such steps.
std::optional<Integrator> integrator_at_60(const std::string& id) {
  if (id == "position-60") return Integrator::explicit_euler;
  if (id == "velocity-60" || id == "lecture") return Integrator::semi_implicit_euler;
  if (id == "verlet-60" || id == "slices" || id == "bisection" || id == "advance")
    return Integrator::velocity_verlet;
  if (id == "kutta-60") return Integrator::runge_kutta_4;
  return std::nullopt;
}

/// In the figure's units: ω is 1.
void show_spring(ladder::Example& example, const Scene<double>& scene, const std::string& id) {
  const double w = scene.spring.angular_frequency;
  const auto integrator = integrator_at_60(id);
  if (!integrator) {
    example.note = "The figure has no step as short as this one, and no float.";
    return;
  }
  example.figure = "swing";
  example.fields = {{"start", {scene.start.position, scene.start.velocity / w}},
                    {"step", {w * steps_of(scene.time, 60).length}},
                    {"integrator", {static_cast<double>(*integrator)}}};
  example.note = "The figure's unit of time is 1/ω, and it follows the motion for two periods.";
}

/// In the figure's units: the outer ball approaches at 1 m/s.
void show_two_balls(ladder::Example& example, const Scene<double>& scene, const std::string& id) {
  const TwoBallsAndWall<double>& balls = scene.balls;
  const double speed = -balls.outer.velocity;
  const double step = speed * steps_of(scene.time, 60).length;
  constexpr double shown_seconds = 6;
  const double outer = balls.wall_gap + balls.ball_gap;
  const auto start = contact::two_balls_and_wall<double>({1, 0}, {balls.outer.mass, -1},
                                                         balls.wall_gap, outer - balls.wall_gap, 1);
  double left = shown_seconds;
  const auto right = contact::two_balls_by_events(start, left, 100000);
  const auto stepped =
      contact::two_balls_in_steps(start, step, static_cast<long long>(shown_seconds / step));
  if (!id.ends_with("-60") || step < 0.01 || right.hits == stepped.hits || right.hits > 50) {
    example.note = "The figure's program in steps tests at the end of each, 1/100 s or longer.";
    return;
  }
  example.figure = "squeeze";
  example.fields = {{"inner", {balls.wall_gap}},
                    {"outer", {outer}},
                    {"ratio", {balls.outer.mass}},
                    {"e", {1}},
                    {"step", {step}}};
  example.note = "The figure's outer ball approaches at 1 m/s: times are longer by that factor.";
}

ladder::Example shown(const Input& input, const Answer& got, const Answer& right,
                      const ladder::Method& method) {
  const Scene<double>& scene = input.wide;
  ladder::Example example;
  switch (input.motion) {
    case Motion::fall:
    case Motion::spring:
      example.facts = {ladder::number("position at first, m", scene.start.position),
                       ladder::number("velocity at first, m/s", scene.start.velocity)};
      if (input.motion == Motion::fall) {
        example.facts.push_back(ladder::number("gravity, m/s²", scene.gravity));
        example.note = "No figure of this chapter shows a free fall.";
      } else {
        example.facts.push_back(ladder::number("ω, 1/s", scene.spring.angular_frequency));
        show_spring(example, scene, method.id);
      }
      break;
    case Motion::bounce:
      example.facts = {ladder::number("thrown upwards at, m/s", scene.ball.velocity),
                       ladder::number("gravity, m/s²", scene.ball.gravity),
                       ladder::number("k", scene.ball.restitution)};
      example.note = "The ball of this chapter's figure has leaning walls, which this one has not.";
      break;
    case Motion::two_balls:
      example.facts = {ladder::number("gap between wall and inner ball, m", scene.balls.wall_gap),
                       ladder::number("gap between the balls, m", scene.balls.ball_gap),
                       ladder::number("mass of the outer ball, kg", scene.balls.outer.mass),
                       ladder::number("its velocity, m/s", scene.balls.outer.velocity)};
      show_two_balls(example, scene, method.id);
      break;
  }
  example.facts.push_back(ladder::number("time, s", scene.time));
  for (const auto& [name, answer] :
       {std::pair{"by this method", &got}, std::pair{"exact", &right}}) {
    const std::string by = name;
    example.facts.push_back(ladder::number("position " + by + ", m", answer->first));
    example.facts.push_back(ladder::number("impacts " + by, answer->hits));
  }
  return example;
}

ladder::Ladder<Input, Answer> experiment() {
  const auto judge = [](const Answer& got, const Answer& right) {
    ladder::Verdict verdict;
    verdict.wrong = got.hits != right.hits;
    verdict.error =
        std::max(std::abs(got.first - right.first), std::abs(got.second - right.second)) /
        right.size;
    return verdict;
  };
  ladder::Ladder<Input, Answer> ladder("Where is it, and how many impacts has it had?", truth,
                                       judge);
  ladder.family("fall", "free fall", fall);
  ladder.family("spring", "a spring", spring);
  ladder.family("bounce", "a bouncing ball", bounce);
  ladder.family("two-balls", "two balls and a wall", two_balls);

  const auto steps = [&ladder](const char* id, const char* title, Integrator integrator,
                               double rate) {
    ladder.method({.id = id, .title = title, .scalar = "double", .exact = false},
                  [integrator, rate](const Input& input) {
                    return at_the_end_of_steps(input, integrator, rate);
                  });
  };
  steps("position-60", "explicit Euler, 1/60 s", Integrator::explicit_euler, 60);
  steps("velocity-60", "symplectic Euler, 1/60 s", Integrator::semi_implicit_euler, 60);
  steps("velocity-960", "symplectic Euler, 1/960 s", Integrator::semi_implicit_euler, 960);
  steps("verlet-60", "Verlet, 1/60 s", Integrator::velocity_verlet, 60);
  steps("verlet-960", "Verlet, 1/960 s", Integrator::velocity_verlet, 960);
  steps("kutta-60", "Runge–Kutta, 1/60 s", Integrator::runge_kutta_4, 60);

  ladder.method({.id = "slices",
                 .title = "Verlet, rolled back to one of 8 slices",
                 .scalar = "double",
                 .exact = false},
                [](const Input& input) {
                  return by_rolling_back(input, {8, std::numeric_limits<double>::infinity()});
                });
  ladder.method({.id = "bisection",
                 .title = "Verlet, rolled back by bisection",
                 .scalar = "double",
                 .exact = false},
                [](const Input& input) {
                  return by_rolling_back(input, {1, 0x1p-40});
                });
  ladder.method(
      {.id = "lecture", .title = "the lecture's loop, 1/60 s", .scalar = "double", .exact = false},
      [](const Input& input) {
        return by_advancing(input, contact::StepRule::new_velocity,
                            Integrator::semi_implicit_euler);
      });
  ladder.method({.id = "advance",
                 .title = "advancing on parabolas, 1/60 s",
                 .scalar = "double",
                 .exact = false},
                [](const Input& input) {
                  return by_advancing(input, contact::StepRule::impact_velocity,
                                      Integrator::velocity_verlet);
                });
  ladder.method({.id = "events-float", .title = "without steps", .scalar = "float", .exact = false},
                [](const Input& input) { return without_steps(input.motion, input.narrow); });
  ladder.method({.id = "events", .title = "without steps", .scalar = "double", .exact = false},
                [](const Input& input) { return without_steps(input.motion, input.wide); });
  ladder.recommend("events");
  ladder.show(shown);
  return ladder;
}

}  // namespace

LADDER(experiment)
