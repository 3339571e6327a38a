#include "tests/support/elastic_block.hpp"

#include "problems/assembly/block.hpp"

namespace signorini::test {

Problem elastic_block_problem(const ElasticBlock& block) {
  const double edge = 1.0 / block.ny;
  const BlockMesh mesh{.elements = {block.nx, block.ny, block.nz},
                       .lengths = {block.nx * edge, 1.0, block.nz * edge}};
  Structure structure = assemble(Block{.mesh = mesh, .young = 2.5, .poisson = 0.25});
  Problem problem;
  problem.name = problem.kind = "block";
  problem.edit_structure([&](Structure& s) {
    s.mass = std::move(structure.mass);
    s.stiffness = std::move(structure.stiffness);
    s.damping = block.alpha * s.mass + block.beta * s.stiffness;
  });
  problem.frequency = block.frequency;
  for (int j = 0; j < block.side; ++j) {
    for (int k = 0; k < block.side; ++k) {
      problem.contacts.push_back({{{mesh.coordinate({block.nx, j, k}, 0), 1.0}}, 0.1});
    }
  }
  problem.force = {{mesh.coordinate({block.nx, block.ny, block.nz}, 0), 1, 1.0, 0.5},
                   {mesh.coordinate({block.nx, block.ny, 0}, 1), 3, 0.0, 0.7},
                   {mesh.coordinate({block.nx, 0, block.nz}, 2), 0, 0.25, 0.0}};
  problem.set_law(Restitution{1.0});
  return problem;
}

}  // namespace signorini::test
