#include "simulation_report.hpp"

#include <algorithm>
#include <string>
#include <variant>

#include <contact/scene/scene_file.hpp>
#include <contact/scene/scene_runs.hpp>

#include "../terminal/terminal.hpp"

namespace contact::cli {

namespace {

std::string trouble(const SimulationEnd& end) {
  const SceneRunCounts counts = end.run.counts();
  const std::string at =
      " at " + shortest_text(end.run.now()) + " s of " + shortest_text(end.until);
  if (end.ending == Ending::out_of_events)
    return "the budget of " + std::to_string(end.options.max_events) + " hits ran out" + at +
           " s: what comes later is not simulated";
  if (end.ending == Ending::endless_hits)
    return "no bound on the number of hits: " + end.scene.bodies[counts.endless_first].name +
           " hits " + end.scene.bodies[counts.endless_second].name +
           " again and again at one instant" + at + " s";
  return "";
}

nlohmann::json effects_json(const SimulationEnd& end) {
  const auto on = scenes::hard_sphere_effects(end.run);
  if (!on) return nullptr;
  return {{"dimension", on->dimension},
          {"gravity", on->gravity},
          {"sizes", on->sizes},
          {"restitution", on->restitution},
          {"grid", on->grid}};
}

nlohmann::json stages_json(const SimulationEnd& end) {
  nlohmann::json stages = nlohmann::json::array();
  for (const SceneStage& stage : end.run.stages())
    stages.push_back({{"name", stage.name}, {"detail", stage.detail}});
  return stages;
}

auto count_bodies(const SimulationEnd& end, bool balls_only) {
  return std::count_if(
      end.scene.bodies.begin(), end.scene.bodies.end(), [&](const SceneBody& body) {
        return balls_only ? std::holds_alternative<BallShape>(body.shape) : body.moves;
      });
}

nlohmann::json fallback_json(const SimulationEnd& end) {
  const auto fallback = end.run.fallback();
  if (!fallback) return nullptr;
  return {{"time", fallback->time}, {"why", fallback->why}};
}

nlohmann::json tolerance_json(const KeptTolerance& kept) {
  nlohmann::json json{{"asked", nullptr},
                      {"kept_until", kept.until},
                      {"by", kept_by_text(kept.by)},
                      {"why", nullptr}};
  if (kept.asked > 0) json["asked"] = kept.asked;
  if (!kept.whole()) json["why"] = kept.why;
  return json;
}

nlohmann::json report_json(const SimulationEnd& end) {
  const SceneRunCounts counts = end.run.counts();
  nlohmann::json expectations = nlohmann::json::array();
  for (const Checked& checked : end.checked) {
    const SceneExpectation& wanted = *checked.wanted;
    nlohmann::json entry{{"quantity", wanted.quantity},
                         {"body", wanted.body},
                         {"time", wanted.time},
                         {"value", wanted.value},
                         {"within", wanted.within},
                         {"met", nullptr},
                         {"got", nullptr}};
    if (checked.got) {
      entry["met"] = checked.met();
      entry["got"] = *checked.got;
    }
    expectations.push_back(entry);
  }
  constexpr const char* endings[] = {"complete", "out_of_events", "endless_hits", "interrupted"};
  nlohmann::json json{{"format", "contact-simulate/1"},
                      {"scene", end.scene.name},
                      {"end", endings[static_cast<int>(end.ending)]},
                      {"time", end.run.now()},
                      {"until", end.until},
                      {"effects", effects_json(end)},
                      {"event_driven", end.run.event_driven()},
                      {"step", end.run.step()},
                      {"stages", stages_json(end)},
                      {"fallback", fallback_json(end)},
                      {"balls", count_bodies(end, true)},
                      {"bodies", end.scene.bodies.size()},
                      {"moving", count_bodies(end, false)},
                      {"steps", counts.steps},
                      {"substeps", counts.substeps},
                      {"crowded_steps", counts.crowded_steps},
                      {"max_impacts", counts.max_impacts},
                      {"pairs", counts.pairs},
                      {"contacts", counts.contacts},
                      {"iterations", counts.iterations},
                      {"hits", counts.hits},
                      {"crossings", counts.crossings},
                      {"largest_overlap", counts.largest_overlap},
                      {"rests", counts.rests},
                      {"rest_error", counts.rest_error},
                      {"energy", {{"first", end.first_energy}, {"last", end.run.energy()}}},
                      {"tolerance", tolerance_json(end.kept)},
                      {"frames", end.frames},
                      {"bytes", end.run.bytes()},
                      {"bytes_per_state", end.run.bytes_per_body()},
                      {"seconds", end.seconds},
                      {"expectations", expectations}};
  if (const std::string what = trouble(end); !what.empty()) json["trouble"] = what;
  return json;
}

void tell_expectations(const SimulationEnd& end, const Style& style, SimulateOutcome& outcome) {
  for (const Checked& checked : end.checked) {
    const SceneExpectation& wanted = *checked.wanted;
    const std::string what = wanted.quantity + (wanted.body.empty() ? "" : " of " + wanted.body) +
                             " at " + shortest_text(wanted.time) + " s: ";
    const std::string right =
        shortest_text(wanted.value) + " within " + shortest_text(wanted.within);
    if (!checked.got)
      outcome.say("  " + style.warn("not checked") + "  " + what + right);
    else
      outcome.say("  " +
                  (checked.met() ? style.good("as expected  ") : style.bad("not expected ")) +
                  "  " + what + shortest_text(*checked.got) + ", expected " + right);
  }
}

void tell(const SimulationEnd& end, const Style& style, SimulateOutcome& outcome) {
  const SceneRunCounts counts = end.run.counts();
  std::string stages;
  for (const SceneStage& stage : end.run.stages())
    stages += (stages.empty() ? "" : ", ") + stage.name;
  outcome.say(style.bold(end.scene.name) + ": " +
              (end.run.event_driven()
                   ? end.way
                   : "step by step, " + shortest_text(end.run.step()) + " s each") +
              " (" + stages + ")");
  outcome.say("  " + shortest_text(end.run.now()) + " s, " + std::to_string(counts.hits) +
              " hits, " + std::to_string(end.run.bytes_per_body()) + " bytes a body's state");
  if (!end.run.event_driven())
    outcome.say("  " + std::to_string(counts.steps) + " steps in " +
                std::to_string(counts.substeps) + " substeps, " + std::to_string(counts.pairs) +
                " pairs tested, " + std::to_string(counts.contacts) + " contacts solved in " +
                std::to_string(counts.iterations) + " iterations");
  outcome.say("  energy " + shortest_text(end.first_energy) + " J, then " +
              shortest_text(end.run.energy()) + " J; largest overlap " +
              shortest_text(counts.largest_overlap) + " m");
  if (counts.rests > 0)
    outcome.say("  came to rest " + std::to_string(counts.rests) + " times" +
                (end.run.event_driven() ? ", which displaces paths by " +
                                              shortest_text(counts.rest_error) + " m at most"
                                        : ""));
  if (counts.crowded_steps > 0)
    outcome.say("  " + style.warn(std::to_string(counts.crowded_steps) + " steps") +
                " had more impacts than " + std::to_string(counts.max_impacts) +
                "; the rest of these steps was taken in substeps in which a pair bounces once");
  if (const auto fallback = end.run.fallback())
    outcome.say("  " + style.warn("step by step") + " from " + shortest_text(fallback->time) +
                " s on: " + fallback->why);
  if (end.options.expect) tell_expectations(end, style, outcome);
  const std::string kept = kept_tolerance_text(end.kept);
  outcome.say("  " + (end.kept.whole() ? kept : style.warn(kept)));
}

}  // namespace

SimulateOutcome reported(const SimulationEnd& end) {
  SimulateOutcome outcome;
  if (end.options.json)
    outcome.json = report_json(end);
  else
    tell(end, Style(stdout), outcome);
  const Style errors(stderr);
  if (end.ending == Ending::interrupted)
    outcome.note("Stopped at " + shortest_text(end.run.now()) + " s" +
                 (end.options.checkpoint.empty()
                      ? ""
                      : "; --resume " + end.options.checkpoint + " goes on"));
  else if (const std::string what = trouble(end); !what.empty())
    outcome.note(errors.bad("contact: ") + what);
  return outcome;
}

}  // namespace contact::cli
