#pragma once
// A method outside the tree: a shared object with one C entry point, written by
//
//     SIGNORINI_PLUGIN(my::Method)
//
// at the end of its source, outside of all namespaces. docs/plugins.md tells how one is built and loaded.

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <version>

#include "methods/catalogue.hpp"
#include "methods/plugin/interface.hpp"
#include "methods/plugin/sanitizer.hpp"

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

/// Characters that need not end with a zero.
struct PluginText {
  const char* data;  ///< the first of them
  std::size_t size;  ///< how many
};

/// One method of a plugin, as MethodEntry has it.
struct PluginMethod {
  PluginText name;    ///< lower-kebab-case
  PluginText title;   ///< one line for people
  PluginText laws;    ///< laws it can represent
  PluginText ladder;  ///< resolutions a benchmark runs
  double order;       ///< of the error of x along the ladder; 0: none is claimed [-]
  /// A new Method, owned by the caller. \throws InvalidOption
  Method* (*make)(const OptionSetting* settings, std::size_t count);
};

/// What the entry point returns: plain C, so that it can be read before it is known that anything else can.
/// A loader reads `api` first, what follows only if that is its own, and the methods only if `abi` is.
struct PluginDescription {
  int api;          ///< SIGNORINI_PLUGIN_API of the plugin
  const char* abi;  ///< its kPluginAbi
  int optimised;  ///< 1 if it was compiled with optimisation and without assertions: its times mean something
  std::size_t count;            ///< of its methods
  const PluginMethod* methods;  ///< so many, for as long as the plugin is loaded
};

/// Name and type of the entry point.
inline constexpr const char* kPluginEntryPoint = "signorini_plugin";
using PluginEntryPoint = const PluginDescription* (*)();

namespace plugin_detail {

constexpr int kOptimised =
#if defined(__OPTIMIZE__) && defined(NDEBUG)
    1;
#else
    0;
#endif

constexpr PluginText text_of(std::string_view text) { return {text.data(), text.size()}; }

template <RegistrableMethod M>
constexpr PluginMethod method_of() {
  constexpr MethodText text = M::kText;
  return {text_of(text.name),
          text_of(text.title),
          text_of(text.laws),
          text_of(text.ladder),
          text.order.value_or(0.0),
          [](const OptionSetting* settings, std::size_t count) -> Method* {
            typename M::Options options;
            apply_settings(options, std::span(settings, count), M::kText.former);
            return new M(options);
          }};
}

}  // namespace plugin_detail

}  // namespace signorini

/// Defines the entry point of a plugin that holds these methods, each a RegistrableMethod.
#define SIGNORINI_PLUGIN(...)                                                                                \
  extern "C" __attribute__((visibility("default"))) const signorini::PluginDescription* signorini_plugin() { \
    static constexpr auto methods = []<class... Methods>() {                                                 \
      return std::array{signorini::plugin_detail::method_of<Methods>()...};                                  \
    }.template operator()<__VA_ARGS__>();                                                                    \
    static constexpr signorini::PluginDescription description{SIGNORINI_PLUGIN_API, signorini::kPluginAbi,   \
                                                              signorini::plugin_detail::kOptimised,          \
                                                              methods.size(), methods.data()};               \
    return &description;                                                                                     \
  }
