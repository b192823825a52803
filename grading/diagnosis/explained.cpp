#include "explained.hpp"

#include <utility>

#include <nlohmann/json.hpp>

#include "message_text.hpp"

namespace contact::grading {

namespace {

using nlohmann::json;

constexpr std::size_t max_line_told = 300;

json contract_json(const ContractLine& line) {
  return {{"file", line.file}, {"line", line.line}, {"text", line.text}};
}

json error_json(const CompileError& error) {
  json contract = json::array();
  for (const ContractLine& line : error.contract) contract.push_back(contract_json(line));
  return {{"file", error.file},       {"line", error.line},
          {"column", error.column},   {"message", error.message},
          {"excerpt", error.excerpt}, {"explanation", error.explanation},
          {"contract", contract}};
}

CompileError error_from(const json& said) {
  CompileError error;
  said.at("file").get_to(error.file);
  said.at("line").get_to(error.line);
  said.at("column").get_to(error.column);
  said.at("message").get_to(error.message);
  said.at("excerpt").get_to(error.excerpt);
  said.at("explanation").get_to(error.explanation);
  for (const json& line : said.at("contract"))
    error.contract.push_back({line.at("file").get<std::string>(), line.at("line").get<int>(),
                              line.at("text").get<std::string>()});
  return error;
}

json remark_json(const Remark& remark) {
  return {{"file", remark.file},
          {"line", remark.line},
          {"column", remark.column},
          {"end_line", remark.end_line},
          {"end_column", remark.end_column},
          {"severity", remark.severity},
          {"message", remark.message},
          {"words", remark.words},
          {"mistake", remark.mistake}};
}

Remark remark_from(const json& said) {
  Remark remark;
  said.at("file").get_to(remark.file);
  said.at("line").get_to(remark.line);
  said.at("column").get_to(remark.column);
  said.at("end_line").get_to(remark.end_line);
  said.at("end_column").get_to(remark.end_column);
  said.at("severity").get_to(remark.severity);
  said.at("message").get_to(remark.message);
  said.at("words").get_to(remark.words);
  said.at("mistake").get_to(remark.mistake);
  return remark;
}

bool is_error(std::string_view line) {
  return line.find("error: ") != std::string_view::npos ||
         line.find("Error: ") != std::string_view::npos;
}

// The first line that is an error, else the first that is not empty.
std::string_view first_error(std::string_view log) {
  std::string_view first;
  for (std::size_t at = 0; at < log.size();) {
    const std::size_t end = std::min(log.find('\n', at), log.size());
    const std::string_view line = log.substr(at, end - at);
    if (is_error(line)) return line;
    if (first.empty()) first = line;
    at = end + 1;
  }
  return first;
}

}  // namespace

std::string kept_log(std::string_view log) {
  const std::string_view kept = first_lines(log, max_log_bytes);
  if (kept.size() == log.size()) return std::string(log);
  return std::string(kept) + "(" + std::to_string(log.size() - kept.size()) +
         " more bytes are left out)\n";
}

Explained unexplained(std::string_view log, bool failed, const std::string& file) {
  Explained said;
  if (!failed) return said;
  log = first_lines(log, max_log_bytes);
  said.error = CompileError{};
  said.error->file = file;
  const std::string_view line = first_error(log);
  said.error->message =
      line.empty() ? "the compiler failed and said nothing" : cut(line, max_line_told);
  said.error->full = kept_log(log);
  return said;
}

json to_json(const Explained& said) {
  json remarks = json::array();
  for (const Remark& remark : said.remarks) remarks.push_back(remark_json(remark));
  json told = {{"remarks", std::move(remarks)},
               {"warnings", said.warnings},
               {"only_library_twice", said.only_library_twice}};
  if (said.error) told["error"] = error_json(*said.error);
  return told;
}

Explained explained_from_json(const json& told) {
  Explained said;
  for (const json& remark : told.at("remarks")) said.remarks.push_back(remark_from(remark));
  told.at("warnings").get_to(said.warnings);
  told.at("only_library_twice").get_to(said.only_library_twice);
  if (told.contains("error")) said.error = error_from(told.at("error"));
  return said;
}

}  // namespace contact::grading
