#include "engine/app/studio/http/http_server.hpp"

#include <fmt/format.h>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <deque>
#include <list>
#include <map>
#include <string_view>
#include <thread>
#include <utility>

#include "engine/app/studio/http/loopback.hpp"
#include "engine/app/studio/http/message.hpp"

namespace stepwire::http {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace ws = boost::beast::websocket;
using asio::ip::tcp;
using boost::system::error_code;
using Parser = beast::http::request_parser<beast::http::empty_body>;
using Response = beast::http::response<beast::http::span_body<const char>>;

/// Slot of a limited number; the destructor frees it.
class Place {
 public:
  explicit Place(std::size_t& taken) : taken_(taken) { ++taken_; }
  ~Place() { --taken_; }
  Place(const Place&) = delete;
  Place& operator=(const Place&) = delete;

 private:
  std::size_t& taken_;
};

Request request_of(const Parser::value_type& from) {
  const auto text = [](const auto& part) { return std::string(part.data(), part.size()); };
  Request request{text(from.method_string()), text(from.target()), {}};
  for (const auto& field : from) request.headers.push_back({text(field.name_string()), text(field.value())});
  return request;
}

/// Returns a response that refers to the body of the answer, which must outlive it. A response to HEAD has no
/// body.
Response response_of(const Answer& answer, bool head, bool keep) {
  const std::string_view body = answer.body.empty() ? answer.fixed : std::string_view(answer.body);
  Response response;
  response.result(static_cast<unsigned>(answer.status));
  for (const Header& one : answer.headers) response.set(one.name, one.value);
  response.keep_alive(keep);
  response.content_length(body.size());
  if (!head) response.body() = {body.data(), body.size()};
  return response;
}

/// Returns an answer with this status and no body.
Answer empty_answer(int status) {
  return {status, security_headers(random_token())};
}

/// Sets the cookie and redirects to the page. The token must not stay in the URL, as the browser's history
/// keeps it.
Answer entrance(const Key& key) {
  Answer answer = empty_answer(303);
  answer.headers.push_back({"Location", "/"});
  answer.headers.push_back(
      {"Set-Cookie", fmt::format("{}={}; HttpOnly; SameSite=Strict; Path=/", cookie_name(key), key.token)});
  return answer;
}

/// Answers a request according to the gate's decision; sockets are handled elsewhere.
Answer reply(const Request& request, const Decision& decision, const Key& key, Site& site) {
  if (decision.kind == Decision::Kind::enter) return entrance(key);
  if (decision.kind != Decision::Kind::pass) return empty_answer(403);
  const bool reads = request.method == "GET" || request.method == "HEAD";
  return reads ? site.answer(request, decision.path) : empty_answer(405);
}

/// Server with everything that runs in its thread.
class Server : public HttpServer {
 public:
  Server(Site& site, std::uint16_t port, const Limits& limits);
  ~Server() override { stop(); }

  const Key& key() const override { return key_; }
  void start() override;
  void stop() override;
  void send_text(int page, std::string text) override { send(page, true, std::move(text)); }
  void send_bytes(int page, std::string bytes) override { send(page, false, std::move(bytes)); }

 private:
  class Connection;
  class Page;

  void accept(tcp::acceptor& acceptor);
  void accept_later(tcp::acceptor& acceptor);
  void take(tcp::socket socket);
  void send(int page, bool text, std::string message);

  Site& site_;
  Limits limits_;
  Key key_;
  std::size_t connections_ = 0, sockets_ = 0;
  int last_page_ = 0;
  std::list<Connection*> unheard_;  ///< connections without a complete request, oldest first
  std::map<int, std::weak_ptr<Page>> pages_;
  asio::io_context context_{1};  // declared after the members that its pending handlers use
  std::deque<tcp::acceptor> acceptors_;
  std::thread thread_;
};

/// WebSocket of a page.
class Server::Page : public std::enable_shared_from_this<Page> {
 public:
  Page(Server& server, beast::tcp_stream stream, std::shared_ptr<Place> connection)
      : server_(server),
        stream_(std::move(stream)),
        connection_(std::move(connection)),
        place_(server.sockets_) {
    const Limits& limits = server_.limits_;
    stream_.set_option(ws::stream_base::timeout{limits.handshake, 2 * limits.ping, true});
    stream_.read_message_max(limits.message);
    stream_.auto_fragment(false);
    stream_.set_option(ws::stream_base::decorator(
        [](ws::response_type& response) { response.erase(beast::http::field::server); }));
  }
  ~Page() { leave(); }

