#include "stop_words.hpp"

#include <algorithm>
#include <csignal>
#include <cstring>
#include <string_view>

#include "../verdict/verdict.hpp"

namespace contact::grading {

namespace {

// An assertion's own sentence is worth more than the name of its signal.
std::string assertion_in(const std::string& printed) {
  if (const std::size_t at = printed.rfind("terminate called"); at != std::string::npos) {
    std::string text = printed.substr(at, 600);
    while (!text.empty() && text.back() == '\n') text.pop_back();
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text;
  }
  std::size_t at = printed.rfind("Assertion `");
  if (at == std::string::npos) at = printed.rfind("Assertion '");
  if (at == std::string::npos) return {};
  const std::size_t start =
      printed.rfind('\n', at) == std::string::npos ? 0 : printed.rfind('\n', at) + 1;
  const std::string before = printed.substr(start, at - start);
  std::string sentence =
      printed.substr(at, std::min<std::size_t>(printed.find('\n', at) - at, 400));
  // Most assertions that a student meets are a library's own, about an index or an empty container.
  if (before.find("/Eigen/") != std::string::npos)
    return "Eigen found a wrong index or size: " + sentence;
  if (before.find("/c++/") != std::string::npos)
    return "the standard library found a wrong index or an empty container: " + sentence;
  return sentence;
}

// The output of a program, without the line that is already in the reason.
std::string without_assertion(const std::string& printed) {
  std::string result;
  std::size_t at = 0;
  while (at < printed.size()) {
    const std::size_t end = std::min(printed.find('\n', at), printed.size() - 1) + 1;
    const std::string line = printed.substr(at, end - at);
    if (line.find("Assertion `") == std::string::npos &&
        line.find("Assertion '") == std::string::npos)
      result += line;
    at = end;
  }
  return result;
}

std::string seconds_text(double seconds) {
  const std::string text = points_text(seconds);
  return text + (text == "1" ? " second" : " seconds");
}

}  // namespace

std::string why_stopped(const ProcessResult& process, double seconds) {
  switch (process.ended) {
    case Ended::time:
      return "no answer after " + seconds_text(seconds) + ": an endless loop, or far too much work";
    case Ended::idle:
      return "waited for " + seconds_text(seconds) +
             " in all and did nothing: a sleep, a lock that it holds itself, or a read of "
             "something that never comes";
    case Ended::output:
      return printed_too_much;
    case Ended::by_itself:
    case Ended::unwanted:
      break;
  }
  if (process.signal != 0) return signal_in_words(process.signal, process.errors);
  return "the program ended by itself (exit code " + std::to_string(process.exit_code) +
         "): does your code call exit()?";
}

std::string signal_in_words(int signal, const std::string& printed) {
  const std::string assertion = assertion_in(printed);
  switch (signal) {
    case SIGSEGV:
    case SIGBUS:
      return "segmentation fault: it touched memory that is not its own (an index out of range, an "
             "empty optional or "
             "container, or a function that calls itself without end)";
    case SIGABRT:
      return assertion.empty()
                 ? "aborted: it called abort(), or an exception left a noexcept function"
                 : "aborted: " + assertion;
    case SIGFPE:
      return "arithmetic fault: an integer was divided by zero";
    case SIGILL:
    case SIGTRAP:
      return "illegal instruction: often the end of a function that promises a value and returns "
             "none";
    case SIGKILL:
      return "killed by the system: out of memory?";
    default:
      return std::string("ended by signal ") + std::to_string(signal) + " (" + ::strsignal(signal) +
             ")";
  }
}

std::string errors_not_told(const ProcessResult& process) {
  return process.signal == SIGABRT ? without_assertion(process.errors) : process.errors;
}

}  // namespace contact::grading
