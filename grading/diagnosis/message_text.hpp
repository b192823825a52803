#pragma once

// Small tools for reading compiler output. They use no regular expressions and no streams, which
// would double the size of the page's judge. Each takes time linear in its text, except readable(),
// whose input is at most max_message_bytes.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace contact::grading {

/// Of a message, no more than this many bytes are looked at.
inline constexpr std::size_t max_message_bytes = 8000;

std::vector<std::string> split_lines(std::string_view text);

/// The beginning of a text, at most `most` bytes of it and whole characters, with " ..." if there
/// was more.
std::string cut(std::string_view text, std::size_t most);

/// The first lines of a text that together have at most `most` bytes; of a first line that is
/// longer, its beginning.
std::string_view first_lines(std::string_view text, std::size_t most);

bool is_identifier_character(char c);

/// One past the > that closes the < at `open`; the end of the text if none does.
std::size_t end_of_brackets(std::string_view text, std::size_t open);

void replace_all(std::string& text, std::string_view from, std::string_view to);

/// Whether all of `text` is `pattern`, in which each {} stands for any characters, as few as
/// possible; `holes` becomes what they stand for.
bool matches(std::string_view pattern, std::string_view text, std::vector<std::string>& holes);

/// 'name' for each of ‘name’ (g++), `name' (bfd) and 'name' (clang++).
std::string with_plain_quotes(std::string text);

/// Without what a compiler adds of a type that has two names: " {aka ...}" (g++), " (aka '...')".
std::string without_aliases(std::string_view text);

/// Types as a reader writes them: Vector3<double>, not Eigen::Matrix<double, 3, 1, 0, 3, 1>;
/// std::optional<contact::Ray<double>>, not that and what it is short for.
std::string readable(std::string_view message);

/// A readable type without the const before it and the & after it.
std::string bare_type(std::string_view type);

/// The words that stand between plain quotes, each cut into its identifiers.
std::vector<std::string> quoted_names(std::string_view message);

/// EIGEN_STATIC_ASSERT spells its sentence in capitals: the sentence, or nothing.
std::string eigen_sentence(std::string_view message);

}  // namespace contact::grading
