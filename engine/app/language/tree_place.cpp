#include "engine/app/language/tree_place.hpp"

namespace stepwire::language {

namespace {

class Descent {
 public:
  Descent(const TextPlaces& places, Forms& forms, std::size_t offset, TreePlace& found)
      : places_(places), forms_(forms), offset_(offset), found_(found) {}

  bool find(const yaml::Node& node, const FormList& forms) {
    if (node.is_scalar() && places_.range(node).contains(offset_)) {
      found_.scalar = &node;
      found_.forms = forms_.scalars(forms);
      found_.range = places_.range(node);
      return true;
    }
    for (const yaml::Node& item : node.items)
      if (find(item, forms_.items(forms))) return true;
    for (const yaml::Entry& entry : node.entries)
      if (in_entry(node, entry, forms)) return true;
    return false;
  }

 private:
  bool in_entry(const yaml::Node& map, const yaml::Entry& entry, const FormList& forms) {
    found_.on_key = places_.key_range(entry).contains(offset_);
    if (found_.on_key) {
      found_.forms = forms_.under(forms, map, entry.key);
      found_.range = places_.key_range(entry);
    } else if (!find(entry.value, forms_.under(forms, map, entry.key))) {
      return false;
    }
    if (!found_.entry) found_.entry = &entry;
    return true;
  }

  const TextPlaces& places_;
  Forms& forms_;
  std::size_t offset_;
  TreePlace& found_;
};

}  // namespace

std::optional<TreePlace> tree_place(DiagramFiles& files, const std::string& file, std::size_t offset) {
  TreePlace found;
  try {
    found.document = files.texts().document(file);
  } catch (const yaml::Error&) {
    return std::nullopt;
  }
  const auto text = files.texts().text(file);
  const TextPlaces places(*text);
  Forms& forms = files.forms(file);
  if (!Descent(places, forms, offset, found).find(found.document->root, forms.root())) return std::nullopt;
  return found;
}

}  // namespace stepwire::language
