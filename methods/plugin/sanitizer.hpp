#pragma once
// The sanitizer that a translation unit is compiled with: GCC and Clang tell it in different ways.

#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define SIGNORINI_ADDRESS_SANITIZER 1
#elif __has_feature(thread_sanitizer)
#define SIGNORINI_THREAD_SANITIZER 1
#endif
#endif

#if defined(__SANITIZE_ADDRESS__) || defined(SIGNORINI_ADDRESS_SANITIZER)
#define SIGNORINI_SANITIZER "address"
#elif defined(__SANITIZE_THREAD__) || defined(SIGNORINI_THREAD_SANITIZER)
#define SIGNORINI_SANITIZER "thread"
#else
#define SIGNORINI_SANITIZER "none"
#endif

namespace signorini {

/// It reserves terabytes of address space, so that no limit of it can be set.
inline constexpr bool kAddressSanitizer = SIGNORINI_SANITIZER[0] == 'a';

}  // namespace signorini
