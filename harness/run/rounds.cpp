#include "harness/run/rounds.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "harness/files.hpp"
#include "harness/interrupt.hpp"
#include "harness/run/latin_square.hpp"

namespace signorini {

namespace {

/// A scene's cases come in the same order whatever else runs, in a shard or not.
std::uint64_t scene_seed(std::uint64_t seed, const Scene& scene) {
  constexpr std::size_t kDigits = 16;
  constexpr int kHexadecimal = 16;
  const std::string hash = sha256(fmt::format("{} {}", seed, scene.problem.name));
  return std::stoull(hash.substr(0, kDigits), nullptr, kHexadecimal);
}

class SceneRounds {
 public:
  SceneRounds(Runner& runner, const Scene& scene, std::span<const Job> jobs,
              std::vector<std::optional<Record>> records, const Schedule& schedule, const RoundEvents& events)
      : runner_(runner),
        scene_(scene),
        jobs_(jobs),
        records_(std::move(records)),
        schedule_(schedule),
        events_(events),
        square_(jobs.size(), scene_seed(schedule.seed, scene)) {}

  bool run() {
    run_row(square_.row(0), 0, [&](std::size_t i) { return !records_[i].has_value(); });
    for (int round = 1; round < runner_.limits().repetitions; ++round) {
      run_row(square_.row(static_cast<std::size_t>(round)), round,
              [&](std::size_t i) { return records_[i] && due(*records_[i], round); });
    }
    return !interrupted();
  }

 private:
  /// A case that was begun in an earlier run may be some rounds ahead of the others.
  [[nodiscard]] bool due(const Record& record, int round) const {
    return runner_.rounds_missing(record) > 0 && static_cast<int>(record.seconds->rounds.size()) <= round;
  }

  template <class Wanted>
  void run_row(const std::vector<std::size_t>& order, int round, const Wanted& wanted) {
    std::vector<std::size_t> row;
    std::copy_if(order.begin(), order.end(), std::back_inserter(row), wanted);
    // One by one where one runs at a time: each is announced before it begins.
    const std::size_t together = schedule_.parallel > 1 ? std::max<std::size_t>(1, row.size()) : 1;
    for (std::size_t i = 0; i < row.size() && !interrupted(); i += together) {
      run_together(std::span(row).subspan(i, together), round);
    }
  }

  void run_together(std::span<const std::size_t> indices, int round) {
    if (events_.begin) {
      events_.begin(indices.size() == 1 ? jobs_[indices.front()].run->id
                                        : fmt::format("{}, round {}", scene_.problem.name, round + 1));
    }
    std::vector<Job> jobs;
    for (const std::size_t index : indices) jobs.push_back(jobs_[index]);
    const TakeRecord take = [&](std::size_t k, Record record) { take_record(indices[k], std::move(record)); };
    if (round == 0) {
      runner_.run_first(scene_, jobs, schedule_.parallel, take);
      return;
    }
    std::vector<Record> begun;
    for (const std::size_t index : indices) begun.push_back(*records_[index]);
    runner_.run_later(scene_, jobs, begun, schedule_.parallel, take);
  }

  void take_record(std::size_t index, Record record) {
    if (record.seconds && schedule_.together() > 1) record.seconds->jobs = schedule_.together();
    records_[index] = std::move(record);
    const auto& tell = runner_.rounds_missing(*records_[index]) > 0 ? events_.unfinished : events_.complete;
    if (tell) tell(index, *records_[index]);
  }

  Runner& runner_;
  const Scene& scene_;
  std::span<const Job> jobs_;
  std::vector<std::optional<Record>> records_;
  Schedule schedule_;
  const RoundEvents& events_;
  LatinSquare square_;
};

}  // namespace

bool run_rounds(Runner& runner, const Scene& scene, std::span<const Job> jobs,
                std::vector<std::optional<Record>> begun, const Schedule& schedule,
                const RoundEvents& events) {
  return SceneRounds(runner, scene, jobs, std::move(begun), schedule, events).run();
}

}  // namespace signorini
