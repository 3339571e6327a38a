#include "problems/assembly/chain.hpp"

#include "problems/assembly/elements.hpp"

namespace signorini {

namespace {

// An element of constant `a` between masses i and j.
void join(int i, int j, double a, Entries& entries) {
  entries.emplace_back(i, i, a);
  entries.emplace_back(j, j, a);
  entries.emplace_back(i, j, -a);
  entries.emplace_back(j, i, -a);
}

Entries diagonal(const std::vector<double>& values) {
  Entries entries;
  for (const double value : values) {
    const int i = static_cast<int>(entries.size());
    entries.emplace_back(i, i, value);
  }
  return entries;
}

// Springs or dampers: those of the row, those to the ground, and those of the links.
SparseMatrix elements(const std::vector<double>& row, const std::vector<double>& ground,
                      const std::vector<Link>& links, double Link::*constant) {
  Entries entries = diagonal(ground);
  for (int i = 0; i < std::ssize(row); ++i) {
    const double a = row[static_cast<std::size_t>(i)];
    if (i == 0) {
      entries.emplace_back(0, 0, a);  // the wall does not move
    } else {
      join(i - 1, i, a, entries);
    }
  }
  for (const Link& link : links) {
    if (link.*constant != 0.0) join(link.first, link.second, link.*constant, entries);
  }
  return from_entries(entries, std::ssize(row));
}

}  // namespace

Structure assemble(const Chain& chain) {
  const std::size_t size = chain.masses.size();
  const auto fits = [=](const std::vector<double>& ground) {
    return ground.empty() || ground.size() == size;
  };
  if (chain.dampers.size() != size || chain.springs.size() != size || !fits(chain.ground_dampers) ||
      !fits(chain.ground_springs)) {
    throw std::invalid_argument("chain: masses, dampers and springs must have one entry per mass");
  }
  return {.mass = from_entries(diagonal(chain.masses), std::ssize(chain.masses)),
          .damping = elements(chain.dampers, chain.ground_dampers, chain.links, &Link::damper),
          .stiffness = elements(chain.springs, chain.ground_springs, chain.links, &Link::spring)};
}

}  // namespace signorini
