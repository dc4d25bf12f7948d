#include "voronaut/benchmarks/engines/engine.h"

#include <cstdlib>
#include <fstream>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "voronaut/tests/support/temporary_folder.h"

namespace voronaut {
namespace {

using ::testing::HasSubstr;

ShardedRun run_of_three() {
  ShardedRun run;
  run.suite = "s";
  run.folder = "/tmp/a b's {x}";
  run.shards = 3;
  run.jobs = 2;
  run.shard_command = {"/bin/voronaut", "run", "it's.yaml", "--shard"};
  run.merge_command = {"/bin/voronaut", "merge", run.folder.string()};
  return run;
}

std::string text_of(const std::vector<EngineFile>& files, const std::string& name) {
  for (const EngineFile& file : files)
    if (file.name == name) return file.text;
  ADD_FAILURE() << "no file " << name;
  return {};
}

TEST(Engine, QuotesWordsSoThatAShellReadsThemBack) {
  const TemporaryFolder folder;
  for (const std::string word :
       {"plain", "", "two words", "it's", "$HOME `x` \\ \"q\"", "a{1,2}*?"}) {
    const std::string out = (folder.path() / "out").string();
    ASSERT_EQ(std::system(("printf %s " + shell_word(word) + " >" + out).c_str()), 0);
    std::ostringstream text;
    text << std::ifstream(out).rdbuf();
    EXPECT_EQ(text.str(), word);
  }
}

TEST(Engine, WritesOneCommandALineForWhateverStartsCommands) {
  const auto files = script_files(run_of_three());
  EXPECT_EQ(text_of(files, "shards.txt"),
            "/bin/voronaut run 'it'\\''s.yaml' --shard 1/3\n"
            "/bin/voronaut run 'it'\\''s.yaml' --shard 2/3\n"
            "/bin/voronaut run 'it'\\''s.yaml' --shard 3/3\n");
  EXPECT_EQ(text_of(files, "merge.txt"), "/bin/voronaut merge '/tmp/a b'\\''s {x}'\n");
}

TEST(Engine, HandsSlurmAnArrayThatCanBeRequeued) {
  const std::string text = text_of(slurm_files(run_of_three()), "shards.sbatch");
  for (const char* line : {"#SBATCH --array=1-3\n", "#SBATCH --requeue\n",
                           "#SBATCH --open-mode=append\n", "#SBATCH --signal=B:USR1@60\n",
                           "#SBATCH --cpus-per-task=2\n", "--shard \"$SLURM_ARRAY_TASK_ID\"/3\n"})
    EXPECT_THAT(text, HasSubstr(line));
  EXPECT_THAT(text_of(slurm_files(run_of_three()), "submit"), HasSubstr("afterany:$shards"));
}

TEST(Engine, KeepsBracesOfPathsApartFromThoseOfSnakemake) {
  const std::string text = text_of(snakemake_files(run_of_three()), "Snakefile");
  EXPECT_THAT(text, HasSubstr("output: \"/tmp/a b's {{x}}/shards/{number}-of-3/results.csv\""));
  EXPECT_THAT(text, HasSubstr("--shard {wildcards.number}/3\""));
}

TEST(Engine, CancelsNothingWhereNoIdWasKept) {
  const TemporaryFolder folder;
  for (const std::string& name : engine_names()) {
    for (const EngineFile& file : engine_of(name).files(run_of_three())) {
      if (file.name != "cancel") continue;
      const auto script = folder.path() / "cancel";
      std::ofstream(script) << file.text;
      for (const char* kept : {"", "\n", "x\n", "-1\n", "1 2\n"}) {
        std::ofstream(folder.path() / "pid") << kept;
        std::ofstream(folder.path() / "jobs") << kept;
        // A kill of anything would be seen: it is told to say so instead.
        const std::string command = "cd " + folder.path().string() +
                                    " && { echo 'kill() { echo killed >>hit; }'; echo 'scancel() "
                                    "{ echo killed >>hit; }'; cat cancel; } >c && sh c >/dev/null";
        EXPECT_EQ(std::system(command.c_str()), 0) << name << " with '" << kept << "'";
        EXPECT_FALSE(std::filesystem::exists(folder.path() / "hit")) << name << " '" << kept << "'";
      }
    }
  }
}

}  // namespace
}  // namespace voronaut
