#include <contact/plan/plan_words.hpp>

#include <cmath>
#include <cstdlib>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <contact/plan/plan.hpp>
#include <contact/plan/plan_types.hpp>
#include <contact/scene/compiled.hpp>
#include <contact/scene/scene_check.hpp>

namespace contact::scenes {

namespace detail {

/// The effects of a list of names.
CONTACT_SCENES_INLINE std::vector<Effect> effects_of(const std::vector<std::string>& names) {
  std::vector<Effect> effects;
  for (const std::string& name : names) {
    const std::optional<Effect> effect = effect_named(name);
    if (effect && can_be_switched(*effect)) {
      effects.push_back(*effect);
      continue;
    }
    std::string known;
    for (const Effect one : all_effects) {
      if (can_be_switched(one))
        known += (known.empty() ? "" : ", ") + std::string(effect_name(one));
    }
    const std::string said = shortened(name);
    throw std::invalid_argument(
        effect ? "'" + said + "' is a value; it is not switched on or off. These are: " + known
               : "there is no effect called '" + said + "'; there are " + known);
  }
  return effects;
}

}  // namespace detail

CONTACT_SCENES_INLINE double seconds_of(const std::string& option, const std::string& text,
                                        bool zero) {
  char* end = nullptr;
  const double seconds = std::strtod(text.c_str(), &end);
  const bool number = !text.empty() && *end == '\0' && std::isfinite(seconds);
  if (!number || seconds < 0 || (seconds == 0 && !zero))
    throw std::invalid_argument(option + " " + shortened(text) + ": must be finite and " +
                                (zero ? "not negative" : "greater than 0") + ", in seconds");
  return seconds;
}

CONTACT_SCENES_INLINE void require_possible_run(double until, double every, const Plan& plan) {
  const std::string option = "--until " + shortest_text(until);
  const auto counted = [&](double count, double each, const std::string& what) {
    return option + ": that is " + contact::detail::short_number(count) + " " + what + " of " +
           shortest_text(each) + " s, and a run has at most " +
           contact::detail::short_number(max_steps) + "; ";
  };
  if (until > max_scene_value) {
    throw std::invalid_argument(option + ": must be at most " + shortest_text(max_scene_value) +
                                " s, like the duration of a scene");
  }
  if (plan.step > 0 && until / plan.step > max_steps) {
    throw std::invalid_argument(counted(until / plan.step, plan.step, "steps") + "choose at most " +
                                contact::detail::short_number(max_steps * plan.step) +
                                " s, or a longer step by --step");
  }
  if (every > 0 && until / every > max_steps) {
    throw std::invalid_argument(counted(until / every, every, "frames") + "choose at most " +
                                contact::detail::short_number(max_steps * every) +
                                " s, or fewer frames by --every");
  }
}

CONTACT_SCENES_INLINE PlanOptions plan_options(const PlanWords& words) {
  PlanOptions options;
  options.overrides.with = detail::effects_of(words.with);
  options.overrides.without = detail::effects_of(words.without);
  for (const Effect effect : options.overrides.with) {
    for (const Effect other : options.overrides.without) {
      if (effect == other)
        throw std::invalid_argument("'" + std::string(effect_name(effect)) +
                                    "' is asked for both with and without");
    }
  }
  if (!words.step.empty()) options.step = seconds_of("--step", words.step, false);
  return options;
}

}  // namespace contact::scenes
