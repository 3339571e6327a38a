#include "problems/files/matrices/matrix_file.hpp"

namespace signorini {

namespace {

enum class MatrixFormat { matrix_market, abaqus, harwell_boeing };

// Matrix Market, whose reader says what is required, for what is none of these.
MatrixFormat format_of_matrix(std::string_view text, const std::string& name) {
  TextLines lines(text, name);
  while (lines.next()) {
    if (lines.words()[0].starts_with('*')) continue;
    if (is_abaqus_entry(lines.line())) return MatrixFormat::abaqus;
    break;
  }
  return is_harwell_boeing(text, name) ? MatrixFormat::harwell_boeing : MatrixFormat::matrix_market;
}

}  // namespace

NodeDofs coordinates_of_matrix_file(std::string_view text, const std::string& name) {
  return format_of_matrix(text, name) == MatrixFormat::abaqus ? abaqus_coordinates(text, name) : NodeDofs{};
}

MatrixFile read_matrix_file(std::string_view text, const std::string& name, const NodeDofs& coordinates) {
  const MatrixFormat format = format_of_matrix(text, name);
  if (format == MatrixFormat::matrix_market) return read_matrix_market(text, name);
  if (format == MatrixFormat::harwell_boeing) return read_harwell_boeing(text, name);
  NodeDofs all = abaqus_coordinates(text, name);
  all.insert(coordinates.begin(), coordinates.end());
  return read_abaqus_matrix(text, name, all);
}

}  // namespace signorini
