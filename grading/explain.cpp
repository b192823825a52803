#include "explain.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "build_text.hpp"
#include "contract_text.hpp"
#include "mistakes.hpp"

namespace fs = std::filesystem;

namespace contact::grading {

namespace {

/// A message at its place in the student's file, in bytes.
struct Found {
  const Diagnostic* diagnostic;
  Place place;
  bool in_library;
  Remark remark;

  [[nodiscard]] bool is_error() const { return remark.severity == "error"; }
};

// Where in the student's file a message belongs. Raised in a header, it is where the last step on
// the way there lies.
std::optional<std::pair<Place, bool>> locate(const Diagnostic& diagnostic, const Answer& answer,
                                             Columns columns) {
  std::optional<std::pair<Place, bool>> found;
  if (same_file(diagnostic.file, answer.file))
    found = {{diagnostic.line, diagnostic.column}, false};
  for (const Step& step : diagnostic.required_from) {
    if (!found || found->second) {
      if (same_file(step.file, answer.file)) found = {{step.line, step.column}, true};
    }
  }
  if (found && found->first.column > 0)
    found->first.column = answer.source.byte_column(found->first, columns);
  return found;
}

// One past the end of what a message is about, in bytes.
Place end_of(const Diagnostic& diagnostic, Place place, bool moved, const Answer& answer,
             Columns columns) {
  if (place.column == 0) return place;
  if (!moved && diagnostic.end_column > 0) {
    const Place end{diagnostic.end_line, diagnostic.end_column};
    return {end.line, answer.source.byte_column(end, columns)};
  }
  const auto length = std::max<std::size_t>(answer.source.word_at(place).size(), 1);
  return {place.line, place.column + static_cast<int>(length)};
}

std::string plain_words(const Diagnostic& diagnostic) {
  if (const std::string said = eigen_sentence(diagnostic.message); !said.empty())
    return "These types do not go together. Eigen says: " + said + ".";
  return readable(with_vectors(diagnostic.message));
}

Found understood(const Diagnostic& diagnostic, Place place, bool in_library,
                 const Exercise& exercise, const Answer& answer, Columns columns) {
  Found found{&diagnostic, place, in_library, {}};
  Remark& remark = found.remark;
  remark.file = answer.file.string();
  remark.severity = diagnostic.is_error() ? "error" : "warning";
  remark.message = diagnostic.message;
  const std::optional<Mistake> mistake = recognise({diagnostic, place, answer.source, exercise});
  remark.words = mistake ? mistake->words : plain_words(diagnostic);
  if (mistake) remark.mistake = mistake->id;
  const bool moved = in_library || (mistake && mistake->place);
  if (mistake && mistake->place) found.place = *mistake->place;
  const Place end = end_of(diagnostic, found.place, moved, answer, columns);
  remark.line = found.place.line;
  remark.column = answer.source.character_column(found.place);
  remark.end_line = end.line;
  remark.end_column = answer.source.character_column(end);
  return found;
}

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

// One mistake makes a compiler say much. What follows from an earlier message is left out: all of
// it stays in the compiler's own words.
class Sieve {
 public:
  Sieve(const std::vector<Found>& all, const SourceText& source) : source_(source) {
    for (const Found& found : all) {
      fails_ = fails_ || found.is_error();
      misread_ =
          misread_ || derails(found.remark.mistake) || found.remark.mistake == "capital-letter";
      in_comment_ = in_comment_ || found.remark.mistake == "unfinished-comment";
    }
  }

  bool keep(const Found& found) {
    if (follows(found)) return false;
    if (derails(found.remark.mistake)) derailed_ = found.remark.line;
    kept_.push_back(&found);
    return true;
  }

