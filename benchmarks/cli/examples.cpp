#include "voronaut/benchmarks/cli/examples.h"

#include <map>

namespace voronaut {

std::vector<std::string> command_examples(const std::string& command) {
  static const std::map<std::string, std::vector<std::string>> kExamples = {
      {"init", {"voronaut init first"}},
      {"check",
       {"voronaut check first/suite.yaml", "voronaut check grove",
        "voronaut check forest --set seed=2"}},
      {"show",
       {"voronaut show first/yard.yaml -o yard.svg", "voronaut show rooms --seed 3 -o rooms.svg"}},
      {"run",
       {"voronaut run first/suite.yaml --dry-run", "voronaut run first/suite.yaml",
        "voronaut run first/suite.yaml --planners VoronoiRoadmap --repetitions 1 --out once"}},
      {"summary",
       {"voronaut summary voronaut-results/first",
        "voronaut summary voronaut-results/first --csv > summary.csv"}},
      {"report",
       {"voronaut report voronaut-results/first -o first.html",
        "voronaut report voronaut-results/first --format md"}},
      {"compare",
       {"voronaut compare voronaut-results/first --planners RRTConnect,VoronoiRoadmap "
        "--statistics goal_reached_share",
        "voronaut run first/suite.yaml --out now",
        "voronaut compare voronaut-results/first now --format md"}},
      {"plot",
       {"voronaut plot voronaut-results/first --scenario yard --repetition 0 -o yard-flown.svg",
        "voronaut plot voronaut-results/first TRIAL_ID -o one.svg"}},
      {"replay", {"voronaut replay voronaut-results/first TRIAL_ID"}},
      {"digest",
       {"voronaut digest voronaut-results/first",
        "voronaut digest voronaut-results/first --flights"}},
      {"evidence", {"voronaut evidence voronaut-results/first -o evidence.md"}},
      {"export",
       {"voronaut export voronaut-results/first --format plannerarena",
        "voronaut export voronaut-results/first --format csv -o first.csv"}},
      {"list",
       {"voronaut list suites", "voronaut list planners RRTConnect",
        "voronaut list generators forest", "voronaut list vehicles quadrotor"}},
      {"schema", {"voronaut schema suite > suite.json", "voronaut schema --format md"}},
      {"submit",
       {"voronaut submit first/suite.yaml --engine parallel --shards 4 --dry-run",
        "voronaut submit first/suite.yaml --engine slurm --dry-run"}},
      {"status",
       {"voronaut status voronaut-results/first",
        "voronaut status voronaut-results/first first/suite.yaml"}},
      {"merge",
       {"voronaut run first/suite.yaml --shard 1/2 --out parts",
        "voronaut run first/suite.yaml --shard 2/2 --out parts", "voronaut merge parts -o parts"}},
      {"cancel", {"voronaut cancel voronaut-results/first"}},
      {"tune",
       {"voronaut tune first/suite.yaml --planner RRTConnect --over range=0.5:5:log --candidates 2",
        "voronaut tune forest --planner RRTConnect --over range=0.1:5:log --dry-run --out wood"}},
      {"completion",
       {"voronaut completion bash > voronaut-completion.bash",
        "voronaut completion fish > voronaut.fish"}},
  };
  return kExamples.at(command);
}

}  // namespace voronaut
