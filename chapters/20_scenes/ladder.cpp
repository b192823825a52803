// Where are the balls at the end? Elastic balls, simulated from event to event with the effects
// that the scene needs and with all of them, by a plain loop, and in steps that test for overlap at
// their end.
#include <support/ladder.hpp>

#include <array>
#include <cmath>
#include <string>
#include <type_traits>
#include <vector>

#include <contact/double_double.hpp>
#include <contact/events/hard_spheres.hpp>

namespace {

using contact::DoubleDouble;
using contact::HardSphereEffects;
using contact::HardSphereSetup;

enum class Motion { line, table, box };
enum class Asked { positions, energy, overlap };

constexpr double radius = 0.25;
constexpr double gravity = 9.8125;

struct Input {
  Motion motion = Motion::line;
  Asked asked = Asked::positions;
  HardSphereSetup setup;
  double room = 0;  // m, of a cube, or of what the motion has of it
  double time = 0;  // s
};

struct Answer {
  Asked asked = Asked::positions;
  std::vector<contact::Vector3<double>> positions;  // m
  double hits = 0;
  double energy_change = 0;  // relative
  double overlap = 0;        // deepest that occurred, m
};

/// Rounded to a 65,536th, so that a float holds it and both types are asked the same.
double short_number(double x) { return std::nearbyint(x * 0x1p16) * 0x1p-16; }

/// Balls on a lattice, each randomly shifted, between walls.
Input balls(generators::Random& random, Motion motion, Asked asked) {
  const int dimension = motion == Motion::line ? 1 : motion == Motion::table ? 2 : 3;
  const int side = motion == Motion::line ? 5 : motion == Motion::table ? 3 : 2;
  Input input;
  input.motion = motion;
  input.asked = asked;
  input.room = side;
  input.time = motion == Motion::box ? 0.5 : 1;
  if (motion == Motion::box) input.setup.gravity = {0, 0, -gravity};
  const int count = dimension == 1 ? side : dimension == 2 ? side * side : side * side * side;
  for (int i = 0; i < count; ++i) {
    contact::HardBall ball;
    ball.radius = radius;
    ball.mass = 1;
    const std::array<int, 3> cell{i % side, i / side % side, i / side / side};
    for (int k = 0; k < dimension; ++k) {
      const double off = random.uniform(-0.2, 0.2);
      const double speed = random.uniform(-3, 3);
      ball.position(k) = short_number(cell[static_cast<std::size_t>(k)] + 0.5 + off);
      ball.velocity(k) = short_number(speed);
    }
    input.setup.balls.push_back(ball);
  }
  for (int k = 0; k < dimension; ++k) {
    const auto axis = contact::Vector3<double>::Unit(k);
    input.setup.walls.push_back({axis, 0, 0});
    input.setup.walls.push_back({-axis, -input.room, 0});
  }
  return input;
}

// ---------------------------------------------------------------- a plain loop

template <class S>
struct Ball {
  std::array<S, 3> x, v;
};
template <class S>
using Balls = std::vector<Ball<S>>;

template <class S>
Balls<S> start(const Input& input) {
  Balls<S> all;
  for (const contact::HardBall& ball : input.setup.balls) {
    Ball<S> b;
    for (std::size_t k = 0; k < 3; ++k) {
      b.x[k] = S(ball.position(static_cast<Eigen::Index>(k)));
      b.v[k] = S(ball.velocity(static_cast<Eigen::Index>(k)));
    }
    all.push_back(b);
  }
  return all;
}

/// Down is along the last axis.
template <class S>
S pull_along(const Input& input, std::size_t k) {
  return S(k == 2 && input.motion == Motion::box ? gravity : 0);
}

template <class S>
S energy_of(const Input& input, const Balls<S>& all) {
  S sum(0);
  for (const Ball<S>& ball : all) {
    for (std::size_t k = 0; k < 3; ++k)
      sum = sum + S(0.5) * ball.v[k] * ball.v[k] + pull_along<S>(input, k) * ball.x[k];
  }
  return sum;
}

template <class S>
S squared_gap(const Ball<S>& a, const Ball<S>& b) {
  S square(0);
  for (std::size_t k = 0; k < 3; ++k) square = square + (b.x[k] - a.x[k]) * (b.x[k] - a.x[k]);
  return square - S(4 * radius * radius);
}

/// When two balls meet; a negative number if never. Gravity accelerates both equally.
template <class S>
S pair_time(const Ball<S>& a, const Ball<S>& b) {
  using std::sqrt;
  S closing(0);
  S speed(0);
  for (std::size_t k = 0; k < 3; ++k) {
    const S w = b.v[k] - a.v[k];
    closing = closing - (b.x[k] - a.x[k]) * w;
    speed = speed + w * w;
  }
  if (!(closing > S(0))) return S(-1);
  const S gap = squared_gap(a, b);
  if (!(gap > S(0))) return S(0);
  const S root = closing * closing - speed * gap;
  if (root < S(0)) return S(-1);
  return gap / (closing + sqrt(root));
}

/// When a ball meets the lower or the upper wall of an axis; a negative number if never.
template <class S>
S wall_time(const Ball<S>& ball, std::size_t k, bool upper, double room, S pull) {
  using std::sqrt;
  const S gap = upper ? S(room - radius) - ball.x[k] : ball.x[k] - S(radius);
  const S v = upper ? -ball.v[k] : ball.v[k];
  const S g = upper ? -pull : pull;
  if (g == S(0)) return v < S(0) ? (gap > S(0) ? gap / -v : S(0)) : S(-1);
  const S root = v * v + S(2) * g * gap;
  if (root < S(0) || (upper && !(v < S(0)))) return S(-1);
  // Down to a floor; or up to a ceiling, the first time.
  const S time = v > S(0) ? (v + sqrt(root)) / g : S(2) * gap / (sqrt(root) - v);
  return time > S(0) ? time : S(0);
}

template <class S>
void fly(Balls<S>& all, const Input& input, S time) {
  for (Ball<S>& ball : all) {
    for (std::size_t k = 0; k < 3; ++k) {
      const S pull = pull_along<S>(input, k);
      ball.x[k] = ball.x[k] + time * (ball.v[k] - S(0.5) * pull * time);
      ball.v[k] = ball.v[k] - pull * time;
    }
  }
}

/// Equal balls exchange the normal components of their velocities.
template <class S>
void collide_equal(Ball<S>& a, Ball<S>& b) {
  S square(0);
  S closing(0);
  for (std::size_t k = 0; k < 3; ++k) {
    square = square + (b.x[k] - a.x[k]) * (b.x[k] - a.x[k]);
    closing = closing - (b.x[k] - a.x[k]) * (b.v[k] - a.v[k]);
  }
  if (!(closing > S(0))) return;
  for (std::size_t k = 0; k < 3; ++k) {
    const S push = (b.x[k] - a.x[k]) * closing / square;
    a.v[k] = a.v[k] - push;
    b.v[k] = b.v[k] + push;
  }
}

template <class S>
double as_double(const S& x) {
  if constexpr (std::is_same_v<S, DoubleDouble>)
    return x.high();
  else
    return static_cast<double>(x);
}

template <class S>
Answer answer(const Input& input, const Balls<S>& all, double hits, double overlap) {
  Answer got;
  got.asked = input.asked;
  for (const Ball<S>& ball : all)
    got.positions.push_back({as_double(ball.x[0]), as_double(ball.x[1]), as_double(ball.x[2])});
  got.hits = hits;
  const S before = energy_of(input, start<S>(input));
  got.energy_change = std::abs(as_double((energy_of(input, all) - before) / before));
  got.overlap = overlap;
  return got;
}

/// Tests all pairs before each event.
template <class S>
Answer plain_loop(const Input& input) {
  const std::size_t walls = input.setup.walls.size();
  Balls<S> all = start<S>(input);
  S left = static_cast<S>(input.time);
  double hits = 0;
  double deepest = 0;
  for (;;) {
    S first = left;
    std::size_t who = all.size();
    std::size_t whom = 0;
    const auto offer = [&](const S& time, std::size_t i, std::size_t k) {
      if (time < S(0) || !(time < first)) return;
      first = time;
      who = i;
      whom = k;
    };
    for (std::size_t i = 0; i < all.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) offer(pair_time(all[i], all[k]), i, k);
      for (std::size_t w = 0; w < walls; ++w) {
        const S pull = pull_along<S>(input, w / 2);
        offer(wall_time(all[i], w / 2, w % 2 == 1, input.room, pull), i, all.size() + w);
      }
    }
    fly(all, input, first);
    if (who == all.size()) return answer(input, all, hits, deepest);
    left = left - first;
    ++hits;
    if (whom < all.size()) {
      deepest = std::max(deepest, -as_double(squared_gap(all[who], all[whom])) / (4 * radius));
      collide_equal(all[who], all[whom]);
    } else {
      const std::size_t wall = whom - all.size();
      all[who].v[wall / 2] = -all[who].v[wall / 2];
    }
  }
}

