#pragma once
// Square matrices in the Matrix Market exchange format, as finite-element codes write them.

#include <string>
#include <string_view>

#include "problems/structure.hpp"

namespace signorini {

/// Largest number of rows that is read.
inline constexpr int kMostMatrixRows = 10'000'000;
/// Largest number of entries of a matrix, both triangles of a symmetric one counted: a full one of 4472 rows.
inline constexpr int kMostMatrixEntries = 20'000'000;

/// Reads one square matrix from the text of its file: `%%MatrixMarket matrix coordinate|array real|integer
/// general|symmetric` [boisvert1996], rows and columns counted from 1, symmetric ones by their lower
/// triangle; comments and blank lines may stand anywhere after the first line. Stored zeros are dropped.
/// `name` stands for the file in messages. \throws SceneError `NAME:LINE: what = found (what is required)`
/// for anything else: a complex, pattern, skew or rectangular matrix, a number that is none or not finite, an
/// index out of range, an entry given twice or above the diagonal of a symmetric matrix, too few or too many
/// entries
SparseMatrix read_matrix_market(std::string_view text, const std::string& name);

}  // namespace signorini
