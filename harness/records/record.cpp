#include "harness/records/record.hpp"

#include <algorithm>

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

std::optional<Claim> claim_of(const Record& record) {
  if (record.status == Status::inaccurate) return Claim::refuted;
  if (record.status != Status::converged) return std::nullopt;
  return record.certificate.status == CertificateStatus::certified ? Claim::certified : Claim::unproven;
}

double measurable_error(const Record& record) {
  constexpr double kErrorBars = 10.0;
  return std::max(kErrorBars * record.certificate.error_bar.value_or(0.0),
                  record.certificate.return_distance.value_or(0.0));
}

}  // namespace signorini
