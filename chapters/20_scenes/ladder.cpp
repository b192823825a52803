// Where are the bodies at the end? Scenes whose end is known by a formula, in steps with the usual
// effects and with all effects, and composed of the effects that the plan has on, with and without
// the time of planning.
#include <support/ladder.hpp>

#include <20_scenes/measured_scenes.hpp>

#include <cstddef>
#include <string>
#include <variant>

namespace {

using measured_scenes::Answer;
using measured_scenes::Input;
using measured_scenes::Run;

/// Wrong is a scene in which a centre, or a rotating cube's vertex, is farther from where it should
/// be than the scene's tolerance.
ladder::Verdict judge(const Answer& got, const Answer& right) {
  ladder::Verdict verdict;
  verdict.error = 0;
  for (std::size_t i = 0; i < right.count; ++i) {
    const double off = (got.points[i] - right.points[i]).norm();
    verdict.error = off > verdict.error || off != off ? off : verdict.error;
  }
  verdict.wrong = !(verdict.error <= measured_scenes::tolerance);
  return verdict;
}

double step_of(const std::string& method) {
  return method.ends_with("-240") ? 1.0 / 240 : 1.0 / 60;
}

/// Whether a ball that nothing stops is never in the plate at the end of a step: the figure's test.
bool passes_between_tests(const contact::SceneBody& ball, const contact::BoxShape& plate,
                          double step) {
  const double touching = plate.half_lengths.y() + std::get<contact::BallShape>(ball.shape).radius;
  double y = ball.position.y();
  for (int n = 1; y > -touching; ++n) {
    if (y <= touching) return false;
    const double t = n * step;
    y = ball.position.y() + ball.velocity.y() * t - measured_scenes::gravity * t * t / 2;
  }
  return true;
}

ladder::Example shown(const Input& input, const Answer& got, const Answer& right,
                      const ladder::Method& method) {
  ladder::Example example;
  std::size_t i = 0;
  for (const contact::SceneBody& body : input.scene.bodies) {
    if (!body.moves) continue;
    const std::string of = " of the " + body.name + ", m";
    example.facts.push_back(ladder::numbers("centre" + of, body.position));
    example.facts.push_back(ladder::numbers("velocity" + of + "/s", body.velocity));
    if (!body.angular_velocity.isZero(0))
      example.facts.push_back(ladder::numbers("angular velocity of the " + body.name + ", rad/s",
                                              body.angular_velocity));
    example.facts.push_back(ladder::numbers("centre at the end, by this method, m", got.points[i]));
    example.facts.push_back(ladder::numbers("centre at the end, exact, m", right.points[i]));
    i += measured_scenes::asks_for_vertex(body) ? 2 : 1;
  }
  const contact::SceneMaterial& material = input.scene.materials.front();
  example.facts.push_back(ladder::number("restitution", material.restitution));
  example.facts.push_back(ladder::number("friction", material.friction));
  example.facts.push_back(ladder::number("time, s", input.scene.duration));
  if (!input.plate) {
    example.note = "No figure of this chapter has such a scene; contact simulate runs it.";
    return example;
  }
  const contact::SceneBody& ball = input.scene.bodies[0];
  const auto& plate = std::get<contact::BoxShape>(input.scene.bodies[1].shape);
  example.facts.push_back(ladder::number("thickness of the plate, m", 2 * plate.half_lengths.y()));
  if (!passes_between_tests(ball, plate, step_of(method.id))) {
    example.note =
        "The figure shows balls that no test finds in the plate; this one is found there, too "
        "late.";
    return example;
  }
  example.figure = "passing";
  example.fields = {{"height", {ball.position.y()}},
                    {"speed", {-ball.velocity.y()}},
                    {"angular_velocity", {0}},
                    {"step", {step_of(method.id)}},
                    {"thick", {2 * plate.half_lengths.y()}},
                    {"gravity", {measured_scenes::gravity}},
                    {"shape", {0}}};
  example.note = "The figure tests this ball once a step.";
  return example;
}

ladder::Ladder<Input, Answer> experiment() {
  ladder::Ladder<Input, Answer> ladder(
      "Where are the bodies at the end, to a millimetre?",
      [](const Input& input) { return input.truth; }, judge);
  ladder.family("stones", "three rotating stones in flight: positions in m",
                measured_scenes::stones, true);
  ladder.family("bouncing", "a ball bounces until it rests", measured_scenes::bouncing);
  ladder.family("sliding", "a block slides until it stops: position in m", measured_scenes::sliding,
                true);
  ladder.family("line", "two or three elastic balls on a line", measured_scenes::on_line);
  ladder.family("plate", "a fast ball at a thin plate", measured_scenes::at_plate);
  ladder.at_most(200);

  const auto method = [&ladder](const char* id, const char* title, Run run) {
    ladder.method({.id = id, .title = title, .scalar = "double", .exact = false},
                  [run](const Input& input) { return measured_scenes::run_of(input, run); });
  };
  method("default-60", "steps of 1/60 s, impacts at steps only", Run::default_60);
  method("default-240", "steps of 1/240 s, impacts at steps only", Run::default_240);
  method("all-60", "steps of 1/60 s, all effects", Run::all_60);
  ladder.method(
      {.id = "plan-and-run", .title = "planning and the planned run", .scalar = "as planned"},
      measured_scenes::plan_and_run);
  ladder.method({.id = "planned", .title = "the planned run", .scalar = "as planned"},
                [](const Input& input) { return measured_scenes::run_of(input, Run::planned); });
  ladder.recommend("planned");
  ladder.show(shown);
  return ladder;
}

}  // namespace

LADDER(experiment)
