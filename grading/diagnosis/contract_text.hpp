#pragma once

// The contract as text: what it declares, so that a message can show it beside the student's line.
// Each header is read once, however many messages ask.

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "../verdict/verdict.hpp"
#include "source_text.hpp"

namespace contact::grading {

/// Whether two names mean one file, wherever the root is.
bool same_file(const std::filesystem::path& a, const std::filesystem::path& b);

/// A header of the book, by the name that the compiler knows it by.
struct HeaderText {
  std::string file;
  std::string text;
};

class ContractText {
 public:
  struct Header {
    std::string file;
    SourceText source;
  };

  /// @param shapes the plain shapes that contracts are written with
  ContractText(HeaderText contract, std::vector<HeaderText> shapes);

  [[nodiscard]] const Header& contract() const { return headers_.front(); }
  /// "ray_triangle.hpp"
  [[nodiscard]] std::string name() const;
  /// The contract, then the shapes.
  [[nodiscard]] const std::vector<Header>& headers() const { return headers_; }
  /// The header of this name; null if it is none of them.
  [[nodiscard]] const Header* header(const std::string& file) const;
  /// Whether the contract holds this text.
  [[nodiscard]] bool mentions(std::string_view text) const;

  /// The lines that declare a name (a function, a struct), to the end of the declaration.
  [[nodiscard]] std::optional<ContractLine> declaration_of(const std::string& name) const;
  /// The same, but only from the contract itself.
  [[nodiscard]] std::optional<ContractLine> declared_by_contract(const std::string& name) const;
  /// A line of the contract and those after it, to the end of the declaration.
  [[nodiscard]] ContractLine declaration_at(int line) const;
  /// The members of a struct, in order; empty if it is none of the headers'.
  [[nodiscard]] std::vector<std::string> members_of(const std::string& structure) const;

 private:
  std::vector<Header> headers_;
  mutable std::map<std::string, std::optional<ContractLine>> known_;  ///< what was asked before
};

}  // namespace contact::grading
