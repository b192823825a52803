// Ladders: which inputs are kept as failures, and what a program does about a method that is
// declared exact and is not.
#include <support/ladder.hpp>

#include <catch2/catch_test_macros.hpp>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

namespace {

/// The question is how large the sum of some numbers is.
using Numbers = std::vector<int>;

int sum(const Numbers& numbers) {
  int total = 0;
  for (const int x : numbers) total += x;
  return total;
}

/// Sets of ten numbers from 0 to 9; "rare" ones have a 9, which the wrong method leaves out.
ladder::Ladder<Numbers, int> experiment(bool declared_exact) {
  const auto judge = [](const int& got, const int& right) {
    ladder::Verdict verdict;
    verdict.wrong = got != right;
    verdict.error = std::abs(got - right);
    return verdict;
  };
  ladder::Ladder<Numbers, int> ladder("How large is the sum?", sum, judge);
  const auto family = [&ladder](const char* id, int largest) {
    ladder.family(id, id, [largest](generators::Random& random) {
      Numbers numbers;
      for (int i = 0; i < 10; ++i) numbers.push_back(random.integer(0, largest));
      return numbers;
    });
  };
  family("without", 8);
  family("with", 9);
  ladder.method({.id = "sum", .title = "sum", .scalar = "int", .exact = true}, sum);
  ladder.method({.id = "no-nine", .title = "no nine", .scalar = "int", .exact = declared_exact},
                [](const Numbers& numbers) {
                  int total = 0;
                  for (const int x : numbers) total += x == 9 ? 0 : x;
                  return total;
                });
  ladder.recommend("sum");
  return ladder;
}

/// The numbers; a figure takes those that begin with a 9.
ladder::Example shown(const Numbers& numbers, const int& got, const int& right,
                      const ladder::Method& method) {
  ladder::Example example;
  example.facts = {ladder::numbers("numbers", numbers), ladder::number(method.id, got),
                   ladder::number("right", right)};
  if (numbers.front() == 9) example.figure = "figure";
  return example;
}

constexpr std::size_t without = 0;
constexpr std::size_t with = 1;
constexpr std::size_t right_method = 0;
constexpr std::size_t wrong_method = 1;

}  // namespace

TEST_CASE(
    "a failure is an input on which the method is wrong, one for the figure if there is one") {
  auto ladder = experiment(false);
  ladder.show(shown);
  ladder.prepare(with, 200, 0);
  ladder.pass(wrong_method);
  REQUIRE(ladder.judge().wrong > 0);
  const auto failure = ladder.failure(wrong_method, false);
  REQUIRE(failure);
  CHECK(failure->verdict.wrong);
  CHECK_FALSE(failure->simplified);
  CHECK(failure->example.figure == "figure");
  CHECK(failure->example.facts[0].values.front() == 9);
  const double told = failure->example.facts[1].values.front();
  const double truth = failure->example.facts[2].values.front();
  CHECK(told != truth);
  CHECK(failure->verdict.error == truth - told);
}

TEST_CASE("a method that is right has no failure") {
  auto ladder = experiment(false);
  ladder.show(shown);
  ladder.prepare(with, 200, 0);
  ladder.pass(right_method);
  CHECK_FALSE(ladder.failure(right_method, false));
  CHECK_FALSE(ladder.failure(right_method, true));
  ladder.prepare(without, 200, 0);
  ladder.pass(wrong_method);
  CHECK_FALSE(ladder.failure(wrong_method, false));
}

TEST_CASE("by error, the failure has the largest error of the family") {
  auto ladder = experiment(false);
  ladder.show(shown);
  ladder.prepare(with, 200, 0);
  ladder.pass(wrong_method);
  const auto failure = ladder.failure(wrong_method, true);
  REQUIRE(failure);
  CHECK(failure->verdict.error == ladder.judge().error_max);
}

TEST_CASE("a failure is simplified as far as the method stays wrong") {
  auto ladder = experiment(false);
  ladder.show(shown);
  ladder.simplify([](const Numbers& numbers) {
    std::vector<Numbers> fewer;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      fewer.push_back(numbers);
      fewer.back().erase(fewer.back().begin() + static_cast<std::ptrdiff_t>(i));
    }
    return fewer;
  });
  ladder.prepare(with, 200, 0);
  ladder.pass(wrong_method);
  const auto failure = ladder.failure(wrong_method, false);
  REQUIRE(failure);
  CHECK(failure->simplified);
  CHECK(failure->example.facts[0].values == std::vector<double>{9});
}

