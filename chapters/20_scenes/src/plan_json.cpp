#include <contact/plan/plan_report.hpp>

#include <cmath>
#include <vector>

#include <contact/plan/plan_types.hpp>
#include <contact/scene/compiled.hpp>
#include <contact/scene/scene.hpp>
#include <nlohmann/json.hpp>

namespace contact::scenes {

namespace detail {

CONTACT_SCENES_INLINE nlohmann::json number_or_null(double x) {
  return std::isfinite(x) ? nlohmann::json(x) : nlohmann::json(nullptr);
}

CONTACT_SCENES_INLINE const char* relation_name(Relation relation) {
  switch (relation) {
    case Relation::less:
      return "<";
    case Relation::at_most:
      return "<=";
    default:
      return "=";
  }
}

CONTACT_SCENES_INLINE nlohmann::json json_of(const Inequality& condition) {
  return {{"left", number_or_null(condition.left)},
          {"left_is", condition.left_is},
          {"relation", relation_name(condition.relation)},
          {"right", number_or_null(condition.right)},
          {"right_is", condition.right_is},
          {"unit", condition.unit},
          {"holds", holds(condition)}};
}

CONTACT_SCENES_INLINE nlohmann::json json_of(const Decision& decision) {
  nlohmann::json conditions = nlohmann::json::array();
  for (const Inequality& condition : decision.because) conditions.push_back(json_of(condition));
  return {{"effect", effect_name(decision.effect)},
          {"on", decision.on},
          {"planned", decision.planned},
          {"overridden", decision.overridden},
          {"proven", decision.proven},
          {"why", decision.why},
          {"because", conditions},
          {"error", number_or_null(decision.error)},
          {"error_is", decision.error_is},
          {"instructions", number_or_null(decision.saving.instructions)},
          {"instructions_are", decision.saving.is},
          {"changes_nothing", decision.changes_nothing},
          {"value", decision.value ? number_or_null(*decision.value) : nlohmann::json(nullptr)}};
}

CONTACT_SCENES_INLINE nlohmann::json json_of(const MeasuredEffect& measured) {
  if (const auto& horizon = measured.horizon) {
    return {{"time", horizon->time},
            {"apart", horizon->apart},
            {"allowed", horizon->allowed},
            {"diverged", horizon->diverged()}};
  }
  nlohmann::json json{{"same_stages", measured.same_stages},
                      {"planned_bytes", measured.planned_bytes},
                      {"other_bytes", measured.other_bytes}};
  if (!measured.same_stages) {
    json["planned_seconds"] = measured.planned_seconds;
    json["other_seconds"] = measured.other_seconds;
  }
  return json;
}

}  // namespace detail

CONTACT_SCENES_INLINE nlohmann::json plan_json(const Scene& scene, const Plan& plan,
                                               const std::vector<MeasuredEffect>& measured) {
  nlohmann::json decisions = nlohmann::json::array();
  for (const Decision& decision : plan.decisions) {
    decisions.push_back(detail::json_of(decision));
    for (const MeasuredEffect& one : measured)
      if (one.effect == decision.effect) decisions.back()["measured"] = detail::json_of(one);
  }
  return {{"format", "contact-plan/1"},
          {"scene", scene.name},
          {"pairs", plan.pairs},
          {"speed", detail::number_or_null(plan.speed)},
          {"step", detail::number_or_null(plan.step)},
          {"tolerance", plan.tolerance},
          {"error", detail::number_or_null(plan.error)},
          {"decisions", decisions},
          {"notices", plan.notices}};
}

}  // namespace contact::scenes
