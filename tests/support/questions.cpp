#include "support/questions.hpp"

#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <set>

namespace questions {
namespace {

std::map<std::string, std::vector<std::function<Key()>>>& keys() {
  static std::map<std::string, std::vector<std::function<Key()>>> registered;
  return registered;
}

std::string chapter_file(const std::string& chapter, const std::string& file) {
  return CONTACT_SOURCE_DIR "/chapters/" + chapter + "/" + file;
}

std::vector<int> whole_numbers(const toml::table& question, const char* field) {
  std::vector<int> numbers;
  if (const toml::array* array = question[field].as_array()) {
    for (const toml::node& node : *array) {
      numbers.push_back(static_cast<int>(node.value<std::int64_t>().value_or(-1)));
    }
  }
  return numbers;
}

/// The faults of one question; `key` computes what its answer should be.
class Check {
 public:
  Check(const std::string& chapter, const toml::table& question,
        const std::set<std::string>& objectives, std::vector<std::string>& faults)
      : chapter_(chapter), question_(question), faults_(faults) {
    id_ = question["id"].value_or(std::string());
    if (id_.empty()) fault("a question has no id");
    for (const char* field : {"text", "explain", "objective"}) {
      if (question[field].value_or(std::string()).empty()) fault(std::string(field) + " is empty");
    }
    if (objectives.count(question["objective"].value_or(std::string())) == 0) {
      fault("its objective is not in chapter.toml");
    }
    kind_ = question["kind"].value_or(std::string());
  }

  const std::string& id() const { return id_; }

  void compare(const Key& key) {
    if (kind_ == "predict") return predict(key);
    if (kind_ == "choose") return choose(key);
    if (kind_ == "order") return order(key);
    if (kind_ == "construct") return construct(key);
    fault("kind must be predict, choose, order or construct");
  }

  void fault(const std::string& problem) {
    faults_.push_back(chapter_ + "/" + id_ + ": " + problem);
  }

 private:
  void predict(const Key& key) {
    if (!std::holds_alternative<double>(key)) return fault("its key must be a double");
    const auto answer = question_["answer"].value<double>();
    const double tolerance = question_["tolerance"].value_or(0.0);
    if (!answer || !std::isfinite(*answer)) return fault("answer must be a number");
    if (!(tolerance > 0)) fault("tolerance must be greater than 0");
    if (!question_["unit"].value<std::string>())
      fault("unit is missing (an empty text if it has none)");
    const double computed = std::get<double>(key);
    // The stored key may be rounded, but not so far that it uses up the reader's tolerance.
    if (!(std::abs(*answer - computed) <= tolerance / 10)) {
      fault("the answer is " + std::to_string(*answer) + ", the code computes " +
            std::to_string(computed));
    }
    for (const toml::table* wrong : wrongs()) {
      const auto value = (*wrong)["answer"].value<double>();
      if (!value || !(std::abs(*value - computed) > 2 * tolerance)) {
        fault("a wrong answer is missing or too near the right one");
      }
    }
  }

  void choose(const Key& key) {
    if (!std::holds_alternative<int>(key)) return fault("its key must be an int");
    const toml::array* options = question_["options"].as_array();
    const auto answer = question_["answer"].value<std::int64_t>();
    if (options == nullptr || options->size() < 2) return fault("it needs at least two options");
    if (!answer || *answer < 0 || *answer >= static_cast<std::int64_t>(options->size())) {
      return fault("answer must be the index of an option");
    }
    if (*answer != std::get<int>(key)) {
      fault("the answer is option " + std::to_string(*answer) + ", the code computes " +
            std::to_string(std::get<int>(key)));
    }
    for (const toml::table* wrong : wrongs()) {
      const std::int64_t value = (*wrong)["answer"].value_or(std::int64_t{-1});
      if (value < 0 || value >= static_cast<std::int64_t>(options->size()) || value == *answer) {
        fault("a wrong answer must be the index of another option");
      }
    }
  }

