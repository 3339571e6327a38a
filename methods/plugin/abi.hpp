#pragma once
// What a plugin and the program that loads it must have in common, as text fixed when each is compiled.

#include <Eigen/Core>
#include <version>

#include "methods/plugin/interface.hpp"

/// Version of the entry point and of what it returns. Everything else is compared by kPluginAbi.
#define SIGNORINI_PLUGIN_API 2

#define SIGNORINI_TEXT_OF(value) #value
#define SIGNORINI_TEXT(value) SIGNORINI_TEXT_OF(value)

#ifdef _LIBCPP_VERSION
#define SIGNORINI_STANDARD_LIBRARY "libc++ " SIGNORINI_TEXT(_LIBCPP_ABI_VERSION)
#else
#define SIGNORINI_STANDARD_LIBRARY "libstdc++ " SIGNORINI_TEXT(_GLIBCXX_USE_CXX11_ABI)
#endif

#if defined(_GLIBCXX_DEBUG)
#define SIGNORINI_LIBRARY_CHECKS "debug"
#elif defined(_GLIBCXX_ASSERTIONS)
#define SIGNORINI_LIBRARY_CHECKS "assertions"
#else
#define SIGNORINI_LIBRARY_CHECKS "none"
#endif

#if defined(__SANITIZE_ADDRESS__)
#define SIGNORINI_SANITIZER "address"
#elif defined(__SANITIZE_THREAD__)
#define SIGNORINI_SANITIZER "thread"
#else
#define SIGNORINI_SANITIZER "none"
#endif

namespace signorini {

/// "item=value;..." of all that decides how objects lie in memory and which functions they meet: two
/// translation units with equal texts may hand each other C++ objects. The alignment of Eigen's types follows
/// from flags such as -mavx; `headers` is a hash of the headers of problems/ and methods/.
constexpr const char* kPluginAbi =                                                             //
    "compiler ABI=" SIGNORINI_TEXT(__GXX_ABI_VERSION)                                          //
    ";standard library=" SIGNORINI_STANDARD_LIBRARY                                            //
    ";checks of the standard library=" SIGNORINI_LIBRARY_CHECKS                                //
    ";pointer size=" SIGNORINI_TEXT(__SIZEOF_POINTER__)                                        //
    ";Eigen=" SIGNORINI_TEXT(EIGEN_WORLD_VERSION) "." SIGNORINI_TEXT(EIGEN_MAJOR_VERSION) "."  //
    SIGNORINI_TEXT(EIGEN_MINOR_VERSION)                                                        //
    ";EIGEN_MAX_ALIGN_BYTES=" SIGNORINI_TEXT(EIGEN_MAX_ALIGN_BYTES)                            //
    ";sanitizer=" SIGNORINI_SANITIZER                                                          //
    ";headers=" SIGNORINI_HEADERS;

}  // namespace signorini
