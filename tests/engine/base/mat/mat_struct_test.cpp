#include <hdf5.h>
#include <matio.h>

#include <array>
#include <catch2/catch.hpp>
#include <cstdint>

#include "engine/base/mat/mat_file.hpp"
#include "engine/base/table/table_file.hpp"
#include "tests/engine/base/table/scratch.hpp"

namespace stepwire::mat {

namespace {

using Values = std::vector<double>;

matvar_t* doubles(const char* name, std::size_t rows, std::size_t columns, Values values) {
  std::array<std::size_t, 2> size{rows, columns};
  return Mat_VarCreate(name, MAT_C_DOUBLE, MAT_T_DOUBLE, 2, size.data(), values.data(), 0);
}

matvar_t* structs(const char* name, std::size_t count, std::vector<const char*> fields) {
  std::array<std::size_t, 2> size{1, count};
  return Mat_VarCreateStruct(name, 2, size.data(), fields.data(), static_cast<unsigned>(fields.size()));
}

/// Writes the file that Simulink's block To Workspace saves as "Structure With Time": two signals of one and
/// two columns.
void write_structure_with_time(const std::string& path, mat_ft version) {
  mat_t* const file = Mat_CreateVer(path.c_str(), nullptr, version);
  REQUIRE(file);
  matvar_t* const signals = structs("signals", 2, {"values", "label"});
  std::array<std::size_t, 2> letters{1, 5};
  const auto label = [&] {
    return Mat_VarCreate("label", MAT_C_CHAR, MAT_T_UINT8, 2, letters.data(), const_cast<char*>("force"), 0);
  };
  Mat_VarSetStructFieldByName(signals, "values", 0, doubles("values", 3, 1, {1, 2, 3}));
  Mat_VarSetStructFieldByName(signals, "label", 0, label());
  Mat_VarSetStructFieldByName(signals, "values", 1, doubles("values", 3, 2, {4, 5, 6, 7, 8, 9}));
  Mat_VarSetStructFieldByName(signals, "label", 1, label());
  matvar_t* const out = structs("out", 1, {"time", "signals"});
  Mat_VarSetStructFieldByName(out, "time", 0, doubles("time", 3, 1, {0, 0.1, 0.2}));
  Mat_VarSetStructFieldByName(out, "signals", 0, signals);
  CHECK(Mat_VarWrite(file, out, MAT_COMPRESSION_NONE) == 0);
  Mat_VarFree(out);
  Mat_Close(file);
}

std::string words(std::uint32_t first, std::uint32_t second) {
  std::string bytes(8, '\0');
  for (unsigned i = 0; i < 4; ++i) {
    bytes[i] = static_cast<char>(first >> 8 * i & 0xFF);
    bytes[4 + i] = static_cast<char>(second >> 8 * i & 0xFF);
  }
  return bytes;
}

std::string text_element(std::string text) {
  const auto length = static_cast<std::uint32_t>(text.size());
  text.resize((text.size() + 7) / 8 * 8);
  return words(1, length) + text;  // miINT8
}

/// A MAT file of level 5 with an object of a newer class, whose numbers MATLAB keeps apart: flags of the
/// class mxOPAQUE (17), the name, the system of types and the class.
std::string file_with_object(const std::string& name, const std::string& class_name) {
  std::string header = "MATLAB 5.0 MAT-file";
  header.resize(124, ' ');
  const std::string object =
      words(6, 8) + words(17, 0) + text_element(name) + text_element("MCOS") + text_element(class_name);
  return header + std::string("\x00\x01IM", 4) + words(14, static_cast<std::uint32_t>(object.size())) +
         object;
}

void put_class(hid_t object, const std::string& name) {
  const hid_t type = H5Tcopy(H5T_C_S1), space = H5Screate(H5S_SCALAR);
  H5Tset_size(type, name.size());
  const hid_t attribute = H5Acreate2(object, "MATLAB_class", type, space, H5P_DEFAULT, H5P_DEFAULT);
  REQUIRE(H5Awrite(attribute, type, name.data()) >= 0);
  H5Aclose(attribute);
  H5Sclose(space);
  H5Tclose(type);
}

/// Datasets of an HDF5 file; a class for those that MATLAB wrote.
class Hdf5File {
 public:
  explicit Hdf5File(std::string path) : path_(std::move(path)) {
    const hid_t creation = H5Pcreate(H5P_FILE_CREATE);
    H5Pset_userblock(creation, 512);
    file_ = H5Fcreate(path_.c_str(), H5F_ACC_TRUNC, creation, H5P_DEFAULT);
    H5Pclose(creation);
  }

