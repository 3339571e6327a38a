#pragma once
// What `signorini verify` does with a folder: orbits are searched again, cases are run again.

#include <filesystem>
#include <optional>
#include <string>

#include "harness/orbits/orbit_file.hpp"

namespace signorini {

/// The command line of `signorini verify`.
struct VerifyArguments {
  std::optional<std::string> folder;  ///< of references or of a run, or a pack
  std::optional<std::string> scenes;  ///< filter of scenes
  std::string cases = "*";            ///< filter of the cases of a run
  OrbitSearchOptions options;         ///< of the search that --update makes
  std::optional<int> subharmonics;    ///< that the search covers; empty: as the scene suggests
  bool update = false;                ///< keep what is found instead of comparing
};

/// Searches the orbits of the scenes again and prints what differs from the files of the folder, or with
/// `update` writes these. \return the exit code of the command
int verify_references(const VerifyArguments& arguments, const std::filesystem::path& folder);

/// \throws UsageError: the folder holds neither references nor records
[[noreturn]] void refuse_folder(const std::filesystem::path& folder);

}  // namespace signorini
