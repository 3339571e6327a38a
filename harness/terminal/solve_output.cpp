#include "harness/terminal/solve_output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>
#include <vector>

#include "harness/report/document/cells.hpp"
#include "harness/report/document/lines.hpp"
#include "harness/text/columns.hpp"
#include "harness/text/words.hpp"

namespace signorini {

namespace {

constexpr std::size_t kNameWidth = 22;
/// Rows of each part that one screen has room for.
constexpr std::size_t kMostShownRows = 4;

std::string named_line(const std::string& name, const std::string& text) {
  return fmt::format("{:<{}}{}\n", name, kNameWidth, text);
}

/// The same with a text that may be too long for one line.
std::string named_text(const std::string& name, const std::string& text) {
  return named_lines(name, kNameWidth, text, kTerminalWidth);
}

std::string titles(const std::string& name, const std::vector<std::string>& words) {
  std::string line;
  for (const std::string& word : words) line += fmt::format("{:>14}", word);
  return named_line(name, line);
}

std::string row(const std::string& name, const std::vector<Measure>& values) {
  std::vector<std::string> words;
  for (const Measure& value : values) words.push_back(value ? fmt::format("{:.6g}", *value) : "-");
  return titles(name, words);
}

std::string contact_name(int contact) { return fmt::format("  contact {}", contact); }

/// The rows of a part, as many as there is room for.
template <class Items, class Print>
std::string rows_of(const Items& items, bool all, const Print& print) {
  std::string text;
  const std::size_t shown = all || items.size() <= kMostShownRows ? items.size() : kMostShownRows - 1;
  for (std::size_t i = 0; i < shown; ++i) text += print(items[i]);
  if (shown < items.size()) text += fmt::format("  and {} more (--verbose)\n", items.size() - shown);
  return text;
}

/// Contacts by the impulse that they exchange per period, the largest first.
std::vector<int> contacts_by_impulse(const MotionSummary& motion) {
  std::vector<double> impulse(motion.x.size(), 0.0);
  for (const ImpactSummary& one : motion.impacts)
    impulse[static_cast<std::size_t>(one.contact)] += one.impulse;
  for (const PhaseSummary& one : motion.contact_phases)
    impulse[static_cast<std::size_t>(one.contact)] += one.impulse;
  std::vector<int> order(motion.x.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {}, [&](int c) { return impulse[static_cast<std::size_t>(c)]; });
  return order;
}

/// Nothing where a value is round-off of a displacement.
double without_noise(double value, const DisplacementSummary& of) {
  constexpr double kNoise = 1e-12;  // relative to the largest |x|
  return std::abs(value) < kNoise * std::max(std::abs(of.min), std::abs(of.max)) ? 0.0 : value;
}

std::string displacement_row(const std::string& name, const DisplacementSummary& one) {
  return row(name, {one.amplitude, one.min, one.max, without_noise(one.mean, one)});
}

std::string displacements(const MotionSummary& motion, const std::vector<int>& contacts, bool all) {
  std::string text = titles("displacement", {"amplitude [m]", "min [m]", "max [m]", "mean [m]"});
  text += rows_of(contacts, all, [&](int c) {
    return displacement_row(contact_name(c), motion.x[static_cast<std::size_t>(c)]);
  });
  for (const DisplacementSummary& one : motion.u)
    text += displacement_row(fmt::format("  u[{}]", one.dof.value_or(0)), one);
  return motion.no_u.empty() ? text : text + named_text("  u", "none: " + motion.no_u);
}

std::string impacts(const MotionSummary& motion, bool all) {
  if (motion.impacts.empty()) return named_line("impacts", "none");
  return titles("impacts", {"t [s]", "before [m/s]", "after [m/s]", "impulse [N s]"}) +
         rows_of(motion.impacts, all, [](const ImpactSummary& one) {
           return row(contact_name(one.contact), {one.time, one.speed_before, one.speed_after, one.impulse});
         });
}

std::string phases(const MotionSummary& motion, double period, bool all) {
  if (motion.contact_phases.empty()) return named_line("contact phases", "none");
  return titles("contact phases", {"from t [s]", "to t [s]", "% of period", "impulse [N s]"}) +
         rows_of(motion.contact_phases, all, [&](const PhaseSummary& one) {
           const double share = 100.0 * (one.end - one.begin) / period;
           return row(contact_name(one.contact), {one.begin, one.end, share, one.impulse});
         });
}

/// A harmonic that is round-off has no phase.
std::string harmonics(const std::string& name, const DisplacementSummary& one) {
  std::string text;
  for (const Harmonic& harmonic : one.harmonics) {
    const double amplitude = without_noise(harmonic.amplitude, one);
    const Measure phase = amplitude > 0.0 ? Measure(harmonic.phase * 180.0 / std::numbers::pi) : Measure();
    text += row(text.empty() ? name : "", {harmonic.frequency, amplitude, phase});
  }
  return text;
}

std::string all_harmonics(const MotionSummary& motion, const std::vector<int>& contacts, bool all) {
  std::string text;
  for (const int c : contacts) {
    text += harmonics(contact_name(c), motion.x[static_cast<std::size_t>(c)]);
    if (!all) break;
  }
  for (const DisplacementSummary& one : motion.u)
    text += harmonics(fmt::format("  u[{}]", one.dof.value_or(0)), one);
  return text.empty() ? text : titles("harmonics", {"rad/s", "amplitude [m]", "phase [deg]"}) + text;
}

/// "9b682b81, which is also reached from rest".
std::string certificate_words(const Certificate& certificate) {
  if (certificate.status != CertificateStatus::certified) {
    const bool more = certificate.expired.value_or(false) && certificate.refutation.empty();
    return (certificate.reason.empty() ? "no reason given" : certificate.reason) +
           (more ? "; --certificate gives it more time" : "");
  }
  const std::string orbit = certificate.orbit.value_or("unnamed");
  if (certificate.same_orbit)
    return orbit + (*certificate.same_orbit ? ", which is also reached from rest"
                                            : ", another than the one reached from rest");
  return fmt::format("{} (from rest: {})", orbit,
                     certificate.reference_reason.empty() ? "not computed" : certificate.reference_reason);
}

/// "stable, largest Floquet multiplier 0.6935 (modulus)", or why neither is known.
std::string stability_line(const Record& record) {
  const Certificate& certificate = record.certificate;
  const bool certified = certificate.status == CertificateStatus::certified;
  std::string text = certified ? stability_words(certificate.stable, certificate.undefined) : "";
  if (text.empty()) {
    const std::string reason = certified ? "the multipliers do not tell" : certificate.reason;
    text = "not determined" + (reason.empty() ? "" : ": " + reason);
  } else if (certificate.floquet && !certificate.floquet->empty()) {
    double largest = 0.0;
    for (const auto& [re, im] : *certificate.floquet) largest = std::max(largest, std::hypot(re, im));
    text += fmt::format(", largest Floquet multiplier {:.4g} (modulus)", largest);
  }
  if (certified && certificate.stable == false)
    text += fmt::format("; a machine leaves this motion: `signorini motion {}` tells what it does then",
                        record.scene);
  return named_text("stability", text);
}

/// Multipliers by their size, the largest first, one of each pair of conjugates.
std::string multipliers(const FloquetMultipliers& all, bool verbose) {
  std::vector<std::pair<double, double>> kept;
  for (const auto& [re, im] : all) {
    if (im >= 0.0) kept.emplace_back(re, im);
  }
  std::ranges::stable_sort(kept, std::greater<>(),
                           [](const auto& mu) { return std::hypot(mu.first, mu.second); });
  std::vector<std::string> words;
  for (const auto& [re, im] : kept) {
    if (!verbose && words.size() == kMostShownRows) {
      words.emplace_back("...");
      break;
    }
    words.push_back(fmt::format("{:.4g}", re) + (im > 0.0 ? fmt::format(" +- {:.4g}i", im) : ""));
  }
  return joined(words, ", ");
}

std::string orbit_lines(const Certificate& certificate, bool verbose) {
  if (certificate.status == CertificateStatus::none)
    return named_text("orbit", "none: " + certificate.reason);
  const bool certified = certificate.status == CertificateStatus::certified;
  std::string text =
      named_text(certified ? "certified by orbit" : "uncertified", certificate_words(certificate));
  if (!certified || !certificate.floquet || certificate.floquet->empty()) return text;
  return text + named_text("multipliers", multipliers(*certificate.floquet, verbose));
}

std::string error_lines(const Record& record) {
  const Errors& errors = record.errors;
  std::string text =
      named_text("error of x", error_text(record) + " (relative, root mean square over a period" +
                                   (record.law && record.law_matches_scene == false
                                        ? "; to the motion with " + law_text(*record.law)
                                        : std::string()) +
                                   ")");
  const Measure worst = record.contacts.value_or(0) > 1 ? errors.x_worst : std::nullopt;
  for (const auto& [name, value] :
       {std::pair{"  maximum over time", errors.x_max}, std::pair{"  worst contact", worst},
        std::pair{"error of u", errors.u_l2}, std::pair{"error of velocity", errors.velocity_l2},
        std::pair{"error of force", errors.force}, std::pair{"  mean square", errors.force_l2},
        std::pair{"error of impulse", errors.impulse}}) {
    if (value) text += named_line(name, bounded_text(*value, record));
  }
  return text;
}

std::string physics_lines(const Physics& physics) {
  std::string text;
  for (const auto& [name, value] :
       {std::pair{"penetration", physics.penetration}, std::pair{"complementarity", physics.complementarity},
        std::pair{"energy defect", physics.energy_defect},
        std::pair{"contact ratio", physics.contact_ratio}}) {
    if (value) text += named_line(name, fmt::format("{:.1e}", *value));
  }
  if (!physics.energy_reason.empty())
    text += named_text("energy defect", "not defined: " + physics.energy_reason);
  if (!physics.effective_restitution.empty())
    text += named_text("effective restitution", joined(physics.effective_restitution, "{:.4f}", ", "));
  return text;
}

std::string work_lines(const Record& record) {
  const Work& work = record.work.counts;
  std::string text;
  for (const auto& [name, count] :
       {std::pair{"unknowns", work.unknowns}, std::pair{"iterations", work.iterations},
        std::pair{"pivots", work.pivots}}) {
    if (count) text += named_line(name, std::to_string(*count));
  }
  return record.condition ? text + named_line("condition estimate", fmt::format("{:.1e}", *record.condition))
                          : text;
}

}  // namespace

std::string answer_text(const Record& record, const SolveOutput& output) {
  const bool converged = record.status == Status::converged;
  const std::string status(status_name(record.status));
  std::string text =
      fmt::format("{}: {}\n", record.case_id,
                  output.colour ? fmt::format("\033[{}m{}\033[0m", converged ? 32 : 31, status) : status);
  if (!record.message.empty() && (output.verbose || !converged)) {
    for (const std::string& line : wrapped_lines(record.message, kTerminalWidth - 2))
      text += "  " + line + "\n";
  }
  if (record.status == Status::timeout) text += "  --timeout gives it more time\n";
  if (record.status == Status::timeout && record.method == "exact-orbit")
    text +=
        fmt::format("  if it never repeats: `signorini motion {}` tells what a machine does\n", record.scene);
  if (converged) text += stability_line(record);
  if (record.law) {
    text +=
        named_text("law", law_text(*record.law) + (record.law_matches_scene == false
                                                       ? " (the scene: " + law_text(*record.scene_law) + ")"
                                                       : ""));
  }
  if (record.period) text += named_line("period", fmt::format("{:.6g} s", *record.period));
  if (!record.motion || !record.period) return text;
  const MotionSummary& motion = *record.motion;
  const std::vector<int> contacts = contacts_by_impulse(motion);
  if (!motion.x.empty() || !motion.u.empty()) text += displacements(motion, contacts, output.verbose);
  if (!motion.x.empty())
    text += impacts(motion, output.verbose) + phases(motion, *record.period, output.verbose);
  return text + all_harmonics(motion, contacts, output.verbose);
}

std::string judgement_text(const Record& record, const SolveOutput& output) {
  std::string text =
      orbit_lines(record.certificate, output.verbose) + error_lines(record) + physics_lines(record.physics);
  if (output.verbose) text += work_lines(record);
  if (record.seconds) {
    const Seconds& seconds = *record.seconds;
    text += named_line("time", fmt::format("{} (set-up {}, solve {}{})", time_text(seconds.median),
                                           time_text(seconds.setup), time_text(seconds.solve),
                                           seconds.first ? ", first " + time_text(*seconds.first) : ""));
  }
  return text;
}

}  // namespace signorini
