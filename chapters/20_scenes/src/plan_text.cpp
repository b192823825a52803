#include <contact/plan/plan_report.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <string>
#include <vector>

#include <contact/plan/plan_types.hpp>
#include <contact/scene/compiled.hpp>
#include <contact/scene/scene.hpp>
#include <contact/scene/scene_check.hpp>

namespace contact::scenes {

namespace detail {

inline constexpr std::size_t effect_width = 22;
inline constexpr std::size_t switch_width = 6;
inline constexpr std::size_t text_width = 100;

CONTACT_SCENES_INLINE std::string with_unit(double x, const std::string& unit) {
  return std::isfinite(x) && !unit.empty() ? plan_number(x) + " " + unit : plan_number(x);
}

/// The relation that holds between the sides: of a condition that fails, the opposite one.
CONTACT_SCENES_INLINE const char* sign_of_sides(const Inequality& condition) {
  const bool held = holds(condition);
  switch (condition.relation) {
    case Relation::less:
      return held ? " < " : " ≥ ";
    case Relation::at_most:
      return held ? " ≤ " : " > ";
    default:
      return held ? " = " : " ≠ ";
  }
}

CONTACT_SCENES_INLINE std::string switched(const Decision& decision) {
  if (decision.value && decision.on) return plan_number(*decision.value) + " s";
  return decision.on ? "on" : "off";
}

/// "Saves about 4300 instructions: 440 for each body and substep (10)."
CONTACT_SCENES_INLINE std::string saving_text(const Decision& decision) {
  const Saving& saving = decision.saving;
  if (saving.is.empty()) return {};
  if (saving.instructions == 0)
    return std::string(decision.on ? "Costs " : "Saves ") + saving.is + ".";
  const bool costs = decision.on == (saving.instructions > 0);
  return std::string(costs ? "Costs" : "Saves") + " about " +
         plan_number(std::abs(saving.instructions)) + " instructions: " + saving.is + ".";
}

CONTACT_SCENES_INLINE void add_lines(std::string& text, const std::string& lines,
                                     const TableStyle& style) {
  if (lines.empty()) return;
  text += style.wrapped(lines, effect_width + switch_width + 2, text_width);
  if (!text.ends_with('\n')) text += '\n';
}

CONTACT_SCENES_INLINE std::string horizon_text(const MeasuredHorizon& measured) {
  return "Measured: a run that begins an ulp away is off by " + plan_number(measured.apart) +
         " m at " + plan_number(measured.time) + " s, " +
         (measured.diverged() ? "more" : "no more") + " than the " + plan_number(measured.allowed) +
         " m allowed.";
}

}  // namespace detail

CONTACT_SCENES_INLINE std::string plan_number(double x) {
  if (!std::isfinite(x)) return "no bound";
  std::array<char, 48> text{};
  if (x == std::floor(x) && std::abs(x) < 1e6)
    std::snprintf(text.data(), text.size(), "%.0f", x);
  else
    std::snprintf(text.data(), text.size(), "%.4g", x);
  return text.data();
}

CONTACT_SCENES_INLINE std::string inequality_text(const Inequality& condition) {
  std::string left = detail::with_unit(condition.left, condition.unit);
  std::string right = detail::with_unit(condition.right, condition.unit);
  if (left == right && condition.left != condition.right && std::isfinite(condition.left)) {
    // Four digits do not tell them apart: show all.
    left = number_text(condition.left);
    right = number_text(condition.right);
    if (!condition.unit.empty()) right += " " + condition.unit;
  }
  return condition.left_is + ": " + left + detail::sign_of_sides(condition) + right + " (" +
         condition.right_is + ")";
}

CONTACT_SCENES_INLINE std::string accepted_text(const Plan& plan) {
  if (!std::isfinite(plan.error)) return "Sum of the errors accepted: no bound.";
  return "Sum of the errors accepted: " + plan_number(plan.error) + " m, of a tolerance of " +
         plan_number(plan.tolerance) + " m.";
}

CONTACT_SCENES_INLINE std::string measured_text(const MeasuredEffect& measured, bool on) {
  if (measured.horizon) return detail::horizon_text(*measured.horizon);
  const std::string other = on ? "without" : "with";
  if (measured.same_stages) return "Measured: the run " + other + " it has the same stages.";
  const auto milliseconds = [](double seconds) { return plan_number(1000 * seconds) + " ms"; };
  std::string text = "Measured: " + milliseconds(measured.planned_seconds) +
                     " of processor time a second as planned, " +
                     milliseconds(measured.other_seconds) + " " + other + " it (" +
                     plan_number(measured.other_seconds / measured.planned_seconds) + " times)";
  if (measured.planned_bytes != measured.other_bytes)
    text += "; " + std::to_string(measured.planned_bytes) + " and " +
            std::to_string(measured.other_bytes) + " bytes a body";
  return text + ".";
}

CONTACT_SCENES_INLINE std::string plan_text(const Scene& scene, const Plan& plan,
                                            const std::vector<MeasuredEffect>& measured,
                                            const TableStyle& style) {
  std::string text = style.bold(scene.name) + ": " + scene.about + "\n";
  text += std::to_string(plan.pairs) + (plan.pairs == 1 ? " pair" : " pairs") +
          " of bodies may meet; nothing is faster than " + plan_number(plan.speed) + " m/s.\n" +
          accepted_text(plan) + "\n\n";
  text += style.dim(style.padded("effect", detail::effect_width) + "  " +
                    style.padded("plan", detail::switch_width) +
                    "what decides, the error accepted, the cost") +
          "\n";
  for (const Decision& decision : plan.decisions) {
    std::string word = detail::switched(decision);
    const std::string name(effect_name(decision.effect));
    std::string head = style.padded(name, detail::effect_width) + "  ";
    head += decision.on ? style.warn(word) : style.good(word);
    if (decision.overridden)
      head += std::string("  forced; the plan says ") + (decision.planned ? "on" : "off");
    text += head + "\n";
    detail::add_lines(text, decision.why, style);
    std::vector<std::string> said;  // two proofs may fail for the same reason
    for (const Inequality& condition : decision.because) {
      const std::string line = inequality_text(condition);
      if (std::find(said.begin(), said.end(), line) != said.end()) continue;
      detail::add_lines(text, line, style);
      said.push_back(line);
    }
    if (!decision.overridden && decision.error > 0)
      detail::add_lines(text,
                        "Error accepted: " + detail::with_unit(decision.error, "m") + ", " +
                            decision.error_is + ".",
                        style);
    detail::add_lines(text, detail::saving_text(decision), style);
    for (const MeasuredEffect& one : measured)
      if (one.effect == decision.effect)
        detail::add_lines(text, measured_text(one, decision.on), style);
  }
  for (const std::string& notice : plan.notices) text += "\n" + style.warn(notice) + "\n";
  while (text.ends_with('\n')) text.pop_back();
  return text;
}

}  // namespace contact::scenes
