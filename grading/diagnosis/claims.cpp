#include "claims.hpp"

#include <map>

namespace contact::grading {

namespace {

class Checker {
 public:
  Checker(const std::string& file, const SourceText& source, const ContractText& contract,
          Columns columns)
      : file_(file), source_(source), contract_(contract), columns_(columns) {}

  void check(Diagnostic& said) {
    const Known& known = know(said.file);
    const Place end{said.end_line, said.end_column};
    const int claimed = said.line;
    said.own = known.own || known.renamed;
    const Place place = place_of(known, said.file, {said.line, said.column});
    const Place last = said.own ? place_of(known, said.file, end) : Place{};
    said.line = place.line;
    said.column = place.column;
    const bool ends_behind =
        last.line > place.line || (last.line == place.line && last.column > place.column);
    said.end_line = place.column > 0 && last.column > 0 && ends_behind ? last.line : 0;
    said.end_column = said.end_line > 0 ? last.column : 0;
    if (!said.own || said.line != claimed || said.line == 0) said.excerpt.clear();
    if (said.own) said.file = file_;
    for (Step& step : said.required_from) check(step);
    for (Diagnostic& note : said.notes) check(note);
  }

 private:
  struct Known {
    bool own = false;      ///< it is the student's file
    bool renamed = false;  ///< a #line directive calls a part of the student's file so
    const ContractText::Header* header = nullptr;
  };

  const Known& know(const std::string& file) {
    const auto [entry, is_new] = known_.try_emplace(file);
    if (is_new)
      entry->second = {same_file(file, file_), source_.goes_by_name(file), contract_.header(file)};
    return entry->second;
  }

  [[nodiscard]] Place place_of(const Known& known, const std::string& file, Place claimed) const {
    if (known.own || known.renamed) {
      const int line = source_.physical_line(file, known.own, claimed.line);
      if (line == 0) return {};
      return {line, source_.byte_column({line, claimed.column}, columns_)};
    }
    if (known.header != nullptr && claimed.line <= known.header->source.line_count())
      return {claimed.line, 0};
    return {};
  }

  void check(Step& step) {
    const Known& known = know(step.file);
    step.own = known.own || known.renamed;
    const Place place = place_of(known, step.file, {step.line, step.column});
    step.line = place.line;
    step.column = place.column;
  }

  const std::string& file_;
  const SourceText& source_;
  const ContractText& contract_;
  const Columns columns_;
  std::map<std::string, Known> known_;
};

}  // namespace

void check_claims(std::vector<Diagnostic>& diagnostics, const std::string& file,
                  const SourceText& source, const ContractText& contract, Columns columns) {
  Checker checker(file, source, contract, columns);
  for (Diagnostic& said : diagnostics) checker.check(said);
}

}  // namespace contact::grading
