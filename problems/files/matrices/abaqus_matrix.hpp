#pragma once
// Matrices as Abaqus writes them for *MATRIX INPUT: by node and degree of freedom.

#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "problems/files/matrices/matrix_entries.hpp"

namespace signorini {

/// Degrees of freedom of nodes, (node, degree of freedom), by rising node: the coordinates of a structure.
using NodeDofs = std::set<std::pair<std::int64_t, std::int64_t>>;

/// Whether a line, the first with content that is no comment (**), begins such a file: node, degree of
/// freedom, node, degree of freedom and value, parted by commas.
bool is_abaqus_entry(std::string_view line);

/// The degrees of freedom that the entries of a file name. \throws SceneError for a line that is no entry
NodeDofs abaqus_coordinates(std::string_view text, const std::string& name);

/// The matrix, coordinates being those of `all`, in their order; entries are mirrored unless some stand in
/// both triangles. \param all  names all that abaqus_coordinates(text) does \throws SceneError as
/// abaqus_coordinates, and as assemble_matrix
MatrixFile read_abaqus_matrix(std::string_view text, const std::string& name, const NodeDofs& all);

}  // namespace signorini
