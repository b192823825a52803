// Tests that fail, crash and stop on purpose. exercise_test.cpp runs this program and reads what it
// reports.
#include <csignal>
#include <cstdlib>
#include <limits>

#include <contact/host.hpp>
#include <contact/prelude.hpp>
#include <support/break_it.hpp>

namespace {

using namespace contact::testing;
using Found = std::optional<double>;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

struct Pair {
  double small = 0, large = 0;
};

}  // namespace

TEST_CASE("right") {
  ask("One?").answer([] { return 1; }).equals(1);
  ask("A third?").answer([] { return 1.0 / 3; }).close_to(0.3333, within(1e-3));
  ask("Even?").answer([] { return 4; }).satisfies("is even", [](int i) { return i % 2 == 0; });
  ask("A bad plane?")
      .answer([]() -> int { throw std::invalid_argument("n"); })
      .throws_invalid_argument();
}

TEST_CASE("wrong and recognised") {
  const Eigen::Vector3d x{1, 2, 0.1};
  const int n = 7;
  ask("What is it?")
      .given("x", x)
      .given("n", n)
      .suspect("not-this-one", [] { return 3.0; })
      .suspect("this-one", [] { return 2.5; })
      .answer([] { return 2.5; })
      .close_to(2, within(0.25));
}

TEST_CASE("a suspect that is right here is not recognised") {
  ask("What is it?")
      .suspect("right-here", [] { return 2.125; })
      .suspect("breaks-down", []() -> double { throw std::domain_error("no"); })
      .answer([] { return 2.375; })
      .close_to(2, within(0.25));
}

TEST_CASE("recognised as several") {
  ask("What is it?")
      .suspect("first", [] { return 2.5; })
      .suspect("another", [] { return 3.5; })
      .suspect_if("by-its-look", [](const double& y) { return y > 2; })
      .suspect("first", [] { return 2.75; })
      .suspect("third", [] { return 2.625; })
      .answer([] { return 2.625; })
      .close_to(2, within(0.25));
}

TEST_CASE("ruled out by an earlier answer") {
  const auto ask_about = [](int x, int answer) {
    ask("What is the square of x?")
        .given("x", x)
        .suspect("doubles", [x] { return 2 * x; })
        .suspect("doubles", [x] { return x == 3 ? 7 : 2 * x; })
        .suspect("adds-two", [x] { return x + 2; })
        .answer([answer] { return answer; })
        .equals(x * x);
  };
  ask_about(2, 4);  // rules out nothing: all are right here
  ask_about(0, 0);  // rules out that 2 is added
  ask_about(2, 4);
  ask("What is the triple of x?")
      .suspect("doubles", [] { return 2; })
      .answer([] { return 3; })
      .equals(3);
  ask_about(4, 6);  // x + 2, which is ruled out
}

TEST_CASE("ruled out for another question only") {
  ask("One?").suspect("two", [] { return 2; }).answer([] { return 1; }).equals(1);
  ask("Another one?").suspect("two", [] { return 2; }).answer([] { return 2; }).equals(1);
}

TEST_CASE("a suspect by its looks") {
  ask("What is it?")
      .suspect_if("not-a-number", [](const double& y) { return y != y; })
      .answer([] { return kNaN; })
      .close_to(2, within(0.25));
}

TEST_CASE("NaN is near nothing and not even NaN") {
  ask("What is it?").answer([] { return Found{kNaN}; }).close_to(Found{kNaN}, within(1e300));
}

TEST_CASE("each number has its own tolerance") {
  ask("What are they?")
      .answer([] {
        return Pair{1.5, 105};
      })
      .close_to({1, 100}, within(Pair{1, 10}));
  ask("What are they?").answer([] { return Pair{5, 105}; }).close_to({1, 100}, within(Pair{1, 10}));
}

TEST_CASE("the wrong exception") {
  ask("Refused?")
      .answer([]() -> int { throw std::out_of_range("far out"); })
      .throws_invalid_argument();
}

TEST_CASE("no exception") {
  ask("Refused?")
      .suspect("accepts-all", [] { return 1; })
      .answer([] { return 1; })
      .throws_invalid_argument();
}

TEST_CASE("not an exception") {
  ask("What is it?").answer([]() -> int { throw 5; }).equals(1);
}

TEST_CASE("out of memory") {
  ask("How much?")
      .answer([] {
        // Small pieces, so that no allocator refuses the size as such; the limit is
        // CONTACT_MEMORY_MB.
        std::vector<std::vector<double>> all;
        while (true) all.emplace_back(std::size_t{1} << 17, 1.0);
        return static_cast<int>(all.size());
      })
      .equals(1);
}

TEST_CASE("not attempted") {
  ask("What is it?").answer([]() -> int { contact::todo(); }).equals(1);
}

TEST_CASE("asked in vain") {
  ask("What is it?").answer([]() -> int { throw contact::host::Stopped("gone"); }).equals(1);
}

TEST_CASE("text that is no UTF-8") {
  ask("What is it?").answer([] { return std::string("\xff\xfe"); }).equals("x");
}

TEST_CASE("an author's own check") {
  const int found = 1;
  REQUIRE(found == 2);
}

TEST_CASE("prints") {
  std::puts("the student's line");
  ask("One?").answer([] { return 1; }).equals(1);
}

TEST_CASE("crashes") {
  ask("What is it?")
      .answer([] {
        std::raise(SIGSEGV);
        return 1;
      })
      .equals(1);
}

TEST_CASE("leaves") {
  ask("What is it?")
      .answer([] {
        std::_Exit(0);
        return 1;
      })
      .equals(1);
}

// The given code doubles; right is the square. Whole numbers up to 100 are allowed.
void break_the_double(std::optional<double> input) {
  break_it<double>("Where is it wrong?")
      .rule("the number is whole", all_whole<double>)
      .rule("the number is at most 100", [](const double& x) { return all_within(x, 100); })
      .suspect_if("the-two-agree", [](const double& x) { return 2 * x == x * x; })
      .input("number",
             [&] {
               if (!input) throw std::invalid_argument("none");
               return *input;
             })
      .judge([](const double& x) {
        const double off = std::abs(2 * x - x * x);
        return Judged{off > 2, contact::text_of(2 * x), contact::text_of(x * x),
                      "The difference is " + contact::text_of(off) + ".", off > 0 && off <= 2};
      });
}

TEST_CASE("an input that breaks the code") { break_the_double(5); }
TEST_CASE("an input on which both agree") { break_the_double(2); }
TEST_CASE("an input within rounding") { break_the_double(1); }
TEST_CASE("an input outside the region") { break_the_double(0.5); }
TEST_CASE("an input that is no number") { break_the_double(kNaN); }
TEST_CASE("no input at all") { break_the_double(std::nullopt); }

// Last, because these tests run in the order of the file.
#include "shrinking_specimen.hpp"
