#pragma once
// A file of a matrix in any of the formats that are read.

#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "problems/files/matrices/matrix_entries.hpp"

namespace signorini {

// The Matrix Market exchange format, as finite-element codes write it.

/// Reads one square matrix from the text of its file: `%%MatrixMarket matrix coordinate|array
/// real|double|integer general|symmetric|skew-symmetric` [boisvert1996], rows and columns counted from 1;
/// symmetric and skew ones by one of each pair of entries, in an array by the lower triangle; comments and
/// blank lines may stand anywhere after the first line. `name` stands for the file in messages.
/// \throws SceneError `NAME:LINE: what = found (what is required)` for anything else: a complex, pattern or
/// rectangular matrix, a number that is none or not finite, an index out of range, an entry of a symmetric
/// matrix given in both triangles, too few or too many entries
MatrixFile read_matrix_market(std::string_view text, const std::string& name);

// Matrices as Abaqus writes them for *MATRIX INPUT: by node and degree of freedom.

/// Degrees of freedom of nodes, (node, degree of freedom), by rising node: the coordinates of a structure.
using NodeDofs = std::set<std::pair<std::int64_t, std::int64_t>>;

/// Whether a line, the first with content that is no comment (**) or keyword (*MATRIX INPUT), begins such a
/// file: node, degree of freedom, node, degree of freedom and value, parted by commas.
bool is_abaqus_entry(std::string_view line);

/// The degrees of freedom that the entries of a file name. \throws SceneError for a line that is no entry
NodeDofs abaqus_coordinates(std::string_view text, const std::string& name);

/// The matrix, coordinates being those of `all`, in their order; entries are mirrored unless some stand in
/// both triangles. \param all  names all that abaqus_coordinates(text) does \throws SceneError as
/// abaqus_coordinates, and as assemble_matrix
MatrixFile read_abaqus_matrix(std::string_view text, const std::string& name, const NodeDofs& all);

// The Harwell-Boeing exchange format and its successor, Rutherford-Boeing.

/// Whether one of the first three lines with content says so: its first word is the type of a matrix, such as
/// RSA, and whole numbers follow, its sizes.
bool is_harwell_boeing(std::string_view text, const std::string& name);

/// Reads one real, assembled matrix (types R or I; S, Z, U or R; A), in columns of the widths that the file's
/// Fortran formats say [duff1989]. \throws SceneError `NAME:LINE: what = found (what is required)` for
/// another type, a rectangular matrix, a format without field width, and what is no sound number
MatrixFile read_harwell_boeing(std::string_view text, const std::string& name);

// Any of them.

/// The degrees of freedom that a file of Abaqus names; none for other formats. \throws SceneError for a file
/// of Abaqus that is none
NodeDofs coordinates_of_matrix_file(std::string_view text, const std::string& name);

/// Reads the matrix of a file: Matrix Market, Abaqus (*MATRIX INPUT), Harwell-Boeing or Rutherford-Boeing.
/// \param coordinates  of all files of Abaqus of a structure, which share their numbers
/// \throws SceneError `NAME:LINE: what = found (what is required)` for a file that is not sound or of another
/// format
MatrixFile read_matrix_file(std::string_view text, const std::string& name, const NodeDofs& coordinates = {});

}  // namespace signorini
