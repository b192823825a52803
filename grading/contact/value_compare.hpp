/// @file
/// Whether two values agree, double by double.
#pragma once

#include <contact/value.hpp>

namespace contact {

/// Whether x and y have the same structure and everything but their doubles is equal, and
/// doubles_agree(a, b) holds for each pair of doubles, visited in order.
template <Value T, class DoublesAgree>
bool agree(const T& x, const T& y, DoublesAgree& doubles_agree) {
  constexpr Kind kind = kind_of<T>;
  if constexpr (kind == Kind::real) {
    return doubles_agree(x, y);
  } else if constexpr (kind == Kind::matrix) {
    if (x.rows() != y.rows() || x.cols() != y.cols()) return false;
    for (Eigen::Index j = 0; j < x.cols(); ++j) {
      for (Eigen::Index i = 0; i < x.rows(); ++i) {
        if (!doubles_agree(x(i, j), y(i, j))) return false;
      }
    }
    return true;
  } else if constexpr (kind == Kind::rotation) {
    return doubles_agree(x.w(), y.w()) && doubles_agree(x.x(), y.x()) &&
           doubles_agree(x.y(), y.y()) && doubles_agree(x.z(), y.z());
  } else if constexpr (kind == Kind::sequence) {
    if (x.size() != y.size()) return false;
    for (std::size_t i = 0; i < x.size(); ++i) {
      const typename T::value_type& a = x[i];
      const typename T::value_type& b = y[i];
      if (!agree(a, b, doubles_agree)) return false;
    }
    return true;
  } else if constexpr (kind == Kind::optional) {
    if (x.has_value() != y.has_value()) return false;
    return !x || agree(*x, *y, doubles_agree);
  } else if constexpr (kind == Kind::variant) {
    if (x.index() != y.index() || x.valueless_by_exception()) return false;
    return std::visit(
        [&](const auto& a) {
          using A = std::remove_cvref_t<decltype(a)>;
          return agree(a, *std::get_if<A>(&y), doubles_agree);
        },
        x);
  } else if constexpr (kind == Kind::aggregate) {
    const auto xs = fields(x);
    const auto ys = fields(y);
    return [&]<std::size_t... I>(std::index_sequence<I...>) {
      return (agree(std::get<I>(xs), std::get<I>(ys), doubles_agree) && ...);
    }
    (std::make_index_sequence<field_count<T>>{});
  } else {
    return x == y;
  }
}

/// Whether x and y are equal; doubles by ==, so 0 and -0 are equal and NaN equals nothing.
template <Value T>
bool equal(const T& x, const T& y) {
  const auto same = [](double a, double b) { return a == b; };
  return agree(x, y, same);
}

}  // namespace contact
