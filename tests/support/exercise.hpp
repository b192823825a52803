/// @file
/// How an exercise's tests ask: one sentence that carries the question, its input, the student's
/// answer, the right answer, and the wrong formulae that people are known to use.
///
///     ask("Where does the ray meet the triangle?")
///         .given("ray", ray)
///         .given("triangle", triangle)
///         .suspect("beta-sign", [&] { return with_beta_negated(ray, triangle); })
///         .answer([&] { return exercise::ray_triangle(ray, triangle); })
///         .close_to(expected, within(bound));
///
/// The first answer that is not right ends its test case. Nothing about what is right may come from
/// the answer.
#pragma once

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <contact/value_compare.hpp>
#include <contact/value_text.hpp>
#include <support/failure.hpp>
#include <support/observed.hpp>

namespace contact::testing {

/// The failure of the test that runs now or has just ended, or nullptr.
const Failure* current_failure();
/// What a passing test of the present run has to show, or nullptr (break_it.hpp).
const Failure* current_finding();
void forget_failure();

/// The question whose answer is being computed, with its inputs: what to say when that never ends
/// or crashes. Empty between questions.
Failure open_question();

/// Calls `tell` each time that a question opens: for a host that can only end the program from
/// outside, and cannot ask it afterwards. Slow.
void tell_questions(std::function<void()> tell);

/// What random inputs start from: CONTACT_SEED of the environment, any text, so that a grader can
/// use a secret one; without it (or empty) always the same. `stream` keeps the numbers of one test
/// apart from those of another.
std::uint64_t seed(std::uint64_t stream);

/// How far an answer may be from the right one.
class Within {
 public:
  Within(std::vector<double> bounds, std::string text)
      : bounds_(std::move(bounds)), text_(std::move(text)) {}
  double bound(std::size_t i) const { return bounds_.size() == 1 ? bounds_[0] : bounds_.at(i); }
  /// The same for an answer that may have more numbers than the right one.
  double strictest(std::size_t i) const {
    return bounds_.empty()      ? 0
           : i < bounds_.size() ? bounds_[i]
                                : *std::min_element(bounds_.begin(), bounds_.end());
  }
  const std::string& text() const { return text_; }

 private:
  std::vector<double> bounds_;
  std::string text_;
};

/// Each number may be off by `tolerance`.
Within within(double tolerance);

/// Each number may be off by the number in its place in `tolerance`, a value of the same shape as
/// the answer.
template <Value T>
requires(!std::is_same_v<T, double>) Within within(const T& tolerance) {
  std::vector<double> bounds;
  const auto collect = [&](double bound, double) {
    bounds.push_back(bound);
    return true;
  };
  agree(tolerance, tolerance, collect);
  return {std::move(bounds), text_of(tolerance, {.digits = 2})};
}

namespace detail {

struct Given {
  std::string_view name;
  const void* value;
  std::string (*text)(const void*, const TextLimits&);
};

struct Asked {
  std::string_view question;
  std::vector<Given> givens;
};

/// How the student's function ended: `thrown` is empty if it returned.
struct Ending {
  std::string thrown;
  bool invalid_argument = false;
  bool told = false;  ///< the failure, in a closer look, which goes on
};

/// Runs the call and catches what it throws. Exceptions of the test program itself are passed on.
Ending run(const Asked& asked, const std::function<void()>& call);

/// Ends the test; a closer look goes on.
void fail(const Asked& asked, std::string got, std::string right, std::string allowed,
          std::vector<std::string> misconceptions, std::string observed);

/// The answer is right.
void pass(const Asked& asked);

/// Wrong formulae that a right answer to this question has ruled out, for the whole run: what the
/// student's function computes is not what they compute. `nth` counts those of one misconception.
bool refuted(const Asked& asked, std::string_view misconception, std::size_t nth);
void refute(const Asked& asked, std::string_view misconception, std::size_t nth);

/// The same with everything said by the caller. `show` ends no test: the report is of one that
/// passes.
[[noreturn]] void fail(Failure report);
void show(Failure report);

template <class C, class A>
std::type_identity<std::remove_cvref_t<A>> parameter_of(bool (C::*)(A) const);

}  // namespace detail

/// A misconception and how its answer is known: by what a wrong formula gives here (`wrong`), or by
/// a predicate on the answer (`looks_like`), which must imply what the misconception's hint states.
/// If the answer is wrong, all suspects are asked, so that an answer that several mistakes give is
/// not put down to one. A right answer to a question rules out each formula that is wrong there for
/// the rest of the run.
template <class T>
struct Suspect {
  std::string_view misconception;
  std::function<T()> wrong;
  std::function<bool(const T&)> looks_like;

