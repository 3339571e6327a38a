// Text that somebody else wrote: in every field of a record, of a scene and of a command's description
// stands, in turn, what one of the interpreters behind a product of the program would act on. SECURITY.md
// says what must become of it.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "harness/files.hpp"
#include "harness/records/record_json.hpp"
#include "tests/harness/fake_method.hpp"
#include "tests/harness/program.hpp"
#include "tests/harness/sample_records.hpp"

namespace signorini::text_attack_test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// One for gnuplot, the shell, HTML, LaTeX, paths, terminals, TOML and spreadsheets each. What acts on one
/// leaves a file PWN.
const std::vector<std::string>& attacks() {
  static const std::vector<std::string> list{
      "x'.system('touch PWN').'",
      "`touch PWN`$(touch PWN);touch PWN",
      "\"; system(\"touch PWN\") #",
      "</td><script>touch(1)</script><img src=x onerror=touch(1)>",
      "\\write18{touch PWN}\\input{/etc/hostname}",
      "../../PWN",
      std::string("a\x1b[2J\nb\tc\x7f"),
      "{} {.} %j %%a",
      "\xff\xfe\xc0\xaf",
      std::string(100000, 'A'),
  };
  return list;
}

/// Pointers to all texts of a JSON value.
void find_texts(const Json& json, const std::string& place, std::vector<std::string>& places) {
  if (json.is_string()) places.push_back(place);
  if (json.is_array()) {
    for (std::size_t i = 0; i < json.size(); ++i)
      find_texts(json[i], place + "/" + std::to_string(i), places);
  }
  if (json.is_object()) {
    for (const auto& [key, value] : json.items()) find_texts(value, place + "/" + key, places);
  }
}

/// A folder of a run: two good records, and one for each text of a full record with the attack in its place.
fs::path attacked_run(const std::string& attack) {
  const fs::path folder = test::fresh_folder("attacked-run");
  const RunFolder run = test::part_of_a_run((folder / "run").string(), {"n=1", "n=2"});
  fs::create_directories(folder / "run");
  Json manifest = run.manifest;
  manifest["limits"] = {{"timeout_s", 1.0},
                        {"memory_mb", 100},
                        {"repetitions", 1},
                        {"certificate_timeout_s", 1.0},
                        {"reference_timeout_s", 1.0}};
  std::ofstream(folder / "run" / "manifest.json") << json_line(manifest);
  std::ofstream lines(folder / "run" / "records.jsonl");
  for (const char* resolution : {"n=1", "n=2"})
    lines << json_line(to_json(test::good_record("s", "m", resolution, 0.1, 0.1))) << "\n";
  const Json full = to_json(test::full_record());
  std::vector<std::string> places;
  find_texts(full, "", places);
  EXPECT_GT(places.size(), 10U);
  for (std::size_t i = 0; i < places.size(); ++i) {
    Json attacked = full;
    attacked["key"] = "key " + std::to_string(i);
    attacked[Json::json_pointer(places[i])] = attack;
    lines << json_line(attacked) << "\n";
  }
  Json options = full;
  options["options"] = {{attack, attack}};
  options["settings"] = {{attack, attack}};
  lines << json_line(options) << "\n";
  return folder;
}

/// Whatever an attack would leave, inside the folder or one level above it.
std::set<std::string> files_below(const fs::path& folder) {
  std::set<std::string> names;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
    names.insert(fs::relative(entry.path(), folder).string());
  return names;
}

bool has_control_characters(const std::string& text) {
  return std::ranges::any_of(text, [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return (byte < 0x20U && c != '\n') || byte == 0x7FU;
  });
}

void expect_harmless(const fs::path& folder, const test::Outcome& outcome) {
  EXPECT_TRUE(outcome.code == 0 || outcome.code == 1 || outcome.code == 2 || outcome.code == 3)
      << outcome.code;
  EXPECT_FALSE(has_control_characters(outcome.out)) << outcome.out.substr(0, 2000);
  EXPECT_FALSE(has_control_characters(outcome.err)) << outcome.err.substr(0, 2000);
  for (const std::string& name : files_below(folder)) {
    EXPECT_EQ(name.find("PWN"), std::string::npos) << name;
    EXPECT_EQ(name.find("hostname"), std::string::npos) << name;
  }
  for (const fs::path& above : {folder.parent_path() / "PWN", folder / "PWN", fs::path("PWN")})
    EXPECT_FALSE(fs::exists(above)) << above;
}

class TextAttack : public testing::TestWithParam<std::size_t> {};