  void order(const Key& key) {
    if (!std::holds_alternative<std::vector<int>>(key))
      return fault("its key must be a vector<int>");
    const toml::array* items = question_["items"].as_array();
    const std::vector<int> answer = whole_numbers(question_, "answer");
    if (items == nullptr || items->size() < 3) return fault("it needs at least three items");
    std::vector<int> sorted = answer;
    std::sort(sorted.begin(), sorted.end());
    std::vector<int> all(items->size());
    std::iota(all.begin(), all.end(), 0);
    if (sorted != all) return fault("answer must hold every index once");
    if (answer == all) fault("the items are shown in the right order already");
    if (answer != std::get<std::vector<int>>(key)) fault("the code computes another order");
  }

  void construct(const Key& key) {
    if (!std::holds_alternative<Construct>(key))
      return fault("its key must be a questions::Construct");
    const std::string figure = question_["figure"].value_or(std::string());
    const std::string goal = question_["goal"].value_or(std::string());
    if (figure.rfind(chapter_ + "/", 0) != 0)
      fault("figure must be one of this chapter, \"" + chapter_ + "/name\"");
    if (goal.empty()) fault("goal is missing");
    const Construct states = std::get<Construct>(key);
    if (!(states.winning >= 1)) fault("the winning state does not reach the goal");
    if (!(states.losing < 1)) fault("the losing state reaches the goal");
  }

  std::vector<const toml::table*> wrongs() {
    std::vector<const toml::table*> all;
    if (const toml::array* array = question_["wrong"].as_array()) {
      for (const toml::node& node : *array) {
        const toml::table* table = node.as_table();
        if (table == nullptr || (*table)["why"].value_or(std::string()).empty()) {
          fault("every entry of wrong has an answer and a why");
        } else {
          all.push_back(table);
        }
      }
    }
    return all;
  }

  std::string chapter_, id_, kind_;
  const toml::table& question_;
  std::vector<std::string>& faults_;
};

}  // namespace

Register::Register(const char* id, std::function<Key()> key) {
  keys()[id].push_back(std::move(key));
}

std::vector<std::string> faults(const std::string& chapter) {
  std::vector<std::string> faults;
  try {
    const toml::table file = toml::parse_file(chapter_file(chapter, "questions.toml"));
    const toml::table about = toml::parse_file(chapter_file(chapter, "chapter.toml"));
    std::set<std::string> objectives;
    if (const toml::array* array = about["objectives"].as_array()) {
      for (const toml::node& node : *array) {
        if (const toml::table* table = node.as_table())
          objectives.insert((*table)["id"].value_or(std::string()));
      }
    }
    std::set<std::string> asked;
    if (const toml::array* array = file["question"].as_array()) {
      for (const toml::node& node : *array) {
        const toml::table* question = node.as_table();
        if (question == nullptr) continue;
        Check check(chapter, *question, objectives, faults);
        if (!asked.insert(check.id()).second) check.fault("two questions have this id");
        const auto key = keys().find(check.id());
        if (key == keys().end()) {
          check.fault("no KEY recomputes its answer");
        } else {
          if (key->second.size() > 1) check.fault("it has more than one KEY");
          check.compare(key->second.front()());
        }
      }
    }
    for (const auto& [id, functions] : keys()) {
      if (asked.count(id) == 0) faults.push_back(chapter + "/" + id + ": a KEY without a question");
    }
  } catch (const toml::parse_error& problem) {
    faults.push_back(chapter + ": " + std::string(problem.description()) + " in line " +
                     std::to_string(problem.source().begin.line));
  }
  return faults;
}

int count(const std::string& chapter) {
  const toml::table file = toml::parse_file(chapter_file(chapter, "questions.toml"));
  const toml::array* array = file["question"].as_array();
  return array == nullptr ? 0 : static_cast<int>(array->size());
}

}  // namespace questions
