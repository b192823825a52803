#pragma once

// What a compiler or linker said, turned into what helps the student: each message at its line and
// in words, the first error whole, and the line of the contract that it is about. `contact check`,
// the page and the grader come here.
//
// Both the file and the messages may be written to mislead or to cost time. So the file is read
// once; no number of a message is used before it has been checked against the file (claims.hpp);
// time and memory are always linear in the length of the input, and the result is at most
// max_told_bytes long. README.md gives the reading order of the folder.

#include <string>
#include <string_view>

#include "compiler_messages.hpp"
#include "contract_text.hpp"
#include "explained.hpp"
#include "source_text.hpp"

namespace contact::grading {

/// A student's file that was compiled, with the contract that it answers to.
class Diagnosis {
 public:
  /// @param file its name as the compiler was given it
  Diagnosis(std::string file, std::string text, ContractText contract);

  /// What a compiler said; `failed` if there is no object.
  [[nodiscard]] Explained of_compile(std::string_view log, bool failed, Columns columns) const;

  /// What a linker said when it failed.
  [[nodiscard]] Explained of_link(std::string_view log) const;

  [[nodiscard]] const std::string& file() const { return file_; }
  [[nodiscard]] const SourceText& source() const { return source_; }
  [[nodiscard]] const ContractText& contract() const { return contract_; }

 private:
  std::string file_;
  SourceText source_;
  ContractText contract_;
};

}  // namespace contact::grading
