// The only source that includes Beast and Asio: they take long to compile.
#include "engine/app/studio/http/http_server.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/ip/v6_only.hpp>
#include <boost/asio/post.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <deque>
#include <map>
#include <thread>
#include <utility>

#include "engine/app/studio/http/security_headers.hpp"
#include "engine/base/io/environment_error.hpp"

namespace stepwire::http {

namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace ws = boost::beast::websocket;
using asio::ip::tcp;
using boost::system::error_code;
using Parser = beast::http::request_parser<beast::http::empty_body>;
using Response = beast::http::response<beast::http::span_body<const char>>;

std::string_view view(beast::string_view text) {
  return {text.data(), text.size()};
}

Request request_of(const Parser& parser) {
  const auto& from = parser.get();
  Request request{std::string(view(from.method_string())), std::string(view(from.target())), {}};
  for (const auto& field : from)
    request.headers.push_back({std::string(view(field.name_string())), std::string(view(field.value()))});
  return request;
}

/// Gives a place back where it is taken by one who goes.
class Place {
 public:
  explicit Place(std::size_t& taken) : taken_(taken) { ++taken_; }
  ~Place() { --taken_; }
  Place(const Place&) = delete;
  Place& operator=(const Place&) = delete;

 private:
  std::size_t& taken_;
};

}  // namespace

/// All that lives in the server's thread.
class HttpServer::Service {
 public:
  Service(Site& site, std::uint16_t port, Limits limits);
  void start();
  void stop();
  void send(int page, bool text, std::string message);

  Key key;

 private:
  class Connection;
  class Page;

  bool listen(std::uint16_t port);
  tcp::acceptor& add_acceptor(const tcp::endpoint& endpoint);
  void accept(tcp::acceptor& acceptor);
  void take(tcp::socket socket);

  Site& site_;
  Limits limits_;
  std::size_t connections_ = 0, sockets_ = 0;
  int last_page_ = 0;
  std::map<int, std::weak_ptr<Page>> pages_;
  asio::io_context context_{1};  // when it goes, what waits in it goes, and uses what stands above
  std::deque<tcp::acceptor> acceptors_;
  std::thread thread_;
};

/// A page's socket.
class HttpServer::Service::Page : public std::enable_shared_from_this<Page> {
 public:
  Page(Service& service, beast::tcp_stream stream, std::shared_ptr<Place> connection)
      : service_(service),
        stream_(std::move(stream)),
        connection_(std::move(connection)),
        place_(service.sockets_) {
    const Limits& limits = service_.limits_;
    stream_.set_option(ws::stream_base::timeout{limits.handshake, 2 * limits.ping, true});
    stream_.read_message_max(limits.message);
    stream_.auto_fragment(false);
  }
  ~Page() {
    if (number_ == 0) return;
    service_.pages_.erase(number_);
    service_.site_.left(number_);
  }

  void accept(std::shared_ptr<Parser> parser) {
    beast::get_lowest_layer(stream_).expires_never();  // the socket has its own timer
    const auto accepted = [self = shared_from_this(), parser](error_code error) {
      if (!error) self->join();
    };
    stream_.async_accept(parser->get(), accepted);
  }

  void send(bool text, std::string message) {
    unsent_ += message.size();
    if (unsent_ > service_.limits_.unsent) return close();
    queue_.push_back({text, std::move(message)});
    if (queue_.size() == 1) write();
  }

  void close() { beast::get_lowest_layer(stream_).close(); }

 private:
  struct Outgoing {
    bool text;
    std::string message;
  };

  void join() {
    number_ = ++service_.last_page_;
    service_.pages_[number_] = weak_from_this();
    service_.site_.joined(number_);
    read();
  }

  void read() {
    stream_.async_read(buffer_, [self = shared_from_this()](error_code error, std::size_t) {
      if (!error && self->stream_.got_text()) self->take();
    });
  }

