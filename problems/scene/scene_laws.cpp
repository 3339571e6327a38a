#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <tuple>

#include "problems/scene/scene_system.hpp"

namespace signorini {

namespace {

// The laws that one table gives to its contacts, in their order, and the dampers beside springs, 0: none
// [N s/m].
using TableLaws = std::vector<std::pair<ContactLaw, double>>;

// One number for all contacts, or a list of one for each.
std::vector<double> read_stop_constants(const SceneField& field, std::string_view unit,
                                        std::size_t contacts) {
  const std::string each = fmt::format("must be a positive number [{}]", unit);
  const std::string requirement = each + ", or a list of them";
  if (!field.is_array()) return std::vector<double>(contacts, field.number(requirement));
  std::vector<double> values;
  for (const SceneField& item : field.items(requirement)) values.push_back(item.number(each));
  if (values.size() != contacts)
    field.refuse(fmt::format("{} values", values.size()),
                 fmt::format("must be one number, or one per contact: {}", contacts));
  return values;
}

// Empty where the table says nothing of a law.
std::optional<TableLaws> laws_of_table(const SceneField& table, std::size_t contacts) {
  const SceneField restitution = table["restitution"], penalty = table["penalty"],
                   massless = table["massless"],
                   damper = table[table["damper"].given() ? "damper" : "damping"];
  if (restitution.given()) table.forbid({"penalty"}, "restitution is given");
  if (damper.given() && !penalty.given())
    damper.refuse("must be absent: no penalty, a spring beside it, is given");
  if (massless.given()) {
    const auto* truth = std::get_if<bool>(&massless.node().value);
    if (truth == nullptr || !*truth) massless.refuse("must be true, or left out");
    if (penalty.given()) table.forbid({"massless"}, "penalty is given");
    if (restitution.given()) table.forbid({"massless"}, "restitution is given");
    return TableLaws(contacts, {Massless{}, 0.0});
  }
  if (restitution.given())
    return TableLaws(contacts, {Restitution{restitution.number("must be in 0..1")}, 0.0});
  if (!penalty.given()) return std::nullopt;
  TableLaws result;
  for (const double stiffness : read_stop_constants(penalty, "N/m", contacts))
    result.emplace_back(Spring{stiffness}, 0.0);
  if (!damper.given()) return result;
  const std::vector<double> dampers = read_stop_constants(damper, "N s/m", contacts);
  for (std::size_t k = 0; k < contacts; ++k) {
    result[k].second = dampers[k];
    if (dampers[k] > 0.0) continue;
    (damper.is_array() ? damper.items("")[k] : damper).refuse("must be a positive number [N s/m]");
  }
  return result;
}

// Gives contacts `first` and on their laws.
void take_laws(const TableLaws& of_table, std::size_t first, std::vector<Contact>& contacts,
               std::vector<double>& dampers) {
  for (std::size_t k = 0; k < of_table.size(); ++k)
    std::tie(contacts[first + k].law, dampers[first + k]) = of_table[k];
}

}  // namespace

std::vector<DampedStop> read_laws(const SceneField& document, FromTables<Contact>& contacts) {
  const SceneField law = document["law"];
  std::vector<Contact>& all = contacts.things;
  std::vector<double> dampers(all.size(), 0.0);
  if (law.given()) {
    law.allow_only({"restitution", "penalty", "damping"}, "must be a table with restitution or penalty");
    if (all.empty()) law.refuse("must be absent: the scene has no contact");
    const auto of_all = laws_of_table(law, all.size());
    if (!of_all) law.refuse("must hold restitution or penalty, or be left out");
    take_laws(*of_all, 0, all, dampers);
  }
  for (std::size_t first = 0; first < all.size();) {
    const int table = contacts.tables[first];
    const auto count = static_cast<std::size_t>(std::ranges::count(contacts.tables, table));
    const SceneField own = document.at(fmt::format("contact[{}]", table));
    if (const auto laws = laws_of_table(own, count)) take_laws(*laws, first, all, dampers);
    first += count;
  }
  std::vector<DampedStop> damped;
  for (std::size_t j = 0; j < all.size(); ++j) {
    const auto* spring = std::get_if<Spring>(&all[j].law);
    if (spring == nullptr || dampers[j] == 0.0) continue;
    damped.push_back({.contact = static_cast<int>(j),
                      .normal = all[j].normal,
                      .stiffness = spring->stiffness,
                      .damping = dampers[j]});
  }
  return damped;
}

void require_massless(const SceneField& document, const FromTables<Contact>& contacts,
                      const Problem& problem) {
  std::optional<std::vector<bool>> massive;
  for (std::size_t j = 0; j < problem.contacts.size(); ++j) {
    const SceneField own = document.at(fmt::format("contact[{}].massless", contacts.tables[j]));
    if (!own.given()) continue;
    if (!massive) massive = contacts_with_mass(problem);
    if ((*massive)[j]) own.refuse("must be left out: the contact coordinate carries mass");
  }
}

SceneField law_field_as_written(const SceneField& document, const std::vector<int>& tables,
                                std::size_t contact, const std::string& key) {
  const int table = tables.at(contact);
  const auto first = static_cast<std::size_t>(std::ranges::find(tables, table) - tables.begin());
  const SceneField own = document.at(fmt::format("contact[{}]", table));
  const auto among = [&](const SceneField& holder, const std::string& name, std::size_t place) {
    return holder[name].is_array() ? holder.at(fmt::format("{}[{}]", name, place)) : holder[name];
  };
  const std::string own_key = key == "damper" && !own[key].given() ? "damping" : key;
  if (own[own_key].given()) return among(own, own_key, contact - first);
  if (!document["law"].given() && std::ranges::any_of(tables, [&](int other) {
        return document.at(fmt::format("contact[{}]", other)).has_any({"restitution", "penalty", "massless"});
      }))
    return own[key];
  return among(document["law"], key == "damper" ? "damping" : key, contact);
}

}  // namespace signorini
