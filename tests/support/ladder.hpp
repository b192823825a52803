/// @file
/// A ladder: several methods for one question, each with how often it is wrong and what it costs.
///
///     ladder::Ladder<Input, Answer> experiment() {
///       ladder::Ladder<Input, Answer> ladder("Does the ray hit?", truth, judge);
///       ladder.family("random", "random", [](generators::Random& random) { return Input{...}; });
///       ladder.method({.id = "plain", .title = "plain", .scalar = "float", .exact = false},
///                     [](const Input& input) { return plain(input); });
///       ladder.recommend("plain");
///       ladder.show([](const Input& input, const Answer& got, const Answer& right,
///                      const ladder::Method& method) {
///         return ladder::Example{...};  // in a figure of the chapter, or in numbers
///       });
///       return ladder;
///     }
///     LADDER(experiment)
///
/// A chapter with several questions makes a ladder for each and returns ladder::Parts of them.
///
/// Natively this is a program: `--size N` inputs a family, `--repeats R` timed passes, `--json
/// FILE`. It fails if a method that is declared exact gives a wrong answer. In WebAssembly it
/// exports
/// - `layout()`: address of a JSON text, ended by a 0: {"question", "families": [{id, title,
/// part}], "methods": [{id, title, scalar, exact, part}]}, where `part` is the question of a ladder
/// of Parts and otherwise empty; a method is only asked about families of its own part;
/// - `prepare(family, n)`: makes n inputs of the family with that number, and the true answers;
/// - `pass(method)`: answers each once, so that the page can tell what n it has time for;
/// - `run(method)`: address of nine doubles: n, wrong, undecided, error_median, error_max,
/// ns_median, ns_q1, ns_q3, repeats; and imports `env.now`, the time in milliseconds. Inputs are
/// the same everywhere, so the wrong answers are too.
#pragma once

#include <support/generators.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <limits>
#include <memory>
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
  /// Makes n inputs and their true answers, or as many as the ladder makes at most.
  virtual void prepare(std::size_t family, std::size_t n) = 0;
  /// Answers every input once; nothing but the method is done here, so the caller times it.
  virtual void pass(std::size_t method) = 0;
  /// Compares the last pass with the truth.
  virtual Judgement judge() const = 0;
  /// An input on which the last pass, which was of this method, was wrong, or with by_error the one
  /// with its largest error; nothing if there is none. One that a figure can show is preferred.
  virtual std::optional<Failure> failure(std::size_t method, bool by_error) const = 0;
};

/// Failing inputs are kept by the native program; the page's module has no code for them.
#if defined(__wasm__)
inline constexpr bool keeps_failures = false;
#else
inline constexpr bool keeps_failures = true;
#endif

/// @tparam Input what a method is asked; it holds the numbers in each scalar that a method wants,
/// so that no conversion is timed
/// @tparam Answer what a method says
template <class Input, class Answer>
class Ladder : public Experiment {
 public:
  using Truth = std::function<Answer(const Input&)>;
  using Judge = std::function<Verdict(const Answer& got, const Answer& right)>;
  using Generator = std::function<Input(generators::Random&)>;
  using Show =
      std::function<Example(const Input&, const Answer& got, const Answer& right, const Method&)>;
  using Simplify = std::function<std::vector<Input>(const Input&)>;

  Ladder(std::string question, Truth truth, Judge judge)
      : question_(std::move(question)), truth_(std::move(truth)), judge_(std::move(judge)) {}

  /// Adds a family of inputs. With by_error it is about the error, whether some method is wrong or
  /// not.
  void family(const std::string& id, const std::string& title, Generator generator,
              bool by_error = false) {
    families_.push_back({id, title, by_error});
    generators_.push_back(std::move(generator));
  }

  /// Adds a method. The loop over the inputs is compiled for each, so that calls can be inlined.
  template <class Call>
  void method(Method about, Call call) {
    methods_.push_back(std::move(about));
    loops_.push_back([call](const std::vector<Input>& inputs, std::vector<Answer>& answers) {
      for (std::size_t i = 0; i < inputs.size(); ++i) answers[i] = call(inputs[i]);
    });
    if constexpr (keeps_failures) calls_.push_back(call);
  }

  /// Makes at most n inputs of a family, however many are asked for: methods that take long.
  void at_most(std::size_t n) { most_ = n; }

  /// Marks the method that the book recommends.
  void recommend(const std::string& id) {
    for (Method& method : methods_) {
      if (method.id != id) continue;
      method.recommended = true;
      return;
    }
    std::fprintf(stderr, "recommend: there is no method %s\n", id.c_str());
    std::abort();
  }

  /// How a failing input is shown.
  template <class Function>
  void show(Function function) {
    if constexpr (keeps_failures) show_ = std::move(function);
  }

