#include "harness/report/document/cells.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "harness/report/document/lines.hpp"
#include "harness/report/evaluation/case_result.hpp"

namespace signorini {

Cell count_cell(std::ptrdiff_t count) { return {std::to_string(count), static_cast<double>(count)}; }

Cell count_cell(std::ptrdiff_t count, std::ptrdiff_t all) {
  return {fmt::format("{} of {}", count, all), static_cast<double>(count)};
}

Cell count_cell(std::ptrdiff_t count, std::ptrdiff_t all, double seconds) {
  const std::string text = count_cell(count, all).text;
  return {std::isfinite(seconds) ? text + ", " + time_text(seconds) : text, seconds};
}

Cell number_cell(const Measure& value, std::string_view format, const std::string& missing) {
  if (!value || !std::isfinite(*value)) return {missing, std::numeric_limits<double>::infinity()};
  return {fmt::format(fmt::runtime(format), *value), *value};
}

Cell time_cell(const Measure& seconds, const std::string& missing) {
  Cell cell = number_cell(seconds, "{}", missing);
  if (std::isfinite(*cell.value)) cell.text = time_text(*seconds);
  return cell;
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

std::string stability_text(int stable, int unstable, int all) {
  std::string text;
  for (const auto& [count, word] : {std::pair{stable, "stable"}, std::pair{unstable, "unstable"},
                                    std::pair{all - stable - unstable, "not determined"}}) {
    if (count > 0) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, word);
  }
  return text.empty() ? "-" : text;
}

std::string orbit_text(const Record& record) {
  constexpr std::size_t kLongestReason = 63;
  const Certificate& certificate = record.certificate;
  if (certificate.status == CertificateStatus::none) return in_place(record);
  if (certificate.status == CertificateStatus::uncertified)
    return "uncertified: " +
           clipped(certificate.reason.empty() ? "no reason given" : certificate.reason, kLongestReason);
  const std::string name = certificate.orbit.value_or("unnamed");
  const std::string stability = !certificate.undefined.empty() && !certificate.stable
                                    ? ", stability undefined"
                                : !certificate.stable ? ", stability not determined"
                                : *certificate.stable ? ", stable"
                                                      : ", unstable";
  const std::string motion = stability + (is_contact_free(record) ? ", without contact" : "");
  if (!certificate.same_orbit) {
    return fmt::format(
        "{}{} (no reference: {})", name, motion,
        clipped(certificate.reference_reason.empty() ? "not computed" : certificate.reference_reason,
                kLongestReason));
  }
  return (*certificate.same_orbit ? "same" : fmt::format("other ({})", name)) + motion;
}

}  // namespace signorini