  void accept(std::shared_ptr<Parser> parser) {
    beast::get_lowest_layer(stream_).expires_never();  // the WebSocket has its own timer
    const auto accepted = [self = shared_from_this(), parser](error_code error) {
      if (!error) self->join();
    };
    stream_.async_accept(parser->get(), accepted);
  }

  void send(bool text, std::string message) {
    unsent_ += message.size();
    if (unsent_ > server_.limits_.unsent) return close();
    queue_.push_back({text, std::move(message)});
    if (queue_.size() == 1) write();
  }

  void close() {
    beast::get_lowest_layer(stream_).close();
    leave();
  }

 private:
  struct Outgoing {
    bool text;
    std::string message;
  };

  void join() {
    number_ = ++server_.last_page_;
    server_.pages_[number_] = weak_from_this();
    server_.site_.joined(number_);
    read();
  }

  /// Reads the next message, unless too many messages are unhandled or the page does not read its answers.
  void read() {
    if (reads_ || waiting_ > server_.limits_.waiting || unsent_ > server_.limits_.unread) return;
    reads_ = true;
    stream_.async_read(buffer_, [self = shared_from_this()](error_code error, std::size_t) {
      self->reads_ = false;
      if (error) return self->leave();
      self->stream_.got_text() ? self->take() : self->close();
    });
  }

  /// Reports that the page has left; its messages may still be in work.
  void leave() {
    if (server_.pages_.erase(number_) > 0) server_.site_.left(number_);
  }

  void take() {
    std::string message = beast::buffers_to_string(buffer_.data());
    buffer_.consume(buffer_.size());
    const std::size_t size = message.size() + 1024;  // overhead: small messages cost work, too
    waiting_ += size;
    server_.site_.said(number_, std::move(message), ticket(size));
    read();
  }

  /// Returns a ticket for a message of `size` bytes. It may be released in any thread; the page is always
  /// destroyed in the thread of the server.
  Ticket ticket(std::size_t size) {
    return {nullptr, [self = shared_from_this(), size](void*) mutable {
              asio::io_context& context = self->server_.context_;
              asio::post(context, [self = std::move(self), size] { self->done(size); });
            }};
  }

  void done(std::size_t size) {
    waiting_ -= size;
    read();
  }

  void write() {
    stream_.text(queue_.front().text);
    stream_.async_write(asio::buffer(queue_.front().message),
                        [self = shared_from_this()](error_code error, std::size_t) {
                          if (error) return self->close();
                          self->unsent_ -= self->queue_.front().message.size();
                          self->queue_.pop_front();
                          if (!self->queue_.empty()) self->write();
                          self->read();
                        });
  }

  Server& server_;
  ws::stream<beast::tcp_stream> stream_;
  std::shared_ptr<Place> connection_;
  Place place_;
  int number_ = 0;
  beast::flat_buffer buffer_;
  std::size_t waiting_ = 0;  ///< bytes of messages whose tickets exist
  bool reads_ = false;       ///< a read is pending
  std::deque<Outgoing> queue_;
  std::size_t unsent_ = 0;  ///< bytes in `queue_`
};

/// Connection that is not a WebSocket yet.
class Server::Connection : public std::enable_shared_from_this<Connection> {
 public:
  Connection(Server& server, tcp::socket socket)
      : server_(server), stream_(std::move(socket)), place_(std::make_shared<Place>(server.connections_)) {}

  /// Closes the oldest connection without a complete request to make room; false if there is none.
  static bool give_way(Server& server) {
    if (server.unheard_.empty()) return false;
    server.unheard_.front()->stream_.close();
    server.unheard_.pop_front();
    return true;
  }

