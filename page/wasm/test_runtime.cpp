// What the compiler's libraries lack for a program whose exceptions work. They were compiled
// without exceptions: where they would throw, they call a function that ends the program, and say
// in words what it would have been. Here that function throws it, so that std::string::at,
// std::stoi, operator new and the rest end as they do natively.
#include <wasi/api.h>

#include <cassert>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <ios>
#include <new>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>
#include <typeinfo>
#include <vector>

namespace {

template <class Error>
[[noreturn]] void raise(const char* message) {
  if constexpr (std::is_constructible_v<Error, const char*>) {
    throw Error(message);
  } else {
    throw Error();
  }
}

struct Kind {
  std::string_view name;
  void (*raise)(const char* message);
};

constexpr Kind kinds[] = {
    {"bad_alloc", raise<std::bad_alloc>},
    {"bad_array_new_length", raise<std::bad_array_new_length>},
    {"bad_cast", raise<std::bad_cast>},
    {"invalid_argument", raise<std::invalid_argument>},
    {"length_error", raise<std::length_error>},
    {"out_of_range", raise<std::out_of_range>},
    {"overflow_error", raise<std::overflow_error>},
    {"runtime_error", raise<std::runtime_error>},
    {"ios_base::failure", raise<std::ios_base::failure>},
};

/// What our __assertion_handler gives: "FILE:LINE: libc++ Hardening assertion EXPRESSION failed:
/// WHAT". Ends as assert() does, in whose words the host looks for it.
void end_if_assertion(std::string_view words) {
  constexpr std::string_view begin = ": libc++ Hardening assertion ", finish = " failed: ";
  const auto from = words.find(begin), to = words.rfind(finish);
  if (from == words.npos || to == words.npos || to < from) return;
  const auto colon = words.rfind(':', from - 1);
  if (colon == words.npos) return;
  const std::string expression{words.substr(from + begin.size(), to - from - begin.size())};
  const std::string file{words.substr(0, colon)};
  const std::string line{words.substr(colon + 1, from - colon - 1)};
  __assert_fail(expression.c_str(), file.c_str(), std::atoi(line.c_str()), "libc++");
}

/// Throws what the words name, if it is known; else says them and ends the program.
[[noreturn]] void end(const char* format, va_list values) {
  constexpr std::string_view thrown = " was thrown in -fno-exceptions mode";
  const std::string_view words{format};
  const auto name = words.substr(0, words.find(thrown));
  if (name.size() < words.size()) {
    const bool has_message = words.find("%s") != words.npos;
    if (name == "system_error") {
      const int code = va_arg(values, int);
      throw std::system_error(code, std::generic_category(), va_arg(values, const char*));
    }
    for (const auto& kind : kinds) {
      if (kind.name == name) kind.raise(has_message ? va_arg(values, const char*) : "");
    }
  }
  if (words == "%s") {
    const char* message = va_arg(values, const char*);
    end_if_assertion(message);
    std::fputs(message, stderr);
  } else {
    std::vfprintf(stderr, format, values);
  }
  std::fputc('\n', stderr);
  std::abort();
}

}  // namespace

extern "C" {

/// libc's traps, as a null pointer that is followed does. The exit code tells the host which it
/// was: 128 plus the number of SIGABRT, as in a shell.
void abort() { __wasi_proc_exit(134); }

// libc++'s std::__libcpp_verbose_abort. Its declaration promises not to throw; its callers were
// compiled without exceptions, so throwing is harmless.
[[noreturn]] void contact_library_ends(const char* format,
                                       ...) __asm__("_ZNSt3__222__libcpp_verbose_abortEPKcz");
void contact_library_ends(const char* format, ...) {
  va_list values;
  va_start(values, format);
  end(format, values);
}

// libc++abi's, for operator new.
[[noreturn]] void __abort_message(const char* format, ...);
void __abort_message(const char* format, ...) {
  va_list values;
  va_start(values, format);
  end(format, values);
}

int __main_argc_argv(int count, char** arguments);
int __main_void();

/// As libc has it. Here, so that a student's own main() is a second one: the linker says so, as it
/// does natively, and does not run it in the place of the tests.
int __main_void() {
  __wasi_size_t count = 0, size = 0;
  if (__wasi_args_sizes_get(&count, &size) != 0) return 71;
  std::vector<char> text(size + 1);
  std::vector<char*> arguments(count + 1);
  if (__wasi_args_get(reinterpret_cast<std::uint8_t**>(arguments.data()),
                      reinterpret_cast<std::uint8_t*>(text.data())) != 0)
    return 71;
  arguments[count] = nullptr;
  return __main_argc_argv(static_cast<int>(count), arguments.data());
}
}
