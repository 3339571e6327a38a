// `operator new` of the program that is linked to mimalloc: that library is C, and its own ends the process
// where memory is short. Everything above relies on std::bad_alloc: a case that needs too much is told as out
// of memory.

#include <algorithm>
#include <cstdlib>
#include <new>

namespace {

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
