#pragma once

/// @file
/// One C++ source for a live figure: the page runs it as WebAssembly, the tests and the fallback
/// picture run it as a native program.
///
/// A figure is a struct of inputs, a struct of outputs, a function between them, and one line that
/// lists the fields:
///
///     struct Input { contact::Vector3<double> centre; double radius; };
///     struct Output { double problem, touching; contact::Vector3<double> nearest; };
///
///     Output compute(const Input& in) {
///       Output out{};
///       if (in.radius <= 0) out.problem = contact::figure::not_positive;
///       if (out.problem != 0) return out;
///       ...
///     }
///
///     FIGURE(Input, FIELDS(centre, radius), Output, FIELDS(problem, touching, nearest))
///
/// - A field is a `double`, an Eigen column of fixed size, or a `std::array` of fields. Every field
///   of the struct is listed (checked when it compiles).
/// - `Output` has a field `double problem`: 0, or the reason why there is no answer. A number that
/// is
///   not finite never reaches `compute`: the figure answers `not_finite`, all other outputs 0.
/// - An output that `compute` leaves alone is 0: figures are compiled with Eigen's vectors zeroed.
/// - `compute` does not throw: check what a factory would refuse, and answer with a `problem`. If
/// it
///   throws all the same, the page shows the message in place of the numbers.
/// - An output may be a NaN or an infinity (a ray that never arrives): the page shows it as such.
///
/// In WebAssembly the figure exports `layout()` (JSON text), `input()` and `output()` (addresses of
/// the numbers, flat, in the order of the fields) and `compute()`. Natively its `main` reads one
/// JSON object a line, {"centre": [0, 0, 2], "radius": [1]}, and prints the outputs the same way,
/// with 17 digits; `--layout` prints the layout. A program that wants the function alone defines
/// CONTACT_FIGURE_NO_MAIN first.

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <tuple>
#include <type_traits>

