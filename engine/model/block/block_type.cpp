#include "engine/model/block/block_type.hpp"
#include "engine/model/block/declare.hpp"

#include <algorithm>
#include <new>
#include <utility>

namespace stepwire {

std::string detail::header_beside(std::string_view source) {
  const std::size_t folder = source.rfind("blocks/"), ending = source.rfind(".cpp");
  const bool of_library =
      folder != source.npos && ending != source.npos && source.find("tests/") == source.npos;
  if (!of_library) return "";
  return std::string(source.substr(folder, ending - folder)) + ".hpp";
}

namespace {

template <class Spec>
int index_of(const std::vector<Spec>& specs, std::string_view key) {
  auto found = std::find_if(specs.begin(), specs.end(), [&](const Spec& spec) { return spec.name == key; });
  return found == specs.end() ? -1 : static_cast<int>(found - specs.begin());
}

void* allocate(const BlockType& type) {
  return ::operator new(type.bytes, std::align_val_t(type.alignment));
}

}  // namespace

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
