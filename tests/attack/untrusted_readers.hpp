#pragma once
// The readers of text that anybody may have written, each with what SECURITY.md promises of it as a check.

#include <span>
#include <stdexcept>
#include <string_view>

namespace signorini::test {

/// A reader broke a promise; what() says which.
class Violation : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

/// A reader of the program. `attack` reads any bytes with it: what it refuses, it must refuse with the
/// exception that its header names and one line without control characters; what it accepts must be finite
/// and mean the same when it is written and read again. \return whether it was accepted, of lines whether one
/// was \throws Violation where it is otherwise; any other exception is one that the reader lets escape
struct UntrustedReader {
  std::string_view name;  ///< of its folder in tests/attack/corpus
  bool (*attack)(std::string_view text);
};

/// - scene: a scene in TOML, and all that is derived from its structure before a method is asked
/// - matrix: a matrix in the Matrix Market format
/// - records: lines of records, and every table and page that a report makes of them
/// - branches: lines of branches and steps as sweep keeps them, and the table of them
/// - answer: what a command prints, and the motion and the measures that the harness takes from it
/// - archive: a tar archive, as it is in a pack
/// - pack: manifest, plan and records of a pack, from which it is packed again
/// - options: methods by name with their options, as --methods and suites have them
/// - curves: a file of branches that a program has followed, and what is made of it over an interval
/// - suite: a suite in TOML
std::span<const UntrustedReader> untrusted_readers();

/// The reader of that name. \throws std::out_of_range
const UntrustedReader& untrusted_reader(std::string_view name);

}  // namespace signorini::test
