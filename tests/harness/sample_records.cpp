#include "tests/harness/sample_records.hpp"

#include "harness/report/formats/formats.hpp"

namespace signorini::test {

namespace {

MotionSummary full_motion() {
  const DisplacementSummary displacement{.mean = 0.5,
                                         .min = -1.0,
                                         .max = 2.0,
                                         .amplitude = 1.5,
                                         .harmonics = {{.frequency = 3.0, .amplitude = 1.25, .phase = -0.5}}};
  MotionSummary motion{
      .x = {displacement},
      .u = {displacement},
      .no_u = "because",
      .impacts = {{.contact = 0, .time = 0.25, .speed_before = 1.0, .speed_after = -0.5, .impulse = -2.0}},
      .contact_phases = {{.contact = 0, .begin = 0.5, .end = 1.0, .impulse = -0.25}}};
  motion.u.front().dof = 4;
  return motion;
}

Waveforms full_waveforms() {
  const Waveform waveform{.t = {0.0, 2.0},
                          .x = {{0.5, 0.5}},
                          .velocity = {{0.0, 0.0}},
                          .force = {{-1.0, -1.0}},
                          .impulse = {{0.0, -2.0}}};
  return Waveforms{.contacts = {0}, .answer = waveform, .orbit = waveform};
}

Errors full_errors() {
  return {.x_l2 = 0.125,
          .x_max = 0.2,
          .u_l2 = 0.3,
          .velocity_l2 = 0.4,
          .impulse = 0.5,
          .force_l2 = 0.55,
          .x_worst = 0.13,
          .force = 0.45,
          .x_l2_scene = 0.6};
}

}  // namespace

Record full_record() {
  Record record = good_record("scene-a", "method-a", "n=1", 0.125, 0.5);
  record.message = "fine";
  record.plugin = "01ab";
  record.problem = "fedcba9876543210";
  record.signal = 11;
  record.residual = 1e-12;
  record.condition = 1e3;
  record.not_timed = "it was";
  record.answer = "0123456789abcdef";
  record.repeats = Repeats{.solves = 7, .identical = 6};
  record.options = {{"n", 1L}, {"tolerance", 1e-9}};
  record.same_equations_as = "method-b";
  record.work.counts = {
      .unknowns = 1, .iterations = 2, .pivots = 3, .rhs_evaluations = 4, .factorisations = 5, .points = 7};
  record.work.peak_memory_bytes = 6;
  record.elapsed = 1.5;
  record.processor = {.solve = 0.125, .timing = 0.25, .measures = 0.0625, .certificate = 0.5};
  record.seconds->unstable = false;
  record.seconds->rounds = {{0.1, 0.4, 0.75}, {0.125, 0.375}};
  record.seconds->first = 0.75;
  record.seconds->jobs = 2;
  record.seconds->exchange = 0.25;
  record.seconds->unsteady = false;
  record.seconds->load = 0.5;
  record.coordinates = 3;
  record.contacts = 1;
  record.certificate.rule = kCertificateRule;
  record.certificate.reason = "because";
  record.certificate.reference_reason = "none";
  record.certificate.residual = 1e-13;
  record.certificate.events = {
      {.time = 0.5, .contact = 0, .kind = ContactEvent::Kind::impact, .value = -1.0}};
  record.certificate.floquet = {{0.5, 0.25}};
  record.certificate.stable = true;
  record.errors = full_errors();
  record.physics = {.penetration = 0.1,
                    .complementarity = 0.2,
                    .energy_defect = 0.3,
                    .contact_ratio = 0.4,
                    .energy_reason = "because",
                    .effective_restitution = {0.9, 1.0}};
  record.trajectory =
      TrajectorySamples{.t = {0.0, 0.5},
                        .x = {{1.0, 2.0}},
                        .velocity = {{3.0, 4.0}},
                        .force = {{-1.0, 0.0}},
                        .impulses = {{.contact = 0, .time = 0.25, .value = -2.0}},
                        .bandwidth = 10,
                        .events = {{{.kind = ContactEvent::Kind::impact, .time = 0.25, .impulse = -2.0},
                                    {.kind = ContactEvent::Kind::open, .time = 0.5, .push = -0.5}}},
                        .dofs = {4},
                        .u = {{0.25, -0.25}}};
  record.motion = full_motion();
  record.waveforms = full_waveforms();
  return record;
}

Record good_record(const std::string& scene, const std::string& method, const std::string& resolution,
                   double error, double seconds) {
  Record record;
  record.case_id = scene + "/" + method + "[" + resolution + "]";
  record.settings = parse_case_name(record.case_id).settings;
  record.key = "key of " + record.case_id;
  record.scene = scene;
  record.scene_sha256 = "abc";
  record.method = method;
  record.status = Status::converged;
  record.law = Restitution{1.0};
  record.scene_law = Restitution{1.0};
  record.law_matches_scene = true;
  record.period = 2.0;
  record.seconds = Seconds{.median = seconds,
                           .min = 0.9 * seconds,
                           .mad = 0.01 * seconds,
                           .repetitions = 3,
                           .setup = 0.1 * seconds,
                           .solve = 0.9 * seconds};
  record.errors.x_l2 = error;
  record.physics.energy_defect = 1e-3;
  record.work.counts.pivots = 12;
  record.certificate.status = CertificateStatus::certified;
  record.certificate.source = "shooting from the answer";
  record.certificate.orbit = "0a1b2c3d";
  record.certificate.order = 1;
  record.certificate.error_bar = 1e-12;
  record.certificate.distance = error;
  record.certificate.reference = "0a1b2c3d";
  record.certificate.same_orbit = true;
  return record;
}

std::vector<Record> records_of_every_status() {
  std::vector<Record> records{good_record("scene-a", "method-a", "n=1", 0.125, 0.5)};
  Record uncertified = good_record("scene-a", "method-a", "n=2", 0.0, 0.5);
  uncertified.errors = {};
  uncertified.certificate = {.status = CertificateStatus::uncertified, .reason = "Newton's method failed"};
  records.push_back(uncertified);
  Record inaccurate = good_record("scene-a", "method-a", "n=3", 0.0, 1e-6);
  inaccurate.status = Status::inaccurate;
  inaccurate.message = "penetrates the stop";
  inaccurate.errors = {};
  inaccurate.certificate = {.status = CertificateStatus::uncertified, .reason = "far away"};
  records.push_back(inaccurate);
  for (const Status status :
       {Status::not_converged, Status::not_applicable, Status::timeout, Status::out_of_memory,
        Status::crashed, Status::exception, Status::invalid_output}) {
    Record record;
    record.scene = "scene-a";
    record.method = "method-a";
    record.settings = {{"ends", std::string(status_name(status))}};
    record.case_id = "scene-a/" + resolution_of(record);
    record.key = record.case_id;
    record.status = status;
    record.message = "because of " + std::string(status_name(status));
    record.certificate.reason = "there is no answer to certify";
    records.push_back(record);
  }
  return records;
}

std::vector<Record> records_of_a_run() {
  std::vector<Record> records = records_of_every_status();
  for (const char* scene : {"scene-b", "scene-c"}) {
    for (const char* method : {"method-b", "method-c"}) {
      records.push_back(good_record(scene, method, "n=1", 0.1, 1e-3));
      records.push_back(good_record(scene, method, "n=2", 1e-3, 1e-2));
      records.back().waveforms = full_record().waveforms;
    }
  }
  records.back().law_matches_scene = false;
  return records;
}

std::vector<Record> records_of_two_methods() {
  std::vector<Record> records;
  for (const char* scene : {"s1", "s2"}) {
    for (const char* method : {"a", "b"}) {
      records.push_back(good_record(scene, method, "n=1", 0.1, 1e-3));
      records.push_back(good_record(scene, method, "n=2", 1e-3, 1e-2));
    }
  }
  return records;
}

RunFolder part_of_a_run(const std::string& path, const std::vector<std::string>& resolutions) {
  RunFolder run{.path = path};
  run.manifest = {{"suite", "quick"},
                  {"date", path},
                  {"limits", {{"timeout_s", 1.0}}},
                  {"jobs", 1},
                  {"build", {{"commit", "abc"}, {"sources", {{"common", "1"}}}}},
                  {"machine", {{"cpu", "x"}, {"processors", 2}, {"load", {0.0}}}}};
  for (const std::string& resolution : resolutions) {
    run.records.push_back(entry_of(good_record("s", "m", resolution, 0.1, 0.1)));
    run.plan.push_back({run.records.back().key, run.records.back().case_id, "m"});
  }
  return run;
}

CaseResults results_of(const std::vector<Record>& records) {
  CaseResults results;
  for (const Record& record : records) results.add(record);
  return results;
}

std::string csv_text(const Evaluation& evaluation) {
  std::string text;
  csv_report(evaluation, [&](std::string_view piece) { text += piece; });
  return text;
}

std::string measures_text(const Evaluation& evaluation) {
  std::string text;
  measures_csv(evaluation, [&](std::string_view piece) { text += piece; });
  return text;
}

}  // namespace signorini::test
