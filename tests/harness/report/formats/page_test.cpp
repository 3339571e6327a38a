#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "harness/report/formats/formats.hpp"
#include "harness/report/sections/sections.hpp"
#include "tests/harness/sample_records.hpp"

namespace signorini {
namespace {

TEST(HtmlPage, NeedsNothingButItself) {
  const Evaluation evaluation(test::records_of_a_run());
  const std::string page =
      html_page("a & b", {{"compiler", "GNU"}}, evaluation, sections_of(evaluation), {}, {});
  EXPECT_EQ(page.rfind("<!DOCTYPE html>", 0), 0U);
  for (const char* outside : {"http://", "https://", "src=\"/", "@import", "url("})
    EXPECT_EQ(page.find(outside), std::string::npos) << outside;
  EXPECT_NE(page.find("<h1>a &amp; b</h1>"), std::string::npos);
}

TEST(HtmlPage, HoldsTheRecordBehindEveryLink) {
  const Evaluation evaluation(test::records_of_a_run());
  const std::string page = html_page("run", {}, evaluation, sections_of(evaluation), {}, {});
  std::size_t links = 0;
  const std::string link = "href=\"#record-";
  for (std::size_t at = page.find(link); at != std::string::npos; at = page.find(link, at + 1), ++links) {
    const std::size_t begin = at + link.size() - std::string("record-").size();
    const std::string id = page.substr(begin, page.find('"', begin) - begin);
    EXPECT_NE(page.find("<details id=\"" + id + "\">"), std::string::npos) << id;
  }
  EXPECT_GE(links, evaluation.records().size());
  EXPECT_NE(page.find("&quot;case&quot;: &quot;scene-b/method-b[n=1]&quot;"), std::string::npos);
}

TEST(HtmlPage, NamesWhatTheManifestHolds) {
  const Evaluation evaluation(test::records_of_a_run());
  const auto page = [&](const nlohmann::ordered_json& manifest) {
    return html_page("run", manifest, evaluation, {}, {}, {});
  };
  EXPECT_NE(page({}).find("<dl></dl>"), std::string::npos);
  EXPECT_NE(
      page({{"suite", "quick"}, {"machine", {{"processors", 2}}}})
          .find("<dl><div><dt>suite</dt><dd>quick</dd></div><div><dt>processors</dt><dd>2</dd></div></dl>"),
      std::string::npos);
}

TEST(HtmlPage, ShowsOverviewsThenScenesThenTheLongTables) {
  const Evaluation evaluation(test::records_of_a_run());
  const std::vector<SceneFigures> scenes{{.scene = "scene-b"}};
  const std::string page = html_page("run", {}, evaluation, sections_of(evaluation), scenes, {});
  const auto place = [&](const std::string& id) { return page.find("<section id=\"" + id + "\">"); };
  const std::size_t scene = page.find("<section class=\"scene\" id=\"scene-scene-b\">");
  ASSERT_NE(scene, std::string::npos);
  EXPECT_LT(place("summary"), place("scenes"));
  EXPECT_LT(place("scenes"), scene);
  EXPECT_LT(scene, place("cases"));
  EXPECT_LT(place("cases"), place("otherwise"));
  EXPECT_LT(place("otherwise"), place("records"));
  EXPECT_NE(place("records"), std::string::npos);
}

TEST(HtmlPage, LeavesMotionsToTheFigures) {
  const Evaluation evaluation(test::records_of_a_run());
  EXPECT_EQ(html_page("run", {}, evaluation, sections_of(evaluation), {}, {}).find("waveforms"),
            std::string::npos);
}

}  // namespace
}  // namespace signorini
