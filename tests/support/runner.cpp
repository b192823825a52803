// The program that runs an exercise's tests: Catch2, and a reporter that prints each event as one
// line of JSON, flushed at once, so that the reader knows in which test the program crashed.
//
//   {"event":"start","test":NAME}
//   {"event":"end","test":NAME,"status":"passed"|"failed"|"not_attempted"|"stopped","seconds":S,"processor_seconds":S?,"failure":{...}}
//   {"event":"done"}
//
// A test that passes may have a "finding", of the same form as a failure: what it has to show.
//
// With CONTACT_TELL_QUESTIONS in the environment also, before each question,
//   {"event":"question","failure":{"asked","inputs"}}
//
// With CONTACT_LOOK=inputs or =smaller, tests go on after a wrong answer, and before the end, and
// after each smaller input,
//   {"event":"look","test":NAME,"look":{"right":N,"wrong":N,"right_inputs"?,"wrong_inputs"?,"smaller"?:{...}}}
//
// failure:
// {"asked","inputs":[{"name","text"}],"got","right","allowed"?,"misconceptions"?,"observed"?,"reason"?}.
// misconceptions: the ids of all mistakes that give this answer.
// Use `-r contact::out=FILE`; stdout is left to the student. CONTACT_MEMORY_MB limits the memory
// (not in a page, which has its own limit), CONTACT_SEED changes the random inputs.

#include <catch2/catch_session.hpp>
#include <catch2/catch_test_case_info.hpp>
#include <catch2/reporters/catch_reporter_event_listener.hpp>
#include <catch2/reporters/catch_reporter_registrars.hpp>
#include <catch2/reporters/catch_reporter_streaming_base.hpp>
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <nlohmann/json.hpp>

#ifndef __wasi__
#include <contact/remote_frames.hpp>
#endif

#include <contact/host.hpp>
#include <support/exercise.hpp>

namespace contact::testing {
namespace {

using nlohmann::ordered_json;

class TestStarts : public Catch::EventListenerBase {
 public:
  using EventListenerBase::EventListenerBase;
  void testCaseStarting(const Catch::TestCaseInfo&) override {
    forget_failure();
    host::test_starts();
  }
};

ordered_json described(const Failure& failure) {
  ordered_json result{{"asked", failure.asked}, {"inputs", ordered_json::array()}};
  for (const auto& [name, text] : failure.inputs) {
    result["inputs"].push_back({{"name", name}, {"text", text}});
  }
  result["got"] = failure.got;
  result["right"] = failure.right;
  if (!failure.allowed.empty()) result["allowed"] = failure.allowed;
  if (!failure.misconceptions.empty()) result["misconceptions"] = failure.misconceptions;
  if (!failure.observed.empty()) result["observed"] = failure.observed;
  if (!failure.reason.empty()) result["reason"] = failure.reason;
  return result;
}

ordered_json described(const CloserLook::Inputs& inputs) {
  ordered_json result = ordered_json::array();
  for (const auto& [name, text] : inputs) result.push_back({{"name", name}, {"text", text}});
  return result;
}

ordered_json described(const CloserLook& look) {
  ordered_json result{{"right", look.right}, {"wrong", look.wrong}};
  for (const auto& inputs : look.right_inputs) result["right_inputs"].push_back(described(inputs));
  for (const auto& inputs : look.wrong_inputs) result["wrong_inputs"].push_back(described(inputs));
  if (look.smaller) result["smaller"] = described(*look.smaller);
  return result;
}

class ContactReporter : public Catch::StreamingReporterBase {
 public:
  explicit ContactReporter(Catch::ReporterConfig&& config)
      : StreamingReporterBase(std::move(config)) {
#ifndef __wasi__  // the page asks for the last words itself
    running = this;
    std::atexit([] { running->ends_early(); });
#endif
    tell_closer_look([this] { tell_look(); });
    if (std::getenv("CONTACT_TELL_QUESTIONS") == nullptr) return;
    tell_questions([this] {
      ordered_json question = described(open_question());
      for (const char* answered : {"got", "right"}) question.erase(answered);
      print({{"event", "question"}, {"failure", std::move(question)}});
    });
  }
  static std::string getDescription() { return "one JSON object a line, as the tests run"; }

