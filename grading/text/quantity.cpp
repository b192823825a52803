#include "quantity.hpp"

#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <regex>
#include <sstream>
#include <stdexcept>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

namespace contact::grading {

namespace {

using Factors = std::vector<std::pair<std::string, int>>;

std::string replaced(std::string text, std::string_view from, std::string_view to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at)) {
    text.replace(at, from.size(), to);
    at += to.size();
  }
  return text;
}

std::string trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) return {};
  return std::string(text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1));
}

// Raised digits as ^ and plain ones; several in a row have one ^.
std::string lowered(std::string_view text) {
  static constexpr std::array<std::pair<std::string_view, char>, 5> raised{
      {{"⁻", '-'}, {"¹", '1'}, {"²", '2'}, {"³", '3'}, {"⁴", '4'}}};
  std::string result;
  bool before = false;
  while (!text.empty()) {
    bool found = false;
    for (const auto& [mark, plain] : raised) {
      if (!text.starts_with(mark)) continue;
      if (!before) result += '^';
      result += plain;
      text.remove_prefix(mark.size());
      found = true;
      break;
    }
    before = found;
    if (found) continue;
    result += text.front();
    text.remove_prefix(1);
  }
  return result;
}

// The factors of a unit with their powers. What is not written as a unit is one unit of its own,
// which no other equals.
Factors factors(std::string_view text) {
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 11> spellings{
      {{"°C", " degC "},
       {"°", " deg "},
       {"degrees", "deg"},
       {"degree", "deg"},
       {"μ", "µ"},
       {"·", " "},
       {"⋅", " "},
       {"*", " "},
       {"×", " "},
       {"−", "-"},
       {"\t", " "}}};
  static const std::regex slash(R"(\s*/\s*)");
  static const std::regex factor(R"((/?)([^0-9^/-]+)(?:\^?(-?[0-9]{1,3}))?)");
  std::string plain = lowered(text);
  for (const auto& [from, to] : spellings) plain = replaced(std::move(plain), from, to);
  std::istringstream parts(std::regex_replace(plain, slash, " /"));
  Factors found;
  for (std::string part; parts >> part;) {
    if (part == "1") continue;
    std::smatch match;
    if (!std::regex_match(part, match, factor)) return {{trimmed(text), 1}};
    const int power = match[3].matched ? std::stoi(match[3]) : 1;
    found.emplace_back(match[2], match[1].length() > 0 ? -power : power);
  }
  return found;
}

void add(std::map<std::string, int>& powers, const std::string& name, int power) {
  if ((powers[name] += power) == 0) powers.erase(name);
}

std::map<std::string, int> own_powers(std::string_view unit) {
  std::map<std::string, int> powers;
  for (const auto& [name, power] : factors(unit)) add(powers, name, power);
  return powers;
}

}  // namespace

std::optional<Quantity> parse_quantity(std::string_view text) {
  static const std::regex number(
      R"(([-+]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][-+]?[0-9]+)?)(?:\s*/\s*([0-9]+\.?[0-9]*))?)");
  std::string plain = trimmed(text);
  // A minus sign as print has it, in front only: the unit keeps its own.
  for (const std::string_view minus : {"−", "–"}) {
    if (plain.starts_with(minus)) plain.replace(0, minus.size(), "-");
  }
  std::smatch match;
  if (!std::regex_search(plain, match, number, std::regex_constants::match_continuous)) return {};
  const std::string rest = match.suffix();
  if (!rest.empty() && (rest.front() == '.' || (rest.front() >= '0' && rest.front() <= '9')))
    return {};
  double value = std::strtod(match[1].str().c_str(), nullptr);
  if (match[2].matched) value /= std::strtod(match[2].str().c_str(), nullptr);
  if (!std::isfinite(value)) return {};
  return Quantity{value, trimmed(rest)};
}

bool same_unit(std::string_view one, std::string_view other) {
  return own_powers(one) == own_powers(other);
}

Units::Units(const std::filesystem::path& file) {
  std::ifstream stream(file);
  if (!stream) throw std::runtime_error("cannot read " + file.string());
  const nlohmann::json listed = nlohmann::json::parse(stream);
  for (const auto& [name, unit] : listed.items())
    units_[name] = {unit.at(0).get<double>(), unit.at(1).get<std::string>()};
}

Units::Measure Units::measure(std::string_view unit) const {
  Measure result;
  for (const auto& [name, power] : factors(unit)) {
    const auto known = units_.find(name);
    if (known == units_.end() || known->second.of == name) {
      add(result.powers, name, power);
      continue;
    }
    result.factor *= std::pow(known->second.factor, power);
    for (const auto& [base, exponent] : factors(known->second.of))
      add(result.powers, base, exponent * power);
  }
  return result;
}

std::optional<double> Units::in_unit(const Quantity& quantity, std::string_view wanted) const {
  if (same_unit(quantity.unit, wanted)) return quantity.value;
  const Measure from = measure(quantity.unit);
  const Measure to = measure(wanted);
  if (from.powers != to.powers) return {};
  return quantity.value * from.factor / to.factor;
}

}  // namespace contact::grading
