/// @file
/// What is true of a wrong answer whatever caused it: "right but for its sign", "one too many".
/// Said if no known mistake is recognised. Each sentence is checked against the right answer.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <contact/value_text.hpp>

namespace contact::testing {

/// A value as the list of what it consists of.
struct Leaves {
  struct Leaf {
    enum class Is { real, integer, other } is = Is::other;
    double number = 0;
    std::string text;   ///< if it is no number
    std::string name;   ///< "displacement" or "normal.x"; empty if the whole value is one leaf
    std::size_t entry;  ///< in which entry of the outermost list it is
  };
  std::vector<Leaf> all;
  std::string shape;        ///< without the length of the outermost list
  bool is_list = false;     ///< the value, or what an optional holds, is a list
  std::size_t entries = 0;  ///< of the outermost list
  bool nothing = false;     ///< an empty optional
};

/// What is true of the answer, in one or two sentences; empty if there is nothing to say. `near`
/// tells for the i-th of the doubles whether two numbers count as equal.
std::string observed(const Leaves& got, const Leaves& right,
                     const std::function<bool(std::size_t, double, double)>& near);

namespace detail {

template <Value T>
void collect(const T& value, const std::string& name, std::size_t entry, Leaves& to) {
  using Is = Leaves::Leaf::Is;
  constexpr Kind kind = kind_of<T>;
  const auto inner = [&](std::string_view part) {
    return name.empty() ? std::string{part} : name + "." + std::string{part};
  };
  if constexpr (kind == Kind::real || kind == Kind::integer) {
    to.all.push_back(
        {kind == Kind::real ? Is::real : Is::integer, static_cast<double>(value), "", name, entry});
    to.shape += 'n';
  } else if constexpr (kind == Kind::matrix) {
    constexpr std::string_view kAxes = "xyzw";
    for (Eigen::Index j = 0; j < value.cols(); ++j) {
      for (Eigen::Index i = 0; i < value.rows(); ++i) {
        const bool vector = value.cols() == 1 && value.rows() <= 4;
        const std::string part =
            vector ? std::string(1, kAxes[static_cast<std::size_t>(i)])
                   : "entry (" + std::to_string(i) + ", " + std::to_string(j) + ")";
        to.all.push_back({Is::real, value(i, j), "", inner(part), entry});
      }
    }
    to.shape += 'm' + std::to_string(value.rows()) + 'x' + std::to_string(value.cols());
  } else if constexpr (kind == Kind::rotation) {
    for (const auto& [part, number] : {std::pair<const char*, double>{"w", value.w()},
                                       {"x", value.x()},
                                       {"y", value.y()},
                                       {"z", value.z()}})
      to.all.push_back({Is::real, number, "", inner(part), entry});
    to.shape += 'q';
  } else if constexpr (kind == Kind::sequence) {
    to.shape += '[';
    const bool outermost = to.all.empty() && to.shape == "[";
    if (outermost) {
      to.is_list = true;
      to.entries = value.size();
    } else {
      to.shape += std::to_string(value.size());
    }
    for (std::size_t i = 0; i < value.size(); ++i) {
      const typename T::value_type& one = value[i];
      const std::string shape = to.shape;
      collect(one, inner("entry " + std::to_string(i)), outermost ? i : entry, to);
      if (outermost) to.shape = shape;
    }
  } else if constexpr (kind == Kind::optional) {
    to.shape += value ? "+" : "-";
    to.nothing = to.all.empty() && !value;
    if (value) collect(*value, name, entry, to);
  } else if constexpr (kind == Kind::aggregate) {
    const auto parts = fields(value);
    to.shape += '{';
    [&]<std::size_t... I>(std::index_sequence<I...>) {
      (collect(std::get<I>(parts), inner(value_detail::field_name<T, I>()), entry, to), ...);
    }
    (std::make_index_sequence<field_count<T>>{});
    to.shape += '}';
  } else {
    to.all.push_back({Is::other, 0, text_of(value), name, entry});
    to.shape += 'o';
  }
}

}  // namespace detail

template <Value T>
Leaves leaves_of(const T& value) {
  Leaves leaves;
  detail::collect(value, "", 0, leaves);
  return leaves;
}

}  // namespace contact::testing
