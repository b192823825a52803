#include "rules.hpp"

#include <array>
#include <utility>

#include "../message_text.hpp"

namespace contact::grading {

namespace {

std::string filled(std::string_view words, const Holes& holes) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::size_t hole = words[i] == '$' && i + 1 < words.size()
                                 ? static_cast<std::size_t>(words[i + 1] - '1')
                                 : holes.size();
    if (hole < holes.size()) {
      text += bare_type(holes[hole]);
      ++i;
    } else {
      text += words[i];
    }
  }
  return text;
}

std::optional<Mistake> recognise_message(const Said& said) {
  const std::string message =
      with_plain_quotes(without_aliases(with_vectors(said.diagnostic.message)));
  Holes holes;
  for (const std::span<const Rule> rules : all_rules()) {
    for (const Rule& rule : rules) {
      if (!matches(rule.pattern, message, holes)) continue;
      std::optional<Mistake> mistake =
          rule.tell != nullptr ? rule.tell(said, holes)
                               : Mistake{std::string(rule.mistake), filled(rule.words, holes)};
      // Words that begin with what a hole stands for lack it if the hole is empty, which no
      // compiler's message is.
      if (mistake && !mistake->words.starts_with(' ')) return mistake;
    }
  }
  return std::nullopt;
}

// Where the contract writes Eigen::Vector3d, so does the message.
void name_vectors(std::string& words, const ContractText& contract) {
  for (const std::string_view size : {"2", "3", "4"}) {
    const std::string name = "Vector" + std::string(size);
    if (!contains(words, name + "<double>") || !contract.mentions("Eigen::" + name + "d")) continue;
    replace_all(words, "Eigen::" + name + "<double>", name + "<double>");
    replace_all(words, name + "<double>", "Eigen::" + name + "d");
  }
}

}  // namespace

std::vector<std::span<const Rule>> all_rules() {
  return {rules_of_signs(), rules_of_what_is_missing(), rules_of_names(), rules_of_members(),
          rules_of_types(), rules_of_definitions(),     rules_of_eigen(), rules_of_warnings()};
}

bool any_note(const Said& said, std::string_view part) {
  return std::any_of(said.diagnostic.notes.begin(), said.diagnostic.notes.end(),
                     [&](const Diagnostic& note) { return contains(note.message, part); });
}

const Diagnostic* find_note(const Said& said, std::string_view pattern, Holes& holes) {
  for (const Diagnostic& note : said.diagnostic.notes) {
    if (matches(pattern, with_plain_quotes(without_aliases(note.message)), holes)) return &note;
  }
  return nullptr;
}

std::string with_vectors(std::string_view said) {
  std::string message = cut(said, max_message_bytes);
  constexpr std::string_view start = "cross_product_return_type<";
  for (std::size_t at = 0; (at = message.find(start, at)) != std::string::npos; ++at) {
    const std::size_t end = end_of_brackets(message, at + start.size() - 1);
    const std::size_t factor = message.find("Matrix<", at);
    constexpr std::string_view member = "::type";
    if (factor >= end || message.compare(end, member.size(), member) != 0) continue;
    const std::size_t open = factor + std::string_view("Matrix").size();
    const std::string vector =
        "Eigen::" + message.substr(factor, end_of_brackets(message, open) - factor);
    const std::size_t quote = message.find_last_of("'\x98", at);
    const std::size_t begin = quote == std::string::npos ? at : quote + 1;
    message.replace(begin, end + member.size() - begin, vector);
    at = begin;
  }
  return message;
}

std::optional<Mistake> recognise(const Said& said) {
  std::optional<Mistake> mistake = recognise_message(said);
  if (mistake) name_vectors(mistake->words, said.contract);
  return mistake;
}

bool derails(const std::string& mistake) {
  constexpr std::array<std::string_view, 8> derailing{
      "stray-character",   "unfinished-text",     "unfinished-comment", "semicolon-after-head",
      "missing-semicolon", "missing-parenthesis", "missing-brace",      "extra-brace"};
  return lists(derailing, mistake);
}

}  // namespace contact::grading
