#pragma once
// A method that is an executable, described by a TOML file: it reads a problem as JSON and prints its answer
// as JSON. docs/plugins.md has every key.

#include <filesystem>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "harness/extend/plugins/curve_exchange.hpp"
#include "harness/plan/deadline.hpp"
#include "methods/catalogue.hpp"

namespace signorini {

/// An option as the description declares it, with its default or another value of the same type.
struct CommandOption {
  std::string name = {};
  OptionValue value = {};  ///< bool, long, double or string
  std::string unit = {};
  std::string meaning = {};
  std::optional<double> least = {}, most = {};  ///< of numbers
  std::vector<std::string> choices = {};        ///< of words; empty: any
};

/// Laws that the answers obey, by the scene's own; where there is none the scene is not supported.
struct RepresentedLaws {
  /// On massive contacts: a number, the scene's restitution, or none determined.
  struct SceneRestitution {};
  using OfRestitution = std::variant<std::monostate, SceneRestitution, Restitution, Undetermined>;
  OfRestitution restitution = {};
  bool penalty = false;
  bool massless = false;
  bool mixed = false;  ///< each contact has its own of these
  bool no_contact = false;

  /// Empty where the law is not supported.
  [[nodiscard]] std::optional<RepresentedLaw> on(const Law& scene) const;
  /// "restitution 1, penalty", for `list`.
  [[nodiscard]] std::string text() const;
};

/// What a description says.
struct CommandDescription {
  std::string name = {};
  std::string title = {};
  std::string ladder = {};
  std::vector<std::string> words =
      {};  ///< program and arguments, files of the description's folder by their paths
  std::vector<CommandOption> options = {};
  RepresentedLaws represents = {};
  std::optional<int> most_coordinates = {}, most_contacts = {};
  bool persistent = false;  ///< one process for all solves of a prepared scene, a line each
  bool curves = false;      ///< the command answers requests for curves too
  /// In place of a command: branches that were followed already.
  std::shared_ptr<const std::vector<ExchangedBranch>> branches = {};
  std::string sha256 = {};  ///< of the description and the files that its command names
};

/// \throws SceneError, `FILE:LINE: key = value (what is required)`; UsageError for a file that cannot be read
CommandDescription read_command_file(const std::filesystem::path& file);

/// Problem and options, all that is known before a solve.
nlohmann::ordered_json command_request(const Problem& problem, const std::vector<OptionEcho>& options);

/// The request of the same scene at another frequency of its load.
void take_frequency(nlohmann::ordered_json& request, const Problem& problem);

/// The text for stdin: the request, with the motion to start from and the seconds until the deadline, one
/// line.
std::string command_input(nlohmann::ordered_json request, const Start& start);

struct CommandAnswer {
  Solution solution = {};
  std::optional<double> seconds = {};  ///< that the command says it took
};

/// The answer printed. \param period  of the motion looked for, where the answer names none [s]
/// \throws SolveFailure (Status::invalid_output) for what is no answer; whether sizes and period fit the
/// scene
///         is judged later, as for every method
CommandAnswer read_command_answer(const std::string& output, double period);

/// The curve printed. \throws SolveFailure (Status::invalid_output) for what is no curve of so many contacts
BranchDiagram read_command_curve(const std::string& output, const ParametrisedScene& scene, int contacts,
                                 const CurveLimits& limits);

/// How a command ended.
struct CommandEnd {
  std::string output = {};   ///< what it printed on stdout
  bool expired = false;      ///< it was killed at the deadline
  bool unasked = false;      ///< it stays, and printed more than the line it was asked for; it was killed
  std::string failure = {};  ///< "the command ended with exit code 3"; empty for exit code 0
  std::optional<int> signal = {};  ///< that ended it
  std::string last_words = {};     ///< last line on its stderr
};

/// Runs `words`, a program and its arguments, with `input` on stdin. At the end or at the deadline its
/// process group is killed, with all that the command has started in it. Libraries for linear algebra are
/// told to use one thread, as all methods do. The command dies with the calling process. \throws
/// MachineFull if no process can be made
CommandEnd run_command(const std::vector<std::string>& words, std::string_view input, Deadline deadline);

/// A command that stays: it is started when it is first asked, and answers each line with a line. Its process
/// ends, as that of `run_command` does, with this object.
class CommandSession {
 public:
  explicit CommandSession(std::vector<std::string> words);
  ~CommandSession();
  CommandSession(const CommandSession&) = delete;
  CommandSession& operator=(const CommandSession&) = delete;

  /// Hands over `line`, which ends with a line break. What the command prints until its next line break is
  /// the output; empty lines are passed over. Where it ends before, is killed at the deadline, or has printed
  /// more than that, now or since its last answer, the result says so, and the next call starts it anew. That
  /// it has ended after an answer is a failure of the next call.
  CommandEnd ask(std::string_view line, Deadline deadline);

 private:
  std::vector<std::string> words_;
  std::unique_ptr<class RunningCommand> running_;
};

/// The catalogue entry of a description. \throws SceneError, UsageError
MethodEntry load_command_method(const std::filesystem::path& file);

}  // namespace signorini
