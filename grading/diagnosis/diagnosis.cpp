#include "diagnosis.hpp"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <utility>

#include "claims.hpp"
#include "message_text.hpp"
#include "mistakes/mistake.hpp"
#include "sieve.hpp"

namespace fs = std::filesystem;

namespace contact::grading {

namespace {

constexpr std::size_t max_shown_bytes = 2000;     // of a message or a sentence
constexpr std::size_t max_remarks_bytes = 80000;  // of all remarks
constexpr std::size_t max_warnings = 40;
constexpr std::size_t max_warning_bytes = 600;
constexpr std::size_t max_excerpt_bytes = 240;
constexpr std::size_t max_quoted_names = 60;
constexpr std::size_t max_contract_bytes = 4000;

std::string shown(std::string_view text) { return cut(text, max_shown_bytes); }

std::string readable_message(const Diagnostic& diagnostic) {
  return shown(readable(with_vectors(diagnostic.message)));
}

// ---- Where a message belongs ------------------------------------------------------------------

struct Located {
  Place place;
  bool in_library = false;
};

// If it is raised in a header, the position of the last step that leads there.
std::optional<Located> locate(const Diagnostic& diagnostic) {
  if (diagnostic.own) return Located{{diagnostic.line, diagnostic.column}, false};
  for (const Step& step : diagnostic.required_from) {
    if (step.own) return Located{{step.line, step.column}, true};
  }
  return std::nullopt;
}

// One past the end of what a message is about.
Place end_of(const Diagnostic& diagnostic, Place place, bool moved, const SourceText& source) {
  if (place.column == 0) return place;
  if (!moved && diagnostic.end_line > 0) return {diagnostic.end_line, diagnostic.end_column};
  const auto length = std::max<std::size_t>(source.word_at(place).size(), 1);
  return {place.line, place.column + static_cast<int>(length)};
}

// The line of a position with a caret below it; of a long line, the part around the position.
std::string excerpt_at(const SourceText& source, Place place) {
  if (place.line == 0) return {};
  std::string_view line = source.line(place.line);
  const auto at = std::min(static_cast<std::size_t>(std::max(place.column - 1, 0)), line.size());
  std::size_t begin = line.size() <= max_excerpt_bytes || at < max_excerpt_bytes / 2
                          ? 0
                          : at - max_excerpt_bytes / 2;
  const auto is_continuation = [&](std::size_t i) {
    return i < line.size() && (static_cast<unsigned char>(line[i]) & 0xC0) == 0x80;
  };
  while (is_continuation(begin)) ++begin;
  const std::string before = begin > 0 ? "... " : "";
  const std::string number = std::to_string(place.line);
  std::string excerpt = "  " + number + " | " + before + cut(line.substr(begin), max_excerpt_bytes);
  if (place.column == 0) return excerpt;
  const int blanks = source.character_column(place) -
                     source.character_column({place.line, static_cast<int>(begin) + 1});
  return excerpt + "\n  " + std::string(number.size(), ' ') + " | " +
         std::string(before.size() + static_cast<std::size_t>(std::max(blanks, 0)), ' ') + "^";
}

// ---- What is told of one message --------------------------------------------------------------

std::string plain_words(const Diagnostic& diagnostic) {
  if (const std::string said = eigen_sentence(diagnostic.message); !said.empty())
    return shown("These types do not go together. Eigen says: " + said + ".");
  return readable_message(diagnostic);
}

FoundMessage understood(const Diagnostic& diagnostic, Located located, const Diagnosis& of) {
  const SourceText& source = of.source();
  FoundMessage found{&diagnostic, located.place, located.in_library, {}};
  Remark& remark = found.remark;
  remark.file = of.file();
  remark.severity = diagnostic.is_error() ? "error" : "warning";
  remark.message = shown(diagnostic.message);
  const std::optional<Mistake> mistake =
      recognise({diagnostic, located.place, source, of.contract()});
  remark.words = mistake ? shown(mistake->words) : plain_words(diagnostic);
  if (mistake) remark.mistake = mistake->id;
  const bool moved = located.in_library || (mistake && mistake->place);
  if (mistake && mistake->place) found.place = *mistake->place;
  const Place end = end_of(diagnostic, found.place, moved, source);
  remark.line = found.place.line;
  remark.column = source.character_column(found.place);
  remark.end_line = end.line;
  remark.end_column = source.character_column(end);
  return found;
}

std::string library_of(const std::string& header) {
  if (header.find("/Eigen/") != std::string::npos) return "Eigen";
  if (header.find("/c++/") != std::string::npos) return "the standard library";
  return shown(fs::path(header).filename().string());
}

void add_contract(CompileError& error, ContractLine line) {
  const bool known =
      std::any_of(error.contract.begin(), error.contract.end(), [&](const ContractLine& other) {
        return other.file == line.file && other.line == line.line;
      });
  if (known || error.contract.size() >= 3) return;
  line.text = cut(line.text, max_contract_bytes);
  error.contract.push_back(std::move(line));
}

// The contract's lines beside the error: those that the compiler's notes point at, else those that
// declare what the message names.
void find_contract(CompileError& error, const Diagnostic& diagnostic,
                   const ContractText& contract) {
  for (const Diagnostic& note : diagnostic.notes) {
    if (!note.own && note.line > 0 && same_file(note.file, contract.contract().file))
      add_contract(error, contract.declaration_at(note.line));
  }
  if (!error.contract.empty()) return;
  std::vector<std::string> names = quoted_names(without_aliases(diagnostic.message));
  std::erase_if(names, [](const std::string& name) {
    return name == "exercise" || name == "contact" || name.size() > max_name_bytes;
  });
  names.resize(std::min(names.size(), max_quoted_names));
  for (const std::string& name : names) {
    if (std::optional<ContractLine> line = contract.declared_by_contract(name))
      add_contract(error, std::move(*line));
  }
  if (!error.contract.empty()) return;
  for (const std::string& name : names) {
    if (std::optional<ContractLine> line = contract.declaration_of(name))
      add_contract(error, std::move(*line));
  }
}

CompileError told(const FoundMessage& found, const Diagnosis& of) {
  const Diagnostic& diagnostic = *found.diagnostic;
  CompileError error;
  error.file = found.remark.file;
  error.line = found.remark.line;
  error.column = found.remark.column;
  error.message = readable_message(diagnostic);
  const bool there = !found.in_library && found.place.line == diagnostic.line;
  error.excerpt = there && !diagnostic.excerpt.empty() ? diagnostic.excerpt
                                                       : excerpt_at(of.source(), found.place);
  if (!found.remark.mistake.empty())
    error.explanation = found.remark.words;
  else if (found.in_library)
    error.explanation = "The error is raised inside " + library_of(diagnostic.file) +
                        ", by what this line asks of it.";
  if (const std::string said = eigen_sentence(diagnostic.message); !said.empty()) {
    error.message = "these types do not go together";
    error.explanation += (error.explanation.empty() ? "" : " ") + ("Eigen says: " + said + ".");
  }
  error.explanation = shown(error.explanation);
  find_contract(error, diagnostic, of.contract());
  return error;
}

// No error has a position in the student's file. Only the number of the other errors is reported,
// not their positions.
CompileError told_elsewhere(const std::vector<Diagnostic>& diagnostics, std::size_t more,
                            std::string_view log, const std::string& file) {
  const auto is_error = [](const Diagnostic& said) { return said.is_error(); };
  const auto first = std::find_if(diagnostics.begin(), diagnostics.end(), is_error);
  CompileError error = *unexplained(log, true, file).error;
  if (first == diagnostics.end()) return error;
  const auto count =
      static_cast<std::size_t>(std::count_if(diagnostics.begin(), diagnostics.end(), is_error)) +
      more;
  error.message = readable_message(*first);
  error.explanation = (count == 1 ? std::string("The compiler's error lies")
                                  : "The compiler's " + std::to_string(count) + " errors lie") +
                      " outside of your file, in what it includes.";
  return error;
}

void blame_missing_contract(std::vector<FoundMessage>& found, const Diagnosis& of) {
  const std::string contract = of.contract().name();
  if (of.source().includes("\"" + contract + "\"")) return;
  const auto first = std::find_if(found.begin(), found.end(),
                                  [](const FoundMessage& said) { return said.is_error(); });
  if (first == found.end()) return;
  first->remark.mistake = "contract-not-included";
  first->remark.words = "The file does not include \"" + contract +
                        "\", its contract: write #include \"" + contract + "\" in its first line.";
  std::swap(*first, found.front());
  found.resize(1);
}

// Remarks as long as there is room for them.
std::vector<Remark> remarks_of(std::vector<FoundMessage>& found) {
  std::vector<Remark> remarks;
  std::size_t bytes = 0;
  for (const FoundMessage& said : found) {
    bytes += said.remark.message.size() + said.remark.words.size() + said.remark.file.size();
    if (bytes > max_remarks_bytes) break;
    remarks.push_back(said.remark);
  }
  return remarks;
}

std::string in_a_sentence(const LinkFaults& faults, const std::string& names,
                          std::string_view log) {
  if (!faults.twice.empty()) return faults.twice.front() + " is defined twice";
  if (!names.empty())
    return names + (names.find(',') != std::string::npos
                        ? " are declared in the contract but not defined"
                        : " is declared in the contract but not defined");
  if (!faults.missing.empty())
    return readable(faults.missing.front()) + " is used but defined nowhere";
  return log.empty() ? "the linker failed and said nothing"
                     : std::string(log.substr(0, log.find('\n')));
}

// The linker's complaint about a name that the student's file defines and the C library has too.
// Where libraries are shared, as in a check, the student's goes before it without a word.
bool only_library_twice(const LinkFaults& faults) {
  return faults.missing.empty() && !faults.twice.empty() &&
         std::none_of(faults.twice.begin(), faults.twice.end(), [](const std::string& name) {
           return name == "main" || name.find("::") != std::string::npos;
         });
}

}  // namespace

Diagnosis::Diagnosis(std::string file, std::string text, ContractText contract)
    : file_(std::move(file)), source_(std::move(text)), contract_(std::move(contract)) {}

Explained Diagnosis::of_compile(std::string_view log, bool failed, Columns columns) const {
  auto [diagnostics, more] = parse_diagnostics(first_lines(log, max_log_bytes));
  check_claims(diagnostics, file_, source_, contract_, columns);
  Explained explained;
  std::vector<FoundMessage> found;
  for (const Diagnostic& diagnostic : diagnostics) {
    const std::optional<Located> located = locate(diagnostic);
    if (!located || diagnostic.severity == "note") continue;
    found.push_back(understood(diagnostic, *located, *this));
    if (diagnostic.severity == "warning" && !located->in_library && located->place.line > 0 &&
        explained.warnings.size() < max_warnings)
      explained.warnings.push_back("line " + std::to_string(located->place.line) + ": " +
                                   cut(readable_message(diagnostic), max_warning_bytes));
  }
  found = sifted(std::move(found), source_);
  blame_missing_contract(found, *this);
  explained.remarks = remarks_of(found);
  if (failed) {
    const auto first = std::find_if(found.begin(), found.end(),
                                    [](const FoundMessage& said) { return said.is_error(); });
    explained.error =
        first == found.end() ? told_elsewhere(diagnostics, more, log, file_) : told(*first, *this);
    explained.error->full = kept_log(log);
  }
  return explained;
}

Explained Diagnosis::of_link(std::string_view log) const {
  const std::string_view read = first_lines(log, max_log_bytes);
  const LinkFaults faults = parse_link_faults(read);
  CompileError error;
  error.full = kept_log(log);
  error.file = file_;
  std::string names;
  for (const std::string& symbol : faults.missing) {
    const std::string qualified = symbol.substr(0, symbol.find('('));
    const std::size_t colon = qualified.rfind(':');
    const std::string name = colon == std::string::npos ? qualified : qualified.substr(colon + 1);
    const std::optional<ContractLine> declared = contract_.declared_by_contract(name);
    if (!declared) continue;
    add_contract(error, *declared);
    names += (names.empty() ? "" : ", ") + name;
  }
  error.message = shown(in_a_sentence(faults, names, read));
  Remark remark;
  remark.file = error.file;
  remark.severity = "error";
  remark.message = error.message;
  remark.words = error.message;
  if (const std::optional<Mistake> mistake = recognise_link(faults, source_, contract_)) {
    remark.mistake = mistake->id;
    remark.words = shown(mistake->words);
    error.explanation = remark.words;
    if (mistake->place) {
      remark.line = remark.end_line = mistake->place->line;
      remark.column = 1;
      remark.end_column = source_.character_column(
          {remark.line, static_cast<int>(source_.line(remark.line).size()) + 1});
      error.line = remark.line;
    }
  }
  Explained explained;
  explained.error = std::move(error);
  explained.remarks.push_back(std::move(remark));
  explained.only_library_twice = only_library_twice(faults);
  return explained;
}

}  // namespace contact::grading
