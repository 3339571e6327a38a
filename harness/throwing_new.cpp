// `operator new` of the program that is linked to mimalloc: that library is C, and its own ends the process
// where memory is short. Everything above relies on std::bad_alloc: a case that needs too much is told as out
// of memory. And what it takes for itself before `main`, asked for before that: it, and the BLAS, end the
// process without a word where they do not get it.

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <new>
#include <string_view>

namespace {

/// What allocator and BLAS take of the address space for the smallest solve, 160 MiB measured, and a little
/// more [bytes].
constexpr std::size_t kRoom = std::size_t{192} << 20U;

/// Ends a process whose limit of address space (`ulimit -v`) leaves less, in one line. No library has begun
/// yet: system calls alone.
void require_room(int /*argc*/, char** /*argv*/, char** /*environment*/) {
  constexpr std::string_view kRefusal =
      "machine = full (must allow 192 MiB of address space beside the program and its libraries: ulimit "
      "-v)\n";
  constexpr int kBadUsage = 2;
  void* const room = mmap(nullptr, kRoom, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (room != MAP_FAILED) {
    munmap(room, kRoom);
    return;
  }
  static_cast<void>(!write(STDERR_FILENO, kRefusal.data(), kRefusal.size()));
  _exit(kBadUsage);
}

// Called before the first function of any library.
// NOLINTNEXTLINE(cppcoreguidelines-avoid-non-const-global-variables): a list that the loader reads
[[gnu::section(".preinit_array"), gnu::used]] void (*first)(int, char**, char**) = require_room;

void* required(void* memory) {
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

void* plain(std::size_t size) noexcept { return std::malloc(std::max<std::size_t>(size, 1)); }

void* aligned(std::size_t size, std::align_val_t alignment) noexcept {
  const auto step = static_cast<std::size_t>(alignment);
  const std::size_t whole = (std::max<std::size_t>(size, 1) + step - 1) / step * step;
  return whole < size ? nullptr : std::aligned_alloc(step, whole);
}

}  // namespace

void* operator new(std::size_t size) { return required(plain(size)); }
void* operator new[](std::size_t size) { return required(plain(size)); }
void* operator new(std::size_t size, const std::nothrow_t& /*none*/) noexcept { return plain(size); }
void* operator new[](std::size_t size, const std::nothrow_t& /*none*/) noexcept { return plain(size); }
void* operator new(std::size_t size, std::align_val_t alignment) {
  return required(aligned(size, alignment));
}
void* operator new[](std::size_t size, std::align_val_t alignment) {
  return required(aligned(size, alignment));
}
void* operator new(std::size_t size, std::align_val_t alignment, const std::nothrow_t& /*none*/) noexcept {
  return aligned(size, alignment);
}
void* operator new[](std::size_t size, std::align_val_t alignment, const std::nothrow_t& /*none*/) noexcept {
  return aligned(size, alignment);
}
