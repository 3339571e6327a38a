#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <functional>
#include <iomanip>
#include <numbers>
#include <random>
#include <sstream>

#include "problems/assembly/beam.hpp"
#include "problems/assembly/damping.hpp"
#include "problems/files/matrices/matrix_file.hpp"
#include "problems/scene/scene_file.hpp"
#include "problems/scene/scene_layout.hpp"
#include "tests/problems/temporary_folder.hpp"

namespace signorini::test::matrix_market_test {
namespace {

SparseMatrix read(const std::string& text) { return read_matrix_market(text, "A.mtx").matrix; }

std::string complaint(const std::function<void()>& action) {
  try {
    action();
    return "";
  } catch (const SceneError& error) {
    return error.what();
  }
}

// A as the format wants it, 17 digits.
std::string written(const Eigen::MatrixXd& A, bool coordinate, bool symmetric, bool integer = false) {
  std::ostringstream entries;
  entries << std::setprecision(17);
  int count = 0;
  for (int j = 0; j < A.cols(); ++j) {
    for (int i = symmetric ? j : 0; i < A.rows(); ++i) {
      if (coordinate && A(i, j) == 0.0) continue;
      if (coordinate) entries << i + 1 << ' ' << j + 1 << ' ';
      entries << A(i, j) << '\n';
      ++count;
    }
  }
  std::ostringstream text;
  text << "%%MatrixMarket matrix " << (coordinate ? "coordinate " : "array ")
       << (integer ? "integer " : "real ") << (symmetric ? "symmetric\n" : "general\n") << "% a comment\n"
       << A.rows() << ' ' << A.cols();
  if (coordinate) text << ' ' << count;
  text << '\n' << entries.str();
  return text.str();
}

TEST(ReadMatrixMarket, ReturnsWhatWasWritten) {
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  for (const int size : {1, 2, 7}) {
    Eigen::MatrixXd A = Eigen::MatrixXd::NullaryExpr(size, size, [&] { return normal(random); });
    A(0, size - 1) = 0.0;
    const Eigen::MatrixXd S = A + A.transpose();
    const Eigen::MatrixXd N = (10.0 * S).array().round();
    for (const bool coordinate : {true, false}) {
      EXPECT_EQ(Eigen::MatrixXd(read(written(A, coordinate, false))), A);
      EXPECT_EQ(Eigen::MatrixXd(read(written(S, coordinate, true))), S);
      EXPECT_EQ(Eigen::MatrixXd(read(written(S, coordinate, false))), S);
      EXPECT_EQ(Eigen::MatrixXd(read(written(N, coordinate, true, true))), N);
    }
  }
}

TEST(ReadMatrixMarket, TakesWhatOtherProgramsWrite) {
  const SparseMatrix A = read(
      "%%matrixmarket MATRIX Coordinate Real Symmetric\r\n%\r\n% text\r\n\r\n  3 3\t4\r\n1 1 +2\r\n\r\n"
      "% in between\r\n2 1 -1.5e0\r\n3 3 4E-1\r\n2 2 0.0\r\n\r\n");
  Eigen::Matrix3d expected;
  expected << 2, -1.5, 0, -1.5, 0, 0, 0, 0, 0.4;
  EXPECT_EQ(Eigen::Matrix3d(A), expected);
  EXPECT_EQ(A.nonZeros(), 4) << "stored zeros are dropped";
}

TEST(ReadMatrixMarket, TakesTheOtherTriangleFortranNumbersAndAByteOrderMark) {
  Eigen::Matrix2d K, G;
  K << 2, -1, -1, 200;
  G << 0, -0.3, 0.3, 0;
  EXPECT_EQ(Eigen::Matrix2d(read("%%MatrixMarket matrix coordinate real symmetric\n2 2 3\n1 1 2.0\n"
                                 "1 2 -1.0\n2 2 200\n")),
            K);
  EXPECT_EQ(Eigen::Matrix2d(read("\xEF\xBB\xBF%%MatrixMarket matrix array double general\n2 2\n2.0D+00\n"
                                 "-1.0d0\n-10.0D-1\n2.0+2\n")),
            K);
  const std::string skew = "%%MatrixMarket matrix coordinate real skew-symmetric\n2 2 1\n";
  EXPECT_EQ(Eigen::Matrix2d(read(skew + "2 1 0.3\n")), G);
  EXPECT_EQ(Eigen::Matrix2d(read(skew + "1 2 -0.3\n")), G);
  EXPECT_EQ(Eigen::Matrix2d(read("%%MatrixMarket matrix array real skew-symmetric\n%\n2 2\n0.3\n")), G);
}

TEST(ReadMatrixMarket, SumsWhatIsGivenTwiceAndSaysSo) {
  const MatrixFile file = read_matrix_market(
      "%%MatrixMarket matrix coordinate real symmetric\n2 2 5\n1 1 1.5\n2 1 -1\n2 2 2\n1 1 0.25\n1 1 0.25\n",
      "K.mtx");
  Eigen::Matrix2d K;
  K << 2, -1, -1, 2;
  EXPECT_EQ(Eigen::Matrix2d(file.matrix), K);
  EXPECT_EQ(file.notices,
            std::vector<std::string>{"K.mtx: 2 entries are summed onto others at the same place, "
                                     "the first at row 1, column 1 (lines 3 and 6)"});
}

TEST(ReadMatrixMarket, RefusesMalformedFilesInOneLine) {
  const std::string general = "%%MatrixMarket matrix coordinate real general\n";
  const std::string header =
      "must be %%MatrixMarket matrix, coordinate or array, real, double or integer, general, symmetric or "
      "skew-symmetric";
  const std::pair<std::string, std::string> cases[] = {
      {"", "1: header = missing (" + header + ")"},
      {"3 3 0\n", "1: header = \"3 3 0\" (" + header +
                      "; a list of row, column and value lacks that line and one of rows, columns and number "
                      "of entries before it)"},
      {"%%MatrixMarket matrix coordinate complex general\n1 1 0\n",
       "1: header = \"%%MatrixMarket matrix coordinate complex general\" (must be real: a motion in time has "
       "no complex stiffness; write the real part, and structural damping as a damping matrix or as modal)"},
      {"%%MatrixMarket matrix coordinate pattern general\n1 1 0\n",
       "1: header = \"%%MatrixMarket matrix coordinate pattern general\" (" + header + ")"},
      {"%%MatrixMarket vector array real general\n",
       "1: header = \"%%MatrixMarket vector array real general\" (" + header + ")"},
      {general, "1: size = missing (must be rows, columns and number of entries, three numbers)"},
      {general + "% only\n2 2\n",
       "3: size = \"2 2\" (must be rows, columns and number of entries, three numbers)"},
      {general + "2 two 1\n",
       "2: size = \"2 two 1\" (must be rows, columns and number of entries, three numbers)"},
      {general + "2 3 1\n", "2: size = \"2 3 1\" (must be square, of 1..10000000 rows)"},
      {general + "0 0 0\n", "2: size = \"0 0 0\" (must be square, of 1..10000000 rows)"},
      {general + "2 2 5\n", "2: file = 0 entries (must hold 5)"},
      {general + "2 2 -1\n", "2: size = \"2 2 -1\" (must promise 0 entries or more)"},
      {general + "9000000 9000000 80000000000000\n1 1 1\n",
       "2: size = \"9000000 9000000 80000000000000\" (must make at most 20000000 entries, both triangles of "
       "a "
       "symmetric matrix counted)"},
      {"%%MatrixMarket matrix array real symmetric\n4473 4473\n",
       "2: size = \"4473 4473\" (must make at most 20000000 entries, both triangles of a symmetric matrix "
       "counted)"},
      {"%%MatrixMarket matrix array real symmetric\n4472 4472\n1\n",
       "3: file = 1 entries (must hold 10001628)"},
      {general + "2 2 2\n1 1 1.0\n", "3: file = 1 entries (must hold 2)"},
      {general + "2 2 1\n1 1 1.0\n2 2 1.0\n",
       "4: entry = \"2 2 1.0\" (must be absent: the file holds 1 entries)"},
      {general + "2 2 1\n1 1\n", "3: entry = \"1 1\" (must be row, column and value)"},
      {general + "2 2 1\n0 1 1.0\n", "3: entry = \"0 1 1.0\" (row must be in 1..2)"},
      {general + "2 2 1\n1 3 1.0\n", "3: entry = \"1 3 1.0\" (column must be in 1..2)"},
      {general + "2 2 1\n1.5 1 1.0\n", "3: entry = \"1.5 1 1.0\" (row must be in 1..2)"},
      {general + "2 2 1\n1 1 nan\n", "3: entry = \"1 1 nan\" (value must be a finite number)"},
      {general + "2 2 1\n1 1 1e999\n", "3: entry = \"1 1 1e999\" (value must be a finite number)"},
      {general + "2 2 1\n1 1 1,5\n",
       "3: entry = \"1 1 1,5\" (value must be a finite number; a decimal comma: write a point, as in 1.5)"},
      {general + "2 2 1\n1 1 \xE2\x88\x92"
                 "1.5\n",
       "3: entry = \"1 1 \xE2\x88\x92"
       "1.5\" (value must be a finite number; the minus sign is one of a text "
       "processor: write -)"},
      {general + "2 2 2\n1 1 1e308\n1 1 1e308\n", "4: entry = row 1, column 1 (must have a finite sum)"},
      {"%%MatrixMarket matrix coordinate real symmetric\n2 2 2\n2 1 1.0\n1 2 1.0\n",
       "4: entry = row 2, column 1 (must be in one triangle: the header says that the other follows from it, "
       "and line 3 has the other; where both are meant, the header says general)"},
      {"%%MatrixMarket matrix coordinate real skew-symmetric\n2 2 1\n2 2 1.0\n",
       "3: entry = row 2, column 2 (must be 0: the header says skew-symmetric)"},
      {"%%MatrixMarket matrix coordinate integer general\n2 2 1\n1 1 1.5\n",
       "3: entry = \"1 1 1.5\" (value must be a whole number)"},
      {"%%MatrixMarket matrix array real general\n2 2\n1\n2\n3 4\n",
       "5: entry = \"3 4\" (must be one value)"},
      {"%%MatrixMarket matrix array real symmetric\n2 2\n1\n2\n", "4: file = 2 entries (must hold 3)"},
      {"%%MatrixMarket matrix array real general\n2 2 4\n1\n2\n3\n4\n",
       "2: size = \"2 2 4\" (must be rows and columns, two numbers)"},
  };
  for (const auto& [text, message] : cases) {
    EXPECT_EQ(complaint([&, &text = text] { read(text); }), "A.mtx:" + message);
  }
}

TEST(ReadMatrixMarket, NeverFallsOverNoise) {
  const std::string sound = written(Eigen::Matrix3d::Identity() * 2.5, true, true);
  std::mt19937 random(99);
  std::uniform_int_distribution<int> byte(0, 255);
  std::uniform_int_distribution<std::size_t> place(0, sound.size() - 1);
  int refused = 0;
  for (int trial = 0; trial < 500; ++trial) {
    std::string text = sound;
    for (int i = 0; i < 3; ++i) text[place(random)] = static_cast<char>(byte(random));
    const std::string message = complaint([&] { read(text); });
    if (message.empty()) continue;
    ++refused;
    EXPECT_EQ(message.substr(0, 6), "A.mtx:");
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
  EXPECT_GT(refused, 250);
}

constexpr std::string_view kScene = R"(schema = 1
name = "matrices"
[system]
kind = "matrices"
mass = "model/M.mtx"
stiffness = "model/K.mtx"
damping = "model/D.mtx"
[forcing]
frequency = 1.0
)";

class MatrixScene : public testing::Test {
 protected:
  MatrixScene() {
    structure_ = assemble(Beam{.elements = 3});
    structure_.damping = damping_matrix(ProportionalDamping{.alpha = 0.5, .beta = 0.01}, structure_.mass,
                                        structure_.stiffness);
    write("model/M.mtx", written(structure_.mass, true, true));
    write("model/K.mtx", written(structure_.stiffness, true, false));
    write("model/D.mtx", written(structure_.damping, false, true));
  }

