#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

// What a trial costs a program that runs a suite, whatever it flies: page faults, CPU time and
// fdatasync of all its processes, as the difference between many repetitions and few.
namespace {

namespace fs = std::filesystem;

constexpr const char* kNearEmpty =
    "suite: near-empty\nkind: static\nseed: 3\ntraces: none\n"
    "scenarios: [{name: open, world: {circles: [[2, 3, 0.5]]}, bounds: [[-2, -2], [5, 5]], "
    "start: [0, 0], goal: [2, 1]}]\nvehicles: [ideal]\nplanners: [RRTConnect]\n";
constexpr const char* kForest =
    "suite: forest\nseed: 3\ntraces: none\n"
    "scenarios: [{name: forest, generator: {name: forest, density_per_m2: 0.1, side_m: 12}}]\n"
    "vehicles: [quadrotor]\nplanners: [VoronoiRoadmap]\nnavigation: paper\n";

struct Cost {
  double faults = 0;
  double user_s = 0;
  double system_s = 0;
  double syncs = 0;
};

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

void wait_for(const std::vector<std::string>& command, const fs::path& log) {
  std::vector<char*> arguments;
  for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  const pid_t child = fork();
  if (child == 0) {
    const int fd = open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
    dup2(fd, STDOUT_FILENO);
    dup2(fd, STDERR_FILENO);
    execvp(arguments.front(), arguments.data());
    _exit(127);
  }
  int status = 0;
  waitpid(child, &status, 0);
  if (!WIFEXITED(status) || WEXITSTATUS(status) > 1)
    throw std::runtime_error(command.front() + ": failed, see " + log.string());
}

// Lines "... fdatasync(..." of strace.
double syncs_in(const fs::path& trace) {
  std::ifstream in(trace);
  double count = 0;
  for (std::string line; std::getline(in, line);)
    if (line.find("sync(") != std::string::npos) ++count;
  return count;
}

Cost cost_of(const std::string& program, const fs::path& folder, int repetitions) {
  const std::vector<std::string> command = {program,
                                            "run",
                                            (folder / "suite.yaml").string(),
                                            "--out",
                                            (folder / "out").string(),
                                            "--jobs",
                                            "1",
                                            "--repetitions",
                                            std::to_string(repetitions)};
  fs::remove_all(folder / "out");
  rusage before{};
  getrusage(RUSAGE_CHILDREN, &before);
  wait_for(command, folder / "log");
  rusage after{};
  getrusage(RUSAGE_CHILDREN, &after);
  fs::remove_all(folder / "out");
  std::vector<std::string> traced = {
      "strace", "-f", "-e", "trace=fdatasync,fsync", "-o", (folder / "trace").string()};
  traced.insert(traced.end(), command.begin(), command.end());
  wait_for(traced, folder / "log");
  return {
      static_cast<double>(after.ru_minflt + after.ru_majflt - before.ru_minflt - before.ru_majflt),
      seconds(after.ru_utime) - seconds(before.ru_utime),
      seconds(after.ru_stime) - seconds(before.ru_stime), syncs_in(folder / "trace")};
}

void print_cost(const std::string& program, const char* name, const char* suite, int repetitions) {
  std::string pattern = (fs::temp_directory_path() / "trial-cost-XXXXXX").string();
  if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no temporary folder");
  const fs::path folder = pattern;
  std::ofstream(folder / "suite.yaml") << suite;
  const int few = std::max(repetitions / 5, 1);
  const Cost less = cost_of(program, folder, few);
  const Cost more = cost_of(program, folder, repetitions);
  fs::remove_all(folder);
  const double n = repetitions - few;
  std::printf("| %s | %d | %.0f | %.3f | %.2f | %.2f | %.2f |\n", name, repetitions - few,
              (more.faults - less.faults) / n, (more.syncs - less.syncs) / n,
              1e3 * (more.user_s + more.system_s - less.user_s - less.system_s) / n,
              1e3 * (more.user_s - less.user_s) / n, 1e3 * (more.system_s - less.system_s) / n);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3 || std::atoi(argv[2]) < 5) {
    std::cerr << "voronaut-trial-cost PROGRAM REPETITIONS (5 or more; needs strace)\n";
    return 2;
  }
  try {
    std::puts("| trial | n | page faults | fdatasync | CPU, ms | of it user | of it system |");
    std::puts("|---|---:|---:|---:|---:|---:|---:|");
    print_cost(argv[1], "near-empty static", kNearEmpty, std::atoi(argv[2]));
    print_cost(argv[1], "governed forest flight", kForest, std::max(std::atoi(argv[2]) / 10, 5));
  } catch (const std::exception& error) {
    std::cerr << "voronaut-trial-cost: " << error.what() << "\n";
    return 1;
  }
}