  void testCaseStarting(const Catch::TestCaseInfo& info) override {
    StreamingReporterBase::testCaseStarting(info);
    fatal_.clear();
    message_.clear();
    started_ = Clock::now();
#ifndef __wasi__
    processor_ = std::clock();
#endif
    test_ = info.name;
    print({{"event", "start"}, {"test", info.name}});
  }

  void fatalErrorEncountered(Catch::StringRef error) override { fatal_ = std::string{error}; }

  // For what is not asked through ask(): an author's own REQUIRE, or an exception outside an
  // answer.
  void assertionEnded(const Catch::AssertionStats& stats) override {
    const auto& result = stats.assertionResult;
    if (result.isOk() || !message_.empty()) return;
    message_ = result.hasExpression() ? result.getExpandedExpression() : "";
    if (result.hasMessage())
      message_ += (message_.empty() ? "" : ": ") + std::string{result.getMessage()};
  }

  void testCaseEnded(const Catch::TestCaseStats& stats) override {
    const std::chrono::duration<double> seconds = Clock::now() - started_;
    tell_look();
    ordered_json line{{"event", "end"}, {"test", stats.testInfo->name}};
    const Failure* failure = current_failure();
    if (!fatal_.empty()) {
      line["status"] = "stopped";
      Failure crash = open_question();
      crash.reason = fatal_;
      line["failure"] = described(crash);
    } else if (failure != nullptr) {
      line["status"] = failure->stopped ? "stopped" : "failed";
      line["failure"] = described(*failure);
    } else if (stats.totals.assertions.failed > 0) {
      line["status"] = "failed";
      line["failure"] = described({.asked = "",
                                   .inputs = {},
                                   .got = message_,
                                   .right = "",
                                   .allowed = "",
                                   .misconceptions = {},
                                   .observed = "",
                                   .stopped = false,
                                   .reason = ""});
    } else if (stats.totals.assertions.skipped > 0) {
      line["status"] = "not_attempted";
    } else {
      line["status"] = "passed";
      if (const Failure* found = current_finding()) line["finding"] = described(*found);
    }
    line["seconds"] = seconds.count();
#ifndef __wasi__  // a page has no such clock
    line["processor_seconds"] = static_cast<double>(std::clock() - processor_) / CLOCKS_PER_SEC;
#endif
    test_.clear();
    print(line);
    StreamingReporterBase::testCaseEnded(stats);
  }

  void testRunEnded(const Catch::TestRunStats&) override { print({{"event", "done"}}); }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point started_;
  std::string test_, fatal_, message_;
#ifndef __wasi__
  std::clock_t processor_ = 0;
  static inline ContactReporter* running = nullptr;

  // exit() unwinds nothing: the question is still open, and the reporter still there.
  void ends_early() {
    if (test_.empty()) return;
    const std::chrono::duration<double> seconds = Clock::now() - started_;
    print({{"event", "end"},
           {"test", test_},
           {"status", "stopped"},
           {"failure", described(open_question())},
           {"seconds", seconds.count()}});
  }
#endif

  void tell_look() {
    const CloserLook* look = closer_look();
    if (look != nullptr) print({{"event", "look"}, {"test", test_}, {"look", described(*look)}});
  }

  void print(const ordered_json& line) {
    // Text that came from the code under test need not be UTF-8.
    m_stream << line.dump(-1, ' ', false, ordered_json::error_handler_t::replace) << std::endl;
  }
};

}  // namespace

CATCH_REGISTER_LISTENER(TestStarts)
CATCH_REGISTER_REPORTER("contact", ContactReporter)

}  // namespace contact::testing

int main(int argc, char* argv[]) {
#ifndef __wasi__
  contact::remote::limit_resources();
#endif
  Catch::Session session;
  session.configData().runOrder = Catch::TestRunOrder::Declared;
  if (const int error = session.applyCommandLine(argc, argv); error != 0) return error;
  return session.run();
}