namespace contact::figure {

/// Reasons why a figure has no answer; the text that goes with each is in `problem_texts`.
inline constexpr double no_problem = 0;
inline constexpr double not_finite = 1;
inline constexpr double zero_normal = 2;
inline constexpr double zero_direction = 3;
inline constexpr double zero_area = 4;
inline constexpr double not_positive = 5;
inline constexpr double coincident_points = 6;
inline constexpr double collinear_points = 7;
inline constexpr double too_large = 8;
inline constexpr double too_small = 9;

/// What the page says for each code, by number.
inline constexpr std::array<std::string_view, 10> problem_texts{
    "",
    "a number is missing or not finite",
    "the normal has no length, so it has no direction",
    "the direction has no length",
    "the triangle has no area",
    "a size must be greater than zero",
    "two of the points are the same point",
    "the points lie on one line",
    "a number is too large to calculate with",
    "a number is too small to calculate with",
};

namespace detail {

/// How many doubles a field holds; 0 for a type that is not a field.
template <typename T>
inline constexpr int numbers_in = 0;
template <>
inline constexpr int numbers_in<double> = 1;
template <int Rows>
inline constexpr int numbers_in<Eigen::Matrix<double, Rows, 1>> = Rows > 0 ? Rows : 0;
template <typename T, std::size_t Size>
inline constexpr int numbers_in<std::array<T, Size>> = static_cast<int>(Size) * numbers_in<T>;

template <typename Struct, typename T>
struct Field {
  static_assert(numbers_in<T> > 0,
                "a figure's field is a double, a fixed Eigen column or an array");
  static constexpr int size = numbers_in<T>;
  std::string_view name;
  T Struct::*member;
};
template <typename Struct, typename T>
Field(std::string_view, T Struct::*) -> Field<Struct, T>;

/// Calls `visit(double&)` for each number of a field, in order.
template <typename T, typename Visit>
constexpr void each_number(T& value, const Visit& visit) {
  if constexpr (std::is_same_v<std::remove_const_t<T>, double>) {
    visit(value);
  } else {
    for (int i = 0; i < static_cast<int>(value.size()); ++i) {
      // An Eigen column counts with Eigen::Index, an array with size_t.
      if constexpr (requires { value.rows(); })
        each_number(value[i], visit);
      else
        each_number(value[static_cast<std::size_t>(i)], visit);
    }
  }
}

template <typename Fields>
constexpr int total_size(const Fields& fields) {
  return std::apply([](const auto&... field) { return (0 + ... + field.size); }, fields);
}

template <typename Fields>
constexpr bool has_problem(const Fields& fields) {
  return std::apply(
      [](const auto&... field) { return (... || (field.name == "problem" && field.size == 1)); },
      fields);
}

/// Whether the fields in the list account for every byte of the struct.
template <typename Struct, typename Fields>
constexpr bool lists_everything(const Fields& fields) {
  return sizeof(Struct) == sizeof(double) * static_cast<std::size_t>(total_size(fields));
}

/// Writes the layout as JSON through `put(char)`: names and sizes of the inputs and outputs, and
/// the text of each problem.
template <typename Inputs, typename Outputs, typename Put>
constexpr void write_layout(const Inputs& inputs, const Outputs& outputs, Put put) {
  const auto text = [&put](std::string_view words) {
    for (const char c : words) put(c);
  };
  const auto number = [&put](int n, const auto& self) -> void {
    if (n > 9) self(n / 10, self);
    put(static_cast<char>('0' + n % 10));
  };
  const auto list = [&](const auto& fields) {
    bool first = true;
    const auto entry = [&](const auto& field) {
      text(first ? R"({"name":")" : R"(,{"name":")");
      text(field.name);
      text(R"(","size":)");
      number(field.size, number);
      text("}");
      first = false;
    };
    std::apply([&](const auto&... field) { (entry(field), ...); }, fields);
  };
  text(R"({"inputs":[)");
  list(inputs);
  text(R"(],"outputs":[)");
  list(outputs);
  text(R"(],"problems":[)");
  for (std::size_t i = 0; i < problem_texts.size(); ++i) {
    text(i == 0 ? "\"" : ",\"");
    text(problem_texts[i]);
    text("\"");
  }
  text("]}");
}

/// A figure, made by FIGURE: its fields, its layout as text, and its run from numbers to numbers.
template <typename In, typename Out, auto in_fields, auto out_fields, Out (*function)(const In&)>
struct Figure {
  static constexpr auto inputs = in_fields(std::type_identity<In>{});
  static constexpr auto outputs = out_fields(std::type_identity<Out>{});
  static constexpr int input_size = total_size(inputs);
  static constexpr int output_size = total_size(outputs);

  static_assert(lists_everything<In>(inputs), "FIELDS leaves out a field of the figure's input");
  static_assert(lists_everything<Out>(outputs), "FIELDS leaves out a field of the figure's output");
  static_assert(has_problem(outputs), "the output of a figure has a field `double problem`");

  static constexpr std::size_t layout_length = [] {
    std::size_t length = 0;
    write_layout(inputs, outputs, [&length](char) { ++length; });
    return length;
  }();
  static constexpr std::array<char, layout_length + 1> layout = [] {
    std::array<char, layout_length + 1> text{};
    std::size_t length = 0;
    write_layout(inputs, outputs, [&](char c) { text[length++] = c; });
    return text;
  }();

  /// Reads `input_size` numbers, computes, writes `output_size` numbers.
  static void run(const double* from, double* to) {
    bool finite = true;
    for (int i = 0; i < input_size; ++i) finite = finite && std::isfinite(from[i]);
    if (!finite) {
      std::apply(
          [&](const auto&... field) {
            const auto blank = [&to](std::string_view name, int size) {
              for (int i = 0; i < size; ++i) *to++ = name == "problem" ? not_finite : 0.0;
            };
            (blank(field.name, field.size), ...);
          },
          outputs);
      return;
    }
    In in{};
    const auto read = [&from](double& number) { number = *from++; };
    std::apply([&](const auto&... field) { (each_number(in.*field.member, read), ...); }, inputs);
    const Out out = function(in);
    const bool answered = out.problem == no_problem;
    const auto give = [&](std::string_view name, const auto& field) {
      each_number(field, [&](const double& number) {
        *to++ = answered || name == "problem" ? number : 0.0;
      });
    };
    std::apply([&](const auto&... field) { (give(field.name, out.*field.member), ...); }, outputs);
  }
};

}  // namespace detail
}  // namespace contact::figure

// FIELDS(a, b) becomes a function of the struct that returns its members with their names. The
// macros before it repeat a macro over a list: each EXPAND rescans, so the list may be 85 fields
// long.
#define CONTACT_FIGURE_PARENTHESES ()
#define CONTACT_FIGURE_EXPAND(...) \
  CONTACT_FIGURE_EXPAND3(          \
      CONTACT_FIGURE_EXPAND3(CONTACT_FIGURE_EXPAND3(CONTACT_FIGURE_EXPAND3(__VA_ARGS__))))
#define CONTACT_FIGURE_EXPAND3(...) \
  CONTACT_FIGURE_EXPAND2(           \
      CONTACT_FIGURE_EXPAND2(CONTACT_FIGURE_EXPAND2(CONTACT_FIGURE_EXPAND2(__VA_ARGS__))))
#define CONTACT_FIGURE_EXPAND2(...) \
  CONTACT_FIGURE_EXPAND1(           \
      CONTACT_FIGURE_EXPAND1(CONTACT_FIGURE_EXPAND1(CONTACT_FIGURE_EXPAND1(__VA_ARGS__))))
#define CONTACT_FIGURE_EXPAND1(...) __VA_ARGS__
#define CONTACT_FIGURE_FIELD(name) ::contact::figure::detail::Field(#name, &T::name)
#define CONTACT_FIGURE_LIST(name, ...) \
  CONTACT_FIGURE_FIELD(name)           \
  __VA_OPT__(, CONTACT_FIGURE_LIST_AGAIN CONTACT_FIGURE_PARENTHESES(__VA_ARGS__))
#define CONTACT_FIGURE_LIST_AGAIN() CONTACT_FIGURE_LIST

/// The fields of a figure's struct, in the order in which the page sees them.
#define FIELDS(...)                                                             \
  []<typename T>(std::type_identity<T>) {                                       \
    return std::tuple(CONTACT_FIGURE_EXPAND(CONTACT_FIGURE_LIST(__VA_ARGS__))); \
  }

/// Makes a figure of `Output compute(const Input&)`, declared before this line.
#define FIGURE(In, in_fields, Out, out_fields)                                                   \
  using TheFigure = ::contact::figure::detail::Figure<In, Out, in_fields, out_fields, &compute>; \
  CONTACT_FIGURE_ENTRY(TheFigure)

#if !defined(CONTACT_FIGURE_NO_MAIN) && !defined(EIGEN_INITIALIZE_MATRICES_BY_ZERO)
#error \
    "compile figures with -DEIGEN_INITIALIZE_MATRICES_BY_ZERO: `Output out{}` leaves vectors unset"
#endif

#if defined(CONTACT_FIGURE_NO_MAIN)
#define CONTACT_FIGURE_ENTRY(TheFigure)
#elif defined(__wasm__)
#include "figure_wasm.hpp"
#else
#include "figure_native.hpp"
#endif
