#include "harness/records/record.hpp"

#include <algorithm>
#include <cmath>

namespace signorini {

std::string_view status_name(Status status) {
  return EnumNames<Status>::values[static_cast<std::size_t>(status)];
}

std::string resolution_of(const Record& record) { return method_label(record.method, record.settings); }

void count_repeat(const std::string& answer, Record& record) {
  Repeats repeats = record.repeats.value_or(Repeats{});
  ++repeats.solves;
  repeats.identical += answer == record.answer ? 1 : 0;
  record.repeats = repeats;
}

std::optional<Claim> claim_of(Status status, CertificateStatus certificate) {
  if (status == Status::inaccurate) return Claim::refuted;
  if (status != Status::converged) return std::nullopt;
  return certificate == CertificateStatus::certified ? Claim::certified : Claim::unproven;
}

std::optional<Claim> claim_of(const Record& record) {
  return claim_of(record.status, record.certificate.status);
}

double measurable_error(const Record& record) {
  constexpr double kErrorBars = 10.0;
  const Certificate& certificate = record.certificate;
  // A state that is off by d returns (P - I) d away: d is up to 1 / min |1 - mu| times as large.
  double nearest = 1.0;
  for (const auto& [re, im] : certificate.floquet.value_or(FloquetMultipliers{}))
    nearest = std::min(nearest, std::hypot(1.0 - re, im));
  const double returned = certificate.return_distance.value_or(0.0);
  return std::max(kErrorBars * certificate.error_bar.value_or(0.0),
                  returned > 0.0 ? returned / nearest : 0.0);
}

}  // namespace signorini
