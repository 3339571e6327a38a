#include "problems/files/matrices/matrix_file.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "problems/files/toml_tree.hpp"

namespace signorini::test::matrix_file_test {
namespace {

Eigen::MatrixXd read(std::string_view text, const NodeDofs& coordinates = {}) {
  return read_matrix_file(text, "K.mtx", coordinates).matrix;
}

std::string refusal(std::string_view text) {
  try {
    static_cast<void>(read(text));
    return "";
  } catch (const SceneError& error) {
    return error.what();
  }
}

Eigen::Matrix3d tridiagonal() {
  Eigen::Matrix3d K;
  K << 2, -1, 0, -1, 2, -0.5, 0, -0.5, 1e-5;
  return K;
}

// As scipy.io.hb_write writes it.
constexpr std::string_view kUnsymmetric =
    "Default title                                                           0       \n"
    "             5             1             1             3\n"
    "RUA                        3             3             7             0\n"
    "(40I2)          (40I2)          (3E25.16)           \n"
    " 1 3 6 8\n"
    " 1 2 1 2 3 2 3\n"
    "  2.0000000000000000E+00 -1.0000000000000000E+00 -1.0000000000000000E+00\n"
    "  2.0000000000000000E+00 -5.0000000000000000E-01 -5.0000000000000000E-01\n"
    "  1.0000000000000001E-05\n";

// One triangle, a right-hand side that is not read, fields that touch, exponents of Fortran.
constexpr std::string_view kSymmetric =
    "Stiffness of a plate                                                    PLATE   \n"
    "             4             1             1             2             1\n"
    "RSA                        3             3             5             0\n"
    "(4I1)           (5I1)           (1P,3D10.3)         (3E10.3)            \n"
    "F                          1             0\n"
    "1356\n"
    "12233\n"
    " 2.000D+00-1.000D+00 2.000D+00\n"
    "-5.000D-01 1.000D-05\n"
    " 1.000E+00 1.000E+00 1.000E+00\n";

TEST(ReadMatrixFile, TakesHarwellBoeing) {
  EXPECT_EQ(read(kUnsymmetric), tridiagonal());
  EXPECT_EQ(read(kSymmetric), tridiagonal());
  std::string skew(kSymmetric);
  skew.replace(skew.find("RSA"), 3, "rza");
  EXPECT_EQ(refusal(skew), "K.mtx:7: entry = row 1, column 1 (must be 0: the header says skew-symmetric)");
}

TEST(ReadMatrixFile, RefusesHarwellBoeingThatIsNotSound) {
  const auto with = [](std::string_view old, std::string_view by) {
    std::string text(kSymmetric);
    return text.replace(text.find(old), old.size(), by);
  };
  EXPECT_EQ(refusal(with("RSA", "CSA")),
            "K.mtx:3: type = \"CSA 3 3 5 0\" (must be real and assembled: RSA, RUA, RZA or RRA)");
  EXPECT_EQ(refusal(with("3             3             5", "3             4             5")),
            "K.mtx:3: size = \"RSA 3 4 5 0\" (must be square, of 1..10000000 rows)");
  EXPECT_EQ(
      refusal(with("(5I1)", "(*)  ")),
      "K.mtx:4: formats = \"(4I1) (*) (1P,3D10.3) (3E10.3)\" (must have a Fortran format, such as (10I8), in "
      "columns 17 to 32)");
  EXPECT_EQ(refusal(with("1356", "1256")), "");
  EXPECT_EQ(refusal(with("1356", "1355")),
            "K.mtx:6: entry = \"1355\" (must end with 6, one more than the entries)");
  EXPECT_EQ(refusal(with("1356", "1326")), "K.mtx:6: entry = \"1326\" (2 must be a whole number in 3..6)");
  EXPECT_EQ(refusal(with("12233", "12243")), "K.mtx:7: entry = \"12243\" (4 must be a whole number in 1..3)");
  EXPECT_EQ(refusal(kSymmetric.substr(0, kSymmetric.find("-5.000D-01"))),
            "K.mtx:8: file = its end (must hold 2 more numbers)");
  EXPECT_EQ(refusal(with("             5             0", "    9999999999             0")),
            "K.mtx:3: size = \"RSA 3 3 9999999999 0\" (word 4 must be a whole number in 0..20000000)");
  EXPECT_EQ(refusal(with("             5             0", "      19999999             0")),
            "K.mtx:3: size = \"RSA 3 3 19999999 0\" (must make at most 20000000 entries, both triangles of a "
            "symmetric matrix counted)");
}

TEST(ReadMatrixFile, NumbersTheNodesOfAbaqus) {
  const std::string_view one_triangle =
      "** stiffness\n*MATRIX INPUT, NAME=K, TYPE=SYMMETRIC\n20,1, 20,1, 1.0e-5\n3,1, 3,1, 2.0\n3,2, 3,1, "
      "-1.0e+00\n3,2, 3,2,  2.0\n20,1, 3,2, "
      "-5D-1\n";
  EXPECT_EQ(read(one_triangle), tridiagonal());
  EXPECT_EQ(read("1,1,1,1,2\n1,1,2,1,-1\n2,1,1,1,-2\n2,1,2,1,3\n"),
            (Eigen::Matrix2d() << 2, -1, -2, 3).finished());
  // A mass that leaves a degree of freedom out has the coordinates of the stiffness.
  const NodeDofs all = coordinates_of_matrix_file(one_triangle, "K.mtx");
  EXPECT_EQ(all, (NodeDofs{{3, 1}, {3, 2}, {20, 1}}));
  EXPECT_EQ(read("20,1, 20,1, 4\n", all), Eigen::Vector3d(0, 0, 4).asDiagonal().toDenseMatrix());
  EXPECT_TRUE(coordinates_of_matrix_file(kSymmetric, "K.mtx").empty());
  const MatrixFile file = read_matrix_file(one_triangle, "K.mtx");
  EXPECT_EQ(file.notices,
            std::vector<std::string>{
                "K.mtx: Abaqus; coordinates by rising node and degree of freedom, 0 is node 3, degree "
                "1, and 2 node 20, degree 1; the other triangle follows from the one given"});
  EXPECT_EQ(
      refusal("1,1,1,1,2\n1,1,2\n"),
      "K.mtx:2: entry = \"1 1 2\" (must be node, degree of freedom, node, degree of freedom and value)");
  EXPECT_EQ(refusal("1,1,1,1,two\n"), "K.mtx:1: entry = \"1 1 1 1 two\" (value must be a finite number)");
}

TEST(ReadMatrixFile, RefusesWhatIsNoMatrix) {
  const std::string header =
      "must be %%MatrixMarket matrix, coordinate or array, real, double or integer, general, symmetric or "
      "skew-symmetric";
  EXPECT_EQ(refusal("node,value\n1,2\n"),
            "K.mtx:1: header = \"node,value\" (" + header +
                "; a list of row, column and value lacks that line and one of rows, "
                "columns and number of entries before it)");
  EXPECT_EQ(refusal("PK\x03\x04"), "K.mtx:1: header = \"PK\\x03\\x04\" (" + header + ")");
  EXPECT_EQ(refusal(""), "K.mtx:1: header = missing (" + header + ")");
}

}  // namespace
}  // namespace signorini::test::matrix_file_test
