#include "engine/analyse/tuning/search_items.hpp"

#include "engine/base/io/environment_error.hpp"
#include "engine/base/messages/bytes.hpp"

namespace stepwire::tuning {

namespace {

using messages::ByteReader;
using messages::ByteWriter;

template <class Stream, class One>
void evaluation(Stream& stream, One& of) {
  plain_list(stream, of.values);
  all(stream, of.objective);
  plain_list(stream, of.offs);
  plain_list(stream, of.claims);
  plain_list(stream, of.margins);
  all(stream, of.fault, of.worst, of.start);
}

/// Serialises the input of a search: the scales, and the evaluation of its start if there is one.
template <class Stream, class Scale, class Scales, class Known>
void beginning(Stream& stream, Scale& objective, Scales& claims, Known& known) {
  all(stream, objective);
  plain_list(stream, claims);
  list(stream, known, [&](auto& one) { evaluation(stream, one); });
}

std::string beginning_of(const SearchProblem& problem, const std::vector<Evaluation>& known) {
  ByteWriter writer;
  beginning(writer, problem.objective_scale, problem.claim_scales, known);
  return writer.take();
}

std::string bytes_of(const SearchResult& result) {
  ByteWriter writer;
  list(writer, result.evaluations, [&](const Evaluation& one) { evaluation(writer, one); });
  const std::size_t best = result.best.value_or(result.evaluations.size());
  all(writer, best, result.converged);
  return writer.take();
}

SearchResult result_of(std::string_view bytes) {
  ByteReader reader(bytes);
  SearchResult result;
  std::size_t best = 0;
  list(reader, result.evaluations, [&](Evaluation& one) { evaluation(reader, one); });
  all(reader, best, result.converged);
  if (!reader.whole()) throw io::EnvironmentError("a search of another process is not as it was sent");
  if (best < result.evaluations.size()) result.best = best;
  return result;
}

}  // namespace

std::vector<SearchResult> search_by(messages::ItemWorkers& workers, const SearchProblem& problem,
                                    const std::optional<Evaluation>& start) {
  std::vector<messages::Item> items;
  for (std::size_t i = 0; i < problem.request.starts; ++i) {
    std::vector<Evaluation> known;
    if (i == 0 && start) known.push_back(*start);
    items.push_back({i, beginning_of(problem, known)});
  }
  std::vector<SearchResult> results;
  for (const std::string& bytes : workers.run(items)) results.push_back(result_of(bytes));
  return results;
}

std::string SearchWork::work(const messages::Item& item) const {
  SearchProblem problem{.runs = runs_, .request = request_, .threads = threads_};
  std::vector<Evaluation> known;
  ByteReader reader(item.bytes);
  beginning(reader, problem.objective_scale, problem.claim_scales, known);
  return bytes_of(search(problem, item.number, known.empty() ? std::nullopt : std::optional(known.front())));
}

}  // namespace stepwire::tuning