// ---------------------------------------------------------------- steps that test at their end

/// As in engines: semi-implicit Euler; then overlapping balls collide and are moved apart.
Answer in_steps(const Input& input, double rate) {
  const auto steps = static_cast<int>(std::ceil(input.time * rate));
  const double h = input.time / steps;
  const std::size_t walls = input.setup.walls.size();
  Balls<double> all = start<double>(input);
  double hits = 0;
  double deepest = 0;
  for (int step = 0; step < steps; ++step) {
    for (Ball<double>& ball : all) {
      for (std::size_t k = 0; k < 3; ++k) {
        ball.v[k] -= h * pull_along<double>(input, k);
        ball.x[k] += h * ball.v[k];
      }
    }
    for (std::size_t i = 0; i < all.size(); ++i) {
      Ball<double>& a = all[i];
      for (std::size_t k = 0; k < i; ++k) {
        Ball<double>& b = all[k];
        const double gap = squared_gap(a, b);
        if (!(gap < 0)) continue;
        ++hits;
        const double distance = std::sqrt(gap + 4 * radius * radius);
        deepest = std::max(deepest, 2 * radius - distance);
        collide_equal(a, b);
        for (std::size_t axis = 0; axis < 3 && distance > 0; ++axis) {
          const double apart = (b.x[axis] - a.x[axis]) / distance * (radius - distance / 2);
          a.x[axis] -= apart;
          b.x[axis] += apart;
        }
      }
      for (std::size_t w = 0; w < walls; ++w) {
        double& x = a.x[w / 2];
        double& v = a.v[w / 2];
        const bool upper = w % 2 == 1;
        const double limit = upper ? input.room - radius : radius;
        if (upper ? !(x > limit) : !(x < limit)) continue;
        ++hits;
        deepest = std::max(deepest, std::abs(x - limit));
        x = limit;
        if ((v > 0) == upper) v = -v;
      }
    }
  }
  return answer(input, all, hits, deepest);
}

