#include "harness/records/record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "harness/text/words.hpp"

namespace signorini {

std::string_view status_name(Status status) {
  return EnumNames<Status>::values[static_cast<std::size_t>(status)];
}

std::string resolution_of(const Record& record) { return label_of(record, record.settings); }

std::string label_of(const Record& record, const Settings& settings) {
  return method_label(record.method, settings) + (record.run.empty() ? "" : " (" + record.run + ")");
}

std::string stability_word(std::optional<bool> stable, const std::string& undefined) {
  if (stable) return *stable ? "stable" : "unstable";
  return undefined.empty() ? "" : "undefined";
}

std::string stability_words(std::optional<bool> stable, const std::string& undefined) {
  return stability_word(stable, undefined) + (stable || undefined.empty() ? "" : ": " + undefined);
}

std::string law_text(const RepresentedLaw& law) {
  struct Printer {
    std::string operator()(std::monostate) const { return "no contact"; }
    std::string operator()(const Restitution& l) const { return fmt::format("e = {:g}", l.e); }
    std::string operator()(const Penalty& l) const {
      std::vector<double> shown = l.stiffness;
      const bool equal = std::ranges::adjacent_find(shown, std::ranges::not_equal_to{}) == shown.end();
      if (equal && !shown.empty()) shown.resize(1);
      return "k = " + joined(shown, "{:g}", ", ") + " N/m";
    }
    std::string operator()(Massless) const { return "massless"; }
    std::string operator()(const MixedLaws& l) const {
      std::vector<std::string> texts;
      for (const ContactLaw& one : l.laws) {
        texts.push_back(
            std::visit([](const auto& law) { return law_text(as_represented(common_law({law}))); }, one));
      }
      return "mixed: " + joined(texts, "; ");
    }
    std::string operator()(Undetermined) const { return "undetermined"; }
  };
  return std::visit(Printer{}, law);
}

std::string law_remark(const Record& record) {
  return record.law && record.law_matches_scene == false ? law_text(*record.law) : std::string();
}

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

Measure level_error(const Record& record) {
  const Errors& errors = record.errors;
  const Measure& moved = errors.x_l2 ? errors.x_l2 : errors.u_l2;
  if (!moved) return moved;
  const bool spring = record.law && std::holds_alternative<Penalty>(*record.law) && errors.force_l2;
  const Measure pushed = errors.force && spring ? errors.force_l2 : errors.force;
  return std::max({*moved, errors.x_worst.value_or(0.0), pushed.value_or(0.0)});
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
