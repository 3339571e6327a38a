#pragma once
// What the processes of a case send of its rounds, and what becomes of it in the record.

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "harness/isolation/isolation.hpp"
#include "harness/records/record.hpp"
#include "harness/run/trial.hpp"

namespace signorini {

/// In the child of a first round: after each stage of the trial, sends the keys of the record that the stage
/// has added or changed. The samples of the trajectory, most of a record, are written once: no stage changes
/// them after the one that has taken them.
class FirstRoundSender {
 public:
  /// \param blank  what the parent knows of the record already
  FirstRoundSender(const LineSender& send, const Record& blank);
  void operator()(const Record& so_far);
  /// Sends a line without a key for each stage that there was not.
  void fill();

 private:
  const LineSender& send_;
  int sent_ = 0;
  bool samples_sent_ = false;
  nlohmann::ordered_json known_;
};

/// In a child that runs several first rounds: sent between two of them.
inline constexpr std::string_view kRoundDone = "done";

/// In the parent: `blank` with what the first stage sent, the answer of the method before it is judged.
Record record_of_answer(const Record& blank, const std::string& line);

/// What the stages of a first round have sent, a line each.
using ReceivedRound = std::vector<std::string>;

/// In the parent: `blank` with all that the stages sent, its verdict, and the failure of a child that ended
/// early.
Record received_first_round(const Record& blank, const ReceivedRound& lines, const ChildEnd& end);

/// In the child of a later round: sends its times, or why there are none.
void send_later_round(const RepeatedSolve& repeat, const LineSender& send);

/// In the parent: adds a later round's times to the record; its failure is the failure of the case.
void take_later_round(const ChildEnd& end, Record& record);

/// Status, signal and message of a case whose child ended before there was an answer.
void take_failure(const ChildEnd& end, Record& record);

}  // namespace signorini
