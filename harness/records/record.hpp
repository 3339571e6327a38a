#pragma once
// One run of one method on one scene, as it is kept: docs/records.md gives every key.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "harness/plan/case_name.hpp"
#include "harness/records/motion_summary.hpp"
#include "harness/records/recorded_response.hpp"
#include "methods/method.hpp"
#include "methods/options.hpp"
#include "problems/scene/scene_family.hpp"

namespace signorini {

enum class Status {
  converged,
  inaccurate,
  not_converged,
  not_applicable,
  timeout,
  out_of_memory,
  crashed,
  exception,
  invalid_output
};

/// The names in record files.
template <>
struct EnumNames<Status> {
  /// In order.
  static constexpr std::array<std::string_view, 9> values{"converged",      "inaccurate", "not-converged",
                                                          "not-applicable", "timeout",    "out-of-memory",
                                                          "crashed",        "exception",  "invalid-output"};
};

/// "not-converged" and so on; the words of records.
std::string_view status_name(Status status);

/// A measure that may have no meaning for a run; never NaN.
using Measure = std::optional<double>;

struct WorkDone {
  Work counts = {};
  std::optional<long> peak_memory_bytes = {};  ///< growth of the peak resident set by set-up and first solve
};

/// Least time of one call in one round [s].
struct TimedRound {
  double setup = 0.0;
  double solve = 0.0;
  /// Of the first set-up and solve of the round's process; empty where there is no such call.
  std::optional<double> first = {};
};

/// Times of set-up plus solve over rounds, the least of each [s].
struct Seconds {
  double median = 0.0;
  double min = 0.0;
  double mad = 0.0;  ///< median absolute deviation from the median
  int repetitions = 0;
  double setup = 0.0;                   ///< median of the set-up's part
  double solve = 0.0;                   ///< median of the solve's part
  std::optional<double> first = {};     ///< of a process, set-up plus solve: the median of the rounds
  std::optional<bool> unstable = {};    ///< mad above kUnstable of the median; empty for a single round
  std::vector<TimedRound> rounds = {};  ///< in the order taken
  std::optional<double> exchange = {};  ///< beside a solve that tells its own time, the least [s]
  std::optional<int> jobs = {};         ///< cases run at the same time, if several: not comparable then
  std::optional<bool> unsteady = {};    ///< rounds still differ after the last one allowed (rounds_missing)
  Measure load = {};                    ///< of other programs, by load_share, the most of all rounds [-]
};

/// Times whose deviation exceeds this share of their median are called unstable.
inline constexpr double kUnstable = 0.05;

enum class CertificateStatus { none, uncertified, certified };

/// The names in record files.
template <>
struct EnumNames<CertificateStatus> {
  /// In order.
  static constexpr std::array<std::string_view, 3> values{"none", "uncertified", "certified"};
};

/// The words of records and exchanges.
template <>
struct EnumNames<ContactEvent::Kind> {
  /// In order.
  static constexpr std::array<std::string_view, 3> values{"impact", "close", "open"};
};

struct OrbitEvent {
  double time = 0.0;  ///< [s]
  int contact = 0;
  ContactEvent::Kind kind = ContactEvent::Kind::impact;
  Measure value = {};  ///< impulse of an impact [N s]
};

/// Real and imaginary parts.
using FloquetMultipliers = std::vector<std::pair<double, double>>;

/// An order in which impacts of one instant that feel each other may follow each other, and the largest
/// multiplier, in magnitude, of the part of the period map that belongs to it.
struct OrderOfImpacts {
  std::vector<std::vector<int>> contacts = {};  ///< of each such instant, in their order
  double largest = 0.0;
};

/// The rules of certificates: those of records without this number accepted the motion reached from rest as
/// the orbit of an answer within 0.5 of it; 2 asked for no contact force, nor for the worst contact, and
/// refuted by what both searches found.
inline constexpr int kCertificateRule = 3;

/// Whether a true orbit of the represented law stands behind an answer, and which.
struct Certificate {
  CertificateStatus status = CertificateStatus::none;
  std::optional<int> rule = {};           ///< by which an answer was judged: kCertificateRule of that time
  std::string reason = {};                ///< of uncertified or none; empty when certified
  std::string refutation = {};            ///< why the answer is wrong, where its orbit shows that
  std::optional<bool> expired = {};       ///< of an answer that is not certified: the time to do so was up
  std::string source = {};                ///< how the orbit was found
  std::optional<std::string> orbit = {};  ///< fingerprint, equal for equal orbits
  std::optional<int> order = {};          ///< period of the orbit in forcing periods
  Measure error_bar = {};                 ///< relative, of the orbit itself
  Measure residual = {};                  ///< relative, of the orbit's own equations
  Measure distance = {};                  ///< x_l2 from the answer to the orbit found, certified or not
  std::optional<std::string> reference =
      {};                               ///< fingerprint of the orbit reached from rest under the same law
  std::string reference_reason = {};    ///< why there is none
  std::optional<bool> same_orbit = {};  ///< the answer's orbit is that one
  std::vector<OrbitEvent> events = {};
  Measure return_distance = {};  ///< of the orbit after one period by CVODE, in the scales of the motion
  std::optional<FloquetMultipliers> floquet = {};
  std::optional<bool> stable = {};
  std::string stability = {};  ///< stability_word, for readers; empty in records of earlier versions
  std::string undefined = {};  ///< why an exact orbit has no multipliers
  std::vector<OrderOfImpacts> orders = {};  ///< of an orbit whose multipliers depend on them
};

/// Against the certified orbit, or one that is near, relative.
struct Errors {
  Measure x_l2 = {}, x_max = {}, u_l2 = {}, velocity_l2 = {}, impulse = {}, force_l2 = {};
  Measure x_worst = {};  ///< of x, as x_l2, at the contact whose own motion is missed most
  Measure force = {};    ///< of the contact force with its impulses, their instants included: see force_error
  Measure x_l2_scene = {};  ///< against the scene's own reference where the represented law is another
};

struct Physics {
  Measure penetration = {}, complementarity = {}, energy_defect = {}, contact_ratio = {};
  std::string energy_reason = {};                  ///< why there is no energy_defect
  std::vector<double> effective_restitution = {};  ///< of each impact, in time order
};

struct TrajectorySamples {
  std::vector<double> t = {};
  std::vector<std::vector<double>> x = {}, velocity = {}, force = {};  ///< per contact
  std::vector<Impulse> impulses = {};
  std::optional<int> bandwidth = {};
  std::optional<std::vector<ContactEvent>> events = {};  ///< as the method lists them
  std::vector<int> dofs = {};                            ///< coordinates that were asked for
  std::vector<std::vector<double>> u = {};               ///< of each of them
};

/// A motion as it is drawn: polylines through common instants, as dense as the motion's bends ask for.
struct Waveform {
  std::vector<double> t = {};  ///< [s]
  /// Per contact kept [m] [m/s] [N] [N s]; `impulse` is that given since t = 0, impulses of impacts included.
  std::vector<std::vector<double>> x = {}, velocity = {}, force = {}, impulse = {};
};

/// An answer and the certified orbit behind it, over a period common to both.
struct Waveforms {
  std::vector<int> contacts = {};  ///< those kept, by index in the scene
  Waveform answer = {};
  std::optional<Waveform> orbit = {};  ///< absent unless certified
};

/// Solves of one case after the first, in the same process and in others, and whether they gave the same
/// bits.
struct Repeats {
  int solves = 0;
  int identical = 0;
};

/// Processor time of the first round's process in each stage of a case, absent where it was not reached [s].
/// What a command method spends in its own processes is not among them.
struct StageSeconds {
  Measure solve = {};  ///< set-up and first solve
  Measure timing = {}, measures = {}, certificate = {};
};

/// Complete options of a method: name and value.
using RecordedOptions = std::vector<std::pair<std::string, OptionValue>>;

struct Record {
  std::string case_id = {};  ///< "scene/method[settings]", the name for people
  std::string key = {};      ///< identifies the run for --resume
  std::string scene = {}, scene_sha256 = {}, method = {};
  std::string plugin = {};                     ///< MethodEntry::plugin
  std::string run = {};                        ///< of several runs side by side, whose it is
  std::optional<FamilyLevel> family = {};      ///< of a scene that is one of a family
  std::optional<SceneInstance> instance = {};  ///< of a scene whose numbers are drawn
  Settings settings = {};                      ///< options as asked for; the rest of `options` are defaults
  RecordedOptions options = {};
  std::string same_equations_as = {};  ///< a method that solves the same equations where options are equal
  Status status = Status::not_converged;
  std::string message = {};
  std::optional<int> signal = {};  ///< that ended a crashed run
  std::optional<RepresentedLaw> law = {}, scene_law = {};
  std::optional<bool> law_matches_scene = {};
  std::optional<int> coordinates = {}, contacts = {};  ///< of the scene
  std::string problem = {};  ///< digest of the problem as the method represents it (problem_digest)
  Measure period = {}, residual = {}, condition = {};
  std::optional<MotionSummary> motion = {};  ///< of a solve that was asked for it
  WorkDone work = {};
  std::optional<Seconds> seconds = {};
  std::string not_timed = {};  ///< why `seconds` is absent
  std::string answer = {};     ///< digest of the first answer (answer_digest)
  std::optional<Repeats> repeats = {};
  Measure elapsed = {};  ///< wall time of all processes of the case [s]
  StageSeconds processor = {};
  Certificate certificate = {};
  Errors errors = {};
  Physics physics = {};
  std::optional<TrajectorySamples> trajectory = {};
  std::optional<Waveforms> waveforms = {};
  std::optional<RecordedResponse> response = {};  ///< of a case that asks for one in place of a motion
};

/// A method with settings, and in brackets the run that it is of where several stand side by side:
/// "aft-hbm[harmonics=40] (mine)".
std::string label_of(const Record& record, const Settings& settings);

/// The case without its scene: "fourier-lipschitz[harmonics=40]".
std::string resolution_of(const Record& record);

/// "stable", "unstable", "undefined", or empty where the multipliers of an exact orbit do not tell or there
/// is none. \param undefined  why it has none
std::string stability_word(std::optional<bool> stable, const std::string& undefined);
/// The same with the reason: "undefined: depends on the order of simultaneous impacts"
std::string stability_words(std::optional<bool> stable, const std::string& undefined);

/// "e = 0.8", "k = 1e+06 N/m", "massless", "undetermined", "no contact".
std::string law_text(const RepresentedLaw& law);

/// What stands beside the name of a method that represents another law than the scene's: "e = 1". Empty where
/// it is the same, or not known.
std::string law_remark(const Record& record);

/// Counts one more solve of the case, whose answer has this digest.
void count_repeat(const std::string& answer, Record& record);

/// What has become of a method's claim that it converged.
enum class Claim {
  certified,  ///< the answer's own orbit is known
  unproven,   ///< no orbit certifies it, and none refutes it
  refuted     ///< the harness found it wrong: status `inaccurate`
};

/// Nothing where the method claims nothing.
std::optional<Claim> claim_of(Status status, CertificateStatus certificate);
std::optional<Claim> claim_of(const Record& record);

/// The error that a level of accuracy asks for, "solved to 1e-3": the largest of that of x (of u where the
/// scene has no contact), of the contact whose own motion is missed most, and of the contact force: of a
/// spring `force_l2`, else `force`. The latter two where a record has them: those of earlier versions have
/// none. Empty without an error of x or u.
Measure level_error(const Record& record);

/// An error below this is not measured but bounded: ten error bars of the certified orbit, and how far away
/// an orbit is to which CVODE, which shares nothing with the methods, would return: the distance it returned
/// to after a period over the distance of the Floquet multipliers from 1, where that is less than 1.
double measurable_error(const Record& record);

}  // namespace signorini
