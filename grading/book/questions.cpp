#include "questions.hpp"

#include <algorithm>
#include <array>
#include <set>

#include <toml++/toml.h>

namespace fs = std::filesystem;

namespace contact::grading {

namespace {

constexpr std::array<std::string_view, 6> kinds{"predict",   "choose",   "order",
                                                "construct", "complete", "say-why"};

// One question's table, and how to name it in a complaint.
class QuestionReader {
 public:
  QuestionReader(const fs::path& file, const toml::table& table) : file_(file), table_(table) {}

  [[noreturn]] void fail(const std::string& what) const {
    const std::string id = table_["id"].value_or(std::string());
    throw BookError(file_.string() + ":" + std::to_string(table_.source().begin.line) + ": " +
                    (id.empty() ? "" : "question " + id + ": ") + what);
  }

  [[nodiscard]] std::string text(const char* name) const {
    const auto value = table_[name].value<std::string>();
    if (!value || value->empty()) fail(std::string(name) + " is missing");
    return *value;
  }

  [[nodiscard]] std::vector<std::string> texts(const char* name) const {
    return texts(table_[name].as_array());
  }

  [[nodiscard]] std::vector<std::string> texts(const toml::array* list) const {
    std::vector<std::string> result;
    if (list == nullptr) return result;
    for (const toml::node& node : *list) result.push_back(node.value_or(std::string()));
    return result;
  }

  [[nodiscard]] std::vector<KnownMistake> mistakes(const toml::table& of) const {
    std::vector<KnownMistake> result;
    for (const toml::table* entry : tables(of, "wrong")) {
      // What is not a number, such as "unit", is for the page's own words.
      if (const auto answer = (*entry)["answer"].value<double>())
        result.push_back({*answer, (*entry)["why"].value_or(std::string())});
    }
    return result;
  }

  [[nodiscard]] NumberKey number(const toml::table& of) const {
    const auto answer = of["answer"].value<double>();
    const auto tolerance = of["tolerance"].value<double>();
    if (!answer || !tolerance) fail("a number needs answer and tolerance");
    return {*answer, of["unit"].value_or(std::string()), *tolerance, of["convert"].value_or(true),
            mistakes(of)};
  }

  [[nodiscard]] std::vector<const toml::table*> tables(const toml::table& of,
                                                       const char* name) const {
    std::vector<const toml::table*> result;
    const toml::array* list = of[name].as_array();
    if (list == nullptr) return result;
    for (const toml::node& node : *list) {
      if (node.as_table() == nullptr) fail(std::string(name) + " must hold tables");
      result.push_back(node.as_table());
    }
    return result;
  }

  [[nodiscard]] std::size_t index(const toml::node& node, std::size_t count) const {
    const std::int64_t value = node.value_or(std::int64_t{-1});
    if (value < 0 || value >= static_cast<std::int64_t>(count))
      fail("answer has an index that nothing has");
    return static_cast<std::size_t>(value);
  }

  [[nodiscard]] const toml::table& table() const { return table_; }

 private:
  const fs::path& file_;
  const toml::table& table_;
};

void read_gaps(const QuestionReader& reader, Question& question) {
  question.lines = reader.texts("lines");
  std::string texts;
  for (const std::string& line : question.lines) texts += line + "\n";
  if (const toml::array* rows = reader.table()["table"].as_array()) {
    for (const toml::node& row : *rows) {
      question.table.push_back(reader.texts(row.as_array()));
      for (const std::string& cell : question.table.back()) texts += cell + "\n";
    }
  }
  for (const toml::table* gap : reader.tables(reader.table(), "gaps")) {
    question.gaps.push_back({(*gap)["id"].value_or(std::string()),
                             (*gap)["label"].value_or(std::string()), reader.number(*gap)});
  }
  if (question.gaps.empty()) reader.fail("it has no gaps");
  const auto position = [&](const QuestionGap& gap) { return texts.find("{{" + gap.id + "}}"); };
  for (const QuestionGap& gap : question.gaps) {
    if (gap.label.empty()) reader.fail("the gap '" + gap.id + "' has no label");
    if (position(gap) == std::string::npos)
      reader.fail("the gap '" + gap.id + "' stands nowhere in lines or table");
  }
  std::stable_sort(
      question.gaps.begin(), question.gaps.end(),
      [&](const QuestionGap& a, const QuestionGap& b) { return position(a) < position(b); });
}

Question read_question(const Chapter& chapter, const QuestionReader& reader) {
  Question question;
  question.chapter = chapter.slug;
  question.id = reader.text("id");
  const std::string kind = reader.text("kind");
  const auto known = std::find(kinds.begin(), kinds.end(), kind);
  if (known == kinds.end()) reader.fail("there is no kind '" + kind + "'");
  question.kind = static_cast<QuestionKind>(known - kinds.begin());
  question.objective = reader.text("objective");
  question.text = reader.text("text");
  question.explain = reader.text(question.kind == QuestionKind::say_why ? "model" : "explain");
  switch (question.kind) {
    case QuestionKind::predict:
      question.number = reader.number(reader.table());
      break;
    case QuestionKind::choose:
      question.choices = reader.texts("options");
      if (!reader.table().contains("answer")) reader.fail("answer is missing");
      question.right_choice = reader.index(*reader.table().get("answer"), question.choices.size());
      question.wrong = reader.mistakes(reader.table());
      break;
    case QuestionKind::order: {
      question.choices = reader.texts("items");
      const toml::array* answer = reader.table()["answer"].as_array();
      if (answer == nullptr || answer->size() != question.choices.size())
        reader.fail("answer must hold every index once");
      for (const toml::node& node : *answer)
        question.sequence.push_back(reader.index(node, question.choices.size()));
      break;
    }
    case QuestionKind::construct:
      question.figure = reader.text("figure");
      break;
    case QuestionKind::complete:
      read_gaps(reader, question);
      break;
    case QuestionKind::say_why:
      question.criteria = reader.texts("criteria");
      if (question.criteria.size() != 3) reader.fail("a model answer has three criteria");
      break;
  }
  return question;
}

}  // namespace

std::string_view key(QuestionKind kind) { return kinds.at(static_cast<std::size_t>(kind)); }

std::vector<Question> read_questions(const Chapter& chapter) {
  std::vector<Question> questions;
  const fs::path file = chapter.folder / "questions.toml";
  if (!fs::exists(file)) return questions;
  try {
    const toml::table table = toml::parse(read_text(file), file.string());
    const toml::array* list = table["question"].as_array();
    if (list == nullptr) return questions;
    std::set<std::string> ids;
    for (const toml::node& node : *list) {
      if (node.as_table() == nullptr) throw BookError(file.string() + ": [[question]] is a table");
      const QuestionReader reader(file, *node.as_table());
      questions.push_back(read_question(chapter, reader));
      if (!ids.insert(questions.back().id).second) reader.fail("the id is used twice");
    }
  } catch (const toml::parse_error& error) {
    throw BookError(file.string() + ":" + std::to_string(error.source().begin.line) + ": " +
                    std::string(error.description()));
  }
  return questions;
}

}  // namespace contact::grading
