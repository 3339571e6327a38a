#pragma once
// A TOML document as a plain tree that remembers lines: the only part that knows the TOML library.

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace signorini {

struct TomlNode;
struct TomlEntry;

/// A date or time: no scene needs one, messages print it.
struct TomlMoment {
  std::string text;
};

using TomlArray = std::vector<TomlNode>;
/// In the order of the file.
using TomlTable = std::vector<TomlEntry>;

struct TomlNode {
  int line = 1;  ///< where the value begins; for a table, where its header stands
  std::variant<TomlTable, TomlArray, std::string, std::int64_t, double, bool, TomlMoment> value;

  /// The entry of that name if this is a table that has it, else null.
  [[nodiscard]] const TomlNode* find(std::string_view key) const;
};

struct TomlEntry {
  std::string key;
  int line = 1;  ///< where the key stands
  TomlNode value;
};

/// A file that cannot be used. what() is the one line for the user,
/// `FILE:LINE: field = value (what is required)`; the line is absent where none applies.
class SceneError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The whole document, a table.
/// \param file  named in messages
/// \throws SceneError if it is not TOML, or a key has more than 100 parts
TomlNode parse_toml(std::string_view text, const std::string& file);

/// A step of a dotted path with indices, "forcing.term[0].dof": a key, or an index.
struct PathStep {
  std::string_view key = {};
  std::optional<std::size_t> index = {};
};

/// Takes the first step off a path that is not empty; none, the path as it was, where it begins with a
/// malformed index: "[x]", "[0", "[0]gap".
std::optional<PathStep> take_step(std::string_view& path);

/// The value on one line as a message shows it: strings quoted, control characters escaped, long ones cut.
std::string print(const TomlNode& node);

/// Whether a text holds an ASCII control character, line breaks and DEL among them.
bool has_control_characters(std::string_view text);

/// Control characters, and bytes that are no UTF-8, as \n or \x1b; what follows the first `length` bytes as
/// "...": for one-line messages, safe on a terminal.
std::string one_line(std::string_view text, std::size_t length = 60);

/// What a text that is no number most likely suffers from, "; a decimal comma ..." to end a message with;
/// empty for none of the common mistakes: a decimal comma, a minus sign of a text processor.
std::string number_mistake(std::string_view text);

/// number_mistake of a line of TOML, behind = where it is a comma: between brackets a comma parts numbers.
std::string toml_number_mistake(std::string_view line);

}  // namespace signorini
