#include "build_messages.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <regex>
#include <set>
#include <sstream>

namespace fs = std::filesystem;

namespace contact::grading {

namespace {

std::vector<std::string> split_lines(std::string_view text) {
  std::vector<std::string> lines;
  std::istringstream stream{std::string(text)};
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

struct Head {
  std::string file;
  int line = 0;
  int column = 0;
  std::string rest;
};

// "FILE:LINE:COLUMN: REST" (or without the column).
bool parse_head(const std::string& text, Head& head) {
  static const std::regex pattern(R"(^([^\s:][^:]*):(\d+):(?:(\d+):)?\s+(.*)$)");
  std::smatch match;
  if (!std::regex_match(text, match, pattern)) return false;
  head.file = match[1];
  head.line = std::stoi(match[2]);
  head.column = match[3].matched ? std::stoi(match[3]) : 0;
  head.rest = match[4];
  return true;
}

bool is_excerpt(const std::string& line) {
  static const std::regex pattern(R"(^\s*(\d+)?\s\|.*$)");
  return std::regex_match(line, pattern);
}

bool same_file(const std::string& a, const fs::path& b) {
  return fs::path(a).lexically_normal() == b.lexically_normal();
}

bool identifier_character(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

std::size_t end_of_brackets(const std::string& text, std::size_t open) {
  int depth = 0;
  for (std::size_t i = open; i < text.size(); ++i) {
    if (text[i] == '<') ++depth;
    if (text[i] == '>' && --depth == 0) return i + 1;
  }
  return text.size();
}

void replace_all(std::string& text, std::string_view from, std::string_view to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
}

// Types as a reader writes them: Vector3<double>, not Eigen::Matrix<double, 3, 1, 0, 3, 1>.
std::string readable(std::string text) {
  static const std::regex aka(R"( ?\{aka [^}]*\})");
  text = std::regex_replace(text, aka, "");
  static const std::regex vector_long(
      R"(Eigen::Matrix<(\w+(?: \w+)?), ([234]), 1(?:, 0, [234], 1)?>)");
  text = std::regex_replace(text, vector_long, "Vector$2<$1>");
  replace_all(text, "contact::Vector", "Vector");
  replace_all(text,
              "std::__cxx11::basic_string<char, std::char_traits<char>, std::allocator<char> >",
              "std::string");
  replace_all(text, "std::__cxx11::basic_string<char>", "std::string");
  // What an Eigen expression is made of helps nobody here.
  for (std::size_t at = text.find("Eigen::"); at != std::string::npos;
       at = text.find("Eigen::", at + 1)) {
    std::size_t end = at + 7;
    while (end < text.size() && (identifier_character(text[end]) || text[end] == ':')) ++end;
    if (end < text.size() && text[end] == '<') {
      const std::size_t close = end_of_brackets(text, end);
      if (close - end > 12) text.replace(end, close - end, "<...>");
    }
  }
  return text;
}

// EIGEN_STATIC_ASSERT spells its sentence in capitals.
std::string eigen_sentence(const std::string& message) {
  static const std::regex pattern(R"(\b([A-Z][A-Z0-9]*(?:_+[A-Z0-9]+){2,})\b)");
  std::smatch match;
  if (!std::regex_search(message, match, pattern)) return {};
  std::string sentence = match[1];
  std::string result;
  for (const char c : sentence) {
    if (c == '_') {
      if (!result.empty() && result.back() != ' ') result += ' ';
    } else {
      result += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
  }
  return "Eigen says: " + result + ".";
}

std::string line_of_file(const fs::path& file, int number) {
  try {
    const std::vector<std::string> lines = split_lines(read_text(file));
    if (number >= 1 && static_cast<std::size_t>(number) <= lines.size())
      return lines[static_cast<std::size_t>(number) - 1];
  } catch (const BookError&) {
    // A header that cannot be read has no line to show.
  }
  return {};
}

std::string excerpt_at(const fs::path& file, int line, int column) {
  const std::string text = line_of_file(file, line);
  if (text.empty()) return {};
  const std::string number = std::to_string(line);
  std::string excerpt = "  " + number + " | " + text;
  if (column > 0)
    excerpt += "\n  " + std::string(number.size(), ' ') + " | " +
               std::string(static_cast<std::size_t>(column) - 1, ' ') + "^";
  return excerpt;
}

std::string library_of(const std::string& header) {
  if (header.find("/Eigen/") != std::string::npos) return "Eigen";
  if (header.find("/c++/") != std::string::npos) return "the standard library";
  return fs::path(header).filename().string();
}

// What a message quotes: ‘name’ (g++) or 'name' (clang++).
std::vector<std::string> quoted_names(const std::string& message) {
  static const std::regex pattern("(?:\xE2\x80\x98|['`])(.*?)(?:\xE2\x80\x99|')");
  std::vector<std::string> names;
  for (std::sregex_iterator it(message.begin(), message.end(), pattern), end; it != end; ++it) {
    const std::string quoted = (*it)[1];
    std::string name;
    for (std::size_t i = 0; i <= quoted.size(); ++i) {
      if (i < quoted.size() && identifier_character(quoted[i])) {
        name += quoted[i];
      } else if (!name.empty()) {
        names.push_back(name);
        name.clear();
      }
    }
  }
  return names;
}

fs::path root_of(const Exercise& exercise) {
  return exercise.folder.parent_path().parent_path().parent_path();
}

// The contract itself, then the plain shapes that contracts are written with.
std::vector<fs::path> contract_files(const Exercise& exercise) {
  std::vector<fs::path> files{exercise.contract};
  std::error_code error;
  for (const fs::directory_entry& chapter :
       fs::directory_iterator(root_of(exercise) / "chapters", error)) {
    const fs::path shapes = chapter.path() / "contact" / "shapes.hpp";
    if (fs::exists(shapes)) files.push_back(shapes);
  }
  return files;
}

// A line and those after it, to the end of the declaration.
std::string declaration_at(const fs::path& file, int line) {
  std::string text;
  for (int next = line; next < line + 8; ++next) {
    const std::string part = line_of_file(file, next);
    text += (next > line ? "\n" : "") + part;
    if (part.empty() || part.find_first_of(";{") != std::string::npos) break;
  }
  return text;
}

void add_contract(CompileError& error, const std::vector<ContractLine>& lines) {
  for (const ContractLine& line : lines) {
    const bool known =
        std::any_of(error.contract.begin(), error.contract.end(), [&](const ContractLine& other) {
          return other.file == line.file && other.line == line.line;
        });
    if (!known && error.contract.size() < 3) error.contract.push_back(line);
  }
}

// The contract's lines beside the error: those that the compiler's notes point at, else those that
// declare what the message names.
void find_contract(CompileError& error, const Diagnostic& diagnostic, const Exercise& exercise) {
  for (const Diagnostic& note : diagnostic.notes) {
    if (same_file(note.file, exercise.contract))
      add_contract(error, {{note.file, note.line, declaration_at(exercise.contract, note.line)}});
  }
  if (!error.contract.empty()) return;
  for (const fs::path& file : contract_files(exercise)) {
    for (const std::string& name : quoted_names(diagnostic.message)) {
      if (name != "exercise" && name != "contact") add_contract(error, declaration_of(file, name));
    }
    if (!error.contract.empty()) return;
  }
}

// The student's definition that was probably meant for a missing one.
std::string what_is_there_instead(const std::string& name, const std::string& symbol,
                                  const Exercise& exercise,
                                  const std::vector<std::string>& defined) {
  const std::string qualified = symbol.substr(0, symbol.find('('));
  std::vector<std::string> others;
  for (const std::string& other : defined) {
    const std::string other_qualified = other.substr(0, other.find('('));
    if (other_qualified == qualified)
      return "Your file defines " + readable(other) +
             ", whose parameters are not the contract's: " + readable(symbol) + ".";
    if (other_qualified == name || other_qualified.ends_with("::" + name))
      return "Your file defines " + readable(other) + ", which is not in namespace exercise.";
    if (other_qualified.starts_with("exercise::")) others.push_back(other_qualified.substr(10));
  }
  for (const std::string& other : nearest(name, others)) {
    if (declaration_of(exercise.contract, other).empty())
      return "Your file defines " + other + ", which the contract does not name: is it " + name +
             ", misspelt?";
  }
  return {};
}

}  // namespace

std::vector<Diagnostic> parse_diagnostics(std::string_view text) {
  std::vector<Diagnostic> result;
  std::vector<std::pair<std::string, int>> required_from;
  Diagnostic* latest = nullptr;  // where excerpt lines belong
  for (const std::string& line : split_lines(text)) {
    if (is_excerpt(line)) {
      if (latest != nullptr) latest->excerpt += (latest->excerpt.empty() ? "" : "\n") + line;
      continue;
    }
    Head head;
    if (!parse_head(line, head)) continue;
    static const std::regex severity(R"(^(fatal error|error|warning|note): (.*)$)");
    std::smatch match;
    if (!std::regex_match(head.rest, match, severity)) {
      if (head.rest.find("required from") != std::string::npos ||
          head.rest.find("required by") != std::string::npos)
        required_from.emplace_back(head.file, head.line);
      latest = nullptr;
      continue;
    }
    Diagnostic diagnostic;
    diagnostic.file = head.file;
    diagnostic.line = head.line;
    diagnostic.column = head.column;
    diagnostic.severity = match[1];
    diagnostic.message = match[2];
    if (diagnostic.severity == "note" && !result.empty()) {
      if (diagnostic.message.find("requested here") != std::string::npos)
        result.back().required_from.emplace_back(diagnostic.file, diagnostic.line);
      result.back().notes.push_back(std::move(diagnostic));
      latest = &result.back().notes.back();
    } else {
      diagnostic.required_from = std::move(required_from);
      required_from.clear();
      result.push_back(std::move(diagnostic));
      latest = &result.back();
    }
  }
  return result;
}

std::vector<ContractLine> declaration_of(const fs::path& contract, const std::string& name) {
  std::vector<std::string> lines;
  try {
    lines = split_lines(read_text(contract));
  } catch (const BookError&) {
    return {};
  }
  const std::regex function("(^|[^\\w:.])" + name + "\\s*\\(");
  const std::regex type("^\\s*(struct|class|enum|enum class|using)\\s+" + name + "\\b");
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::size_t start = lines[i].find_first_not_of(" \t");
    if (start == std::string::npos || lines[i].compare(start, 2, "//") == 0) continue;
    const bool is_type = std::regex_search(lines[i], type);
    if (!is_type && !std::regex_search(lines[i], function)) continue;
    std::string text;
    for (std::size_t j = i; j < lines.size() && j < i + 12; ++j) {
      text += (j > i ? "\n" : "") + lines[j];
      const bool block = is_type && text.find('{') != std::string::npos;
      if (block ? lines[j].find("};") != std::string::npos
                : lines[j].find(';') != std::string::npos)
        break;
    }
    return {{contract.string(), static_cast<int>(i) + 1, text}};
  }
  return {};
}

CompileError explain_compile(std::string_view text, const Exercise& exercise,
                             const fs::path& source) {
  CompileError error;
  error.full = std::string(text);
  const std::vector<Diagnostic> diagnostics = parse_diagnostics(text);
  const auto first =
      std::find_if(diagnostics.begin(), diagnostics.end(), [](const Diagnostic& diagnostic) {
        return diagnostic.severity == "error" || diagnostic.severity == "fatal error";
      });
  if (first == diagnostics.end()) {
    error.file = source.string();
    const std::vector<std::string> lines = split_lines(text);
    error.message = lines.empty() ? "the compiler failed and said nothing" : lines.front();
    return error;
  }
  error.file = first->file;
  error.line = first->line;
  error.column = first->column;
  error.message = readable(first->message);
  error.excerpt = first->excerpt;
  if (!same_file(first->file, source)) {
    // Raised in a header: the last step on the way there that lies in the student's file is where
    // it came from.
    for (const auto& [file, line] : first->required_from) {
      if (!same_file(file, source)) continue;
      error.file = file;
      error.line = line;
      error.column = 0;
      error.excerpt = excerpt_at(source, line, 0);
      error.explanation = "The error is raised inside " + library_of(first->file) +
                          ", by what this line asks of it.";
    }
  }
  if (const std::string said = eigen_sentence(first->message); !said.empty()) {
    error.message = "these types do not go together";
    error.explanation = said;
  }
  if (first->message.find("ambiguating new declaration") != std::string::npos ||
      first->message.find("differ only in their return type") != std::string::npos)
    error.explanation = "The contract declares it with another return type.";
  find_contract(error, *first, exercise);
  try {
    if (read_text(source).find("\"" + exercise.contract.filename().string() + "\"") ==
        std::string::npos)
      error.explanation = "The file does not include \"" + exercise.contract.filename().string() +
                          "\", its contract.";
  } catch (const BookError&) {
    error.explanation = "The file cannot be read.";
  }
  return error;
}

std::vector<std::string> warnings_of(std::string_view text, const fs::path& source) {
  std::vector<std::string> result;
  for (const Diagnostic& diagnostic : parse_diagnostics(text)) {
    if (diagnostic.severity == "warning" && same_file(diagnostic.file, source))
      result.push_back("line " + std::to_string(diagnostic.line) + ": " +
                       readable(diagnostic.message));
  }
  return result;
}

CompileError explain_link(std::string_view text, const Exercise& exercise, const fs::path& source,
                          const std::vector<std::string>& defined) {
  CompileError error;
  error.full = std::string(text);
  error.file = source.string();
  static const std::regex undefined(
      R"((?:undefined reference to [`']|undefined symbol: )(.*?)'?$)");
  static const std::regex multiple(R"((?:multiple definition of [`']|duplicate symbol: )([^']*))");
  std::vector<std::string> missing;
  for (const std::string& line : split_lines(text)) {
    std::smatch match;
    if (std::regex_search(line, match, multiple)) {
      error.message = std::string(match[1]) + " is defined twice";
      error.explanation = match[1] == "main"
                              ? "The tests bring their own main(); yours must go."
                              : "The tests or the book define it too; give yours another name.";
      return error;
    }
    if (!std::regex_search(line, match, undefined)) continue;
    if (std::find(missing.begin(), missing.end(), match[1]) == missing.end())
      missing.push_back(match[1]);
  }
  if (missing.empty()) {
    const std::vector<std::string> lines = split_lines(text);
    error.message = lines.empty() ? "the linker failed and said nothing" : lines.front();
    return error;
  }
  std::string names;
  for (const std::string& symbol : missing) {
    const std::string qualified = symbol.substr(0, symbol.find('('));
    const std::string name =
        qualified.substr(qualified.rfind(':') == std::string::npos ? 0 : qualified.rfind(':') + 1);
    const std::vector<ContractLine> declared = declaration_of(exercise.contract, name);
    add_contract(error, declared);
    if (!declared.empty()) names += (names.empty() ? "" : ", ") + name;
    if (!error.explanation.empty() || declared.empty()) continue;
    error.explanation = what_is_there_instead(name, symbol, exercise, defined);
  }
  if (names.empty()) {
    error.message = readable(missing.front()) + " is used but defined nowhere";
  } else {
    const bool several = names.find(',') != std::string::npos;
    error.message = names + (several ? " are declared in the contract but not defined"
                                     : " is declared in the contract but not defined");
  }
  return error;
}

}  // namespace contact::grading
