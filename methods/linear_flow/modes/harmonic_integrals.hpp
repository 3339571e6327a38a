#pragma once
// Fourier integrals of motions that are sums of exponentials, in closed form.

#include <Eigen/Core>

namespace signorini {

/// The integrals of Re sum_k c_kj e^{nu_k (t - begin)} times e^{-i n w t} from `begin` to `end`, for n = 0 to
/// `harmonics`: by quotients; where nu_k - i n w is near zero by a series; of terms with |nu_k| up to half of
/// n w by parts, which takes their sum's derivatives at both ends in place of a quotient each. Terms below
/// 1e-17 of the largest are left out. Above harmonic 256 to rounding of |c| / (n w): of an interval much
/// shorter than a wave that is more than rounding of its integral, and no more than the rounding of the
/// others. \param rates  nu_k [rad/s] \param terms  c_kj, terms x outputs, one at least \return (harmonics +
/// 1) x outputs, in the unit of the terms times [s]
Eigen::MatrixXcd harmonic_integrals(const Eigen::VectorXcd& rates, const Eigen::MatrixXcd& terms,
                                    double begin, double end, double w, Eigen::Index harmonics);

}  // namespace signorini
