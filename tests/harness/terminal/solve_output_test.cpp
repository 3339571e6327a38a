// What `solve` prints, of records made by hand.

#include "harness/terminal/solve_output.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "tests/harness/sample_records.hpp"

namespace signorini::solve_output_test {
namespace {

Record record_with_contacts(int contacts) {
  Record record = test::full_record();
  record.motion = MotionSummary{};
  for (int c = 0; c < contacts; ++c) {
    record.motion->x.push_back({.mean = 0.5, .min = -1.0, .max = 2.0, .amplitude = 1.5});
    record.motion->x.back().harmonics = {{.frequency = 3.0, .amplitude = 1.25, .phase = 0.5}};
    record.motion->impacts.push_back({.contact = c, .time = 0.1 * c, .impulse = -1.0 - c});
    record.motion->contact_phases.push_back({.contact = c, .begin = 0.1, .end = 0.6, .impulse = -0.25});
  }
  return record;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

TEST(AnswerText, OfManyContactsIsOneScreenOfThoseThatPushHardest) {
  Record record = record_with_contacts(100);
  record.motion->u.push_back({.dof = 7, .max = 3.0});
  const std::string text = answer_text(record, {}) + judgement_text(record, {});
  const std::vector<std::string> lines = lines_of(text);
  EXPECT_LE(lines.size(), 40U) << text;
  for (const std::string& line : lines) EXPECT_LE(line.size(), 80U) << line;
  EXPECT_NE(text.find("\n  contact 99 "), std::string::npos) << text;
  EXPECT_EQ(text.find("\n  contact 50 "), std::string::npos) << text;
  EXPECT_NE(text.find("and 97 more (--verbose)"), std::string::npos) << text;
  EXPECT_NE(text.find("\n  u[7]"), std::string::npos) << text;
}

TEST(AnswerText, HasEveryContactWhereAllIsAskedFor) {
  const std::string text = answer_text(record_with_contacts(100), {.verbose = true});
  EXPECT_NE(text.find("\n  contact 50 "), std::string::npos);
  EXPECT_EQ(text.find("more (--verbose)"), std::string::npos);
  EXPECT_NE(text.find("\n  fine\n"), std::string::npos) << "the message of the method";
}

TEST(AnswerText, PrintsRoundOffAsNothing) {
  Record record = record_with_contacts(1);
  record.motion->x[0].mean = 1e-16;
  record.motion->x[0].harmonics = {{.frequency = 3.0, .amplitude = 1.25, .phase = 0.0},
                                   {.frequency = 6.0, .amplitude = 1e-15, .phase = 1.0}};
  const std::string text = answer_text(record, {});
  EXPECT_NE(text.find("            -1             2             0\n"), std::string::npos) << text;
  EXPECT_NE(text.find("             3          1.25             0\n"), std::string::npos) << text;
  EXPECT_NE(text.find("             6             0             -\n"), std::string::npos) << text;
}

TEST(AnswerText, WithoutAnAnswerSaysWhy) {
  Record record;
  record.case_id = "a/b";
  record.status = Status::not_converged;
  record.message = "the residual stays";
  EXPECT_EQ(answer_text(record, {}), "a/b: not-converged\n  the residual stays\n");
  EXPECT_EQ(answer_text(record, {.colour = true}),
            "a/b: \033[31mnot-converged\033[0m\n  the residual stays\n");
}

TEST(JudgementText, NamesMultipliersByTheirSizeAndOneOfEachPair) {
  Record record = test::full_record();
  record.certificate.floquet = {{0.1, 0.0}, {-0.5, -0.5}, {-0.5, 0.5}};
  const std::string text = judgement_text(record, {});
  EXPECT_NE(text.find("\nmultipliers           -0.5 +- 0.5i, 0.1\n"), std::string::npos) << text;
}

TEST(AnswerText, SaysInItsSecondLineWhetherTheMotionIsStable) {
  Record record = test::full_record();
  record.status = Status::converged;
  record.certificate.status = CertificateStatus::certified;
  record.certificate.undefined.clear();
  record.certificate.floquet = {{0.1, 0.0}, {-0.3, -0.4}, {-0.3, 0.4}};
  const auto second = [&] { return lines_of(answer_text(record, {}))[1]; };
  record.certificate.stable = true;
  EXPECT_EQ(second(), "stability             stable, largest Floquet multiplier 0.5 (modulus)");
  record.certificate.stable = false;
  EXPECT_EQ(second().rfind("stability             unstable, largest Floquet multiplier 0.5 (modulus); ", 0),
            0U)
      << second();
  record.certificate.stable.reset();
  record.certificate.floquet.reset();
  EXPECT_EQ(second(), "stability             not determined: the multipliers do not tell");
  record.certificate.undefined = "depends on the order";
  EXPECT_EQ(second(), "stability             undefined: depends on the order");
  record.certificate = {.status = CertificateStatus::uncertified, .reason = "no time"};
  EXPECT_EQ(second(), "stability             not determined: no time");
}

TEST(AnswerText, NamesTheOptionThatGivesAMethodMoreTime) {
  Record record;
  record.case_id = "a/b";
  record.status = Status::timeout;
  record.message = "the time is up";
  EXPECT_EQ(answer_text(record, {}), "a/b: timeout\n  the time is up\n  --timeout gives it more time\n");
  record.method = "exact-orbit";
  record.scene = "tube.toml";
  EXPECT_EQ(lines_of(answer_text(record, {})).back(),
            "  if it never repeats: `signorini motion tube.toml` tells what a machine does");
}

TEST(JudgementText, SaysWhetherTheOrbitIsReachedFromRest) {
  Record record = test::full_record();
  EXPECT_NE(judgement_text(record, {}).find("which is also reached from rest"), std::string::npos);
  record.certificate.same_orbit = false;
  EXPECT_NE(judgement_text(record, {}).find("another than the one reached from rest"), std::string::npos);
  record.certificate.same_orbit.reset();
  EXPECT_NE(judgement_text(record, {}).find("from rest: none)"), std::string::npos);
}

TEST(JudgementText, NamesTheOptionThatGivesMoreTime) {
  Record record = test::full_record();
  record.certificate = {.status = CertificateStatus::uncertified, .reason = "no time", .expired = true};
  EXPECT_NE(judgement_text(record, {}).find("no time; --certificate gives it more time"), std::string::npos);
  record.certificate.expired = false;
  EXPECT_EQ(judgement_text(record, {}).find("--certificate"), std::string::npos);
}

}  // namespace
}  // namespace signorini::solve_output_test
