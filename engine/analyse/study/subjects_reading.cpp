#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "engine/analyse/study/study_keys.hpp"

namespace stepwire::study {

using yaml::form;

namespace {

constexpr std::size_t max_subjects = 1000;

yaml::Key subjects_form() {
  return form::either({yaml::key("", "how many people", form::whole(1, max_subjects)),
                       yaml::key("", "which people", form::list(form::whole(1, max_subjects), 1))});
}

void read_subjects(StudyRequest& request, const yaml::Node& node, const StudyReading& read) {
  const yaml::Key number = form::whole(1, max_subjects);
  if (!node.is_list()) {
    std::size_t count = 0;
    read.take(node, number, count);
    request.subjects = first_numbers(count);
    return;
  }
  if (node.items.empty()) read.fault(node.mark, "the list is empty");
  auto& all = request.subjects;
  for (const yaml::Node& item : node.items) {
    const auto subject = read.whole(item, number);
    if (!subject) continue;
    const auto one = static_cast<std::size_t>(*subject);
    if (std::ranges::find(all, one) != all.end())
      read.fault(item.mark,
                 fmt::format("'{}' stands here twice; subjects are how many, or a list of different "
                             "numbers",
                             item.text));
    all.push_back(one);
  }
}

}  // namespace

std::vector<std::size_t> first_numbers(std::size_t count) {
  std::vector<std::size_t> numbers(count);
  std::iota(numbers.begin(), numbers.end(), 1);
  return numbers;
}

StudyRow subjects_row() {
  return {"subjects", "how many people, or a list of which",
          yaml::like("10, or a list such as [3, 7]", subjects_form()), read_subjects};
}

}  // namespace stepwire::study
