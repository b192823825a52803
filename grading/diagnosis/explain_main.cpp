// contact-explain: explains what a compiler said of one file. It reads the question from standard
// input and writes the answer, JSON, to standard output; `contact grade` runs it in a box, so that
// nothing that a submission makes a compiler say can hold up or harm the grader. Linked statically,
// it needs no library inside.

#include <array>
#include <cstdio>
#include <exception>
#include <string>

#include "explain_request.hpp"

namespace {

std::string standard_input() {
  std::string text;
  std::array<char, 65536> part{};
  while (const std::size_t count = std::fread(part.data(), 1, part.size(), stdin))
    text.append(part.data(), count);
  return text;
}

}  // namespace

int main() {
  try {
    const std::string told =
        contact::grading::explain(contact::grading::request_from(standard_input()));
    return std::fwrite(told.data(), 1, told.size(), stdout) == told.size() &&
                   std::fflush(stdout) == 0
               ? 0
               : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "contact-explain: %s\n", error.what());
    return 2;
  }
}
