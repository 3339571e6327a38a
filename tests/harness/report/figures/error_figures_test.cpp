#include <gtest/gtest.h>

#include "harness/report/figures/figures.hpp"
#include "harness/report/figures/gnuplot.hpp"
#include "tests/harness/sample_records.hpp"

namespace signorini::error_figures_test {
namespace {

TEST(WorkPrecisionFigure, KeepsTheCaseBesideEveryPoint) {
  const Evaluation evaluation(test::records_of_two_methods());
  const std::vector<Figure> figures = work_precision_figures(evaluation, "s1");
  ASSERT_EQ(figures.size(), 1U);
  EXPECT_EQ(figures[0].name, "s1-work-precision");
  EXPECT_NE(figures[0].data.find("1.000000e-02 1.000000e-03  # b[n=2]"), std::string::npos);
  EXPECT_EQ(figures[0].data.find("nan"), std::string::npos);
}

TEST(WorkPrecisionFigure, ShowsMethodsOfAnotherLawApartAndBoundsHollow) {
  std::vector<Record> records = test::records_of_two_methods();
  for (Record& record : records) {
    if (record.method == "b") record.law_matches_scene = false;
  }
  records[1].errors.x_l2 = 1e-15;
  const Evaluation evaluation(records);
  const std::vector<Figure> figures = work_precision_figures(evaluation, "s1");
  ASSERT_EQ(figures.size(), 2U);
  EXPECT_EQ(figures[0].data.find("# b,"), std::string::npos);
  EXPECT_EQ(figures[1].data.find("# a,"), std::string::npos);
  EXPECT_NE(figures[0].script.find(line_style(0).hollow), std::string::npos);
  EXPECT_EQ(figures[1].script.find(line_style(1).hollow), std::string::npos);
}

TEST(WorkPrecisionFigure, IsNoneWhereNobodySolvesTheScene) {
  std::vector<Record> records = test::records_of_two_methods();
  for (Record& record : records) record.status = Status::timeout;
  EXPECT_TRUE(work_precision_figures(Evaluation(records), "s1").empty());
}

/// Method a with errors of order 2, b with one resolution only.
std::vector<Record> harmonics() {
  std::vector<Record> records;
  for (const int n : {10, 20, 40})
    records.push_back(
        test::good_record("s1", "a", "harmonics=" + std::to_string(n), 1.0 / (n * n), 1e-3 * n));
  records.push_back(test::good_record("s1", "b", "harmonics=10", 1e-3, 1e-3));
  return records;
}

TEST(ConvergenceFigure, HasTheMethodsWithSeveralResolutionsOverTheirNumbers) {
  const Figure figure = convergence_figure(Evaluation(harmonics()), "s1");
  EXPECT_EQ(figure.name, "s1-convergence");
  EXPECT_NE(figure.data.find("# a, runs\n1.000000e+01 1.000000e-02  # a[harmonics=10]\n2.000000e+01"),
            std::string::npos)
      << figure.data;
  EXPECT_EQ(figure.data.find("# b"), std::string::npos);
  EXPECT_NE(figure.script.find("set object polygon"), std::string::npos);
  EXPECT_NE(figure.script.find("set label '40' at 4.000000e+01,"), std::string::npos);  // beside its mark
  EXPECT_TRUE(convergence_figure(Evaluation(harmonics()), "s2").data.empty());
}

TEST(WorkPrecisionFigure, NamesEveryCurveOnceBesideThePanel) {
  const std::vector<Figure> figures = work_precision_figures(Evaluation(harmonics()), "s1");
  for (const char* name : {"set label 'a' at graph", "set label 'b' at graph"}) {
    const std::size_t at = figures[0].script.find(name);
    ASSERT_NE(at, std::string::npos) << figures[0].script;
    EXPECT_EQ(figures[0].script.find(name, at + 1), std::string::npos);
  }
}

TEST(ErrorFigures, AreUnderstoodByGnuplot) {
  const Evaluation evaluation(harmonics());
  EXPECT_NO_THROW((void)drawn(work_precision_figures(evaluation, "s1").front(), "svg"));
  EXPECT_NO_THROW((void)drawn(convergence_figure(evaluation, "s1"), "svg"));
}

TEST(WorkPrecisionFigure, NamesCurvesBelowThePanelInASingleColumn) {
  const Evaluation evaluation(test::records_of_two_methods());
  const Figure usual = work_precision_figures(evaluation, "s1").at(0),
               narrow = work_precision_figures(evaluation, "s1", Column::single).at(0),
               broad = work_precision_figures(evaluation, "s1", Column::both).at(0);
  EXPECT_EQ(narrow.width, kSingleColumn);
  EXPECT_EQ(broad.width, kBothColumns);
  EXPECT_EQ(narrow.data, usual.data);
  EXPECT_NE(usual.script.find("set label 'b' at graph 1.06"), std::string::npos) << usual.script;
  EXPECT_EQ(narrow.script.find("graph 1.06"), std::string::npos);
  EXPECT_NE(narrow.script.find("title 'b'"), std::string::npos);
  for (const char* format : {"svg", "pdf", "png"}) EXPECT_NO_THROW((void)drawn(narrow, format));
}
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
}  // namespace signorini::error_figures_test
