// What a plugin linked with -ffast-math does in its own way: other arithmetic for the whole process.
#include <cfenv>

namespace {
const int kUpward = std::fesetround(FE_UPWARD);
}
