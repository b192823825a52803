// The scene player of the page: reads a scene, plans it, runs it as planned and, beside that, as
// the reader switches it. Requests and replies are JSON; the page reads positions as numbers.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <contact/plan/plan.hpp>
#include <contact/plan/plan_report.hpp>
#include <contact/scene/scene_file.hpp>
#include <nlohmann/json.hpp>

#include "player_run.hpp"

#define CONTACT_PLAYER_EXPORT(name) __attribute__((export_name(name)))

namespace contact::scenes {

namespace {

using nlohmann::json;

json json_of(const Vector3<double>& v) { return {v.x(), v.y(), v.z()}; }

json json_of(const SceneShape& shape) {
  if (const auto* ball = std::get_if<BallShape>(&shape))
    return {{"type", "sphere"}, {"radius", ball->radius}};
  if (const auto* box = std::get_if<BoxShape>(&shape))
    return {{"type", "box"}, {"half_lengths", json_of(box->half_lengths)}};
  if (const auto* capsule = std::get_if<CapsuleShape>(&shape)) {
    return {
        {"type", "capsule"}, {"radius", capsule->radius}, {"half_length", capsule->half_length}};
  }
  if (const auto* hull = std::get_if<HullShape>(&shape)) {
    json points = json::array();
    for (const Vector3<double>& point : hull->points) points.push_back(json_of(point));
    return {{"type", "hull"}, {"points", points}};
  }
  const auto& wall = std::get<HalfSpaceShape>(shape);
  return {{"type", "half_space"}, {"normal", json_of(wall.normal)}, {"offset", wall.offset}};
}

json json_of(const Scene& scene) {
  json bodies = json::array();
  for (const SceneBody& body : scene.bodies)
    bodies.push_back({{"name", body.name}, {"moves", body.moves}, {"shape", json_of(body.shape)}});
  const std::optional<double>& position = scene.tolerance.position;
  return {{"name", scene.name},
          {"about", scene.about},
          {"duration", scene.duration},
          {"gravity", json_of(scene.gravity)},
          {"tolerance", position ? json(*position) : json(nullptr)},
          {"bodies", bodies}};
}

/// The plan as in `contact plan --json`, and with each decision its conditions in words.
json told(const Scene& scene, const Plan& plan) {
  json all = plan_json(scene, plan);
  all["accepted"] = accepted_text(plan);
  for (std::size_t i = 0; i < plan.decisions.size(); ++i) {
    const Decision& decision = plan.decisions[i];
    std::vector<std::string> says;  // two proofs may fail for the same reason
    for (const Inequality& condition : decision.because) {
      std::string line = inequality_text(condition);
      if (std::find(says.begin(), says.end(), line) == says.end()) says.push_back(std::move(line));
    }
    all["decisions"][i]["says"] = says;
    all["decisions"][i]["switched"] = can_be_switched(decision.effect);
  }
  return all;
}

std::vector<Effect> effects_of(const json& names) {
  std::vector<Effect> effects;
  for (const json& name : names) {
    const std::optional<Effect> effect = effect_named(name.get<std::string>());
    if (!effect) throw std::invalid_argument("there is no effect called " + name.dump());
    effects.push_back(*effect);
  }
  return effects;
}

/// A run with the data that the page shows.
class Side {
 public:
  Side(const Scene& scene, const Plan& plan) : run_(player_run(scene, plan)) {
    first_energy_ = run_->energy();
  }

  [[nodiscard]] SceneRun& run() { return *run_; }

  [[nodiscard]] json composition() const {
    json stages = json::array();
    for (const SceneStage& stage : run_->stages())
      stages.push_back({{"name", stage.name}, {"detail", stage.detail}});
    const std::optional<SceneFallback> fallback = run_->fallback();
    return {{"event_driven", run_->event_driven()},
            {"step", run_->step()},
            {"bytes_per_body", run_->bytes_per_body()},
            {"bytes", run_->bytes()},
            {"stages", stages},
            {"fallback",
             fallback ? json({{"time", fallback->time}, {"why", fallback->why}}) : json(nullptr)}};
  }

  /// The data that the page draws and counts; `numbers` gets `frame_head` of them, then seven a
  /// body: its position, and the quaternion of its orientation.
  void write(const Scene& scene, const Side* other, std::vector<double>& numbers) const {
    const SceneRunCounts counts = run_->counts();
    numbers.clear();
    for (const double x :
         {run_->now(), run_->energy(), first_energy_, static_cast<double>(counts.steps),
          static_cast<double>(counts.substeps), static_cast<double>(counts.hits),
          static_cast<double>(counts.pairs), static_cast<double>(counts.contacts),
          static_cast<double>(counts.rests), counts.largest_overlap,
          static_cast<double>(run_->bytes()), static_cast<double>(run_->bytes_per_body()),
          static_cast<double>(run_->event_driven())}) {
      numbers.push_back(x);
    }
    double apart = 0;
    double farthest = -1;
    for (std::size_t i = 0; i < scene.bodies.size() && other != nullptr; ++i) {
      const double d = (run_->position(i) - other->run_->position(i)).norm();
      if (!(d > apart)) continue;
      apart = d;
      farthest = static_cast<double>(i);
    }
    numbers.push_back(apart);
    numbers.push_back(farthest);
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
      const Vector3<double> p = run_->position(i);
      const Quaternion<double> q = run_->orientation(i);
      for (const double x : {p.x(), p.y(), p.z(), q.w, q.v.x(), q.v.y(), q.v.z()})
        numbers.push_back(x);
    }
  }

