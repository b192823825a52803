// The height of a bouncing ball at a time, and the number of impacts until then: by formula, by
// events and in time steps.
#include <support/ladder.hpp>

#include <contact/bouncing.hpp>
#include <contact/exact.hpp>
#include <contact/fixed_step_bounce.hpp>

namespace {

/// The same ball in float and in double; the conversion is not timed. It starts on the floor, so
/// that all its times are rational, and the right answer needs no root.
struct Input {
  contact::BouncingBall<double> in_double;
  contact::BouncingBall<float> in_float;
  double time = 0;
  float time_in_float = 0;
};

/// A height and a count; the truth says both of the floats and of the doubles.
struct Position {
  double height = 0;
  double bounces = 0;
};
struct Answer {
  bool of_floats = false;
  Position in_float, in_double;
  double highest = 1;
};

Input thrown(double speed, double gravity, double k, double time) {
  const auto narrow = [](double x) { return static_cast<float>(x); };
  return {
      {0, speed, gravity, k}, {0, narrow(speed), narrow(gravity), narrow(k)}, time, narrow(time)};
}

/// In whole 256ths, to limit the digits of the right answer.
double share(generators::Random& random, double low, double high) {
  return std::ldexp(std::round(std::ldexp(random.uniform(low, high), 8)), -8);
}

/// Number of impacts and height: n is the largest with (2 v / g)(1 + k + … + k^(n−1)) ≤ t.
Position truth_of(double speed, double gravity, double k, double time) {
  using contact::Exact;
  const Exact v(speed), g(gravity), e(k), t(time);
  const Exact two(2.0);
  // Rest: g t (1 − k) ≥ 2 v.
  if (!(g * t * (Exact(1.0) - e) < two * v)) {
    return {0, std::numeric_limits<double>::infinity()};
  }
  Exact sum;         // 1 + k + … + k^(n − 1)
  Exact power(1.0);  // k^n
  double n = 0;
  for (; !(g * t < two * v * (sum + power)); ++n) {
    sum += power;
    power *= e;
  }
  // g y = (g s)(v k^n) − (g s)²/2 with g s = g t − 2 v sum.
  const Exact since = g * t - two * v * sum;
  return {quotient<double>(since * (two * v * power - since), two * g), n};
}

Answer truth_of_both(const Input& input) {
  const auto& narrow = input.in_float;
  const auto& wide = input.in_double;
  return {
      false,
      truth_of(static_cast<double>(narrow.velocity), static_cast<double>(narrow.gravity),
               static_cast<double>(narrow.restitution), static_cast<double>(input.time_in_float)),
      truth_of(wide.velocity, wide.gravity, wide.restitution, input.time),
      wide.velocity * wide.velocity / (2 * wide.gravity)};
}

/// A ball that is thrown from the floor with k from 1/2 to 0.9, somewhere in its first eight
/// flights.
Input plain(generators::Random& random) {
  const double v = share(random, 3, 8);
  const double g = 9.8125;
  const double k = share(random, 0.5, 0.9);
  const double flight = 2 * v / g;
  double time = 0;
  double length = flight;
  for (int n = random.integer(0, 7); n > 0; --n) {
    time += length;
    length *= k;
  }
  return thrown(v, g, k, time + random.uniform(0.05, 0.95) * length);
}

/// At an impact, or one ulp beside it.
Input at_impact(generators::Random& random) {
  const double v = share(random, 3, 8);
  const double g = 9.8125;
  const double k = share(random, 0.5, 0.9);
  const contact::BouncingBall<double> ball{0, v, g, k};
  double time = contact::impact_time(ball, random.integer(1, 8));
  const int side = random.integer(-1, 1);
  if (side != 0) time = std::nextafter(time, side > 0 ? 1e9 : 0);
  return thrown(v, g, k, time);
}

/// So near to the end that a flight takes less than a millionth of the time that has passed; some
/// flights are shorter than an ulp of the time.
Input near_end(generators::Random& random) {
  const double v = share(random, 3, 8);
  const double g = 9.8125;
  const double k = share(random, 0.5, 0.75);
  const contact::BouncingBall<double> ball{0, v, g, k};
  const double end = contact::rest_time(ball);
  return thrown(v, g, k, end * (1 - std::abs(random.magnitude(-52, -24))));
}

/// Nothing is lost, for up to a quarter of a minute.
Input no_loss(generators::Random& random) {
  const double v = share(random, 3, 8);
  return thrown(v, 9.8125, 1, random.uniform(5, 15));
}

template <class S>
Position position(const contact::BounceState<S>& state, double k) {
  const bool endless = state.resting && k > 0;
  return {static_cast<double>(state.height),
          endless ? std::numeric_limits<double>::infinity() : static_cast<double>(state.bounces)};
}

/// The figure drops a ball: the same one, from its greatest height, has one more impact, the throw.
template <class S>
ladder::Example shown(const contact::BouncingBall<S>& ball, S time, const Position& told,
                      const Position& truth) {
  ladder::Example example;
  example.facts = {ladder::number("thrown upwards at, m/s", ball.velocity),
                   ladder::number("gravity, m/s²", ball.gravity),
                   ladder::number("k", ball.restitution),
                   ladder::number("time, s", time),
                   ladder::number("impacts by this method", told.bounces),
                   ladder::number("height by this method, m", told.height),
                   ladder::number("impacts, exact", truth.bounces),
                   ladder::number("height, exact, m", truth.height)};
  const auto v = static_cast<double>(ball.velocity);
  const auto g = static_cast<double>(ball.gravity);
  const auto k = static_cast<double>(ball.restitution);
  const double height = v * v / (2 * g);
  const double later = static_cast<double>(time) + v / g;
  if (later > 5 || height > 1.5) {
    example.note = "The figure shows 5 seconds and 1.6 m.";
    return example;
  }
  const double rebound = std::min(height, k * k * height);
  const double same_k = std::min(1.0, contact::restitution_from_heights(height, rebound));
  const auto there = contact::bounce_at(contact::bouncing_ball(height, 0.0, g, same_k), later);
  const bool resting = there.resting && k > 0;
  if (resting == std::isfinite(truth.bounces) || (!resting && there.bounces != truth.bounces + 1)) {
    example.note =
        "The figure drops its ball. The conversion from a throw rounds the time, and here the last "
        "digits matter.";
    return example;
  }
  example.figure = "zeno";
  example.fields = {{"height", {height}}, {"rebound", {rebound}}, {"gravity", {g}},
                    {"time", {later}},    {"rest_height", {0}},   {"beside", {0}}};
  example.note =
      "The figure drops the ball from its greatest height: the throw is its first impact, and "
      "times "
      "are later by v/g, rounded.";
  return example;
}

ladder::Ladder<Input, Answer> experiment() {
  const auto judge = [](const Answer& got, const Answer& right) {
    ladder::Verdict verdict;
    const Position& told = got.of_floats ? got.in_float : got.in_double;
    const Position& truth = got.of_floats ? right.in_float : right.in_double;
    verdict.wrong = told.bounces != truth.bounces;
    verdict.error = std::abs(told.height - truth.height) / right.highest;
    return verdict;
  };
  ladder::Ladder<Input, Answer> ladder("Where is the ball, and how often has it bounced?",
                                       truth_of_both, judge);
  ladder.family("plain", "in the first eight flights", plain);
  ladder.family("impact", "at an impact, to the last digit", at_impact);
  ladder.family("end", "just before the end of all bounces", near_end);
  ladder.family("no-loss", "k = 1 for 5 to 15 s", no_loss);

  const auto in_steps = [&ladder](const char* id, const char* title, contact::StepRule rule,
                                  double rate) {
    ladder.method({.id = id, .title = title, .scalar = "double", .exact = false},
                  [rule, rate](const Input& input) {
                    const auto steps = static_cast<long long>(std::ceil(input.time * rate));
                    const double dt = input.time / static_cast<double>(steps);
                    return Answer{
                        false,
                        {},
                        position(contact::bounce_in_steps(input.in_double, dt, steps, rule),
                                 input.in_double.restitution)};
                  });
  };
  using contact::StepRule;
  in_steps("flip-60", "steps of 1/60 s, flip below", StepRule::flip_below, 60);
  in_steps("flip-960", "steps of 1/960 s, flip below", StepRule::flip_below, 960);
  in_steps("clamp-60", "steps of 1/60 s, on the floor", StepRule::clamp, 60);
  in_steps("clamp-960", "steps of 1/960 s, on the floor", StepRule::clamp, 960);
  in_steps("lecture-60", "steps of 1/60 s, the lecture's loop", StepRule::new_velocity, 60);
  in_steps("lecture-960", "steps of 1/960 s, the lecture's loop", StepRule::new_velocity, 960);
  in_steps("end-60", "steps of 1/60 s, step's end", StepRule::end_velocity, 60);
  in_steps("end-960", "steps of 1/960 s, step's end", StepRule::end_velocity, 960);
  in_steps("impact-60", "steps of 1/60 s, at the impact", StepRule::impact_velocity, 60);
  in_steps("impact-960", "steps of 1/960 s, at the impact", StepRule::impact_velocity, 960);

  ladder.method(
      {.id = "events-float", .title = "flight by flight", .scalar = "float", .exact = false},
      [](const Input& input) {
        return Answer{true,
                      position(contact::follow_bounces(input.in_float, input.time_in_float, 0.0f),
                               static_cast<double>(input.in_float.restitution)),
                      {}};
      });
  ladder.method(
      {.id = "events-double", .title = "flight by flight", .scalar = "double", .exact = false},
      [](const Input& input) {
        return Answer{false,
                      {},
                      position(contact::follow_bounces(input.in_double, input.time, 0.0),
                               input.in_double.restitution)};
      });
  ladder.method({.id = "rest",
                 .title = "flight by flight, rests below 1 mm",
                 .scalar = "double",
                 .exact = false},
                [](const Input& input) {
                  return Answer{false,
                                {},
                                position(contact::follow_bounces(
                                             input.in_double, input.time,
                                             contact::rest_speed(0.001, input.in_double.gravity)),
                                         input.in_double.restitution)};
                });
  ladder.method({.id = "formula-float",
                 .title = "the book's formula",
                 .scalar = "float, then exact",
                 .exact = true},
                [](const Input& input) {
                  return Answer{true,
                                position(contact::bounce_at(input.in_float, input.time_in_float),
                                         static_cast<double>(input.in_float.restitution)),
                                {}};
                });
  ladder.method({.id = "formula",
                 .title = "the book's formula",
                 .scalar = "double, then exact",
                 .exact = true},
                [](const Input& input) {
                  return Answer{false,
                                {},
                                position(contact::bounce_at(input.in_double, input.time),
                                         input.in_double.restitution)};
                });
  ladder.method({.id = "exact", .title = "exact", .scalar = "exact", .exact = true}, [](const Input&
                                                                                            input) {
    const auto& ball = input.in_double;
    return Answer{false, {}, truth_of(ball.velocity, ball.gravity, ball.restitution, input.time)};
  });
  ladder.recommend("formula");
  ladder.show([](const Input& input, const Answer& got, const Answer& right,
                 const ladder::Method&) {
    return got.of_floats ? shown(input.in_float, input.time_in_float, got.in_float, right.in_float)
                         : shown(input.in_double, input.time, got.in_double, right.in_double);
  });
  return ladder;
}

}  // namespace

LADDER(experiment)