  void add(const char* name, const Values& values, const std::string& class_name) {
    const hsize_t count = values.size();
    const hid_t space = H5Screate_simple(1, &count, nullptr);
    const hid_t set = H5Dcreate2(file_, name, H5T_IEEE_F64LE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    REQUIRE(H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) >= 0);
    if (!class_name.empty()) put_class(set, class_name);
    H5Dclose(set);
    H5Sclose(space);
  }

  /// Closes the file and writes the header of level 7.3.
  void finish() {
    H5Fclose(file_);
    std::fstream file(path_, std::ios::binary | std::ios::in | std::ios::out);
    std::string header = "MATLAB 7.3 MAT-file";
    header.resize(124, ' ');
    file << header << '\0' << '\x02' << "IM";
  }

 private:
  std::string path_;
  hid_t file_;
};

}  // namespace

TEST_CASE("fields of structs are columns with their path, and texts in them are passed over") {
  for (const mat_ft version : {MAT_FT_MAT5, MAT_FT_MAT73}) {
    const Scratch scratch;
    write_structure_with_time(scratch.path("a.mat"), version);
    const table::RecordTable table = read_mat(scratch.path("a.mat"));
    INFO(version);
    REQUIRE(table.columns.size() == 4);
    CHECK(table.find("out.time")->values == Values{0, 0.1, 0.2});
    CHECK(table.find("out.signals(1).values")->values == Values{1, 2, 3});
    CHECK(table.find("out.signals(2).values(1)")->values == Values{4, 5, 6});
    CHECK(table.find("out.signals(2).values(2)")->values == Values{7, 8, 9});
    CHECK(table.problems.empty());
  }
}

TEST_CASE("an object is refused with its name, its class and the cure in MATLAB") {
  const Scratch scratch;
  CHECK_THROWS_WITH(
      read_mat(scratch.file("a.mat", file_with_object("ts", "timeseries"))),
      Catch::EndsWith(
          "a.mat: 'ts' is an object of the class timeseries, which MATLAB alone can read; save numbers "
          "in MATLAB: `t = ts.Time; x = ts.Data; save('f.mat', 't', 'x', '-v7')`"));
  CHECK_THROWS_WITH(read_mat(scratch.file("a.mat", file_with_object("run", "timetable"))),
                    Catch::Contains("'run' is an object of the class timetable") &&
                        Catch::Contains("x = run.Variables; save("));
}

TEST_CASE("in a file of level 7.3 an object is a problem beside arrays, which are read") {
  const Scratch scratch;
  Hdf5File file(scratch.path("a.mat"));
  file.add("x", {1, 2, 3}, "double");
  file.add("ts", {5, 6}, "timeseries");
  file.finish();
  const table::RecordTable table = read_mat(scratch.path("a.mat"));
  CHECK(table.find("x")->values == Values{1, 2, 3});
  CHECK_THAT(table.problems.at("ts"), Catch::Contains("a.mat: 'ts' is an object of the class timeseries"));
}

TEST_CASE("an HDF5 file that other programs wrote is read under the name of a MAT file, too") {
  const Scratch scratch;
  Hdf5File file(scratch.path("a.mat"));
  file.add("x", {1, 2, 3}, "");
  file.finish();
  CHECK(read_mat(scratch.path("a.mat")).find("x")->values == Values{1, 2, 3});
}

}  // namespace stepwire::mat
