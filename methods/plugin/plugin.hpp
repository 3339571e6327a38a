#pragma once
// A method outside the tree: a shared object with one C entry point, written by
//
//     SIGNORINI_PLUGIN(my::Method)
//
// at the end of its source, outside of all namespaces. docs/plugins.md tells how one is built and loaded.

#include <array>
#include <cstddef>

#include "methods/catalogue.hpp"
#include "methods/plugin/abi.hpp"

namespace signorini {

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

#if defined(__OPTIMIZE__) && defined(NDEBUG)
constexpr int kOptimised = 1;
#else
constexpr int kOptimised = 0;
#endif

constexpr PluginText text_of(std::string_view text) { return {text.data(), text.size()}; }

template <RegistrableMethod M>
constexpr PluginMethod method_of() {
  return {text_of(M::kName),
          text_of(M::kTitle),
          text_of(M::kLaws),
          text_of(M::kLadder),
          claimed_order<M>().value_or(0.0),
          [](const OptionSetting* settings, std::size_t count) -> Method* {
            typename M::Options options;
            apply_settings(options, std::span(settings, count));
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
