#pragma once
// A reduction by several MPI processes, started from one that knows nothing of MPI.

#include <stdexcept>
#include <string>
#include <string_view>

#include "harness/reduction/reduction_files.hpp"

namespace signorini {

/// Name of the program that is started, beside this one.
inline constexpr std::string_view kSharedReducer = "signorini-reduce-mpi";

/// Its last line where it has written the files.
inline constexpr std::string_view kReductionDone = "done";
/// Begins its last line where it refuses the scene; the reason follows.
inline constexpr std::string_view kReductionRefused = "refused: ";
/// Begins its last line where it failed; the reason follows.
inline constexpr std::string_view kReductionFailed = "failed: ";

/// How MPI processes are started.
struct MpiLaunch {
  int processes = 2;
  std::string launcher = "mpirun";  ///< with its options, separated by blanks; "-n" follows
};

/// A reduction by several processes that came to no end. what() is one line.
class ReductionFailure : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// `write_reduction` by kSharedReducer. \return its lines for the user; none after an interrupt
/// \throws UsageError where the scene is refused, the program was not built or the launcher cannot be run;
/// ReductionFailure where it fails
std::string reduce_by_mpi(const ReductionOrder& order, const MpiLaunch& launch);

}  // namespace signorini
