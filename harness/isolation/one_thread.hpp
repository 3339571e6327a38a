#pragma once
// One thread for every library.

namespace signorini {

/// Has OpenMP and the linear algebra libraries that the program is linked to (OpenBLAS, MKL) compute on the
/// thread that calls them from now on, and by the environment those that plugins load later: times are of one
/// core, whatever BLAS is installed, and a forked child does not wait for threads that its parent had.
void compute_on_one_thread();

}  // namespace signorini
