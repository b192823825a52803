#pragma once

// A chapter's questions for the command line, read from its questions.toml.

#include <string>
#include <vector>

#include "book.hpp"

namespace contact::grading {

enum class QuestionKind { predict, choose, order, construct, complete, say_why };

/// As in questions.toml: "say-why".
std::string_view key(QuestionKind kind);

/// A wrong answer that can be recognised, and what to say to it.
struct KnownMistake {
  double answer = 0.0;
  std::string why;
};

/// A number that is asked for.
struct NumberKey {
  double answer = 0.0;
  std::string unit;
  double tolerance = 0.0;
  /// False: it must be given in this very unit.
  bool convert = true;
  std::vector<KnownMistake> wrong;
};

struct QuestionGap {
  std::string id;
  std::string label;
  NumberKey number;
};

/// Texts are Markdown with formulas. Which members are filled depends on the kind.
struct Question {
  std::string chapter;
  std::string id;
  QuestionKind kind = QuestionKind::predict;
  std::string objective;
  std::string text;
  /// The explanation; of a question to say why, the model answer.
  std::string explain;
  NumberKey number;                   ///< predict
  std::vector<std::string> choices;   ///< choose, order
  std::size_t right_choice = 0;       ///< choose
  std::vector<std::size_t> sequence;  ///< order: indices of the choices
  std::vector<KnownMistake> wrong;    ///< choose
  /// Complete: the steps of a derivation, or the rows of a table with its heads first. A gap is
  /// {{id}}.
  std::vector<std::string> lines;
  std::vector<std::vector<std::string>> table;
  std::vector<QuestionGap> gaps;      ///< complete, in the order in which they stand
  std::vector<std::string> criteria;  ///< say why
  std::string figure;                 ///< construct: NN_slug/NAME

  [[nodiscard]] std::string name() const { return chapter + "/" + id; }
};

/// In the order of the file; none for a chapter without questions.
/// @throws BookError naming file and line.
std::vector<Question> read_questions(const Chapter& chapter);

}  // namespace contact::grading
