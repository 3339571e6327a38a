#include "harness/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "harness/statistics.hpp"
#include "harness/table.hpp"
#include "harness/yardstick.hpp"

namespace signorini {

namespace {

std::string shortened(const std::string& text) {
  constexpr std::size_t kLongest = 60;
  if (text.size() <= kLongest) return text;
  std::size_t end = kLongest;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;  // no half characters
  return text.substr(0, end) + "...";
}

bool answered(const Record& record) {
  return record.status == Status::converged || record.status == Status::inaccurate;
}

std::string status_text(const Record& record) { return std::string(status_name(record.status)); }

/// What a cell says where the run gave nothing to show.
std::string in_place(const Record& record) { return fmt::format("({})", status_name(record.status)); }

std::string represented_text(const Record& record) {
  if (!record.law) return in_place(record);
  return law_text(*record.law) + (record.law_matches_scene == false ? " ≠ scene" : "");
}

std::string energy_text(const Record& record) {
  if (!answered(record)) return in_place(record);
  return record.physics.energy_defect ? fmt::format("{:.1e}", *record.physics.energy_defect) : "not defined";
}

// Only what converged in the harness's eyes has a time: a fast wrong answer is no answer.
std::string time_cell(const Record& record, double Seconds::*which) {
  if (record.status != Status::converged) return in_place(record);
  if (record.seconds) {
    const bool shaky = which == &Seconds::median && record.seconds->unstable == true;
    return time_text((*record.seconds).*which) + (shaky ? " (unstable)" : "");
  }
  return record.not_timed.empty() ? "not timed" : "not timed: " + record.not_timed;
}

std::string work_text(const Record& record) {
  const Work& work = record.work.counts;
  std::string text;
  if (work.pivots) text = fmt::format("{} p", *work.pivots);
  if (work.iterations) text += fmt::format("{}{} it", text.empty() ? "" : ", ", *work.iterations);
  if (!text.empty()) return text;
  return answered(record) ? "not counted" : in_place(record);
}

bool before(const Record& a, const Record& b) {
  if (a.scene != b.scene) return natural_less(a.scene, b.scene);
  if (a.method != b.method) return a.method < b.method;
  if (a.case_id != b.case_id) return natural_less(a.case_id, b.case_id);
  return a.key < b.key;
}

std::vector<Record> sorted(std::vector<Record> records) {
  std::stable_sort(records.begin(), records.end(), before);
  return records;
}

/// "fourier-lipschitz[harmonics=40]".
std::string method_text(const Record& record) {
  const std::size_t slash = record.case_id.find('/');
  return slash == std::string::npos ? record.method : record.case_id.substr(slash + 1);
}

struct Tally {
  int cases = 0, not_applicable = 0, converged = 0, certified = 0, same = 0, other = 0, inaccurate = 0;
  bool timed = true;
  std::vector<double> times;  // of applicable cases, infinite where they failed
};

void count(const Record& record, Tally& tally) {
  ++tally.cases;
  if (record.status == Status::not_applicable) {
    ++tally.not_applicable;
    return;
  }
  const bool converged = record.status == Status::converged;
  tally.converged += converged ? 1 : 0;
  tally.inaccurate += record.status == Status::inaccurate ? 1 : 0;
  if (converged && !record.seconds) tally.timed = false;
  tally.times.push_back(converged && record.seconds ? record.seconds->median
                                                    : std::numeric_limits<double>::infinity());
  if (!converged || record.certificate.status != CertificateStatus::certified) return;
  ++tally.certified;
  if (record.certificate.same_orbit) ++(*record.certificate.same_orbit ? tally.same : tally.other);
}

std::string median_text(const Tally& tally) {
  if (tally.times.empty()) return "no applicable case";
  if (tally.converged == 0) return "all failed";
  if (!tally.timed) return "not timed";
  const double middle = median(tally.times);
  return std::isfinite(middle) ? time_text(middle) : "half or more failed";
}

Table summary_table(const std::vector<Record>& records) {
  std::map<std::string, Tally> tallies;
  for (const Record& record : records) count(record, tallies[record.method]);
  Table table{{"method", "cases", "not applicable", "converged", "inaccurate", "failed", "certified",
               "same orbit", "other orbit", "median time, failures infinite"},
              {}};
  for (const auto& [method, tally] : tallies) {
    const int failed = tally.cases - tally.not_applicable - tally.converged - tally.inaccurate;
    const int applicable = tally.cases - tally.not_applicable;
    table.rows.push_back({method, std::to_string(tally.cases), std::to_string(tally.not_applicable),
                          fmt::format("{} of {}", tally.converged, applicable),
                          std::to_string(tally.inaccurate), std::to_string(failed),
                          std::to_string(tally.certified), std::to_string(tally.same),
                          std::to_string(tally.other), median_text(tally)});
  }
  return table;
}

Table main_table(const std::vector<Record>& records) {
  Table table{{"scene", "law", "method", "represents", "status", "error of x", "energy defect", "time min",
               "time median", "pivots, iterations", "orbit"},
              {}};
  for (const Record& record : records) {
    table.rows.push_back({record.scene, record.scene_law ? law_text(*record.scene_law) : "not recorded",
                          method_text(record), represented_text(record), status_text(record),
                          error_text(record), energy_text(record), time_cell(record, &Seconds::min),
                          time_cell(record, &Seconds::median), work_text(record), orbit_text(record)});
  }
  return table;
}

/// The figures of one method at one resolution over all scenes to which it applies; infinite where it failed.
struct Speed {
  std::string method;
  std::vector<double> errors, times, ratios;
};

std::vector<Speed> speeds(const std::vector<Record>& records) {
  const auto solved = [](const Record& r) {
    return r.status == Status::converged && r.certificate.status == CertificateStatus::certified && r.seconds;
  };
  std::map<std::string, double> yardstick;  // by scene
  for (const Record& r : records) {
    if (method_text(r) == kYardstick && solved(r)) yardstick[r.scene] = r.seconds->median;
  }
  std::vector<Speed> result;
  std::map<std::string, std::size_t> place;
  constexpr double kFailed = std::numeric_limits<double>::infinity();
  for (const Record& r : records) {
    if (r.status == Status::not_applicable) continue;
    const std::string method = method_text(r);
    if (place.try_emplace(method, result.size()).second) result.push_back({method, {}, {}, {}});
    Speed& speed = result[place[method]];
    const bool good = solved(r);
    const Measure error = r.errors.x_l2 ? r.errors.x_l2 : r.errors.u_l2;
    const double floor = measurable_error(r);
    speed.errors.push_back(good && error ? std::max(*error, floor) : kFailed);
    speed.times.push_back(good ? r.seconds->median : kFailed);
    if (const auto found = yardstick.find(r.scene); found != yardstick.end())
      speed.ratios.push_back(good ? r.seconds->median / found->second : kFailed);
  }
  std::stable_sort(result.begin(), result.end(), [](const Speed& a, const Speed& b) {
    return a.method != b.method && natural_less(a.method, b.method);
  });
  return result;
}

Table speed_table(const std::vector<Record>& records) {
  Table table{{"method", "solved", "error of x, median", "time, median",
               fmt::format("time / {}, median", kYardstick)},
              {}};
  const auto text = [](const std::vector<double>& values, const auto& print) {
    if (values.empty()) return std::string("not measured");
    const double middle = median(values);
    return std::isfinite(middle) ? print(middle) : std::string("half or more failed");
  };
  for (const Speed& speed : speeds(records)) {
    const auto solved = std::count_if(speed.times.begin(), speed.times.end(),
                                      [](double time) { return std::isfinite(time); });
    table.rows.push_back({speed.method, fmt::format("{} of {}", solved, speed.times.size()),
                          text(speed.errors, [](double e) { return fmt::format("{:.1e}", e); }),
                          text(speed.times, [](double t) { return time_text(t); }),
                          text(speed.ratios, [](double r) { return fmt::format("{:.2g}", r); })});
  }
  return table;
}

std::string notes(const std::vector<Record>& records) {
  std::string text;
  for (const Record& record : records) {
    const bool uncertified = record.certificate.status != CertificateStatus::certified && answered(record);
    if (record.status == Status::converged && !uncertified) continue;
    const std::string why = record.status == Status::converged ? record.certificate.reason : record.message;
    text += fmt::format(
        "- `{}`: {}: {}\n", record.case_id,
        uncertified && record.status == Status::converged ? "uncertified" : status_name(record.status),
        why.empty() ? "no message" : why);
  }
  return text;
}

constexpr std::string_view kLegend =
    "error of x: relative L2 distance to the certified orbit of the law that the method represents; `<`: "
    "below ten\n"
    "error bars of that orbit. `≠ scene`: the method represents another impact law than the scene states.\n"
    "time: set-up and solve of one cold run, least per round, over rounds; unstable where rounds deviate by "
    "more "
    "than 5 % in the median. p: pivots, it: iterations "
    "(event-driven:\n"
    "periods marched or Newton steps). orbit: same as reached from rest under the represented law, or "
    "another one;\n"
    "unstable where a Floquet multiplier lies outside the unit circle.\n"
    "The orbits are exact ones, polished from each answer and followed by CVODE for a period; where there is "
    "none,\n"
    "they come from the event-driven method by shooting at tolerance 1e-12. Both methods are so judged by "
    "their own kin:\n"
    "exact-orbit by a second evaluation of its orbit, and by CVODE to about 1e-10.\n"
    "Medians of the second table take failures as infinite; its errors mix laws and scenes, and rank "
    "nothing.\n";

std::string number(const Measure& value) { return value ? fmt::format("{:.9e}", *value) : ""; }
std::string number(const std::optional<long>& value) { return value ? std::to_string(*value) : ""; }
std::string yes_no(const std::optional<bool>& value) { return value ? (*value ? "true" : "false") : ""; }

/// Why cells of a row are empty, or what is to be said about it.
std::string csv_reason(const Record& record) {
  if (!answered(record)) return fmt::format("{}: {}", status_name(record.status), record.message);
  std::string text;
  const auto add = [&](const std::string& part) {
    if (!part.empty()) text += (text.empty() ? "" : "; ") + part;
  };
  if (record.status == Status::inaccurate) add(record.message);
  if (record.certificate.status != CertificateStatus::certified)
    add("uncertified: " + record.certificate.reason);
  if (!record.seconds)
    add("not timed: " + (record.not_timed.empty() ? "no times recorded" : record.not_timed));
  if (!record.certificate.reference_reason.empty())
    add("no reference: " + record.certificate.reference_reason);
  add("other empty cells: the notion does not exist for this run");
  return text;
}

std::vector<std::string> csv_row(const Record& r) {
  const auto seconds = [&](double Seconds::*which) {
    return r.seconds ? number(Measure((*r.seconds).*which)) : "";
  };
  const Work& work = r.work.counts;
  return {r.case_id,
          r.scene,
          r.scene_law ? law_text(*r.scene_law) : "",
          r.method,
          method_text(r),
          r.law ? law_text(*r.law) : "",
          yes_no(r.law_matches_scene),
          status_text(r),
          number(r.period),
          number(r.errors.x_l2),
          number(r.errors.x_max),
          number(r.errors.u_l2),
          number(r.errors.velocity_l2),
          number(r.errors.impulse),
          number(r.errors.x_l2_scene),
          number(r.certificate.error_bar),
          number(r.physics.penetration),
          number(r.physics.complementarity),
          number(r.physics.energy_defect),
          number(r.physics.contact_ratio),
          seconds(&Seconds::min),
          seconds(&Seconds::median),
          seconds(&Seconds::mad),
          seconds(&Seconds::setup),
          seconds(&Seconds::solve),
          number(work.unknowns),
          number(work.iterations),
          number(work.pivots),
          number(work.rhs_evaluations),
          number(work.factorisations),
          number(r.work.peak_memory_bytes),
          std::string(certificate_name(r.certificate.status)),
          r.certificate.orbit.value_or(""),
          yes_no(r.certificate.same_orbit),
          yes_no(r.certificate.stable),
          number(r.certificate.return_distance),
          csv_reason(r)};
}

}  // namespace

std::string law_text(const RepresentedLaw& law) {
  struct Printer {
    std::string operator()(std::monostate) const { return "no contact"; }
    std::string operator()(const Restitution& l) const { return fmt::format("e = {:g}", l.e); }
    std::string operator()(const Penalty& l) const {
      std::string text = "k =";
      const bool equal = std::equal(l.stiffness.begin() + (l.stiffness.empty() ? 0 : 1), l.stiffness.end(),
                                    l.stiffness.begin());
      for (std::size_t i = 0; i < (equal ? std::min<std::size_t>(1, l.stiffness.size()) : l.stiffness.size());
           ++i) {
        text += fmt::format("{} {:g}", i == 0 ? "" : ",", l.stiffness[i]);
      }
      return text + " N/m";
    }
    std::string operator()(Massless) const { return "massless"; }
    std::string operator()(Undetermined) const { return "undetermined"; }
  };
  return std::visit(Printer{}, law);
}

std::string error_text(const Record& record) {
  if (!answered(record)) return in_place(record);
  if (record.certificate.status != CertificateStatus::certified) return "uncertified";
  const bool field = !record.errors.x_l2.has_value();
  const Measure error = field ? record.errors.u_l2 : record.errors.x_l2;
  if (!error) return "no scale";
  return bounded_text(*error, record) + (field ? " (u)" : "");
}

std::string bounded_text(double error, const Record& record) {
  const double floor = measurable_error(record);
  return fmt::format("{}{:.1e}", error < floor ? "<" : "", std::max(error, floor));
}

std::string time_text(double seconds) {
  if (seconds < 1e-3) return fmt::format("{:.3g} us", 1e6 * seconds);
  if (seconds < 1.0) return fmt::format("{:.3g} ms", 1e3 * seconds);
  return fmt::format("{:.3g} s", seconds);
}

std::string orbit_text(const Record& record) {
  const Certificate& certificate = record.certificate;
  switch (certificate.status) {
    case CertificateStatus::none:
      return in_place(record);
    case CertificateStatus::uncertified:
      return "uncertified: " + shortened(certificate.reason.empty() ? "no reason given" : certificate.reason);
    case CertificateStatus::certified:
      break;
  }
  const std::string name = certificate.orbit.value_or("unnamed");
  if (!certificate.same_orbit) {
    return fmt::format(
        "{} (no reference: {})", name,
        shortened(certificate.reference_reason.empty() ? "not computed" : certificate.reference_reason));
  }
  const std::string stability = certificate.stable == false ? ", unstable" : "";
  return (*certificate.same_orbit ? "same" : fmt::format("other ({})", name)) + stability;
}

std::string markdown_report(const std::vector<Record>& unsorted) {
  const std::vector<Record> records = sorted(unsorted);
  std::string text =
      fmt::format("{}\n{}\n{}\n{}", to_markdown(summary_table(records)), to_markdown(speed_table(records)),
                  to_markdown(main_table(records)), kLegend);
  if (const std::string said = notes(records); !said.empty()) text += "\nWhat went otherwise:\n\n" + said;
  return text;
}

std::string csv_report(const std::vector<Record>& unsorted) {
  Table table{{"case",
               "scene",
               "scene_law",
               "method",
               "resolution",
               "law",
               "law_matches_scene",
               "status",
               "period",
               "x_l2",
               "x_max",
               "u_l2",
               "velocity_l2",
               "impulse",
               "x_l2_scene",
               "error_bar",
               "penetration",
               "complementarity",
               "energy_defect",
               "contact_ratio",
               "seconds_min",
               "seconds_median",
               "seconds_mad",
               "seconds_setup",
               "seconds_solve",
               "unknowns",
               "iterations",
               "pivots",
               "rhs_evaluations",
               "factorisations",
               "peak_memory_bytes",
               "certificate",
               "orbit",
               "same_orbit",
               "stable",
               "return_distance",
               "reason"},
              {}};
  for (const Record& record : sorted(unsorted)) table.rows.push_back(csv_row(record));
  return to_csv(table);
}

}  // namespace signorini
