/// @file
/// What a ladder (ladder.hpp) is to the native program and to the page: questions, methods and
/// their results, whatever its inputs and answers.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace ladder {

/// The comparison of one answer with the truth.
struct Verdict {
  bool wrong = false;
  bool undecided = false;       ///< the method says that it does not know
  double error = std::nan("");  ///< of the value; NaN where there is none to compare
};

struct Method {
  std::string id;
  std::string title;
  std::string scalar;        ///< the type that it computes in
  bool exact = false;        ///< whether its decision is never wrong
  bool recommended = false;  ///< set by recommend()
  std::string part = {};     ///< set by Parts: the question that it answers
};

/// A method outside the program: JavaScript in the page, which is asked in numbers and answers in
/// numbers. Natively it is not run.
struct Peer {
  std::string id;  ///< the page has the method under this name
  std::string title;
  std::string scalar;
  std::size_t asks = 1;   ///< numbers of a question
  std::size_t tells = 1;  ///< numbers of an answer
  std::string part = {};  ///< set by Parts: the question that it answers
};

struct Family {
  std::string id;
  std::string title;
  bool by_error = false;  ///< shown by its largest error even if some method is wrong
  std::string part = {};  ///< set by Parts: the question
};

/// What a method made of one family.
struct Judgement {
  std::size_t n = 0, wrong = 0, undecided = 0;
  double error_median = std::nan(""), error_max = std::nan("");
};

/// Something told of an input or an answer: words, or numbers, written as their type writes them.
struct Fact {
  std::string name;
  std::string words = {};
  std::vector<double> values = {};
  bool in_float = false;
};

/// A field of a figure's input, as its C++ names it.
struct Field {
  std::string name;
  std::vector<double> values;
};

/// An input and two answers to it, as a reader sees them.
struct Example {
  std::vector<Fact> facts;
  std::string figure = {};  ///< NAME of the chapter's figure that shows the input; empty: none can
  std::vector<Field> fields = {};
  std::string note = {};  ///< what the figure shows differently, or why no figure can show it
};

/// The numbers of a vector, or of any other range.
template <class Numbers>
Fact numbers(std::string name, const Numbers& range) {
  Fact fact{std::move(name)};
  for (const auto& x : range) {
    fact.in_float = std::is_same_v<std::decay_t<decltype(x)>, float>;
    fact.values.push_back(static_cast<double>(x));
  }
  return fact;
}
template <class S>
Fact number(std::string name, S x) {
  return numbers(std::move(name), std::array<S, 1>{x});
}

/// A vector as a field of a figure.
template <class Numbers>
Field field(std::string name, const Numbers& range) {
  return {std::move(name), numbers("", range).values};
}

/// An input on which a method fails.
struct Failure {
  std::size_t input = 0;  ///< its index in the family
  bool simplified = false;
  Verdict verdict;
  Example example;
};

/// A median between its quartiles.
struct Spread {
  double median = 0, q1 = 0, q3 = 0;
};

/// The quartiles of at least one number, between neighbours by linear interpolation.
inline Spread spread(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const auto at = [&values](double share) {
    const double place = share * static_cast<double>(values.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, values.size() - 1);
    return values[below] + (place - static_cast<double>(below)) * (values[above] - values[below]);
  };
  return {at(0.5), at(0.25), at(0.75)};
}

/// A ladder whatever its inputs and answers: what the program and the page see.
class Experiment {
 public:
  virtual ~Experiment() = default;
  virtual const std::string& question() const = 0;
  virtual const std::vector<Family>& families() const = 0;
  virtual const std::vector<Method>& methods() const = 0;
  virtual const std::vector<Peer>& peers() const = 0;
  /// Makes n inputs and their true answers, or as many as the ladder makes at most: those of
  /// another block are other ones of the same family.
  virtual void prepare(std::size_t family, std::size_t n, std::uint64_t block) = 0;
  /// Answers every input once; nothing but the method is done here, so the caller times it.
  virtual void pass(std::size_t method) = 0;
  /// What a peer's questions refer to, such as meshes: the same numbers for all families, often
  /// none.
  virtual std::vector<double> given(std::size_t peer) const = 0;
  /// The prepared inputs as a peer gets them: its `asks` numbers for each.
  virtual std::vector<double> questions(std::size_t peer) const = 0;
  /// Takes a peer's answers, its `tells` numbers for each prepared input, as those of the last
  /// pass.
  virtual void take(std::size_t peer, const std::vector<double>& answers) = 0;
  /// Compares the last pass with the truth.
  virtual Judgement judge() const = 0;
  /// An input on which the last pass, which was of this method, was wrong, or with by_error the one
  /// with its largest error; nothing if there is none. One that a figure can show is preferred.
  virtual std::optional<Failure> failure(std::size_t method, bool by_error) const = 0;
};

}  // namespace ladder
