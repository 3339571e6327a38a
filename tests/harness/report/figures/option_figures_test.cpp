#include <gtest/gtest.h>

#include "harness/report/figures/figures.hpp"
#include "harness/report/figures/gnuplot.hpp"
#include "tests/harness/sample_records.hpp"

namespace signorini::option_figures_test {
namespace {

/// At three resolutions and four stiffnesses, of which the softest is not certified.
std::vector<Record> penalties() {
  std::vector<Record> records;
  for (const char* harmonics : {"10", "40", "160"}) {
    for (const char* penalty : {"1e3x", "10x", "100x", "1e4x"}) {
      Record record = test::good_record(
          "s1", "p", std::string("harmonics=") + harmonics + ",penalty=" + penalty, 1e-2, 1.0);
      record.certificate.distance = 1.0 / std::stod(penalty);
      if (penalty == std::string("10x")) record.certificate.status = CertificateStatus::uncertified;
      records.push_back(record);
    }
  }
  return records;
}

TEST(OptionFigures, HaveACurveForEachResolutionOverTheConstant) {
  const std::vector<Figure> figures = option_figures(Evaluation(penalties()), "s1");
  ASSERT_EQ(figures.size(), 1U);
  EXPECT_EQ(figures[0].name, "s1-penalty");
  const std::string& data = figures[0].data;
  for (const char* harmonics : {"10", "40", "160"}) {
    const std::string name = std::string("# p[harmonics=") + harmonics + "]";
    EXPECT_NE(data.find(name + ", curve\n1.000000e+01 1.000000e-01\n1.000000e+02 1.000000e-02\n"),
              std::string::npos)
        << data;
    EXPECT_NE(data.find(name + ", runs not certified\n1.000000e+01 1.000000e-01  # p["), std::string::npos)
        << data;
    EXPECT_NE(data.find(name + ", runs\n1.000000e+02 1.000000e-02  # p["), std::string::npos) << data;
  }
  EXPECT_NE(figures[0].script.find("penalty, in units of its scale"), std::string::npos);
  EXPECT_NO_THROW((void)drawn(figures[0], "svg"));
}

TEST(OptionFigures, LeaveOutAnswersUnderAnotherLawAndThoseWithoutAnOrbit) {
  std::vector<Record> records = penalties();
  records[0].law_matches_scene = false;
  records[1].certificate.distance = std::nullopt;
  const std::vector<Figure> figures = option_figures(Evaluation(records), "s1");
  ASSERT_EQ(figures.size(), 1U);
  EXPECT_EQ(figures[0].data.find("harmonics=10]"), std::string::npos) << "two points are no curve";
  EXPECT_NE(figures[0].data.find("harmonics=40]"), std::string::npos);
}

TEST(OptionFigures, AreNoneOfOptionsWithoutAScale) {
  std::vector<Record> records;
  for (const char* c : {"0.1", "1", "10"})
    records.push_back(test::good_record("s1", "m", std::string("harmonics=40,c=") + c, 1e-2, 1.0));
  EXPECT_TRUE(option_figures(Evaluation(records), "s1").empty());
}

}  // namespace
}  // namespace signorini::option_figures_test
