#include "engine/analyse/estimation/search_items.hpp"

#include "engine/base/io/environment_error.hpp"
#include "engine/base/messages/bytes.hpp"

namespace stepwire::estimation {

namespace {

using messages::ByteReader;
using messages::ByteWriter;

void put(ByteWriter& writer, const Eigen::VectorXd& x) {
  plain_list(writer, x);
}

Eigen::VectorXd vector_of(ByteReader& reader) {
  std::vector<double> numbers;
  plain_list(reader, numbers);
  return Eigen::Map<const Eigen::VectorXd>(numbers.data(), static_cast<Eigen::Index>(numbers.size()));
}

std::string bytes_of(const SearchStart& start) {
  ByteWriter writer;
  put(writer, start.from);
  all(writer, start.iterations);
  return writer.take();
}

std::string bytes_of(const Minimum& minimum) {
  ByteWriter writer;
  put(writer, minimum.x);
  all(writer, minimum.cost, minimum.converged, minimum.stalled, minimum.iterations, minimum.refusal);
  return writer.take();
}

Minimum minimum_of(std::string_view bytes) {
  ByteReader reader(bytes);
  Minimum minimum{.x = vector_of(reader)};
  all(reader, minimum.cost, minimum.converged, minimum.stalled, minimum.iterations, minimum.refusal);
  if (!reader.whole()) throw io::EnvironmentError("a search of another process is not as it was sent");
  return minimum;
}

}  // namespace

std::vector<Minimum> search_by(messages::ItemWorkers& workers, const std::vector<SearchStart>& starts) {
  std::vector<messages::Item> items;
  for (const SearchStart& start : starts) items.push_back({start.number, bytes_of(start)});
  std::vector<Minimum> minima;
  for (const std::string& bytes : workers.run(items)) minima.push_back(minimum_of(bytes));
  return minima;
}

SearchWork::SearchWork(const ModelSource& source, const run::Job& job, const FitRequest& request,
                       unsigned threads)
    : request_(request),
      interrupt_(source.interrupt),
      runs_(source, job, request),
      residuals_(runs_, request, threads) {}

std::string SearchWork::work(const messages::Item& item) const {
  ByteReader reader(item.bytes);
  const Eigen::VectorXd from = vector_of(reader);
  std::size_t iterations = 0;
  all(reader, iterations);
  return bytes_of(minimise(residuals_, request_, from, {iterations, interrupt_}));
}

}  // namespace stepwire::estimation
