// Files of others, made by the library itself, and files that are damaged.
#include <hdf5.h>

#include <catch2/catch.hpp>
#include <random>

#include "engine/base/hdf5/handle.hpp"
#include "engine/base/hdf5/hdf5_read.hpp"
#include "engine/base/io/environment_error.hpp"
#include "engine/base/io/file.hpp"
#include "engine/base/table/table_file.hpp"
#include "tests/engine/base/table/scratch.hpp"

namespace stepwire::hdf5 {

using Catch::Contains;
using Catch::EndsWith;

namespace {

using Values = std::vector<double>;

struct Pair {
  std::int32_t count;
  float force;
};

/// A session comes before the first call of the library, which closes nothing at the end of the program then.
hid_t created(const std::string& path) {
  const Session session;
  return H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
}

void put(hid_t file, const char* name, hid_t type, const std::vector<hsize_t>& size, const void* content) {
  const hid_t space = H5Screate_simple(static_cast<int>(size.size()), size.data(), nullptr);
  const hid_t set = H5Dcreate2(file, name, type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  REQUIRE(set >= 0);
  if (content) CHECK(H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, content) >= 0);
  H5Dclose(set);
  H5Sclose(space);
}

void put_pairs(hid_t file) {
  const std::vector<Pair> pairs{{1, 0.5f}, {2, 0.25f}};
  const hid_t type = H5Tcreate(H5T_COMPOUND, sizeof(Pair));
  H5Tinsert(type, "count", offsetof(Pair, count), H5T_NATIVE_INT32);
  H5Tinsert(type, "force", offsetof(Pair, force), H5T_NATIVE_FLOAT);
  put(file, "pairs", type, {2}, pairs.data());
  H5Tclose(type);
}

void put_flags(hid_t file) {
  const std::vector<std::int8_t> flags{0, 1};
  const hid_t type = H5Tenum_create(H5T_NATIVE_INT8);
  H5Tenum_insert(type, "FALSE", &flags[0]);
  H5Tenum_insert(type, "TRUE", &flags[1]);
  put(file, "flags", type, {2}, flags.data());
  H5Tclose(type);
}

/// Whole numbers in the other order of bytes, a matrix, members, flags, and what holds no columns.
void write_by_library(const std::string& path) {
  const hid_t file = created(path);
  const std::vector<std::int16_t> whole{0x0100, 0x0200};
  const Values numbers{1, 2, 3, 4, 5, 6, 7, 8};
  put(file, "whole", H5T_STD_I16BE, {2}, whole.data());
  put(file, "matrix", H5T_NATIVE_DOUBLE, {3, 2}, numbers.data());
  put(file, "cube", H5T_NATIVE_DOUBLE, {2, 2, 2}, numbers.data());
  put(file, "huge", H5T_NATIVE_DOUBLE, {0}, nullptr);
  put_pairs(file);
  put_flags(file);
  H5Gclose(H5Gcreate2(file, "rig", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
  put(file, "rig/x", H5T_NATIVE_DOUBLE, {8}, numbers.data());
  H5Lcreate_hard(file, "/", file, "rig/again", H5P_DEFAULT, H5P_DEFAULT);
  H5Lcreate_external("/etc/hostname", "/", file, "outside", H5P_DEFAULT, H5P_DEFAULT);
  H5Fclose(file);
}

std::string refusal(const std::string& path) {
  try {
    read_hdf5(path);
  } catch (const table::TableError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("HDF5 files of others are read: integers, matrices, members, flags, groups") {
  const Scratch scratch;
  write_by_library(scratch.path("a.h5"));
  const table::RecordTable table = read_hdf5(scratch.path("a.h5"));
  CHECK(table.find("whole")->values == Values{1.0, 2.0});
  CHECK(table.find("matrix(1)")->values == Values{1.0, 3.0, 5.0});
  CHECK(table.find("matrix(2)")->values == Values{2.0, 4.0, 6.0});
  CHECK(table.find("pairs.count")->values == Values{1.0, 2.0});
  CHECK(table.find("pairs.force")->values == Values{0.5, 0.25});
  CHECK(table.find("flags")->values == Values{0.0, 1.0});
  CHECK(table.find("rig/x")->values.size() == 8);
  CHECK_THAT(table.problems.at("cube"), EndsWith("a.h5: 'cube' has more than two dimensions"));
}

TEST_CASE("a group inside of itself and links out of the file lead nowhere") {
  const Scratch scratch;
  write_by_library(scratch.path("a.h5"));
  for (const table::Column& column : read_hdf5(scratch.path("a.h5")).columns) {
    INFO(column.name);
    CHECK(column.name.find("rig/again/rig/again") == std::string::npos);
    CHECK(column.name.find("outside") == std::string::npos);
  }
}

TEST_CASE("numbers that a small file has not are not made") {
  const Scratch scratch;
  const hid_t file = created(scratch.path("a.h5"));
  put(file, "huge", H5T_NATIVE_DOUBLE, {hsize_t{1} << 40}, nullptr);
  H5Fclose(file);
  CHECK_THAT(refusal(scratch.path("a.h5")), Contains("more than a file of this size may unpack to"));
}

TEST_CASE("what is no HDF5 file, is empty or is not there is told in one line") {
  const Scratch scratch;
  CHECK_THAT(refusal(scratch.file("a.h5", "time,x\n0,1\n")), Contains("a.h5: this is no HDF5 file"));
  CHECK_THAT(refusal(scratch.file("b.h5", "")), Contains("b.h5: this is no HDF5 file"));
  CHECK_THROWS_AS(read_hdf5(scratch.path("none.h5")), io::EnvironmentError);
  H5Fclose(created(scratch.path("c.h5")));
  CHECK_THAT(refusal(scratch.path("c.h5")), EndsWith("c.h5: there is no dataset in the file"));
}

TEST_CASE("a file that was cut off is an error, and a damaged one an error or a table", "[full]") {
  const Scratch scratch;
  const std::string path = scratch.path("a.h5");
  write_by_library(path);
  const std::string whole = io::read_file(path);
  std::mt19937 random(1);
  for (int i = 0; i < 300; ++i) {
    std::string damaged = whole;
    const bool cut = i % 3 == 0;
    if (cut) damaged.resize(random() % whole.size());
    for (int k = 0; k < i % 7 && !cut; ++k) damaged[random() % whole.size()] = static_cast<char>(random());
    scratch.file("a.h5", damaged);
    INFO(i << ": " << damaged.size() << " of " << whole.size());
    const std::string told = refusal(path);
    if (cut) CHECK_FALSE(told.empty());
    CHECK(told.find('\n') == std::string::npos);
  }
}

}  // namespace stepwire::hdf5
