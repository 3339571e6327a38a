#include "harness/report/document/cells.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace signorini {

namespace {

std::string shortened(const std::string& text) {
  constexpr std::size_t kLongest = 60;
  if (text.size() <= kLongest) return text;
  std::size_t end = kLongest;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;  // no half characters
  return text.substr(0, end) + "...";
}

}  // namespace

Cell count_cell(int count) { return {std::to_string(count), static_cast<double>(count)}; }

bool answered(const Record& record) {
  return record.status == Status::converged || record.status == Status::inaccurate;
}

std::string in_place(const Record& record) { return fmt::format("({})", status_name(record.status)); }

std::string represented_text(const Record& record) {
  if (!record.law) return in_place(record);
  return law_text(*record.law) + (record.law_matches_scene == false ? " ≠ scene" : "");
}

std::string energy_text(const Record& record) {
  if (!answered(record)) return in_place(record);
  return record.physics.energy_defect ? fmt::format("{:.1e}", *record.physics.energy_defect) : "not defined";
}

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
  if (record.certificate.status != CertificateStatus::certified)
    return record.errors.x_l2 ? fmt::format("near: {:.1e}", *record.errors.x_l2) : "uncertified";
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

}  // namespace signorini
