#include "plan_options.hpp"

#include <stdexcept>

#include "../../grading/book/book.hpp"

namespace contact::cli {

void add_plan_words(Command command, scenes::PlanWords& words) {
  command.add_option("--with", words.with, "Force an effect on; may be repeated")
      .type_name("EFFECT")
      .one_value();
  command.add_option("--without", words.without, "Force an effect off; may be repeated")
      .type_name("EFFECT")
      .one_value();
  command.add_option("--step", words.step, "Go step by step, in steps of so many seconds")
      .type_name("SECONDS");
}

PlanOptions typed_plan_options(const scenes::PlanWords& words) {
  try {
    return scenes::plan_options(words);
  } catch (const std::invalid_argument& error) {
    throw grading::UnknownName(error.what());
  }
}

void require_possible_run(double until, double every, const Plan& plan) {
  try {
    scenes::require_possible_run(until, every, plan);
  } catch (const std::invalid_argument& error) {
    throw grading::UnknownName(error.what());
  }
}

double seconds_of(const std::string& option, const std::string& text, bool zero) {
  try {
    return scenes::seconds_of(option, text, zero);
  } catch (const std::invalid_argument& error) {
    throw grading::UnknownName(error.what());
  }
}

}  // namespace contact::cli
