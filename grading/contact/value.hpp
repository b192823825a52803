/// @file
/// What may cross a contract: plain values, whose parts can be visited without any code written for
/// the type.
///
/// Everything else here is deduced from that: the text of a value (value_text.hpp), its bytes
/// (value_bytes.hpp) and how two values are compared (value_compare.hpp).
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace contact {

/// How a value is made of others.
enum class Kind {
  none,  ///< not a value
  boolean,
  integer,  ///< int or std::int64_t
  real,     ///< double
  enumeration,
  text,      ///< std::string
  matrix,    ///< Eigen::Matrix or Eigen::Array of double, fixed-size or not
  rotation,  ///< Eigen::Quaternion of double
  sequence,  ///< std::vector or std::array
  optional,
  variant,
  aggregate  ///< a struct with public members only
};

namespace value_detail {

template <class T>
struct IsVector : std::false_type {};
template <class T, class A>
struct IsVector<std::vector<T, A>> : std::true_type {};
template <class T>
struct IsArray : std::false_type {};
template <class T, std::size_t N>
struct IsArray<std::array<T, N>> : std::bool_constant<(N > 0)> {};
template <class T>
struct IsOptional : std::false_type {};
template <class T>
struct IsOptional<std::optional<T>> : std::true_type {};
template <class T>
struct IsVariant : std::false_type {};
template <class... T>
struct IsVariant<std::variant<T...>> : std::true_type {};
template <class T>
struct IsMatrix : std::false_type {};
template <int R, int C, int O, int MR, int MC>
struct IsMatrix<Eigen::Matrix<double, R, C, O, MR, MC>> : std::true_type {};
template <int R, int C, int O, int MR, int MC>
struct IsMatrix<Eigen::Array<double, R, C, O, MR, MC>> : std::true_type {};
template <class T>
struct IsRotation : std::false_type {};
template <int O>
struct IsRotation<Eigen::Quaternion<double, O>> : std::true_type {};

// Stand-ins for "some initialiser" while members are counted. std::optional needs its own: it can
// be made both from an optional and from what it holds, so that one stand-in for everything would
// be ambiguous.
struct Anything {
  template <class T>
  requires(!IsOptional<T>::value) operator T() const;
};
struct AnyOptional {
  template <class T>
  operator std::optional<T>() const;
};

template <class T, class... Initialisers>
concept BraceConstructible = requires {
  T{Initialisers{}...};
};

inline constexpr std::size_t kMaxFields = 12;

template <class T, class... Initialisers>
consteval std::size_t count_fields() {
  if constexpr (sizeof...(Initialisers) > kMaxFields) {
    return sizeof...(Initialisers);
  } else if constexpr (BraceConstructible<T, Initialisers..., AnyOptional>) {
    return count_fields<T, Initialisers..., AnyOptional>();
  } else if constexpr (BraceConstructible<T, Initialisers..., Anything>) {
    return count_fields<T, Initialisers..., Anything>();
  } else {
    return sizeof...(Initialisers);
  }
}

}  // namespace value_detail

/// The number of members of an aggregate.
template <class T>
inline constexpr std::size_t field_count = value_detail::count_fields<T>();

/// References to the members of an aggregate, in order, as a std::tuple.
template <class T>
constexpr auto fields(T& value) {
  constexpr std::size_t n = field_count<std::remove_const_t<T>>;
  static_assert(n >= 1 && n <= value_detail::kMaxFields, "an aggregate value has 1 to 12 members");
  if constexpr (n == 1) {
    auto& [a] = value;
    return std::tie(a);
  } else if constexpr (n == 2) {
    auto& [a, b] = value;
    return std::tie(a, b);
  } else if constexpr (n == 3) {
    auto& [a, b, c] = value;
    return std::tie(a, b, c);
  } else if constexpr (n == 4) {
    auto& [a, b, c, d] = value;
    return std::tie(a, b, c, d);
  } else if constexpr (n == 5) {
    auto& [a, b, c, d, e] = value;
    return std::tie(a, b, c, d, e);
  } else if constexpr (n == 6) {
    auto& [a, b, c, d, e, f] = value;
    return std::tie(a, b, c, d, e, f);
  } else if constexpr (n == 7) {
    auto& [a, b, c, d, e, f, g] = value;
    return std::tie(a, b, c, d, e, f, g);
  } else if constexpr (n == 8) {
    auto& [a, b, c, d, e, f, g, h] = value;
    return std::tie(a, b, c, d, e, f, g, h);
  } else if constexpr (n == 9) {
    auto& [a, b, c, d, e, f, g, h, i] = value;
    return std::tie(a, b, c, d, e, f, g, h, i);
  } else if constexpr (n == 10) {
    auto& [a, b, c, d, e, f, g, h, i, j] = value;
    return std::tie(a, b, c, d, e, f, g, h, i, j);
  } else if constexpr (n == 11) {
    auto& [a, b, c, d, e, f, g, h, i, j, k] = value;
    return std::tie(a, b, c, d, e, f, g, h, i, j, k);
  } else {
    auto& [a, b, c, d, e, f, g, h, i, j, k, l] = value;
    return std::tie(a, b, c, d, e, f, g, h, i, j, k, l);
  }
}

/// Calls visit(member) for each member of an aggregate, in order.
template <class T, class Visit>
constexpr void for_each_field(T& value, Visit&& visit) {
  std::apply([&](auto&... field) { (visit(field), ...); }, fields(value));
}

namespace value_detail {

template <class T>
consteval Kind classify();

template <class T>
consteval bool all_fields_are_values() {
  constexpr std::size_t n = field_count<T>;
  if constexpr (n == 0 || n > kMaxFields) {
    return false;
  } else {
    return []<class... F>(std::type_identity<std::tuple<F&...>>) {
      return ((classify<F>() != Kind::none) && ...);
    }(std::type_identity<decltype(fields(std::declval<T&>()))>{});
  }
}

template <class T>
consteval bool all_alternatives_are_values() {
  return []<class... A>(std::type_identity<std::variant<A...>>) {
    return sizeof...(A) <= 255 && ((classify<A>() != Kind::none) && ...);
  }(std::type_identity<T>{});
}

// std::int64_t is another type on other machines, and `long` the same one on some: so a contract
// writes std::int64_t, and the contract generator refuses `long`.
template <class T>
consteval Kind classify() {
  if constexpr (std::is_same_v<T, bool>) {
    return Kind::boolean;
  } else if constexpr (std::is_same_v<T, int> || std::is_same_v<T, std::int64_t>) {
    return Kind::integer;
  } else if constexpr (std::is_same_v<T, double>) {
    return Kind::real;
  } else if constexpr (std::is_enum_v<T>) {
    // Only a scoped enumeration holds any number of its underlying type, so only that can be read
    // back safely.
    return std::is_convertible_v<T, std::underlying_type_t<T>> ? Kind::none : Kind::enumeration;
  } else if constexpr (std::is_same_v<T, std::string>) {
    return Kind::text;
  } else if constexpr (IsMatrix<T>::value) {
    return Kind::matrix;
  } else if constexpr (IsRotation<T>::value) {
    return Kind::rotation;
  } else if constexpr (IsVector<T>::value || IsArray<T>::value) {
    return classify<typename T::value_type>() == Kind::none ? Kind::none : Kind::sequence;
  } else if constexpr (IsOptional<T>::value) {
    return classify<typename T::value_type>() == Kind::none ? Kind::none : Kind::optional;
  } else if constexpr (IsVariant<T>::value) {
    return all_alternatives_are_values<T>() ? Kind::variant : Kind::none;
  } else if constexpr (std::is_class_v<T> && std::is_aggregate_v<T>) {
    return all_fields_are_values<T>() ? Kind::aggregate : Kind::none;
  } else {
    return Kind::none;
  }
}

}  // namespace value_detail

/// How T is made of other values; Kind::none if it is not a value.
template <class T>
inline constexpr Kind kind_of = value_detail::classify<T>();

/// A type that a contract may hold: bool, int, std::int64_t, double, a scoped enumeration,
/// std::string, an Eigen matrix, array or quaternion of double; a std::vector, std::array,
/// std::optional or std::variant of values; a struct of 1 to 12 public members that are values.
template <class T>
concept Value = std::semiregular<T> && kind_of<T>
!= Kind::none;

}  // namespace contact