  void take() {
    std::string message = beast::buffers_to_string(buffer_.data());
    buffer_.consume(buffer_.size());
    const std::size_t size = message.size() + 1024;  // a small one is work, too
    waiting_ += size;
    service_.site_.said(number_, std::move(message), ticket(size));
    reads_ = waiting_ <= service_.limits_.waiting;
    if (reads_) read();
  }

  /// Whoever lets it go may be in any thread.
  Ticket ticket(std::size_t size) {
    const auto release = [page = weak_from_this(), size, &context = service_.context_](void*) {
      asio::post(context, [page, size] {
        if (const auto self = page.lock()) self->done(size);
      });
    };
    return {nullptr, release};
  }

  void done(std::size_t size) {
    waiting_ -= size;
    if (reads_ || waiting_ > service_.limits_.waiting) return;
    reads_ = true;
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
                        });
  }

  Service& service_;
  ws::stream<beast::tcp_stream> stream_;
  std::shared_ptr<Place> connection_;
  Place place_;
  int number_ = 0;
  beast::flat_buffer buffer_;
  std::size_t waiting_ = 0;  ///< [bytes] of messages whose tickets exist
  bool reads_ = true;
  std::deque<Outgoing> queue_;
  std::size_t unsent_ = 0;  ///< [bytes]
};

/// A connection as long as it is none of a page.
class HttpServer::Service::Connection : public std::enable_shared_from_this<Connection> {
 public:
  Connection(Service& service, tcp::socket socket)
      : service_(service),
        stream_(std::move(socket)),
        place_(std::make_shared<Place>(service.connections_)) {}

  void read() {
    parser_ = std::make_shared<Parser>();
    parser_->header_limit(service_.limits_.header);
    parser_->body_limit(0);
    stream_.expires_after(service_.limits_.handshake);
    beast::http::async_read(stream_, buffer_, *parser_,
                            [self = shared_from_this()](error_code error, std::size_t) {
                              if (!error) self->decide();
                            });
  }

 private:
  void decide() {
    const Request request = request_of(*parser_);
    const Decision decision = http::decide(request, service_.key);
    switch (decision.kind) {
      case Decision::Kind::refuse:
        return send(empty(403), false);
      case Decision::Kind::enter:
        return send(entrance(), true);
      case Decision::Kind::pass:
        return send(answer(request, decision.path), parser_->keep_alive());
      case Decision::Kind::upgrade:
        return upgrade(decision.path);
    }
  }

  static Answer empty(int status) { return {status, security_headers(random_token())}; }

  Answer entrance() const {
    Answer answer = empty(303);
    answer.headers.push_back({"Location", "/"});
    answer.headers.push_back({"Set-Cookie", fmt::format("{}={}; HttpOnly; SameSite=Strict; Path=/",
                                                        cookie_name(service_.key), service_.key.token)});
    return answer;
  }

  Answer answer(const Request& request, const std::string& path) const {
    const bool reads = request.method == "GET" || request.method == "HEAD";
    return reads ? service_.site_.answer(request, path) : empty(405);
  }

  void upgrade(const std::string& path) {
    if (!service_.site_.has_socket(path)) return send(empty(404), false);
    if (service_.sockets_ >= service_.limits_.pages) return send(empty(503), false);
    std::make_shared<Page>(service_, std::move(stream_), std::move(place_))->accept(std::move(parser_));
  }

  void send(Answer answer, bool keep) {
    answer_ = std::move(answer);
    const std::string_view body = answer_.body.empty() ? answer_.fixed : std::string_view(answer_.body);
    response_ = Response(beast::http::int_to_status(static_cast<unsigned>(answer_.status)), 11);
    for (const Header& one : answer_.headers) response_.set(one.name, one.value);
    response_.keep_alive(keep);
    response_.body() = {body.data(), body.size()};
    response_.content_length(body.size());
    if (parser_->get().method() == beast::http::verb::head) response_.body() = {};
    stream_.expires_after(service_.limits_.handshake);
    beast::http::async_write(stream_, response_,
                             [self = shared_from_this(), keep](error_code error, std::size_t) {
                               if (!error && keep) self->read();
                             });
  }

