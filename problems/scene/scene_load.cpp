#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "problems/scene/scene_system.hpp"

namespace signorini {

namespace {

// Coordinates that a term acts on, each with its share.
std::vector<std::pair<int, double>> read_point_of_attack(const SceneField& term,
                                                         const SystemDescription& system) {
  const SceneField face = term["face"];
  const SceneField group = term["group"];
  const SceneField direction = term["direction"];
  if (!face.given() && !group.given()) {
    term.forbid({"direction"}, "neither a face nor a group is given");
    return {{read_dof(term["dof"], system.size), 1.0}};
  }
  if (term["dof"].given()) term.forbid({"face", "group"}, "dof is given");
  if (face.given()) {
    term.forbid({"group"}, "face is given");
    return load_on_face(std::get<BlockMesh>(system.layout), read_face(face, system), read_axis(direction));
  }
  const MeshGroup& loaded = read_group(group, system);
  auto load = load_on_group(mesh_of(system), loaded, read_axis(direction));
  if (load.empty()) group.refuse("must have nodes that can move, and faces with an area");
  return load;
}

// The harmonic that a frequency is, where there is one. A motion that repeats itself needs a common period.
int harmonic_of(const SceneField& term, double base) {
  constexpr double kSame = 1e-12;  // of the ratio
  constexpr int kMostParts = 64;
  const SceneField field = frequency_field(term);
  const bool hertz = term["frequency_hz"].given();
  const double ratio = read_frequency(term) / base;
  const auto is_whole = [](double value) { return std::abs(value - std::round(value)) <= kSame * value; };
  if (is_whole(ratio) && ratio < kMostLoadSamples) return static_cast<int>(std::lround(ratio));
  for (int q = 2; q <= kMostParts; ++q) {
    if (is_whole(ratio * q) && ratio * q < kMostLoadSamples)
      field.refuse(fmt::format(
          "is {}/{} of forcing.frequency: write forcing.frequency{} = {:.17g}, and of what was a harmonic h "
          "harmonic = {} h, here harmonic = {}",
          std::lround(ratio * q), q, hertz ? "_hz" : "", base / q / (hertz ? 2.0 * std::numbers::pi : 1.0), q,
          std::lround(ratio * q)));
  }
  field.refuse(fmt::format(
      "must be p/q of forcing.frequency, q <= {}: a load of two frequencies without a common period has no "
      "periodic motion",
      kMostParts));
}

int read_load_harmonic(const SceneField& term, double base) {
  if (!frequency_field(term).given()) return read_int(term["harmonic"], 1);
  term.forbid({"harmonic"}, "frequency is given");
  return harmonic_of(term, base);
}

std::vector<double> read_samples(const SceneField& samples) {
  const std::vector<SceneField> items =
      samples.items("must be a list of samples of the load over one period, at least 3 [N]");
  if (items.size() < 3 || items.size() > kMostLoadSamples)
    samples.refuse(fmt::format("{} samples", items.size()), fmt::format("must be 3..{}", kMostLoadSamples));
  std::vector<double> values;
  for (const SceneField& item : items) values.push_back(item.number("must be a finite number [N]"));
  return values;
}

std::vector<double> read_table(const SceneField& table, double frequency, ReadLoad& load) {
  constexpr std::size_t kLargestTable = std::size_t{1} << 22U;  // [bytes]
  const NamedFile file = read_named_file(
      table, "must be the name of a text file of samples, relative to the scene's folder", kLargestTable);
  load.files.push_back(file.path);
  return parse_load_table(file.text, file.path.string(), 2.0 * std::numbers::pi / frequency);
}

// A term given by samples, on so many coordinates.
SampledLoad read_sampled(const SceneField& term, double frequency, std::size_t places, ReadLoad& load) {
  term.forbid({"harmonic", "frequency", "frequency_hz", "cos", "sin", "omega_power"},
              "the load is given by samples");
  if (term["samples"].given()) term.forbid({"file"}, "samples are given");
  const std::vector<double> values =
      term["file"].given() ? read_table(term["file"], frequency, load) : read_samples(term["samples"]);
  std::optional<int> harmonics;
  if (term["harmonics"].given()) {
    const int most = (static_cast<int>(values.size()) - 1) / 2;
    harmonics = term["harmonics"].whole(
        fmt::format("must be a whole number, 0..{}: {} samples determine no more", most, values.size()), 0,
        most);
  }
  SampledLoad sampled = load_of_samples(values, harmonics);
  if ((sampled.harmonics() + 1.0) * static_cast<double>(places) > kMostLoads)
    term.refuse(fmt::format("{} harmonics on {} coordinates", sampled.harmonics(), places),
                fmt::format("must make at most {:.0f} loads: give fewer harmonics", kMostLoads));
  sampled.field = term.path();
  return sampled;
}

void add_sampled(const SampledLoad& sampled, const std::vector<std::pair<int, double>>& attack, int table,
                 ReadLoad& load) {
  for (int h = 0; h <= sampled.harmonics(); ++h) {
    const double cos = sampled.cos[static_cast<std::size_t>(h)],
                 sin = sampled.sin[static_cast<std::size_t>(h)];
    if (cos == 0.0 && sin == 0.0) continue;
    for (const auto& [dof, share] : attack)
      load.add({.dof = dof, .harmonic = h, .cos = cos * share, .sin = sin * share}, table);
  }
}

}  // namespace

int read_int(const SceneField& field, int otherwise) {
  using Limits = std::numeric_limits<int>;
  return field.whole_or(otherwise, "must be a whole number", Limits::min() + 1, Limits::max());
}

SceneField frequency_field(const SceneField& table) {
  const SceneField frequency = table["frequency"], hertz = table["frequency_hz"];
  if (frequency.given()) table.forbid({"frequency_hz"}, "frequency is given");
  return hertz.given() ? hertz : frequency;
}

double read_frequency(const SceneField& table) {
  const SceneField field = frequency_field(table);
  if (!field.path().ends_with("_hz")) return read_positive(field, "[rad/s]");
  return 2.0 * std::numbers::pi * read_positive(field, "[Hz]");
}

ReadLoad read_load(const SceneField& terms, const SystemDescription& system, double frequency) {
  ReadLoad load;
  for (int table = 0; const SceneField& term :
                      terms.items_or_none("must be [[forcing.term]] tables; left out if there is none")) {
    term.allow_only({"dof", "face", "group", "direction", "harmonic", "frequency", "frequency_hz", "cos",
                     "sin", "omega_power", "samples", "file", "harmonics"},
                    "must be a table");
    const auto attack = read_point_of_attack(term, system);
    if (term.has_any({"samples", "file"})) {
      load.sampled.push_back(read_sampled(term, frequency, attack.size(), load));
      add_sampled(load.sampled.back(), attack, table, load);
    } else {
      term.forbid({"harmonics"}, "no samples are given");
      const int harmonic = read_load_harmonic(term, frequency);
      const double cos = term["cos"].number_or(0.0, "must be a finite number");
      const double sin = term["sin"].number_or(0.0, "must be a finite number");
      const int power = read_int(term["omega_power"], 0);
      for (const auto& [dof, share] : attack)
        load.add(
            {.dof = dof, .harmonic = harmonic, .cos = cos * share, .sin = sin * share, .omega_power = power},
            table);
    }
    ++table;
  }
  return load;
}

FromTables<ForceTerm> read_unbalance(const SceneField& unbalance, int size) {
  FromTables<ForceTerm> load;
  for (int table = 0; const SceneField& disc : unbalance.items_or_none(
                          "must be [[forcing.unbalance]] tables; left out if there is none")) {
    disc.allow_only({"dofs", "moment", "phase"}, "must be a table");
    const auto [x, y] = read_plane(disc["dofs"], size, ", of the plane in which the disc turns");
    const double moment = disc["moment"].number("must be a finite number [kg m]");
    const double phase = disc["phase"].number_or(0.0, "must be a finite number [rad]");
    const double cos = moment * std::cos(phase), sin = moment * std::sin(phase);
    load.add({.dof = x, .cos = cos, .sin = -sin, .omega_power = 2}, table);
    load.add({.dof = y, .cos = sin, .sin = cos, .omega_power = 2}, table);
    ++table;
  }
  return load;
}

}  // namespace signorini
