#pragma once
// Square matrices in the Matrix Market exchange format, as finite-element codes write them.

#include <string>
#include <string_view>

#include "problems/files/matrices/matrix_entries.hpp"

namespace signorini {

/// Reads one square matrix from the text of its file: `%%MatrixMarket matrix coordinate|array
/// real|double|integer general|symmetric|skew-symmetric` [boisvert1996], rows and columns counted from 1;
/// symmetric and skew ones by one of each pair of entries, in an array by the lower triangle; comments and
/// blank lines may stand anywhere after the first line. `name` stands for the file in messages.
/// \throws SceneError `NAME:LINE: what = found (what is required)` for anything else: a complex, pattern or
/// rectangular matrix, a number that is none or not finite, an index out of range, an entry of a symmetric
/// matrix given in both triangles, too few or too many entries
MatrixFile read_matrix_market(std::string_view text, const std::string& name);

}  // namespace signorini