  Service& service_;
  beast::tcp_stream stream_;
  std::shared_ptr<Place> place_;
  beast::flat_buffer buffer_;
  std::shared_ptr<Parser> parser_;
  Answer answer_;
  Response response_;
};

HttpServer::Service::Service(Site& site, std::uint16_t port, Limits limits) : site_(site), limits_(limits) {
  key.token = random_token();
  // Somebody else may have the port at the other address only: then another one is taken, if it may be any.
  for (int attempt = 0; attempt < (port == 0 ? 16 : 1); ++attempt)
    if (listen(port)) return;
  throw io::EnvironmentError(
      fmt::format("port {} is taken at one of the addresses of this machine; another one is "
                  "given by --port N",
                  key.port));
}

tcp::acceptor& HttpServer::Service::add_acceptor(const tcp::endpoint& endpoint) {
  tcp::acceptor& acceptor = acceptors_.emplace_back(context_, endpoint.protocol());
  acceptor.set_option(tcp::acceptor::reuse_address(true));
  if (endpoint.protocol() == tcp::v6()) acceptor.set_option(asio::ip::v6_only(true));
  acceptor.bind(endpoint);
  acceptor.listen();
  return acceptor;
}

bool HttpServer::Service::listen(std::uint16_t port) {
  acceptors_.clear();
  key.port = port;
  try {
    key.port = add_acceptor({asio::ip::address_v4::loopback(), port}).local_endpoint().port();
  } catch (const boost::system::system_error& error) {
    if (error.code() == asio::error::address_in_use) return false;
    throw io::EnvironmentError(fmt::format("port {}: {}", port, error.code().message()));
  }
  try {
    add_acceptor({asio::ip::address_v6::loopback(), key.port});
  } catch (const boost::system::system_error& error) {
    if (error.code() == asio::error::address_in_use) return false;
    if (acceptors_.size() > 1) acceptors_.pop_back();  // this machine has no IPv6
  }
  return true;
}

void HttpServer::Service::accept(tcp::acceptor& acceptor) {
  acceptor.async_accept([this, &acceptor](error_code error, tcp::socket socket) {
    if (!error) take(std::move(socket));
    if (error != asio::error::operation_aborted) accept(acceptor);
  });
}

void HttpServer::Service::take(tcp::socket socket) {
  if (connections_ >= limits_.connections) return;
  error_code ignored;
  socket.set_option(tcp::no_delay(true), ignored);
  std::make_shared<Connection>(*this, std::move(socket))->read();
}

void HttpServer::Service::start() {
  for (tcp::acceptor& acceptor : acceptors_) accept(acceptor);
  thread_ = std::thread([this] { context_.run(); });
}

void HttpServer::Service::stop() {
  context_.stop();
  if (thread_.joinable()) thread_.join();
}

void HttpServer::Service::send(int page, bool text, std::string message) {
  asio::post(context_, [this, page, text, message = std::move(message)]() mutable {
    const auto found = pages_.find(page);
    if (found == pages_.end()) return;
    if (const auto open = found->second.lock()) open->send(text, std::move(message));
  });
}

HttpServer::HttpServer(Site& site, std::uint16_t port, Limits limits)
    : service_(std::make_unique<Service>(site, port, limits)) {}

HttpServer::~HttpServer() {
  service_->stop();
}

const Key& HttpServer::key() const {
  return service_->key;
}

void HttpServer::start() {
  service_->start();
}

void HttpServer::stop() {
  service_->stop();
}

void HttpServer::send_text(int page, std::string text) {
  service_->send(page, true, std::move(text));
}

void HttpServer::send_bytes(int page, std::string bytes) {
  service_->send(page, false, std::move(bytes));
}

}  // namespace stepwire::http
