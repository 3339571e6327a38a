#pragma once
// Lines of a mesh that can be told apart on paper.

#include <string>
#include <vector>

namespace signorini {

/// Inner lines of so many equal elements, as shares of the whole in (0, 1): all of them up to 40 elements, of
/// finer meshes about 40 lines.
std::vector<double> mesh_lines(int elements);

/// "20 elements", and of how many the lines are where they are not all drawn: "10000 elements (lines every
/// 250)".
std::string elements_text(int elements);

}  // namespace signorini
