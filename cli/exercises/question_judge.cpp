#include "question_judge.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace contact::cli {

using grading::KnownMistake;
using grading::NumberKey;
using grading::Question;

namespace {

// Six significant digits, without zeros at the end.
std::string shown_number(double value) {
  const double size = std::abs(value);
  std::array<char, 64> text{};
  const bool plain = value == 0 || (size < 1e7 && size >= 1e-4);
  const int decimals = plain && value != 0
                           ? std::clamp(5 - static_cast<int>(std::floor(std::log10(size))), 0, 8)
                           : 0;
  if (plain)
    std::snprintf(text.data(), text.size(), "%.*f", decimals, value);
  else
    std::snprintf(text.data(), text.size(), "%.4e", value);
  std::string result = text.data();
  const std::size_t exponent = result.find('e');
  std::string tail;
  if (exponent != std::string::npos) {
    tail = " × 10^" + std::to_string(std::stoi(result.substr(exponent + 1)));
    result.resize(exponent);
  }
  if (result.find('.') != std::string::npos) {
    result.erase(result.find_last_not_of('0') + 1);
    if (result.ends_with('.')) result.pop_back();
  }
  if (result.starts_with('-')) result.replace(0, 1, "−");
  return result + tail;
}

std::size_t place_of(char c) {
  if (c >= 'a' && c <= 'z') return static_cast<std::size_t>(c - 'a');
  if (c >= 'A' && c <= 'Z') return static_cast<std::size_t>(c - 'A');
  if (c >= '1' && c <= '9') return static_cast<std::size_t>(c - '1');
  return std::string::npos;
}

std::string letter(std::size_t index) { return std::string(1, static_cast<char>('a' + index)); }

}  // namespace

std::string shown_key(const NumberKey& key) {
  return shown_number(key.answer) + (key.unit.empty() ? "" : " " + key.unit);
}

Judged judge_number(const grading::Units& units, const NumberKey& key, const std::string& text) {
  const std::optional<grading::Quantity> given = grading::parse_quantity(text);
  if (!given) return {false, false, "Begin with a number, such as −1.5 or 3/4."};
  if (!key.unit.empty() && given->unit.empty()) return {false, false, "Give the unit too."};
  const std::optional<double> value = units.in_unit(*given, key.unit);
  if (!value)
    return {false, true,
            key.unit.empty() ? "The answer has no unit: it is a plain number."
                             : "The unit " + given->unit + " does not measure what is asked."};
  if (!key.convert && !grading::same_unit(given->unit, key.unit))
    return {false, true, "Give it in " + key.unit + "."};
  const auto close = [&](double to) { return std::abs(*value - to) <= key.tolerance; };
  if (close(key.answer)) return {true, true, "It is " + shown_key(key) + "."};
  for (const KnownMistake& mistake : key.wrong) {
    if (close(mistake.answer)) return {false, true, mistake.why};
  }
  if (key.answer != 0 && close(-key.answer))
    return {false, true, "The size is right; look at the sign."};
  return {false, true, "It is another number."};
}

std::optional<std::size_t> named_choice(const std::string& text, std::size_t count) {
  if (text.size() != 1 || place_of(text[0]) >= count) return {};
  return place_of(text[0]);
}

std::optional<std::vector<std::size_t>> named_sequence(const std::string& text, std::size_t count) {
  std::vector<std::size_t> sequence;
  for (const char c : text) {
    if (c == ' ' || c == ',' || c == ';' || c == '\t') continue;
    const std::size_t index = place_of(c);
    if (index >= count || std::find(sequence.begin(), sequence.end(), index) != sequence.end())
      return {};
    sequence.push_back(index);
  }
  if (sequence.size() != count) return {};
  return sequence;
}

Judged judge_choice(const Question& question, std::optional<std::size_t> choice) {
  if (!choice)
    return {false, false, "Choose one of a to " + letter(question.choices.size() - 1) + "."};
  if (*choice == question.right_choice) return {true, true, ""};
  for (const KnownMistake& mistake : question.wrong) {
    if (mistake.answer == static_cast<double>(*choice)) return {false, true, mistake.why};
  }
  return {false, true, "Another one is right."};
}

Judged judge_sequence(const Question& question,
                      const std::optional<std::vector<std::size_t>>& sequence) {
  const std::size_t count = question.choices.size();
  if (!sequence)
    return {false, false, "Name each step from a to " + letter(count - 1) + " once, in order."};
  if (*sequence == question.sequence) return {true, true, ""};
  const auto differs =
      std::mismatch(sequence->begin(), sequence->end(), question.sequence.begin()).first;
  const auto right = differs - sequence->begin();
  return {false, true,
          right == 0
              ? "The first step is another one."
              : "The first " +
                    (right == 1 ? std::string("step is") : std::to_string(right) + " steps are") +
                    " right; then comes another."};
}

}  // namespace contact::cli
