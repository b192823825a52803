// The memory of GMP's numbers under AddressSanitizer. The oracle makes and frees millions of small
// numbers, and what the sanitizer does for each allocation takes longer than the arithmetic: 60 %
// of the time of tests/03_polygons. Only GMP and MPFR work in this memory. They are not
// instrumented, so the sanitizer would only see that a number is never freed, or twice, and Boost's
// classes see to that. Whatever exceeds 256 bytes is allocated like everything else.
#include <gmp.h>

#include <array>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <new>

namespace {

struct Unused {
  Unused* next;
};

constexpr std::size_t step = 16;
constexpr std::size_t largest = 256;
constexpr std::size_t block_size = 1u << 16;

// Of each size that is a multiple of `step`, what is unused; and the block that new memory comes
// from.
thread_local constinit std::array<Unused*, largest / step + 1> unused{};
thread_local constinit char* block = nullptr;
thread_local constinit std::size_t left = 0;

// A size of 0 counts as 1: GMP may ask for it.
std::size_t steps_of(std::size_t size) { return size == 0 ? 1 : (size + step - 1) / step; }

// GMP has no way to report that memory is exhausted.
void* allocated(void* memory) {
  if (memory == nullptr) std::abort();
  return memory;
}

void* take(std::size_t size) {
  const std::size_t steps = steps_of(size);
  if (steps >= unused.size()) return allocated(std::malloc(size));
  if (Unused* const first = unused[steps]) {
    unused[steps] = first->next;
    return first;
  }
  if (left < steps * step) {
    block = static_cast<char*>(allocated(std::malloc(block_size)));
    left = block_size;
  }
  char* const memory = block;
  block += steps * step;
  left -= steps * step;
  return memory;
}

void give_back(void* memory, std::size_t size) {
  const std::size_t steps = steps_of(size);
  if (steps >= unused.size()) {
    std::free(memory);
    return;
  }
  unused[steps] = new (memory) Unused{unused[steps]};
}

void* resize(void* memory, std::size_t old_size, std::size_t new_size) {
  const std::size_t old_steps = steps_of(old_size);
  const std::size_t new_steps = steps_of(new_size);
  if (old_steps >= unused.size() && new_steps >= unused.size())
    return allocated(std::realloc(memory, new_size));
  if (old_steps == new_steps) return memory;
  void* const moved = take(new_size);
  std::memcpy(moved, memory, old_size < new_size ? old_size : new_size);
  give_back(memory, old_size);
  return moved;
}

// Before every other initialisation: a number that GMP's own functions allocated must not be given
// back here.
[[gnu::constructor(101)]] void use_this_memory() {
  mp_set_memory_functions(take, resize, give_back);
}

}  // namespace
