#include "harness/report/page/page.hpp"

#include <gtest/gtest.h>
#include <openssl/evp.h>
#include <zlib.h>

#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>
#include <string>

#include "harness/report/formats/screen.hpp"
#include "harness/report/page/page_shell.hpp"
#include "harness/report/sections/sections.hpp"
#include "tests/harness/sample_records.hpp"

namespace signorini::page_test {
namespace {

using Json = nlohmann::ordered_json;

std::string page_of(const Evaluation& evaluation, const Json& manifest = {}) {
  return html_page("a & b", manifest, evaluation, sections_of(evaluation));
}

/// The data in a page, unpacked as a browser does it.
Json data_in(const std::string& page) {
  const std::string begin = "id=\"data\">";
  const std::size_t from = page.find(begin) + begin.size(), to = page.find('<', from);
  std::string bytes(to - from, '\0'), text(32U << 20U, '\0');
  EVP_DecodeBlock(reinterpret_cast<unsigned char*>(bytes.data()),
                  reinterpret_cast<const unsigned char*>(&page[from]), static_cast<int>(to - from));
  uLongf size = text.size();
  EXPECT_EQ(uncompress(reinterpret_cast<Bytef*>(text.data()), &size,
                       reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()),
            Z_OK);
  return Json::parse(text.substr(0, size));
}

TEST(HtmlPage, NeedsNothingButItself) {
  std::string page = page_of(Evaluation(test::records_of_a_run()));
  EXPECT_EQ(page.rfind("<!DOCTYPE html>", 0), 0U);
  EXPECT_NE(page.find("<h1>a &amp; b</h1>"), std::string::npos);
  // D3 names the namespaces of SVG and MathML, which nothing is loaded from.
  page.erase(page.find(kChartLibrary), kChartLibrary.size());
  for (const char* outside : {"http://", "https://", "src=\"", "@import", "<link rel=\"stylesheet"})
    EXPECT_EQ(page.find(outside), std::string::npos) << outside;
}

TEST(HtmlPage, AllowsItsOwnTwoScriptsAlone) {
  const std::string page = page_of(Evaluation(test::records_of_a_run()));
  const std::string policy =
      "default-src 'none'; base-uri 'none'; form-action 'none'; img-src data:; style-src "
      "'unsafe-inline'; script-src " +
      script_source(kChartLibrary) + " " + script_source(kPageScript) + "\"";
  EXPECT_NE(page.find(policy), std::string::npos);
  for (const std::string_view script : {kChartLibrary, kPageScript})
    EXPECT_NE(page.find("<script>" + std::string(script) + "</script>"), std::string::npos);
  EXPECT_EQ(page.find(" onclick="), std::string::npos);
}

TEST(HtmlPage, HoldsTheRecordBehindEveryLink) {
  const Evaluation evaluation(test::records_of_a_run());
  const std::string page = page_of(evaluation);
  const Json data = data_in(page);
  ASSERT_EQ(data["records"].size(), evaluation.results().size());
  for (std::size_t i = 0; i < data["records"].size(); ++i) {
    const Json record = Json::parse(data["records"][i].get<std::string>());
    EXPECT_EQ(record["case"], evaluation.results()[i].case_id);
    EXPECT_EQ(data["cases"][i], record["case"]);
    EXPECT_FALSE(record.contains("waveforms"));  // left to the figures
  }
  std::size_t links = 0;
  const std::regex link("href=\"#record-([0-9]+)\"");
  for (std::sregex_iterator at(page.begin(), page.end(), link), end; at != end; ++at, ++links) {
    const std::size_t number = std::stoul((*at)[1]);
    EXPECT_GE(number, 1U);
    EXPECT_LE(number, evaluation.results().size());
  }
  EXPECT_GE(links, evaluation.results().size());
}

TEST(HtmlPage, OpensWithTheVerdictOfTheScreen) {
  const Evaluation evaluation(test::records_of_a_run());
  const std::string page = page_of(evaluation),
                    screen = screen_report(evaluation, {.folder = "r", .program = "s"});
  const std::regex caption("<caption>([^<]*)</caption>");
  int groups = 0;
  for (std::sregex_iterator at(page.begin(), page.end(), caption), end; at != end; ++at, ++groups)
    EXPECT_NE(screen.find("\n" + (*at)[1].str() + "\n"), std::string::npos) << (*at)[1];
  EXPECT_GT(groups, 0);
  EXPECT_NE(page.find("<p>" + counts_line(evaluation) + "</p>"), std::string::npos);
}

TEST(HtmlPage, NamesWhatTheManifestHolds) {
  const Evaluation evaluation(test::records_of_a_run());
  EXPECT_NE(page_of(evaluation).find("The run has no manifest."), std::string::npos);
  EXPECT_NE(
      page_of(evaluation, {{"suite", "quick"}, {"machine", {{"processors", 2}}}})
          .find("<dl><div><dt>suite</dt><dd>quick</dd></div><div><dt>processors</dt><dd>2</dd></div></dl>"),
      std::string::npos);
}

TEST(HtmlPage, ShowsTheVerdictThenFiguresThenTablesThenWhereItComesFrom) {
  const std::string page = page_of(Evaluation(test::records_of_a_run()));
  std::size_t last = 0;
  for (const char* id :
       {"verdict", "side-by-side", "summary", "scene-scene-b", "scenes", "cases", "otherwise", "about"}) {
    const std::size_t place = page.find(" id=\"" + std::string(id) + "\"><h");
    ASSERT_NE(place, std::string::npos) << id;
    EXPECT_GT(place, last) << id;
    last = place;
  }
  const std::size_t repeats = page.find("<section id=\"repeats\">");
  EXPECT_TRUE(repeats == std::string::npos || repeats > last);
}

TEST(HtmlPage, IsWholeForARunWithoutRecords) {
  const std::string page = page_of(Evaluation({}));
  EXPECT_NE(page.find("No scene of this run has a contact whose law is known."), std::string::npos);
  EXPECT_EQ(data_in(page)["cases"], Json::array());
}

}  // namespace
}  // namespace signorini::page_test