TEST_CASE("a peer is asked in numbers, and its answers are compared with the truth") {
  auto sums = experiment(false);
  sums.peer(
      {.id = "peer", .title = "peer", .scalar = "JavaScript", .asks = 10, .tells = 2},
      [](const Numbers& numbers, std::vector<double>& to) {
        to.insert(to.end(), numbers.begin(), numbers.end());
      },
      // It tells two halves, and of a truth above 45 nothing that could be wrong.
      [](const double* told, const int& right) {
        return right > 45 ? right : static_cast<int>(told[0] + told[1]);
      },
      [] {
        return std::vector<double>{7, 8};
      });
  sums.peer(
      {.id = "bare", .title = "bare", .scalar = "JavaScript"},
      [](const Numbers&, std::vector<double>&) {}, [](const double*, const int&) { return 0; });
  ladder::Parts parts("Sums");
  ladder::Ladder<int, bool> other(
      "Another?", [](const int&) { return true; },
      [](const bool&, const bool&) { return ladder::Verdict(); });
  other.family("any", "any", [](generators::Random& random) { return random.integer(0, 9); });
  parts.add(std::move(other));
  parts.add(std::move(sums));
  REQUIRE(parts.peers().size() == 2);
  CHECK(parts.peers()[0].part == "How large is the sum?");
  CHECK(ladder::layout(parts).ends_with(
      R"("peers":[{"id":"peer","title":"peer","scalar":"JavaScript","asks":10,"tells":2,)"
      R"("part":"How large is the sum?"},)"
      R"({"id":"bare","title":"bare","scalar":"JavaScript","asks":1,"tells":1,)"
      R"("part":"How large is the sum?"}]})"));
  ladder::Exchange exchange;
  const double* given = exchange.given(parts, 0);
  CHECK(std::vector<double>(given, given + 3) == std::vector<double>{2, 7, 8});
  CHECK(*exchange.given(parts, 1) == 0);
  constexpr std::size_t n = 100;
  parts.prepare(1 + with, n, 0);
  const double* asked = exchange.questions(parts, 0);
  const std::vector<double> questions(asked, asked + 10 * n);
  std::size_t wrong = 0;
  double* told = exchange.answers(parts, 0);
  for (std::size_t i = 0; i < n; ++i) {
    double sum = 0;
    for (std::size_t k = 0; k < 10; ++k) sum += questions[10 * i + k];
    const bool off = i % 4 == 0;
    if (off && sum <= 45) ++wrong;
    told[2 * i] = 2;
    told[2 * i + 1] = sum - 2 + (off ? 1 : 0);
  }
  const double* judged = exchange.judge(parts, 0);
  REQUIRE(wrong > 0);
  REQUIRE(wrong < n / 4);
  CHECK(judged[0] == n);
  CHECK(judged[1] == static_cast<double>(wrong));
  CHECK(judged[2] == 0);
  CHECK(judged[4] == 1);
}

TEST_CASE("a ladder of slow methods makes at most as many inputs as it says") {
  auto sums = experiment(false);
  sums.at_most(20);
  sums.prepare(1, 100, 0);
  sums.pass(0);
  REQUIRE(sums.judge().n == 20);
  sums.prepare(1, 7, 0);
  sums.pass(0);
  REQUIRE(sums.judge().n == 7);
}

TEST_CASE("one method is recommended") {
  const auto ladder = experiment(false);
  CHECK(ladder.methods()[right_method].recommended);
  CHECK_FALSE(ladder.methods()[wrong_method].recommended);
}

