#include "engine/app/session/shared_points.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstring>
#include <fstream>

#include "engine/simulate/journal/point_bytes.hpp"

namespace stepwire::session {

namespace {

// What a message is by its first byte. From a process to process 0: who it is, that it asks for points and
// what it has done, that it is alive, why it gives up. From process 0: points, of which none means the end.
constexpr char hello = 'h', asks = 'a', alive = 'l', fails = 'f', points = 'p', results = 'r';

constexpr std::size_t most_given = 1000, most_sent = std::size_t{1} << 20;
constexpr std::chrono::milliseconds look{200};
constexpr std::chrono::seconds between_signs{1}, longest_silence{60};

std::string host_name() {
  std::array<char, 256> name{};
  return ::gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "";
}

/// Is a process of this machine there, and not only its entry? A number that is used again is taken for it.
bool is_alive(std::int64_t process) {
  std::ifstream file(fmt::format("/proc/{}/stat", process));
  std::string line;
  if (!std::getline(file, line)) return false;
  const std::size_t behind = line.rfind(") ");
  return behind != line.npos && line[behind + 2] != 'Z' && line[behind + 2] != 'X';
}

void put(std::string& bytes, std::uint64_t number) {
  bytes.append(reinterpret_cast<const char*>(&number), sizeof(number));
}

std::uint64_t take_number(std::string_view& bytes) {
  std::uint64_t number = 0;
  if (bytes.size() < sizeof(number)) return bytes = {}, 0;
  std::memcpy(&number, bytes.data(), sizeof(number));
  bytes.remove_prefix(sizeof(number));
  return number;
}

}  // namespace

void PointServer::serve(const Monitor& monitor) {
  while (!monitor.interrupted()) {
    if (const auto message = messages_.receive(look))
      take(*message);
    else
      look_for_deaths();
    monitor.show(kept_.done());
    if (all_ended()) break;
  }
  kept_.journal().flush();
}

void PointServer::take(const messages::Message& message) {
  const auto of = static_cast<std::size_t>(message.from);
  if (of >= workers_.size() || message.bytes.empty()) return;
  Worker& worker = workers_[of];
  worker.heard = Clock::now();
  std::string_view rest(message.bytes);
  const char kind = rest.front();
  rest.remove_prefix(1);
  if (kind == hello) {
    worker.process = static_cast<std::int64_t>(take_number(rest));
    worker.host = rest;
  } else if (kind == results) {
    take_results(worker, rest);
  } else if (kind == fails) {
    worker.ended = true;
    deaths_.push_back(fmt::format("process {} gave up: {}", of, rest));
  } else if (kind == asks) {
    give(of);
  }
}

void PointServer::take_results(Worker& worker, std::string_view rest) {
  while (!rest.empty()) {
    const std::uint64_t size = take_number(rest);
    std::string_view bytes = rest.substr(0, size);
    rest.remove_prefix(bytes.size());
    std::string_view start = bytes;
    const std::uint64_t point = take_number(start);
    if (bytes.size() < size || std::ranges::find(worker.has, point) == worker.has.end()) return;
    kept_.journal().add_bytes(point, bytes);
    std::erase(worker.has, point);
  }
}

/// Few enough that all processes end at about the same time.
void PointServer::give(std::size_t worker) {
  const std::size_t many = std::clamp<std::size_t>(kept_.left() / (4 * workers_.size()), 1, most_given);
  std::string bytes(1, points);
  std::vector<std::size_t>& has = workers_[worker].has;
  has.clear();
  while (has.size() < many) {
    const auto point = kept_.next();
    if (!point) break;
    has.push_back(*point);
    put(bytes, *point);
  }
  workers_[worker].ended = has.empty();
  messages_.send(static_cast<int>(worker), bytes);
}

/// A process of this machine is looked for; one of another is taken for dead once it has not said for a
/// minute that it is alive.
void PointServer::look_for_deaths() {
  static const std::string here = host_name();
  for (std::size_t of = 1; of < workers_.size(); ++of) {
    Worker& worker = workers_[of];
    if (worker.ended) continue;
    const bool is_here = worker.process != 0 && worker.host == here;
    if (is_here ? is_alive(worker.process) : Clock::now() - worker.heard < longest_silence) continue;
    worker.ended = true;
    deaths_.push_back(fmt::format("process {} on {} has died, and with it {} points that it had not sent", of,
                                  worker.host, worker.has.size()));
  }
}

bool PointServer::all_ended() const {
  return std::all_of(workers_.begin() + 1, workers_.end(), [](const Worker& worker) { return worker.ended; });
}

ServedPoints::ServedPoints(messages::Messages& messages, const std::atomic<bool>* interrupt)
    : messages_(messages), interrupt_(interrupt) {
  std::string bytes(1, hello);
  put(bytes, static_cast<std::uint64_t>(::getpid()));
  messages_.send(0, bytes + host_name());
}

std::optional<std::size_t> ServedPoints::next() {
  if (given_.empty()) {
    send_results();
    messages_.send(0, std::string(1, asks));
    std::optional<messages::Message> answer;
    while (!(answer = messages_.receive(look)))
      if (interrupt_ && *interrupt_) return std::nullopt;
    std::string_view rest(answer->bytes);
    rest.remove_prefix(1);
    while (!rest.empty()) given_.push_back(take_number(rest));
    std::ranges::reverse(given_);
  }
  if (given_.empty()) return std::nullopt;
  const std::size_t point = given_.back();
  given_.pop_back();
  return point;
}

void ServedPoints::take(run::PointResult result) {
  if (result.end.interrupted) return;
  const std::string bytes = journal::bytes_of(result);
  if (results_.empty()) results_ = results;
  put(results_, bytes.size());
  results_ += bytes;
  if (results_.size() >= most_sent || std::chrono::steady_clock::now() - sent_ >= between_signs)
    send_results();
}

void ServedPoints::send_results() {
  if (!results_.empty()) messages_.send(0, results_);
  results_.clear();
  sent_ = std::chrono::steady_clock::now();
}

void ServedPoints::note_alive() {
  if (std::chrono::steady_clock::now() - sent_ < between_signs) return;
  sent_ = std::chrono::steady_clock::now();
  messages_.send(0, std::string(1, alive));
}

void ServedPoints::fail(const std::string& why) {
  messages_.send(0, fails + why);
}

}  // namespace stepwire::session
