#include "harness/run/round_messages.hpp"

#include <fmt/format.h>

#include <exception>
#include <span>
#include <vector>

#include "harness/judge/certificate.hpp"
#include "harness/records/json_fields.hpp"
#include "harness/records/record_check.hpp"
#include "harness/records/record_json.hpp"
#include "harness/run/trial.hpp"
#include "harness/text/json.hpp"

namespace signorini {

/// What the child of a later round sends.
void visit_fields(Either<RepeatedSolve> auto& repeat, auto&& field) {
  field(Field{"times", "s"}, repeat.times);
  field(Field{"answer"}, repeat.answer);
  field(Field{"message"}, repeat.message);
  field(Field{"status"}, repeat.status);
  field(Field{"signal"}, repeat.signal);
}

namespace {

using Json = nlohmann::ordered_json;

/// Of a case whose child ended so before there was an answer.
Status status_of(ChildEnd::Kind end) {
  switch (end) {
    case ChildEnd::Kind::threw:
      return Status::exception;
    case ChildEnd::Kind::out_of_memory:
      return Status::out_of_memory;
    case ChildEnd::Kind::timed_out:
    case ChildEnd::Kind::out_of_processor_time:
      return Status::timeout;
    default:
      return Status::crashed;
  }
}

/// What a child was doing when it died after the answer had arrived, for the message of its record.
const char* work_after(TrialStage last) {
  switch (last) {
    case TrialStage::solved:
      return kRepeated;
    case TrialStage::certified:
      return "in its clean-up: ";
    default:
      return "in the harness's check of its answer: ";
  }
}

/// A child that died after its answer had arrived. An answer whose check has died is nobody's: the check runs
/// in the method's process, whose memory the method may have spoilt. Only a certificate that takes too long
/// leaves the claim as it is, unproven: then its physics have been measured.
void take_late_end(const ReceivedRound& lines, const ChildEnd& end, Record& record) {
  if (end.kind == ChildEnd::Kind::finished) return;
  const auto last = static_cast<TrialStage>(lines.size() - 1);
  const bool checking = last == TrialStage::timed || last == TrialStage::measured;
  if (checking) {
    record.certificate.status = CertificateStatus::uncertified;
    record.certificate.reason = as_message("the harness's own check ended by " + describe(end));
    const bool late =
        end.kind == ChildEnd::Kind::timed_out || end.kind == ChildEnd::Kind::out_of_processor_time;
    if (late && last == TrialStage::measured) return;
  }
  take_failure(end, record);
  record.message = work_after(last) + record.message;
}

/// `blank` with what the lines say. A method that writes into its process's pipe costs its own case alone.
Record record_of(const Record& blank, std::span<const std::string> lines) {
  try {
    Json json = to_json(blank);
    for (const std::string& line : lines) json.update(parse_json(line));
    return record_from_json(json);
  } catch (const std::exception& error) {  // a BadRecord, or of JSON
    Record record = blank;
    record.status = Status::invalid_output;
    record.message = as_message(fmt::format("its process sent no record: {}", error.what()));
    return record;
  }
}

}  // namespace

FirstRoundSender::FirstRoundSender(const LineSender& send, const Record& blank)
    : send_(send), known_(to_json(blank)) {}

void FirstRoundSender::operator()(const Record& so_far) {
  Record rest = so_far;
  if (samples_sent_) rest.trajectory.reset();
  samples_sent_ = samples_sent_ || rest.trajectory;
  Json record = to_json(rest), changes = Json::object();
  for (auto& [key, value] : record.get_ref<Json::object_t&>()) {
    if (known_.contains(key) && known_[key] == value) continue;
    if (key != "trajectory") known_[key] = value;
    changes[key] = std::move(value);
  }
  send_(json_line(changes));
  ++sent_;
}

void FirstRoundSender::fill() {
  constexpr int kStages = static_cast<int>(TrialStage::certified) + 1;
  for (; sent_ < kStages; ++sent_) send_(json_line(Json::object()));
}

Record record_of_answer(const Record& blank, const std::string& line) { return record_of(blank, {&line, 1}); }

Record received_first_round(const Record& blank, const ReceivedRound& lines, const ChildEnd& end) {
  Record record = blank;
  if (lines.empty()) {
    take_failure(end, record);
  } else {
    record = record_of(blank, lines);
    take_late_end(lines, end, record);
    apply_verdict(record);
  }
  record.elapsed = end.seconds;
  return record;
}

void send_later_round(const RepeatedSolve& repeat, const LineSender& send) {
  send(json_line(write_fields(repeat)));
}

void take_later_round(const ChildEnd& end, Record& record) {
  record.elapsed = record.elapsed.value_or(0.0) + end.seconds;
  const Json json = end.lines.empty() ? Json() : try_parse_json(end.lines.back());
  RepeatedSolve repeat;
  bool told = json.contains("times") || json.contains("status");
  try {
    if (told) read_fields(json, repeat);
  } catch (const std::exception&) {  // not of ours: a method may write into its process's pipe
    told = false;
    repeat = {};
  }
  if (repeat.times) {
    std::vector<TimedRound> rounds = record.seconds->rounds;
    rounds.push_back(*repeat.times);
    const std::optional<double> exchange = record.seconds->exchange;
    record.seconds = summarise(rounds);
    record.seconds->exchange = exchange;
    return count_repeat(repeat.answer, record);
  }
  if (told) {
    record.status = repeat.status;
    record.message = repeat.message;
    record.signal = repeat.signal;
  } else {
    take_failure(end, record);
  }
  record.message = kRepeated + record.message;
  record.seconds.reset();
}

void take_failure(const ChildEnd& end, Record& record) {
  const bool threw = end.kind == ChildEnd::Kind::threw;
  record.status = status_of(end.kind);
  record.message = as_message(threw ? end.detail : describe(end));
  if (end.kind == ChildEnd::Kind::signalled) record.signal = end.code;
}

}  // namespace signorini
