#include "profile.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <string>
#include <variant>
#include <vector>

#include <toml++/toml.h>
#include <nlohmann/json.hpp>

namespace fs = std::filesystem;

namespace contact::grading {

namespace {

using Member = std::variant<double GradeLimits::*, int GradeLimits::*, long GradeLimits::*,
                            std::size_t GradeLimits::*>;

struct Key {
  const char* name;
  Member member;
  double least;
  double most;
};

constexpr double mib = 1 << 20;

// What a profile may say, and within what: beyond these a number is a slip of the pen.
const std::array<Key, 19> keys{{
    {"test_cpu_seconds", &GradeLimits::test_cpu_seconds, 0.0, 3600.0},
    {"wall_factor", &GradeLimits::wall_factor, 1.0, 100.0},
    {"wall_extra", &GradeLimits::wall_extra, 1.0, 3600.0},
    {"idle_seconds", &GradeLimits::idle_seconds, 0.1, 3600.0},
    {"idle_seconds_in_all", &GradeLimits::idle_seconds_in_all, 0.0, 3600.0},
    {"memory_mb", &GradeLimits::memory_mb, 32, 65536},
    {"processes", &GradeLimits::processes, 1, 1024},
    {"output_bytes", &GradeLimits::output_bytes, 0, 64 * mib},
    {"files_mb", &GradeLimits::files_mb, 1, 4096},
    {"files", &GradeLimits::files, 16, 100000},
    {"compile_cpu_seconds", &GradeLimits::compile_cpu_seconds, 1.0, 3600.0},
    {"compile_idle_seconds", &GradeLimits::compile_idle_seconds, 1.0, 3600.0},
    {"compile_memory_mb", &GradeLimits::compile_memory_mb, 256, 65536},
    {"compile_processes", &GradeLimits::compile_processes, 4, 1024},
    {"diagnostics_bytes", &GradeLimits::diagnostics_bytes, 1024, 16 * mib},
    {"object_mb", &GradeLimits::object_mb, 1, 4096},
    {"answer_bytes", &GradeLimits::answer_bytes, 1024, 256 * mib},
    {"calls", &GradeLimits::calls, 1, 1e9},
    {"unit_seconds", &GradeLimits::unit_seconds, 0.0, 86400.0},
}};

// A limit that is added to GradeLimits and not to the list above stops the compiler here.
[[maybe_unused]] std::size_t count_members(const GradeLimits& limits) {
  [[maybe_unused]] const auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s] = limits;
  return keys.size();
}

std::string number(double value) { return nlohmann::json(value).dump(); }

std::string limit_text(const Key& key, double value) {
  return std::holds_alternative<double GradeLimits::*>(key.member)
             ? number(value)
             : std::to_string(static_cast<long long>(value));
}

void set(GradeLimits& limits, const Key& key, double value) {
  std::visit(
      [&](auto member) {
        using Type = std::remove_reference_t<decltype(limits.*member)>;
        limits.*member = static_cast<Type>(value);
      },
      key.member);
}

std::string place(const fs::path& file, const toml::source_region& source) {
  return file.string() + ":" + std::to_string(source.begin.line) + ": ";
}

const Key& key_named(const std::string& name, const std::string& where) {
  std::vector<std::string> names;
  for (const Key& key : keys) {
    if (name == key.name) return key;
    names.emplace_back(key.name);
  }
  std::string text = where + "there is no limit '" + name + "'";
  std::vector<std::string> near = nearest(name, names);
  if (near.empty())
    std::copy_if(names.begin(), names.end(), std::back_inserter(near),
                 [&](const std::string& known) { return known.starts_with(name); });
  if (!near.empty()) throw BookError(text + ". Did you mean " + near.front() + "?");
  text += "; a profile may set ";
  for (std::size_t i = 0; i < names.size(); ++i)
    text += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
  throw BookError(text);
}

}  // namespace

GradeLimits read_profile(const fs::path& file) {
  const std::string text = read_text(file);
  toml::table table;
  try {
    table = toml::parse(std::string_view(text), file.string());
  } catch (const toml::parse_error& error) {
    throw BookError(place(file, error.source()) + std::string(error.description()));
  }
  GradeLimits limits;
  for (const auto& [name, node] : table) {
    const std::string where = place(file, node.source());
    const Key& key = key_named(std::string(name.str()), where);
    const bool whole = !std::holds_alternative<double GradeLimits::*>(key.member);
    const std::optional<double> value = node.is_integer() || (node.is_floating_point() && !whole)
                                            ? node.value<double>()
                                            : std::nullopt;
    if (!value)
      throw BookError(where + key.name + " must be a " + (whole ? "whole number" : "number"));
    if (!(*value >= key.least && *value <= key.most))
      throw BookError(where + key.name + " must be between " + limit_text(key, key.least) +
                      " and " + limit_text(key, key.most));
    set(limits, key, *value);
  }
  return limits;
}

nlohmann::json to_json(const GradeLimits& limits) {
  nlohmann::json json = nlohmann::json::object();
  for (const Key& key : keys) {
    std::visit([&](auto member) { json[key.name] = limits.*member; }, key.member);
  }
  return json;
}

GradeLimits limits_from_json(const nlohmann::json& json) {
  GradeLimits limits;
  for (const Key& key : keys) {
    // A version of the program that did not have it yet had no other limit in its place.
    if (!json.contains(key.name)) continue;
    std::visit([&](auto member) { json.at(key.name).get_to(limits.*member); }, key.member);
  }
  return limits;
}

}  // namespace contact::grading
