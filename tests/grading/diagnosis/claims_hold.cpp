#include "claims_hold.hpp"

#include <algorithm>
#include <string_view>

#include <nlohmann/json.hpp>

#include "diagnosis/message_text.hpp"
#include "diagnosis/source_text.hpp"

namespace contact::testing {

namespace {

// 2000 bytes; one that is no UTF-8 is told as U+FFFD, which has three.
constexpr std::size_t max_sentence = 3 * 2000 + 4;
constexpr std::size_t max_excerpt = 4000;

bool is_continuation(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

class Judge {
 public:
  explicit Judge(const grading::ExplainRequest& asked) : asked_(asked), source_(asked.source) {}

  std::string judge(const grading::Explained& said) {
    if (asked_.failed != said.error.has_value() &&
        asked_.step == grading::ExplainRequest::Step::compile)
      complain("an error is reported if and only if the compilation failed");
    for (const grading::Remark& remark : said.remarks) {
      place(remark.line, remark.column, "a remark");
      place(remark.end_line, remark.end_column, "a remark's end");
      if (remark.column > 0 && remark.end_column > 0 &&
          std::pair(remark.end_line, remark.end_column) < std::pair(remark.line, remark.column))
        complain("a remark ends before it begins");
      if (remark.file != asked_.file) complain("a remark is about another file: " + remark.file);
      sentence(remark.words);
      if (!remark.mistake.empty() && (remark.words.empty() || remark.words.front() == ' '))
        complain("the words of " + remark.mistake + " lack what they are about");
      sentence(remark.message, false);
    }
    for (const std::string& warning : said.warnings) sentence(warning);
    if (said.error) {
      place(said.error->line, said.error->column, "the error");
      sentence(said.error->message, false);
      sentence(said.error->explanation);
      if (said.error->excerpt.size() > max_excerpt) complain("the excerpt is too long");
      if (said.error->file != asked_.file) complain("the error is about another file");
      if (said.error->contract.size() > 3) complain("more than three lines of the contract");
    }
    return wrong_;
  }

 private:
  void complain(const std::string& what) {
    if (wrong_.empty()) wrong_ = what;
  }

  void place(int line, int column, const std::string& whose) {
    if (line < 0 || line > source_.line_count() + 1)
      complain(whose + " has a line that is not there: " + std::to_string(line));
    const std::string_view text = source_.line(line);
    const auto characters =
        static_cast<int>(text.size() - static_cast<std::size_t>(std::count_if(
                                           text.begin(), text.end(), is_continuation)));
    if (column < 0 || column > characters + 2)
      complain(whose + " has a column that is not there: " + std::to_string(line) + ":" +
               std::to_string(column));
  }

  // A line that our own words name is one that is there.
  void sentence(const std::string& text, bool ours = true) {
    if (text.size() > max_sentence) complain("a sentence is too long");
    constexpr std::string_view word = " line ";
    for (std::size_t at = text.find(word); ours && at != std::string::npos;
         at = text.find(word, at + 1)) {
      const std::size_t begin = at + word.size();
      std::size_t end = begin;
      while (end < text.size() && text[end] >= '0' && text[end] <= '9') ++end;
      // The compiler's own words may quote the source.
      if (end == begin || end - begin > 9 ||
          asked_.log.find(text.substr(at, end - at)) != std::string::npos)
        continue;
      const int line = std::stoi(text.substr(begin, end - begin));
      if (line < 1 || line > source_.line_count() + 1)
        complain("the words name line " + std::to_string(line));
    }
  }

  const grading::ExplainRequest& asked_;
  const grading::SourceText source_;
  std::string wrong_;
};

}  // namespace

std::string what_is_wrong(const grading::ExplainRequest& asked, const std::string& told) {
  if (told.size() > grading::max_told_bytes)
    return "the answer has " + std::to_string(told.size()) + " bytes";
  return Judge(asked).judge(grading::explained_from_json(nlohmann::json::parse(told)));
}

}  // namespace contact::testing