 private:
  std::unique_ptr<SceneRun> run_;
  double first_energy_ = 0;
};

/// One scene, planned and run.
class Player {
 public:
  json open(const json& request) {
    const std::string text = request.at("text").get<std::string>();
    try {
      scene_ = scene_from_text(text, request.at("file").get<std::string>());
    } catch (const SceneFileError& error) {
      // The lines that `contact scene check` prints.
      return {{"wrong", error.what()}};
    }
    plan_ = plan_scene(scene_);
    return {{"scene", json_of(scene_)}, {"plan", told(scene_, plan_)}, {"sides", begin(request)}};
  }

  json switched(const json& request) { return {{"sides", begin(request)}}; }

  /// @return 0: reached; 1: the budget is used up; 2: it cannot go on
  int advance(std::size_t which, double until, double budget) {
    try {
      SceneRun& run = side(which).run();
      switch (run.advance(until, static_cast<std::uint64_t>(budget), nullptr)) {
        case SceneRunEnd::reached:
          return 0;
        case SceneRunEnd::out_of_budget:
          return 1;
        default:
          trouble_ = "Infinitely many hits at one instant: " + body(run.counts().endless_first) +
                     " and " + body(run.counts().endless_second) + ".";
      }
    } catch (const std::exception& error) {
      trouble_ = error.what();
    }
    return 2;
  }

  const std::vector<double>& frame(std::size_t which) {
    const bool beside = which == 1 && sides_[0] != nullptr;
    side(which).write(scene_, beside ? sides_[0].get() : nullptr, numbers_);
    return numbers_;
  }

  json composition(const json& request) {
    return side(request.at("side").get<std::size_t>()).composition();
  }

  [[nodiscard]] json trouble() const { return trouble_; }

 private:
  Side& side(std::size_t which) {
    if (which > 1 || sides_[which] == nullptr) throw std::out_of_range("there is no such run");
    return *sides_[which];
  }

  [[nodiscard]] std::string body(std::size_t i) const {
    return i < scene_.bodies.size() ? scene_.bodies[i].name : "a body";
  }

  /// Both runs from the start: as planned, and with the reader's overrides if there are any.
  json begin(const json& request) {
    trouble_.clear();
    PlanOptions options;
    options.overrides.with = effects_of(request.value("with", json::array()));
    options.overrides.without = effects_of(request.value("without", json::array()));
    if (request.contains("step")) options.step = request.at("step").get<double>();
    json sides = json::array({start(0, plan_)});
    sides_[1].reset();
    if (options.step || !options.overrides.with.empty() || !options.overrides.without.empty()) {
      const Plan plan = plan_scene(scene_, options);
      json beside = start(1, plan);
      beside["plan"] = told(scene_, plan);
      sides.push_back(std::move(beside));
    }
    return sides;
  }

  json start(std::size_t which, const Plan& plan) {
    sides_[which].reset();
    try {
      sides_[which] = std::make_unique<Side>(scene_, plan);
    } catch (const std::exception& error) {
      return {{"refused", error.what()}};
    }
    return sides_[which]->composition();
  }

  Scene scene_;
  Plan plan_;
  std::unique_ptr<Side> sides_[2];  // as planned; as switched
  std::vector<double> numbers_;
  std::string trouble_;
};

Player& player() {
  static Player the_player;
  return the_player;
}

json answer(const json& request) {
  const std::string what = request.at("do").get<std::string>();
  if (what == "open") return player().open(request);
  if (what == "switch") return player().switched(request);
  if (what == "composition") return player().composition(request);
  if (what == "trouble") return player().trouble();
  throw std::runtime_error("the player does not know how to '" + what + "'");
}

std::string answer_text(std::string_view request) {
  json reply;
  try {
    reply = {{"ok", answer(json::parse(request))}};
  } catch (const std::exception& error) {
    reply = {{"error", error.what()}};
  }
  return reply.dump(-1, ' ', false, json::error_handler_t::replace);
}

const std::vector<double>* last_frame = nullptr;

}  // namespace

}  // namespace contact::scenes

/// A buffer for a request of this many bytes; player_answer frees it.
extern "C" CONTACT_PLAYER_EXPORT("player_room") char* player_room(std::size_t bytes) {
  return static_cast<char*>(std::malloc(bytes));
}

/// Takes a request, {"do": ..., ...}, and returns {"ok": ...} or {"error": "..."}, which stays
/// valid until the next call.
extern "C" CONTACT_PLAYER_EXPORT("player_answer") const
    char* player_answer(char* request, std::size_t bytes) {
  static std::string reply;
  reply = contact::scenes::answer_text({request, bytes});
  std::free(request);
  return reply.c_str();
}

/// Runs a side (0: as planned, 1: as switched) until a time, or for so many hits or steps.
extern "C" CONTACT_PLAYER_EXPORT("player_advance") int player_advance(std::size_t side,
                                                                      double until, double budget) {
  return contact::scenes::player().advance(side, until, budget);
}

/// Makes the frame of a side: its number of numbers. A side that does not exist has none.
extern "C" CONTACT_PLAYER_EXPORT("player_frame") std::size_t player_frame(std::size_t side) {
  using namespace contact::scenes;
  try {
    last_frame = &player().frame(side);
  } catch (const std::exception&) {
    last_frame = nullptr;
  }
  return last_frame == nullptr ? 0 : last_frame->size();
}

/// Address of the numbers of the last frame.
extern "C" CONTACT_PLAYER_EXPORT("player_numbers") const double* player_numbers() {
  using namespace contact::scenes;
  return last_frame == nullptr ? nullptr : last_frame->data();
}
