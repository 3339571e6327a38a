#include "methods/method.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace signorini {

namespace {

struct LawWords {
  std::string operator()(const Restitution& law) const { return fmt::format("restitution {:g}", law.e); }
  std::string operator()(const Spring&) const { return "a spring"; }
  std::string operator()(Massless) const { return "no mass"; }
};

}  // namespace

ContactLaw law_of_contact(const RepresentedLaw& law, int contact) {
  const auto index = static_cast<std::size_t>(contact);
  if (const auto* springs = std::get_if<Penalty>(&law)) return Spring{springs->stiffness[index]};
  if (const auto* mixed = std::get_if<MixedLaws>(&law)) return mixed->laws[index];
  if (const auto* restitution = std::get_if<Restitution>(&law)) return *restitution;
  return Massless{};
}

double restitution_of(const ContactLaw& law) {
  const auto* restitution = std::get_if<Restitution>(&law);
  return restitution != nullptr ? restitution->e : 1.0;
}

Support supports_one_law(const Problem& problem) {
  if (!std::holds_alternative<MixedLaws>(problem.law())) return {};
  const auto& contacts = problem.contacts;
  const auto other = std::ranges::find_if(
      contacts, [&contacts](const Contact& contact) { return contact.law != contacts.front().law; });
  return {false, fmt::format("contacts of different laws, contact 0 with {} and contact {} with {}: the "
                             "method knows one law for all",
                             std::visit(LawWords{}, contacts.front().law), other - contacts.begin(),
                             std::visit(LawWords{}, other->law))};
}

RepresentedLaw as_represented(const Law& law) {
  return std::visit([](const auto& held) -> RepresentedLaw { return held; }, law);
}

RepresentedLaw with_restitution(const Problem& problem, double e) {
  std::vector<ContactLaw> laws;
  for (const Contact& contact : problem.contacts)
    laws.push_back(std::holds_alternative<Restitution>(contact.law) ? Restitution{e} : contact.law);
  return as_represented(common_law(laws));
}

bool law_matches(const RepresentedLaw& represented, const Law& scene) {
  return represented == as_represented(scene);
}

}  // namespace signorini
