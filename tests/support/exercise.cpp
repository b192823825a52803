#include <support/exercise.hpp>

#include <catch2/internal/catch_test_failure_exception.hpp>
#include <cstdlib>
#include <new>
#include <optional>
#include <set>
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
  for (const std::string& id : f.misconceptions) text += "  hint:      " + id + '\n';
  if (!f.observed.empty()) text += "  hint:      " + f.observed + '\n';
  if (!f.reason.empty()) text += (f.stopped ? "  stopped:   " : "  why:       ") + f.reason + '\n';
  return text;
}

CloserLook::Inputs inputs_of(const detail::Asked& asked, const TextLimits& limits = {}) {
  CloserLook::Inputs inputs;
  for (const auto& given : asked.givens)
    inputs.emplace_back(given.name, given.text(given.value, limits));
  return inputs;
}

Failure described(const detail::Asked& asked) {
  Failure f;
  f.asked = asked.question;
  f.inputs = inputs_of(asked);
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

std::optional<CloserLook>& look() {
  static std::optional<CloserLook> current;
  return current;
}

std::string_view wanted_look() {
  const char* text = std::getenv("CONTACT_LOOK");
  return text == nullptr ? "" : text;
}

/// Adds the inputs of a question to those that are shown, if these are few.
void add_inputs(std::vector<CloserLook::Inputs>& shown, const detail::Asked& asked) {
  constexpr std::size_t most = 3;
  constexpr TextLimits short_text{.elements = 8, .characters = 60, .digits = 4};
  if (shown.size() < most) shown.push_back(inputs_of(asked, short_text));
}

/// Where the failure of a probe goes; nullptr outside of one.
std::optional<Failure>* probed = nullptr;
std::function<void()> told_of_look;

/// Whether the test goes on after this failure.
bool goes_on(const detail::Asked& asked, const Failure& f) {
  if (probed != nullptr) {
    if (!*probed) *probed = f;
    return true;
  }
  if (!look()) return false;
  ++look()->wrong;
  add_inputs(look()->wrong_inputs, asked);
  if (!failure()) failure() = f;
  return true;
}

void end_test(const detail::Asked& asked, Failure f) {
  if (goes_on(asked, f)) return;
  failure() = std::move(f);
  FAIL(told(*failure()));
}

detail::Ending stop_test(const detail::Asked& asked, std::string reason) {
  Failure f = described(asked);
  f.stopped = true;
  f.reason = std::move(reason);
  end_test(asked, std::move(f));
  return {.thrown = "", .invalid_argument = false, .told = true};
}

}  // namespace

const Failure* current_failure() { return failure() ? &*failure() : nullptr; }
const Failure* current_finding() { return finding() ? &*finding() : nullptr; }
void forget_failure() {
  failure().reset();
  finding().reset();
  look().reset();
  if (!wanted_look().empty()) look().emplace();
}
const CloserLook* closer_look() { return look() ? &*look() : nullptr; }
void tell_closer_look(std::function<void()> tell) { told_of_look = std::move(tell); }
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
namespace {

std::set<std::string>& all_refuted() {
  static std::set<std::string> keys;
  return keys;
}

std::string key_of(const Asked& asked, std::string_view misconception, std::size_t nth) {
  return std::string{asked.question} + '\n' + std::string{misconception} + '\n' +
         std::to_string(nth);
}

}  // namespace

bool refuted(const Asked& asked, std::string_view misconception, std::size_t nth) {
  return all_refuted().contains(key_of(asked, misconception, nth));
}

void refute(const Asked& asked, std::string_view misconception, std::size_t nth) {
  all_refuted().insert(key_of(asked, misconception, nth));
}

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
    return stop_test(asked, stopped.what());
  } catch (const std::invalid_argument& error) {
    return {"threw std::invalid_argument: " + std::string{error.what()}, true, false};
  } catch (const std::bad_alloc&) {
    return stop_test(asked, "ran out of memory");
  } catch (const std::exception& error) {
    return stop_test(asked, "threw an exception: " + std::string{error.what()});
  } catch (...) {
    return stop_test(asked, "threw something that is not a std::exception");
  }
}

void fail(Failure report) {
  failure() = std::move(report);
  FAIL(told(*failure()));
  std::abort();  // FAIL throws
}

void show(Failure report) { finding() = std::move(report); }

void fail(const Asked& asked, std::string got, std::string right, std::string allowed,
          std::vector<std::string> misconceptions, std::string observed) {
  Failure f = described(asked);
  f.got = std::move(got);
  f.right = std::move(right);
  f.allowed = std::move(allowed);
  if (misconceptions.empty()) f.observed = std::move(observed);
  f.misconceptions = std::move(misconceptions);
  end_test(asked, std::move(f));
}

void pass(const Asked& asked) {
  if (!look() || probed != nullptr) return;
  ++look()->right;
  add_inputs(look()->right_inputs, asked);
}

bool wants_smaller() {
  return probed == nullptr && look() && !look()->smaller && wanted_look() == "smaller";
}

std::optional<Failure> probe(const std::function<void()>& ask) {
  std::optional<Failure> found;
  probed = &found;
  try {
    ask();
  } catch (const Catch::TestSkipException&) {
    probed = nullptr;
    throw;
  } catch (...) {
    found.reset();  // a test's own exception: these inputs cannot be judged
  }
  probed = nullptr;
  return found;
}

void found_smaller(Failure smaller) {
  look()->smaller = std::move(smaller);
  if (told_of_look) told_of_look();
}

}  // namespace detail
}  // namespace contact::testing
