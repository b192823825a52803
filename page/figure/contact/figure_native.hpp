#pragma once

// The native program of a figure: JSON lines in, JSON lines out. Part of figure.hpp.

#include <cstdio>
#include <exception>
#include <iostream>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

namespace contact::figure::detail {

/// JSON has no NaN and no infinity: they are written as text, "nan", "inf" and "-inf".
inline double number_from(const nlohmann::json& json) {
  if (json == "nan") return std::numeric_limits<double>::quiet_NaN();
  if (json == "inf") return std::numeric_limits<double>::infinity();
  if (json == "-inf") return -std::numeric_limits<double>::infinity();
  return json.get<double>();
}

inline std::string number_text(double value) {
  if (std::isnan(value)) return R"("nan")";
  if (std::isinf(value)) return value > 0 ? R"("inf")" : R"("-inf")";
  char text[32];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}

template <typename TheFigure>
std::string answer(const std::string& line) {
  const nlohmann::json given = nlohmann::json::parse(line);
  std::vector<double> numbers;
  std::size_t used = 0;
  const auto take = [&](std::string_view name, int size) {
    const auto found = given.find(std::string(name));
    if (found == given.end()) throw std::invalid_argument("no field " + std::string(name));
    const nlohmann::json list = found->is_array() ? *found : nlohmann::json::array({*found});
    if (list.size() != static_cast<std::size_t>(size))
      throw std::invalid_argument(std::string(name) + " has " + std::to_string(size) + " numbers");
    for (const auto& number : list) numbers.push_back(number_from(number));
    ++used;
  };
  std::apply([&](const auto&... field) { (take(field.name, field.size), ...); }, TheFigure::inputs);
  if (used != given.size()) throw std::invalid_argument("a field that this figure does not have");

  std::array<double, static_cast<std::size_t>(TheFigure::output_size)> result{};
  TheFigure::run(numbers.data(), result.data());

  std::string text = "{";
  const double* next = result.data();
  const auto give = [&](std::string_view name, int size) {
    text += (text.size() > 1 ? ",\"" : "\"") + std::string(name) + "\":[";
    for (int i = 0; i < size; ++i) text += (i > 0 ? "," : "") + number_text(*next++);
    text += "]";
  };
  std::apply([&](const auto&... field) { (give(field.name, field.size), ...); },
             TheFigure::outputs);
  return text + "}";
}

template <typename Fields>
constexpr bool has_error(const Fields& fields) {
  return std::apply([](const auto&... field) { return (... || (field.name == "error")); }, fields);
}

template <typename TheFigure>
int native_main(int argc, char** argv) {
  static_assert(!has_error(TheFigure::outputs),
                "an output called `error` would be read as the message of an exception");
  if (argc == 2 && std::string_view(argv[1]) == "--layout") {
    std::puts(TheFigure::layout.data());
    return 0;
  }
  if (argc > 1) {
    std::fprintf(stderr, "usage: %s [--layout]   (JSON lines on standard input)\n", argv[0]);
    return 2;
  }
  for (std::string line; std::getline(std::cin, line);) {
    if (line.empty()) continue;
    std::string text;
    try {
      text = answer<TheFigure>(line);
    } catch (const std::exception& problem) {
      text = nlohmann::json{{"error", problem.what()}}.dump();
    }
    std::puts(text.c_str());
    std::fflush(stdout);
  }
  return 0;
}

}  // namespace contact::figure::detail

#define CONTACT_FIGURE_ENTRY(TheFigure)                                   \
  int main(int argc, char** argv) {                                       \
    return ::contact::figure::detail::native_main<TheFigure>(argc, argv); \
  }
