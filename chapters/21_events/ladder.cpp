// Where are the balls at the end? Elastic balls, simulated from event to event with the effects
// that the scene needs and with all of them, by a plain loop, and in steps that test for overlap at
// their end.
#include "figures/compared_balls.hpp"

#include <support/ladder.hpp>

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace {

using compared_balls::Motion;
using contact::HardSphereEffects;

enum class Asked { positions, energy, overlap };

struct Input : compared_balls::Setting {
  Asked asked = Asked::positions;
};

struct Answer : compared_balls::Course {
  Asked asked = Asked::positions;
};

/// A method of the ladder from one of the simulations.
template <class Simulation>
auto answering(Simulation simulation) {
  return [simulation](const Input& input) { return Answer{simulation(input), input.asked}; };
}

/// Rounded to a 65,536th, so that a float holds it and both types are asked the same.
double short_number(double x) { return std::nearbyint(x * 0x1p16) * 0x1p-16; }

/// Balls on a lattice, each randomly shifted, between walls.
Input balls(generators::Random& random, Motion motion, Asked asked) {
  Input input{compared_balls::empty_room(motion), asked};
  const auto dimension = static_cast<int>(input.setup.walls.size() / 2);
  const auto side = static_cast<int>(input.room);
  const int count = dimension == 1 ? side : dimension == 2 ? side * side : side * side * side;
  for (int i = 0; i < count; ++i) {
    contact::HardBall ball;
    ball.radius = compared_balls::radius;
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
  return input;
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

/// The methods, in the order of the figure.
constexpr std::array<const char*, 6> ways{"steps-60", "steps-240", "plain-float",
                                          "plain",    "all",       "planned"};

ladder::Example shown(const Input& input, const Answer& got, const Answer& right,
                      const ladder::Method& method) {
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
  std::vector<double> numbers(54);
  for (std::size_t i = 0; i < balls; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      numbers[6 * i + k] = input.setup.balls[i].position(static_cast<Eigen::Index>(k));
      numbers[6 * i + 3 + k] = input.setup.balls[i].velocity(static_cast<Eigen::Index>(k));
    }
  }
  const auto way = std::find(ways.begin(), ways.end(), method.id) - ways.begin();
  example.figure = "balls";
  example.fields = {{"motion", {static_cast<double>(input.motion)}},
                    {"method", {static_cast<double>(way)}},
                    ladder::field("balls", numbers),
                    {"at", {input.time}}};
  if (input.motion == Motion::box)
    example.note = "The figure shows the box from the front.";
  else
    example.note = "The figure simulates these balls.";
  return example;
}

ladder::Ladder<Input, Answer> experiment() {
  ladder::Ladder<Input, Answer> ladder(
      "Where are the balls, and is the energy conserved?", answering([](const Input& input) {
        return compared_balls::plain_loop<contact::DoubleDouble>(input);
      }),
      judge);
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
    ladder.method(
        {.id = "steps-" + text,
         .title = "tests at the end of steps of 1/" + text + " s",
         .scalar = "double",
         .exact = false},
        answering([rate](const Input& input) { return compared_balls::in_steps(input, rate); }));
  }
  ladder.method(
      {.id = "plain-float", .title = "events, a plain loop", .scalar = "float", .exact = false},
      answering([](const Input& input) { return compared_balls::plain_loop<float>(input); }));
  ladder.method(
      {.id = "plain", .title = "events, a plain loop", .scalar = "double", .exact = false},
      answering([](const Input& input) { return compared_balls::plain_loop<double>(input); }));
  ladder.method(
      {.id = "all", .title = "events, all effects on", .scalar = "double", .exact = false},
      answering(compared_balls::composed<HardSphereEffects{}>));
  ladder.method(
      {.id = "planned", .title = "events, as planned", .scalar = "double", .exact = false},
      answering(compared_balls::planned));
  ladder.recommend("planned");
  ladder.show(shown);
  return ladder;
}

}  // namespace

LADDER(experiment)
