#include "harness/cluster/scripts.hpp"

#include <gtest/gtest.h>

#include "harness/failure.hpp"

namespace signorini::scripts_test {
namespace {

Submission submission() {
  return {.program = "/opt/signorini",
          .folder = "/data/my run",
          .run_words = {"quick", "--scenes", "sdof*"},
          .shards = 3,
          .sbatch_words = {"--time=60"}};
}

TEST(ShellWord, QuotesWhatTheShellWouldRead) {
  EXPECT_EQ(shell_word("--out=a/b-1.2"), "--out=a/b-1.2");
  EXPECT_EQ(shell_word("sdof*"), "'sdof*'");
  EXPECT_EQ(shell_word("it's"), "'it'\\''s'");
  EXPECT_EQ(shell_word(""), "''");
}

TEST(SlurmScripts, RunOneShardPerTaskAndMergeWhenAllHaveEnded) {
  const std::string array = slurm_array_script(submission());
  EXPECT_EQ(array.rfind("#!/bin/sh\n#SBATCH", 0), 0U);
  EXPECT_NE(array.find("#SBATCH --array=1-3\n"), std::string::npos);
  EXPECT_NE(array.find("#SBATCH --time=60\n"), std::string::npos);
  EXPECT_NE(
      array.find("/opt/signorini run quick --scenes 'sdof*' --resume --shard \"$SLURM_ARRAY_TASK_ID\"/3 "
                 "--out '/data/my run'/shard-\"$SLURM_ARRAY_TASK_ID\"\n"),
      std::string::npos)
      << array;
  EXPECT_NE(slurm_merge_script(submission()).find("merge '/data/my run'/shard-* --out '/data/my run'/merged"),
            std::string::npos);
  EXPECT_NE(slurm_submit_script(submission()).find("--dependency=\"afterany:${array%%;*}\""),
            std::string::npos);
}

TEST(SlurmScripts, TakeFoldersThatMeanWhatTheySay) {
  Submission job = submission();
  job.folder = "/data/50 %j of it";
  EXPECT_NO_THROW(require_quotable(job));
  EXPECT_NE(slurm_array_script(job).find("#SBATCH --output=\"/data/50 %%j of it/log-%a.txt\"\n"),
            std::string::npos);
  EXPECT_NE(slurm_merge_script(job).find("#SBATCH --output=\"/data/50 %%j of it/log-merge.txt\"\n"),
            std::string::npos);
  for (const char* folder : {"/data/nl\nrm -rf x", "/data/\"x", "/data/a{}b", "/data/a\\b", "/data/\x1b"}) {
    job.folder = folder;
    EXPECT_THROW(require_quotable(job), UsageError) << folder;
  }
  job.folder = "/data/run";
  job.sbatch_words = {"--time=60\nrm -rf x"};
  EXPECT_THROW(require_quotable(job), UsageError);
}

TEST(ParallelScript, NumbersTheShardsAndSaysHowManyRunAtOnce) {
  Submission two = submission();
  two.at_once = 2;
  const std::string script = parallel_script(two);
  EXPECT_NE(script.find("parallel --jobs 2 "), std::string::npos) << script;
  EXPECT_NE(script.find("--beside 2"), std::string::npos) << script;
  EXPECT_NE(script.find("::: 1 2 3\n"), std::string::npos) << script;
  EXPECT_LT(script.find(":::"), script.find(" merge ")) << script;
}

}  // namespace
}  // namespace signorini::scripts_test
