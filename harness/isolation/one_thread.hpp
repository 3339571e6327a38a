#pragma once
// One thread for every library.

namespace signorini {

/// Has OpenMP and the linear algebra libraries that this process has loaded (OpenBLAS, MKL, BLIS) compute on
/// the thread that calls them from now on, and start no others: times are of one core, whatever BLAS is
/// installed, and a forked child does not wait for threads that its parent had. A BLAS or an OpenMP that is
/// not loaded is left alone, and so is one of a library loaded later until this is called again.
void compute_on_one_thread();

}  // namespace signorini
