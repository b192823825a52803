#include "contract_text.hpp"

#include <algorithm>
#include <array>
#include <system_error>

#include "build_text.hpp"
#include "source_text.hpp"

namespace fs = std::filesystem;

namespace contact::grading {

namespace {

// Whether `text` holds `name` as a whole word at `at`.
bool word_at(std::string_view text, std::size_t at, std::string_view name) {
  const std::size_t end = at + name.size();
  return (at == 0 || !is_identifier_character(text[at - 1])) &&
         (end == text.size() || !is_identifier_character(text[end]));
}

std::size_t find_word(std::string_view text, std::string_view name) {
  for (std::size_t at = text.find(name); at != std::string_view::npos;
       at = text.find(name, at + 1)) {
    if (word_at(text, at, name)) return at;
  }
  return std::string_view::npos;
}

bool declares_type(std::string_view code, std::string_view name) {
  const std::size_t at = find_word(code, name);
  if (at == std::string_view::npos) return false;
  constexpr std::array<std::string_view, 4> kinds{"struct", "class", "enum", "using"};
  return std::any_of(kinds.begin(), kinds.end(), [&](std::string_view kind) {
    const std::size_t start = find_word(code, kind);
    return start < at && code.substr(0, start).find_first_not_of(" \t") == std::string_view::npos;
  });
}

// A name before a bracket is a function's unless it is asked of something: x.name(, x::name(.
bool declares_function(std::string_view code, std::string_view name) {
  const std::size_t at = find_word(code, name);
  if (at == std::string_view::npos || (at > 0 && (code[at - 1] == '.' || code[at - 1] == ':')))
    return false;
  const std::size_t next = code.find_first_not_of(" \t", at + name.size());
  return next != std::string_view::npos && code[next] == '(';
}

// Where one of the signs stands next, outside of all brackets.
std::size_t next_outside_brackets(std::string_view code, std::size_t at, std::string_view signs) {
  int depth = 0;
  for (; at < code.size(); ++at) {
    if (depth == 0 && signs.find(code[at]) != std::string_view::npos) return at;
    if (code[at] == '<' || code[at] == '(' || code[at] == '{') ++depth;
    if (code[at] == '>' || code[at] == ')' || code[at] == '}') --depth;
  }
  return at;
}

// "Vector3<S> a = Vector3<S>::Zero()" declares a: the last name before what it begins with.
std::string declared_name(std::string_view declaration) {
  declaration = declaration.substr(0, next_outside_brackets(declaration, 0, "={"));
  const std::size_t last = declaration.find_last_not_of(" \t");
  if (last == std::string_view::npos || !is_identifier_character(declaration[last])) return {};
  std::size_t first = last;
  while (first > 0 && is_identifier_character(declaration[first - 1])) --first;
  return std::string(declaration.substr(first, last + 1 - first));
}

}  // namespace

std::vector<fs::path> contract_files(const Exercise& exercise) {
  std::vector<fs::path> files{exercise.contract};
  const fs::path root = exercise.folder.parent_path().parent_path().parent_path();
  std::error_code error;
  for (const fs::directory_entry& chapter : fs::directory_iterator(root / "chapters", error)) {
    fs::path shapes = chapter.path() / "contact" / "shapes.hpp";
    if (fs::exists(shapes, error)) files.push_back(std::move(shapes));
  }
  return files;
}

bool same_file(const fs::path& a, const fs::path& b) {
  return a.lexically_normal().relative_path() == b.lexically_normal().relative_path();
}

std::string line_of_file(const fs::path& file, int number) {
  try {
    return std::string(SourceText(read_text(file)).line(number));
  } catch (const BookError&) {
    return {};  // a header that cannot be read has no line to show
  }
}

std::string declaration_at(const fs::path& file, int line) {
  std::string text;
  for (int next = line; next < line + 8; ++next) {
    const std::string part = line_of_file(file, next);
    text += (next > line ? "\n" : "") + part;
    if (part.empty() || part.find_first_of(";{") != std::string::npos) break;
  }
  return text;
}

std::optional<ContractLine> declaration_of(const fs::path& header, const std::string& name) {
  std::string text;
  try {
    text = read_text(header);
  } catch (const BookError&) {
    return std::nullopt;
  }
  const SourceText source(text);
  for (int line = 1; line <= source.line_count(); ++line) {
    const bool is_type = declares_type(source.code(line), name);
    if (!is_type && !declares_function(source.code(line), name)) continue;
    std::string declaration;
    bool block = false;
    for (int next = line; next <= source.line_count() && next < line + 12; ++next) {
      const std::string_view code = source.code(next);
      declaration += (next > line ? "\n" : "") + std::string(source.line(next));
      block = block || (is_type && code.find('{') != std::string_view::npos);
      if (code.find(block ? "};" : ";") != std::string_view::npos) break;
    }
    return ContractLine{header.string(), line, declaration};
  }
  return std::nullopt;
}

std::optional<ContractLine> declaration_of(const Exercise& exercise, const std::string& name) {
  for (const fs::path& file : contract_files(exercise)) {
    if (std::optional<ContractLine> found = declaration_of(file, name)) return found;
  }
  return std::nullopt;
}

bool mentions(const fs::path& file, std::string_view text) {
  try {
    return read_text(file).find(text) != std::string::npos;
  } catch (const BookError&) {
    return false;  // what cannot be read says nothing
  }
}

std::vector<std::string> members_of(const Exercise& exercise, const std::string& structure) {
  const std::optional<ContractLine> declared = declaration_of(exercise, structure);
  if (!declared) return {};
  std::string code;
  const SourceText text(declared->text);
  for (int line = 1; line <= text.line_count(); ++line) code += std::string(text.code(line)) + " ";
  const std::size_t open = code.find('{');
  if (open == std::string::npos) return {};
  std::vector<std::string> members;
  std::size_t at = open + 1;
  const std::size_t end = std::min(code.rfind('}'), code.size());
  while (at < end) {
    const std::size_t stop = std::min(next_outside_brackets(code, at, ";,"), end);
    if (std::string name = declared_name(std::string_view(code).substr(at, stop - at));
        !name.empty())
      members.push_back(std::move(name));
    at = stop + 1;
  }
  return members;
}

}  // namespace contact::grading
