#pragma once
// Siconos' Lemke on the complementarity problem of `hat-lcp`.

#include "methods/method.hpp"

namespace siconos_rivals {

/// The same hat functions, the same matrix as an array, another solver: what pivoting with the structure of
/// the matrix is worth.
class HatLemke final : public signorini::Method {
 public:
  static constexpr signorini::MethodText kText{
      .name = "siconos-hat-lcp",
      .title = "Lemke's method of Siconos on the complementarity problem of hat-lcp",
      .laws = "all",
      .ladder = "samples=64|256|1024"};

  struct Options {
    int samples = 256;  ///< nodes per period [-]

    void visit(auto&& field) { field("samples", samples, "[-]", "nodes per period, 4..4096"); }
  };

  /// \throws signorini::InvalidOption
  explicit HatLemke(const Options& options);
  [[nodiscard]] std::vector<signorini::OptionEcho> options() const override {
    return signorini::echo_options(options_);
  }
  [[nodiscard]] signorini::Support supports(const signorini::Problem& problem) const override;
  [[nodiscard]] signorini::RepresentedLaw law(const signorini::Problem& problem) const override;
  [[nodiscard]] std::unique_ptr<signorini::PreparedMethod> prepare(
      const signorini::Problem& problem) const override;

 private:
  Options options_;
};

}  // namespace siconos_rivals
