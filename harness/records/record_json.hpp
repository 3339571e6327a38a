#pragma once
// Records as JSON lines: every field of a record with its name, its unit, and whether it may be absent
// (docs/records.md has a row for each; a test compares the two), and the form of what is special: laws,
// options, rounds.

#include <array>
#include <string_view>

#include "harness/records/json_fields.hpp"
#include "harness/records/record.hpp"
#include "methods/curve.hpp"

namespace signorini {

/// Exactly the keys of docs/records.md, absent where a notion is; numbers that are not finite are absent.
nlohmann::ordered_json to_json(const Record& record);

/// Settings that a record of an earlier version does not hold are those in the name of its case.
/// \throws BadRecord
Record record_from_json(const nlohmann::ordered_json& json);

/// One key, the law's name, with its constant: {"restitution": 0.8}; of contacts of different laws "mixed", a
/// list of one for each.
template <>
struct JsonForm<RepresentedLaw> {
  static nlohmann::ordered_json write(const RepresentedLaw& law);  ///< of any law
  static RepresentedLaw read(const nlohmann::ordered_json& json);  ///< \throws BadRecord
};

/// The law of one contact likewise, with one number: {"penalty": 1e6}.
nlohmann::ordered_json contact_law_json(const ContactLaw& law);

/// The names in record files.
template <>
struct EnumNames<ResponseWay> {
  /// In order.
  static constexpr std::array<std::string_view, 3> values{"exact", "arc-length", "steps"};
};

void visit_fields(Either<LocatedPoint> auto& point, auto&& field) {
  field(required("kind"), point.kind);
  field(required("omega", "rad/s"), point.frequency);
  field(required("order"), point.order);
  field(Field{"amplitude", "m"}, point.amplitude);
}

void visit_fields(Either<CurveShares> auto& shares, auto&& field) {
  field(required("covered"), shares.covered);
  field(Field{"covered_stable"}, shares.covered_stable);
  field(required("false"), shares.false_share);
}

void visit_fields(Either<PointMatch> auto& match, auto&& field) {
  field(required("exact"), match.exact);
  field(Field{"omega", "rad/s"}, match.frequency);
}

void visit_fields(Either<CurveComparison> auto& comparison, auto&& field) {
  field(required("within_0.02"), comparison.close);
  field(required("within_0.05"), comparison.wide);
  field(required("exact_length"), comparison.exact_length);
  field(required("length"), comparison.length);
  field(required("right_length"), comparison.right_length);
  field(Field{"points", "", Presence::always}, comparison.points);
  field(Field{"invented", "", Presence::always}, comparison.invented);
}

void visit_fields(Either<DrawnBranch> auto& branch, auto&& field) {
  field(required("omega", "rad/s"), branch.frequency);
  field(required("amplitude", "m"), branch.amplitude);
  field(required("stable"), branch.stable);
  field(Field{"motion", "m"}, branch.motion);
  field(Field{"by_steps"}, branch.by_steps);
}

void visit_fields(Either<RecordedResponse> auto& response, auto&& field) {
  field(required("way"), response.question.way);
  field(required("from", "rad/s"), response.question.from);
  field(required("to", "rad/s"), response.question.to);
  field(required("orders"), response.question.orders);
  field(required("points"), response.points);
  field(Field{"comparison"}, response.comparison);
  field(Field{"located"}, response.located);
  field(Field{"open_ends"}, response.open_ends);
  field(Field{"branches"}, response.branches);
}

/// The value of an option: numbers keep their kind.
template <>
struct JsonForm<OptionValue> {
  static nlohmann::ordered_json write(const OptionValue& value);  ///< "auto" where the method chooses
  static OptionValue read(const nlohmann::ordered_json& json);    ///< \throws BadRecord
};

/// A pair, set-up and solve.
template <>
struct JsonForm<TimedRound> {
  static nlohmann::ordered_json write(const TimedRound& round);  ///< [set-up, solve], [..., first]
  static TimedRound read(const nlohmann::ordered_json& json);    ///< of two numbers or three
};

void visit_fields(Either<FamilyLevel> auto& level, auto&& field) {
  field(required("name"), level.family);
  field(required("parameter"), level.parameter);
  field(required("level"), level.level);
  field(required("severity"), level.severity);
  field(required("levels"), level.levels);
}

void visit_fields(Either<SceneInstance> auto& instance, auto&& field) {
  field(required("name"), instance.scene);
  field(required("seed"), instance.seed);
  field(required("number"), instance.number);
  field(required("values"), instance.values);
}

void visit_fields(Either<Work> auto& counts, auto&& field) {
  field(Field{"unknowns"}, counts.unknowns);
  field(Field{"iterations"}, counts.iterations);
  field(Field{"pivots"}, counts.pivots);
  field(Field{"rhs_evaluations"}, counts.rhs_evaluations);
  field(Field{"factorisations"}, counts.factorisations);
  field(Field{"points"}, counts.points);
}

void visit_fields(Either<WorkDone> auto& work, auto&& field) {
  visit_fields(work.counts, field);
  field(Field{"peak_memory_bytes", "bytes"}, work.peak_memory_bytes);
}

void visit_fields(Either<Seconds> auto& seconds, auto&& field) {
  field(required("median", "s"), seconds.median);
  field(required("min", "s"), seconds.min);
  field(required("mad", "s"), seconds.mad);
  field(required("repetitions"), seconds.repetitions);
  field(required("setup", "s"), seconds.setup);
  field(required("solve", "s"), seconds.solve);
  field(Field{"first", "s"}, seconds.first);
  field(Field{"unstable"}, seconds.unstable);
  field(Field{"rounds", "s"}, seconds.rounds);
  field(Field{"exchange", "s"}, seconds.exchange);
  field(Field{"jobs"}, seconds.jobs);
  field(Field{"unsteady"}, seconds.unsteady);
  field(Field{"load"}, seconds.load);
}

void visit_fields(Either<Repeats> auto& repeats, auto&& field) {
  field(required("solves"), repeats.solves);
  field(required("identical"), repeats.identical);
}

void visit_fields(Either<StageSeconds> auto& stages, auto&& field) {
  field(Field{"solve", "s"}, stages.solve);
  field(Field{"timing", "s"}, stages.timing);
  field(Field{"measures", "s"}, stages.measures);
  field(Field{"certificate", "s"}, stages.certificate);
}

void visit_fields(Either<OrbitEvent> auto& event, auto&& field) {
  field(required("time", "s"), event.time);
  field(required("contact"), event.contact);
  field(required("kind"), event.kind);
  field(Field{"value", "N s"}, event.value);
}

void visit_fields(Either<OrderOfImpacts> auto& order, auto&& field) {
  field(required("contacts"), order.contacts);
  field(required("largest"), order.largest);
}

void visit_fields(Either<Certificate> auto& certificate, auto&& field) {
  // An orbit without any event has an empty list; where there is no orbit, there is no list.
  const bool has_orbit = certificate.status == CertificateStatus::certified;
  field(required("status"), certificate.status);
  field(Field{"rule"}, certificate.rule);
  field(Field{"reason"}, certificate.reason);
  field(Field{"refutation"}, certificate.refutation);
  field(Field{"expired"}, certificate.expired);
  field(Field{"source"}, certificate.source);
  field(Field{"orbit"}, certificate.orbit);
  field(Field{"order"}, certificate.order);
  field(Field{"error_bar"}, certificate.error_bar);
  field(Field{"residual"}, certificate.residual);
  field(Field{"distance"}, certificate.distance);
  field(Field{"reference"}, certificate.reference);
  field(Field{"reference_reason"}, certificate.reference_reason);
  field(Field{"same_orbit"}, certificate.same_orbit);
  field(Field{"events", "", has_orbit ? Presence::always : Presence::unless_empty}, certificate.events);
  field(Field{"return_distance"}, certificate.return_distance);
  field(Field{"floquet"}, certificate.floquet);
  field(Field{"stable"}, certificate.stable);
  field(Field{"stability"}, certificate.stability);
  field(Field{"stability_reason"}, certificate.undefined);
  field(Field{"orders"}, certificate.orders);
}

void visit_fields(Either<Errors> auto& errors, auto&& field) {
  field(Field{"x_l2"}, errors.x_l2);
  field(Field{"x_max"}, errors.x_max);
  field(Field{"u_l2"}, errors.u_l2);
  field(Field{"velocity_l2"}, errors.velocity_l2);
  field(Field{"impulse"}, errors.impulse);
  field(Field{"force_l2"}, errors.force_l2);
  field(Field{"x_l2_scene"}, errors.x_l2_scene);
  field(Field{"x_worst"}, errors.x_worst);
  field(Field{"force"}, errors.force);
}

void visit_fields(Either<Physics> auto& physics, auto&& field) {
  field(Field{"penetration"}, physics.penetration);
  field(Field{"complementarity"}, physics.complementarity);
  field(Field{"energy_defect"}, physics.energy_defect);
  field(Field{"contact_ratio"}, physics.contact_ratio);
  field(Field{"energy_reason"}, physics.energy_reason);
  field(Field{"effective_restitution"}, physics.effective_restitution);
}

void visit_fields(Either<Impulse> auto& impulse, auto&& field) {
  field(required("contact"), impulse.contact);
  field(required("time", "s"), impulse.time);
  field(required("value", "N s"), impulse.value);
}

void visit_fields(Either<ContactEvent> auto& event, auto&& field) {
  field(required("kind"), event.kind);
  field(required("contact"), event.contact);
  field(required("time", "s"), event.time);
  field(Field{"impulse", "N s"}, event.impulse);
  field(Field{"push", "N s"}, event.push);
}

void visit_fields(Either<TrajectorySamples> auto& samples, auto&& field) {
  field(required("t", "s"), samples.t);
  field(required("x", "m"), samples.x);
  field(required("velocity", "m/s"), samples.velocity);
  field(required("force", "N"), samples.force);
  field(Field{"impulses", "", Presence::always}, samples.impulses);
  field(Field{"bandwidth"}, samples.bandwidth);
  field(Field{"events"}, samples.events);
  field(Field{"dofs"}, samples.dofs);
  field(Field{"u", "m"}, samples.u);
}

void visit_fields(Either<Harmonic> auto& harmonic, auto&& field) {
  field(required("frequency", "rad/s"), harmonic.frequency);
  field(required("amplitude", "m"), harmonic.amplitude);
  field(required("phase", "rad"), harmonic.phase);
}

void visit_fields(Either<DisplacementSummary> auto& displacement, auto&& field) {
  field(Field{"dof"}, displacement.dof);
  field(required("mean", "m"), displacement.mean);
  field(required("min", "m"), displacement.min);
  field(required("max", "m"), displacement.max);
  field(required("amplitude", "m"), displacement.amplitude);
  field(Field{"harmonics"}, displacement.harmonics);
}

void visit_fields(Either<ImpactSummary> auto& impact, auto&& field) {
  field(required("contact"), impact.contact);
  field(required("time", "s"), impact.time);
  field(Field{"speed_before", "m/s"}, impact.speed_before);
  field(Field{"speed_after", "m/s"}, impact.speed_after);
  field(required("impulse", "N s"), impact.impulse);
}

void visit_fields(Either<PhaseSummary> auto& phase, auto&& field) {
  field(required("contact"), phase.contact);
  field(required("begin", "s"), phase.begin);
  field(required("end", "s"), phase.end);
  field(required("impulse", "N s"), phase.impulse);
}

void visit_fields(Either<MotionSummary> auto& motion, auto&& field) {
  field(Field{"x"}, motion.x);
  field(Field{"u"}, motion.u);
  field(Field{"no_u"}, motion.no_u);
  field(Field{"impacts", "", Presence::always}, motion.impacts);
  field(Field{"contact_phases", "", Presence::always}, motion.contact_phases);
}

void visit_fields(Either<Waveform> auto& waveform, auto&& field) {
  field(required("t", "s"), waveform.t);
  field(required("x", "m"), waveform.x);
  field(required("velocity", "m/s"), waveform.velocity);
  field(required("force", "N"), waveform.force);
  field(required("impulse", "N s"), waveform.impulse);
}

void visit_fields(Either<Waveforms> auto& waveforms, auto&& field) {
  field(required("contacts"), waveforms.contacts);
  field(required("answer"), waveforms.answer);
  field(Field{"orbit"}, waveforms.orbit);
}

void visit_fields(Either<Record> auto& record, auto&& field) {
  field(Field{"case"}, record.case_id);
  field(Field{"key"}, record.key);
  field(required("scene"), record.scene);
  field(required("scene_sha256"), record.scene_sha256);
  field(Field{"family"}, record.family);
  field(Field{"instance"}, record.instance);
  field(required("method"), record.method);
  field(Field{"plugin"}, record.plugin);
  field(Field{"run"}, record.run);
  field(Field{"settings"}, record.settings);
  field(required("options"), record.options);
  field(Field{"same_equations_as"}, record.same_equations_as);
  field(required("status"), record.status);
  field(Field{"message"}, record.message);
  field(Field{"signal"}, record.signal);
  field(Field{"law"}, record.law);
  field(Field{"scene_law"}, record.scene_law);
  field(Field{"law_matches_scene"}, record.law_matches_scene);
  field(Field{"coordinates"}, record.coordinates);
  field(Field{"contacts"}, record.contacts);
  field(Field{"problem"}, record.problem);
  field(Field{"period", "s"}, record.period);
  field(Field{"motion"}, record.motion);
  field(Field{"residual"}, record.residual);
  field(Field{"condition"}, record.condition);
  field(Field{"work"}, record.work);
  field(Field{"seconds"}, record.seconds);
  field(Field{"not_timed"}, record.not_timed);
  field(Field{"answer"}, record.answer);
  field(Field{"repeats"}, record.repeats);
  field(Field{"elapsed", "s"}, record.elapsed);
  field(Field{"processor"}, record.processor);
  field(Field{"certificate", "", Presence::always}, record.certificate);
  field(Field{"errors"}, record.errors);
  field(Field{"physics"}, record.physics);
  field(Field{"trajectory"}, record.trajectory);
  field(Field{"waveforms"}, record.waveforms);
  field(Field{"response"}, record.response);
}

}  // namespace signorini
