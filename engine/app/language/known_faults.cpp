#include "engine/app/language/known_faults.hpp"

#include <algorithm>

#include "engine/app/language/analysis.hpp"

namespace stepwire::language {

namespace {

std::pair<std::string, std::string> name_of(const yaml::Fault& fault) {
  return {fault.subject, fault.message.text()};
}

}  // namespace

KnownFaults::KnownFaults(DiagramFiles& files, const std::string& file) : files_(files), file_(file) {
  for (const yaml::Fault& fault : analyse(files_, file_, Depth::sizes).faults)
    known_.push_back(name_of(fault));
}

std::vector<yaml::Fault> KnownFaults::added_by(const FileSplices& changes) const {
  DiagramFiles after(files_.registry());
  after.texts() = files_.texts();
  for (const auto& [path, splices] : changes)
    after.texts().open(path, spliced(*files_.texts().text(path), splices));
  return added_in(after);
}

std::vector<yaml::Fault> KnownFaults::added_by(yaml::Document tree) const {
  DiagramFiles after(files_.registry());
  after.texts() = files_.texts();
  after.texts().open_tree(file_, std::make_shared<const yaml::Document>(std::move(tree)));
  return added_in(after);
}

std::vector<yaml::Fault> KnownFaults::added_in(DiagramFiles& after) const {
  std::vector<yaml::Fault> now = analyse(after, file_, Depth::sizes).faults;
  auto before = known_;
  std::erase_if(now, [&](const yaml::Fault& fault) {
    const auto known = std::ranges::find(before, name_of(fault));
    if (known == before.end()) return false;
    before.erase(known);
    return true;
  });
  return now;
}

}  // namespace stepwire::language
