#pragma once
// Cholesky factors shared between MPI processes.

#include <functional>

#include "problems/definite_solver.hpp"

namespace signorini {

/// Runs `work` in rank 0 of MPI_COMM_WORLD, with a function that factorises by MUMPS [amestoy2001] on all
/// ranks; the others serve it until it has ended. Matrices and columns are those of rank 0; each rank holds
/// its part of the factors alone. To be called once, by every rank, with MPI initialised.
///
/// The function refuses a matrix whose factors need more memory on some node than is free there, by MUMPS's
/// own estimate and before any number of them is computed. \throws UsageError then; std::runtime_error where
/// MUMPS fails; what `work` throws
void run_with_shared_factors(const std::function<void(const Factorise& factorise)>& work);

}  // namespace signorini
