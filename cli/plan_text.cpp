// A plan as a table.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

#include "plan_report.hpp"

namespace contact::cli {

namespace {

constexpr std::size_t effect_width = 22;
constexpr std::size_t switch_width = 6;
constexpr std::size_t text_width = 100;

std::string with_unit(double x, const std::string& unit) {
  return std::isfinite(x) && !unit.empty() ? plan_number(x) + " " + unit : plan_number(x);
}

/// The sign between the sides as they are: of a condition that fails, the opposite one.
const char* sign_of_sides(const Inequality& condition) {
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

std::string switched(const Decision& decision) {
  if (decision.value && decision.on) return plan_number(*decision.value) + " s";
  return decision.on ? "on" : "off";
}

/// "Saves about 4300 instructions: 440 for each body and part (10)."
std::string saving_text(const Decision& decision) {
  const Saving& saving = decision.saving;
  if (saving.is.empty()) return {};
  if (saving.instructions == 0)
    return std::string(decision.on ? "Costs " : "Saves ") + saving.is + ".";
  const bool costs = decision.on == (saving.instructions > 0);
  return std::string(costs ? "Costs" : "Saves") + " about " +
         plan_number(std::abs(saving.instructions)) + " instructions: " + saving.is + ".";
}

void add_lines(std::string& text, const std::string& lines) {
  if (lines.empty()) return;
  text += wrapped(lines, effect_width + switch_width + 2, text_width);
  if (!text.ends_with('\n')) text += '\n';
}

}  // namespace

std::string plan_number(double x) {
  if (!std::isfinite(x)) return "no bound";
  std::array<char, 48> text{};
  if (x == std::floor(x) && std::abs(x) < 1e6)
    std::snprintf(text.data(), text.size(), "%.0f", x);
  else
    std::snprintf(text.data(), text.size(), "%.4g", x);
  return text.data();
}

std::string inequality_text(const Inequality& condition) {
  std::string left = with_unit(condition.left, condition.unit);
  std::string right = with_unit(condition.right, condition.unit);
  if (left == right && condition.left != condition.right && std::isfinite(condition.left)) {
    // Four digits do not tell them apart: show all.
    left = number_text(condition.left);
    right = number_text(condition.right);
    if (!condition.unit.empty()) right += " " + condition.unit;
  }
  return condition.left_is + ": " + left + sign_of_sides(condition) + right + " (" +
         condition.right_is + ")";
}

std::string accepted_text(const Plan& plan) {
  if (!std::isfinite(plan.error)) return "Errors accepted, all together: no bound.";
  return "Errors accepted, all together: " + plan_number(plan.error) + " m, of a tolerance of " +
         plan_number(plan.tolerance) + " m.";
}

std::string plan_text(const Scene& scene, const Plan& plan,
                      const std::vector<MeasuredEffect>& measured, const Style& style) {
  std::string text = style.bold(scene.name) + ": " + scene.about + "\n";
  text += std::to_string(plan.pairs) + (plan.pairs == 1 ? " pair" : " pairs") +
          " of bodies may meet; nothing is faster than " + plan_number(plan.speed) + " m/s.\n" +
          accepted_text(plan) + "\n\n";
  text += style.dim(padded("effect", effect_width) + "  " + padded("plan", switch_width) +
                    "what decides, the error accepted, the cost") +
          "\n";
  for (const Decision& decision : plan.decisions) {
    std::string word = switched(decision);
    const std::string name(effect_name(decision.effect));
    std::string head = padded(name, effect_width) + "  ";
    head += decision.on ? style.warn(word) : style.good(word);
    if (decision.overridden)
      head += std::string("  forced; the plan says ") + (decision.planned ? "on" : "off");
    text += head + "\n";
    add_lines(text, decision.why);
    std::vector<std::string> said;  // two proofs may fail for the same reason
    for (const Inequality& condition : decision.because) {
      const std::string line = inequality_text(condition);
      if (std::find(said.begin(), said.end(), line) != said.end()) continue;
      add_lines(text, line);
      said.push_back(line);
    }
    if (!decision.overridden && decision.error > 0)
      add_lines(text, "Error accepted: " + with_unit(decision.error, "m") + ", " +
                          decision.error_is + ".");
    add_lines(text, saving_text(decision));
    for (const MeasuredEffect& one : measured)
      if (one.effect == decision.effect) add_lines(text, measured_text(one, decision.on));
  }
  for (const std::string& notice : plan.notices) text += "\n" + style.warn(notice) + "\n";
  while (text.ends_with('\n')) text.pop_back();
  return text;
}

}  // namespace contact::cli