  /// Simpler inputs than the given one, to replace it while the method still fails.
  template <class Function>
  void simplify(Function function) {
    if constexpr (keeps_failures) simplify_ = std::move(function);
  }

  const std::string& question() const override { return question_; }
  const std::vector<Family>& families() const override { return families_; }
  const std::vector<Method>& methods() const override { return methods_; }

  void prepare(std::size_t family, std::size_t asked) override {
    const std::size_t n = std::min(asked, most_);
    generators::Random random(family + 1);
    inputs_.clear();
    truths_.clear();
    inputs_.reserve(n);
    truths_.reserve(n);
    for (std::size_t i = 0; i < n; ++i) {
      inputs_.push_back(generators_[family](random));
      truths_.push_back(truth_(inputs_.back()));
    }
    answers_.assign(n, Answer());
  }

  void pass(std::size_t method) override { loops_[method](inputs_, answers_); }

  Judgement judge() const override {
    Judgement result;
    std::vector<double> errors;
    for (std::size_t i = 0; i < answers_.size(); ++i) {
      const Verdict verdict = judge_(answers_[i], truths_[i]);
      ++result.n;
      result.wrong += verdict.wrong;
      result.undecided += verdict.undecided;
      if (!std::isnan(verdict.error)) errors.push_back(verdict.error);
    }
    if (!errors.empty()) {
      result.error_max = *std::max_element(errors.begin(), errors.end());
      result.error_median = spread(std::move(errors)).median;
    }
    return result;
  }

  std::optional<Failure> failure(std::size_t method, bool by_error) const override {
    std::optional<Failure> found;
    if (!show_) return found;
    constexpr int max_tries = 200;
    int tries = 0;
    for (std::size_t i = 0; i < answers_.size() && tries < max_tries; ++i) {
      const Verdict verdict = judge_(answers_[i], truths_[i]);
      if (by_error) {
        if (!(verdict.error > (found ? found->verdict.error : 0))) continue;
        found = Failure{i, false, verdict, {}};
        continue;
      }
      if (!verdict.wrong) continue;
      ++tries;
      Failure failure = simplest(method, i);
      const bool shown = !failure.example.figure.empty();
      if (shown || !found) found = std::move(failure);
      if (shown) break;
    }
    if (found && by_error) {
      const std::size_t i = found->input;
      found->example = show_(inputs_[i], answers_[i], truths_[i], methods_[method]);
    }
    return found;
  }

 private:
  /// The input with this index, simplified as long as the method is wrong.
  Failure simplest(std::size_t method, std::size_t index) const {
    Failure failure{index, false, judge_(answers_[index], truths_[index]), {}};
    Input input = inputs_[index];
    Answer answer = answers_[index];
    Answer truth = truths_[index];
    const auto simplified_once = [&] {
      for (const Input& simpler : simplify_(input)) {
        Answer got = calls_[method](simpler);
        Answer right = truth_(simpler);
        const Verdict verdict = judge_(got, right);
        if (!verdict.wrong) continue;
        input = simpler;
        answer = std::move(got);
        truth = std::move(right);
        failure.verdict = verdict;
        return true;
      }
      return false;
    };
    while (simplify_ && simplified_once()) failure.simplified = true;
    failure.example = show_(input, answer, truth, methods_[method]);
    return failure;
  }

  std::string question_;
  std::size_t most_ = std::numeric_limits<std::size_t>::max();
  Truth truth_;
  Judge judge_;
  std::vector<Family> families_;
  std::vector<Generator> generators_;
  std::vector<Method> methods_;
  Show show_;
  Simplify simplify_;
  std::vector<std::function<Answer(const Input&)>> calls_;
  std::vector<std::function<void(const std::vector<Input>&, std::vector<Answer>&)>> loops_;
  std::vector<Input> inputs_;
  std::vector<Answer> truths_, answers_;
};

/// Several ladders as one, each with its own question, inputs and methods.
class Parts : public Experiment {
 public:
  /// @param question what all of them are about
  explicit Parts(std::string question) : question_(std::move(question)) {}

  /// Adds a ladder. The ids of its families and methods must differ from those of the others.
  template <class Part>
  void add(Part part) {
    for (Family family : part.families()) {
      family.part = part.question();
      families_.push_back(std::move(family));
      of_family_.push_back({parts_.size(), of_family_.size() - first_family_});
    }
    for (Method method : part.methods()) {
      method.part = part.question();
      methods_.push_back(std::move(method));
      of_method_.push_back({parts_.size(), of_method_.size() - first_method_});
    }
    first_family_ = of_family_.size();
    first_method_ = of_method_.size();
    parts_.push_back(std::make_unique<Part>(std::move(part)));
  }

