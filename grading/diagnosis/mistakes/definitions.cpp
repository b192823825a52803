#include <array>
#include <filesystem>

#include "../message_text.hpp"
#include "rules.hpp"

namespace contact::grading {

namespace {

std::optional<Mistake> redefinition(const Said& said, const Holes& holes) {
  const std::string& what = holes[0];
  // "std::optional<...> exercise::ray_triangle(...)", "struct contact::Ray<S>", "double t" or "t".
  std::string name = contains(what, "(")   ? function_name(what)
                     : what.ends_with('>') ? short_name(bare_type(what))
                                           : what.substr(what.find_last_of(": ") + 1);
  if (name.empty()) return std::nullopt;
  for (const Diagnostic& note : said.diagnostic.notes) {
    if (!contains(note.message, "revious") && !contains(note.message, "declared here")) continue;
    if (const ContractText::Header* const header = said.contract.header(note.file))
      return Mistake{"redefinition",
                     name + " is defined already, in " +
                         std::filesystem::path(header->file).filename().string() +
                         ", which your file includes. Use that one and delete this."};
    if (note.own && note.line > 0)
      return Mistake{"redefinition",
                     name + " is declared twice: first in line " + std::to_string(note.line) + "."};
    break;
  }
  return Mistake{"redefinition", name + " is declared twice."};
}

std::optional<Mistake> without_its_number(const Said& said, const Holes& holes) {
  std::string name = holes.empty() ? std::string() : short_name(bare_type(holes[0]));
  if (name.empty()) name = std::string(said.source.word_before(said.place));
  if (name.empty()) return std::nullopt;
  return Mistake{
      "missing-template-argument",
      name + " needs to be told of which numbers it is made: write " + name + "<double>."};
}

constexpr std::array rules{
    Rule{"ambiguating new declaration of '{}'", "another-return-type",
         "The contract declares this function with another return type."},
    Rule{"functions that differ only in their return type cannot be overloaded",
         "another-return-type", "The contract declares this function with another return type."},
    Rule{"redefinition of '{}' {}", {}, {}, redefinition},
    Rule{"redefinition of '{}'", {}, {}, redefinition},
    Rule{"redeclaration of '{}'", {}, {}, redefinition},
    Rule{"conflicting declaration '{}'", {}, {}, redefinition},
    Rule{"declaration of '{}' shadows a parameter", {}, {}, redefinition},
    Rule{"template placeholder type '{}' must be followed by{}", {}, {}, without_its_number},
    Rule{"cannot form reference to deduced class template specialization type",
         {},
         {},
         without_its_number},
    Rule{"use of class template '{}' requires template arguments{}", {}, {}, without_its_number},
    Rule{"invalid use of template-name '{}' without an argument list", {}, {}, without_its_number},
};

}  // namespace

std::span<const Rule> rules_of_definitions() { return rules; }

}  // namespace contact::grading
