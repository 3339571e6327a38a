#pragma once
// How much memory there is to take.

#include <filesystem>

namespace signorini {

/// Memory that this process can still take, without swapping [bytes]: what the machine has available, and
/// what each control group that the process is in leaves of its limit (versions 1 and 2; containers and
/// clusters set them). Pages of files that were read count as free: the system drops them. Without bound
/// where nothing tells. \param root  below which /proc and /sys are read
double free_memory(const std::filesystem::path& root = "/");

}  // namespace signorini
