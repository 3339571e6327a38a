#include "harness/schematic/boundary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <map>
#include <set>
#include <utility>

#include "harness/text/words.hpp"

namespace signorini {

namespace {

/// "⁻³"
std::string superscript(int exponent) {
  constexpr std::array kDigits{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = exponent < 0 ? "⁻" : "";
  for (const char digit : std::to_string(std::abs(exponent)))
    text += kDigits.at(static_cast<std::size_t>(digit - '0'));
  return text;
}

/// "0.5 cos 2ωt"
std::string term_text(double size, const char* function, int harmonic) {
  const std::string times = harmonic == 1 ? "" : std::to_string(harmonic);
  return fmt::format("{} {} {}ωt", number_text(size), function, times);
}

std::vector<std::pair<int, double>> acting(const Contact& contact) {
  std::vector<std::pair<int, double>> found;
  for (const auto& entry : contact.normal)
    if (entry.second != 0.0) found.push_back(entry);
  return found;
}

/// Whether a contact is between two coordinates that move it in opposite directions.
bool is_pair(const Contact& contact) {
  const auto normal = acting(contact);
  return normal.size() == 2 && (normal[0].second > 0.0) != (normal[1].second > 0.0);
}

int elements_per_line(int elements) {
  constexpr int kMostLines = 40;
  return (elements + kMostLines - 1) / kMostLines;
}

}  // namespace

std::string number_text(double value, int digits) {
  std::string text = fmt::format("{:.{}g}", value, digits);
  if (const std::size_t e = text.find('e'); e != std::string::npos) {
    const std::string mantissa = text.substr(0, e);
    const std::string power = "10" + superscript(std::stoi(text.substr(e + 1)));
    text = mantissa == "1" ? power : mantissa == "-1" ? "-" + power : mantissa + "·" + power;
  }
  if (text.starts_with('-')) text.replace(0, 1, "−");
  return text;
}

std::string range_text(double least, double largest, const std::string& unit) {
  constexpr int kDigits = 10;  // a gap may differ from a resonance by little
  const std::string from = number_text(least, kDigits), to = number_text(largest, kDigits);
  return (from == to ? from : from + " … " + to) + " " + unit;
}

std::vector<double> mesh_lines(int elements) {
  std::vector<double> shares;
  const int step = elements_per_line(elements);
  for (int i = step; i < elements; i += step) shares.push_back(static_cast<double>(i) / elements);
  return shares;
}

std::string elements_text(int elements) {
  const int step = elements_per_line(elements);
  return fmt::format("{} element{}{}", elements, elements == 1 ? "" : "s",
                     step > 1 ? fmt::format(" (a line every {})", step) : "");
}

void SingleStop::add(const SingleStop& other) {
  const bool first = contacts == 0;
  if (first) *this = {.dof = other.dof, .forward = other.forward};
  least_gap = first ? other.least_gap : std::min(least_gap, other.least_gap);
  largest_gap = first ? other.largest_gap : std::max(largest_gap, other.largest_gap);
  contacts += other.contacts;
}

std::vector<SingleStop> single_stops(const Problem& problem) {
  std::map<std::pair<int, bool>, SingleStop> found;
  for (const Contact& contact : problem.contacts) {
    const auto normal = acting(contact);
    if (normal.size() != 1) continue;
    const bool forward = normal[0].second > 0.0;
    found[{normal[0].first, !forward}].add({normal[0].first, forward, 1, contact.gap, contact.gap});
  }
  std::vector<SingleStop> stops;
  for (const auto& [place, stop] : found) stops.push_back(stop);
  return stops;
}

bool has_other_side(const SingleStop& stop, const std::vector<SingleStop>& all) {
  return std::ranges::any_of(
      all, [&](const SingleStop& other) { return other.dof == stop.dof && other.forward != stop.forward; });
}

std::string gap_text(const SingleStop& stop, const char* things) {
  const std::string gap = "g = " + range_text(stop.least_gap, stop.largest_gap, "m");
  if (stop.contacts == 1) return stop.least_gap < 0.0 ? gap + " (preload)" : gap;
  return fmt::format("{} {}, {}", stop.contacts, things, gap);
}

std::vector<PairStop> pair_stops(const Problem& problem) {
  std::vector<PairStop> pairs;
  for (const Contact& contact : problem.contacts) {
    if (!is_pair(contact)) continue;
    const auto normal = acting(contact);
    const std::size_t closing = normal[0].second > 0.0 ? 0 : 1;
    pairs.push_back(
        {.closing = normal[closing].first, .other = normal[1 - closing].first, .gap = contact.gap});
  }
  return pairs;
}

int other_stops(const Problem& problem) {
  return static_cast<int>(std::ranges::count_if(problem.contacts, [](const Contact& contact) {
    return acting(contact).size() != 1 && !is_pair(contact);
  }));
}

std::string hidden_text(std::ptrdiff_t count, const std::string& contact, const char* rest) {
  return count > 0 ? fmt::format(", {} {}{}{}", count, contact, count == 1 ? "" : "s", rest) : "";
}

double drawn_gap(double gap, const Problem& problem) {
  double largest = 0.0;
  for (const Contact& contact : problem.contacts) largest = std::max(largest, std::abs(contact.gap));
  return gap > 0.0 ? 0.16 + 0.44 * gap / largest : 0.0;
}

std::vector<int> loaded_coordinates(const Problem& problem) {
  std::set<int> found;
  for (const ForceTerm& term : problem.force)
    if (term.cos != 0.0 || term.sin != 0.0) found.insert(term.dof);
  return {found.begin(), found.end()};
}

std::string load_text(const Problem& problem, int dof) {
  constexpr std::size_t kMostTerms = 2;
  std::map<int, std::complex<double>> amplitudes;
  for (const ForceTerm& term : problem.force)
    if (term.dof == dof) amplitudes[term.harmonic] += force_amplitude(term, problem.frequency);
  std::vector<std::string> terms;
  for (const auto& [harmonic, amplitude] : amplitudes) {
    if (harmonic == 0) terms.push_back(number_text(amplitude.real()));
    if (harmonic > 0 && amplitude.real() != 0.0)
      terms.push_back(term_text(amplitude.real(), "cos", harmonic));
    if (harmonic > 0 && amplitude.imag() != 0.0)
      terms.push_back(term_text(-amplitude.imag(), "sin", harmonic));
  }
  if (terms.size() > kMostTerms) return "f(t)";
  return replaced(joined(terms, " + ") + " N", "+ −", "− ");
}

std::string motion_note(const Problem& problem) {
  std::string note = fmt::format("ω = {} rad/s", number_text(problem.frequency));
  if (problem.subharmonic > 1) note += fmt::format(", order {}", problem.subharmonic);
  const Law law = problem.law();
  if (const auto* impact = std::get_if<Restitution>(&law)) note += ", e = " + number_text(impact->e);
  if (const auto* springs = std::get_if<Penalty>(&law)) {
    const auto [least, largest] = std::ranges::minmax(springs->stiffness);
    note += ", stop of " + range_text(least, largest, "N/m");
  }
  if (!problem.frame.empty()) note += ", moving stops";
  if (std::holds_alternative<Massless>(law)) note += ", contact without mass";
  if (std::holds_alternative<MixedLaws>(law)) note += ", stops of different laws";
  return note;
}

}  // namespace signorini
