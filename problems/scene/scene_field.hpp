#pragma once
// A value of a scene file that knows its path and line, so that every complaint names both.

#include <cstddef>
#include <initializer_list>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "problems/files/toml_tree.hpp"

namespace signorini {

/// Least value of a number that must be positive.
inline constexpr double kLeastPositive = std::numeric_limits<double>::min();

/// A place in a scene file, "forcing.term[0].dof", whether or not something stands there.
/// All readers throw SceneError, `FILE:LINE: path = value (requirement)`; what is missing prints as `missing`
/// at the line of the table that should hold it. The tree and the file name must outlive the field.
class SceneField {
 public:
  /// The whole document. `file` is its name in messages.
  SceneField(const TomlNode& document, const std::string& file);

  /// Entry of a table; of anything else, a missing one.
  [[nodiscard]] SceneField operator[](std::string_view key) const;
  /// Field of a dotted path with indices relative to this one; missing where the path leads nowhere.
  [[nodiscard]] SceneField at(std::string_view path) const;
  [[nodiscard]] bool given() const { return node_ != nullptr; }
  [[nodiscard]] bool is_table() const { return as<TomlTable>() != nullptr; }
  [[nodiscard]] bool is_array() const { return as<TomlArray>() != nullptr; }
  [[nodiscard]] bool is_text() const { return as<std::string>() != nullptr; }
  [[nodiscard]] const std::string& path() const { return path_; }
  /// This field under another path, for a part that was taken out of its document.
  [[nodiscard]] SceneField named(std::string path) const { return {node_, std::move(path), line_, file_}; }
  /// The value. Requires given().
  [[nodiscard]] const TomlNode& node() const { return *node_; }
  /// Keys of a table in the order of the file; none of anything else.
  [[nodiscard]] std::vector<std::string> keys() const;
  /// Name of the scene file, as messages give it.
  [[nodiscard]] const std::string& file() const { return *file_; }

  /// Refuses anything but a table, and in it any key but these.
  void allow_only(std::initializer_list<std::string_view> keys, std::string_view requirement) const;
  /// Whether one of these entries of a table is given.
  [[nodiscard]] bool has_any(std::initializer_list<std::string_view> keys) const;
  /// Refuses each of these entries of a table that is given: it must be absent, and why.
  void forbid(std::initializer_list<std::string_view> keys, std::string_view why) const;
  /// Items of an array; refuses an empty one, and one of another length than `count` if that is given.
  [[nodiscard]] std::vector<SceneField> items(std::string_view requirement, std::size_t count = 0) const;
  /// The same; none where nothing is given.
  [[nodiscard]] std::vector<SceneField> items_or_none(std::string_view requirement) const;
  /// A finite number, >= least if that is given; TOML integers will do.
  [[nodiscard]] double number(std::string_view requirement,
                              double least = std::numeric_limits<double>::lowest()) const;
  /// The same; `otherwise` where nothing is given.
  [[nodiscard]] double number_or(double otherwise, std::string_view requirement,
                                 double least = std::numeric_limits<double>::lowest()) const;
  /// A whole number in least..most.
  [[nodiscard]] int whole(std::string_view requirement, int least, int most) const;
  /// The same, which a refusal says: must be `what`, least..most.
  [[nodiscard]] int in_range(std::string_view what, int least, int most) const;
  [[nodiscard]] int whole_or(int otherwise, std::string_view requirement, int least, int most) const;
  /// True or false.
  [[nodiscard]] bool truth(std::string_view requirement) const;
  /// A string without line breaks and other control characters.
  [[nodiscard]] std::string text(std::string_view requirement) const;
  /// One of these words; a refusal lists them, and adds the remark.
  [[nodiscard]] std::string one_of(const std::vector<std::string_view>& words,
                                   std::string_view remark = {}) const;

  /// \throws SceneError with the value found, or `missing`
  [[noreturn]] void refuse(std::string_view requirement) const;
  /// Refuses the field with `found` in place of its value.
  [[noreturn]] void refuse(std::string_view found, std::string_view requirement) const;

 private:
  SceneField(const TomlNode* node, std::string path, int line, const std::string* file);
  [[nodiscard]] SceneField item(std::size_t index) const;
  // The value if it is of this type, else null.
  template <class Value>
  [[nodiscard]] const Value* as() const {
    return given() ? std::get_if<Value>(&node_->value) : nullptr;
  }

  const TomlNode* node_;  // null: missing
  std::string path_;
  int line_;
  const std::string* file_;
};

/// "\"a\", \"b\" or \"c\"", for messages. \param words  two or more
std::string alternatives(const std::vector<std::string_view>& words);

}  // namespace signorini
