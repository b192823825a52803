#include "explain_request.hpp"

#include <charconv>
#include <stdexcept>
#include <utility>

#include <nlohmann/json.hpp>

#include "diagnosis.hpp"
#include "message_text.hpp"

namespace contact::grading {

namespace {

void put(std::string& bytes, std::string_view field) {
  bytes += std::to_string(field.size()) + '\n';
  bytes += field;
}

class Fields {
 public:
  explicit Fields(std::string_view bytes) : bytes_(bytes) {}

  [[nodiscard]] bool more() const { return !bytes_.empty(); }
  std::string next() {
    std::size_t size = 0;
    const auto [end, error] = std::from_chars(bytes_.data(), bytes_.data() + bytes_.size(), size);
    const auto digits = static_cast<std::size_t>(end - bytes_.data());
    if (error != std::errc() || digits >= bytes_.size() || *end != '\n' ||
        bytes_.size() - digits - 1 < size)
      throw std::invalid_argument("the question to contact-explain is cut off or broken");
    std::string field(bytes_.substr(digits + 1, size));
    bytes_.remove_prefix(digits + 1 + size);
    return field;
  }

 private:
  std::string_view bytes_;
};

}  // namespace

void shorten(Explained& said, const std::string& root) {
  if (root.empty()) return;
  const auto in = [&](std::string& text) { replace_all(text, root, ""); };
  for (Remark& remark : said.remarks) {
    for (std::string* text : {&remark.file, &remark.message, &remark.words}) in(*text);
  }
  for (std::string& warning : said.warnings) in(warning);
  if (!said.error) return;
  CompileError& error = *said.error;
  for (std::string* text : {&error.file, &error.message, &error.excerpt, &error.explanation})
    in(*text);
  for (ContractLine& line : error.contract) in(line.file);
}

namespace {

std::string dumped(const Explained& said) {
  return to_json(said).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace

std::string to_bytes(const ExplainRequest& request) {
  std::string bytes;
  put(bytes, request.step == ExplainRequest::Step::link ? "link" : "compile");
  put(bytes, request.failed ? "failed" : "");
  put(bytes, request.columns == Columns::bytes ? "bytes" : "displayed");
  put(bytes, request.file);
  put(bytes, request.source);
  put(bytes, first_lines(request.log, max_log_bytes));
  put(bytes, request.root);
  for (const HeaderText& header : request.headers) {
    put(bytes, header.file);
    put(bytes, header.text);
  }
  return bytes;
}

ExplainRequest request_from(std::string_view bytes) {
  Fields fields(bytes);
  ExplainRequest request;
  request.step =
      fields.next() == "link" ? ExplainRequest::Step::link : ExplainRequest::Step::compile;
  request.failed = !fields.next().empty();
  request.columns = fields.next() == "bytes" ? Columns::bytes : Columns::displayed;
  request.file = fields.next();
  request.source = fields.next();
  request.log = fields.next();
  request.root = fields.next();
  while (fields.more()) {
    std::string file = fields.next();
    request.headers.push_back({std::move(file), fields.next()});
  }
  if (request.headers.empty())
    throw std::invalid_argument("the question to contact-explain has no contract");
  return request;
}

std::string explain(ExplainRequest request) {
  HeaderText contract = std::move(request.headers.front());
  request.headers.erase(request.headers.begin());
  const Diagnosis diagnosis(std::move(request.file), std::move(request.source),
                            {std::move(contract), std::move(request.headers)});
  Explained said = request.step == ExplainRequest::Step::link
                       ? diagnosis.of_link(request.log)
                       : diagnosis.of_compile(request.log, request.failed, request.columns);
  shorten(said, request.root);
  std::string told = dumped(said);
  // Escaped as JSON it may still be too long; then the last remarks go.
  while (told.size() > max_told_bytes && !said.remarks.empty()) {
    said.remarks.resize(said.remarks.size() / 2);
    told = dumped(said);
  }
  return told;
}

}  // namespace contact::grading
