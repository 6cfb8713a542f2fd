#include <matio.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <random>
#include <set>

#include "engine/base/mat/mat_file.hpp"
#include "engine/base/table/table_file.hpp"
#include "tests/engine/base/mat/mat_samples.hpp"
#include "tests/engine/base/table/scratch.hpp"

namespace stepwire::mat {
using stepwire::testing::write_by_library;

namespace {

using Values = std::vector<double>;

void check_library_file(mat_ft version) {
  const Scratch scratch;
  write_by_library(scratch.path("a.mat"), version);
  const table::RecordTable table = read_mat(scratch.path("a.mat"));
  CHECK_THAT(table.problems.at("complex"),
             Catch::EndsWith("a.mat: 'complex' is complex; save numbers in MATLAB: `re = real(complex); im = "
                             "imag(complex); save('f.mat', 't', 're', 'im', '-v7')`"));
  CHECK(table.columns.size() == (version == MAT_FT_MAT4 ? 6 : 8));
  CHECK(table.find("column")->values == Values{1.5, 2.5, 3.5});
  CHECK(table.find("row")->values == Values{1.5, 2.5, 3.5});
  CHECK(table.find("matrix(1)")->values == Values{1.5, 2.5});
  CHECK(table.find("matrix(3)")->values == Values{5.5, 6.5});
  if (version == MAT_FT_MAT4) return;
  CHECK(table.find("integers")->values == Values{-3.0, 300.0});
  CHECK(table.find("single")->values == Values{0.25});
}

/// Where the variables of a file end that the library wrote above: cut there, it is a whole file with fewer
/// of them.
std::set<std::size_t> piece_ends(const std::string& file, mat_ft version) {
  std::set<std::size_t> ends;
  for (std::size_t at = 128; version == MAT_FT_MAT5 && at < file.size(); ends.insert(at)) {
    std::uint32_t length = 0;
    std::memcpy(&length, file.data() + at + 4, 4);
    at += 8 + length;
  }
  // 20 bytes of header, the name with its final zero, the doubles: "column", "row", "matrix".
  if (version == MAT_FT_MAT4) ends = {20 + 7 + 24, 20 + 7 + 24 + 20 + 4 + 24, 51 + 48 + 20 + 7 + 48};
  return ends;
}

table::Table sample() {
  return {{{"time", "s", {0.0, 0.1, 0.2}},
           {"rig.x", "mm", {1.0 / 3.0, -0.0, INFINITY}},
           {"rig_x", "µm", {1.0, 2.0, 3.0}},
           {"2nd", "", {4.0, 5.0, 6.0}},
           {"end", "N m", {7.0, 8.0, 9.0}},
           {std::string(80, 'a') + ".b", "Ω", {1.0, 2.0, 3.0}}}};
}

}  // namespace

TEST_CASE("MAT files of level 4, 5 and 7.3 are read") {
  check_library_file(MAT_FT_MAT4);
  check_library_file(MAT_FT_MAT5);
  check_library_file(MAT_FT_MAT73);
}

TEST_CASE("a table comes back from a MAT file of level 5 or 7.3 with its names, units and bits") {
  const Scratch scratch;
  const table::Table table = sample();
  const bool long_columns = GENERATE(false, true);
  write_mat(scratch.path("a.mat"), table, long_columns ? 100 : max_bytes_of_level_5);
  const char level = long_columns ? '7' : '5';
  CHECK(stepwire::io::read_file(scratch.path("a.mat"))[7] == level);
  const table::Table back = stepwire::mat::read_mat(scratch.path("a.mat"));
  REQUIRE(back.columns.size() == table.columns.size());
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    CHECK(back.columns[i].name == table.columns[i].name);
    CHECK(back.columns[i].unit == table.columns[i].unit);
    CHECK(std::memcmp(back.columns[i].values.data(), table.columns[i].values.data(), 3 * sizeof(double)) ==
          0);
  }
}

