#pragma once
// The instants by which a contact is known to trigonometric polynomials.

#include <Eigen/Core>
#include <vector>

#include "methods/discretisation/contact_phases.hpp"

namespace signorini {

/// Instants during contact and their weights: of the period's integral over the contact, that is shares of
/// the period.
struct ContactNodes {
  Eigen::VectorXd time;    ///< shares of the period [-]
  Eigen::VectorXd weight;  ///< > 0; their sum is the contact's duration [-]
};

/// Gauss' nodes on an interval, as many as integrate products of two trigonometric polynomials of degree H to
/// rounding: gauss_nodes_for pi H (end - begin). In so short a time such a polynomial can bend no more.
/// \param begin  < end [-]
ContactNodes nodes_on(double begin, double end, int harmonics);

/// The number of these nodes on an interval of such a length. \param length  > 0 [-]
int node_count(double length, int harmonics);

/// Gauss' nodes on all intervals of one contact.
ContactNodes nodes_on(const std::vector<ContactInterval>& intervals, int harmonics);

/// Of N samples, i / N, those within the intervals of one contact, which begin and end half way between two,
/// or all.
ContactNodes samples_on(const std::vector<ContactInterval>& intervals, int samples);

/// e^{2 pi i n t}, n = 0..H, at so many times; times x (H+1).
Eigen::MatrixXcd phases_at(const Eigen::VectorXd& time, int harmonics);

}  // namespace signorini
