#include "harness/reduction/mumps_solver.hpp"

#include <dmumps_c.h>
#include <fmt/format.h>
#include <mpi.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <new>
#include <vector>

#include "harness/failure.hpp"
#include "harness/reduction/free_memory.hpp"

namespace signorini {

namespace {

// What all ranks do together; `solve` and those before it are jobs of MUMPS, by their numbers in its manual.
enum class Step { terminate = -2, initialise, end, analyse, factorise, solve, create, measure, destroy };

// One instance of MUMPS, in each rank its part. Numbers of controls and results as in its manual, from 1.
class Mumps {
 public:
  Mumps() {
    id_.comm_fortran = static_cast<MUMPS_INT>(MPI_Comm_c2f(MPI_COMM_WORLD));
    id_.par = 1;  // rank 0 computes, too
    id_.sym = 1;  // positive definite
    call(Step::initialise);
    for (const int stream : {1, 2, 3}) control(stream) = -1;  // it prints nothing
    control(4) = 0;
    control(27) = 32;  // columns solved at once
  }
  ~Mumps() { call(Step::terminate); }
  Mumps(const Mumps&) = delete;
  Mumps& operator=(const Mumps&) = delete;

  void call(Step job) {
    id_.job = static_cast<MUMPS_INT>(job);
    dmumps_c(&id_);
  }
  DMUMPS_STRUC_C& data() { return id_; }
  MUMPS_INT& control(int number) { return id_.icntl[number - 1]; }
  [[nodiscard]] int outcome() const { return id_.infog[0]; }  // negative: an error
  [[nodiscard]] int detail() const { return id_.infog[1]; }
  [[nodiscard]] int negative_pivots() const { return id_.infog[11]; }
  // What the factorisation needs in this rank [bytes].
  [[nodiscard]] double needed() const { return 1e6 * id_.info[14]; }
  // Where they are more than an int counts, MUMPS tells them in millions, as a negative number.
  [[nodiscard]] double entries() const {
    const double told = id_.infog[28];
    return told < 0.0 ? -1e6 * told : told;
  }
  [[nodiscard]] double operations() const { return id_.rinfog[2]; }

 private:
  DMUMPS_STRUC_C id_{};
};

// Needed over free memory on the fullest node, and both there [bytes].
struct Room {
  double share = 0.0, needed = 0.0, free = 0.0;
};

// Called by all ranks.
Room fullest_node(double needed_here) {
  MPI_Comm node = MPI_COMM_NULL;
  MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &node);
  double needed = 0.0;
  MPI_Allreduce(&needed_here, &needed, 1, MPI_DOUBLE, MPI_SUM, node);
  MPI_Comm_free(&node);
  const double free = free_memory();
  struct {
    double share;
    int rank;
  } mine{needed / free, 0}, worst{};
  MPI_Comm_rank(MPI_COMM_WORLD, &mine.rank);
  MPI_Allreduce(&mine, &worst, 1, MPI_DOUBLE_INT, MPI_MAXLOC, MPI_COMM_WORLD);
  std::array<double, 2> there{needed, free};
  MPI_Bcast(there.data(), static_cast<int>(there.size()), MPI_DOUBLE, worst.rank, MPI_COMM_WORLD);
  return {.share = worst.share, .needed = there[0], .free = there[1]};
}

// The instances of a rank by their numbers, which are the same in all of them.
class Instances {
 public:
  // This rank's part of a step.
  Room take(Step step, int number) {
    if (step == Step::create) {
      all_.emplace(number, std::make_unique<Mumps>());
    } else if (step == Step::destroy) {
      all_.erase(number);
    } else if (step == Step::measure) {
      return fullest_node(all_.at(number)->needed());
    } else {
      all_.at(number)->call(step);
    }
    return {};
  }
  Mumps& of(int number) { return *all_.at(number); }

 private:
  std::map<int, std::unique_ptr<Mumps>> all_;
};

std::array<int, 2> broadcast(std::array<int, 2> message) {
  MPI_Bcast(message.data(), static_cast<int>(message.size()), MPI_INT, 0, MPI_COMM_WORLD);
  return message;
}

// Rank 0: tells the others what to do, and does its part.
class Leader {
 public:
  ~Leader() { broadcast({static_cast<int>(Step::end), 0}); }
  Room all(Step step, int number) {
    broadcast({static_cast<int>(step), number});
    return instances_.take(step, number);
  }
  Mumps& of(int number) { return instances_.of(number); }
  int next() { return made_++; }

  Leader() = default;
  Leader(const Leader&) = delete;
  Leader& operator=(const Leader&) = delete;

