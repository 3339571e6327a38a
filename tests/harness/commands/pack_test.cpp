// `signorini pack`, and what `verify`, `report` and `compare` make of packs: a stranger's method and ours.

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "harness/files.hpp"
#include "harness/pack/run_pack.hpp"
#include "harness/run_folder/record_store.hpp"
#include "harness/text/json.hpp"
#include "tests/harness/fake_method.hpp"
#include "tests/harness/program.hpp"
#include "tests/support/other_programs.hpp"

namespace signorini::pack_test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using test::Outcome;
using test::run_program;

/// The linear response of one mass whose stop it never reaches, in Python without any package.
constexpr const char* kScript = R"(import cmath, json, sys
request = json.load(sys.stdin)
problem, count = request["problem"], int(request["options"]["samples"])
m, d, k = (problem[name]["value"][0] for name in ("mass", "damping", "stiffness"))
w, force = problem["frequency"], problem["force"][0]
u = force["cos"] / (k - w * w * m + 1j * w * d)
t = [problem["period"] * i / count for i in range(count)]
waves = [u * cmath.exp(1j * w * time) for time in t]
print(json.dumps({"verdict": "converged", "trajectory": {
    "t": t, "x": [[wave.real for wave in waves]], "velocity": [[(1j * w * wave).real for wave in waves]],
    "force": [[0.0] * count]}}))
)";

constexpr const char* kDescription = R"(schema = 1
name = "one-wave"
title = "The linear response of one mass"
command = ["python3", "one_wave.py"]
ladder = "samples=64|256"
[represents]
restitution = "scene"
[[option]]
name = "samples"
default = 64
least = 8
most = 4096
unit = "[-]"
meaning = "instants of a period"
)";

/// A folder with the stranger's method in it.
fs::path root_with_plugin(const std::string& name) {
  const fs::path root = test::fresh_folder(name);
  write_whole(root / "one_wave.py", kScript);
  write_whole(root / "one-wave.toml", kDescription);
  return root;
}

bool says(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// A text of JSON, or of lines of it, with each value changed.
std::string changed_text(const std::string& text, const std::function<void(Json& value)>& change) {
  std::string changed;
  const auto add = [&](Json value) {
    change(value);
    changed += json_line(value) + "\n";
  };
  if (Json whole = try_parse_json(text); !whole.is_discarded()) {
    add(std::move(whole));
    return changed;
  }
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) add(parse_json(line));
  return changed;
}

/// A pack of a run of the stranger's method, made in a root of its own.
class Stranger : public testing::Test {
 protected:
  void SetUp() override {
    root_ = root_with_plugin("pack-stranger");
    const Outcome ran = run_program(
        "run quick --scenes sdof-far-stop --methods one-wave --repetitions 3 --plugin one-wave.toml --out "
        "theirs",
        root_.string());
    ASSERT_EQ(ran.code, 0) << ran.err << ran.out;
    packed_ = run_program("pack theirs --out theirs.tar.gz --plugin one-wave.toml", root_.string());
    ASSERT_EQ(packed_.code, 0) << packed_.err;
    home_ = root_with_plugin("pack-home");
    fs::copy_file(root_ / "theirs.tar.gz", home_ / "theirs.tar.gz");
  }

  [[nodiscard]] Outcome at_home(const std::string& arguments) const {
    return run_program(arguments, home_.string());
  }

  /// The pack with the JSON changed in each line of one of its files, and its sums made anew, as a forger
  /// would.
  void forge(const char* name, const std::function<void(Json& line)>& change) const {
    std::vector<ArchivedFile> files = read_tar(gunzipped(read_file(root_ / "theirs.tar.gz"), kLargestPack));
    std::string sums;
    for (std::size_t i = 1; i < files.size(); ++i) {
      if (files[i].name == name) files[i].text = changed_text(files[i].text, change);
      sums += fmt::format("{}  {}\n", sha256(files[i].text), files[i].name);
    }
    files.front().text = sums;
    write_whole(home_ / "theirs.tar.gz", gzipped(write_tar(files)));
  }

  fs::path root_, home_;
  Outcome packed_;
};

TEST_F(Stranger, IsPackedWithTheDescriptionOfItsMethod) {
  EXPECT_EQ(packed_.out, fmt::format("theirs.tar.gz: 2 records, 1 description of plugins, SHA-256 {}\n",
                                     sha256_of_file(root_ / "theirs.tar.gz")));
  const OpenedRun opened(root_ / "theirs.tar.gz");
  EXPECT_EQ(read_file(opened.folder() / "plugins" / "one-wave.toml"), kDescription);
  const Json manifest = parse_json(read_file(opened.folder() / "manifest.json"));
  EXPECT_EQ(manifest.contains("calibration"), manifest["build"]["timings_count"].get<bool>());
}

