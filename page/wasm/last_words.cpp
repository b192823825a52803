// Lets the page query a test program that has crashed. A trap ends the program immediately, but its
// memory still exists: the host takes the address of a spare stack for the stack pointer (the
// program's own may be used up, and still holds the question), calls contact_last_words, and reads
// text at the address that it gives back.
#include <array>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include <support/exercise.hpp>

namespace {

alignas(16) std::array<std::byte, 256 * 1024> spare_stack;

/// Given back before the last words, which need memory too.
auto reserve = std::make_unique<std::array<std::byte, 64 * 1024>>();

}  // namespace

extern "C" {

void* contact_spare_stack();
const char* contact_last_words();

/// Uses no stack itself.
void* contact_spare_stack() { return spare_stack.data() + spare_stack.size(); }

/// {"asked":…,"inputs":[{"name","text"}…]} of the question whose answer was being computed, both
/// empty if there was none. What the program printed and did not flush is flushed.
const char* contact_last_words() {
  using nlohmann::ordered_json;
  static std::string text;
  reserve.reset();
  std::fflush(nullptr);
  const auto open = contact::testing::open_question();
  ordered_json words{{"asked", open.asked}, {"inputs", ordered_json::array()}};
  for (const auto& [name, value] : open.inputs) {
    words["inputs"].push_back({{"name", name}, {"text", value}});
  }
  text = words.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
  return text.c_str();
}
}
