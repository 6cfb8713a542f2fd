#include <unistd.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "engine/base/mat/mat_file.hpp"
#include "engine/base/table/table_file.hpp"
#include "tests/support/run_text.hpp"

using namespace stepwire;

namespace {

/// A temporary folder that is removed at the end of a test.
struct Folder {
  std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("stepwire_from_file_" + std::to_string(::getpid()));
  ~Folder() { std::filesystem::remove_all(path); }

  std::string file(const std::string& name, const std::string& content) const {
    io::write_file((path / name).string(), content);
    return (path / name).string();
  }
};

/// `y` of a FromFile with these keys, at every 0.1 s up to `stop`.
std::vector<double> played(const std::string& file, const std::string& keys, const std::string& stop) {
  return column(run_text("step: 0.1 s\nstop: " + stop + "\nblocks:\n  y: {block: FromFile, file: '" + file +
                         "', " + keys + "}\nrecord: [y]\n"),
                "y");
}

std::string refused(const std::string& file, const std::string& keys, const std::string& stop = "0.3 s") {
  return error_of("step: 0.1 s\nstop: " + stop + "\nblocks:\n  y: {block: FromFile, file: '" + file + "', " +
                  keys + "}\nrecord: [y]\n");
}

void require_near(const std::vector<double>& values, const std::vector<double>& expected) {
  REQUIRE(values.size() == expected.size());
  for (std::size_t i = 0; i < values.size(); ++i) REQUIRE(values[i] == Approx(expected[i]).margin(1e-12));
}

const char* const record_text = "time [ms],x [mm],F_N\n1000,0,5\n1200,4000,7\n1400,2000,9\n";

}  // namespace

TEST_CASE("a record is played from its first row, straight between rows, in SI by its header") {
  const Folder folder;
  const std::string file = folder.file("press.csv", record_text);
  require_near(played(file, "column: x", "0.4 s"), {0, 2, 4, 3, 2});
  require_near(played(file, "column: F_N", "0.4 s"), {5, 6, 7, 8, 9});
  require_near(played(file, "column: F_N, unit: kN", "0.4 s"), {5000, 6000, 7000, 8000, 9000});
}

TEST_CASE("every solver sees a held row from its instant on, on a tick and between two") {
  const Folder folder;
  const std::string file = folder.file("steps.csv", "time [s],x [m]\n0,0\n0.3,1\n0.57,3\n2,3\n");
  for (const char* solver : {"euler", "heun", "rk4", "dormand_prince", "rosenbrock", "sdirk", "radau"}) {
    INFO(solver);
    const table::Table run = run_text(std::string("events: locate\nstep: 0.1 s\nstop: 1 s\nsolver: ") +
                                      solver + "\nblocks:\n  q: {block: FromFile, file: '" + file +
                                      "', column: x, interpolation: hold}\n  i: {block: Integrator, u: q}\n"
                                      "record: [i]\n");
    CHECK(column(run, "i").back() == Approx(0.27 + 3.0 * 0.43).epsilon(1e-9));
  }
}

TEST_CASE("a held record changes at its rows and not a tick late") {
  const Folder folder;
  const std::string file = folder.file("press.csv", record_text);
  require_near(played(file, "column: x, interpolation: hold", "0.4 s"), {0, 0, 4, 4, 2});
}

TEST_CASE("a record may end the run, be held, or be repeated") {
  const Folder folder;
  const std::string file = folder.file("press.csv", record_text);
  require_near(played(file, "column: x, after_end: hold", "0.7 s"), {0, 2, 4, 3, 2, 2, 2, 2});
  // The first row follows one mean interval, 0.2 s, after the last.
  require_near(played(file, "column: x, after_end: repeat", "0.8 s"), {0, 2, 4, 3, 2, 1, 0, 2, 4});
  require_near(played(file, "column: x, after_end: repeat, interpolation: hold", "0.8 s"),
               {0, 0, 4, 4, 2, 2, 0, 0, 4});
}