TEST_P(TextAttack, InARecordReachesNoInterpreter) {
  const fs::path folder = attacked_run(attacks()[GetParam()]);
  for (const char* command : {"status run", "report run --format md", "report run --format csv",
                              "report run --format tex", "report run --format html"}) {
    SCOPED_TRACE(command);
    const test::Outcome outcome = test::run_program(command, folder.string());
    EXPECT_EQ(outcome.code, 0) << outcome.err.substr(0, 2000);
    expect_harmless(folder, outcome);
  }
  int products = 0;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder / "run")) {
    const std::string kind = entry.path().extension().string();
    if (kind != ".html" && kind != ".tex" && kind != ".md" && kind != ".csv") continue;
    ++products;
    const std::string text = read_file(entry.path());
    EXPECT_LT(text.size(), 20U << 20U) << entry.path();
    EXPECT_EQ(text.find('\x1b'), std::string::npos) << entry.path();
    if (kind == ".html") {
      EXPECT_EQ(text.find("<script>touch"), std::string::npos);
      EXPECT_EQ(text.find("<img src=x"), std::string::npos);
    }
    if (kind == ".tex") {
      EXPECT_EQ(text.find("\\write18"), std::string::npos);
    }
  }
  EXPECT_GT(products, 2);
}

TEST_P(TextAttack, InAManifestReachesNoInterpreter) {
  const std::string& attack = attacks()[GetParam()];
  const fs::path folder = attacked_run("harmless");
  const fs::path file = folder / "run" / "manifest.json";
  Json good = Json::parse(read_file(file));
  good.update({{"command_line", {"signorini", "run"}},
               {"order", "any"},
               {"shard", "1/2"},
               {"plugins", {{"mine", "1"}}},
               {"shards", {{{"date", "today"}, {"shard", "2/2"}}}}});
  std::vector<std::string> places;
  find_texts(good, "", places);
  EXPECT_GT(places.size(), 8U);
  std::vector<Json> attacked(places.size() + 2, good);
  for (std::size_t i = 0; i < places.size(); ++i) attacked[i][Json::json_pointer(places[i])] = attack;
  attacked[places.size()][attack] = 1;
  attacked[places.size() + 1]["plugins"][attack] = "1";
  for (const Json& manifest : attacked) {
    std::ofstream(file) << json_line(manifest);
    for (const char* command : {"status run", "report run --format html", "merge run --out merged"}) {
      SCOPED_TRACE(command);
      expect_harmless(folder, test::run_program(command, folder.string()));
    }
  }
}

/// A text as TOML may spell it, whatever is in it.
std::string quoted(const std::string& text) {
  std::string literal = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') literal += '\\';
    if (byte < 0x20U || byte == 0x7FU) {
      constexpr const char* kDigits = "0123456789abcdef";
      literal += std::string("\\u00") + kDigits[byte >> 4U] + kDigits[byte & 15U];
    } else {
      literal += c;
    }
  }
  return literal + "\"";
}

TEST_P(TextAttack, InASceneReachesNoInterpreter) {
  const std::string text = quoted(attacks()[GetParam()]);
  const fs::path folder = test::fresh_folder("attacked-scene");
  for (const char* field : {"name", "title", "reference", "tags"}) {
    std::string scene = "schema = 1\n";
    for (const char* other : {"name", "title"}) {
      if (std::string(other) != field) scene += std::string(other) + " = \"good\"\n";
    }
    scene += std::string(field) + " = " + (std::string(field) == "tags" ? "[" + text + "]" : text) + "\n";
    scene +=
        "[system]\nkind = \"sdof\"\nmass = 1.0\ndamping = 0.1\nstiffness = 1.0\n[forcing]\nfrequency = 2.2\n"
        "[[forcing.term]]\ndof = 0\ncos = 1.0\n[[contact]]\ndof = 0\ngap = 0.2\n[law]\nrestitution = 0.8\n";
    std::ofstream(folder / "scene.toml") << scene;
    for (const char* command :
         {"show ./scene.toml", "solve ./scene.toml --method hat-lcp --set samples=64 --certificate 0.1",
          "run quick --scenes ./scene.toml --methods 'hat-lcp[samples=64]' --repetitions 1 --out out"}) {
      SCOPED_TRACE(std::string(field) + " " + command);
      expect_harmless(folder, test::run_program(command, folder.string()));
    }
  }
}

TEST_P(TextAttack, InADescriptionOfACommandReachesNoInterpreter) {
  const std::string text = quoted(attacks()[GetParam()]);
  const fs::path folder = test::fresh_folder("attacked-command");
  for (const char* field : {"name", "title", "ladder", "meaning"}) {
    const auto value = [&](const char* name, const char* good) {
      return std::string(name) == field ? text : "\"" + std::string(good) + "\"";
    };
    std::ofstream(folder / "method.toml")
        << "schema = 1\nname = " << value("name", "my-method") << "\ntitle = " << value("title", "A method")
        << "\ncommand = [\"/bin/cat\"]\nladder = " << value("ladder", "word=a|b")
        << "\n[represents]\nrestitution = \"scene\"\n[[option]]\nname = \"word\"\ndefault = \"a\"\nmeaning = "
        << value("meaning", "any") << "\n";
    for (const char* command :
         {"list methods --plugin ./method.toml", "show my-method --plugin ./method.toml"}) {
      SCOPED_TRACE(std::string(field) + " " + command);
      expect_harmless(folder, test::run_program(command, folder.string()));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Each, TextAttack, testing::Range<std::size_t>(0, 10));

TEST(TextAttacks, AreAllTried) { EXPECT_EQ(attacks().size(), 10U); }

}  // namespace
}  // namespace signorini::text_attack_test
