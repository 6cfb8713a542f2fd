// Written files are read back, and have the same bytes each time. The second reader is h5py from Debian.
#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <map>
#include <numeric>

#include "engine/base/hdf5/hdf5_read.hpp"
#include "engine/base/hdf5/hdf5_writer.hpp"
#include "engine/base/io/file.hpp"
#include "engine/base/subprocess/process.hpp"
#include "tests/engine/base/table/scratch.hpp"

namespace stepwire::hdf5 {

namespace {

using Values = std::vector<double>;
const Values times{0.0, 0.1, 0.2}, positions{1.0 / 3.0, -0.0, INFINITY};
const std::vector<std::string> words{"hold", "linear"};

void write_runs(const std::string& path, const std::vector<table::RunView>& runs) {
  Hdf5Writer writer(path, "A cart, 20 µm");
  for (const table::RunView& run : runs) writer.add(run);
  writer.finish();
}

std::vector<table::RunView> one_run() {
  return {{"", {}, {{"time", "s", times}, {"cart.position", "mm", positions}, {"a", "", times}}}};
}

std::vector<table::RunView> two_runs() {
  return {
      {"run-1", {{"mass", "kg", 2.0}, {"way", "", 0.0, "hold"}}, {{"time", "s", times}, {"x", "m", times}}},
      {"run-2",
       {{"mass", "kg", 3.0}, {"way", "", 1.0, "linear"}},
       {{"time", "s", times}, {"x", "m", positions}}}};
}

void check_bits(const Values& back, std::span<const double> wanted) {
  REQUIRE(back.size() == wanted.size());
  CHECK(std::memcmp(back.data(), wanted.data(), wanted.size_bytes()) == 0);
}

/// Each column with the bits of its numbers; units and titles are texts in a heap that has no checksum.
std::map<std::string, std::vector<std::uint64_t>> numbers_of(const table::RecordTable& table) {
  std::map<std::string, std::vector<std::uint64_t>> bits;
  for (const table::Column& column : table.columns)
    for (const double value : column.values) bits[column.name].push_back(std::bit_cast<std::uint64_t>(value));
  return bits;
}

/// Returns the output of a script for Debian's python about a file; an empty text if there is no h5py.
std::string printed_by_h5py(const std::string& script, const std::string& file) {
  const auto call = [](std::vector<std::string> command) {
    return subprocess::run_process({.command = std::move(command)});
  };
  if (!call({"/usr/bin/python3", "-c", "import h5py"}).succeeded()) return "";
  return call({"/usr/bin/python3", "-c", "import h5py, sys\nf = h5py.File(sys.argv[1])\n" + script, file})
      .output;
}

}  // namespace

TEST_CASE("a run comes back from an HDF5 file with its names, units, order and bits") {
  const Scratch scratch;
  write_runs(scratch.path("a.h5"), one_run());
  const table::RecordTable back = read_hdf5(scratch.path("a.h5"));
  REQUIRE(back.columns.size() == 3);
  CHECK(back.columns[0].name == "time");
  CHECK(back.columns[0].unit == "s");
  CHECK(back.columns[1].name == "cart.position");
  CHECK(back.columns[1].unit == "mm");
  CHECK(back.columns[2].name == "a");
  CHECK(back.columns[2].unit.empty());
  check_bits(back.columns[1].values, positions);
}

TEST_CASE("rows that come piece by piece are one run, beyond a chunk, too") {
  const Scratch scratch;
  Values all(20'000);
  std::iota(all.begin(), all.end(), 0.5);
  {
    Hdf5Writer writer(scratch.path("a.h5"), "");
    writer.begin({"run-1", {{"mass", "kg", 2.0}}, {{"time", "s", {}}, {"x", "m", {}}}});
    for (std::size_t at = 0; at < all.size(); at += 3'001) {
      const auto piece =
          std::span<const double>(all).subspan(at, std::min<std::size_t>(3'001, all.size() - at));
      const std::vector<std::span<const double>> columns{piece, piece};
      writer.append(columns);
    }
    writer.add({"run-2", {}, {{"time", "s", times}}});
    writer.finish();
  }
  const table::RecordTable back = read_hdf5(scratch.path("a.h5"));
  check_bits(back.find("run-1/x")->values, all);
  CHECK(back.find("run-1/x")->unit == "m");
  CHECK(back.find("run-1/mass")->values == Values{2.0});
  CHECK(back.find("run-2/time")->values == times);
}

TEST_CASE("what was published and flushed can be read while more is written") {
  const Scratch scratch;
  // The bytes that are there, since the library opens no file again that it writes itself.
  const auto times_there = [&] {
    scratch.file("copy.h5", io::read_file(scratch.path("a.h5")));
    return read_hdf5(scratch.path("copy.h5")).find("time")->values;
  };
  Hdf5Writer writer(scratch.path("a.h5"), "");
  writer.begin({"", {}, {{"time", "s", times}}});
  CHECK_FALSE(std::filesystem::exists(scratch.path("a.h5")));
  writer.publish();
  check_bits(times_there(), times);
  const std::vector<std::span<const double>> more{positions};
  writer.append(more);
  writer.flush();
  CHECK(times_there().size() == 6);
  writer.append(more);
  writer.finish();
  CHECK(times_there().size() == 9);
}

TEST_CASE("runs of a sweep are groups with what they set") {
  const Scratch scratch;
  write_runs(scratch.path("a.h5"), two_runs());
  const table::RecordTable back = read_hdf5(scratch.path("a.h5"));
  CHECK(back.find("run-1/mass")->values == Values{2.0});
  CHECK(back.find("run-2/mass")->unit == "kg");
  check_bits(back.find("run-2/x")->values, positions);
  CHECK(back.problems.at("run-2/way") == scratch.path("a.h5") + ": 'run-2/way' holds text, not numbers");
}

TEST_CASE("groups are read by name in the order that is given, and one that is not there is passed over") {
  const Scratch scratch;
  write_runs(scratch.path("a.h5"), two_runs());
  const table::RecordTable back = read_hdf5_groups(scratch.path("a.h5"), {"run-2", "run-7", "run-1"});
  std::vector<std::string> names;
  for (const table::Column& column : back.columns) names.push_back(column.name);
  CHECK(names == std::vector<std::string>{"run-2/mass", "run-2/way", "run-2/time", "run-2/x", "run-1/mass",
                                          "run-1/way", "run-1/time", "run-1/x"});
  check_bits(back.find("run-2/x")->values, positions);
  CHECK(read_hdf5_groups(scratch.path("a.h5"), {"run-7"}).columns.empty());
}

TEST_CASE("the words that a column's numbers stand for come back") {
  const Scratch scratch;
  const Values ways{1.0, 0.0};
  write_runs(scratch.path("a.h5"), {{"", {}, {{"way", "", ways, words}, {"x", "", ways}}}});
  const table::RecordTable back = read_hdf5(scratch.path("a.h5"));
  CHECK(back.words == std::map<std::string, std::vector<std::string>>{{"way", words}});
}

TEST_CASE("rows beyond a chunk, and none at all, come back") {
  const Scratch scratch;
  Values many(20'001);
  std::iota(many.begin(), many.end(), 0.5);
  write_runs(scratch.path("a.h5"), {{"", {}, {{"many", "", many}, {"none", "", {}}}}});
  const table::RecordTable back = read_hdf5(scratch.path("a.h5"));
  check_bits(back.find("many")->values, many);
  CHECK(back.problems.at("none") == scratch.path("a.h5") + ": 'none' has no rows");
}

TEST_CASE("the same runs make the same HDF5 file") {
  const Scratch scratch;
  Values many(20'001, 1.0);
  const std::vector<table::RunView> long_run{{"", {}, {{"many", "", many, words}}}};
  for (const auto& runs : {one_run(), two_runs(), long_run}) {
    write_runs(scratch.path("a.h5"), runs);
    const std::string first = io::read_file(scratch.path("a.h5"));
    const Values moved(77, 3.0);  // other memory, and another second, must not show
    write_runs(scratch.path("b.h5"), runs);
    CHECK(io::read_file(scratch.path("b.h5")) == first);
  }
}

TEST_CASE("a file that is not finished is not there") {
  const Scratch scratch;
  { Hdf5Writer(scratch.path("a.h5"), "").add(one_run().front()); }
  CHECK(scratch.files() == 0);
}

TEST_CASE("no damaged byte of an HDF5 file gives other numbers or other names", "[full]") {
  const Scratch scratch;
  const std::string path = scratch.path("a.h5");
  const auto read_back = [&] { return numbers_of(read_hdf5(path)); };
  for (const auto& runs : {one_run(), two_runs()}) {
    write_runs(path, runs);
    const std::string whole = io::read_file(path);
    const auto right = read_back();
    std::size_t other = 0, refused = 0;
    for (std::size_t at = 0; at < whole.size(); at += 23) {
      std::string damaged = whole;
      damaged[at] = static_cast<char>(damaged[at] ^ (1 << at % 8));
      scratch.file("a.h5", damaged);
      try {
        if (read_back() != right) ++other;
      } catch (const std::exception&) {
        ++refused;
      }
    }
    CHECK(other == 0);
    CHECK(refused > 0);
  }
}

TEST_CASE("h5py reads runs with their units") {
  const Scratch scratch;
  write_runs(scratch.path("a.h5"), one_run());
  write_runs(scratch.path("b.h5"), two_runs());
  const std::string one = printed_by_h5py(
      "print(f.attrs['title'], sorted(f), f['cart.position'].attrs['units'], f['cart.position'][0] == 1/3)\n",
      scratch.path("a.h5"));
  if (one.empty()) {
    WARN("python3-h5py is not installed; no other program read the file");
    return;
  }
  CHECK(one == "A cart, 20 µm ['a', 'cart.position', 'time'] mm True\n");
  CHECK(printed_by_h5py("for name, run in f.items(): print(name, run['mass'][()], run['way'].asstr()[()], "
                        "run['x'][:2].tolist())\n",
                        scratch.path("b.h5")) ==
        "run-1 2.0 hold [0.0, 0.1]\nrun-2 3.0 linear [0.3333333333333333, -0.0]\n");
}

}  // namespace stepwire::hdf5
