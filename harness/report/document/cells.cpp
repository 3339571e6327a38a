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

Cell count_cell(std::ptrdiff_t count) { return {std::to_string(count), static_cast<double>(count)}; }

Cell count_cell(std::ptrdiff_t count, std::ptrdiff_t all) {
  return {fmt::format("{} of {}", count, all), static_cast<double>(count)};
}

std::string in_place(Status status) { return fmt::format("({})", status_name(status)); }

std::string in_place(const Record& record) { return in_place(record.status); }

std::string error_text(const Record& record) {
  if (!claim_of(record)) return in_place(record);
  if (record.certificate.status != CertificateStatus::certified)
    return record.errors.x_l2 ? fmt::format("near: {:.1e}", *record.errors.x_l2) : "uncertified";
  const Measure& error = record.errors.x_l2 ? record.errors.x_l2 : record.errors.u_l2;
  if (!error) return "no scale";
  return bounded_text(*error, record) + (record.errors.x_l2 ? "" : " (u)");
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
  if (certificate.status == CertificateStatus::none) return in_place(record);
  if (certificate.status == CertificateStatus::uncertified)
    return "uncertified: " + shortened(certificate.reason.empty() ? "no reason given" : certificate.reason);
  const std::string name = certificate.orbit.value_or("unnamed");
  if (!certificate.same_orbit) {
    return fmt::format(
        "{} (no reference: {})", name,
        shortened(certificate.reference_reason.empty() ? "not computed" : certificate.reference_reason));
  }
  const std::string stability = certificate.stable == false      ? ", unstable"
                                : !certificate.undefined.empty() ? ", stability undefined"
                                                                 : "";
  return (*certificate.same_orbit ? "same" : fmt::format("other ({})", name)) + stability;
}

}  // namespace signorini
