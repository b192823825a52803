#include <contact/plan/plan_report.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include <contact/plan/plan_types.hpp>
#include <contact/scene/compiled.hpp>
#include <contact/scene/scene.hpp>

#include "plan_phrases.hpp"

namespace contact::scenes {

namespace detail {

inline constexpr std::size_t effect_width = 20;
inline constexpr std::size_t switch_width = 11;
inline constexpr std::size_t text_width = 80;
inline constexpr std::size_t summary_lines = 25;
inline constexpr std::size_t summary_head = 5;  // lines of a summary besides those of effects

CONTACT_SCENES_INLINE std::string switched(const Decision& decision) {
  if (decision.value && decision.on) return plan_number(*decision.value) + " s";
  return decision.on ? "on" : "off";
}

/// "on", "off, forced", "on, proven" or "0.0002 s". What is off is proven to change nothing, unless
/// it is forced; of what is on, only from event to event is a proof.
CONTACT_SCENES_INLINE std::string state_of(const Decision& decision) {
  if (decision.overridden) return switched(decision) + ", forced";
  const bool proven = decision.on && decision.proven && !decision.value;
  return switched(decision) + (proven ? ", proven" : "");
}

/// "Saves about 4300 instructions: 440 for each body and substep (10)."
/// @param same_stages whether a run with the effect switched was seen to have the same stages
CONTACT_SCENES_INLINE std::string saving_text(const Decision& decision, bool same_stages) {
  if (!decision.changes_nothing.empty()) {
    return std::string(decision.overridden ? "Forced, but changes" : "Switching it changes") +
           " nothing here: " + decision.changes_nothing + ".";
  }
  const Saving& saving = decision.saving;
  if (same_stages) {
    return saving.instructions != 0
               ? "Switching it changes nothing here: the run has the same stages."
               : "";
  }
  if (saving.is.empty()) return {};
  if (saving.instructions == 0)
    return std::string(decision.on ? "Costs " : "Saves ") + saving.is + ".";
  const bool costs = decision.on == (saving.instructions > 0);
  return std::string(costs ? "Costs" : "Saves") + " about " +
         plan_number(std::abs(saving.instructions)) + " instructions: " + saving.is + ".";
}

/// A line cut to a number of characters.
CONTACT_SCENES_INLINE std::string cut(const std::string& line, std::size_t width) {
  std::size_t seen = 0;
  std::size_t last = 0;  // where the last character but one ends
  for (std::size_t at = 0; at < line.size(); ++at) {
    if ((static_cast<unsigned char>(line[at]) & 0xc0U) == 0x80U) continue;
    if (++seen == width) last = at;
    if (seen > width) return line.substr(0, last) + "…";
  }
  return line;
}

CONTACT_SCENES_INLINE std::string pairs_text(const Plan& plan) {
  return std::to_string(plan.pairs) + (plan.pairs == 1 ? " pair" : " pairs") +
         " of bodies may meet; nothing is faster than " + plan_number(plan.speed) + " m/s.";
}

/// What decided about an effect, and the error that it makes.
CONTACT_SCENES_INLINE std::string summary_of(const Decision& decision) {
  if (decision.overridden) {
    if (!decision.changes_nothing.empty())
      return "changes nothing here: " + decision.changes_nothing;
    return std::string("the plan says ") + (decision.planned ? "on" : "off") + ": " +
           reason_text(decision);
  }
  const std::string reason = reason_text(decision);
  if (!(decision.error > 0)) return reason;
  const std::string error =
      std::isfinite(decision.error) ? with_unit(decision.error, "m") : "no bound";
  // The number that decided may be the error.
  return reason.find(error + " ≤") == std::string::npos ? reason + "; error " + error : reason;
}

CONTACT_SCENES_INLINE void add_lines(std::string& text, const std::string& lines,
                                     const TableStyle& style) {
  if (lines.empty()) return;
  text += style.wrapped(lines, effect_width + 2, text_width);
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
  if (condition.relation == Relation::equal) return condition_text(condition);
  const auto [left, right] = detail::sides_of(condition);
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
  if (measured.same_stages)
    return "Measured: the run " + other + " it has the same stages, so that it changes nothing.";
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

CONTACT_SCENES_INLINE std::string plan_summary(const Scene& scene, const Plan& plan,
                                               const TableStyle& style) {
  const auto divided = [&](const std::string& words, std::size_t width) {
    std::vector<std::string> parts;
    std::string rest = style.wrapped(words, 0, width);
    for (std::size_t end = 0; end != std::string::npos; rest.erase(0, end + 1)) {
      end = rest.find('\n');
      parts.push_back(detail::cut(rest.substr(0, end), width));
      if (end == std::string::npos) break;
    }
    return parts;
  };
  // What is longer than a line takes more of them, as long as there are any.
  std::size_t spare = detail::summary_lines - detail::summary_head - plan.decisions.size();
  const auto fitted = [&](const std::string& words, std::size_t width) {
    std::vector<std::string> parts = divided(words, width);
    if (parts.size() - 1 > spare) {
      const bool alone = spare == 0;
      parts.resize(spare + 1);
      parts.back() = detail::cut(alone ? words : parts.back() + " …", width);
    }
    spare -= parts.size() - 1;
    return parts;
  };
  std::vector<std::string> lines = fitted(scene.name + ": " + scene.about, detail::text_width);
  if (lines.front().starts_with(scene.name))
    lines.front() = style.bold(scene.name) + lines.front().substr(scene.name.size());
  lines.push_back(detail::pairs_text(plan));
  lines.push_back(accepted_text(plan));
  lines.push_back(style.dim(style.padded("effect", detail::effect_width) + "  " +
                            style.padded("plan", detail::switch_width) +
                            "  what decides (off: proven to change nothing)"));
  for (const Decision& decision : plan.decisions) {
    const std::string state = style.padded(detail::state_of(decision), detail::switch_width);
    const std::size_t column = detail::effect_width + 2 + state.size() + 2;
    const std::vector<std::string> said =
        fitted(detail::summary_of(decision), detail::text_width - column);
    lines.push_back(style.padded(effect_name(decision.effect), detail::effect_width) + "  " +
                    (decision.on ? style.warn(state) : style.good(state)) + "  " + said.front());
    for (std::size_t i = 1; i < said.size(); ++i)
      lines.push_back(std::string(column, ' ') + said[i]);
  }
  const std::size_t notices = plan.notices.size();
  const std::string told =
      notices == 0
          ? "All reasons"
          : std::to_string(notices) + (notices == 1 ? " notice" : " notices") + " and all reasons";
  lines.push_back(told + ": with --explain; of one effect: with --explain EFFECT");
  std::string text;
  for (std::size_t i = 0; i < lines.size(); ++i) text += (i == 0 ? "" : "\n") + lines[i];
  return text;
}

CONTACT_SCENES_INLINE std::string plan_text(const Scene& scene, const Plan& plan,
                                            const std::vector<MeasuredEffect>& measured,
                                            const TableStyle& style, std::optional<Effect> only) {
  std::string text;
  if (!only) {
    text = style.wrapped(scene.name + ": " + scene.about, 0, detail::text_width) + "\n";
    if (text.starts_with(scene.name))
      text = style.bold(scene.name) + text.substr(scene.name.size());
    text += detail::pairs_text(plan) + "\n" + accepted_text(plan) + "\n\n";
    text += style.dim(style.padded("effect", detail::effect_width) + "  " +
                      "plan, what decides, the error accepted, the cost") +
            "\n";
  }
  for (const Decision& decision : plan.decisions) {
    if (only && decision.effect != *only) continue;
    std::string head = style.padded(effect_name(decision.effect), detail::effect_width) + "  ";
    const std::string state = detail::state_of(decision);
    head += decision.on ? style.warn(state) : style.good(state);
    if (decision.overridden)
      head += std::string("; the plan says ") + (decision.planned ? "on" : "off");
    text += head + "\n";
    detail::add_lines(text, decision.why, style);
    std::vector<std::string> said;  // two proofs may fail for the same reason
    for (const Inequality& condition : decision.because) {
      // What fails is why an effect is on; what holds beside it is only told.
      const bool decides = decision.proven || !holds(condition);
      const std::string line = (decides ? "because " : "although ") + inequality_text(condition);
      if (std::find(said.begin(), said.end(), line) != said.end()) continue;
      detail::add_lines(text, line, style);
      said.push_back(line);
    }
    if (!decision.overridden && decision.error > 0)
      detail::add_lines(text,
                        "Error accepted: " + detail::with_unit(decision.error, "m") + ", " +
                            decision.error_is + ".",
                        style);
    const auto found =
        std::find_if(measured.begin(), measured.end(),
                     [&](const MeasuredEffect& one) { return one.effect == decision.effect; });
    const bool same = found != measured.end() && found->same_stages;
    detail::add_lines(text, detail::saving_text(decision, same), style);
    if (found != measured.end()) detail::add_lines(text, measured_text(*found, decision.on), style);
  }
  for (std::size_t i = 0; i < plan.notices.size() && !only; ++i)
    text += "\n" + style.warn(style.wrapped(plan.notices[i], 0, detail::text_width)) + "\n";
  while (text.ends_with('\n')) text.pop_back();
  return text;
}

}  // namespace contact::scenes
