#pragma once

// The book's Markdown and formulas as a terminal can show them.

#include <string>
#include <string_view>

namespace contact::cli {

/// Markdown without its marks: emphasis and links are their words, code stays between backticks,
/// formulas are as plain_formula makes them. A formula has no break inside.
std::string plain_text(std::string_view markdown);

/// A formula of TeX in one line of Unicode: "v₂′ = (1 + e) v₁ m₁/(m₁ + m₂)". A command that is not
/// known stays as it is.
std::string plain_formula(std::string_view tex);

}  // namespace contact::cli
