#include "tests/support/structure_scenes.hpp"

#include <vector>

#include "problems/assembly/beam.hpp"
#include "problems/assembly/block.hpp"

namespace signorini::test {

namespace {

Problem on_structure(Structure structure, const ProportionalDamping& damping) {
  structure.damping = combination(damping, structure.mass, structure.stiffness);
  Problem problem;
  problem.structure = std::make_shared<const Structure>(std::move(structure));
  problem.set_law(Massless{});
  return problem;
}

}  // namespace

Problem massless_bar(const ProportionalDamping& damping, int elements) {
  Problem problem = on_structure(
      assemble(Bar{.elements = elements, .contact_mass = ContactMass::massless, .contacts = {elements - 1}}),
      damping);
  problem.name = "massless-bar";
  problem.frequency = 1.2;
  problem.force = {{elements / 2 - 1, 1, 0.15, 0.0}};
  problem.contacts = {{{{elements - 1, 1.0}}, 0.1}};
  return problem;
}

Problem massless_beam(const ProportionalDamping& damping, int contacts) {
  constexpr int kElements = 150;
  std::vector<int> touched;
  if (contacts == 1) {
    touched = {2 * kElements - 2};
  } else {
    for (int dof = 200; dof < 300; dof += 10) touched.push_back(dof);
  }
  Problem problem = on_structure(
      assemble(Beam{.elements = kElements, .contact_mass = ContactMass::massless, .contacts = touched}),
      damping);
  problem.name = "massless-beam";
  problem.frequency = 2.7;
  problem.force = {{148, 1, 0.6, 0.0}};
  for (const int dof : touched) problem.contacts.push_back({{{dof, 1.0}}, 0.05});
  return problem;
}

Problem padded_block_problem(const PaddedBlock& block) {
  const BlockMesh mesh{.elements = block.elements, .lengths = block.lengths};
  const Face top{.axis = 2, .upper = true};
  const std::vector<Contact> contacts = contacts_on_face(mesh, top, block.patch, block.gap);
  std::vector<int> touched;
  for (const Contact& contact : contacts) touched.push_back(contact.normal.front().first);
  Problem problem = on_structure(assemble(Block{.mesh = mesh,
                                                .young = 1.0,
                                                .poisson = 0.3,
                                                .contact_mass = ContactMass::massless,
                                                .contacts = touched}),
                                 block.damping);
  problem.name = "padded-block";
  problem.frequency = block.frequency;
  problem.contacts = contacts;
  for (const auto& [dof, part] : load_on_face(mesh, {.axis = 0, .upper = true}, 2))
    problem.force.push_back({dof, 1, part * block.force, 0.0});
  return problem;
}

}  // namespace signorini::test
