#pragma once
// A file of a matrix in any of the formats that are read.

#include <string>
#include <string_view>

#include "problems/files/matrices/abaqus_matrix.hpp"

namespace signorini {

/// The degrees of freedom that a file of Abaqus names; none for other formats. \throws SceneError for a file
/// of Abaqus that is none
NodeDofs coordinates_of_matrix_file(std::string_view text, const std::string& name);

/// Reads the matrix of a file: Matrix Market, Abaqus (*MATRIX INPUT), Harwell-Boeing or Rutherford-Boeing.
/// \param coordinates  of all files of Abaqus of a structure, which share their numbers
/// \throws SceneError `NAME:LINE: what = found (what is required)` for a file that is not sound or of another
/// format
MatrixFile read_matrix_file(std::string_view text, const std::string& name, const NodeDofs& coordinates = {});

}  // namespace signorini
