#pragma once
// Memory that goes back to the system while large files are read.

namespace signorini {

/// While one of them exists, freed blocks go back to the system at once, where the allocator is mimalloc. It
/// keeps them for 25 ms otherwise, in which lists that grow free hundreds of megabytes; solves, which free
/// and take large blocks again and again, are faster with that (docs/decisions/0051-allocator.md).
class FreedAtOnce {
 public:
  FreedAtOnce();
  ~FreedAtOnce();
  FreedAtOnce(const FreedAtOnce&) = delete;
  FreedAtOnce& operator=(const FreedAtOnce&) = delete;

 private:
  long before_ = 0;  // delay [ms]
};

}  // namespace signorini
