#include <fmt/format.h>

#include <cmath>
#include <memory>

#include "problems/assembly/beam.hpp"
#include "problems/assembly/block.hpp"
#include "problems/assembly/penalty_supports.hpp"
#include "problems/matrix_properties.hpp"
#include "problems/scene/scene_system.hpp"

namespace signorini {

namespace {

constexpr int kMostElements = 100000;

int read_element_count(const SceneField& field) { return field.in_range("a whole number", 1, kMostElements); }

// Before damping is made of it, so that the complaint names the culprit.
void require_finite(const SparseMatrix& A, const std::string& field) {
  const double largest = largest_entry(A);
  if (!std::isfinite(largest))
    throw InvalidProblem(field, fmt::format("{}", largest), "must be a finite number");
}

Beam read_section_and_material(const SceneField& system) {
  return {.elements = read_element_count(system["elements"]),
          .length = read_positive(system["length"], "[m]"),
          .area = read_positive(system["area"], "[m^2]"),
          .inertia = read_positive(system["inertia"], "[m^4]"),
          .young = read_positive(system["young"], "[N/m^2]"),
          .density = read_positive(system["density"], "[kg/m^3]")};
}

BlockMesh read_mesh(const SceneField& system) {
  const SceneField elements = system["elements"];
  const auto bricks = elements.items("must be three whole numbers: bricks along x, y and z", 3);
  const auto lengths = system["lengths"].items("must be three positive numbers, along x, y and z [m]", 3);
  BlockMesh mesh;
  for (std::size_t a = 0; a < 3; ++a) {
    mesh.elements[a] = read_element_count(bricks[a]);
    mesh.lengths[a] = read_positive(lengths[a], "[m]");
  }
  constexpr int kMostCoordinates = 1000000;  // 2 GB of matrices
  const double size = 3.0 * mesh.elements[0] * (mesh.elements[1] + 1.0) * (mesh.elements[2] + 1.0);
  if (size > kMostCoordinates) {
    elements.refuse(fmt::format("{:.0f} coordinates", size),
                    fmt::format("must make at most {}", kMostCoordinates));
  }
  return mesh;
}

}  // namespace

double read_positive(const SceneField& field, std::string_view unit) {
  return field.number(fmt::format("must be a positive number {}", unit), kLeastPositive);
}

double read_nonnegative(const SceneField& field, std::string_view unit) {
  return field.number(fmt::format("must be a number >= 0 {}", unit), 0.0);
}

double read_poisson(const SceneField& field) {
  constexpr std::string_view kRequirement = "must be a number between -1 and 0.5 [-]";
  const double poisson = field.number(kRequirement);
  if (poisson <= -1.0 || poisson >= 0.5) field.refuse(kRequirement);
  return poisson;
}

ContactMass read_contact_mass(const SceneField& field) {
  if (!field.given()) return ContactMass::consistent;
  const std::string word = field.one_of({"consistent", "lumped", "massless"});
  if (word == "lumped") return ContactMass::lumped;
  return word == "massless" ? ContactMass::massless : ContactMass::consistent;
}

SystemDescription damped_structure(SystemLayout layout, Assembly undamped, DampingModel damping, int size) {
  return {.size = size,
          .layout = std::move(layout),
          .definiteness = Definiteness::by_construction,
          .assemble = [undamped = std::move(undamped),
                       damping = std::move(damping)](const std::vector<int>& contact_coordinates) {
            // Made in its place, swapped and not moved: these matrices have no moves.
            const std::shared_ptr<Structure> structure(new Structure(undamped(contact_coordinates)));
            require_finite(structure->mass, "system.mass");
            require_finite(structure->stiffness, "system.stiffness");
            SparseMatrix of_material = damping_matrix(damping, structure->mass, structure->stiffness);
            if (structure->damping.nonZeros() > 0)
              of_material += structure->damping;
            else if (const auto* factors = std::get_if<ProportionalDamping>(&damping))
              structure->proportional = *factors;
            structure->damping.swap(of_material);
            return structure;
          }};
}

ModalDamping read_modal(const SceneField& modal, int size, int most) {
  constexpr std::string_view kRequirement = "must be a damping ratio >= 0 [-], or a list of them";
  if (size > most) {
    modal.refuse(
        fmt::format("a system of {} coordinates", size),
        fmt::format("modal damping takes at most {}: use alpha and beta, or solve the smaller scene that "
                    "`signorini reduce` makes of this one",
                    most));
  }
  if (!modal.is_array()) return {{modal.number(kRequirement, 0.0)}};
  ModalDamping damping;
  for (const SceneField& item : modal.items(kRequirement)) {
    damping.ratios.push_back(item.number("must be a damping ratio >= 0 [-]", 0.0));
  }
  if (std::ssize(damping.ratios) > size) {
    modal.refuse(fmt::format("{} values", damping.ratios.size()), fmt::format("has at most {} modes", size));
  }
  return damping;
}

ProportionalDamping read_rayleigh(const SceneField& rayleigh) {
  return {.alpha = rayleigh["alpha"].number_or(0.0, "must be a number >= 0 [1/s]", 0.0),
          .beta = rayleigh["beta"].number_or(0.0, "must be a number >= 0 [s]", 0.0)};
}

DampingModel read_damping(const SceneField& damping, int size) {
  constexpr std::string_view kRequirement = "must be { alpha = .., beta = .. } or { modal = .. }";
  damping.allow_only({"alpha", "beta", "modal"}, kRequirement);
  if (damping.has_any({"alpha", "beta"})) {
    damping.forbid({"modal"}, "alpha or beta is given");
    return read_rayleigh(damping);
  }
  if (!damping["modal"].given()) damping.refuse(kRequirement);
  return read_modal(damping["modal"], size);
}

SystemDescription read_bar(const SceneField& system) {
  system.allow_only({"kind", "elements", "length", "area", "young", "density", "damping", "contact_mass"},
                    "must be a table");
  const Bar bar{.elements = read_element_count(system["elements"]),
                .length = read_positive(system["length"], "[m]"),
                .area = read_positive(system["area"], "[m^2]"),
                .young = read_positive(system["young"], "[N/m^2]"),
                .density = read_positive(system["density"], "[kg/m^3]"),
                .contact_mass = read_contact_mass(system["contact_mass"])};
  return damped_structure(bar, assembly_of(bar), read_damping(system["damping"], bar.elements), bar.elements);
}

SystemDescription read_beam(const SceneField& system) {
  system.allow_only({"kind", "elements", "count", "length", "area", "inertia", "young", "density", "damping",
                     "contact_mass"},
                    "must be a table");
  constexpr int kMostBeams = 100;
  Beam beam = read_section_and_material(system);
  const SceneField count = system["count"];
  if (count.given()) beam.count = count.in_range("a whole number", 1, kMostBeams);
  if (beam.elements * beam.count > kMostElements) {
    count.refuse(fmt::format("{} beams of {} elements", beam.count, beam.elements),
                 fmt::format("must make at most {} elements in all", kMostElements));
  }
  beam.contact_mass = read_contact_mass(system["contact_mass"]);
  const int size = 2 * beam.elements * beam.count;
  return damped_structure(beam, assembly_of(beam), read_damping(system["damping"], size), size);
}

SystemDescription read_block(const SceneField& system) {
  system.allow_only({"kind", "elements", "lengths", "young", "poisson", "density", "damping", "contact_mass"},
                    "must be a table");
  Block block{.mesh = read_mesh(system),
              .young = read_positive(system["young"], "[N/m^2]"),
              .poisson = read_poisson(system["poisson"]),
              .density = read_positive(system["density"], "[kg/m^3]"),
              .contact_mass = read_contact_mass(system["contact_mass"])};
  const int size = block.mesh.size();
  return damped_structure(block.mesh, assembly_of(block), read_damping(system["damping"], size), size);
}

// No body has more about an axis than about two at right angles to it.
double read_polar_inertia(const SceneField& field, double diametral) {
  const std::string requirement =
      fmt::format("must be in 0..{:g}, twice disc_inertia [kg m^2]", 2.0 * diametral);
  const double inertia = field.number_or(0.0, requirement, 0.0);
  if (inertia > 2.0 * diametral) field.refuse(requirement);
  return inertia;
}

// False of a number, which is left in `spin`; true where it is the frequency of the load.
bool read_spin(const SceneField& field, double& spin) {
  constexpr std::string_view kRequirement =
      "must be a finite number [rad/s], or \"synchronous\": the frequency of the load";
  if (field.is_text() && field.text(kRequirement) == "synchronous") return true;
  spin = field.number_or(0.0, kRequirement);
  return false;
}

SystemDescription read_shaft(const SceneField& system) {
  system.allow_only(
      {"kind", "elements", "length", "area", "inertia", "young", "density", "disc_mass", "disc_node",
       "disc_inertia", "disc_polar_inertia", "spin", "bearing_stiffness", "bearing_damping", "damping"},
      "must be a table");
  Shaft shaft{.beam = read_section_and_material(system)};
  const int last = shaft.beam.elements;
  shaft.disc_mass = read_nonnegative(system["disc_mass"], "[kg]");
  shaft.disc_node = system["disc_node"].in_range("a node of the shaft", 0, last);
  shaft.bearing_stiffness = read_positive(system["bearing_stiffness"], "[N/m]");
  shaft.bearing_damping = read_nonnegative(system["bearing_damping"], "[N s/m]");
  shaft.disc_inertia = system["disc_inertia"].number_or(0.0, "must be a number >= 0 [kg m^2]", 0.0);
  shaft.polar_inertia = read_polar_inertia(system["disc_polar_inertia"], shaft.disc_inertia);
  const bool synchronous = read_spin(system["spin"], shaft.spin);
  const int size = 4 * (last + 1);
  const auto undamped = std::make_shared<Structure>(assemble(shaft));
  SystemDescription description = damped_structure(
      shaft, [undamped](const std::vector<int>&) { return *undamped; }, read_damping(system["damping"], size),
      size);
  description.held = hold_supports(*undamped, description.notices);
  if (synchronous) {
    shaft.spin = 1.0;
    description.assemble = [standing = std::move(description.assemble),
                            rate = gyroscopic_matrix(shaft)](const std::vector<int>& contact_coordinates) {
      const auto structure = std::make_shared<Structure>(*standing(contact_coordinates));
      follow_speed(*structure, rate, SparseMatrix(rate.rows(), rate.cols()));
      return structure;
    };
  }
  return description;
}

}  // namespace signorini
