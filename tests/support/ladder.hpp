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
/// part}], "methods": [{id, title, scalar, exact, part}], "peers": [{id, title, scalar, asks,
/// tells, part}]}, where `part` is the question of a ladder
/// of Parts and otherwise empty; a method is only asked about families of its own part;
/// - `prepare(family, n)`: makes n inputs of the family with that number, and the true answers;
/// - `pass(method)`: answers each once, so that the page can tell what n it has time for;
/// - `run(method)`: address of nine doubles: n, wrong, undecided, error_median, error_max,
/// ns_median, ns_q1, ns_q3, repeats; and imports `env.now`, the time in milliseconds. Inputs are
/// the same everywhere, so the wrong answers are too;
/// - `given(peer)`: address of how many numbers follow, and of those that a peer is given once,
/// before all questions;
/// - `questions(peer)`: address of the prepared inputs as that peer gets them, `asks` doubles each;
/// - `answers(peer)`: address of room for its answers, `tells` doubles each;
/// - `judge(peer)`: compares what the page wrote there with the truth; address of the first five of
/// the nine doubles of `run`.
#pragma once

#include <support/generators.hpp>
#include <support/ladder_experiment.hpp>
#include <support/ladder_page.hpp>

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

  /// Adds a method that the page has in JavaScript.
  /// @param ask appends the numbers of one question to a vector
  /// @param tell makes an answer of the numbers of one; it is also given the truth, for what the
  /// peer by its own definition answers differently
  /// @param given what the questions refer to, such as meshes: the peer gets it once, before them
  void peer(Peer about, std::function<void(const Input&, std::vector<double>&)> ask,
            std::function<Answer(const double*, const Answer& right)> tell,
            std::function<std::vector<double>()> given = {}) {
    peers_.push_back(std::move(about));
    ask_.push_back(std::move(ask));
    tell_.push_back(std::move(tell));
    given_.push_back(std::move(given));
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
  const std::vector<Peer>& peers() const override { return peers_; }

  void prepare(std::size_t family, std::size_t asked, std::uint64_t block) override {
    const std::size_t n = std::min(asked, most_);
    generators::Random random(family + 1 + (block << 32));
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

  std::vector<double> given(std::size_t peer) const override {
    return given_[peer] ? given_[peer]() : std::vector<double>();
  }

  std::vector<double> questions(std::size_t peer) const override {
    std::vector<double> numbers;
    numbers.reserve(inputs_.size() * peers_[peer].asks);
    for (const Input& input : inputs_) ask_[peer](input, numbers);
    return numbers;
  }

  void take(std::size_t peer, const std::vector<double>& answers) override {
    const std::size_t tells = peers_[peer].tells;
    if (answers.size() != tells * answers_.size()) std::abort();
    for (std::size_t i = 0; i < answers_.size(); ++i) {
      answers_[i] = tell_[peer](answers.data() + i * tells, truths_[i]);
    }
  }

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
  std::vector<Peer> peers_;
  std::vector<std::function<void(const Input&, std::vector<double>&)>> ask_;
  std::vector<std::function<Answer(const double*, const Answer&)>> tell_;
  std::vector<std::function<std::vector<double>()>> given_;
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
    for (Peer peer : part.peers()) {
      peer.part = part.question();
      peers_.push_back(std::move(peer));
      of_peer_.push_back({parts_.size(), of_peer_.size() - first_peer_});
    }
    first_family_ = of_family_.size();
    first_method_ = of_method_.size();
    first_peer_ = of_peer_.size();
    parts_.push_back(std::make_unique<Part>(std::move(part)));
  }

  const std::string& question() const override { return question_; }
  const std::vector<Family>& families() const override { return families_; }
  const std::vector<Method>& methods() const override { return methods_; }
  const std::vector<Peer>& peers() const override { return peers_; }
  void prepare(std::size_t family, std::size_t n, std::uint64_t block) override {
    current_ = parts_[of_family_[family].part].get();
    current_->prepare(of_family_[family].index, n, block);
  }
  void pass(std::size_t method) override { current_->pass(of_method_[method].index); }
  std::vector<double> given(std::size_t peer) const override {
    return parts_[of_peer_[peer].part]->given(of_peer_[peer].index);
  }
  std::vector<double> questions(std::size_t peer) const override {
    return current_->questions(of_peer_[peer].index);
  }
  void take(std::size_t peer, const std::vector<double>& answers) override {
    current_->take(of_peer_[peer].index, answers);
  }
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
  std::vector<Peer> peers_;
  std::vector<Place> of_family_, of_method_, of_peer_;
  std::size_t first_family_ = 0, first_method_ = 0, first_peer_ = 0;
  std::vector<std::unique_ptr<Experiment>> parts_;
  Experiment* current_ = nullptr;
};

/// The program (ladder.cpp): runs every method of a chapter's ladder on every family and writes a
/// table, or JSON.
int run_program(Experiment& experiment, const char* chapter, int argc, char** argv);

}  // namespace ladder

#if !defined(__wasm__)
/// Makes the program from a function that returns a ladder; the build defines whose it is.
#define LADDER(make)                                                    \
  int main(int argc, char** argv) {                                     \
    auto the_ladder = make();                                           \
    return ladder::run_program(the_ladder, CONTACT_LADDER, argc, argv); \
  }
#endif
