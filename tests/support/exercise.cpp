#include <support/exercise.hpp>

#include <catch2/internal/catch_test_failure_exception.hpp>
#include <cstdlib>
#include <new>
#include <optional>
#include <stdexcept>

#include <contact/host.hpp>

namespace contact {

// The host's part of the prelude: here, a test that meets an unfinished function is skipped.
[[noreturn]] void todo();
void todo() {
  SKIP("not attempted");
  std::abort();  // SKIP throws
}

}  // namespace contact

namespace contact::testing {
namespace {

std::optional<Failure>& failure() {
  static std::optional<Failure> current;
  return current;
}

std::optional<Failure>& finding() {
  static std::optional<Failure> current;
  return current;
}

std::string told(const Failure& f) {
  std::string text = "\n" + f.asked + '\n';
  for (const auto& [name, value] : f.inputs) text += "  " + name + " = " + value + '\n';
  if (!f.got.empty()) text += "  came back: " + f.got + '\n';
  if (!f.right.empty()) text += "  right:     " + f.right + '\n';
  if (!f.allowed.empty()) text += "  allowed:   " + f.allowed + '\n';
  if (!f.misconception.empty()) text += "  hint:      " + f.misconception + '\n';
  if (!f.reason.empty()) text += (f.stopped ? "  stopped:   " : "  why:       ") + f.reason + '\n';
  return text;
}

Failure described(const detail::Asked& asked) {
  Failure f;
  f.asked = asked.question;
  for (const auto& given : asked.givens) f.inputs.emplace_back(given.name, given.text(given.value));
  return f;
}

const detail::Asked* open = nullptr;
std::function<void()> told_of_questions;

/// Marks a question as open while it lives.
class Open {
 public:
  explicit Open(const detail::Asked& asked) {
    open = &asked;
    if (told_of_questions) told_of_questions();
  }
  ~Open() { open = nullptr; }
  Open(const Open&) = delete;
  Open& operator=(const Open&) = delete;
};

[[noreturn]] void end_test(Failure f) {
  failure() = std::move(f);
  FAIL(told(*failure()));
  std::abort();  // FAIL throws
}

[[noreturn]] void stop_test(const detail::Asked& asked, std::string reason) {
  Failure f = described(asked);
  f.stopped = true;
  f.reason = std::move(reason);
  end_test(std::move(f));
}

}  // namespace

const Failure* current_failure() { return failure() ? &*failure() : nullptr; }
const Failure* current_finding() { return finding() ? &*finding() : nullptr; }
void forget_failure() {
  failure().reset();
  finding().reset();
}
void tell_questions(std::function<void()> tell) { told_of_questions = std::move(tell); }
Failure open_question() { return open != nullptr ? described(*open) : Failure{}; }

std::uint64_t seed(std::uint64_t stream) {
  const char* text = std::getenv("CONTACT_SEED");
  std::uint64_t x = 20;
  if (text != nullptr && *text != '\0') {
    // FNV-1a over the whole text, so that any two seeds differ, in words or in digits.
    x = 0xcbf29ce484222325u;
    for (const char c : std::string_view{text}) {
      x = (x ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
    }
  }
  // splitmix64, so that neighbouring seeds and streams have nothing in common.
  x += 0x9e3779b97f4a7c15u * (stream + 1);
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

Within within(double tolerance) {
  return {{tolerance}, "\u00b1" + text_of(tolerance, {.digits = 2})};
}

namespace detail {

Ending run(const Asked& asked, const std::function<void()>& call) {
  try {
    const Open question(asked);
    call();
    return {};
  } catch (const Catch::TestSkipException&) {
    throw;
  } catch (const Catch::TestFailureException&) {
    throw;
  } catch (const host::Stopped& stopped) {
    stop_test(asked, stopped.what());
  } catch (const std::invalid_argument& error) {
    return {"threw std::invalid_argument: " + std::string{error.what()}, true};
  } catch (const std::bad_alloc&) {
    stop_test(asked, "ran out of memory");
  } catch (const std::exception& error) {
    stop_test(asked, "threw an exception: " + std::string{error.what()});
  } catch (...) {
    stop_test(asked, "threw something that is not a std::exception");
  }
}

void fail(Failure report) { end_test(std::move(report)); }

void show(Failure report) { finding() = std::move(report); }

void fail(const Asked& asked, std::string got, std::string right, std::string allowed,
          std::string_view misconception) {
  Failure f = described(asked);
  f.got = std::move(got);
  f.right = std::move(right);
  f.allowed = std::move(allowed);
  f.misconception = misconception;
  end_test(std::move(f));
}

}  // namespace detail
}  // namespace contact::testing
