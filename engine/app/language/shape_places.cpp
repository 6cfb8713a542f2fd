#include "engine/app/language/shape_places.hpp"

#include <algorithm>

namespace stepwire::language {

namespace {

constexpr int deepest_part = 32;
constexpr std::size_t most_shapes = 20'000;

class Shapes {
 public:
  explicit Shapes(DiagramFiles& files) : files_(files) {}

  void add_file(const std::string& file, const std::string& prefix, int depth) {
    const auto document = files_.tree(file);
    if (!document || depth > deepest_part) return;
    const auto text = files_.texts().text(file);
    const TextPlaces places(*text);
    for (const char* section : {"inputs", "outputs"})
      if (const yaml::Node* ports = document->root.find(section); ports && depth == 0)
        for (const yaml::Entry& port : ports->entries) add(port.key, file, range_of(places, port));
    const yaml::Node* blocks = document->root.find("blocks");
    for (std::size_t i = 0; blocks && i < blocks->entries.size() && found_.size() < most_shapes; ++i)
      add_block(file, places, blocks->entries[i], prefix, depth);
  }

  std::map<std::string, FilePlace> take() { return std::move(found_); }

 private:
  static TextRange range_of(const TextPlaces& places, const yaml::Entry& entry) {
    const TextRange key = places.key_range(entry);
    return {key.from, std::max(key.to, places.offset(entry.value.end))};
  }

  void add(const std::string& name, const std::string& file, const TextRange& range) {
    found_.try_emplace(name, FilePlace{file, range});
  }

  void add_block(const std::string& file, const TextPlaces& places, const yaml::Entry& block,
                 const std::string& prefix, int depth) {
    const std::string name = prefix + block.key;
    add(name, file, range_of(places, block));
    for (const std::string& output : files_.outputs(file, block))
      add(name + "." + output, file, places.key_range(block));
    for (const yaml::Entry& key : block.value.entries) {
      add(name + "." + key.key, file, range_of(places, key));
      for (std::size_t i = 0; i < key.value.items.size(); ++i)
        add(name + "." + key.key + "." + std::to_string(i + 1), file, places.range(key.value.items[i]));
    }
    if (const std::string part = DiagramFiles::part_file(file, block); !part.empty())
      add_file(part, name + ".", depth + 1);
  }

  DiagramFiles& files_;
  std::map<std::string, FilePlace> found_;
};

}  // namespace

std::map<std::string, FilePlace> shape_places(DiagramFiles& files, const std::string& file) {
  Shapes shapes(files);
  shapes.add_file(file, "", 0);
  return shapes.take();
}

}  // namespace stepwire::language
