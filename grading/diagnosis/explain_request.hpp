#pragma once

// What contact-explain is asked: a compile or a link, the file, and the headers, all as text. It
// comes as bytes on standard input, because the box in which it runs shows it no file.

#include <string>
#include <string_view>
#include <vector>

#include "contract_text.hpp"
#include "explained.hpp"

namespace contact::grading {

struct ExplainRequest {
  enum class Step { compile, link };
  Step step = Step::compile;
  bool failed = true;
  Columns columns = Columns::displayed;
  std::string file;
  std::string source;
  std::string log;
  /// The contract first.
  std::vector<HeaderText> headers;
  /// The book's folder; explanations name its files relative to it.
  std::string root;
};

/// Texts for students name files relative to this folder, which ends with a slash, not by their
/// paths on this machine. Nothing is done if it is empty.
void shorten(Explained& said, const std::string& root);

/// Fields, each with its length before it.
std::string to_bytes(const ExplainRequest& request);
/// @throws std::invalid_argument if the bytes are not what to_bytes() makes
ExplainRequest request_from(std::string_view bytes);

/// The answer, as the reply's JSON.
std::string explain(ExplainRequest request);

}  // namespace contact::grading
