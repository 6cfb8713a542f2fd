#include "engine/base/hdf5/objects.hpp"

#include <hdf5.h>

#include "engine/base/io/inside.hpp"

namespace stepwire::hdf5 {

Handle open_file(const std::string& path) {
  if (!io::is_inside(path)) Session::refuse("the file is outside of the folder of the call; name one inside");
  Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
  if (!file) {
    const bool begins_well = H5Fis_hdf5(path.c_str()) > 0;
    Session::refuse(begins_well ? "the file is damaged or cut off" : "this is no HDF5 file");
  }
  return file;
}

std::vector<std::string> links_of(const Handle& group) {
  const Handle properties(H5Gget_create_plist(group.id()), H5Pclose);
  unsigned kept = 0;
  H5Pget_link_creation_order(properties.id(), &kept);
  const H5_index_t order = (kept & H5P_CRT_ORDER_INDEXED) != 0 ? H5_INDEX_CRT_ORDER : H5_INDEX_NAME;
  std::vector<std::string> names;
  const auto take = [](hid_t, const char* name, const H5L_info_t* link, void* to) -> herr_t {
    auto& all = *static_cast<std::vector<std::string>*>(to);
    if (link->type == H5L_TYPE_HARD) all.emplace_back(name);
    return all.size() > max_columns ? 1 : 0;
  };
  if (H5Literate(group.id(), order, H5_ITER_INC, nullptr, take, &names) < 0)
    Session::refuse("the file is damaged");
  return names;
}

std::uint64_t place_of(const Handle& object) {
  H5O_info_t info{};
  if (H5Oget_info2(object.id(), &info, H5O_INFO_BASIC) < 0) Session::refuse("the file is damaged");
  return info.addr;
}

std::string text_attribute(std::int64_t object, const char* name) {
  if (H5Aexists(object, name) <= 0) return "";
  const Handle attribute(H5Aopen(object, name, H5P_DEFAULT), H5Aclose);
  const Handle type(H5Aget_type(attribute.id()), H5Tclose), space(H5Aget_space(attribute.id()), H5Sclose);
  if (!attribute || H5Tget_class(type.id()) != H5T_STRING || H5Sget_simple_extent_npoints(space.id()) != 1)
    return "";
  if (H5Tis_variable_str(type.id()) <= 0) {
    std::string text(H5Tget_size(type.id()), '\0');
    if (H5Aread(attribute.id(), type.id(), text.data()) < 0) return "";
    return text.substr(0, text.find('\0'));
  }
  char* text = nullptr;
  if (H5Aread(attribute.id(), type.id(), &text) < 0 || !text) return "";
  const std::string result = text;
  H5free_memory(text);
  return result;
}

}  // namespace stepwire::hdf5
