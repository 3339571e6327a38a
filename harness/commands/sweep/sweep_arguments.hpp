#pragma once
// The options of `signorini sweep`.

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "harness/arguments/arguments.hpp"
#include "harness/plan/plan.hpp"
#include "harness/report/figures/column.hpp"
#include "harness/sweep/attractors.hpp"
#include "harness/sweep/bifurcation_response.hpp"
#include "harness/sweep/branch_response.hpp"
#include "harness/sweep/response_folder.hpp"

namespace signorini {

/// What `sweep` is asked.
struct SweepArguments {
  std::string scene, method, methods;
  std::vector<std::string> settings;
  SweepRange range;
  SweepLimits limits;
  CurveLimits branches;
  std::optional<int> max_order = {};  ///< of the branches; default_orders if not given
  double total_time = 60.0;           ///< of all branches of a method [s]
  int searches = 0;                   ///< values of the parameter at which all orbits are searched
  std::string parameter{kFrequency};
  std::optional<double> from, to;
  bool hertz = false;  ///< from, to and range.at are in Hz
  bool natural = false;
  std::string follow;
  SecondParameter second;
  bool backbone = false;
  std::string format = "text";
  std::string plot;
  Column column = Column::own;
  bool bifurcation = false;
  AttractorOptions attractors{.starts = 0};  ///< no starts: not asked for
  std::optional<std::string> out;
  bool resume = false;
  std::vector<std::string> words;  ///< the command line
};

/// Adds the options to the command; `arguments` outlives it.
void add_sweep_options(const Command& command, SweepArguments& arguments);

/// The range in rad/s, or in the unit of --parameter, with its ends: those given, or the least and the
/// largest of the values asked for. \throws UsageError where an end is missing, or a value is not between
/// them
SweepRange interval(const SweepArguments& arguments);

/// The scene with the number asked for left free. \throws UsageError
ParametrisedScene parametrised(const SweepArguments& arguments, const Scene& scene);

/// Free motions have an interval of their own, and one method follows them: both are set where the command
/// line leaves them open.
void complete_free_motions(SweepArguments& arguments);

/// `--backbone` stands for phase resonances over the load factor, from where the load is small; method,
/// interval and second number are set where the command line leaves them open. \throws UsageError, SceneError
void complete_backbone(SweepArguments& arguments);

/// The values of the parameter at which motions are followed: those asked for, else equally spaced, of a
/// frequency as sweep_frequencies has them. \throws UsageError
std::vector<double> attractor_values(const SweepArguments& arguments);

/// Every row, in the format of tables that is asked for.
std::string table_text(const SweepArguments& arguments, const Table& table);

/// The folder of --out, if there is one, with the question that it answers. \throws UsageError
std::optional<ResponseFolder> folder_of(const SweepArguments& arguments,
                                        const nlohmann::ordered_json& question);

using UseResponse = std::function<void(MethodResponse& response)>;

/// The response of a method as the folder has kept it, which is handed to `replay`; or else what `follow`
/// makes of a blank one, which is marked as complete unless it is interrupted or fails.
MethodResponse kept_or_followed(std::optional<ResponseFolder>& folder, const MethodChoice& method,
                                MethodResponse blank, const UseResponse& follow, const UseResponse& replay);

/// The picture that --plot asks for, if it does. \param attractors  drawn over the branches
void draw(const SweepArguments& arguments, const std::vector<MethodResponse>& responses,
          const std::string& scene, const std::vector<AttractorsAt>& attractors = {});

/// `sweep --follow`: special points over the frequency and a second number. \return the exit code \throws
/// UsageError
int sweep_special_points(const SweepArguments& arguments);

/// All that the answers depend on but methods and code: an object, its keys the names of the options.
nlohmann::ordered_json question_of(const SweepArguments& arguments, const Scene& scene);

}  // namespace signorini