  void read() {
    parser_ = std::make_shared<Parser>();
    parser_->header_limit(server_.limits_.header);
    parser_->body_limit(0);
    stream_.expires_after(server_.limits_.handshake);
    server_.unheard_.push_back(this);
    beast::http::async_read(stream_, buffer_, *parser_,
                            [self = shared_from_this()](error_code error, std::size_t) {
                              self->server_.unheard_.remove(self.get());
                              if (!error) self->decide();
                            });
  }

 private:
  void decide() {
    const Request request = request_of(parser_->get());
    const Decision decision = http::decide(request, server_.key_);
    if (decision.kind == Decision::Kind::upgrade) return upgrade(decision.path);
    const bool keeps = decision.kind != Decision::Kind::refuse && parser_->keep_alive();
    send(reply(request, decision, server_.key_, server_.site_), keeps);
  }

  void upgrade(const std::string& path) {
    if (!server_.site_.has_socket(path)) return send(empty_answer(404), false);
    if (server_.sockets_ >= server_.limits_.pages) return send(empty_answer(503), false);
    std::make_shared<Page>(server_, std::move(stream_), std::move(place_))->accept(std::move(parser_));
  }

  void send(Answer answer, bool keep) {
    answer_ = std::move(answer);
    response_ = response_of(answer_, parser_->get().method() == beast::http::verb::head, keep);
    stream_.expires_after(server_.limits_.handshake);
    beast::http::async_write(stream_, response_,
                             [self = shared_from_this(), keep](error_code error, std::size_t) {
                               if (!error && keep) self->read();
                             });
  }

  Server& server_;
  beast::tcp_stream stream_;
  std::shared_ptr<Place> place_;
  beast::flat_buffer buffer_;
  std::shared_ptr<Parser> parser_;
  Answer answer_;
  Response response_;
};

Server::Server(Site& site, std::uint16_t port, const Limits& limits) : site_(site), limits_(limits) {
  Loopback both = listen_on_loopback(port);
  key_ = {both.port, random_token()};
  acceptors_.emplace_back(context_, tcp::v4(), both.v4.release());
  if (both.v6.open()) acceptors_.emplace_back(context_, tcp::v6(), both.v6.release());
}

void Server::accept(tcp::acceptor& acceptor) {
  acceptor.async_accept([this, &acceptor](error_code error, tcp::socket socket) {
    if (error == asio::error::operation_aborted) return;
    if (error) return accept_later(acceptor);
    take(std::move(socket));
    accept(acceptor);
  });
}

/// Accepts again after a pause. Without a free descriptor the connection stays in the queue, and accepting at
/// once would fail again.
void Server::accept_later(tcp::acceptor& acceptor) {
  const auto pause = std::make_shared<asio::steady_timer>(context_, std::chrono::milliseconds(100));
  pause->async_wait([this, &acceptor, pause](error_code error) {
    if (!error) accept(acceptor);
  });
}

void Server::take(tcp::socket socket) {
  if (connections_ >= limits_.connections && !Connection::give_way(*this)) return;
  error_code ignored;
  socket.set_option(tcp::no_delay(true), ignored);
  std::make_shared<Connection>(*this, std::move(socket))->read();
}

void Server::start() {
  for (tcp::acceptor& acceptor : acceptors_) accept(acceptor);
  thread_ = std::thread([this] { context_.run(); });
}

void Server::stop() {
  context_.stop();
  if (thread_.joinable()) thread_.join();
  // The sockets close later, when the site may be destroyed.
  for (const auto& [page, socket] : std::exchange(pages_, {})) site_.left(page);
}

void Server::send(int page, bool text, std::string message) {
  asio::post(context_, [this, page, text, message = std::move(message)]() mutable {
    const auto found = pages_.find(page);
    if (found == pages_.end()) return;
    if (const auto open = found->second.lock()) open->send(text, std::move(message));
  });
}

}  // namespace

std::unique_ptr<HttpServer> listen(Site& site, std::uint16_t port, const Limits& limits) {
  return std::make_unique<Server>(site, port, limits);
}

}  // namespace stepwire::http