TEST_CASE("what nobody reads of a record may be no numbers, and times may be called t") {
  const Folder folder;
  const std::string file =
      folder.file("press.csv", "t,x [mm],by,F [N],\n1,0,Ann,,\n1.2,4000,Ann,off,\n1.4,2000,,9,\n,,,,\n");
  require_near(played(file, "column: x", "0.4 s"), {0, 2, 4, 3, 2});
  REQUIRE_THAT(refused(file, "column: x, unit: '1'"),
               Catch::Contains("'1' is not what the header of") && Catch::Contains("of 'x', which is in mm"));
  REQUIRE_THAT(refused(file, "column: F"), Catch::Contains("press.csv:3: 'off' is no number (column 'F')"));
  REQUIRE_THAT(refused(file, "column: x, prepare: [{trim: by}]"),
               Catch::Contains("press.csv:2: 'Ann' is no number (column 'by')"));
}

TEST_CASE("the example of measured records on the page of fits plays one with its header") {
  const std::string page = io::read_file(STEPWIRE_SOURCE_DIR "/engine/analyse/estimation/README.md");
  const std::string header = "t [s],x [mm],F [N]";
  REQUIRE(page.find("`" + header + "`") != std::string::npos);
  const std::size_t begin = page.find("  velocity:\n    {block: FromFile"), end = page.find("record:", begin);
  REQUIRE(end != std::string::npos);
  const std::string blocks = page.substr(begin, end - begin);
  const double w = 2.0 * std::acos(-1.0);
  std::string text = header + "\n";  // at rest for a second, two periods of 1 Hz, and at rest again
  for (int row = 0; row <= 4000; ++row) {
    const double t = 1e-3 * row, x = t > 1.0 && t < 3.0 ? 5.0 * std::sin(w * t) : 0.0;
    text += std::to_string(t) + "," + std::to_string(x) + "," + std::to_string(10.0 * x + 3.0) + "\n";
  }
  const Folder folder;
  folder.file("press.csv", text);
  const std::string yaml = "step: 1 ms\nstop: 1.9 s\nblocks:\n" + blocks + "record: [velocity, force]\n";
  std::string placed = yaml;
  for (std::size_t at = placed.find("press.csv"); at != std::string::npos;
       at = placed.find("press.csv", at + 99))
    placed.replace(at, 9, (folder.path / "press.csv").string());
  const table::Table table = run_text(placed);
  const auto &v = column(table, "velocity"), &F = column(table, "force");
  // Both are trimmed by x, to where it has moved by its threshold (velocity: 2 % of its range, force: 1 %).
  for (const std::size_t k : {300u, 800u, 1300u}) {
    const double t = 1.0 + std::asin(0.04) / w + 1e-3 * static_cast<double>(k);
    CHECK(v[k] == Approx(5e-3 * w * std::cos(w * t)).margin(1e-3));
    CHECK(F[k] == Approx(50.0 * std::sin(w * t)).margin(2.0));
  }
}

TEST_CASE("a run may begin inside of a record, and a part of it may be used") {
  const Folder folder;
  const std::string file = folder.file("press.csv", record_text);
  require_near(played(file, "column: x, start: 1.1 s", "0.3 s"), {2, 4, 3, 2});
  require_near(played(file, "column: x, from: 1.2 s", "0.2 s"), {4, 3, 2});
  require_near(played(file, "column: x, to: 1.2 s, after_end: hold", "0.3 s"), {0, 2, 4, 4});
}

TEST_CASE("two columns of a MAT file without times are a vector over the sample time") {
  const Folder folder;
  const table::Table table{{{"u", "", {1, 2, 3, 4}}, {"v", "", {10, 20, 30, 40}}}};
  mat::write_mat((folder.path / "uv.mat").string(), table);
  const table::Table run = run_text(
      "step: 0.1 s\nstop: 0.3 s\nblocks:\n  uv: {block: FromFile, file: '" +
      (folder.path / "uv.mat").string() +
      "', column: [u, v], sample_time: 0.1 s}\n  v: {block: Select, u: uv, indices: [2]}\nrecord: [v]\n");
  require_near(column(run, "v"), {10, 20, 30, 40});
}

