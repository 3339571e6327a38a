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

namespace {

using Json = nlohmann::ordered_json;

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
  if (!repeat.times) {
    Json failure{{"message", repeat.message}, {"status", status_name(repeat.status)}};
    if (repeat.signal) failure["signal"] = *repeat.signal;
    return send(json_line(failure));
  }
  Json times{{"setup", repeat.times->setup}, {"solve", repeat.times->solve}, {"answer", repeat.answer}};
  if (repeat.times->first) times["first"] = *repeat.times->first;
  send(json_line(times));
}

void take_later_round(const ChildEnd& end, Record& record) {
  record.elapsed = record.elapsed.value_or(0.0) + end.seconds;
  const Json json = end.lines.empty() ? Json::object() : try_parse_json(end.lines.back());
  if (json.contains("setup")) {
    std::vector<TimedRound> rounds = record.seconds->rounds;
    rounds.push_back({.setup = json.at("setup"), .solve = json.at("solve")});
    if (json.contains("first")) rounds.back().first = json.at("first").get<double>();
    const std::optional<double> exchange = record.seconds->exchange;
    record.seconds = summarise(rounds);
    record.seconds->exchange = exchange;
    count_repeat(json.at("answer"), record);
    return;
  }
  if (json.contains("message")) {
    record.status = enum_from_name<Status>("status", json.at("status").get<std::string>());
    record.message = json.at("message");
    if (json.contains("signal")) record.signal = whole_number<int>("signal", json.at("signal"));
  } else {
    take_failure(end, record);
  }
  record.message = kRepeated + record.message;
  record.seconds.reset();
}

void take_failure(const ChildEnd& end, Record& record) {
  record.message = as_message(describe(end));
  switch (end.kind) {
    case ChildEnd::Kind::threw:
      record.status = Status::exception;
      record.message = as_message(end.detail);
      break;
    case ChildEnd::Kind::out_of_memory:
      record.status = Status::out_of_memory;
      break;
    case ChildEnd::Kind::timed_out:
    case ChildEnd::Kind::out_of_processor_time:
      record.status = Status::timeout;
      break;
    case ChildEnd::Kind::signalled:
      record.signal = end.code;
      record.status = Status::crashed;
      break;
    case ChildEnd::Kind::exited:
    case ChildEnd::Kind::flooded:
    case ChildEnd::Kind::finished:
    case ChildEnd::Kind::interrupted:
      record.status = Status::crashed;
      break;
  }
}

}  // namespace signorini
