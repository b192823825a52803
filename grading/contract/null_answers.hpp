#pragma once

// Values that know nothing of the question, of any type that a contract may return: for `contact
// dev check`, which proves that they earn nothing and crash no test. Of what kind they are is said
// when the program is run, so that one program does for all kinds.

#include <cstdint>
#include <cstdlib>
#include <limits>
#include <string_view>
#include <type_traits>

#include <contact/value.hpp>

namespace contact {

enum class Null { zeros, nan, infinity, minus_infinity, huge, random, echo };

namespace null_detail {

// splitmix64: the same numbers on every machine.
inline std::uint64_t next_random() {
  static std::uint64_t state = 20;
  state += 0x9e3779b97f4a7c15u;
  std::uint64_t x = state;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

// What CONTACT_NULL_ANSWER names. A name that stands for none must not pass for one that does.
inline Null kind_named(std::string_view name) {
  if (name == "zeros") return Null::zeros;
  if (name == "nan") return Null::nan;
  if (name == "infinity") return Null::infinity;
  if (name == "minus_infinity") return Null::minus_infinity;
  if (name == "huge") return Null::huge;
  if (name == "random") return Null::random;
  if (name == "echo") return Null::echo;
  std::abort();
}

inline Null kind_asked_for() {
  const char* const name = std::getenv("CONTACT_NULL_ANSWER");
  return kind_named(name == nullptr ? "" : name);
}

inline double random_unit() { return static_cast<double>(next_random() >> 11) * 0x1p-53; }

inline double real(Null kind) {
  switch (kind) {
    case Null::nan:
      return std::numeric_limits<double>::quiet_NaN();
    case Null::infinity:
      return std::numeric_limits<double>::infinity();
    case Null::minus_infinity:
      return -std::numeric_limits<double>::infinity();
    case Null::huge:
      return std::numeric_limits<double>::max();
    case Null::random:
      return 20.0 * random_unit() - 10.0;
    case Null::zeros:
    case Null::echo:
      break;
  }
  return 0.0;
}

template <class T>
T integer(Null kind) {
  switch (kind) {
    case Null::infinity:
    case Null::huge:
      return std::numeric_limits<T>::max();
    case Null::minus_infinity:
      return std::numeric_limits<T>::min();
    case Null::nan:
      return T(-1);
    case Null::random:
      return static_cast<T>(next_random() % 8);
    case Null::zeros:
    case Null::echo:
      break;
  }
  return T(0);
}

inline int length(Null kind) {
  if (kind == Null::huge) return 10'000;
  return kind == Null::zeros || kind == Null::echo ? 0 : 3;
}

// Whether the optional, or the later alternative, is there. Zeros say "nothing", which is what a
// function returns that never looked.
inline bool present(Null kind) {
  return kind == Null::random ? next_random() % 2 == 0 : kind != Null::zeros && kind != Null::echo;
}

template <Value T>
T make(Null kind) {
  constexpr Kind of = kind_of<T>;
  if constexpr (of == Kind::boolean) {
    return present(kind);
  } else if constexpr (of == Kind::integer) {
    return integer<T>(kind);
  } else if constexpr (of == Kind::real) {
    return real(kind);
  } else if constexpr (of == Kind::enumeration) {
    // Also numbers that the enumeration does not name: a test that indexes by one must look first.
    return static_cast<T>(integer<int>(kind) % 128);
  } else if constexpr (of == Kind::text) {
    return std::string(static_cast<std::size_t>(length(kind)), 'x');
  } else if constexpr (of == Kind::matrix) {
    T result;
    if constexpr (T::SizeAtCompileTime == Eigen::Dynamic) {
      // Ten thousand numbers, not a square of ten thousand.
      result.resize(T::RowsAtCompileTime == Eigen::Dynamic ? length(kind) : T::RowsAtCompileTime,
                    T::ColsAtCompileTime == Eigen::Dynamic && T::RowsAtCompileTime != Eigen::Dynamic
                        ? length(kind)
                    : T::ColsAtCompileTime == Eigen::Dynamic ? 1
                                                             : T::ColsAtCompileTime);
    }
    for (Eigen::Index i = 0; i < result.size(); ++i) result.data()[i] = real(kind);
    return result;
  } else if constexpr (of == Kind::rotation) {
    return T(real(kind), real(kind), real(kind), real(kind));
  } else if constexpr (of == Kind::sequence) {
    T result{};
    if constexpr (requires { result.push_back(make<typename T::value_type>(kind)); }) {
      for (int i = 0; i < length(kind); ++i) result.push_back(make<typename T::value_type>(kind));
    } else {
      for (auto& part : result) part = make<typename T::value_type>(kind);
    }
    return result;
  } else if constexpr (of == Kind::optional) {
    if (!present(kind)) return std::nullopt;
    return make<typename T::value_type>(kind);
  } else if constexpr (of == Kind::variant) {
    constexpr std::size_t last = std::variant_size_v<T> - 1;
    if (present(kind))
      return T(std::in_place_index<last>, make<std::variant_alternative_t<last, T>>(kind));
    return T(std::in_place_index<0>, make<std::variant_alternative_t<0, T>>(kind));
  } else {
    T result{};
    for_each_field(result,
                   [&](auto& part) { part = make<std::remove_cvref_t<decltype(part)>>(kind); });
    return result;
  }
}

template <class T, class Argument>
void echo_into(T& result, bool& done, const Argument& argument) {
  if (done) return;
  if constexpr (std::is_same_v<Argument, T>) {
    result = argument;
    done = true;
  }
}

}  // namespace null_detail

/// A value of T that is of the kind asked for, or for echo the first argument of that type (else
/// zeros).
template <class T, class... Arguments>
T null_answer(int, const Arguments&... arguments) {
  static const Null kind = null_detail::kind_asked_for();
  T result = null_detail::make<T>(kind);
  [[maybe_unused]] bool done = kind != Null::echo;
  (null_detail::echo_into(result, done, arguments), ...);
  return result;
}

}  // namespace contact
