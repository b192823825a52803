#include <array>
#include <cstdint>
#include <utility>

#include "../message_text.hpp"
#include "rules.hpp"

namespace contact::grading {

namespace {

// The first two different vectors or matrices that a message and its notes name.
std::vector<std::string> shapes_in(const Said& said) {
  std::string text = said.diagnostic.message;
  for (const Diagnostic& note : said.diagnostic.notes) text += " " + note.message;
  text = readable(std::move(text));
  std::vector<std::string> shapes;
  for (std::size_t at = 0; at < text.size() && shapes.size() < 2; ++at) {
    const std::string_view rest = std::string_view(text).substr(at);
    if ((!rest.starts_with("Vector") && !rest.starts_with("Matrix")) || rest.size() < 9 ||
        rest[7] != '<' || (at > 0 && is_identifier_character(text[at - 1])))
      continue;
    std::string shape(rest.substr(0, rest.find('>') + 1));
    if (shapes.empty() || shapes[0] != shape) shapes.push_back(std::move(shape));
  }
  return shapes;
}

std::optional<Mistake> eigen_sizes(const Said& said, const Holes&) {
  const std::vector<std::string> shapes = shapes_in(said);
  return Mistake{"eigen-sizes", shapes.size() == 2
                                    ? shapes[0] + " and " + shapes[1] +
                                          " are of different sizes and cannot be mixed."
                                    : "Vectors or matrices of different sizes are mixed here."};
}

}  // namespace

std::optional<Mistake> eigen_types(const Said&, const Holes& holes) {
  const std::string kinds =
      holes.size() > 3 ? holes[2] + " and " + holes[3] : std::string("different kinds of numbers");
  return Mistake{"eigen-types",
                 "Vectors of " + kinds +
                     " are mixed here. Make both of double; v.cast<double>() turns one into it."};
}

namespace {

std::optional<Mistake> eigen_product(const Said&, const Holes&) { return product_of_vectors(); }

constexpr std::array rules{
    Rule{"{}YOU_MIXED_MATRICES_OF_DIFFERENT_SIZES{}", {}, {}, eigen_sizes},
    Rule{"{}YOU_MIXED_DIFFERENT_NUMERIC_TYPES{}", {}, {}, eigen_types},
    Rule{"{}INVALID_VECTOR_VECTOR_PRODUCT{}", {}, {}, eigen_product},
};

}  // namespace

std::span<const Rule> rules_of_eigen() { return rules; }

}  // namespace contact::grading
