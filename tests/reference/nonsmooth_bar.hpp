#pragma once
// Oracle: free vibrations of a bar that meets a stop at its end, by d'Alembert's solution.

namespace signorini::test {

/// u_tt = u_xx on 0 < x < 1, u(0) = 0, u_x(1) = lambda, u(1) <= g, without load or damping: length, wave
/// speed and EA are one. With u = f(t + x) - f(t - x) the free end asks f'(t + 1) = -f'(t - 1), the closed
/// one f'(t + 1) = f'(t - 1) = lambda / 2 <= 0, so that |f'| does not change along t, t + 2, t + 4...: where
/// T / 2 is irrational it is one number a, and velocities and strains are piecewise constant. For g > 0 and
/// 3 < T < 4 there is such a motion with one contact per period, of duration 4 - T, and a = g / (2 (T - 3)).
struct NonsmoothBar {
  double gap = 0.5;     ///< g > 0 [-]
  double period = 3.7;  ///< T in (3, 4) [-]

  [[nodiscard]] double contact_duration() const;        ///< centred on t = 0 [-]
  [[nodiscard]] double strain() const;                  ///< a [-]
  [[nodiscard]] double energy() const;                  ///< 2 a^2, at all times [-]
  [[nodiscard]] double force(double time) const;        ///< lambda: -2 a in contact, else 0 [-]
  [[nodiscard]] double u(double x, double time) const;  ///< at rest in uniform compression at T / 2 [-]
};

}  // namespace signorini::test
