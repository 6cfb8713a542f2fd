#include "engine/base/hdf5/matlab_file.hpp"
#include "engine/base/mat/mat_content.hpp"
#include "engine/base/mat/mat_elements.hpp"
#include "engine/base/mat/mat_unreadable.hpp"

namespace stepwire::mat {
namespace {

std::string problem_of(const hdf5::MatlabOther& other) {
  using Kind = hdf5::MatlabOther::Kind;
  switch (other.kind) {
    case Kind::complex:
      return unreadable_text(other.name, MatUnreadable::complex);
    case Kind::sparse:
      return unreadable_text(other.name, MatUnreadable::sparse);
    case Kind::cell:
      return unreadable_text(other.name, MatUnreadable::cell);
    case Kind::function:
      return unreadable_text(other.name, MatUnreadable::function);
    case Kind::struct_array:
      return unreadable_text(other.name, MatUnreadable::struct_array);
    case Kind::outside:
      return "'" + other.name + "' lies in other files, which are not read";
    case Kind::object:
      break;
  }
  return unreadable_text(other.name, MatUnreadable::object, other.class_name);
}

}  // namespace

MatContent read_mat_level_7(const std::string& path, std::size_t file_size) {
  hdf5::MatlabContent from = hdf5::read_matlab(path, file_size, {max_structs, max_depth}, {"names", "units"});
  MatContent content;
  content.has_foreign = from.has_foreign;
  for (hdf5::MatlabArray& array : from.arrays)
    content.variables.push_back({std::move(array.name), std::move(array.size), std::move(array.values)});
  for (const hdf5::MatlabOther& other : from.others)
    content.problems.push_back({other.name, problem_of(other)});
  for (const hdf5::MatlabTexts& list : from.texts) {
    std::vector<std::string>& texts = list.name == "names" ? content.names : content.units;
    for (const std::vector<double>& units : list.texts) texts.push_back(utf16_text(units));
  }
  return content;
}

}  // namespace stepwire::mat