  Suspect(std::string_view id, std::function<T()> formula)
      : misconception(id), wrong(std::move(formula)) {}
  Suspect(std::string_view id, std::function<bool(const T&)> look)
      : misconception(id), looks_like(std::move(look)) {}
};

/// The student's answer, to be judged once.
template <Value T>
class Answer {
 public:
  template <class Call>
  Answer(detail::Asked asked, std::vector<Suspect<T>> suspects, Call&& call)
      : asked_(std::move(asked)), suspects_(std::move(suspects)) {
    ending_ = detail::run(asked_, [&] { answer_.emplace(call()); });
  }

  /// Every part is the same; NaN equals nothing.
  void equals(const T& expected) && { judge(expected, Within({0}, "")); }

  /// Every number is as near as `allowed` says, and everything else is the same. NaN is near
  /// nothing.
  void close_to(const T& expected, const Within& allowed) && { judge(expected, allowed); }

  /// pred(answer) holds; `says` completes the sentence "Right is an answer that ...".
  template <class Predicate>
  void satisfies(std::string_view says, Predicate&& pred) && {
    const auto is_right = [&](const T& wrong) { return pred(wrong); };
    if (answer_ && is_right(*answer_)) return rule_out(is_right);
    fail(std::string{says}, "", Within({0}, ""), is_right, "");
  }

  /// The call throws std::invalid_argument.
  void throws_invalid_argument() && {
    if (ending_.invalid_argument) return detail::pass(asked_);
    fail(
        "throws std::invalid_argument", "", Within({0}, ""), [](const T&) { return false; },
        answer_ ? "You return an answer for input that the contract refuses." : "");
  }

 private:
  detail::Asked asked_;
  std::vector<Suspect<T>> suspects_;
  std::optional<T> answer_;
  detail::Ending ending_;

  void judge(const T& expected, const Within& allowed) {
    const auto is_right = [&](const T& wrong) { return close(wrong, expected, allowed); };
    if (answer_ && is_right(*answer_)) return rule_out(is_right);
    bool has_numbers = false;
    const auto number = [&](double, double) { return has_numbers = true; };
    agree(expected, expected, number);
    std::string seen;
    if (answer_) {
      seen = observed(leaves_of(*answer_), leaves_of(expected),
                      [&](std::size_t i, double a, double b) {
                        return a == b || std::abs(a - b) <= allowed.strictest(i);
                      });
    }
    fail(text_of(expected), has_numbers ? allowed.text() : "", allowed, is_right, seen);
  }

  static bool close(const T& x, const T& y, const Within& allowed, bool nan_is_nan = false) {
    std::size_t i = 0;
    const auto near = [&](double a, double b) {
      const double bound = allowed.bound(i++);
      return a == b || std::abs(a - b) <= bound || (nan_is_nan && a != a && b != b);
    };
    return agree(x, y, near);
  }

  template <class Right>
  void fail(std::string right, std::string text, const Within& allowed, Right&& is_right,
            std::string seen) {
    if (ending_.told) return;
    std::vector<std::string> misconceptions;
    for_each_suspect([&](const Suspect<T>& suspect, std::size_t nth) {
      const bool known = std::find(misconceptions.begin(), misconceptions.end(),
                                   suspect.misconception) != misconceptions.end();
      if (answer_ && !known && !detail::refuted(asked_, suspect.misconception, nth) &&
          recognised(suspect, allowed, is_right))
        misconceptions.emplace_back(suspect.misconception);
    });
    detail::fail(asked_, answer_ ? text_of(*answer_) : ending_.thrown, std::move(right),
                 std::move(text), std::move(misconceptions), std::move(seen));
  }

  template <class Use>
  void for_each_suspect(Use use) const {
    for (std::size_t i = 0; i < suspects_.size(); ++i) {
      std::size_t nth = 0;
      for (std::size_t j = 0; j < i; ++j)
        nth += suspects_[j].misconception == suspects_[i].misconception;
      use(suspects_[i], nth);
    }
  }

