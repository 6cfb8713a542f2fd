#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "engine/base/yaml/document.hpp"
#include "engine/base/yaml/key.hpp"
#include "engine/model/block/registry.hpp"

namespace stepwire::language {

/// Alternative forms of a value.
using FormList = std::vector<const yaml::Key*>;

/// Forms of all places in diagram files, from the key tables of their reader and from the declarations of the
/// blocks.
class Forms {
 public:
  explicit Forms(const Registry& registry) : registry_(registry) {}

  /// Returns the form of a whole file.
  FormList root() const;
  /// Returns the forms of the value under a key, for a map with one of the given forms.
  FormList under(const FormList& map_forms, const yaml::Node& map, const std::string& key);
  /// Returns the forms of the items, for a list with one of the given forms.
  FormList items(const FormList& list_forms);
  /// Returns the map forms for a particular map. The keys of a block depend on its type, those of a figure on
  /// its plot.
  FormList maps(const FormList& forms, const yaml::Node& map);
  /// Returns the forms of a scalar.
  FormList scalars(const FormList& forms);

  const yaml::Key& block_form(const BlockType& type);
  /// Sets the lookup of part files by the text of the key `diagram`. It returns nullptr for an unreadable
  /// file.
  using Parts = std::function<std::shared_ptr<const yaml::Document>(const std::string& path)>;
  void look_for_parts(Parts parts) { parts_ = std::move(parts); }

 private:
  void expand(const yaml::Key& form, FormList& result, int depth = 0);
  FormList expanded(const FormList& forms);
  void add_block(const yaml::Node& map, FormList& result);
  void add_figure(const yaml::Node& map, bool panel, FormList& result);
  const yaml::Key& any_block();

  const Registry& registry_;
  Parts parts_;
  std::map<std::string, std::unique_ptr<const yaml::Key>> made_;
  /// forms of parts, by document
  std::map<std::shared_ptr<const yaml::Document>, std::unique_ptr<const yaml::Key>> of_parts_;
};

/// True for the form of a block, whose keys depend on its type.
bool is_block_form(const yaml::Key& form);

}  // namespace stepwire::language
