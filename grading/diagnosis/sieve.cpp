#include "sieve.hpp"

#include <algorithm>
#include <string_view>
#include <tuple>
#include <utility>

#include "message_text.hpp"
#include "mistakes/mistake.hpp"

namespace contact::grading {

namespace {

bool names_word(std::string_view code, std::string_view word) {
  for (std::size_t at = code.find(word); at != std::string_view::npos;
       at = code.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    if ((at == 0 || !is_identifier_character(code[at - 1])) &&
        (end == code.size() || !is_identifier_character(code[end])))
      return true;
  }
  return false;
}

class Sieve {
 public:
  Sieve(const std::vector<FoundMessage>& all, const SourceText& source) : source_(source) {
    for (const FoundMessage& found : all) {
      fails_ = fails_ || found.is_error();
      misread_ =
          misread_ || derails(found.remark.mistake) || found.remark.mistake == "capital-letter";
      in_comment_ = in_comment_ || found.remark.mistake == "unfinished-comment";
    }
  }

  bool keep(const FoundMessage& found) {
    if (follows(found)) return false;
    if (derails(found.remark.mistake)) derailed_ = found.remark.line;
    kept_.push_back(&found);
    return true;
  }

 private:
  [[nodiscard]] bool follows(const FoundMessage& found) const {
    const Remark& remark = found.remark;
    if (fails_ && (remark.mistake == "unused" || remark.mistake == "no-effect")) return true;
    if (remark.message.find("<expression error>") != std::string::npos) return true;
    if (in_comment_ && remark.mistake == "missing-brace") return true;
    if (misread_ && (remark.mistake == "missing-return" || remark.mistake == "uninitialised"))
      return true;
    if (derailed_ > 0 && !(derails(remark.mistake) && remark.line > derailed_ + 2)) return true;
    return std::any_of(kept_.begin(), kept_.end(), [&](const FoundMessage* earlier) {
      const Remark& first = earlier->remark;
      if (first.mistake == "missing-brace" && remark.mistake == "missing-brace") return true;
      if (first.mistake == remark.mistake && first.words == remark.words && first.line != 0 &&
          (remark.mistake == "name-in-comment" || remark.mistake == "contract-not-included"))
        return true;
      if (first.line == remark.line)
        return remark.mistake.empty() || first.mistake == remark.mistake || !found.is_error();
      // A name that an earlier broken line declares is unknown because of that line.
      return remark.mistake == "unknown-name" && earlier->is_error() &&
             names_word(source_.code(first.line), source_.word_at(found.place));
    });
  }

  const SourceText& source_;
  bool fails_ = false;
  bool misread_ = false;
  bool in_comment_ = false;
  int derailed_ = 0;
  std::vector<const FoundMessage*> kept_;
};

}  // namespace

std::vector<FoundMessage> sifted(std::vector<FoundMessage> all, const SourceText& source) {
  const bool fails = std::any_of(all.begin(), all.end(),
                                 [](const FoundMessage& found) { return found.is_error(); });
  for (FoundMessage& found : all) {
    // A compiler warns of it and then fails by what it makes of the rest of the line.
    if (fails && found.remark.mistake == "unfinished-text") found.remark.severity = "error";
  }
  std::stable_sort(all.begin(), all.end(), [](const FoundMessage& a, const FoundMessage& b) {
    const auto rank = [](const FoundMessage& found) {
      // What has no line that is known comes last.
      return std::tuple(found.remark.line == 0, found.remark.line, !found.is_error(),
                        found.remark.mistake.empty(), found.remark.column);
    };
    return rank(a) < rank(b);
  });
  Sieve sieve(all, source);
  std::vector<FoundMessage> kept;
  kept.reserve(all.size());
  for (FoundMessage& found : all) {
    if (sieve.keep(found)) kept.push_back(found);
  }
  return kept;
}

}  // namespace contact::grading
