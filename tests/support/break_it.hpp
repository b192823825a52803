/// @file
/// How the tests of an exercise that breaks code ask: the answer is an input, and right if the
/// given code is wrong there.
///
///     break_it<Points>("Which points does the given hull get wrong?")
///         .rule("every coordinate is a whole number", are_whole)
///         .suspect_if("points-in-general-position", no_three_collinear)
///         .input("points", [] { return exercise::whole_points(); })
///         .judge([](const Points& points) { return Judged{...}; });
///
/// An input that breaks a rule is not judged, so a judge only sees inputs that all rules allow.
/// What is right is computed from the input by the tests' own oracle. The report shows the input,
/// what the given code answers, the right answer and the difference; a passing test shows them too.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <support/exercise.hpp>

namespace contact::testing {

/// What the given code and the oracle say of one input.
struct Judged {
  bool wrong = false;      ///< the given code's answer is outside what is allowed
  std::string given;       ///< the given code's answer, as text
  std::string right;       ///< the right answer, as text
  std::string difference;  ///< in what they differ, and by how much: whole sentences
  /// The answers differ, and by no more than rounding may do.
  bool within_rounding = false;
};

/// Whether every number of a value is finite.
template <Value T>
bool all_finite(const T& value) {
  const auto finite = [](double a, double) { return std::isfinite(a); };
  return agree(value, value, finite);
}

/// Whether every number of a value has at most this magnitude. NaN has none.
template <Value T>
bool all_within(const T& value, double limit) {
  const auto small = [&](double a, double) { return std::abs(a) <= limit; };
  return agree(value, value, small);
}

/// Whether every number of a value is a whole number.
template <Value T>
bool all_whole(const T& value) {
  const auto whole = [](double a, double) { return a == std::floor(a); };
  return agree(value, value, whole);
}

template <Value T>
class GivenInput;

/// One question of an exercise that breaks code.
template <Value T>
class BreakIt {
 public:
  explicit BreakIt(std::string_view question) : question_(question) {}

  /// A condition on the input; `says` is a clause that states it.
  BreakIt&& rule(std::string says, std::function<bool(const T&)> holds) && {
    rules_.push_back({std::move(says), std::move(holds)});
    return std::move(*this);
  }

  /// A misconception that shows in an input on which the given code is right.
  BreakIt&& suspect_if(std::string misconception, std::function<bool(const T&)> looks_like) && {
    suspects_.push_back({std::move(misconception), std::move(looks_like)});
    return std::move(*this);
  }

  /// Calls the student's function for the input.
  template <class Call>
  GivenInput<T> input(std::string_view name, Call&& call) &&;

 private:
  friend class GivenInput<T>;
  struct Named {
    std::string name;
    std::function<bool(const T&)> holds;
  };
  std::string question_;
  std::vector<Named> rules_, suspects_;
};

/// The student's input, to be judged once.
template <Value T>
class GivenInput {
 public:
  GivenInput(BreakIt<T> question, std::string_view name, T input)
      : question_(std::move(question)), input_(std::move(input)) {
    report_.asked = question_.question_;
    report_.inputs.emplace_back(name, text_of(input_));
  }

  /// `of` says what the given code and the oracle answer. It is called only if all rules hold.
  template <class Judge>
  void judge(Judge&& of) && {
    for (const auto& rule : question_.rules_) {
      if (rule.holds(input_)) continue;
      report_.right = "an input for which this holds: " + rule.name;
      report_.reason = "It does not hold for this input, so the given code was not asked.";
      report_.misconception = "break-outside-the-region";
      detail::fail(std::move(report_));
    }
    const Judged judged = of(std::as_const(input_));
    report_.inputs.emplace_back("given code", judged.given);
    report_.right = judged.right;
    report_.reason = judged.difference;
    if (judged.wrong) {
      detail::show(std::move(report_));
      return;
    }
    const auto suspect = std::find_if(question_.suspects_.begin(), question_.suspects_.end(),
                                      [&](const auto& one) { return one.holds(input_); });
    if (judged.within_rounding)
      report_.misconception = "break-within-rounding";
    else if (suspect != question_.suspects_.end())
      report_.misconception = suspect->name;
    detail::fail(std::move(report_));
  }

 private:
  BreakIt<T> question_;
  T input_;
  Failure report_;
};

template <Value T>
template <class Call>
GivenInput<T> BreakIt<T>::input(std::string_view name, Call&& call) && {
  const detail::Asked asked{question_, {}};
  std::optional<T> input;
  const detail::Ending ending = detail::run(asked, [&] { input.emplace(call()); });
  if (!input) {
    Failure report;
    report.asked = question_;
    report.got = ending.thrown;
    report.right = "an input";
    detail::fail(std::move(report));
  }
  return {std::move(*this), name, std::move(*input)};
}

/// Starts a question. `question` is a whole sentence, as the student reads it.
template <Value T>
BreakIt<T> break_it(std::string_view question) {
  return BreakIt<T>(question);
}

}  // namespace contact::testing
