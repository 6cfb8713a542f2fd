#include "engine/base/data_file/data_file.hpp"
#include "engine/base/io/environment_error.hpp"
#include "engine/base/table/table_file.hpp"
#include "tests/fuzz/input_file.hpp"

using namespace stepwire;

// Any bytes must give a table, or one of the two errors.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static fuzz::InputFile file("." KIND);
  try {
    data_file::read_data_file(file.with(data, size));
  } catch (const table::TableError&) {
  } catch (const io::EnvironmentError&) {
  }
  return 0;
}
