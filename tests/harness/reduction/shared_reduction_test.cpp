// `signorini reduce --mpi N` beside the same command in one process.
#include "harness/reduction/shared_reduction.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "harness/plan/plan.hpp"
#include "harness/plan/scene_choice.hpp"
#include "tests/harness/fake_method.hpp"
#include "tests/harness/program.hpp"
#include "tests/support/other_programs.hpp"

namespace signorini::shared_reduction_test {
namespace {

namespace fs = std::filesystem;

class SharedReduction : public testing::Test {
 protected:
  void SetUp() override {
    if (!fs::exists(fs::path(SIGNORINI_BINARY).parent_path() / kSharedReducer))
      GTEST_SKIP() << "built without MUMPS (libmumps-dev)";
    // As root, in a container, mpirun asks for these.
    setenv("OMPI_ALLOW_RUN_AS_ROOT", "1", 1);
    setenv("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1", 1);
    if (!test::succeeds("mpirun --oversubscribe -n 2 true"))
      GTEST_SKIP() << "no mpirun of Open MPI starts two processes here (openmpi-bin)";
  }

  static test::Outcome reduce(const std::string& words) {
    return test::run_program("reduce " + words + " --launcher 'mpirun --oversubscribe'");
  }
  [[nodiscard]] std::string file(const std::string& name) const { return (folder_ / name).string(); }

 private:
  fs::path folder_ = test::fresh_folder("shared-reduction");
};

double difference(const SparseMatrix& a, const SparseMatrix& b) {
  return (Eigen::MatrixXd(a) - Eigen::MatrixXd(b)).norm() / a.norm();
}

// Nine contacts on 2,160 coordinates: of one factorisation, six powers; the Ritz vectors may change signs.
TEST_F(SharedReduction, WritesWhatOneProcessWrites) {
  ASSERT_EQ(test::run_program("reduce block-nine-contacts --out " + file("one.toml")).code, 0);
  const test::Outcome shared = reduce("block-nine-contacts --mpi 2 --out " + file("two.toml"));
  ASSERT_EQ(shared.code, 0) << shared.err;
  EXPECT_NE(shared.out.find("receptances of the contacts"), std::string::npos) << shared.out;
  EXPECT_EQ(shared.out.find("done"), std::string::npos) << shared.out;
  const Problem one = read_scene(find_scene(file("one.toml"))).problem;
  const Problem two = read_scene(find_scene(file("two.toml"))).problem;
  ASSERT_EQ(one.size(), two.size());
  const int contacts = one.contact_count(), vectors = one.size() - contacts;
  const auto own = [&](const SparseMatrix& A) {
    return SparseMatrix(A.bottomRightCorner(contacts, contacts));
  };
  EXPECT_LT(difference(own(one.stiffness()), own(two.stiffness())), 1e-6);
  // The squares of the lowest ten frequencies, with what the contacts pull: free of signs.
  const Eigen::VectorXd first = one.stiffness().diagonal().head(10),
                        second = two.stiffness().diagonal().head(10);
  EXPECT_GT(vectors, 10);
  EXPECT_LT((first - second).norm(), 1e-6 * first.norm());
}

TEST_F(SharedReduction, RefusesInOneLineWhatOneProcessRefuses) {
  const test::Outcome rigid = reduce("chain10-stop --mpi 2 --out " + file("chain.toml"));
  EXPECT_EQ(rigid.code, 2) << rigid.out;
  EXPECT_NE(rigid.err.find("impact law"), std::string::npos) << rigid.err;
  EXPECT_EQ(std::count(rigid.err.begin(), rigid.err.end(), '\n'), 1) << rigid.err;
  EXPECT_EQ(reduce("no-such-scene --mpi 2 --out " + file("none.toml")).code, 2);
}

TEST_F(SharedReduction, SaysWhereItsProcessesCannotBeStarted) {
  const std::string words = "reduce block-nine-contacts --mpi 2 --out " + file("pad.toml") + " --launcher ";
  const test::Outcome missing = test::run_program(words + "no-such-launcher");
  EXPECT_EQ(missing.code, 2) << missing.err;
  EXPECT_NE(missing.err.find("launcher = no-such-launcher"), std::string::npos) << missing.err;
  const test::Outcome failing = test::run_program(words + "false");
  EXPECT_EQ(failing.code, 1) << failing.err;
  EXPECT_NE(failing.err.find("ended with code 1 before it was done"), std::string::npos) << failing.err;
}

}  // namespace
}  // namespace signorini::shared_reduction_test
