// The writers of tables by themselves, among them those of files that no call of a test would fill.
#include <catch2/catch.hpp>
#include <filesystem>
#include <functional>

#include "engine/base/hdf5/hdf5_writer.hpp"
#include "engine/base/io/file.hpp"
#include "engine/base/mat/mat_file.hpp"
#include "engine/base/mcap/mcap_writer.hpp"
#include "engine/base/table/table_file.hpp"
#include "tests/engine/base/io/small_disk.hpp"
#include "tests/engine/base/table/scratch.hpp"

namespace stepwire::table {

namespace {

/// `columns` of as many rows as make a little more than `numbers`.
Table table_of(std::size_t numbers, std::size_t columns) {
  Table table;
  for (std::size_t i = 0; i < columns; ++i)
    table.columns.push_back({"c" + std::to_string(i), "m", std::vector<double>(numbers / columns + 1, 0.25)});
  return table;
}

RunView view_of(const Table& table) {
  RunView view;
  for (const Column& column : table.columns) view.series.push_back({column.name, column.unit, column.values});
  return view;
}

template <class Writer>
void write_run(const std::string& path, const Table& table) {
  Writer writer(path, "rows");
  writer.add(view_of(table));
  writer.finish();
}

/// The rows twice: with the beginning, and behind it.
void write_growing(const std::string& path, const Table& table) {
  hdf5::Hdf5Writer writer(path, "rows");
  writer.begin(view_of(table));
  std::vector<std::span<const double>> columns;
  for (const Column& column : table.columns) columns.emplace_back(column.values);
  writer.append(columns);
  writer.finish();
}

struct Kind {
  const char* name;
  std::size_t numbers;
  std::function<void(const std::string&, const Table&)> write;
};

const std::vector<Kind> kinds{
    {"csv", 3'000, [](const auto& path, const Table& table) { write_csv(path, table); }},
    {"large csv", 1'100'000, [](const auto& path, const Table& table) { write_csv(path, table); }},
    {"mat of level 5", 3'000, [](const auto& path, const Table& table) { mat::write_mat(path, table); }},
    {"mat of level 7.3", 3'000,
     [](const auto& path, const Table& table) { mat::write_mat(path, table, 100); }},
    {"large mat of level 7.3", 1'100'000,
     [](const auto& path, const Table& table) { mat::write_mat(path, table, 100); }},
    {"h5", 3'000, write_run<hdf5::Hdf5Writer>},
    {"large h5", 1'100'000, write_run<hdf5::Hdf5Writer>},
    {"h5 that grows", 30'000, write_growing},
    {"mcap", 3'000, write_run<mcap::McapWriter>},
    {"large mcap", 1'100'000, write_run<mcap::McapWriter>},
};

std::string refusal(const Kind& kind, const std::string& path, const Table& table, std::size_t bytes) {
  const SmallDisk small(bytes);
  try {
    kind.write(path, table);
  } catch (const io::EnvironmentError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("a table that the disk does not take is one line, and the file before stays whole") {
  for (const Kind& kind : kinds) {
    INFO(kind.name);
    const Scratch scratch;
    const Table table = table_of(kind.numbers, 20);
    const std::string path = scratch.path("a");
    kind.write(path, table);
    const std::size_t size = std::filesystem::file_size(path);
    for (const std::size_t bytes : {std::size_t{1}, size / 4, size / 2, size / 4 * 3, size - 1}) {
      INFO(bytes << " of " << size << " bytes");
      scratch.file("a", "former");
      CHECK(refusal(kind, path, table, bytes) == path + ": File too large");
      CHECK(io::read_file(path) == "former");
      CHECK(scratch.files() == 1);
    }
  }
}

}  // namespace stepwire::table
