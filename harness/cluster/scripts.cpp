#include "harness/cluster/scripts.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "harness/failure.hpp"
#include "harness/text/words.hpp"
#include "problems/files/toml_tree.hpp"

namespace signorini {

namespace {

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += " " + shell_word(word);
  return text;
}

std::string sbatch_lines(const Submission& s) {
  std::string lines;
  for (const std::string& word : s.sbatch_words) lines += "#SBATCH " + word + "\n";
  return lines;
}

/// A path in a line of #SBATCH, which no shell reads: in double quotes, "%" of a name doubled.
std::string sbatch_path(const std::filesystem::path& folder, std::string_view file) {
  return fmt::format("\"{}/{}\"", replaced(folder.string(), "%", "%%"), file);
}

std::string merge_command(const Submission& s) {
  return fmt::format("{} merge {}/shard-* --out {}/merged", shell_word(s.program.string()),
                     shell_word(s.folder.string()), shell_word(s.folder.string()));
}

}  // namespace

void require_quotable(const Submission& s) {
  const std::string folder = s.folder.string();
  if (has_control_characters(folder) || folder.find_first_of("\"\\{}") != std::string::npos) {
    throw UsageError(
        "dir = {} (must be a path without control characters, quotation marks, backslashes and braces)",
        folder);
  }
  for (const std::string& word : s.sbatch_words) {
    if (has_control_characters(word))
      throw UsageError("sbatch = {} (must be one option without control characters)", word);
  }
}

std::string shell_word(const std::string& text) {
  const auto plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
           std::string_view("-_./=:,+@%").find(c) != std::string_view::npos;
  };
  if (!text.empty() && std::ranges::all_of(text, plain)) return text;
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

std::string slurm_run_command(const Submission& s, const std::string& index) {
  return fmt::format("{} run{} --resume --shard {}/{} --out {}/shard-{}", shell_word(s.program.string()),
                     joined(s.run_words), index, s.shards, shell_word(s.folder.string()), index);
}

std::string parallel_run_command(const Submission& s, const std::string& index) {
  return fmt::format("{} --beside {}", slurm_run_command(s, index), s.at_once);
}

std::string slurm_array_script(const Submission& s) {
  return fmt::format(
      "#!/bin/sh\n#SBATCH --job-name=signorini\n#SBATCH --array=1-{}\n#SBATCH --requeue\n"
      "#SBATCH --ntasks=1\n#SBATCH --cpus-per-task=1\n#SBATCH --exclusive\n#SBATCH --open-mode=append\n"
      "#SBATCH --output={}\n"
      "{}# Requeued after the loss of a node, a task resumes; cases that fail are records, not failures of "
      "the task.\n"
      "{}\nstatus=$?\n[ \"$status\" -le 1 ] && exit 0\nexit \"$status\"\n",
      s.shards, sbatch_path(s.folder, "log-%a.txt"), sbatch_lines(s),
      slurm_run_command(s, "\"$SLURM_ARRAY_TASK_ID\""));
}

std::string slurm_merge_script(const Submission& s) {
  return fmt::format(
      "#!/bin/sh\n#SBATCH --job-name=signorini-merge\n#SBATCH --ntasks=1\n#SBATCH "
      "--output={}\n{}exec {}\n",
      sbatch_path(s.folder, "log-merge.txt"), sbatch_lines(s), merge_command(s));
}

std::string slurm_submit_script(const Submission& s) {
  const std::string folder = shell_word(s.folder.string());
  return fmt::format(
      "#!/bin/sh\nset -eu\narray=$(sbatch --parsable {0}/array.sh)\n"
      "merge=$(sbatch --parsable --dependency=\"afterany:${{array%%;*}}\" {0}/merge.sh)\n"
      "echo \"job array ${{array%%;*}}, merge job ${{merge%%;*}}\"\n",
      folder);
}

std::string parallel_script(const Submission& s) {
  std::vector<std::string> numbers;
  for (int i = 1; i <= s.shards; ++i) numbers.push_back(std::to_string(i));
  // Cases that fail are records: exit code 1 is no reason to stop.
  const std::string run = parallel_run_command(s, "{}") + " || [ $? -eq 1 ]";
  return fmt::format("#!/bin/sh\nset -eu\nparallel --jobs {} --joblog {}/parallel.log {} ::: {}\nexec {}\n",
                     s.at_once, shell_word(s.folder.string()), shell_word(run), joined(numbers, " "),
                     merge_command(s));
}

}  // namespace signorini