TEST_CASE("another reader finds the columns under names that MATLAB allows, each once") {
  const Scratch scratch;
  const bool long_columns = GENERATE(false, true);
  write_mat(scratch.path("a.mat"), sample(), long_columns ? 100 : max_bytes_of_level_5);
  mat_t* const file = Mat_Open(scratch.path("a.mat").c_str(), MAT_ACC_RDONLY);
  REQUIRE(file);
  std::vector<std::string> names;
  while (matvar_t* const variable = Mat_VarReadNext(file)) {
    names.emplace_back(variable->name);
    if (names.back() == "rig_x") CHECK(static_cast<const double*>(variable->data)[0] == 1.0 / 3.0);
    if (names.back() == "names") CHECK(variable->class_type == MAT_C_CELL);
    Mat_VarFree(variable);
  }
  Mat_Close(file);
  if (long_columns) std::ranges::sort(names);  // level 7.3 has them in any order
  std::vector<std::string> wanted{"time",  "rig_x", "rig_x_2", "x2nd", "end_2", std::string(63, 'a'),
                                  "names", "units"};
  if (long_columns) std::ranges::sort(wanted);
  CHECK(names == wanted);
}

TEST_CASE("the same table makes the same file") {
  const Scratch scratch;
  const std::size_t max_bytes = GENERATE(false, true) ? 100 : max_bytes_of_level_5;
  write_mat(scratch.path("a.mat"), sample(), max_bytes);
  write_mat(scratch.path("b.mat"), sample(), max_bytes);
  CHECK(stepwire::io::read_file(scratch.path("a.mat")) == stepwire::io::read_file(scratch.path("b.mat")));
}

TEST_CASE("the Bouc-Wen benchmark is read as its authors describe it") {
  const char* const data = std::getenv("STEPWIRE_DATA");
  if (!data) {
    WARN("STEPWIRE_DATA is not set; the benchmark was not read");
    return;
  }
  // Validation records of 8192 samples at 750 Hz; the multisine has an rms of 50 N.
  const std::string folder = std::string(data) + "/bouc_wen_benchmark/";
  const table::Table force = read_mat(folder + "uval_multisine.mat");
  const table::Table position = read_mat(folder + "yval_multisine.mat");
  REQUIRE(force.columns.size() == 1);
  CHECK(force.columns[0].name == "uval_multisine");
  CHECK(position.columns[0].name == "yval_multisine");
  CHECK(force.rows() == 8192);
  CHECK(position.rows() == 8192);
  double squares = 0.0;
  for (const double value : force.columns[0].values) squares += value * value;
  CHECK(std::sqrt(squares / 8192.0) == Approx(50.0).epsilon(0.01));
}

TEST_CASE("what is no MAT file is said to be none") {
  const Scratch scratch;
  CHECK_THROWS_AS(read_mat(scratch.file("a.mat", "time,x\n0,1\n")), table::TableError);
  CHECK_THROWS_AS(read_mat(scratch.file("b.mat", "")), table::TableError);
  CHECK_THROWS_AS(read_mat(scratch.file("c.mat", std::string(5000, 'x'))), table::TableError);
  CHECK_THROWS_AS(read_mat(scratch.path("none.mat")), stepwire::io::EnvironmentError);
}

TEST_CASE("a damaged MAT file is an error or a table, and one that was cut off is an error") {
  const Scratch scratch;
  for (const mat_ft version : {MAT_FT_MAT4, MAT_FT_MAT5, MAT_FT_MAT73}) {
    const std::string path = scratch.path("a.mat");
    write_by_library(path, version);
    const std::string whole = stepwire::io::read_file(path);
    const std::set<std::size_t> ends = piece_ends(whole, version);
    std::mt19937 random(1);
    for (int i = 0; i < 150; ++i) {
      std::string damaged = whole;
      const bool cut = i % 3 == 0;
      if (cut) damaged.resize(random() % whole.size());
      for (int k = 0; k < i % 7 && !cut; ++k) damaged[random() % whole.size()] = static_cast<char>(random());
      scratch.file("a.mat", damaged);
      INFO(version << " " << i << " " << damaged.size() << " of " << whole.size());
      if (cut && ends.count(damaged.size()) == 0) {
        CHECK_THROWS_AS(read_mat(path), table::TableError);
      } else {
        try {
          read_mat(path);
        } catch (const table::TableError&) {
        }
      }
    }
  }
}

}  // namespace stepwire::mat