TEST_F(Stranger, IsVerifiedInAnotherRootWithTheMethodAtHand) {
  const Outcome verified = at_home("verify theirs.tar.gz --plugin one-wave.toml");
  EXPECT_EQ(verified.code, 0) << verified.out << verified.err;
  EXPECT_TRUE(says(verified.out, "theirs.tar.gz: SHA-256 " + sha256_of_file(home_ / "theirs.tar.gz")));
  EXPECT_TRUE(says(verified.out, "2 cases, 0 differences")) << verified.out;
  EXPECT_FALSE(says(verified.out, "note: ")) << verified.out;
}

TEST_F(Stranger, IsNotVerifiedWithoutTheMethodAndNothingOfThePackIsRun) {
  const Outcome without = at_home("verify theirs.tar.gz");
  EXPECT_EQ(without.code, 3) << without.out;
  EXPECT_TRUE(says(without.out, "left out: 2 cases: no method one-wave is here")) << without.out;
  EXPECT_TRUE(says(without.err, "dir = theirs.tar.gz (holds no case that can be judged here)"))
      << without.err;
  write_whole(home_ / "one_wave.py", std::string(kScript) + "# another version\n");
  const Outcome other = at_home("verify theirs.tar.gz --plugin one-wave.toml");
  EXPECT_EQ(other.code, 0) << other.out;
  EXPECT_TRUE(says(other.out, "note: the plugin of one-wave is not the one of the run")) << other.out;
}

TEST_F(Stranger, IsFoundOutWhereAnErrorOrAVerdictIsNotWhatItIs) {
  forge("records.jsonl",
        [](Json& record) { record["errors"]["x_l2"] = 1e-3 * record["errors"]["x_l2"].get<double>(); });
  const Outcome better = at_home("verify theirs.tar.gz --plugin one-wave.toml");
  EXPECT_EQ(better.code, 1) << better.out;
  EXPECT_TRUE(says(better.out, "error of x")) << better.out;
  forge("records.jsonl", [](Json& record) { record["status"] = "inaccurate"; });
  const Outcome worse = at_home("verify theirs.tar.gz --plugin one-wave.toml");
  EXPECT_EQ(worse.code, 1) << worse.out;
  EXPECT_TRUE(says(worse.out, "inaccurate became converged")) << worse.out;
}

// Limits of a forger, under which nothing comes out, prove nothing.
TEST_F(Stranger, IsNotVerifiedWithinLimitsThatLeaveNoTime) {
  forge("manifest.json", [](Json& manifest) { manifest["limits"]["timeout_s"] = 1e-3; });
  const Outcome verified = at_home("verify theirs.tar.gz --plugin one-wave.toml");
  EXPECT_EQ(verified.code, 3) << verified.out;
  EXPECT_TRUE(says(verified.out, "converged became timeout: a time limit decided")) << verified.out;
}

TEST_F(Stranger, StandsBesideOursOnOnePage) {
  ASSERT_EQ(
      at_home("run quick --scenes sdof-far-stop --methods 'hat-lcp[samples=64]' --repetitions 3 --out ours")
          .code,
      0);
  const Outcome page = at_home("report ours theirs.tar.gz --out both --format html,csv");
  ASSERT_EQ(page.code, 0) << page.err;
  const std::string html = read_file(home_ / "both" / "report.html");
  EXPECT_TRUE(says(html, "one-wave (theirs)"));
  EXPECT_TRUE(says(html, "hat-lcp (ours)"));
  EXPECT_FALSE(says(read_file(home_ / "both" / "manifest.json"), "signorini-"))
      << "nothing tells of the temporary folder";
  EXPECT_EQ(at_home("report theirs.tar.gz").code, 2) << "a pack has no folder for its page";
  EXPECT_EQ(at_home("report theirs.tar.gz --out alone").code, 0);
}

TEST_F(Stranger, IsComparedInSeveralRunsAtOnce) {
  const Outcome same = at_home("compare theirs.tar.gz theirs.tar.gz theirs.tar.gz");
  EXPECT_EQ(same.code, 0) << same.out << same.err;
  EXPECT_TRUE(says(same.out, "theirs.tar.gz beside theirs.tar.gz:")) << same.out;
  fs::copy_file(home_ / "theirs.tar.gz", home_ / "true.tar.gz");
  forge("records.jsonl", [](Json& record) { record["status"] = "crashed"; });
  const Outcome worse = at_home("compare true.tar.gz true.tar.gz theirs.tar.gz");
  EXPECT_EQ(worse.code, 4) << worse.out;
}