  // The answer is right: a function that used a formula which is wrong here would have answered
  // otherwise.
  template <class Right>
  void rule_out(Right& is_right) const {
    detail::pass(asked_);
    for_each_suspect([&](const Suspect<T>& suspect, std::size_t nth) {
      if (suspect.looks_like || detail::refuted(asked_, suspect.misconception, nth)) return;
      try {
        if (!is_right(suspect.wrong())) detail::refute(asked_, suspect.misconception, nth);
      } catch (const std::exception&) {
        // It has no answer here, which says nothing about the student's.
      }
    });
  }

  // A wrong formula that happens to be right here explains nothing. One that breaks down is not
  // what the student used. To recognise a wrong answer (never to accept one), NaN is like NaN.
  template <class Right>
  bool recognised(const Suspect<T>& suspect, const Within& allowed, Right& is_right) const {
    if (suspect.looks_like) return suspect.looks_like(*answer_);
    try {
      const T wrong = suspect.wrong();
      return close(*answer_, wrong, allowed, true) && !is_right(wrong);
    } catch (const std::exception&) {
      return false;
    }
  }
};

/// Stands for the type of the answer until it is known.
struct NotAskedYet {};

/// A question, its input and the wrong formulae whose results would be recognised.
template <class T>
class Question {
 public:
  explicit Question(detail::Asked asked, std::vector<Suspect<T>> suspects = {})
      : asked_(std::move(asked)), suspects_(std::move(suspects)) {}

  /// One argument, shown if the answer is wrong. It must outlive the sentence.
  template <Value V>
  Question&& given(std::string_view name, const V& value) && {
    asked_.givens.push_back({name, &value, [](const void* v, const TextLimits& limits) {
                               return text_of(*static_cast<const V*>(v), limits);
                             }});
    return std::move(*this);
  }

  /// A misconception, and what it would answer here.
  template <class Wrong>
  auto suspect(std::string_view misconception, Wrong wrong) && {
    using R = std::invoke_result_t<Wrong>;
    if constexpr (std::is_same_v<T, NotAskedYet>) {
      std::vector<Suspect<R>> suspects;
      suspects.emplace_back(misconception, std::function<R()>(std::move(wrong)));
      return Question<R>(std::move(asked_), std::move(suspects));
    } else {
      static_assert(std::is_same_v<R, T>, "every suspect answers with the type of the answer");
      suspects_.emplace_back(misconception, std::function<T()>(std::move(wrong)));
      return std::move(*this);
    }
  }

  /// A misconception that shows in the answer itself: `looks_like(answer)` holds. It is a lambda
  /// that takes the answer by const reference, and captures what else it needs: the inputs, the
  /// right answer. Whatever the hint states about the answer, it tests.
  template <class LooksLike>
  auto suspect_if(std::string_view misconception, LooksLike looks_like) && {
    using R = decltype(detail::parameter_of(&LooksLike::operator()));
    static_assert(std::is_same_v<T, NotAskedYet> || std::is_same_v<T, typename R::type>,
                  "every suspect is about the type of the answer");
    std::vector<Suspect<typename R::type>> suspects;
    if constexpr (!std::is_same_v<T, NotAskedYet>) suspects = std::move(suspects_);
    suspects.emplace_back(misconception,
                          std::function<bool(const typename R::type&)>(std::move(looks_like)));
    return Question<typename R::type>(std::move(asked_), std::move(suspects));
  }

  /// Several at once, when a helper makes them.
  template <class R>
  Question<R> suspects(std::vector<Suspect<R>> several) && {
    static_assert(std::is_same_v<T, NotAskedYet>, "suspects() comes before suspect()");
    return Question<R>(std::move(asked_), std::move(several));
  }

  /// Calls the student's function. Its arguments and its judge must not depend on one another.
  template <class Call>
  auto answer(Call&& call) && {
    using R = std::remove_cvref_t<std::invoke_result_t<Call>>;
    if constexpr (std::is_same_v<T, NotAskedYet>) {
      return Answer<R>(std::move(asked_), {}, std::forward<Call>(call));
    } else {
      static_assert(std::is_same_v<R, T>, "every suspect answers with the type of the answer");
      return Answer<R>(std::move(asked_), std::move(suspects_), std::forward<Call>(call));
    }
  }

 private:
  detail::Asked asked_;
  std::vector<Suspect<T>> suspects_;
};

/// Starts a question. `question` is a whole sentence, as the student reads it.
inline Question<NotAskedYet> ask(std::string_view question) {
  return Question<NotAskedYet>({question, {}});
}

}  // namespace contact::testing
