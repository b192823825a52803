#include "contract_text.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "message_text.hpp"

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

constexpr std::size_t max_remembered = 500;
constexpr int max_declaration_lines = 12;

std::optional<ContractLine> declared_in(const ContractText::Header& header,
                                        const std::string& name) {
  const SourceText& source = header.source;
  for (int line = 1; line <= source.line_count(); ++line) {
    const bool is_type = declares_type(source.code(line), name);
    if (!is_type && !declares_function(source.code(line), name)) continue;
    std::string declaration;
    bool block = false;
    for (int next = line; next <= source.line_count() && next < line + max_declaration_lines;
         ++next) {
      const std::string_view code = source.code(next);
      declaration += (next > line ? "\n" : "") + std::string(source.line(next));
      block = block || (is_type && code.find('{') != std::string_view::npos);
      if (code.find(block ? "};" : ";") != std::string_view::npos) break;
    }
    return ContractLine{header.file, line, declaration};
  }
  return std::nullopt;
}

}  // namespace

bool same_file(const fs::path& a, const fs::path& b) {
  return a.lexically_normal().relative_path() == b.lexically_normal().relative_path();
}

ContractText::ContractText(HeaderText contract, std::vector<HeaderText> shapes) {
  headers_.push_back({std::move(contract.file), SourceText(std::move(contract.text))});
  for (HeaderText& shape : shapes)
    headers_.push_back({std::move(shape.file), SourceText(std::move(shape.text))});
}

std::string ContractText::name() const { return fs::path(contract().file).filename().string(); }

const ContractText::Header* ContractText::header(const std::string& file) const {
  const auto found = std::find_if(headers_.begin(), headers_.end(), [&](const Header& header) {
    return same_file(header.file, file);
  });
  return found == headers_.end() ? nullptr : &*found;
}

bool ContractText::mentions(std::string_view text) const {
  return contract().source.text().find(text) != std::string::npos;
}

std::optional<ContractLine> ContractText::declaration_of(const std::string& name) const {
  if (name.empty() || name.size() > max_name_bytes) return std::nullopt;
  if (const auto known = known_.find(name); known != known_.end()) return known->second;
  std::optional<ContractLine> found;
  for (const Header& header : headers_) {
    found = declared_in(header, name);
    if (found) break;
  }
  if (known_.size() < max_remembered) known_[name] = found;
  return found;
}

// What the contract declares comes before what the shapes do.
std::optional<ContractLine> ContractText::declared_by_contract(const std::string& name) const {
  std::optional<ContractLine> found = declaration_of(name);
  if (found && found->file != contract().file) found.reset();
  return found;
}

ContractLine ContractText::declaration_at(int line) const {
  const SourceText& source = contract().source;
  std::string text;
  for (int next = line; next < line + 8; ++next) {
    const std::string_view part = source.line(next);
    text += (next > line ? "\n" : "") + std::string(part);
    if (part.empty() || part.find_first_of(";{") != std::string_view::npos) break;
  }
  return {contract().file, line, text};
}

std::vector<std::string> ContractText::members_of(const std::string& structure) const {
  const std::optional<ContractLine> declared = declaration_of(structure);
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
