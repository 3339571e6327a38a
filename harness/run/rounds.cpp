#include "harness/run/rounds.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "harness/interrupt.hpp"

namespace signorini {

namespace {

class SceneRounds {
 public:
  SceneRounds(Runner& runner, const Scene& scene, std::span<const Job> jobs,
              std::vector<std::optional<Record>> records, const Schedule& schedule, RoundObserver& observer)
      : runner_(runner),
        scene_(scene),
        jobs_(jobs),
        records_(std::move(records)),
        schedule_(schedule),
        observer_(observer) {}

  bool run() {
    for (int round = 0; round < runner_.limits().repetitions; ++round) run_round(round);
    return !interrupted();
  }

 private:
  /// A case that was begun in an earlier run may be some rounds ahead of the others.
  [[nodiscard]] bool is_due(const std::optional<Record>& record, int round) const {
    if (round == 0) return !record;
    return record && runner_.rounds_missing(*record) > 0 &&
           static_cast<int>(record->seconds->rounds.size()) <= round;
  }

  void run_round(int round) {
    std::vector<std::size_t> due = round_order(jobs_.size(), schedule_.seed, scene_.problem.name, round);
    std::erase_if(due, [&](std::size_t index) { return !is_due(records_[index], round); });
    // One by one where one runs at a time: each is announced before it begins.
    const std::size_t together = schedule_.parallel > 1 ? std::max<std::size_t>(1, due.size()) : 1;
    for (std::size_t i = 0; i < due.size() && !interrupted(); i += together)
      run_together(std::span(due).subspan(i, together), round);
  }

  void run_together(std::span<const std::size_t> indices, int round) {
    observer_.begins(indices.size() == 1 ? jobs_[indices.front()].planned_case->id
                                         : fmt::format("{}, round {}", scene_.problem.name, round + 1));
    std::vector<Job> jobs;
    for (const std::size_t index : indices) jobs.push_back(jobs_[index]);
    const TakeRecord take = [&](std::size_t k, Record record) { take_record(indices[k], std::move(record)); };
    if (round == 0) return runner_.run_first(scene_, jobs, schedule_.parallel, take);
    std::vector<Record> begun;
    for (const std::size_t index : indices) begun.push_back(*records_[index]);
    runner_.run_later(scene_, jobs, begun, schedule_.parallel, take);
  }

  void take_record(std::size_t index, Record record) {
    if (record.seconds && schedule_.together() > 1) record.seconds->jobs = schedule_.together();
    records_[index] = std::move(record);
    if (runner_.rounds_missing(*records_[index]) > 0) {
      observer_.round_done(index, *records_[index]);
    } else {
      observer_.case_done(index, *records_[index]);
    }
  }

  Runner& runner_;
  const Scene& scene_;
  std::span<const Job> jobs_;
  std::vector<std::optional<Record>> records_;
  Schedule schedule_;
  RoundObserver& observer_;
};

}  // namespace

bool run_rounds(Runner& runner, const Scene& scene, std::span<const Job> jobs,
                std::vector<std::optional<Record>> begun, const Schedule& schedule, RoundObserver& observer) {
  return SceneRounds(runner, scene, jobs, std::move(begun), schedule, observer).run();
}

}  // namespace signorini
