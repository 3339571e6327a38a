#pragma once
// How long the allocator keeps what is freed.

namespace signorini {

/// While one of them exists, freed blocks go back to the system after so many milliseconds, where the
/// allocator is mimalloc; else after 25. With 0, lists that grow while large files are read do not free
/// hundreds of megabytes that nobody uses; with longer than a step takes, what takes and frees the same large
/// blocks in each is spared to have them zeroed anew (docs/decisions/0051-allocator.md).
class FreedAfter {
 public:
  explicit FreedAfter(long milliseconds);
  ~FreedAfter();
  FreedAfter(const FreedAfter&) = delete;
  FreedAfter& operator=(const FreedAfter&) = delete;

 private:
  long before_ = 0;  // delay [ms]
};

}  // namespace signorini