TEST_CASE("of several ladders each method is asked about the families of its own") {
  // The question is whether a number is even.
  ladder::Ladder<int, bool> parity(
      "Is it even?", [](const int& x) { return x % 2 == 0; },
      [](const bool& got, const bool& right) {
        ladder::Verdict verdict;
        verdict.wrong = got != right;
        return verdict;
      });
  parity.family("any", "any", [](generators::Random& random) { return random.integer(0, 9); });
  parity.method({.id = "always", .title = "always", .scalar = "int", .exact = false},
                [](const int&) { return true; });
  ladder::Parts both("How is a number?");
  both.add(experiment(false));
  both.add(std::move(parity));
  REQUIRE(both.families().size() == 3);
  REQUIRE(both.methods().size() == 3);
  CHECK(both.families()[2].part == "Is it even?");
  CHECK(both.methods()[1].part == "How large is the sum?");
  both.prepare(2, 200, 0);
  both.pass(2);
  CHECK(both.judge().wrong > 50);
  both.prepare(with, 200, 0);
  both.pass(right_method);
  CHECK(both.judge().wrong == 0);

  const auto file = std::filesystem::temp_directory_path() / "contact-ladder-parts-test.json";
  std::string name = file.string();
  std::array<std::string, 7> words{"ladder", "--size", "50", "--repeats", "1", "--json", name};
  std::array<char*, 7> arguments{};
  for (std::size_t i = 0; i < words.size(); ++i) arguments[i] = words[i].data();
  CHECK(ladder::run_program(both, "00_trial", 7, arguments.data()) == 0);
  const auto kept = nlohmann::json::parse(std::ifstream(file));
  std::filesystem::remove(file);
  CHECK(kept["results"].size() == 5);
  CHECK(kept["methods"][2]["part"] == "Is it even?");
  CHECK(kept["families"][0]["part"] == "How large is the sum?");
}

TEST_CASE("the program keeps failures, and fails if an exact method is wrong") {
  const auto file = std::filesystem::temp_directory_path() / "contact-ladder-test.json";
  for (const bool declared_exact : {false, true}) {
    auto ladder = experiment(declared_exact);
    ladder.show(shown);
    std::string name = file.string();
    std::array<std::string, 7> words{"ladder", "--size", "50", "--repeats", "1", "--json", name};
    std::array<char*, 7> arguments{};
    for (std::size_t i = 0; i < words.size(); ++i) arguments[i] = words[i].data();
    const int code = ladder::run_program(ladder, "00_trial", 7, arguments.data());
    CHECK(code == (declared_exact ? 1 : 0));
    const auto kept = nlohmann::json::parse(std::ifstream(file));
    std::filesystem::remove(file);
    CHECK(kept["methods"][0]["recommended"] == true);
    for (const auto& row : kept["results"]) CHECK(row.contains("failure") == (row["wrong"] > 0));
  }
}

TEST_CASE("options that ask nothing are refused") {
  ladder::Ladder<int, bool> none_exact(
      "Is it even?", [](const int& x) { return x % 2 == 0; },
      [](const bool&, const bool&) { return ladder::Verdict{}; });
  none_exact.family("any", "any", [](generators::Random&) { return 1; });
  none_exact.method({.id = "always", .title = "always", .scalar = "int", .exact = false},
                    [](const int&) { return true; });
  const auto run = [&none_exact](std::vector<std::string> words) {
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    const int count = static_cast<int>(words.size());
    return ladder::run_program(none_exact, "00_trial", count, arguments.data());
  };
  CHECK(run({"ladder", "--from", "3"}) == 2);
  CHECK(run({"ladder", "--never-wrong"}) == 2);
  CHECK(run({"ladder", "--never-wrong", "0"}) == 2);
  CHECK(run({"ladder", "--never-wrong", "10"}) == 1);
}

TEST_CASE("what is declared never wrong is asked in blocks of other inputs") {
  constexpr int rare = 15000;  // the first input on which the method is wrong: in the second block
  for (const int first_wrong : {rare, std::numeric_limits<int>::max()}) {
    CAPTURE(first_wrong);
    int made = 0;
    std::set<std::uint64_t> drawn;
    ladder::Ladder<int, bool> parity(
        "Is it even?", [](const int& x) { return x % 2 == 0; },
        [](const bool& got, const bool& right) {
          ladder::Verdict verdict;
          verdict.wrong = got != right;
          return verdict;
        });
    parity.family("any", "any", [&](generators::Random& random) {
      drawn.insert(random.bits());
      return made++;
    });
    parity.method({.id = "sure", .title = "sure", .scalar = "int", .exact = true},
                  [&](const int& x) { return x >= first_wrong ? x % 2 == 1 : x % 2 == 0; });
    parity.method({.id = "always", .title = "always", .scalar = "int", .exact = false},
                  [](const int&) { return true; });
    std::array<std::string, 5> words{"ladder", "--never-wrong", "25000", "--from", "7"};
    std::array<char*, 5> arguments{};
    for (std::size_t i = 0; i < words.size(); ++i) arguments[i] = words[i].data();
    const int code = ladder::run_program(parity, "00_trial", 5, arguments.data());
    CHECK(code == (first_wrong == rare ? 1 : 0));
    CHECK(made == 25000);
    CHECK(drawn.size() == 25000);
  }
}
