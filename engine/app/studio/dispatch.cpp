#include "engine/app/studio/dispatch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <optional>
#include <utility>

#include "engine/base/text/characters.hpp"

namespace stepwire::studio {

using Clock = std::chrono::steady_clock;

using json::Json;

namespace {

const CallRow& row_of(const Calls& calls, const Json& request) {
  const std::string name = Arguments(request).text("call");
  const auto row = calls.find(name);
  if (row == calls.end()) throw Fault(fmt::format("there is no call '{}'", text::visible(name)));
  return row->second;
}

/// Runs a call and returns the answer, with the `id` of the request. Without an `id` only faults are
/// answered; success returns std::nullopt.
std::optional<std::string> answer_to(const Json& request, const std::function<Json()>& call) {
  Json answer = Json::object();
  const Json* id = request.find("id");
  if (id && id->as_number()) answer.set("id", *id);
  try {
    answer.set("result", call());
    if (!id) return std::nullopt;
  } catch (...) {
    answer.set("fault", fault_in_flight());
  }
  return answer.text(-1);
}

}  // namespace

Lane::Lane(Work tick, std::chrono::milliseconds period)
    : tick_(std::move(tick)), period_(period), thread_([this] { run(); }) {}

void Lane::post(Work work, int sender) {
  const std::lock_guard lock(mutex_);
  if (ends_) return;
  auto found = std::ranges::find(waiting_, sender, &Sender::number);
  if (found == waiting_.end()) found = waiting_.insert(found, {sender, {}});
  found->works.push_back(std::move(work));
  changed_.notify_one();
}

void Lane::stop() {
  {
    const std::lock_guard lock(mutex_);
    ends_ = true;
    waiting_.clear();
    changed_.notify_one();
  }
  if (thread_.joinable()) thread_.join();
}

/// Waits for the next work; returns an empty function at the end of the period or of the lane.
Lane::Work Lane::next() {
  std::unique_lock lock(mutex_);
  changed_.wait_for(lock, period_, [this] { return ends_ || !waiting_.empty(); });
  if (waiting_.empty()) return {};
  Sender sender = std::move(waiting_.front());
  waiting_.pop_front();
  Work work = std::move(sender.works.front());
  sender.works.pop_front();
  if (!sender.works.empty()) waiting_.push_back(std::move(sender));
  return work;
}

void Lane::run() {
  Clock::time_point ticked = Clock::now();
  for (bool ends = false; !ends;) {
    if (const Work work = next()) work();
    {
      const std::lock_guard lock(mutex_);
      ends = ends_;
    }
    if (!ends && Clock::now() - ticked < period_) continue;
    if (tick_) tick_();
    ticked = Clock::now();
  }
}

Dispatch::Dispatch(const Calls& calls, Send send, Acknowledge acknowledge)
    : calls_(calls), send_(std::move(send)), acknowledge_(std::move(acknowledge)) {
  for (const auto& [name, row] : calls) lanes_.try_emplace(row.where);
}

void Dispatch::take(int page, const std::string& message, const http::Ticket& ticket) {
  auto request = std::make_shared<Json>();
  try {
    *request = Json::parse(message);
    if (const Json* sequence = request->find("ack"); sequence && sequence->as_number())
      return acknowledge_(page, static_cast<std::uint32_t>(Arguments(*request).whole("ack")));
    const CallRow& row = row_of(calls_, *request);
    lanes_.at(row.where).post(
        [this, page, &row, request, ticket] { answer(page, row, Arguments(*request, ticket)); }, page);
  } catch (...) {
    refuse(page, *request);
  }
}

void Dispatch::answer(int page, const CallRow& row, const Arguments& arguments) const {
  if (auto text = answer_to(arguments.all(), [&] { return row.act(page, arguments); }))
    send_(page, *std::move(text));
}

void Dispatch::refuse(int page, const Json& request) const {
  const std::exception_ptr why = std::current_exception();
  if (auto text = answer_to(request, [&]() -> Json { std::rethrow_exception(why); }))
    send_(page, *std::move(text));
}

void Dispatch::stop() {
  for (auto& [where, lane] : lanes_) lane.stop();
}

}  // namespace stepwire::studio
