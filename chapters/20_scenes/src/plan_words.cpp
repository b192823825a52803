#include <contact/plan/plan_words.hpp>

#include <cmath>
#include <cstdlib>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <contact/plan/plan_types.hpp>
#include <contact/scene/compiled.hpp>

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
    throw std::invalid_argument(
        effect ? "'" + name + "' is a value; it is not switched on or off. These are: " + known
               : "there is no effect called '" + name + "'; there are " + known);
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
    throw std::invalid_argument(option + " " + text + ": must be finite and " +
                                (zero ? "not negative" : "greater than 0") + ", in seconds");
  return seconds;
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
