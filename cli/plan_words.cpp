#include "plan_words.hpp"

#include <cmath>
#include <cstdlib>
#include <optional>

#include "../grading/book.hpp"

namespace contact::cli {

namespace {

// The effects of a list of names.
std::vector<Effect> effects_of(const std::vector<std::string>& names) {
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
    throw grading::UnknownName(
        effect ? "'" + name + "' is a value; it is not switched on or off. These are: " + known
               : "there is no effect called '" + name + "'; there are " + known);
  }
  return effects;
}

}  // namespace

void add_plan_words(Command command, PlanWords& words) {
  command.add_option("--with", words.with, "Force an effect on; may be given again")
      .type_name("EFFECT")
      .one_value();
  command.add_option("--without", words.without, "Force an effect off; may be given again")
      .type_name("EFFECT")
      .one_value();
  command.add_option("--step", words.step, "Go step by step, in steps of so many seconds")
      .type_name("SECONDS");
}

double seconds_of(const std::string& option, const std::string& text, bool zero) {
  char* end = nullptr;
  const double seconds = std::strtod(text.c_str(), &end);
  const bool number = !text.empty() && *end == '\0' && std::isfinite(seconds);
  if (!number || seconds < 0 || (seconds == 0 && !zero))
    throw grading::UnknownName(option + " " + text + ": must be finite and " +
                               (zero ? "not negative" : "greater than 0") + ", in seconds");
  return seconds;
}

PlanOptions plan_options(const PlanWords& words) {
  PlanOptions options;
  options.overrides.with = effects_of(words.with);
  options.overrides.without = effects_of(words.without);
  for (const Effect effect : options.overrides.with) {
    for (const Effect other : options.overrides.without) {
      if (effect == other)
        throw grading::UnknownName("'" + std::string(effect_name(effect)) +
                                   "' is asked for both with and without");
    }
  }
  if (!words.step.empty()) options.step = seconds_of("--step", words.step, false);
  return options;
}

}  // namespace contact::cli