// ---------------------------------------------------------------- composed

template <HardSphereEffects E>
Answer composed(const Input& input) {
  contact::HardSpheres<E> run(input.setup);
  const double before = run.energy();
  run.advance(input.time);
  Answer got;
  got.asked = input.asked;
  for (std::size_t i = 0; i < run.moving(); ++i) got.positions.push_back(run.position(i));
  const contact::HardSphereCounts did = run.counts();
  got.hits = static_cast<double>(did.hits);
  got.energy_change = std::abs((run.energy() - before) / before);
  got.overlap = std::max(0.0, did.largest_overlap);
  return got;
}

constexpr HardSphereEffects elastic(int dimension, bool pulled) {
  return {.dimension = dimension,
          .gravity = pulled,
          .sizes = false,
          .restitution = false,
          .grid = false};
}

Answer planned(const Input& input) {
  switch (input.motion) {
    case Motion::line:
      return composed<elastic(1, false)>(input);
    case Motion::table:
      return composed<elastic(2, false)>(input);
    case Motion::box:
      break;
  }
  return composed<elastic(3, true)>(input);
}

ladder::Verdict judge(const Answer& got, const Answer& right) {
  ladder::Verdict verdict;
  verdict.wrong = got.hits != right.hits;
  switch (right.asked) {
    case Asked::energy:
      verdict.error = got.energy_change;
      break;
    case Asked::overlap:
      verdict.error = got.overlap;
      break;
    case Asked::positions:
      verdict.error = 0;
      for (std::size_t i = 0; i < right.positions.size(); ++i)
        verdict.error = std::max(verdict.error, (got.positions[i] - right.positions[i]).norm());
      break;
  }
  return verdict;
}

