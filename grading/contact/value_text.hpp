/// @file
/// A value as a person reads it: `Ray{origin: (0, 0, 1), direction: (0, 0, -1)}`. Doubles are
/// printed with as many digits as bring back the same double, and no more.
#pragma once

#include <charconv>
#include <string>
#include <string_view>

#include <contact/value.hpp>

namespace contact {

/// How much of a long value is shown.
struct TextLimits {
  std::size_t elements = 24;     ///< of a sequence, or rows of a matrix
  std::size_t characters = 200;  ///< of a string
  int digits = 0;                ///< of a double; 0: as many as bring back the same double
};

namespace value_detail {

template <class T>
struct Holder {
  T value;
};

// Never defined: only the addresses of its members are named, at compile time, and a compiler
// spells them out.
template <class T>
extern const Holder<T> never_defined;

template <auto Pointer>
consteval std::string_view spelled() {
  return __PRETTY_FUNCTION__;
}

template <std::size_t I, class T>
constexpr auto* member_address(const T& value) {
  return &std::get<I>(fields(value));
}

// The identifier that ends the text up to the first `]` or `;` after "Pointer =":
// "...value.Ray::origin)]".
consteval std::string_view last_identifier(std::string_view text) {
  std::size_t end = text.find("Pointer = ");
  end = text.find_first_of(";]", end);
  const auto is_word = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
  };
  while (end > 0 && !is_word(text[end - 1])) --end;
  std::size_t begin = end;
  while (begin > 0 && is_word(text[begin - 1])) --begin;
  return text.substr(begin, end - begin);
}

template <class T, std::size_t I>
consteval std::string_view field_name() {
  return last_identifier(spelled<member_address<I>(never_defined<T>.value)>());
}

template <class T>
consteval std::string_view spelled_type() {
  return __PRETTY_FUNCTION__;
}

// "Ray" out of "... [with T = contact::Ray<double>; ...]".
template <class T>
consteval std::string_view type_name() {
  std::string_view text = spelled_type<T>();
  text.remove_prefix(text.find("T = ") + 4);
  text = text.substr(0, text.find_first_of("<;]"));
  const std::size_t colon = text.rfind(':');
  return colon == std::string_view::npos ? text : text.substr(colon + 1);
}

// An enumerator is spelled by its name, and any other number by a cast.
template <class E, E V>
consteval std::string_view spelled_enumerator() {
  return __PRETTY_FUNCTION__;
}

template <class E, E V>
consteval std::string_view enumerator_name() {
  std::string_view text = spelled_enumerator<E, V>();
  text.remove_prefix(text.find("V = ") + 4);
  text = text.substr(0, text.find_first_of(";]"));
  if (text.find('(') != std::string_view::npos) return {};
  const std::size_t colon = text.rfind(':');
  return colon == std::string_view::npos ? std::string_view{} : text.substr(colon + 1);
}

template <class E>
std::string enum_text(E value) {
  constexpr int kFirst = -2, kCount = 34;
  const auto number = static_cast<std::int64_t>(value);
  std::string_view name;
  [&]<int... I>(std::integer_sequence<int, I...>) {
    ((number == kFirst + I && std::in_range<std::underlying_type_t<E>>(kFirst + I)
          ? void(name = enumerator_name<E, static_cast<E>(kFirst + I)>())
          : void()),
     ...);
  }
  (std::make_integer_sequence<int, kCount>{});
  std::string text{type_name<E>()};
  return name.empty() ? text + '(' + std::to_string(number) + ')' : text + "::" + std::string{name};
}

inline std::string number_text(double x, const TextLimits& limits) {
  if (x != x) return "NaN";
  std::array<char, 40> buffer;
  char* const first = buffer.data();
  char* const last = first + buffer.size();
  const auto [end, error] =
      limits.digits == 0 ? std::to_chars(first, last, x)
                         : std::to_chars(first, last, x, std::chars_format::general, limits.digits);
  return std::string(first, end);
}

inline std::string quoted_text(std::string_view text, std::size_t most) {
  std::string result = "\"";
  for (const char c : text.substr(0, most)) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      result += '\\';
      result += c;
    } else if (code < 0x20 || code == 0x7f) {
      constexpr std::string_view kDigits = "0123456789abcdef";
      result += "\\x";
      result += kDigits[code >> 4];
      result += kDigits[code & 15];
    } else {
      result += c;
    }
  }
  result += '"';
  if (text.size() > most)
    result += " and " + std::to_string(text.size() - most) + " more characters";
  return result;
}

template <class M>
std::string matrix_text(const M& m, const TextLimits& limits) {
  const bool column = m.cols() == 1;
  std::string text = column ? "(" : "[";
  for (Eigen::Index i = 0; i < m.rows(); ++i) {
    if (i > 0) text += column ? ", " : "; ";
    if (static_cast<std::size_t>(i) >= limits.elements) {
      text += "and " + std::to_string(m.rows() - i) + " more";
      break;
    }
    for (Eigen::Index j = 0; j < m.cols(); ++j) {
      if (j > 0) text += ' ';
      text += number_text(m(i, j), limits);
    }
  }
  return text + (column ? ')' : ']');
}

}  // namespace value_detail

/// The value as text.
template <Value T>
std::string text_of(const T& value, const TextLimits& limits = {}) {
  using namespace value_detail;
  constexpr Kind kind = kind_of<T>;
  if constexpr (kind == Kind::boolean) {
    return value ? "true" : "false";
  } else if constexpr (kind == Kind::integer) {
    return std::to_string(value);
  } else if constexpr (kind == Kind::real) {
    return number_text(value, limits);
  } else if constexpr (kind == Kind::enumeration) {
    return enum_text(value);
  } else if constexpr (kind == Kind::text) {
    return quoted_text(value, limits.characters);
  } else if constexpr (kind == Kind::matrix) {
    return matrix_text(value, limits);
  } else if constexpr (kind == Kind::rotation) {
    return "Quaternion{w: " + number_text(value.w(), limits) +
           ", x: " + number_text(value.x(), limits) + ", y: " + number_text(value.y(), limits) +
           ", z: " + number_text(value.z(), limits) + '}';
  } else if constexpr (kind == Kind::sequence) {
    std::string text = "[";
    for (std::size_t i = 0; i < value.size(); ++i) {
      if (i > 0) text += ", ";
      if (i >= limits.elements) {
        text += "and " + std::to_string(value.size() - i) + " more";
        break;
      }
      const typename T::value_type& element = value[i];
      text += text_of(element, limits);
    }
    return text + ']';
  } else if constexpr (kind == Kind::optional) {
    return value ? text_of(*value, limits) : "nullopt";
  } else if constexpr (kind == Kind::variant) {
    if (value.valueless_by_exception()) return "valueless";
    return std::visit([&](const auto& alternative) { return text_of(alternative, limits); }, value);
  } else {
    std::string text{type_name<T>()};
    const auto all = fields(value);
    [&]<std::size_t... I>(std::index_sequence<I...>) {
      ((text += (I == 0 ? "{" : ", ") + std::string{field_name<T, I>()} + ": " +
                text_of(std::get<I>(all), limits)),
       ...);
    }
    (std::make_index_sequence<field_count<T>>{});
    return text + '}';
  }
}

}  // namespace contact
