#include "support/hard_cases.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <set>

namespace hard_cases {
namespace {

std::string text_field(const Json& source, const std::string& case_name, const char* field) {
  if (!source.contains(field) || !source.at(field).is_string() ||
      source.at(field).get<std::string>().empty()) {
    throw CorpusError("case \"" + case_name + "\": the field \"" + field +
                      "\" must be a text that is not empty");
  }
  return source.at(field).get<std::string>();
}

}  // namespace

Case::Case(const Json& source) {
  if (!source.is_object()) throw CorpusError("a case must be an object");
  name_ = text_field(source, "(no name)", "name");
  family_ = text_field(source, name_, "family");
  question_ = text_field(source, name_, "question");
  type_ = text_field(source, name_, "type");
  meaning_ = text_field(source, name_, "meaning");
  why_ = text_field(source, name_, "why");
  source_ = text_field(source, name_, "source");
  if (type_ != "double" && type_ != "float") fail("type", "must be \"double\" or \"float\"");
  if (meaning_ != "stored" && meaning_ != "constructed") {
    fail("meaning", "must be \"stored\" or \"constructed\"");
  }
  for (const char* field : {"input", "answer"}) {
    if (!source.contains(field) || !source.at(field).is_object()) fail(field, "must be an object");
  }
  input_ = source.at("input");
  answer_ = source.at("answer");
  if (!source.contains("fails") || !source.at("fails").is_array()) {
    fail("fails", "must be a list of method names, empty if every method is right");
  }
  for (const Json& method : source.at("fails")) {
    if (!method.is_string()) fail("fails", "must hold names only");
    fails_.push_back(method.get<std::string>());
  }
}

void Case::fail(const std::string& path, const std::string& problem) const {
  throw CorpusError("case \"" + name_ + "\", field \"" + path + "\": " + problem);
}

const Json& Case::find(const Json& object, const std::string& path, const std::string& key) const {
  if (!object.is_object() || !object.contains(key)) fail(path, "is missing");
  return object.at(key);
}

oracle::Rational Case::fraction(const Json& value, const std::string& path) const {
  if (value.is_string() && value.get<std::string>().find('x') == std::string::npos) {
    if (meaning_ != "constructed") {
      fail(path, "a stored number is a hexadecimal float, and " + value.dump() + " is none");
    }
    try {
      return oracle::parse_rational(value.get<std::string>());
    } catch (const std::invalid_argument& problem) {
      fail(path, problem.what());
    }
  }
  return oracle::exact(stored(value, path));
}

double Case::stored(const Json& value, const std::string& path) const {
  if (!value.is_string()) fail(path, "numbers are texts, such as \"0x1.8p+1\"");
  const std::string text = value.get<std::string>();
  if (text.find('x') == std::string::npos) {
    const oracle::Rational constructed = fraction(value, path);
    return type_ == "float" ? static_cast<double>(oracle::nearest_float(constructed))
                            : oracle::nearest(constructed);
  }
  if (text.find_first_not_of("0123456789abcdefABCDEFxXpP.+-") != std::string::npos) {
    fail(path, "\"" + text + "\" is not a hexadecimal float");
  }
  char* end = nullptr;
  const double number = std::strtod(text.c_str(), &end);
  if (end != text.c_str() + text.size()) fail(path, "\"" + text + "\" is not a hexadecimal float");
  if (!std::isfinite(number)) fail(path, "\"" + text + "\" is too large for a double");
  if (type_ == "float" && static_cast<double>(static_cast<float>(number)) != number) {
    fail(path, "\"" + text + "\" is not a float, and the case's type is float");
  }
  return number;
}

contact::Vector3<double> Case::stored_vector(const Json& value, const std::string& path) const {
  if (!value.is_array() || value.size() != 3) fail(path, "must be a list of three numbers");
  return {stored(value[0], path + "[0]"), stored(value[1], path + "[1]"),
          stored(value[2], path + "[2]")};
}

double Case::number(const std::string& field) const {
  return stored(find(input_, field, field), field);
}
contact::Vector3<double> Case::vector(const std::string& field) const {
  return stored_vector(find(input_, field, field), field);
}
std::vector<double> Case::numbers(const std::string& field) const {
  const Json& list = find(input_, field, field);
  if (!list.is_array()) fail(field, "must be a list of numbers");
  std::vector<double> all;
  for (const Json& value : list) {
    all.push_back(stored(value, field + "[" + std::to_string(all.size()) + "]"));
  }
  return all;
}
oracle::Rational Case::exact_number(const std::string& field) const {
  return fraction(find(input_, field, field), field);
}
oracle::Vector Case::exact_vector(const std::string& field) const {
  const Json& value = find(input_, field, field);
  if (!value.is_array() || value.size() != 3) fail(field, "must be a list of three numbers");
  return {fraction(value[0], field + "[0]"), fraction(value[1], field + "[1]"),
          fraction(value[2], field + "[2]")};
}
contact::Segment<double> Case::segment(const std::string& field) const {
  const Json& s = find(input_, field, field);
  return {stored_vector(find(s, field + ".start", "start"), field + ".start"),
          stored_vector(find(s, field + ".end", "end"), field + ".end")};
}
contact::Ray<double> Case::ray(const std::string& field) const {
  const Json& r = find(input_, field, field);
  return {stored_vector(find(r, field + ".origin", "origin"), field + ".origin"),
          stored_vector(find(r, field + ".direction", "direction"), field + ".direction")};
}
contact::Sphere<double> Case::sphere(const std::string& field) const {
  const Json& s = find(input_, field, field);
  return {stored_vector(find(s, field + ".centre", "centre"), field + ".centre"),
          stored(find(s, field + ".radius", "radius"), field + ".radius")};
}
contact::Triangle<double> Case::triangle(const std::string& field) const {
  const Json& t = find(input_, field, field);
  return {stored_vector(find(t, field + ".a", "a"), field + ".a"),
          stored_vector(find(t, field + ".b", "b"), field + ".b"),
          stored_vector(find(t, field + ".c", "c"), field + ".c")};
}
contact::Plane<double> Case::plane(const std::string& field) const {
  const Json& p = find(input_, field, field);
  return {stored_vector(find(p, field + ".normal", "normal"), field + ".normal"),
          stored(find(p, field + ".offset", "offset"), field + ".offset")};
}

std::vector<Case> read(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw CorpusError(path + ": cannot be opened");
  Json corpus;
  try {
    corpus = Json::parse(file);
  } catch (const Json::parse_error& problem) {
    throw CorpusError(path + ": " + problem.what());
  }
  if (!corpus.is_object() || !corpus.contains("cases") || !corpus.at("cases").is_array()) {
    throw CorpusError(path + ": must be an object with a list \"cases\"");
  }
  std::vector<Case> cases;
  std::set<std::string> names;
  for (const Json& source : corpus.at("cases")) {
    try {
      cases.emplace_back(source);
    } catch (const CorpusError& problem) {
      throw CorpusError(path + ": " + problem.what());
    }
    if (!names.insert(cases.back().name()).second) {
      throw CorpusError(path + ": two cases are called \"" + cases.back().name() + "\"");
    }
  }
  return cases;
}

std::string corpus_path(const std::string& chapter) {
  return std::string(CONTACT_SOURCE_DIR) + "/tests/" + chapter + "/hard_cases.json";
}

std::string hex(double x) {
  char text[48];
  std::snprintf(text, sizeof text, "%a", x);
  return text;
}
Json hex(const contact::Vector3<double>& v) {
  return Json::array({hex(v.x()), hex(v.y()), hex(v.z())});
}
std::string hex(const oracle::Rational& x) { return hex(oracle::nearest(x)); }

double unhex(const Json& number) { return std::strtod(number.get<std::string>().c_str(), nullptr); }
double unhex(const Json& answer, const char* field) { return unhex(answer.at(field)); }

bool close(double got, double right, double room) {
  return std::isfinite(got) && std::abs(got - right) <= room;
}

std::string answer_text(const Json& answer) {
  const std::function<std::string(const Json&)> show = [&show](const Json& value) -> std::string {
    if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
    if (value.is_null()) return "none";
    if (value.is_string()) {
      const std::string text = value.get<std::string>();
      if (text.find('x') == std::string::npos) return text;
      char decimal[48];  // a hexadecimal float: for the reader in decimal, as short as gives the
                         // same double
      const double number = std::strtod(text.c_str(), nullptr);
      *std::to_chars(decimal, decimal + sizeof decimal - 1, number).ptr = '\0';
      return decimal;
    }
    if (value.is_array()) {
      std::string list;
      for (const Json& entry : value) list += (list.empty() ? "" : ", ") + show(entry);
      return "(" + list + ")";
    }
    return value.dump();
  };
  std::string line;
  for (const auto& [key, value] : answer.items()) {
    if (key == "class") continue;
    if (!line.empty()) line += ", ";
    line += key + (value.is_boolean() || value.is_null() ? ": " : " = ") + show(value);
  }
  return line;
}

Runner::Runner(std::string chapter) : chapter_(std::move(chapter)) {}

Runner& Runner::question(const std::string& name, Recompute recompute) {
  questions_[name] = std::move(recompute);
  return *this;
}
Runner& Runner::method(const std::string& question, const std::string& name, IsRight is_right) {
  return method(
      question, name, [](const Case&) { return true; }, std::move(is_right));
}
Runner& Runner::method(const std::string& question, const std::string& name, Applies applies,
                       IsRight is_right) {
  methods_.push_back({question, name, std::move(applies), std::move(is_right)});
  return *this;
}

Json Runner::judge(const std::vector<Case>& cases, std::vector<std::string>& faults) const {
  std::vector<std::string> names;
  for (const Method& method : methods_) {
    if (std::find(names.begin(), names.end(), method.name) == names.end())
      names.push_back(method.name);
  }
  Json report{{"chapter", chapter_}, {"methods", names}, {"cases", Json::array()}};
  for (const Case& c : cases) {
    const auto recompute = questions_.find(c.question());
    if (recompute == questions_.end()) {
      faults.push_back(c.name() + ": nothing recomputes the question \"" + c.question() + "\"");
      continue;
    }
    const Json answer = recompute->second(c);
    // Compared without the order of the keys.
    if (nlohmann::json(answer) != nlohmann::json(c.answer())) {
      faults.push_back(c.name() + ": the stored answer is " + c.answer().dump() +
                       ", the oracle says " + answer.dump());
    }
    Json verdicts = Json::object();
    std::vector<std::string> wrong;
    for (const Method& method : methods_) {
      if (method.question != c.question() || !method.applies(c)) continue;
      bool right = false;
      try {
        right = method.is_right(c, answer);
      } catch (const CorpusError&) {
        throw;
      } catch (const std::exception&) {
        right = false;
      }
      verdicts[method.name] = right ? "right" : "wrong";
      if (!right) wrong.push_back(method.name);
    }
    if (verdicts.empty()) faults.push_back(c.name() + ": no method answers it");
    std::vector<std::string> meant = c.fails();
    for (const std::string& name : meant) {
      if (!verdicts.contains(name)) {
        faults.push_back(c.name() + ": \"" + name + "\" in fails is not a method for this case");
      } else if (std::find(wrong.begin(), wrong.end(), name) == wrong.end()) {
        faults.push_back(c.name() + ": \"" + name + "\" is meant to get it wrong and got it right");
      }
    }
    for (const std::string& name : wrong) {
      if (std::find(meant.begin(), meant.end(), name) == meant.end()) {
        faults.push_back(c.name() + ": \"" + name + "\" got it wrong");
      }
    }
    report["cases"].push_back({{"name", c.name()},
                               {"family", c.family()},
                               {"question", c.question()},
                               {"type", c.type()},
                               {"why", c.why()},
                               {"source", c.source()},
                               {"answer", answer},
                               {"answer_text", answer_text(answer)},
                               {"fails", wrong},
                               {"verdicts", verdicts}});
  }
  return report;
}

int Runner::run(int argc, char** argv) {
  const std::string option = argc > 1 ? argv[1] : "";
  const bool with_report = option == "--report" && argc == 3;
  if (argc > 1 && !with_report && !(argc == 2 && (option == "--json" || option == "--answers"))) {
    std::cerr << "usage: " << argv[0] << " [--json | --answers | --report FILE]\n";
    return 2;
  }
  try {
    const std::string path = corpus_path(chapter_);
    const std::vector<Case> cases = read(path);
    std::vector<std::string> faults;
    const Json report = judge(cases, faults);
    if (option == "--answers") {
      Json corpus = Json::parse(std::ifstream(path));
      for (Json& source : corpus["cases"]) {
        for (const Json& judged : report["cases"]) {
          if (judged["name"] != source["name"]) continue;
          source["answer"] = judged["answer"];
          source["fails"] = judged["fails"];
        }
      }
      std::cout << corpus.dump(1) << "\n";
      return 0;
    }
    for (const std::string& fault : faults) std::cerr << fault << "\n";
    if (option == "--json") {
      std::cout << report.dump(1) << "\n";
    } else {
      std::map<std::string, int> wrong;
      for (const Json& c : report["cases"]) {
        for (const auto& [name, verdict] : c["verdicts"].items()) {
          wrong[name] += verdict == "wrong" ? 1 : 0;
        }
      }
      std::cout << chapter_ << ": " << cases.size() << " hard cases, " << faults.size()
                << " faults\n";
      for (const Json& name : report["methods"]) {
        std::cout << "  " << name.get<std::string>() << ": wrong in "
                  << wrong[name.get<std::string>()] << "\n";
      }
    }
    if (with_report && faults.empty()) {
      std::ofstream file(argv[2]);
      file << report.dump(1) << "\n" << std::flush;
      if (!file) throw std::runtime_error(std::string("cannot write ") + argv[2]);
    }
    return faults.empty() ? 0 : 1;
  } catch (const std::exception& problem) {
    std::cerr << chapter_ << ": " << problem.what() << "\n";
    return 1;
  }
}

}  // namespace hard_cases
