#pragma once
// A file of branches that any program has followed, as a method: it has curves, and no solves.

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "harness/extend/plugins/curve_exchange.hpp"
#include "methods/method.hpp"

namespace signorini {

/// The branches of a file, one per line; empty lines are passed over. \throws SceneError, `FILE:LINE: what`;
/// UsageError for a file that cannot be read
std::vector<ExchangedBranch> read_branches(const std::filesystem::path& file);

/// A method that follows, over the frequency of the load, the scenes whose names stand with the branches.
/// \param represents  the law that the branches obey, by the scene's own; empty where there is none
std::unique_ptr<Method> method_of_branches(
    std::shared_ptr<const std::vector<ExchangedBranch>> branches,
    std::function<std::optional<RepresentedLaw>(const Law&)> represents);

}  // namespace signorini
