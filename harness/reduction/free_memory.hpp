#pragma once
// How much memory there is to take.

namespace signorini {

/// Memory that programs can still take, without swapping [bytes]; without bound where the system does not
/// tell.
double free_memory();

}  // namespace signorini
