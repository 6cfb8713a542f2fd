#include "engine/app/cluster/item_server.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <fstream>

#include "engine/app/cluster/item_messages.hpp"
#include "engine/base/messages/bytes.hpp"
#include "engine/simulate/journal/run_bytes.hpp"

namespace stepwire::cluster {

using messages::ByteReader;

using messages::ByteWriter;

namespace {

constexpr double share_of_answers = 0.25;  // Largest fraction of the server's time for answers.
constexpr double longest = 10.0;           // Longest duration of a group [s], which bounds lost work.
constexpr std::size_t first_group = 8;     // Group size before the first measurement: the lanes of a run.
constexpr std::size_t most = 100'000;      // Largest number of items whose numbers fit into a message.
constexpr std::size_t groups_left = 4;     // Groups per process that the remaining items make.
constexpr double forget_beyond = 1e4;      // Number of notes after which old ones lose weight.

std::size_t whole(double number) {
  return static_cast<std::size_t>(std::clamp(std::ceil(number), 1.0, 1e15));
}

constexpr std::chrono::milliseconds look{200};
constexpr std::chrono::seconds between_looks{1}, longest_silence{60};

/// True if the process runs on this machine and is no zombie. A reused process id counts as the same process.
bool is_alive(std::int64_t process) {
  std::ifstream file(fmt::format("/proc/{}/stat", process));
  std::string line;
  if (!std::getline(file, line)) return false;
  const std::size_t behind = line.rfind(") ");
  return behind != line.npos && line[behind + 2] != 'Z' && line[behind + 2] != 'X';
}

/// Returns the CPU time of this thread [s], which does not depend on the load of the machine.
double processor_time() {
  timespec time{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace

void GroupSize::Mean::add(double value, double weight) {
  sum += value;
  count += weight;
  if (count < forget_beyond * weight) return;
  sum *= 0.5;
  count *= 0.5;
}

void GroupSize::note_group(std::size_t items, double seconds) {
  if (items > 0) item_.add(std::max(seconds, 0.0), static_cast<double>(items));
}

void GroupSize::note_answer(double seconds) {
  answer_.add(std::max(seconds, 0.0), 1.0);
}

std::size_t GroupSize::next(std::size_t left, std::size_t processes) const {
  const std::size_t even = std::max<std::size_t>(1, left / (groups_left * processes));
  const double item = item_.value();
  if (item <= 0.0) return std::min(even, first_group);
  // Shortest duration of a group that leaves the server mostly idle [s].
  const double busy = answer_.value() * static_cast<double>(processes) / share_of_answers;
  const std::size_t share = left / processes + 1;
  const std::size_t fewest = std::min(whole(busy / item), share);
  return std::min({std::max(even, fewest), whole(longest / item), most});
}

void ItemServer::serve(ItemSource& source, const std::string& job, const session::Monitor& monitor) {
  source_ = &source;
  job_ = job;
  ++job_number_;
  for (std::size_t of = 1; of < workers_.size(); ++of)
    if (workers_[of].wants_job) give_job(of);
  while (!monitor.interrupted() && !is_done()) {
    step();
    monitor.show(source.done());
  }
  source_ = nullptr;
  if (!refused_.empty()) throw yaml::Error(std::move(refused_));
}

bool ItemServer::finish() {
  source_ = nullptr;
  for (std::size_t of = 1; of < workers_.size(); ++of)
    if (!workers_[of].gone) messages_.send(static_cast<int>(of), std::string(1, kind::end));
  const auto is_gone = [](const Worker& worker) { return worker.gone; };
  while (!std::all_of(workers_.begin() + 1, workers_.end(), is_gone)) step();
  return std::all_of(workers_.begin() + 1, workers_.end(), [](const Worker& worker) { return !worker.lost; });
}

/// Handles one message, or waits for one. The answer is timed only if the message had already arrived,
/// because the CPU time of a wait would distort it.
void ItemServer::step() {
  const auto begin = Clock::now();
  if (begin - looked_ > between_looks) look_for_deaths();
  const double start = processor_time();
  std::optional<messages::Message> message = messages_.receive({});
  const bool waited = !message;
  if (waited) message = messages_.receive(look);
  if (!message || message->bytes.empty()) return;
  const auto of = static_cast<std::size_t>(message->from);
  if (of == 0 || of >= workers_.size()) return;
  workers_[of].heard = begin;
  const char kind = message->bytes.front();
  taking_ = 0.0;
  taken_ = 0;
  take(of, kind, std::string_view(message->bytes).substr(1));
  if (!waited) measure(kind, processor_time() - start);
}

/// Excludes the per-item cost (`taking_`) from the cost of an answer.
void ItemServer::measure(char kind, double seconds) {
  if (kind == kind::wants_items) size_.note_answer(seconds - taking_);
  if (kind == kind::results) taking_ = seconds;
  costs_ += taking_;
  items_ += taken_;
}

void ItemServer::take(std::size_t of, char kind, std::string_view rest) {
  if (kind == kind::wants_items) return take_request(of, rest);
  if (kind == kind::results) return take_results(workers_[of], rest);
  if (kind == kind::wants_job) {
    workers_[of].wants_job = true;
    if (source_) give_job(of);
    return;
  }
  take_note(of, kind, rest);
}

/// Handles a message about the state of a process: its name, its end, its failure.
void ItemServer::take_note(std::size_t of, char kind, std::string_view rest) {
  Worker& worker = workers_[of];
  ByteReader reader(rest);
  if (kind == kind::hello) {
    all(reader, worker.process, worker.host);
  } else if (kind == kind::died) {
    note_death(of, fmt::format("on {} has died ({})", worker.host, rest));
  } else if (kind == kind::failed) {
    note_death(of, fmt::format("on {} gave up: {}", worker.host, rest));
  } else if (kind == kind::refused) {
    list(reader, refused_, [&](yaml::Fault& fault) { journal::fault(reader, fault); });
  } else if (kind == kind::bye) {
    end(worker);
    worker.gone = true;
  }
}

void ItemServer::take_request(std::size_t of, std::string_view rest) {
  ByteReader reader(rest);
  std::uint64_t job = 0, items = 0;
  double seconds = 0.0;
  std::string results;
  all(reader, job, items, seconds, results);
  take_results(workers_[of], results);
  size_.note_group(items, seconds);
  if (source_ && job == job_number_) return give(of);
  messages_.send(static_cast<int>(of), std::string(1, kind::items));  // The job of the request has ended.
}

void ItemServer::take_results(Worker& worker, std::string_view rest) {
  const double start = processor_time();
  while (!rest.empty() && source_) {
    std::uint64_t number = 0, size = 0;
    ByteReader reader(rest);
    all(reader, number, size);
    const std::string_view bytes = rest.substr(std::min<std::size_t>(2 * sizeof(size), rest.size()), size);
    const auto place = std::ranges::find(worker.has, number);
    if (!reader.whole() || bytes.size() < size || place == worker.has.end()) return;
    worker.has.erase(place);
    --given_;
    ++taken_;
    source_->take(number, bytes);
    rest.remove_prefix(2 * sizeof(size) + bytes.size());
  }
  taking_ += processor_time() - start;
}

void ItemServer::give(std::size_t of) {
  const double start = processor_time();
  Worker& worker = workers_[of];
  const std::size_t many = size_.next(source_->left(), std::max<std::size_t>(1, living_));
  std::vector<messages::Item> given;
  while (given.size() < many) {
    auto item = source_->next();
    if (!item) break;
    worker.has.push_back(item->number);
    given.push_back(std::move(*item));
  }
  given_ += given.size();
  ByteWriter writer;
  writer.put(kind::items);
  for (const messages::Item& item : given) all(writer, item.number, item.bytes);
  taking_ += processor_time() - start;
  messages_.send(static_cast<int>(of), writer.take());
}

void ItemServer::give_job(std::size_t of) {
  ByteWriter writer;
  all(writer, kind::job, job_number_, job_);
  messages_.send(static_cast<int>(of), writer.take());
  workers_[of].wants_job = false;
}

void ItemServer::note_death(std::size_t of, const std::string& what) {
  Worker& worker = workers_[of];
  if (worker.ended) return;
  deaths_.push_back(
      fmt::format("process {} {}, and with it {} of what it was given", of, what, worker.has.size()));
  end(worker);
}

void ItemServer::end(Worker& worker) {
  if (worker.ended) return;
  worker.ended = true;
  worker.wants_job = false;
  given_ -= worker.has.size();
  worker.has.clear();
  --living_;
}

/// Marks dead processes. A process of this machine is looked up in /proc; one of another machine is dead
/// after a minute without a message.
void ItemServer::look_for_deaths() {
  looked_ = Clock::now();
  for (std::size_t of = 1; of < workers_.size(); ++of) {
    Worker& worker = workers_[of];
    if (worker.gone) continue;
    const bool is_here = worker.process > 0 && worker.host == this_host();
    if (is_here ? is_alive(worker.process) : looked_ - worker.heard < longest_silence) continue;
    note_death(of, fmt::format("on {} has died", worker.host));
    worker.gone = true;
    worker.lost = true;
  }
}

double ItemServer::seconds_of_item() const {
  return items_ == 0 ? 0.0 : costs_ / static_cast<double>(items_);
}

bool ItemServer::is_done() const {
  return !refused_.empty() || living_ == 0 || (given_ == 0 && source_->left() == 0);
}

}  // namespace stepwire::cluster