ladder::Example shown(const Input& input, const Answer& got, const Answer& right,
                      const ladder::Method&) {
  const auto dimension = static_cast<Eigen::Index>(input.setup.walls.size() / 2);
  ladder::Example example;
  const auto balls = input.setup.balls.size();
  for (std::size_t i = 0; i < balls; ++i) {
    const contact::HardBall& ball = input.setup.balls[i];
    const std::string of = " of ball " + std::to_string(i + 1);
    example.facts.push_back(
        ladder::numbers("centre" + of + ", m", ball.position.cast<float>().eval().head(dimension)));
    example.facts.push_back(ladder::numbers("velocity" + of + ", m/s",
                                            ball.velocity.cast<float>().eval().head(dimension)));
  }
  example.facts.push_back(ladder::number("time, s", input.time));
  example.facts.push_back(ladder::number("hits by this method", got.hits));
  example.facts.push_back(ladder::number("hits, exact", right.hits));
  example.note = "The chapter's figures show one body each, and cannot show these balls.";
  return example;
}

ladder::Ladder<Input, Answer> experiment() {
  ladder::Ladder<Input, Answer> ladder("Where are the balls, and is the energy conserved?",
                                       plain_loop<DoubleDouble>, judge);
  const auto family = [&ladder](const char* id, const char* title, Motion motion, Asked asked) {
    ladder.family(
        id, title,
        [motion, asked](generators::Random& random) { return balls(random, motion, asked); },
        asked != Asked::positions);
  };
  family("line", "five on a line: hits, and positions in m", Motion::line, Asked::positions);
  family("table", "nine on a table: hits, and positions in m", Motion::table, Asked::positions);
  family("table-overlap", "nine on a table: deepest overlap in m", Motion::table, Asked::overlap);
  family("box", "eight in a box, with gravity: hits, and positions in m", Motion::box,
         Asked::positions);
  family("box-energy", "eight in a box: relative change of energy", Motion::box, Asked::energy);

  for (const int rate : {60, 240}) {
    const std::string text = std::to_string(rate);
    ladder.method({.id = "steps-" + text,
                   .title = "tests at the end of steps of 1/" + text + " s",
                   .scalar = "double",
                   .exact = false},
                  [rate](const Input& input) { return in_steps(input, rate); });
  }
  ladder.method(
      {.id = "plain-float", .title = "events, a plain loop", .scalar = "float", .exact = false},
      plain_loop<float>);
  ladder.method(
      {.id = "plain", .title = "events, a plain loop", .scalar = "double", .exact = false},
      plain_loop<double>);
  ladder.method(
      {.id = "all", .title = "events, all effects on", .scalar = "double", .exact = false},
      composed<HardSphereEffects{}>);
  ladder.method(
      {.id = "planned", .title = "events, as planned", .scalar = "double", .exact = false},
      planned);
  ladder.recommend("planned");
  ladder.show(shown);
  return ladder;
}

}  // namespace

LADDER(experiment)