  const std::string& question() const override { return question_; }
  const std::vector<Family>& families() const override { return families_; }
  const std::vector<Method>& methods() const override { return methods_; }
  void prepare(std::size_t family, std::size_t n) override {
    current_ = parts_[of_family_[family].part].get();
    current_->prepare(of_family_[family].index, n);
  }
  void pass(std::size_t method) override { current_->pass(of_method_[method].index); }
  Judgement judge() const override { return current_->judge(); }
  std::optional<Failure> failure(std::size_t method, bool by_error) const override {
    return current_->failure(of_method_[method].index, by_error);
  }

 private:
  struct Place {
    std::size_t part, index;
  };
  std::string question_;
  std::vector<Family> families_;
  std::vector<Method> methods_;
  std::vector<Place> of_family_, of_method_;
  std::size_t first_family_ = 0, first_method_ = 0;
  std::vector<std::unique_ptr<Experiment>> parts_;
  Experiment* current_ = nullptr;
};

/// The program (ladder.cpp): runs every method of a chapter's ladder on every family and writes a
/// table, or JSON.
int run_program(Experiment& experiment, const char* chapter, int argc, char** argv);

/// Text between quotes; ids and titles need no other escapes.
inline std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result + "\"";
}

/// What there is to run, as JSON.
inline std::string layout(const Experiment& experiment) {
  std::string text = "{\"question\":" + quoted(experiment.question()) + ",\"families\":[";
  for (const Family& family : experiment.families()) {
    if (text.back() == '}') text += ",";
    text += "{\"id\":" + quoted(family.id) + ",\"title\":" + quoted(family.title) +
            ",\"part\":" + quoted(family.part) + "}";
  }
  text += "],\"methods\":[";
  for (const Method& method : experiment.methods()) {
    if (text.back() == '}') text += ",";
    text += "{\"id\":" + quoted(method.id) + ",\"title\":" + quoted(method.title) +
            ",\"scalar\":" + quoted(method.scalar) +
            ",\"exact\":" + (method.exact ? "true" : "false") + ",\"part\":" + quoted(method.part) +
            "}";
  }
  return text + "]}";
}

/// The timed passes of one method in the page, after one that warms up: enough for a median, few
/// enough to wait for.
inline constexpr int passes_in_page = 7;

/// One method on the prepared family: the nine numbers of `run`.
template <class Now>
void run_in_page(Experiment& experiment, std::size_t method, const Now& now_in_ms, double* to) {
  experiment.pass(method);
  const Judgement judged = experiment.judge();
  std::vector<double> ns;
  // A browser's clock is coarse: a pass that it cannot resolve is repeated until it can.
  constexpr double long_enough = 4;
  for (int i = 0; i < passes_in_page; ++i) {
    const double start = now_in_ms();
    double elapsed = 0;
    int rounds = 0;
    while (elapsed < long_enough) {
      experiment.pass(method);
      ++rounds;
      elapsed = now_in_ms() - start;
    }
    ns.push_back(elapsed * 1e6 / (rounds * static_cast<double>(judged.n)));
  }
  const Spread times = spread(std::move(ns));
  for (const double value :
       {static_cast<double>(judged.n), static_cast<double>(judged.wrong),
        static_cast<double>(judged.undecided), judged.error_median, judged.error_max, times.median,
        times.q1, times.q3, double{passes_in_page}}) {
    *to++ = value;
  }
}

}  // namespace ladder

#if defined(__wasm__)
#define LADDER_EXPORT(name) [[gnu::used]] __attribute__((export_name(name)))
/// Makes the module's exports from a function that returns a ladder.
#define LADDER(make)                                                                              \
  __attribute__((import_module("env"), import_name("now"))) extern "C" double ladder_now_in_ms(); \
  static auto& the_ladder() {                                                                     \
    static auto ladder = make();                                                                  \
    return ladder;                                                                                \
  }                                                                                               \
  LADDER_EXPORT("layout") const char* ladder_layout() {                                           \
    static const std::string text = ladder::layout(the_ladder());                                 \
    return text.c_str();                                                                          \
  }                                                                                               \
  LADDER_EXPORT("prepare") void ladder_prepare(int family, int n) {                               \
    the_ladder().prepare(static_cast<std::size_t>(family), static_cast<std::size_t>(n));          \
  }                                                                                               \
  LADDER_EXPORT("pass") void ladder_pass(int method) {                                            \
    the_ladder().pass(static_cast<std::size_t>(method));                                          \
  }                                                                                               \
  LADDER_EXPORT("run") const double* ladder_run(int method) {                                     \
    static double row[9];                                                                         \
    ladder::run_in_page(the_ladder(), static_cast<std::size_t>(method), ladder_now_in_ms, row);   \
    return row;                                                                                   \
  }
#else
/// Makes the program from a function that returns a ladder; the build defines whose it is.
#define LADDER(make)                                                    \
  int main(int argc, char** argv) {                                     \
    auto the_ladder = make();                                           \
    return ladder::run_program(the_ladder, CONTACT_LADDER, argc, argv); \
  }
#endif
