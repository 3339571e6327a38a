#pragma once
// A square matrix from the entries that its file lists.

#include <string>
#include <string_view>
#include <vector>

#include "problems/files/text_lines.hpp"
#include "problems/structure.hpp"

namespace signorini {

/// Largest number of rows that is read.
inline constexpr int kMostMatrixRows = 10'000'000;
/// Largest number of entries of a matrix, both triangles of a symmetric one counted: a full one of 4472 rows.
inline constexpr int kMostMatrixEntries = 20'000'000;

/// What a file leaves out because another entry says it.
enum class Symmetry {
  general,    ///< nothing
  symmetric,  ///< a_ij where a_ji is given
  skew        ///< a_ij = -a_ji where a_ji is given
};

/// An entry of a file.
struct MatrixEntry {
  int row = 0, column = 0;  ///< from 0
  double value = 0.0;       ///< finite
  int line = 0;             ///< where it stands
  bool above = false;       ///< above the diagonal; kept where assembly mirrors the entry
};

/// A matrix, and what the reader decided about its file, each in a line for the user.
struct MatrixFile {
  SparseMatrix matrix = {};
  std::vector<std::string> notices = {};
};

/// The number that a word is, with the exponents of Fortran: 1.5D+03, 1.5-103.
/// \throws SceneError at the line for what is no finite number
double matrix_value(const TextLines& lines, std::string_view word);

/// Refuses sizes that are not square or too large. \param rows, columns  as the file says
int matrix_size(const TextLines& lines, std::int64_t rows, std::int64_t columns);

/// Refuses a number of entries below 0, or that would make more than kMostMatrixEntries.
void require_entry_count(const TextLines& lines, std::int64_t entries, int size, Symmetry symmetry);

/// Whether an entry and its mirror image are both among these.
bool has_both_triangles(const std::vector<MatrixEntry>& entries);

/// The matrix of size x size. Entries of a symmetric or skew one may stand in either triangle. What is given
/// more than once is summed, with a notice; zeros are left out. \throws SceneError for an entry of a
/// symmetric or skew matrix in both triangles, a diagonal of a skew one that is not 0, or a sum that is not
/// finite
MatrixFile assemble_matrix(const TextLines& lines, int size, std::vector<MatrixEntry> entries,
                           Symmetry symmetry);

}  // namespace signorini
