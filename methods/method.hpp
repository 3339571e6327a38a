#pragma once
// The plugin interface. A method turns a Problem into a Solution; it never scores itself.

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "methods/deadline.hpp"
#include "methods/options.hpp"
#include "methods/solution.hpp"
#include "problems/problem.hpp"

namespace signorini {

/// What a method class says of itself, by a member `static constexpr MethodText kText`: the first four at
/// least.
struct MethodText {
  std::string_view name;         ///< lower-kebab-case
  std::string_view title;        ///< one line for people
  std::string_view laws = {};    ///< laws it can represent, for `list`
  std::string_view ladder = {};  ///< resolutions a benchmark runs, "key=v1|v2|v3"
  std::string_view limits = {};  ///< what it cannot do, in sentences for people; empty: nothing is said
  /// Settings, "key=v1|v2", from which cold starts lead to orbits that no step of the ladder leads to: tried
  /// in searches for all orbits of a scene only; empty: none
  std::string_view starts = {};
  /// p of error of x ~ h^p, h the step that the ladder refines, on motions with impacts; empty: none is
  /// claimed [-]
  std::optional<double> order = {};
  bool exact = false;  ///< its motions are exact orbits, and curves of others are judged by its own
  std::span<const FormerOption> former = {};  ///< options that it no longer has
};

/// The impact law is not determined by the method's equations (see docs/theory.md).
struct Undetermined {
  /// True.
  bool operator==(const Undetermined&) const = default;
};

/// The law a method represents on a scene. std::monostate: no contact.
using RepresentedLaw = std::variant<std::monostate, Restitution, Penalty, Massless, Undetermined, MixedLaws>;

/// Whether a method applies to a scene; if not, `reason` is printed in the table's cell.
struct Support {
  bool ok = true;           ///< it applies
  std::string reason = {};  ///< empty exactly if so
};

/// Where a solve begins and when it must give up.
struct Start {
  std::shared_ptr<const Trajectory> guess = {};  ///< null: cold start
  /// The end of the time budget.
  Deadline deadline = {};

  /// True once the time budget is spent; methods ask between iterations and end `not_converged`.
  [[nodiscard]] bool expired() const { return deadline.passed(); }
};

/// Times that a prepared method tells itself, apart from what it costs to reach it.
struct OwnTimes {
  std::optional<double> last = {};            ///< of the last solve; empty: the harness measures it [s]
  std::optional<double> least_exchange = {};  ///< least time that passed in a solve beside its own [s]
};

/// A method prepared for one scene: everything that a user pays once per scene is done.
class PreparedMethod {
 public:
  virtual ~PreparedMethod() = default;
  /// One solve. Deterministic; repeatable. Numerical failure is a Solution, never an exception.
  virtual Solution solve(const Start& start) = 0;
  /// Takes the scene at another frequency of the load in place of the one it was prepared for, where what is
  /// set up serves that one too. Where it is costly, a response over the frequency pays for it once.
  /// \param problem  that scene, different in `frequency` alone; must outlive this
  /// \return whether the next solve answers it; if not, nothing has changed
  virtual bool take_frequency([[maybe_unused]] const Problem& problem) { return false; }
  /// Of its solves so far; empty where it has no clock of its own.
  [[nodiscard]] virtual OwnTimes own_times() const { return {}; }
};

class CurveMethod;

/// Immutable after construction, hence safe to share between threads.
class Method {
 public:
  virtual ~Method() = default;
  /// Complete options, defaults included.
  [[nodiscard]] virtual std::vector<OptionEcho> options() const = 0;
  /// Whether it applies to this valid scene. Quick: asked of every scene of a run.
  [[nodiscard]] virtual Support supports(const Problem& problem) const = 0;
  /// The law represented on this scene; meaningful where `supports` says ok.
  [[nodiscard]] virtual RepresentedLaw law(const Problem& problem) const = 0;
  /// Set-up for one valid, supported scene, which must outlive the result.
  /// \throws std::runtime_error if the structure cannot be factorised
  [[nodiscard]] virtual std::unique_ptr<PreparedMethod> prepare(const Problem& problem) const = 0;
  /// The method as one that follows curves of its solutions (curve.hpp), while this lives; null: it follows
  /// none.
  [[nodiscard]] virtual const CurveMethod* curve() const { return nullptr; }
};

/// The law represented at one contact; Massless where none is determined.
ContactLaw law_of_contact(const RepresentedLaw& law, int contact);
/// e of a restitution; 1 of other laws, which lose nothing [-].
double restitution_of(const ContactLaw& law);

/// The scene's own law as one that is represented.
RepresentedLaw as_represented(const Law& law);
/// The scene's own laws, but with this e at all contacts that have a restitution [-].
RepresentedLaw with_restitution(const Problem& problem, double e);
/// For methods that know one law only: whether the contacts have one; if not, two that differ are named.
Support supports_one_law(const Problem& problem);
/// True if the represented law is the scene's own.
bool law_matches(const RepresentedLaw& represented, const Law& scene);

}  // namespace signorini
