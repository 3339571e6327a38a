#pragma once
// Solutions of a method made of Fourier coefficients of the contact force.

#include <Eigen/Core>
#include <string>

#include "methods/complementarity/exact_projection.hpp"
#include "methods/complementarity/projected_law.hpp"
#include "methods/discretisation/trajectories.hpp"
#include "methods/solution.hpp"

namespace signorini {

/// The trajectory behind the coefficients of lambda, (H+1) x Nc [N]: x_n = x_f,n + C_n lambda_n.
FourierTrajectory::Data series_data(const ProjectedEquations& equations, Eigen::MatrixXcd lambda);

/// The converged answer behind a solution of the exactly projected equations, without its work. The message
/// is `how` it was found and the energy identity.
Solution exact_solution(const ProjectedEquations& equations, const ExactProjection& solved,
                        const std::string& how);

/// The linear response of a scene without contacts.
Solution contact_free_response(const ContactReceptance& receptance);

}  // namespace signorini
