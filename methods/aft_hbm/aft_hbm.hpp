#pragma once
// Alternating frequency/time harmonic balance, Newton-Krylov in the frequency domain.

#include <array>
#include <optional>
#include <string_view>

#include "methods/harmonic_balance/projected_method.hpp"

namespace signorini {

/// Finds the harmonics of the contact force from R(lambda) = lambda + P max(0, y) = 0, where
/// y = c (x - g) - lambda (dynamic Lagrangians, DLFT [nacivet2003]) or y = eps (x - g) (penalty),
/// x = x_f + C lambda. Every residual and Jacobian-vector product goes harmonics -> inverse FFT ->
/// contact law in time -> FFT -> harmonics; no matrix in time or frequency is formed. The equations are
/// those of fourier-lipschitz and penalty-hbm; what differs is the solver. They represent restitution 1.
///
/// Globalisation: Newton with GMRES, a harmonic-wise preconditioner and a line search; where that fails, the
/// gap homotopy of the same equations on the same samples is followed by pivoting
/// (complementarity_solver.hpp), and Newton finishes. With more than some twenty harmonics this is done for
/// few of them, and continued to all.
///
/// `plain`: alternating frequency/time on 32 H samples and Newton from the contact-free response, or by
/// `continuation=frequency` from where nothing touches, with the constants of fourier-lipschitz and
/// penalty-hbm, without homotopy. It sets what is left at `auto`.
class AftHbm final : public FollowedMethod {
 public:
  enum class ContactLaw { dlft, penalty };

  static constexpr MethodText kText =
      completed({.name = "aft-hbm", .title = "Alternating frequency/time harmonic balance, Newton-Krylov"});

  /// With this value of an option, the equations are those of this method.
  static constexpr std::array<std::array<std::string_view, 3>, 2> kSameEquations{
      {{"law", "dlft", "fourier-lipschitz"}, {"law", "penalty", "penalty-hbm"}}};

  struct Options {
    HarmonicOptions common = {};
    ContactLaw law = ContactLaw::dlft;
    std::optional<double> c = {};        ///< of dlft: > 0, times contact_stiffness_scale [-]
    std::optional<Scaled> penalty = {};  ///< of penalty: eps > 0 [N/m], or times contact_stiffness_scale
    std::optional<bool> homotopy = {};   ///< false: Newton alone

    void visit(auto&& field) {
      const auto contact_law = [&] {
        field("law", law, "[-]", "dlft (dynamic Lagrangian, has c) | penalty (has penalty)");
        field("c", c, "[-]", kMeanings.constant);
        field("penalty", penalty, "[N/m]", kMeanings.penalty);
      };
      const auto solver = [&] {
        field("homotopy", homotopy, "[-]",
              "follow the gap homotopy where Newton fails: true | false; auto: unless plain");
      };
      common.visit(field, contact_law, solver);
    }
  };

  explicit AftHbm(const Options& options);  ///< \throws InvalidOption

  [[nodiscard]] std::vector<OptionEcho> options() const override { return echo_options(options_); }

 private:
  [[nodiscard]] HarmonicMethod preset(const Problem& problem) const override;

  Options options_;
};

template <>
struct EnumNames<AftHbm::ContactLaw> {
  static constexpr std::array<std::string_view, 2> values{"dlft", "penalty"};
};

}  // namespace signorini
