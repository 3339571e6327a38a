#pragma once
// [forcing] and [[contact]] of a scene file: what acts on the structure from outside.

#include <vector>

#include "problems/problem.hpp"
#include "problems/scene/scene_field.hpp"
#include "problems/scene/scene_system.hpp"

namespace signorini {

/// Things made from a list of tables; one table may make many.
template <class Thing>
struct FromTables {
  std::vector<Thing> things = {};
  std::vector<int> tables = {};  ///< for each thing, the table it was made from

  void add(Thing thing, int table) {
    things.push_back(std::move(thing));
    tables.push_back(table);
  }
};

/// The load: [[forcing.term]] tables, each on a coordinate or spread over a face. \throws SceneError
FromTables<ForceTerm> read_load(const SceneField& terms, const SystemDescription& system);

/// [[contact]] tables, each a contact, a ring of them, or those of a face. \throws SceneError
FromTables<Contact> read_contacts(const SceneField& contacts, const SystemDescription& system);

/// A whole number of any size: ranges are validate()'s business.
int read_int(const SceneField& field, int otherwise);

}  // namespace signorini