 private:
  [[nodiscard]] bool follows(const Found& found) const {
    const Remark& remark = found.remark;
    if (fails_ && (remark.mistake == "unused" || remark.mistake == "no-effect")) return true;
    if (remark.message.find("<expression error>") != std::string::npos) return true;
    if (in_comment_ && remark.mistake == "missing-brace") return true;
    if (misread_ && (remark.mistake == "missing-return" || remark.mistake == "uninitialised"))
      return true;
    if (derailed_ > 0 && !(derails(remark.mistake) && remark.line > derailed_ + 2)) return true;
    return std::any_of(kept_.begin(), kept_.end(), [&](const Found* earlier) {
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
  std::vector<const Found*> kept_;
};

std::vector<Found> sifted(std::vector<Found> all, const SourceText& source) {
  const bool fails =
      std::any_of(all.begin(), all.end(), [](const Found& found) { return found.is_error(); });
  for (Found& found : all) {
    // A compiler warns of it and then fails by what it makes of the rest of the line.
    if (fails && found.remark.mistake == "unfinished-text") found.remark.severity = "error";
  }
  std::stable_sort(all.begin(), all.end(), [](const Found& a, const Found& b) {
    const auto rank = [](const Found& found) {
      return std::tuple(found.remark.line, !found.is_error(), found.remark.mistake.empty(),
                        found.remark.column);
    };
    return rank(a) < rank(b);
  });
  Sieve sieve(all, source);
  std::vector<Found> kept;
  kept.reserve(all.size());
  for (Found& found : all) {
    if (sieve.keep(found)) kept.push_back(found);
  }
  return kept;
}

std::string excerpt_at(const SourceText& source, Place place) {
  const std::string number = std::to_string(place.line);
  std::string excerpt = "  " + number + " | " + std::string(source.line(place.line));
  if (place.column > 0)
    excerpt += "\n  " + std::string(number.size(), ' ') + " | " +
               std::string(static_cast<std::size_t>(source.character_column(place)) - 1, ' ') + "^";
  return excerpt;
}

std::string library_of(const std::string& header) {
  if (header.find("/Eigen/") != std::string::npos) return "Eigen";
  if (header.find("/c++/") != std::string::npos) return "the standard library";
  return fs::path(header).filename().string();
}

void add_contract(CompileError& error, const ContractLine& line) {
  const bool known =
      std::any_of(error.contract.begin(), error.contract.end(), [&](const ContractLine& other) {
        return other.file == line.file && other.line == line.line;
      });
  if (!known && error.contract.size() < 3) error.contract.push_back(line);
}

// The contract's lines beside the error: those that the compiler's notes point at, else those that
// declare what the message names.
void find_contract(CompileError& error, const Diagnostic& diagnostic, const Exercise& exercise) {
  for (const Diagnostic& note : diagnostic.notes) {
    if (same_file(note.file, exercise.contract))
      add_contract(error, {exercise.contract.string(), note.line,
                           declaration_at(exercise.contract, note.line)});
  }
  if (!error.contract.empty()) return;
  for (const fs::path& file : contract_files(exercise)) {
    for (const std::string& name : quoted_names(without_aliases(diagnostic.message))) {
      if (name == "exercise" || name == "contact") continue;
      if (const std::optional<ContractLine> line = declaration_of(file, name))
        add_contract(error, *line);
    }
    if (!error.contract.empty()) return;
  }
}

CompileError told(const Found& found, const Exercise& exercise, const Answer& answer) {
  const Diagnostic& diagnostic = *found.diagnostic;
  CompileError error;
  error.file = found.remark.file;
  error.line = found.remark.line;
  error.column = found.remark.column;
  error.message = readable(with_vectors(diagnostic.message));
  const bool there = !found.in_library && found.place.line == diagnostic.line;
  error.excerpt = there ? diagnostic.excerpt : excerpt_at(answer.source, found.place);
  if (!found.remark.mistake.empty())
    error.explanation = found.remark.words;
  else if (found.in_library)
    error.explanation = "The error is raised inside " + library_of(diagnostic.file) +
                        ", by what this line asks of it.";
  if (const std::string said = eigen_sentence(diagnostic.message); !said.empty()) {
    error.message = "these types do not go together";
    error.explanation += (error.explanation.empty() ? "" : " ") + ("Eigen says: " + said + ".");
  }
  find_contract(error, diagnostic, exercise);
  return error;
}

// An error that has no place in the student's file, or no form that is known.
CompileError told_elsewhere(const std::vector<Diagnostic>& diagnostics, std::string_view log,
                            const Answer& answer) {
  CompileError error;
  const auto first = std::find_if(diagnostics.begin(), diagnostics.end(),
                                  [](const Diagnostic& said) { return said.is_error(); });
  if (first == diagnostics.end()) {
    error.file = answer.file.string();
    const std::vector<std::string> lines = split_lines(log);
    error.message = lines.empty() ? "the compiler failed and said nothing" : lines.front();
    return error;
  }
  error.file = first->file;
  error.line = first->line;
  error.column = first->column;
  error.message = readable(with_vectors(first->message));
  error.excerpt = first->excerpt;
  return error;
}

void blame_missing_contract(std::vector<Found>& found, const Exercise& exercise,
                            const SourceText& source) {
  const std::string contract = exercise.contract.filename().string();
  if (source.includes("\"" + contract + "\"")) return;
  const auto first =
      std::find_if(found.begin(), found.end(), [](const Found& said) { return said.is_error(); });
  if (first == found.end()) return;
  first->remark.mistake = "contract-not-included";
  first->remark.words = "The file does not include \"" + contract +
                        "\", its contract: write #include \"" + contract + "\" in its first line.";
  std::swap(*first, found.front());
  found.resize(1);
}

}  // namespace

Explained explain_compile(std::string_view log, bool failed, const Exercise& exercise,
                          const Answer& answer, Columns columns) {
  const std::vector<Diagnostic> diagnostics = parse_diagnostics(log);
  Explained explained;
  std::vector<Found> found;
  for (const Diagnostic& diagnostic : diagnostics) {
    const auto place = locate(diagnostic, answer, columns);
    if (!place || diagnostic.severity == "note") continue;
    found.push_back(understood(diagnostic, place->first, place->second, exercise, answer, columns));
    if (diagnostic.severity == "warning" && !place->second)
      explained.warnings.push_back("line " + std::to_string(diagnostic.line) + ": " +
                                   readable(with_vectors(diagnostic.message)));
  }
  found = sifted(std::move(found), answer.source);
  blame_missing_contract(found, exercise, answer.source);
  for (const Found& said : found) explained.remarks.push_back(said.remark);
  if (failed) {
    const auto first =
        std::find_if(found.begin(), found.end(), [](const Found& said) { return said.is_error(); });
    explained.error = first == found.end() ? told_elsewhere(diagnostics, log, answer)
                                           : told(*first, exercise, answer);
    explained.error->full = std::string(log);
  }
  return explained;
}

Explained explain_link(std::string_view log, const Exercise& exercise, const Answer& answer) {
  return explain_link_faults(parse_link_faults(log), log, exercise, answer);
}

Explained explain_link_faults(const LinkFaults& faults, std::string_view log,
                              const Exercise& exercise, const Answer& answer) {
  CompileError error;
  error.full = std::string(log);
  error.file = answer.file.string();
  std::string names;
  for (const std::string& symbol : faults.missing) {
    const std::string qualified = symbol.substr(0, symbol.find('('));
    const std::size_t colon = qualified.rfind(':');
    const std::string name = colon == std::string::npos ? qualified : qualified.substr(colon + 1);
    const std::optional<ContractLine> declared = declaration_of(exercise.contract, name);
    if (!declared) continue;
    add_contract(error, *declared);
    names += (names.empty() ? "" : ", ") + name;
  }
  if (!faults.twice.empty()) {
    error.message = faults.twice.front() + " is defined twice";
  } else if (!names.empty()) {
    const bool several = names.find(',') != std::string::npos;
    error.message = names + (several ? " are declared in the contract but not defined"
                                     : " is declared in the contract but not defined");
  } else if (!faults.missing.empty()) {
    error.message = readable(faults.missing.front()) + " is used but defined nowhere";
  } else {
    const std::vector<std::string> lines = split_lines(log);
    error.message = lines.empty() ? "the linker failed and said nothing" : lines.front();
  }
  Remark remark;
  remark.file = error.file;
  remark.severity = "error";
  remark.message = error.message;
  remark.words = error.message;
  if (const std::optional<Mistake> mistake = recognise_link(faults, answer.source, exercise)) {
    remark.mistake = mistake->id;
    remark.words = mistake->words;
    error.explanation = mistake->words;
    if (mistake->place) {
      remark.line = remark.end_line = mistake->place->line;
      remark.column = 1;
      remark.end_column = static_cast<int>(answer.source.line(remark.line).size()) + 1;
      error.line = remark.line;
    }
  }
  return {std::move(error), {std::move(remark)}, {}};
}

}  // namespace contact::grading
