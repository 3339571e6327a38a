#include "harness/report/document/section.hpp"

#include <fmt/format.h>

namespace signorini {

void Rows::close() {
  if (count_ <= kMostRows) return;
  section_.note = fmt::format("These are the first {} of {} rows; {}.{}{}", kMostRows, count_, elsewhere_,
                              section_.note.empty() ? "" : " ", section_.note);
}

}  // namespace signorini
