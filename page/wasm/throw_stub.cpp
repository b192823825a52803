// Figures and ladders do not catch, so they need no unwinding: a throw says what it threw, on
// stderr, and traps. The page shows the sentence and goes on; the module's instance is not used
// again.
#include <unistd.h>
#include <__verbose_abort>

#include <cstddef>
#include <cstring>
#include <new>
#include <stdexcept>
#include <typeinfo>

namespace {

void say(const char* text) {
  // Nothing better can be done if this fails.
  [[maybe_unused]] const auto written = write(2, text, std::strlen(text));
}

template <typename... Errors>
const char* message(const void* thrown, const std::type_info& type) {
  const char* text = nullptr;
  const auto try_one = [&]<typename Error>(const Error*) {
    if (type == typeid(Error)) text = static_cast<const Error*>(thrown)->what();
  };
  (try_one(static_cast<const Errors*>(nullptr)), ...);
  return text;
}

}  // namespace

// The libraries' own last words, which they would print with all of printf.
extern "C" [[noreturn]] void __abort_message(const char* format, ...) {
  say(format);
  __builtin_trap();
}

_LIBCPP_BEGIN_NAMESPACE_STD
[[noreturn]] void __libcpp_verbose_abort(const char* format, ...) noexcept {
  say(format);
  __builtin_trap();
}
_LIBCPP_END_NAMESPACE_STD

extern "C" {

void* __cxa_allocate_exception(std::size_t size) {
  // One is enough: the first throw is the last.
  alignas(std::max_align_t) static unsigned char room[1024];
  if (size > sizeof room) __builtin_trap();
  return room;
}

void __cxa_free_exception(void*) {}

[[noreturn]] void __cxa_throw(void* thrown, std::type_info* type, void* (*)(void*)) {
  const char* text =
      message<std::invalid_argument, std::domain_error, std::out_of_range, std::length_error,
              std::logic_error, std::range_error, std::overflow_error, std::underflow_error,
              std::runtime_error, std::bad_alloc>(thrown, *type);
  say(text != nullptr ? text : type->name());
  say("\n");
  __builtin_trap();
}
}
