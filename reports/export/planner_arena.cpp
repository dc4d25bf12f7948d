#include "voronaut/reports/export/planner_arena.h"

#include "voronaut/reports/export/ompl_log.h"
#include "voronaut/reports/store/sqlite.h"

namespace voronaut {
namespace {

constexpr const char* kTables = R"(
CREATE TABLE experiments (id INTEGER PRIMARY KEY AUTOINCREMENT, name VARCHAR(512),
  totaltime REAL, timelimit REAL, memorylimit REAL, runcount INTEGER, version VARCHAR(128),
  hostname VARCHAR(1024), cpuinfo TEXT, date DATETIME, seed VARCHAR(24), setup TEXT);
CREATE TABLE plannerConfigs (id INTEGER PRIMARY KEY AUTOINCREMENT, name VARCHAR(512) NOT NULL,
  settings TEXT);
CREATE TABLE enums (name VARCHAR(512), value INTEGER, description TEXT,
  PRIMARY KEY (name, value));
CREATE TABLE runs (id INTEGER PRIMARY KEY AUTOINCREMENT, experimentid INTEGER, plannerid INTEGER,
  FOREIGN KEY (experimentid) REFERENCES experiments(id) ON DELETE CASCADE,
  FOREIGN KEY (plannerid) REFERENCES plannerConfigs(id) ON DELETE CASCADE);
CREATE TABLE progress (runid INTEGER, time REAL, PRIMARY KEY (runid, time),
  FOREIGN KEY (runid) REFERENCES runs(id) ON DELETE CASCADE);
)";

// Configurations in the order of success, then of mean time.
constexpr const char* kViews = R"(
CREATE VIEW bestPlannerConfigsPerExperiment AS
  SELECT plannerid, experimentid, MIN(avg_solved) AS avg_solved, avg_total_time FROM
    (SELECT plannerid, plannerConfigs.name AS plannerName, experimentid, AVG(solved) AS avg_solved,
       AVG(time) AS avg_total_time FROM runs
       INNER JOIN plannerConfigs ON plannerConfigs.id = plannerid GROUP BY plannerid, experimentid)
  GROUP BY plannerName, experimentid ORDER BY avg_solved DESC, avg_total_time ASC;
CREATE VIEW bestPlannerConfigs AS
  SELECT plannerid, MIN(avg_solved) AS avg_solved, avg_total_time FROM
    (SELECT plannerid, plannerConfigs.name AS plannerName, AVG(solved) AS avg_solved,
       AVG(time) AS avg_total_time FROM runs
       INNER JOIN plannerConfigs ON plannerConfigs.id = plannerid GROUP BY plannerid)
  GROUP BY plannerName ORDER BY avg_solved DESC, avg_total_time ASC;
)";

void add_columns(sqlite::Database& database, const char* table,
                 const std::vector<BenchmarkColumn>& columns) {
  for (const BenchmarkColumn& column : columns)
    if (column.name != "time" || std::string_view(table) != "progress")
      database.execute(std::string("ALTER TABLE ") + table + " ADD " + column.name + " " +
                       column.type);
}

std::string insert_sql(const char* table, const std::vector<std::string>& first,
                       const std::vector<BenchmarkColumn>& columns) {
  std::string names;
  std::string marks;
  const auto add = [&](const std::string& name) {
    names += (names.empty() ? "" : ",") + name;
    marks += marks.empty() ? "?" : ",?";
  };
  for (const std::string& name : first) add(name);
  for (const BenchmarkColumn& column : columns) add(column.name);
  return std::string("INSERT INTO ") + table + " (" + names + ") VALUES (" + marks + ")";
}

// As the script binds them: text, which the column's type turns into numbers.
void bind_row(sqlite::Statement& statement, int first, const BenchmarkRow& row) {
  for (std::size_t i = 0; i < row.size(); ++i) {
    const int parameter = first + static_cast<int>(i);
    if (row[i].empty())
      statement.bind(parameter, kAbsent);
    else
      statement.bind(parameter, row[i]);
  }
}

void add_experiment(const PlannerBenchmark& benchmark, sqlite::Database& database) {
  sqlite::Statement statement(database, "INSERT INTO experiments VALUES (1,?,?,?,?,?,?,?,?,?,?,?)");
  const auto lines = [](const std::string& text) {
    return text.empty() || text.back() == '\n' ? text : text + "\n";
  };
  statement.bind(1, benchmark.name);
  statement.bind(2, benchmark.total_time_s);
  statement.bind(3, benchmark.time_limit_s);
  statement.bind(4, benchmark.memory_limit_mb);
  statement.bind(5, std::int64_t{benchmark.runs_per_planner});
  statement.bind(6, "Voronaut " + benchmark.version);
  statement.bind(7, benchmark.host);
  statement.bind(8, lines(benchmark.processor));
  statement.bind(9, benchmark.date);
  statement.bind(10, std::to_string(benchmark.seed));
  statement.bind(11, lines(benchmark.setup));
  statement.step();
}

void add_enum(const PlannerBenchmark& benchmark, sqlite::Database& database) {
  sqlite::Statement statement(database, "INSERT INTO enums VALUES (?,?,?)");
  for (std::size_t i = 0; i < benchmark.enum_words.size(); ++i) {
    statement.bind(1, benchmark.enum_name);
    statement.bind(2, static_cast<std::int64_t>(i));
    statement.bind(3, benchmark.enum_words[i]);
    statement.step();
    statement.reset();
  }
}

void add_planners(const PlannerBenchmark& benchmark, sqlite::Database& database) {
  sqlite::Statement planner_row(database, "INSERT INTO plannerConfigs VALUES (?,?,?)");
  sqlite::Statement run_row(
      database, insert_sql("runs", {"experimentid", "plannerid"}, benchmark.run_columns));
  sqlite::Statement progress_row(database,
                                 insert_sql("progress", {"runid"}, benchmark.progress_columns));
  std::int64_t run_id = 0;
  std::int64_t planner_id = 0;
  for (const BenchmarkedPlanner& planner : benchmark.planners) {
    planner_row.bind(1, ++planner_id);
    planner_row.bind(2, planner.name);
    planner_row.bind(3, settings_text(planner));
    planner_row.step();
    planner_row.reset();
    for (std::size_t run = 0; run < planner.runs.size(); ++run) {
      ++run_id;
      run_row.bind(1, std::int64_t{1});
      run_row.bind(2, planner_id);
      bind_row(run_row, 3, planner.runs[run]);
      run_row.step();
      run_row.reset();
      for (const BenchmarkRow& sample : planner.progress[run]) {
        progress_row.bind(1, run_id);
        bind_row(progress_row, 2, sample);
        progress_row.step();
        progress_row.reset();
      }
    }
  }
}

}  // namespace

void write_planner_arena(const PlannerBenchmark& benchmark, const std::filesystem::path& file) {
  std::filesystem::path part = file;
  part += ".part";
  std::filesystem::remove(part);
  {
    sqlite::Database database(part, sqlite::OpenMode::create);
    sqlite::Transaction transaction(database);
    database.execute(kTables);
    add_columns(database, "runs", benchmark.run_columns);
    add_columns(database, "progress", benchmark.progress_columns);
    add_experiment(benchmark, database);
    add_enum(benchmark, database);
    add_planners(benchmark, database);
    database.execute(kViews);
    transaction.commit();
  }
  std::filesystem::rename(part, file);
}

}  // namespace voronaut
