#include <fmt/format.h>
#include <matio.h>

#include <memory>

#include "engine/base/mat/mat_elements.hpp"
#include "engine/base/table/table_file.hpp"

namespace stepwire::mat {
namespace {

struct Free {
  void operator()(mat_t* file) const { Mat_Close(file); }
  void operator()(matvar_t* variable) const { Mat_VarFree(variable); }
};
using MatFile = std::unique_ptr<mat_t, Free>;
using Variable = std::unique_ptr<matvar_t, Free>;

/// What the library says first of a file.
std::string& complaint() {
  static std::string text;
  return text;
}

void listen() {
  complaint().clear();
  Mat_LogInitFunc("stepwire", [](int, char* message) {
    if (complaint().empty()) complaint() = message;
  });
}

std::vector<std::size_t> size_of(const matvar_t& variable) {
  if (variable.rank <= 0 || !variable.dims) return {0};
  return {variable.dims, variable.dims + variable.rank};
}

/// Kind of the numbers that the library makes of a class; nothing for other classes.
MatNumber kind_of(matio_classes type) {
  switch (type) {
    case MAT_C_DOUBLE:
      return MatNumber::float64;
    case MAT_C_SINGLE:
      return MatNumber::float32;
    case MAT_C_INT8:
      return MatNumber::int8;
    case MAT_C_UINT8:
      return MatNumber::uint8;
    case MAT_C_INT16:
      return MatNumber::int16;
    case MAT_C_UINT16:
      return MatNumber::uint16;
    case MAT_C_INT32:
      return MatNumber::int32;
    case MAT_C_UINT32:
      return MatNumber::uint32;
    case MAT_C_INT64:
      return MatNumber::int64;
    case MAT_C_UINT64:
      return MatNumber::uint64;
    default:
      return MatNumber{};
  }
}

bool is_real_array(const matvar_t& variable) {
  return kind_of(variable.class_type) != MatNumber{} && !variable.isComplex &&
         mat_count(size_of(variable)) > 0;
}

std::string text_of(const matvar_t* cell) {
  if (!cell || cell->class_type != MAT_C_CHAR || !cell->data) return "";
  const std::string_view bytes(static_cast<const char*>(cell->data), cell->nbytes);
  const std::uint32_t type = cell->data_size == 1   ? MatElement::utf8
                             : cell->data_size == 2 ? MatElement::utf16
                                                    : MatElement::utf32;
  return mat_text({"", false}, {type, bytes.size(), bytes});
}

/// Reads one file; complaints of the library about it end the reading.
class Level7 {
 public:
  Level7(const std::string& path, std::size_t file_size)
      : budget_(table::max_unpacked(file_size)), most_(budget_) {
    listen();
    file_.reset(Mat_Open(path.c_str(), MAT_ACC_RDONLY));
    if (!file_) fail("this is no MAT file");
  }

  MatContent read() {
    while (const Variable variable{Mat_VarReadNextInfo(file_.get())}) take(*variable);
    if (!complaint().empty()) fail("the file is damaged");
    return std::move(content_);
  }

 private:
  [[noreturn]] static void fail(const std::string& message) {
    throw table::TableError(message + (complaint().empty() ? "" : " (" + complaint() + ")"));
  }

  void take(matvar_t& variable) {
    if (!variable.name) return;
    const std::string name = variable.name;
    const bool texts = variable.class_type == MAT_C_CELL && (name == "names" || name == "units");
    if (texts) return take_texts(variable, name);
    if (is_real_array(variable)) take_numbers(variable, name);
  }

  void load(matvar_t& variable, const std::string& name, std::size_t bytes) {
    if (bytes > budget_)
      fail(
          fmt::format("'{}' unpacks to {} MB, and what lies before it to {} MB; a file of this size may "
                      "unpack to {} MB in all",
                      name, bytes >> 20, (most_ - budget_) >> 20, most_ >> 20));
    budget_ -= bytes;
    if (Mat_VarReadDataAll(file_.get(), &variable) != 0 || !variable.data || !complaint().empty())
      fail(fmt::format("'{}' cannot be read", name));
  }

  void take_numbers(matvar_t& variable, const std::string& name) {
    const MatNumber kind = kind_of(variable.class_type);
    const std::size_t bytes = mat_count(size_of(variable)) * mat_number_size(kind);
    load(variable, name, bytes);
    if (variable.nbytes != bytes)
      fail(fmt::format("'{}' has {} bytes of numbers, not {}", name, variable.nbytes, bytes));
    const std::string_view numbers(static_cast<const char*>(variable.data), bytes);
    content_.variables.push_back({name, size_of(variable), mat_numbers(numbers, kind, false)});
  }

  void take_texts(matvar_t& variable, const std::string& name) {
    const std::size_t count = mat_count(size_of(variable));
    load(variable, name, count);
    const auto* const* const cells = static_cast<const matvar_t* const*>(variable.data);
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < count; ++i) texts.push_back(text_of(cells[i]));
    (name == "names" ? content_.names : content_.units) = std::move(texts);
  }

  std::size_t budget_, most_;
  MatFile file_;
  MatContent content_;
};

}  // namespace

MatContent read_mat_level_7(const std::string& path, std::size_t file_size) {
  return Level7(path, file_size).read();
}

}  // namespace stepwire::mat
