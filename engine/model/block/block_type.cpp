#include "engine/model/block/block_type.hpp"

#include <algorithm>
#include <filesystem>
#include <new>
#include <system_error>
#include <utility>

#include "engine/model/block/declare.hpp"

namespace stepwire {

namespace {

namespace fs = std::filesystem;

/// True for a path that can be quoted in an #include.
bool can_be_included(const std::string& path) {
  return path.find_first_of("\"\\\n\r") == path.npos;
}

bool has_name_outside(std::string_view struct_name) {
  return struct_name.find(")::") == struct_name.npos && struct_name.find("}::") == struct_name.npos;
}

bool is_header(const fs::path& file) {
  const std::string ending = file.extension().string();
  return ending == ".hpp" || ending == ".h" || ending == ".hh" || ending == ".hxx";
}

/// Returns the header of a source: the named one, the source itself if it is a header, or one of its name
/// beside it. Returns an empty path if there is none.
fs::path header_file(const fs::path& source, const std::string& named) {
  if (!named.empty()) return source.parent_path() / named;
  if (is_header(source)) return source;
  for (const char* ending : {".hpp", ".h", ".hh", ".hxx"})
    if (fs::path header = fs::path(source).replace_extension(ending); fs::exists(header)) return header;
  return {};
}

template <class Spec>
int index_of(const std::vector<Spec>& specs, std::string_view key) {
  auto found = std::find_if(specs.begin(), specs.end(), [&](const Spec& spec) { return spec.name == key; });
  return found == specs.end() ? -1 : static_cast<int>(found - specs.begin());
}

void* allocate(const BlockType& type) {
  return ::operator new(type.bytes, std::align_val_t(type.alignment));
}

}  // namespace

// Returns "blocks/math/gain.hpp" for blocks that the library declares in "blocks/math/gain.cpp". For other
// sources, given by their full path, it returns the full path of the header found by header_file(). Returns
// an empty text without such a header, and for a struct in a function or in an unnamed namespace.
std::string detail::header_of(std::string_view source, const std::string& named,
                              std::string_view struct_name) {
  if (!has_name_outside(struct_name)) return "";
  if (source.starts_with("blocks/"))  // the library is compiled with paths relative to its root
    return fs::path(source).replace_extension(".hpp").string();
  if (!source.starts_with('/')) return "";
  std::error_code none;
  const std::string header = fs::canonical(header_file(source, named), none).string();
  return none || !can_be_included(header) ? "" : header;
}

const ParameterSpec* BlockType::parameter(std::string_view key) const {
  const int index = index_of(parameters, key);
  return index < 0 ? nullptr : &parameters[static_cast<std::size_t>(index)];
}

int BlockType::input(std::string_view key) const {
  return index_of(inputs, key);
}
int BlockType::output(std::string_view key) const {
  return index_of(outputs, key);
}
int BlockType::state(std::string_view key) const {
  return index_of(states, key);
}

bool BlockType::has_continuous_state() const {
  return std::any_of(states.begin(), states.end(), [](const StateSpec& state) { return state.continuous; });
}

AnyBlock::AnyBlock(const BlockType& type) : type_(&type), memory_(allocate(type)) {
  type.construct(memory_);
}

AnyBlock::AnyBlock(const AnyBlock& other) : type_(other.type_), memory_(allocate(*other.type_)) {
  type_->copy(memory_, other.memory_);
}

AnyBlock::AnyBlock(AnyBlock&& other) noexcept
    : type_(other.type_), memory_(std::exchange(other.memory_, nullptr)) {}

AnyBlock& AnyBlock::operator=(AnyBlock other) noexcept {
  std::swap(type_, other.type_);
  std::swap(memory_, other.memory_);
  return *this;
}

AnyBlock::~AnyBlock() {
  if (!memory_) return;
  type_->destroy(memory_);
  ::operator delete(memory_, std::align_val_t(type_->alignment));
}

}  // namespace stepwire