 private:
  Instances instances_;
  int made_ = 0;
};

void serve() {
  Instances instances;
  for (;;) {
    const auto [step, number] = broadcast({});
    if (static_cast<Step>(step) == Step::end) return;
    instances.take(static_cast<Step>(step), number);
  }
}

// A matrix that all ranks have factorised, seen from rank 0.
class SharedFactors final : public DefiniteSolver {
 public:
  SharedFactors(Leader& leader, const SparseMatrix& A) : leader_(leader), number_(leader.next()) {
    take(A);
    leader_.all(Step::create, number_);
    DMUMPS_STRUC_C& data = mumps().data();
    data.n = static_cast<MUMPS_INT>(A.rows());
    data.nnz = static_cast<MUMPS_INT8>(values_.size());
    data.irn = rows_.data();
    data.jcn = columns_.data();
    data.a = values_.data();
    try {
      factorise(A);
    } catch (...) {
      leader_.all(Step::destroy, number_);
      throw;
    }
    std::vector<MUMPS_INT>().swap(rows_);  // gives the memory back, which an assignment does not
    std::vector<MUMPS_INT>().swap(columns_);
    std::vector<double>().swap(values_);
  }
  ~SharedFactors() override { leader_.all(Step::destroy, number_); }
  SharedFactors(const SharedFactors&) = delete;
  SharedFactors& operator=(const SharedFactors&) = delete;

  [[nodiscard]] bool definite() const override { return definite_; }
  [[nodiscard]] double entries() const override { return leader_.of(number_).entries(); }
  [[nodiscard]] double operations() const override { return leader_.of(number_).operations(); }
  [[nodiscard]] Eigen::MatrixXd solve(const Eigen::MatrixXd& rhs) override {
    constexpr Eigen::Index kAtOnce = 64;  // its counts have 32 bits
    Eigen::MatrixXd solution = rhs;
    DMUMPS_STRUC_C& data = mumps().data();
    for (Eigen::Index first = 0; first < rhs.cols(); first += kAtOnce) {
      data.rhs = solution.col(first).data();
      data.lrhs = static_cast<MUMPS_INT>(rhs.rows());
      data.nrhs = static_cast<MUMPS_INT>(std::min(kAtOnce, rhs.cols() - first));
      leader_.all(Step::solve, number_);
      check("solution");
    }
    return solution;
  }

 private:
  void take(const SparseMatrix& A) {
    const auto most = static_cast<std::size_t>((A.nonZeros() + A.rows()) / 2);
    rows_.reserve(most);
    columns_.reserve(most);
    values_.reserve(most);
    for (int column = 0; column < A.outerSize(); ++column) {
      for (SparseMatrix::InnerIterator it(A, column); it; ++it) {
        if (it.row() < it.col()) continue;
        rows_.push_back(static_cast<MUMPS_INT>(it.row()) + 1);
        columns_.push_back(static_cast<MUMPS_INT>(it.col()) + 1);
        values_.push_back(it.value());
      }
    }
  }

  void factorise(const SparseMatrix& A) {
    constexpr double kRounding = 1e-15;  // of A scaled to unit diagonal
    constexpr int kNotDefinite = -40, kSingular = -10, kMoreRoom = 2, kAttempts = 3;
    constexpr std::array kTooSmall{-8, -9, -17, -20};  // what it sets aside beyond its estimate, in percent
    leader_.all(Step::analyse, number_);
    check("analysis");
    const Room room = leader_.all(Step::measure, number_);
    if (room.share > 1.0) {
      throw UsageError(
          fmt::format("the factors need {:.1f} GB on a node where {:.1f} GB are free (more nodes are needed)",
                      1e-9 * room.needed, 1e-9 * room.free));
    }
    for (int attempt = 0; attempt < kAttempts; ++attempt, mumps().control(14) *= kMoreRoom) {
      leader_.all(Step::factorise, number_);
      if (std::ranges::find(kTooSmall, mumps().outcome()) == kTooSmall.end()) break;
    }
    if (mumps().outcome() == kNotDefinite || mumps().outcome() == kSingular) return;
    check("factorisation");
    definite_ = mumps().negative_pivots() == 0 && least_eigenvalue(A) > kRounding;
  }

  // The size of the least one of A scaled to unit diagonal: by inverse iteration, from above, to a digit.
  [[nodiscard]] double least_eigenvalue(const SparseMatrix& A) {
    const Eigen::VectorXd size = A.diagonal().cwiseSqrt();
    Eigen::VectorXd x = Eigen::VectorXd::Random(A.rows());
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 4; ++i) {
      x.normalize();
      const Eigen::VectorXd y = size.cwiseProduct(solve(Eigen::MatrixXd(size.cwiseProduct(x))).col(0));
      least = 1.0 / y.norm();
      x = y;
    }
    return std::isfinite(least) ? least : 0.0;
  }

  void check(const char* what) {
    constexpr int kOutOfMemory = -13, kNotEnough = -19;
    const int outcome = mumps().outcome();
    if (outcome == kOutOfMemory || outcome == kNotEnough) throw std::bad_alloc();
    if (outcome < 0) {
      throw std::runtime_error(
          fmt::format("the {} by MUMPS failed: {}, {} (its manual, section \"Error diagnostics\")", what,
                      outcome, mumps().detail()));
    }
  }

  Mumps& mumps() { return leader_.of(number_); }

  Leader& leader_;
  int number_;
  std::vector<MUMPS_INT> rows_, columns_;  // from 1, of the lower triangle
  std::vector<double> values_;
  bool definite_ = false;
};

}  // namespace

void run_with_shared_factors(const std::function<void(const Factorise& factorise)>& work) {
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  if (rank != 0) return serve();
  Leader leader;
  work([&leader](const SparseMatrix& A) { return std::make_unique<SharedFactors>(leader, A); });
}

}  // namespace signorini
