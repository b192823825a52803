// The heap of a figure, in a tenth of what the C library's takes to load: a page has several
// figures. Blocks have sizes of powers of two; freed ones wait in a list for each size, and nothing
// is joined or given back.
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstring>

extern "C" unsigned char __heap_base;

namespace {

/// Before what is handed out, which is at a multiple of 16.
struct alignas(16) Header {
  std::uint32_t bits;    ///< the block has 2^bits bytes
  std::uint32_t offset;  ///< from its start to what is handed out
};

/// In the place of the header, while the block is free.
struct Free {
  Free* next;
};

Free* waiting[32];
std::uintptr_t unused;

constexpr std::uint32_t fewest_bits = 5, max_bits = 30;

std::uintptr_t round_up(std::uintptr_t address, std::size_t alignment) {
  return (address + alignment - 1) & ~(alignment - 1);
}

/// A block that was never handed out; 0 if there is no more memory.
std::uintptr_t new_block(std::uint32_t bits) {
  constexpr std::uintptr_t page = 65536;
  if (unused == 0) unused = round_up(reinterpret_cast<std::uintptr_t>(&__heap_base), 16);
  const std::uintptr_t size = std::uintptr_t(1) << bits, end = unused + size;
  const std::uintptr_t there = __builtin_wasm_memory_size(0) * page;
  if (end < unused) return 0;
  if (end > there && __builtin_wasm_memory_grow(0, (end - there + page - 1) / page) == SIZE_MAX)
    return 0;
  const std::uintptr_t block = unused;
  unused = end;
  return block;
}

void* allocate(std::size_t size, std::size_t alignment) {
  if (alignment < sizeof(Header)) alignment = sizeof(Header);
  if (size > std::size_t(1) << (max_bits - 1) || alignment > std::size_t(1) << (max_bits - 2))
    return nullptr;
  std::uint32_t bits = fewest_bits;
  while ((std::size_t(1) << bits) < size + alignment) ++bits;
  std::uintptr_t block = reinterpret_cast<std::uintptr_t>(waiting[bits]);
  if (block != 0) {
    waiting[bits] = waiting[bits]->next;
  } else {
    block = new_block(bits);
    if (block == 0) return nullptr;
  }
  const std::uintptr_t given = round_up(block + sizeof(Header), alignment);
  reinterpret_cast<Header*>(given)[-1] = {bits, std::uint32_t(given - block)};
  return reinterpret_cast<void*>(given);
}

}  // namespace

extern "C" {

void* malloc(std::size_t size) { return allocate(size, 1); }

void free(void* given) {
  if (given == nullptr) return;
  const Header header = static_cast<Header*>(given)[-1];
  Free* block = reinterpret_cast<Free*>(reinterpret_cast<std::uintptr_t>(given) - header.offset);
  block->next = waiting[header.bits];
  waiting[header.bits] = block;
}

void* calloc(std::size_t count, std::size_t size) {
  std::size_t bytes = 0;
  if (__builtin_mul_overflow(count, size, &bytes)) return nullptr;
  void* given = malloc(bytes);
  return given == nullptr ? nullptr : std::memset(given, 0, bytes);
}

void* realloc(void* given, std::size_t size) {
  void* larger = malloc(size);
  if (given == nullptr || larger == nullptr) return larger;
  const Header header = static_cast<Header*>(given)[-1];
  const std::size_t room = (std::size_t(1) << header.bits) - header.offset;
  std::memcpy(larger, given, room < size ? room : size);
  free(given);
  return larger;
}

void* aligned_alloc(std::size_t alignment, std::size_t size) { return allocate(size, alignment); }

int posix_memalign(void** given, std::size_t alignment, std::size_t size) {
  *given = allocate(size, alignment);
  return *given == nullptr ? ENOMEM : 0;
}

// By these names the C library calls its own.
void* __libc_malloc(std::size_t size) { return malloc(size); }
void* __libc_calloc(std::size_t count, std::size_t size) { return calloc(count, size); }
void __libc_free(void* given) { free(given); }
}
