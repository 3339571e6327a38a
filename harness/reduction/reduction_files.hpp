#pragma once
// A scene reduced to what its contacts feel, as files.

#include <filesystem>
#include <string>

#include "harness/reduction/free_memory.hpp"
#include "harness/reduction/reducible_scene.hpp"
#include "problems/definite_solver.hpp"

namespace signorini {

/// What is to be reduced, and where to.
struct ReductionOrder {
  std::string scene;          ///< as the user names it
  std::filesystem::path out;  ///< NAME.toml; its matrices are NAME-M.mtx and NAME-K.mtx beside it
  int vectors = 0;            ///< kept; 0: as many as are enough for most motions
};

/// Refuses a file that no scene can have. \throws UsageError
void require_scene_file(const std::filesystem::path& out);

/// Refuses a stiffness whose factors need more memory than is free, by their number of entries.
/// \param room  [bytes] \throws UsageError
void require_room_for_factors(const std::string& scene, const SparseMatrix& stiffness,
                              double room = free_memory());

/// Reduces the scene (`ContactSpace`, `reduced_problem`) and writes it as a scene of its own. Of damping
/// ratios every vector has that of the mode whose frequency is nearest: itself, where it has converged.
/// \return lines for the user: what was written, and how its receptances differ from those of more vectors
/// \throws UsageError where the scene cannot be reduced, or a file not be written
std::string write_reduction(const ReducibleScene& scene, const ReductionOrder& order,
                            const Factorise& factorise);

}  // namespace signorini
