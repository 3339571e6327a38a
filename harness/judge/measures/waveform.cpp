#include "harness/judge/measures/waveform.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "harness/text/words.hpp"

namespace signorini {

namespace {

/// Instants per forcing period among which those that are kept are chosen.
constexpr int kDrawnGrid = 2048;

enum Signal : Eigen::Index { kX, kVelocity, kForce, kImpulse, kSignals };

/// Impulse given since row 0, of one contact: trapezoids of the force, jumps of the impulses.
Eigen::VectorXd accumulated(const Motion& motion, int contact) {
  const Eigen::Index count = motion.count();
  const double step = motion.step();
  Eigen::VectorXd jumps = Eigen::VectorXd::Zero(count + 1);
  for (const Impulse& impulse : motion.impulses) {
    if (impulse.contact == contact)
      jumps[std::min(count, static_cast<Eigen::Index>(impulse.time / step) + 1)] += impulse.value;
  }
  Eigen::VectorXd total(count + 1);
  total[0] = jumps[0];
  for (Eigen::Index i = 0; i < count; ++i) {
    const double mean =
        0.5 * (motion.samples.force(i, contact) + motion.samples.force((i + 1) % count, contact));
    total[i + 1] = total[i] + step * mean + jumps[i + 1];
  }
  return total;
}

/// All signals of one contact over `periods` forcing periods, ends included.
Eigen::MatrixXd signals_of(const Motion& motion, int contact, int periods) {
  const Eigen::Index count = motion.count();
  const Eigen::Index rows = static_cast<Eigen::Index>(periods) * motion.per_period();
  const Eigen::VectorXd total = accumulated(motion, contact);
  const auto given = [&](Eigen::Index row) {
    const Eigen::Index rounds = row / count;
    return total[row % count] + static_cast<double>(rounds) * total[count];
  };
  Eigen::MatrixXd signals(rows + 1, static_cast<Eigen::Index>(kSignals));
  for (Eigen::Index i = 0; i <= rows; ++i) {
    const Eigen::Index row = i % count;
    signals(i, kX) = motion.samples.x(row, contact);
    signals(i, kVelocity) = motion.samples.velocity(row, contact);
    signals(i, kForce) = motion.samples.force(row, contact);
    signals(i, kImpulse) = given(i) - given(0);
  }
  return signals;
}

constexpr int kDrawnDigits = 5;

std::vector<double> rounded_at(const Eigen::Ref<const Eigen::VectorXd>& values,
                               const std::vector<int>& places) {
  std::vector<double> list;
  list.reserve(places.size());
  for (const int place : places) list.push_back(rounded(values[place], kDrawnDigits));
  return list;
}

/// Impulses are summed over all samples, so that a force between two instants that are drawn is counted once.
Waveform draw(const Motion& motion, const std::vector<int>& contacts, int periods, double tolerance) {
  const int every = std::max(1, motion.per_period() / kDrawnGrid);
  const auto kept = static_cast<Eigen::Index>(contacts.size());
  const Eigen::Index rows = static_cast<Eigen::Index>(periods) * motion.per_period() / every + 1;
  Eigen::MatrixXd signals(rows, kept * kSignals);
  for (Eigen::Index c = 0; c < kept; ++c)
    signals.middleCols(c * kSignals, kSignals) = signals_of(motion, contacts[static_cast<std::size_t>(c)],
                                                            periods)(Eigen::seqN(0, rows, every), Eigen::all);
  const std::vector<int> places = polyline(signals, tolerance);
  Waveform waveform;
  for (const int place : places) waveform.t.push_back(rounded(place * every * motion.step(), kDrawnDigits));
  for (Eigen::Index c = 0; c < kept; ++c) {
    const auto list = [&](Signal signal) { return rounded_at(signals.col(c * kSignals + signal), places); };
    waveform.x.push_back(list(kX));
    waveform.velocity.push_back(list(kVelocity));
    waveform.force.push_back(list(kForce));
    waveform.impulse.push_back(list(kImpulse));
  }
  return waveform;
}

/// The contacts that exchange most impulse, at most kDrawnContacts, in the scene's order.
std::vector<int> contacts_drawn(const Motion& motion) {
  std::vector<int> contacts(static_cast<std::size_t>(motion.samples.x.cols()));
  std::iota(contacts.begin(), contacts.end(), 0);
  if (contacts.size() <= kDrawnContacts) return contacts;
  std::vector<double> impulse;
  for (const int contact : contacts) impulse.push_back(-accumulated(motion, contact)[motion.count()]);
  std::stable_sort(contacts.begin(), contacts.end(), [&](int a, int b) {
    return impulse[static_cast<std::size_t>(a)] > impulse[static_cast<std::size_t>(b)];
  });
  contacts.resize(kDrawnContacts);
  std::sort(contacts.begin(), contacts.end());
  return contacts;
}

}  // namespace

std::vector<int> polyline(const Eigen::MatrixXd& signals, double tolerance) {
  // A signal that changes by round-off only counts as constant.
  const Eigen::RowVectorXd range = (signals.colwise().maxCoeff() - signals.colwise().minCoeff())
                                       .cwiseMax(kRoundOff * signals.cwiseAbs().colwise().maxCoeff());
  const int last = static_cast<int>(signals.rows()) - 1;
  std::vector<int> kept{0, last};
  std::vector<std::pair<int, int>> open{{0, last}};
  while (!open.empty()) {
    const auto [begin, end] = open.back();
    open.pop_back();
    int farthest = begin;
    double largest = tolerance;
    for (int i = begin + 1; i < end; ++i) {
      const double share = static_cast<double>(i - begin) / static_cast<double>(end - begin);
      for (Eigen::Index s = 0; s < signals.cols(); ++s) {
        const double line = (1.0 - share) * signals(begin, s) + share * signals(end, s);
        const double distance = std::abs(signals(i, s) - line);
        if (distance > largest * range[s]) {
          largest = distance / range[s];
          farthest = i;
        }
      }
    }
    if (farthest == begin) continue;
    kept.push_back(farthest);
    open.emplace_back(begin, farthest);
    open.emplace_back(farthest, end);
  }
  std::sort(kept.begin(), kept.end());
  return kept;
}

Waveforms draw_waveforms(const Motion& answer, const Motion* orbit, double tolerance) {
  Waveforms waveforms{.contacts = contacts_drawn(answer)};
  const int periods = orbit == nullptr ? answer.order : std::lcm(answer.order, orbit->order);
  waveforms.answer = draw(answer, waveforms.contacts, periods, tolerance);
  if (orbit != nullptr) waveforms.orbit = draw(*orbit, waveforms.contacts, periods, tolerance);
  return waveforms;
}

}  // namespace signorini
