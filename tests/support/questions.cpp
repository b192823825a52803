#include "support/questions.hpp"

#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <map>
#include <numeric>
#include <regex>
#include <set>
#include <stdexcept>

namespace questions {
namespace {

Keys& keys() {
  static Keys registered;
  return registered;
}

std::string read(const std::string& file) {
  std::ifstream stream(file);
  if (!stream) throw std::runtime_error("cannot read " + file);
  return {std::istreambuf_iterator<char>(stream), {}};
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
    kind_ = question["kind"].value_or(std::string());
    // A model answer is the explanation of a question to say why.
    const char* explain = kind_ == "say-why" ? "model" : "explain";
    for (const char* field : {"text", explain, "objective"}) {
      if (question[field].value_or(std::string()).empty()) fault(std::string(field) + " is empty");
    }
    if (objectives.count(question["objective"].value_or(std::string())) == 0) {
      fault("its objective is not in chapter.toml");
    }
  }

  const std::string& id() const { return id_; }

  void compare(const Key& key) {
    if (kind_ == "predict") return predict(key);
    if (kind_ == "choose") return choose(key);
    if (kind_ == "order") return order(key);
    if (kind_ == "construct") return construct(key);
    if (kind_ == "complete") return complete(key);
    if (kind_ == "say-why") return say_why(key);
    fault("kind must be predict, choose, order, construct, complete or say-why");
  }

  void fault(const std::string& problem) {
    faults_.push_back(chapter_ + "/" + id_ + ": " + problem);
  }

 private:
  void predict(const Key& key) {
    if (!std::holds_alternative<double>(key)) return fault("its key must be a double");
    if (!question_["unit"].value<std::string>())
      fault("unit is missing (an empty text if it has none)");
    number(question_, std::get<double>(key), "");
  }

  // A number of the file against the computed one; `which` begins each sentence.
  void number(const toml::table& table, double computed, const std::string& which) {
    const auto answer = table["answer"].value<double>();
    const double tolerance = table["tolerance"].value_or(0.0);
    if (!answer || !std::isfinite(*answer)) return fault(which + "answer must be a number");
    if (!(tolerance > 0)) fault(which + "tolerance must be greater than 0");
    // The stored key may be rounded, but not so far that it uses up the reader's tolerance.
    if (!(std::abs(*answer - computed) <= tolerance / 10)) {
      fault(which + "the answer is " + std::to_string(*answer) + ", the code computes " +
            std::to_string(computed));
    }
    for (const toml::table* wrong : wrongs(table)) {
      const auto value = (*wrong)["answer"].value<double>();
      if (!value || !(std::abs(*value - computed) > 2 * tolerance)) {
        fault(which + "a wrong answer is missing or too near the right one");
      }
    }
  }

  void complete(const Key& key) {
    if (!std::holds_alternative<Gaps>(key)) return fault("its key must be questions::Gaps");
    const Gaps& computed = std::get<Gaps>(key);
    const std::string texts = texts_to_complete();
    std::set<std::string> named;
    const toml::array* gaps = question_["gaps"].as_array();
    if (gaps == nullptr || gaps->empty()) return fault("it has no [[question.gaps]]");
    for (const toml::node& node : *gaps) {
      const toml::table* gap = node.as_table();
      if (gap == nullptr) return fault("gaps must be tables");
      const std::string id = (*gap)["id"].value_or(std::string());
      if (!named.insert(id).second) fault("two gaps are called '" + id + "'");
      if ((*gap)["label"].value_or(std::string()).empty()) fault("gap " + id + ": label is empty");
      const std::string mark = "{{" + id + "}}";
      const std::size_t first = texts.find(mark);
      if (first == std::string::npos || texts.find(mark, first + 1) != std::string::npos)
        fault("gap " + id + ": " + mark + " must stand once in lines or table");
      const auto value = computed.find(id);
      if (value == computed.end())
        fault("gap " + id + ": its key does not compute it");
      else
        number(*gap, value->second, "gap " + id + ": ");
    }
    for (const auto& [id, value] : computed) {
      if (named.count(id) == 0) fault("its key computes '" + id + "', which is no gap");
    }
    static const std::regex mark(R"(\{\{([^{}]*)\}\})");
    for (std::sregex_iterator it(texts.begin(), texts.end(), mark), end; it != end; ++it) {
      if (named.count((*it)[1]) == 0) fault("no gap is called '" + (*it)[1].str() + "'");
    }
  }

  // The steps or the cells, one a line.
  std::string texts_to_complete() {
    const toml::array* lines = question_["lines"].as_array();
    const toml::array* table = question_["table"].as_array();
    if ((lines == nullptr) == (table == nullptr)) fault("it has either lines or a table");
    std::string texts;
    if (lines != nullptr) {
      for (const toml::node& line : *lines) texts += line.value_or(std::string()) + "\n";
    }
    if (table != nullptr) {
      for (const toml::node& row : *table) {
        if (row.as_array() == nullptr) continue;
        for (const toml::node& cell : *row.as_array()) texts += cell.value_or(std::string()) + "\n";
      }
    }
    return texts;
  }

  void say_why(const Key& key) {
    if (!std::holds_alternative<Claim>(key)) return fault("its key must be a questions::Claim");
    const toml::array* criteria = question_["criteria"].as_array();
    if (criteria == nullptr || criteria->size() != 3) return fault("it needs three criteria");
    for (const toml::node& criterion : *criteria) {
      if (criterion.value_or(std::string()).empty()) fault("a criterion is empty");
    }
    const Claim claim = std::get<Claim>(key);
    if (!claim.with_reason) fault("what the model answer claims does not hold");
    if (claim.without_reason) fault("what the model answer claims holds without its reason too");
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
    for (const toml::table* wrong : wrongs(question_)) {
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

  std::vector<const toml::table*> wrongs(const toml::table& of) {
    std::vector<const toml::table*> all;
    if (const toml::array* array = of["wrong"].as_array()) {
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
  return faults(chapter, read(chapter_file(chapter, "questions.toml")),
                read(chapter_file(chapter, "chapter.toml")), keys());
}

std::vector<std::string> faults(const std::string& chapter, std::string_view questions,
                                std::string_view about, const Keys& keys) {
  std::vector<std::string> faults;
  try {
    const toml::table file = toml::parse(questions);
    const toml::table chapter_file = toml::parse(about);
    std::set<std::string> objectives;
    if (const toml::array* array = chapter_file["objectives"].as_array()) {
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
        const auto key = keys.find(check.id());
        if (key == keys.end()) {
          check.fault("no KEY recomputes its answer");
        } else {
          if (key->second.size() > 1) check.fault("it has more than one KEY");
          check.compare(key->second.front()());
        }
      }
    }
    for (const auto& [id, functions] : keys) {
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

std::vector<int> only_order(const std::vector<Step>& steps) {
  std::set<std::string> made;
  std::vector<int> order;
  while (order.size() < steps.size()) {
    int next = -1;
    for (std::size_t i = 0; i < steps.size(); ++i) {
      if (made.count(steps[i].makes) != 0) continue;
      bool ready = true;
      for (const std::string& need : steps[i].needs) ready = ready && made.count(need) != 0;
      if (!ready) continue;
      CHECK(next == -1);
      next = static_cast<int>(i);
    }
    if (next < 0) break;
    made.insert(steps[static_cast<std::size_t>(next)].makes);
    order.push_back(next);
  }
  return order;
}

}  // namespace questions