  void write(const std::string& name, const std::string& text) {
    static_cast<void>(folder_.write(name, text));
  }
  // The scene with its line `number` replaced.
  std::filesystem::path scene(int number = 0, const std::string& replacement = "") {
    std::istringstream stream{std::string(kScene)};
    std::string text;
    int count = 0;
    for (std::string line; std::getline(stream, line);) {
      text += (++count == number ? replacement : line) + '\n';
    }
    return folder_.write("scene.toml", text);
  }
  std::string refusal(int number, const std::string& replacement) {
    const std::filesystem::path path = scene(number, replacement);
    const std::string message = complaint([&] { load_scene(path); });
    const std::string folder = folder_.path().string() + "/";
    return message.starts_with(folder) ? message.substr(folder.size()) : message;
  }

  TemporaryFolder folder_;
  Structure structure_;
};

TEST_F(MatrixScene, FindsItsFilesBesideIt) {
  const Problem problem = load_scene(scene());
  EXPECT_EQ(problem.kind, "matrices");
  EXPECT_EQ(Eigen::MatrixXd(problem.mass()), Eigen::MatrixXd(structure_.mass));
  EXPECT_EQ(Eigen::MatrixXd(problem.damping()), Eigen::MatrixXd(structure_.damping));
  EXPECT_EQ(Eigen::MatrixXd(problem.stiffness()), Eigen::MatrixXd(structure_.stiffness));
}

TEST_F(MatrixScene, TakesDampingModelsInsteadOfAFile) {
  const Problem rayleigh = load_scene(scene(7, "rayleigh = { alpha = 0.5, beta = 0.01 }"));
  EXPECT_EQ(Eigen::MatrixXd(rayleigh.damping()), Eigen::MatrixXd(structure_.damping));

  const Problem modal = load_scene(scene(7, "modal = [0.02, 0.05]"));
  const SparseMatrix expected =
      damping_matrix(ModalDamping{{0.02, 0.05}}, structure_.mass, structure_.stiffness);
  EXPECT_EQ(Eigen::MatrixXd(modal.damping()), Eigen::MatrixXd(expected));
}

TEST_F(MatrixScene, IsRefusedInOneLineThatNamesTheCulprit) {
  EXPECT_EQ(refusal(5, ""),
            "scene.toml:3: system.mass = missing (must be the name of a file of a matrix, relative to the "
            "scene's folder)");
  EXPECT_EQ(refusal(5, "mass = 1.0"),
            "scene.toml:5: system.mass = 1 (must be the name of a file of a matrix, relative to the scene's "
            "folder)");
  EXPECT_EQ(refusal(5, "mass = \"model\""),
            "scene.toml:5: system.mass = \"model\" (must be the name of a file of a matrix, relative to the "
            "scene's folder; it is a folder)");
  EXPECT_EQ(refusal(5, "mass = \"M.mtx\""),
            "scene.toml:5: system.mass = \"M.mtx\" (must be the name of a file of a matrix, relative to the "
            "scene's folder; it is missing)");
  EXPECT_EQ(refusal(7, ""),
            "scene.toml:3: system.damping = missing (must be the name of a file; or give modal or rayleigh "
            "instead)");
  EXPECT_EQ(refusal(7, "damping = { alpha = 0.1 }"),
            "scene.toml:7: system.damping = {alpha = 0.1} (must be the name of a file of a matrix, relative "
            "to the scene's folder)");
  EXPECT_EQ(refusal(7, "rayleigh = {}"),
            "scene.toml:7: system.rayleigh = {} (must be { alpha = .., beta = .. })");
  EXPECT_EQ(refusal(7, "rayleigh = { alpha = 1.0 }\nmodal = 0.1"),
            "scene.toml:8: system.modal = 0.1 (must be absent: rayleigh is given)");
  EXPECT_EQ(refusal(7, "damping = \"model/D.mtx\"\nrayleigh = { alpha = 1.0 }"),
            "scene.toml:8: system.rayleigh = {alpha = 1} (must be absent: damping is given)");
  EXPECT_EQ(refusal(7, "modal = \"small\""),
            "scene.toml:7: system.modal = \"small\" (must be a damping ratio >= 0 [-], or a list of them)");
  EXPECT_EQ(
      refusal(7, "young = 1.0"),
      "scene.toml:7: system.young = 1 (unknown key; known: kind, mass, damping, rayleigh, modal, "
      "stiffness, gyroscopic, circulatory, gyroscopic_per_speed, circulatory_per_speed, symmetric_part)");
}

TEST_F(MatrixScene, IsRefusedForMatricesThatAreNoStructure) {
  const Eigen::Matrix2d small = Eigen::Matrix2d::Identity();
  write("small.mtx", written(small, true, true));
  EXPECT_EQ(refusal(6, "stiffness = \"small.mtx\""),
            "scene.toml:6: system.stiffness = 2 x 2 matrix (must be 6 x 6, as mass)");
  EXPECT_EQ(refusal(7, "damping = \"small.mtx\""),
            "scene.toml:7: system.damping = 2 x 2 matrix (must be 6 x 6, as mass)");

  Eigen::MatrixXd K = structure_.stiffness;
  K(0, 1) += 1.0;
  write("skew.mtx", written(K, true, false));
  EXPECT_EQ(refusal(6, "stiffness = \"skew.mtx\""),
            "scene.toml:6: system.stiffness = unsymmetric matrix (must be symmetric to 1e-12 of its largest "
            "entry; a_ij - a_ji is up to 0.0015 of it: symmetric_part = [\"stiffness\"] drops that; what is "
            "meant is a circulatory matrix)");
  for (const std::string key :
       {"gyroscopic", "circulatory", "gyroscopic_per_speed", "circulatory_per_speed"}) {
    EXPECT_EQ(refusal(7, "rayleigh = { alpha = 0.1 }\n" + key + " = \"skew.mtx\""),
              "scene.toml:8: system." + key +
                  " = matrix with a symmetric part (must be skew-symmetric to 1e-12 of its largest entry)");
  }
  write("model/K.mtx", "%%MatrixMarket matrix coordinate real symmetric\n6 6 1\n7 1 1.0\n");
  EXPECT_EQ(refusal(0, ""), "model/K.mtx:3: entry = \"7 1 1.0\" (row must be in 1..6)");
}

constexpr std::string_view kTwoMasses = R"(schema = 1
name = "matrices"
[system]
kind = "matrices"
mass = "M.mtx"
stiffness = "K.mtx"
modal = 0.1
[forcing]
frequency_hz = 0.5
term = [{ dof = 1, cos = 1.0 }]
)";

TEST_F(MatrixScene, FollowsTheFrequencyWhereItsRotorDoes) {
  write("M.mtx", written(Eigen::Matrix2d::Identity(), true, true));
  write("K.mtx", written(3.0 * Eigen::Matrix2d::Identity(), true, true));
  write("G.mtx", "%%MatrixMarket matrix coordinate real skew-symmetric\n2 2 1\n2 1 0.25\n");
  std::string text(kTwoMasses);
  text.replace(
      text.find("modal = 0.1"), 11,
      "rayleigh = { beta = 0.5 }\ngyroscopic_per_speed = \"G.mtx\"\ncirculatory_per_speed = \"G.mtx\"");
  text.replace(text.find("frequency_hz = 0.5"), 18, "frequency = 4.0");
  const Problem problem = load_scene(folder_.write("a.toml", text));
  const auto matrix = [](double a, double b) { return (Eigen::Matrix2d() << a, -b, b, a).finished(); };
  EXPECT_EQ(Eigen::Matrix2d(problem.damping()), matrix(1.5, 1.0));
  EXPECT_EQ(Eigen::Matrix2d(problem.stiffness()), matrix(3.0, 1.0));
  const Problem slow = at_frequency(at_frequency(problem, 64.0), 2.0);
  EXPECT_EQ(Eigen::Matrix2d(slow.damping()), matrix(1.5, 0.5));
  EXPECT_EQ(Eigen::Matrix2d(slow.stiffness()), matrix(3.0, 0.5));
}

TEST_F(MatrixScene, TakesTheSymmetricPartOnRequestAndSaysWhatIsDropped) {
  write("M.mtx", written(Eigen::Matrix2d::Identity(), true, true));
  write("K.mtx", "%%MatrixMarket matrix coordinate real general\n2 2 4\n1 1 2\n1 2 -1.5\n2 1 -0.5\n2 2 2\n");
  std::string text(kTwoMasses);
  text.insert(text.find("modal"), "symmetric_part = [\"stiffness\"]\n");
  const std::filesystem::path file = folder_.write("a.toml", text);
  const Problem problem = load_scene(file);
  Eigen::Matrix2d K;
  K << 2, -1, -1, 2;
  EXPECT_EQ(Eigen::Matrix2d(problem.stiffness()), K);
  EXPECT_EQ(load_outline(file).notices,
            std::vector<std::string>{"stiffness: its symmetric part; dropped are skew entries "
                                     "up to 0.5, 0.25 of the largest entry"});
  EXPECT_DOUBLE_EQ(problem.frequency, std::numbers::pi);
}

// A coordinate with a penalty is at rest: K and M of the others alone. One of rounding has no mass.
TEST_F(MatrixScene, HoldsSupportsByPenaltyAndDropsRounding) {
  write("M.mtx", "%%MatrixMarket matrix coordinate real symmetric\n3 3 3\n1 1 1\n2 2 1\n3 3 1\n");
  write("K.mtx",
        "%%MatrixMarket matrix coordinate real symmetric\n3 3 5\n1 1 1e20\n2 1 -1\n2 2 3\n3 2 -1\n3 3 2\n");
  const std::filesystem::path file = folder_.write("a.toml", kTwoMasses);
  const Problem held = load_scene(file);
  Eigen::Matrix3d K, M;
  K << 3, 0, 0, 0, 3, -1, 0, -1, 2;
  M << 0, 0, 0, 0, 1, 0, 0, 0, 1;
  EXPECT_EQ(Eigen::Matrix3d(held.stiffness()), K);
  EXPECT_EQ(Eigen::Matrix3d(held.mass()), M);
  EXPECT_EQ(Eigen::Matrix3d(held.damping()).row(0).norm(), 0.0);
  ASSERT_EQ(load_outline(file).notices.size(), 1U);
  EXPECT_TRUE(load_outline(file).notices[0].starts_with("stiffness: 1e+20 N/m at coordinate 0, "))
      << load_outline(file).notices[0];

  write("M.mtx", "%%MatrixMarket matrix coordinate real symmetric\n3 3 3\n1 1 -1e-17\n2 2 1\n3 3 1\n");
  write("K.mtx",
        "%%MatrixMarket matrix coordinate real symmetric\n3 3 5\n1 1 2\n2 1 -1\n2 2 3\n3 2 -1\n3 3 2\n");
  EXPECT_EQ(Eigen::Matrix3d(load_scene(file).mass()), M);
  EXPECT_EQ(load_outline(file).notices,
            std::vector<std::string>{"mass: -1e-17 at coordinate 0 is rounding and taken as 0"});
}

TEST_F(MatrixScene, LeavesComplaintsToValidationWhereThereAreNoModes) {
  write("model/M.mtx", written(-Eigen::MatrixXd(structure_.mass), true, true));
  EXPECT_EQ(refusal(7, "modal = 0.1"),
            "scene.toml:5: system.mass = indefinite matrix (must be positive semi-definite)");
  write("model/M.mtx", written(Eigen::MatrixXd::Zero(6, 6), true, true));
  EXPECT_EQ(refusal(7, "modal = 0.1"), "scene.toml:5: system.mass = 0 (some coordinate must carry mass)");
}

}  // namespace
}  // namespace signorini::test::matrix_market_test
