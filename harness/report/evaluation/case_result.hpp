#pragma once
// The result of a case as reports compare it with others: of its record the few figures that rankings, counts
// and means go by, some 300 bytes, so that runs of millions of cases are evaluated in memory.

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "harness/records/record.hpp"

namespace signorini {

/// A method with its options: what the records of one step of a ladder have in common on all scenes.
struct CaseChoice {
  std::string method = {};
  Settings settings = {};
  RecordedOptions options = {};
  std::string same_equations_as = {};
  std::string resolution = {};     ///< resolution_of the record
  std::string configuration = {};  ///< configuration_of the record
  bool from_plugin = false;        ///< the method is none of this program's own

  /// Whether it is a method as the literature has it, `plain=true`.
  [[nodiscard]] bool is_plain() const;
};

/// What the records of a scene have in common, and what a record says of it.
struct CaseScene {
  std::string name = {};
  std::optional<FamilyLevel> family = {};
  std::optional<SceneInstance> instance = {};
  std::optional<RepresentedLaw> law = {};              ///< Record::scene_law
  std::optional<int> coordinates = {}, contacts = {};  ///< absent in records of earlier versions
};

/// Whether the value of a setting is a number.
bool is_numeric(const std::string& value);

/// Whether a setting is a step of a ladder: a number that refines, or coarsens, what is solved. The constant
/// `c` of a contact law makes other equations of them, as a penalty does, and kStartSetting another start.
bool is_resolution(const OptionSetting& setting);

/// "event-driven[flow=cvode]": the method with those of its settings that are no resolution, so that
/// "fourier-lipschitz[c=1e5]" has a row of its own.
std::string configuration_of(const Record& record);

/// What a record says of its scene.
CaseScene case_scene_of(const Record& record);

/// What became of a case, as counts go by it.
struct CaseOutcome {
  Status status = Status::not_converged;
  CertificateStatus certificate = CertificateStatus::none;
  std::optional<bool> law_matches_scene = {};
  std::optional<bool> same_orbit = {};  ///< Certificate::same_orbit
  std::optional<bool> stable = {};      ///< Certificate::stable: empty where that is not determined
  bool contact_free = false;            ///< certified, and nothing touches: no event, and no contact pushes
  bool response = false;                ///< it is a whole response, which has no certificate
};

/// Whether the certified orbit of an answer touches nothing, as the record tells by the orbit's events and
/// the share of the period during which contacts push.
bool is_contact_free(const Record& record);

/// The outcome of a record.
CaseOutcome outcome_of(const Record& record);

/// The result of a case. Pointers are into the CaseResults that hold it.
struct CaseResult {
  std::string case_id = {};
  const CaseChoice* choice = nullptr;
  const CaseScene* scene = nullptr;
  CaseOutcome outcome = {};
  const RepresentedLaw* law = nullptr;  ///< that the method represents; null where it is not known
  Measure error = {};                   ///< relative L2 error of x, of u where the scene has no contact
  Measure level = {};                   ///< level_error
  Measure impulse_error = {};           ///< Errors::impulse
  double measurable = 0.0;              ///< measurable_error
  Measure condition = {};
  Measure seconds = {};                  ///< median of set-up plus solve [s]
  Measure exchange = {};                 ///< Seconds::exchange [s]
  bool together = false;                 ///< other cases ran at the same time
  bool unsteady = false;                 ///< Seconds::unsteady
  bool keeps_motion = false;             ///< with its certified orbit
  Work work = {};                        ///< counts
  std::optional<Repeats> repeats = {};   ///< solves after the first
  const std::string* orbit = nullptr;    ///< fingerprint of the certified orbit; null where there is none
  const std::string* problem = nullptr;  ///< Record::problem; null where it is not known
  const std::string* answer = nullptr;   ///< Record::answer; null where there is none
  std::size_t source = 0;                ///< where the whole record is had: its number among those added
};

/// Results and what they share. A result stays valid as long as these do, wherever they are moved.
class CaseResults {
 public:
  /// Adds the result of a record.
  void add(const Record& record);
  /// Keeps of all that were added those alone whose numbers these are, in this order.
  void keep(const std::vector<std::size_t>& sources);

  std::vector<CaseResult> all = {};
  std::vector<Record> responses = {};  ///< records of frequency responses, whole: no figures stand for them

 private:
  const std::string* name_of(const std::string& text) { return &*names_.insert(text).first; }

  // By all that they hold; nodes stay where they are.
  std::unordered_map<std::string, CaseChoice> choices_;
  std::unordered_map<std::string, CaseScene> scenes_;
  std::unordered_map<std::string, RepresentedLaw> laws_;
  std::unordered_set<std::string> names_;
  std::vector<std::size_t> response_sources_;  // numbers of `responses`
  std::size_t count_ = 0;
};

/// claim_of the record.
std::optional<Claim> claim_of(const CaseOutcome& outcome);

/// Whether the case states another problem than its scene: the method represents another law.
bool has_another_law(const CaseOutcome& outcome);

/// Whether the case is solved: certified, under the law of the scene.
bool is_solved(const CaseOutcome& outcome);

/// For each result, whether it states a problem (Record::problem) that the same method with the same settings
/// is given in another one too, which counts for both: one under its scene's law before others, else the
/// first. False of results that do not know their problem.
std::vector<bool> repeated_problems(const std::vector<CaseResult>& results);

/// The error of x, of u where the scene has no contact, but not below ten error bars of the orbit. Whether
/// its orbit certifies the answer is not asked.
Measure bounded_error(const CaseResult& result);

/// bounded_error of a certified answer; empty for all others.
Measure certified_error(const CaseResult& result);

/// The error that levels of accuracy ask of a certified answer (level_error), bounded alike; empty for all
/// others.
Measure certified_level(const CaseResult& result);

/// How many cases ended how.
struct OutcomeCounts {
  int cases = 0, not_applicable = 0, failed = 0, refuted = 0, unproven = 0, certified = 0;
  int same_orbit = 0, other_orbit = 0;  ///< certified, and the orbit reached from rest or another one
  int stable = 0, unstable = 0;         ///< certified, of these orbits; of the rest it is not determined
  int another_law = 0;                  ///< applicable cases of another law than the scene's
  int solved = 0;                       ///< certified cases of the scene's law
  int followed = 0;                     ///< responses with a branch, of which nothing is claimed

  void add(const CaseOutcome& outcome);
  [[nodiscard]] int applicable() const { return cases - not_applicable; }
  /// Applicable cases of the scene's law.
  [[nodiscard]] int own_law() const { return applicable() - another_law; }
  /// Certified cases of another law.
  [[nodiscard]] int solved_under_another_law() const { return certified - solved; }
  /// Claims that are not refuted.
  [[nodiscard]] int converged() const { return certified + unproven; }
  [[nodiscard]] int claims() const { return converged() + refuted; }
};

/// Those of some cases.
OutcomeCounts counts_of(std::span<const CaseResult> results);

}  // namespace signorini
