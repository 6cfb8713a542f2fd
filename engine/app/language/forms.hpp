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

/// What may stand at a place: one of these forms.
using FormList = std::vector<const yaml::Key*>;

/// The forms of the places of diagram files, by the tables of keys that their reader has and the declarations
/// of the blocks.
class Forms {
 public:
  explicit Forms(const Registry& registry) : registry_(registry) {}

  /// Of a file as a whole.
  FormList root() const;
  /// Of what stands under a key of a map that has one of these forms.
  FormList under(const FormList& map_forms, const yaml::Node& map, const std::string& key);
  /// Of the items of a list that has one of these forms.
  FormList items(const FormList& list_forms);
  /// The maps among these forms, for a certain map: the keys of a block follow from its type, those of a
  /// figure from its plot.
  FormList maps(const FormList& forms, const yaml::Node& map);
  /// The forms of a value that is no list and no map.
  FormList scalars(const FormList& forms);

  const yaml::Key& block_form(const BlockType& type);
  /// Gives the root of a part's file by the text behind `diagram:`, or null; used from now on.
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
  /// Of parts, for as long as their documents are the same.
  std::map<std::shared_ptr<const yaml::Document>, std::unique_ptr<const yaml::Key>> of_parts_;
};

/// The keys of a part: what a file that uses it as a block may give.
yaml::Key part_form(const yaml::Node& part);

/// Is this the place of a block, whose keys follow from its type?
bool is_block_form(const yaml::Key& form);

}  // namespace stepwire::language