TEST_CASE("a band-limited record is its periodic signal between the rows") {
  const Folder folder;
  const auto signal = [](double t) {
    return 1.0 + 2.0 * std::sin(2.0 * M_PI * t) + std::cos(6.0 * M_PI * t);
  };
  table::Table rows{{{"time", "s", {}}, {"u", "", {}}}};
  for (int i = 0; i < 8; ++i) {
    rows.columns[0].values.push_back(i / 8.0);
    rows.columns[1].values.push_back(signal(i / 8.0));
  }
  const std::string file = folder.file("u.csv", table::csv_text(rows));
  const auto y = played(file, "column: u, interpolation: band_limited", "2 s");
  for (std::size_t i = 0; i < y.size(); ++i)
    REQUIRE(y[i] == Approx(signal(static_cast<double>(i) * 0.1)).margin(1e-12));
}

TEST_CASE("what is wrong in a record is told with the file and the row") {
  const Folder folder;
  const std::string good = folder.file("press.csv", record_text);
  REQUIRE_THAT(refused(good, "column: y"), Catch::Contains("no column 'y'") && Catch::Contains("x, F_N"));
  REQUIRE_THAT(refused(good, "column: x, time: t"),
               Catch::Contains("no column 't'") && Catch::Contains("sample_time"));
  REQUIRE_THAT(refused(good, "column: x, start: 3 s"), Catch::Contains("3 s is not in the record"));
  REQUIRE_THAT(refused(good, "column: x, unit: furlongs of string"), Catch::Contains("is no unit"));
  REQUIRE_THAT(refused(good, "column: x, start: 1e300 s, after_end: repeat"), Catch::Contains("y.start"));
  const std::string endless = folder.file("endless.csv", "time,x\n-1e308,1\n1e308,2\n");
  REQUIRE_THAT(refused(endless, "column: x"), Catch::Contains("are no record"));
  const std::string back = folder.file("back.csv", "time,x\n0,1\n0.2,2\n0.1,3\n");
  REQUIRE_THAT(refused(back, "column: x"), Catch::Contains("back.csv:4") && Catch::Contains("must increase"));
  const std::string hole = folder.file("hole.csv", "time,x\n0,1\n0.2,nan\n0.3,3\n");
  REQUIRE_THAT(refused(hole, "column: x"),
               Catch::Contains("hole.csv:3: x has no value; say `missing: hold`"));
  const std::string uneven = folder.file("uneven.csv", "time,x\n0,1\n0.2,2\n0.3,3\n");
  REQUIRE_THAT(refused(uneven, "column: x, interpolation: band_limited"), Catch::Contains("evenly spaced"));
}

TEST_CASE("a column is suggested for one that is not there") {
  const Folder folder;
  const std::string file = folder.file("press.csv", record_text);
  REQUIRE_THAT(refused(file, "column: F_n"), Catch::Contains("did you mean 'F_N'? It has: time, x, F_N"));
  REQUIRE_THAT(refused(file, "column: x, time: tim"), Catch::Contains("did you mean 'time'?"));
}

TEST_CASE("a column in degC is a temperature, and one in W/degC a factor of differences") {
  const Folder folder;
  std::filesystem::create_directories(folder.path);
  const std::string file = folder.file("warm.csv", "time,room [degC],k [W/degC]\n0,20,2\n1,25,2\n");
  const auto with = [&](const std::string& block) {
    return error_of("step: 0.1 s\nstop: 0.3 s\nblocks:\n  room: {block: FromFile, file: '" + file +
                    "', column: room}\n  k: {block: FromFile, file: '" + file + "', column: k}\n" + block +
                    "record: [room, k]\n");
  };
  const std::string refused = "takes a difference of temperatures";
  REQUIRE_THAT(with("  g: {block: Gain, u: room, gain: 2 W/degC}\n"), Catch::Contains(refused));
  REQUIRE_THAT(with("  p: {block: Product, u: [room, k]}\n"), Catch::Contains(refused));
  const std::string rise = "  rise: {block: Sum, signs: \"+-\", u: [room, 18 degC]}\n";
  REQUIRE(with(rise + "  p: {block: Product, u: [rise, k]}\n").empty());
}