/// Serves the folder it is in over http while the program, its first word, runs with the others; PORT in them
/// is the server's.
constexpr const char* kServer = R"(import http.server, subprocess, sys, threading
class Quiet(http.server.SimpleHTTPRequestHandler):
    def log_message(self, *ignored): pass
server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), Quiet)
threading.Thread(target=server.serve_forever, daemon=True).start()
sys.exit(subprocess.call([word.replace("PORT", str(server.server_port)) for word in sys.argv[1:]]))
)";

TEST_F(Stranger, IsFetchedFromAFolder) {
  write_whole(root_ / "SHA256SUMS",
              fmt::format("{}  theirs.tar.gz\n", sha256_of_file(root_ / "theirs.tar.gz")));
  const std::string index = (root_ / "SHA256SUMS").string();
  const Outcome listed = at_home("fetch " + index);
  EXPECT_EQ(listed.out, read_file(index)) << listed.err;
  EXPECT_FALSE(fs::exists(home_ / "packs"));
  ASSERT_EQ(at_home("fetch " + index + " --out packs").code, 0);
  EXPECT_EQ(read_file(home_ / "packs" / "theirs.tar.gz"), read_file(root_ / "theirs.tar.gz"));
  EXPECT_EQ(at_home("fetch " + index + " --packs 'no*'").code, 3);
  write_whole(root_ / "theirs.tar.gz", "another");
  const Outcome other = at_home("fetch " + index + " --out others");
  EXPECT_EQ(other.code, 2);
  EXPECT_TRUE(says(other.err, "its SHA-256 must be")) << other.err;
  EXPECT_FALSE(fs::exists(home_ / "others" / "theirs.tar.gz"));
}

TEST_F(Stranger, IsFetchedFromAWebServer) {
  if (!test::succeeds("curl --version")) GTEST_SKIP() << "curl is not installed";
  write_whole(root_ / "SHA256SUMS",
              fmt::format("{}  theirs.tar.gz\n", sha256_of_file(root_ / "theirs.tar.gz")));
  const fs::path server = home_ / "server.py";
  write_whole(server, kServer);
  const auto fetched = [&](const std::string& index) {
    return std::system(fmt::format("cd {} && python3 {} {} fetch http://127.0.0.1:PORT/{} --out {} 2>{}",
                                   root_.string(), server.string(), SIGNORINI_BINARY, index,
                                   (home_ / "packs").string(), (home_ / "err").string())
                           .c_str());
  };
  EXPECT_EQ(WEXITSTATUS(fetched("SHA256SUMS")), 0) << read_file(home_ / "err");
  EXPECT_EQ(read_file(home_ / "packs" / "theirs.tar.gz"), read_file(root_ / "theirs.tar.gz"));
  EXPECT_EQ(WEXITSTATUS(fetched("NONE")), 2);
  EXPECT_TRUE(says(read_file(home_ / "err"), "404")) << read_file(home_ / "err");
}

TEST(Pack, LeavesOutTheDescriptionOfAMethodThatIsNotLoaded) {
  const fs::path root = root_with_plugin("pack-none");
  ASSERT_EQ(run_program("run quick --scenes sdof-far-stop --methods 'one-wave[samples=64]' --repetitions 1 "
                        "--plugin one-wave.toml --out run",
                        root.string())
                .code,
            0);
  const Outcome packed = run_program("pack run --out run.tar.gz", root.string());
  EXPECT_EQ(packed.code, 0);
  EXPECT_TRUE(says(packed.err, "one-wave: its description is left out")) << packed.err;
  EXPECT_TRUE(says(packed.out, "1 record, 0 descriptions")) << packed.out;
}

TEST(Pack, RefusesWhatIsNoRunInOneLine) {
  const fs::path root = test::fresh_folder("pack-refused");
  write_whole(root / "text", "no pack\n");
  for (const char* arguments : {"pack . --out x.tar.gz", "pack text --out x.tar.gz", "verify text",
                                "report text --out both", "compare text text"}) {
    const Outcome refused = run_program(arguments, root.string());
    EXPECT_EQ(refused.code, 2) << arguments << refused.out;
    EXPECT_EQ(refused.out, "") << arguments;
    EXPECT_EQ(std::ranges::count(refused.err, '\n'), 1) << refused.err;
  }
  EXPECT_FALSE(fs::exists(root / "x.tar.gz"));
}

}  // namespace
}  // namespace signorini::pack_test
