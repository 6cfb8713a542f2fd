#include <fmt/format.h>
#include <matio.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <memory>
#include <mutex>
#include <numeric>
#include <set>

#include "engine/table/file.hpp"
#include "engine/table/mat_check.hpp"

namespace stepwire {
namespace {

struct Free {
  void operator()(mat_t* file) const { Mat_Close(file); }
  void operator()(matvar_t* variable) const { Mat_VarFree(variable); }
};
using MatFile = std::unique_ptr<mat_t, Free>;
using Variable = std::unique_ptr<matvar_t, Free>;

/// The library keeps its log, and HDF5 all it has, in variables of the program: one file at a time.
struct Library {
  std::mutex mutex;
  std::string complaint;

  static Library& the() {
    static Library library;
    return library;
  }

  void listen() {
    complaint.clear();
    Mat_LogInitFunc("stepwire", [](int, char* message) {
      if (the().complaint.empty()) the().complaint = message;
    });
  }
};

std::size_t elements(const matvar_t& variable) {
  if (variable.rank == 0 || !variable.dims) return 0;
  return std::accumulate(variable.dims, variable.dims + variable.rank, std::size_t{1},
                         [](std::size_t a, std::size_t b) {
                           return b != 0 && a > std::numeric_limits<std::size_t>::max() / b
                                      ? std::numeric_limits<std::size_t>::max()
                                      : a * b;
                         });
}

bool is_real_array(const matvar_t& variable) {
  const bool numeric = variable.class_type >= MAT_C_DOUBLE && variable.class_type <= MAT_C_UINT64;
  return numeric && !variable.isComplex && elements(variable) > 0;
}

template <class T>
std::vector<double> converted(const matvar_t& variable) {
  const T* const first = static_cast<const T*>(variable.data);
  return {first, first + elements(variable)};
}

std::vector<double> numbers(const matvar_t& variable) {
  switch (variable.class_type) {
    case MAT_C_SINGLE:
      return converted<float>(variable);
    case MAT_C_INT8:
      return converted<std::int8_t>(variable);
    case MAT_C_UINT8:
      return converted<std::uint8_t>(variable);
    case MAT_C_INT16:
      return converted<std::int16_t>(variable);
    case MAT_C_UINT16:
      return converted<std::uint16_t>(variable);
    case MAT_C_INT32:
      return converted<std::int32_t>(variable);
    case MAT_C_UINT32:
      return converted<std::uint32_t>(variable);
    case MAT_C_INT64:
      return converted<std::int64_t>(variable);
    case MAT_C_UINT64:
      return converted<std::uint64_t>(variable);
    default:
      return converted<double>(variable);
  }
}

/// A vector is one column; of anything larger each column is one.
void append_columns(Table& table, const matvar_t& variable) {
  const std::vector<double> all = numbers(variable);
  const std::size_t longest = *std::max_element(variable.dims, variable.dims + variable.rank);
  const std::size_t rows = longest == all.size() ? all.size() : variable.dims[0];
  for (std::size_t first = 0; first < all.size(); first += rows) {
    const std::string index = rows == all.size() ? "" : fmt::format("({})", first / rows + 1);
    const auto begin = all.begin() + static_cast<std::ptrdiff_t>(first);
    table.columns.push_back({variable.name + index, "", {begin, begin + static_cast<std::ptrdiff_t>(rows)}});
  }
}

void append_utf8(std::string& text, std::uint32_t code) {
  if (code < 0x80) {
    text += static_cast<char>(code);
  } else if (code < 0x800) {
    text += {static_cast<char>(0xC0 | code >> 6), static_cast<char>(0x80 | (code & 0x3F))};
  } else {
    text += {static_cast<char>(0xE0 | code >> 12), static_cast<char>(0x80 | (code >> 6 & 0x3F)),
             static_cast<char>(0x80 | (code & 0x3F))};
  }
}

std::string text_of(const matvar_t* cell) {
  std::string text;
  if (!cell || cell->class_type != MAT_C_CHAR || !cell->data) return text;
  const std::size_t count = cell->nbytes / static_cast<std::size_t>(std::max(cell->data_size, 1));
  if (cell->data_size == 1) return {static_cast<const char*>(cell->data), count};
  for (std::size_t i = 0; i < count && cell->data_size == 2; ++i) {
    append_utf8(text, static_cast<const std::uint16_t*>(cell->data)[i]);
  }
  return text;
}

std::vector<std::string> texts_of(const matvar_t& variable) {
  std::vector<std::string> texts;
  const auto* const* const cells = static_cast<const matvar_t* const*>(variable.data);
  for (std::size_t i = 0; cells && i < elements(variable); ++i) texts.push_back(text_of(cells[i]));
  return texts;
}

/// Reads one file; complaints of the library about it end the reading.
class Mat {
 public:
  explicit Mat(const std::string& path) : path_(path) {
    Library::the().listen();
    file_.reset(Mat_Open(path.c_str(), MAT_ACC_RDONLY));
    if (!file_) fail("this is no MAT file");
  }

  Table read() {
    while (const Variable variable{Mat_VarReadNextInfo(file_.get())}) take(*variable);
    if (!Library::the().complaint.empty()) fail("the file is damaged");
    if (table_.columns.empty()) fail("there is no real vector in the file");
    name_columns();
    return std::move(table_);
  }

 private:
  [[noreturn]] void fail(const std::string& message) const {
    const std::string& complaint = Library::the().complaint;
    throw TableError(
        fmt::format("{}: {}{}", path_, message, complaint.empty() ? "" : " (" + complaint + ")"));
  }

  void take(matvar_t& variable) {
    const bool text =
        variable.class_type == MAT_C_CELL && variable.name &&
        (variable.name == std::string_view("names") || variable.name == std::string_view("units"));
    if (!variable.name || (!text && !is_real_array(variable))) return;
    load(variable);
    if (text) {
      (variable.name[0] == 'n' ? names_ : units_) = texts_of(variable);
    } else {
      append_columns(table_, variable);
    }
  }

  void load(matvar_t& variable) const {
    // A damaged size is not tried: deflate packs a thousandfold at best.
    const std::uintmax_t most = std::filesystem::file_size(path_) * 1100;
    const bool believable = elements(variable) <= most;
    if (!believable || Mat_VarReadDataAll(file_.get(), &variable) != 0 || !variable.data) {
      fail(fmt::format("'{}' cannot be read", variable.name));
    }
  }

  /// Files of our own keep the names of their columns, which MATLAB would not allow, and their units.
  void name_columns() {
    const std::size_t count = table_.columns.size();
    if (names_.size() == count && units_.size() == count) {
      for (std::size_t i = 0; i < count; ++i) {
        table_.columns[i].name = names_[i];
        table_.columns[i].unit = units_[i];
      }
    }
    std::set<std::string_view> seen;
    for (const Column& column : table_.columns) {
      if (!seen.insert(column.name).second) fail(fmt::format("two columns are named '{}'", column.name));
    }
  }

  const std::string& path_;
  MatFile file_;
  Table table_;
  std::vector<std::string> names_, units_;
};

}  // namespace

Table read_mat(const std::string& path) {
  check_mat_layout(path);
  const std::lock_guard lock(Library::the().mutex);
  return Mat(path).read();
}

}  // namespace stepwire
