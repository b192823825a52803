// What a program of tests reports, and that it reports it in time. The program is
// exercise_specimen.cpp.
#include <catch2/catch_test_macros.hpp>
#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace {

using nlohmann::json;

struct Run {
  std::vector<json> lines;
  std::vector<std::string> printed;
};

/// Runs the tests whose names match, reports on its stdout; lines that are not JSON are what tests
/// printed.
Run run(const std::string& which) {
  const std::string command = std::string("CONTACT_MEMORY_MB=512 ") + CONTACT_SPECIMEN +
                              " -r contact \"" + which + "\" 2>/dev/null";
  FILE* pipe = popen(command.c_str(), "r");
  REQUIRE(pipe != nullptr);
  Run result;
  std::string all;
  for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) all += static_cast<char>(c);
  pclose(pipe);
  std::size_t at = 0;
  while (at < all.size()) {
    const std::size_t end = std::min(all.find('\n', at), all.size());
    const std::string line = all.substr(at, end - at);
    if (line.starts_with('{')) {
      result.lines.push_back(json::parse(line));
    } else {
      result.printed.push_back(line);
    }
    at = end + 1;
  }
  return result;
}

/// The end line of the only test that this name matches.
json outcome(const std::string& name) {
  const Run all = run(name);
  REQUIRE(all.lines.size() == 3);
  CHECK(all.lines[0] == json{{"event", "start"}, {"test", name}});
  CHECK(all.lines[1]["event"] == "end");
  CHECK(all.lines[1]["test"] == name);
  CHECK(all.lines[1]["seconds"].get<double>() >= 0);
  CHECK(all.lines[2] == json{{"event", "done"}});
  return all.lines[1];
}

}  // namespace

TEST_CASE("right answers pass, with nothing more to say") {
  const json end = outcome("right");
  CHECK(end["status"] == "passed");
  CHECK_FALSE(end.contains("failure"));
}

TEST_CASE(
    "a wrong answer reports the question, the input, the answer, the right answer, and the hint") {
  const json end = outcome("wrong and recognised");
  CHECK(end["status"] == "failed");
  CHECK(end["failure"] ==
        json{{"asked", "What is it?"},
             {"inputs", {{{"name", "x"}, {"text", "(1, 2, 0.1)"}}, {{"name", "n"}, {"text", "7"}}}},
             {"got", "2.5"},
             {"right", "2"},
             {"allowed", "±0.25"},
             {"misconception", "this-one"}});
}

TEST_CASE("an input that breaks the code passes, and says what both answer") {
  const json end = outcome("an input that breaks the code");
  CHECK(end["status"] == "passed");
  CHECK_FALSE(end.contains("failure"));
  CHECK(end["finding"] ==
        json{{"asked", "Where is it wrong?"},
             {"inputs",
              {{{"name", "number"}, {"text", "5"}}, {{"name", "given code"}, {"text", "10"}}}},
             {"got", ""},
             {"right", "25"},
             {"reason", "The difference is 15."}});
  CHECK_FALSE(outcome("right").contains("finding"));
}

TEST_CASE("an input that does not break the code says why not") {
  const auto failure = [](const char* test) {
    const json end = outcome(test);
    CHECK(end["status"] == "failed");
    CHECK_FALSE(end.contains("finding"));
    return end["failure"];
  };
  CHECK(failure("an input on which both agree") ==
        json{{"asked", "Where is it wrong?"},
             {"inputs",
              {{{"name", "number"}, {"text", "2"}}, {{"name", "given code"}, {"text", "4"}}}},
             {"got", ""},
             {"right", "4"},
             {"misconception", "the-two-agree"},
             {"reason", "The difference is 0."}});
  CHECK(failure("an input within rounding")["misconception"] == "break-within-rounding");
  for (const char* test : {"an input outside the region", "an input that is no number"}) {
    const json told = failure(test);
    CHECK(told["misconception"] == "break-outside-the-region");
    CHECK(told["got"] == "");
    CHECK(told["right"] == "an input for which this holds: the number is whole");
  }
  const json none = failure("no input at all");
  CHECK(none["got"] == "threw std::invalid_argument: none");
  CHECK_FALSE(none.contains("misconception"));
}

TEST_CASE("only a wrong formula that is wrong here is recognised") {
  CHECK_FALSE(outcome("a suspect that is right here is not recognised")["failure"].contains(
      "misconception"));
  CHECK(outcome("a suspect by its looks")["failure"]["misconception"] == "not-a-number");
}

TEST_CASE("comparisons fail for NaN, and keep a tolerance for each number") {
  CHECK(outcome("NaN is near nothing and not even NaN")["status"] == "failed");
  const json end = outcome("each number has its own tolerance");
  CHECK(end["failure"]["got"] == "Pair{small: 5, large: 105}");
  CHECK(end["failure"]["allowed"] == "Pair{small: 1, large: 10}");
}

TEST_CASE("an exception that the contract does not name stops the test, and is reported") {
  const json wrong = outcome("the wrong exception");
  CHECK(wrong["status"] == "stopped");
  CHECK(wrong["failure"]["reason"] == "threw an exception: far out");
  CHECK(outcome("not an exception")["failure"]["reason"] ==
        "threw something that is not a std::exception");
  CHECK(outcome("out of memory")["failure"]["reason"] == "ran out of memory");
}

TEST_CASE("a missing exception is reported") {
  const json none = outcome("no exception");
  CHECK(none["failure"]["got"] == "1");
  CHECK(none["failure"]["right"] == "throws std::invalid_argument");
  CHECK(none["failure"]["misconception"] == "accepts-all");
}

TEST_CASE("todo is not attempted, and a call that could not be made is stopped") {
  const json todo = outcome("not attempted");
  CHECK(todo["status"] == "not_attempted");
  CHECK_FALSE(todo.contains("failure"));
  const json stopped = outcome("asked in vain");
  CHECK(stopped["status"] == "stopped");
  CHECK(stopped["failure"]["reason"] == "gone");
}

TEST_CASE("whatever text comes back, the report is JSON") {
  CHECK(outcome("text that is no UTF-8")["status"] == "failed");
}

TEST_CASE("an author's own check is reported too") {
  const json end = outcome("an author's own check");
  CHECK(end["status"] == "failed");
  CHECK(end["failure"]["got"] == "1 == 2");
}

TEST_CASE("stdout belongs to the student") {
  CHECK(run("prints").printed == std::vector<std::string>{"the student's line"});
}

TEST_CASE("a crash is reported for the test in which it happened") {
  const Run all = run("crashes");
  REQUIRE(all.lines.size() >= 2);
  CHECK(all.lines[0]["event"] == "start");
  CHECK(all.lines[1]["status"] == "stopped");
  CHECK(all.lines[1]["failure"]["reason"].get<std::string>().starts_with("SIGSEGV"));
}

TEST_CASE("a program that leaves has said in which test, and never says done") {
  const Run all = run("leaves");
  REQUIRE(all.lines.size() == 1);
  CHECK(all.lines[0] == json{{"event", "start"}, {"test", "leaves"}});
}

TEST_CASE("tests run and report in the order of the file") {
  std::vector<std::string> started;
  for (const json& line : run("*").lines) {
    if (line["event"] == "start") started.push_back(line["test"]);
  }
  REQUIRE(started.size() >= 3);
  CHECK(started[0] == "right");
  CHECK(started[1] == "wrong and recognised");
  CHECK(started[2] == "a suspect that is right here is not recognised");
}
