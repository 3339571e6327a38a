#include "problems/assembly/rotor.hpp"

#include <cmath>

namespace signorini {

namespace {

SparseMatrix twice(double value) {
  SparseMatrix identity(2, 2);
  identity.setIdentity();
  return value * identity;
}

// cos(2 pi part / whole), without the rounding of pi at right angles.
double cosine_of_part(int part, int whole) {
  if (4 * part == whole || 4 * part == 3 * whole) return 0.0;
  return std::cos(2.0 * std::numbers::pi * part / whole);
}

double sine_of_part(int part, int whole) {
  if (2 * part == whole || part == 0) return 0.0;
  return std::sin(2.0 * std::numbers::pi * part / whole);
}

}  // namespace

Structure assemble(const Rotor& rotor) {
  return {.mass = twice(rotor.mass), .damping = twice(rotor.damping), .stiffness = twice(rotor.stiffness)};
}

std::vector<Contact> ring_of_contacts(int first, int second, int facets, double gap) {
  std::vector<Contact> contacts;
  for (int j = 0; j < facets; ++j) {
    contacts.push_back(
        {.normal = {{first, cosine_of_part(j, facets)}, {second, sine_of_part(j, facets)}}, .gap = gap});
  }
  return contacts;
}

}  // namespace signorini