TEST_CASE("a column whose name says a unit that nothing else says is not taken for SI") {
  const Folder folder;
  const std::string file = folder.file("named.csv", "time,x_mm,F_N,u_in\n0,1,2,3\n0.4,5,6,7\n");
  REQUIRE_THAT(refused(file, "column: x_mm"),
               Catch::Contains("named.csv") && Catch::Contains("say `unit: mm`"));
  REQUIRE(refused(file, "column: x_mm, unit: mm").empty());
  REQUIRE(refused(file, "column: F_N").empty());
  REQUIRE(refused(file, "column: u_in").empty());
  const std::string fast = folder.file("fast.csv", "t_ms,x\n0,1\n400,5\n");
  REQUIRE_THAT(refused(fast, "column: x, time: t_ms"), Catch::Contains("t_ms [ms]"));
  const std::string logger = folder.file("logger.csv", "millis,ms,time,x\n0,0,0,1\n400,400,0.4,5\n");
  REQUIRE_THAT(refused(logger, "column: x, time: millis"), Catch::Contains("write `millis [ms]` there"));
  REQUIRE_THAT(refused(logger, "column: x, time: ms"), Catch::Contains("write `ms [ms]` there"));
  REQUIRE(refused(logger, "column: x").empty());
}

TEST_CASE("rows that are no numbers, no rows, and times that stand still are told with their place") {
  const Folder folder;
  const auto message = [&](const std::string& rows) {
    return refused(folder.file("bad.csv", rows), "column: x");
  };
  REQUIRE_THAT(message("time,x\n0,1\n0.1,\n0.2,3\n"), Catch::Contains("bad.csv:3: x has no value"));
  REQUIRE_THAT(message("time,x\n0,1\n0.1,off\n0.2,3\n"), Catch::Contains("bad.csv:3: 'off' is no number"));
  REQUIRE_THAT(message("time,x\n0,1\n0.1\n0.2,3\n"), Catch::Contains("bad.csv:3: 1 value where"));
  REQUIRE_THAT(message("time,x\n0,1\n0.1,2\n0.1,3\n0.1,4\n"),
               Catch::Contains("bad.csv:5: time is 0.1, as in the two rows before"));
  REQUIRE_THAT(message("time,x\n0,1\n0.1,inf\n"),
               Catch::Contains("bad.csv:3: x is inf; every row must be a finite"));
  REQUIRE_THAT(message("time,x\nnan,1\n0.1,2\n"), Catch::Contains("bad.csv:2: time has no value"));
  REQUIRE_THAT(message("time,x\n0,1\n"), Catch::Contains("1 row in use"));
  REQUIRE_THAT(message("time,x\n"), Catch::Contains("no rows below the header"));
  REQUIRE_THAT(message(""), Catch::Contains("the file is empty"));
}

TEST_CASE("columns of a MAT file that differ in length are refused") {
  const Folder folder;
  mat::write_mat((folder.path / "odd.mat").string(),
                 table::Table{{{"time", "", {0, 0.1, 0.2}}, {"x", "", {1, 2}}}});
  REQUIRE_THAT(refused((folder.path / "odd.mat").string(), "column: x"),
               Catch::Contains("x has 2 rows, but there are 3 times"));
}

TEST_CASE("a run that is longer than its record ends after its last row and says so") {
  const Folder folder;
  REQUIRE_THAT(refused(folder.file("short.csv", "time,x\n0,1\n0.1,2\n"), "column: x"),
               Catch::Contains("y: the record is over") && Catch::Contains("at 0.2 s"));
}

TEST_CASE("a run whose last row is beyond its record says so") {
  const Folder folder;
  REQUIRE_THAT(refused(folder.file("short.csv", "time,x\n0,1\n0.1,2\n"), "column: x", "0.2 s"),
               Catch::Contains("y: the record is over") && Catch::Contains("at 0.2 s"));
}

TEST_CASE("a measured record of a press is read") {
  const char* data = std::getenv("STEPWIRE_DATA");
  if (!data || !*data) {
    WARN("skipped: STEPWIRE_DATA is not set");
    return;
  }
  const table::Table run = run_text(R"(
step: 1 ms
stop: 1 s
blocks:
  x: {block: FromFile, file: data/mr_damper_press/5mm3Hz_0A.csv, column: x_mm, unit: mm, time: t_s}
record: [x]
)");
  REQUIRE(column(run, "x").front() == Approx(-0.029924).epsilon(1e-12));  // the first row as the file has it
}
