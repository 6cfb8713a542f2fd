#include "engine/app/studio/http/gate.hpp"

#include <catch2/catch.hpp>
#include <set>

namespace stepwire::http {

namespace {

using Texts = std::vector<std::string>;

const Key key{8080, "0123456789abcdef0123456789abcdef"};
const std::string origin = "http://127.0.0.1:8080";
const std::string cookie = "stepwire-8080=" + key.token;

/// A request that is let in, to be spoilt.
Request good(const std::string& target = "/") {
  return {"GET", target, {{"Host", "127.0.0.1:8080"}, {"Cookie", cookie}}};
}

Request socket() {
  Request request = good("/socket");
  request.headers.push_back({"Upgrade", "websocket"});
  request.headers.push_back({"Origin", origin});
  return request;
}

Request with(Request request, const std::string& name, const std::string& value) {
  for (Header& one : request.headers)
    if (same_word(one.name, name)) one.value = value;
  if (!request.has(name)) request.headers.push_back({name, value});
  return request;
}

Request without(Request request, const std::string& name) {
  std::erase_if(request.headers, [&](const Header& one) { return same_word(one.name, name); });
  return request;
}

bool refuses(const Request& request) {
  return decide(request, key) == Decision{};
}

}  // namespace

TEST_CASE("a page with the cookie is let in, and so is its socket") {
  CHECK(decide(good("/a.js?x=1"), key) == Decision{Decision::Kind::pass, "/a.js"});
  CHECK(decide(socket(), key) == Decision{Decision::Kind::upgrade, "/socket"});
  for (const std::string& host : Texts{"127.0.0.1:8080", "localhost:8080", "[::1]:8080"})
    CHECK(decide(with(with(socket(), "Host", host), "Origin", "http://" + host), key).kind ==
          Decision::Kind::upgrade);
}

TEST_CASE("the token lets in once in the address of the page, and nowhere else") {
  const Request first = without(good("/?token=" + key.token), "Cookie");
  CHECK(decide(first, key) == Decision{Decision::Kind::enter, "/"});
  for (const std::string& target : Texts{
           "/?token=", "/?token=" + key.token.substr(1), "/?token=" + key.token + "0", "/?Token=" + key.token,
           "/?a=b&token=" + key.token, "/socket?token=" + key.token, "/?token=" + key.token + "&a=b",
           "/?token=0123456789ABCDEF0123456789ABCDEF", "//?token=" + key.token})
    CHECK(refuses(without(good(target), "Cookie")));
  Request posted = first;
  posted.method = "POST";
  CHECK(refuses(with(posted, "Origin", origin)));
  CHECK(refuses(without(with(socket(), "Host", "127.0.0.1:8080"), "Cookie")));
}

TEST_CASE("Host has to be a loopback name with the port, written as browsers write it") {
  for (const std::string& host :
       Texts{"", "127.0.0.1", "127.0.0.1:80", "127.0.0.1:8081", "127.0.0.1:08080", "127.0.0.2:8080",
             "0.0.0.0:8080", "example.com:8080", "127.0.0.1.example.com:8080", "localhost.:8080",
             "LOCALHOST:8080", "::1:8080", "[::]:8080", "127.0.0.1:8080 ", "127.0.0.1:8080,evil",
             "user@127.0.0.1:8080", "2130706433:8080"}) {
    INFO(host);
    CHECK(refuses(with(good(), "Host", host)));
    CHECK(refuses(with(with(socket(), "Host", host), "Origin", "http://" + host)));
  }
  CHECK(refuses(without(good(), "Host")));
  Request twice = good();
  twice.headers.push_back({"host", "127.0.0.1:8080"});
  CHECK(refuses(twice));
}

TEST_CASE("a name that leads here by DNS rebinding is refused, with the token and its own Origin") {
  Request request = with(socket(), "Host", "rebound.example:8080");
  CHECK(refuses(with(request, "Origin", "http://rebound.example:8080")));
  CHECK(refuses(with(good("/?token=" + key.token), "Host", "rebound.example:8080")));
}

TEST_CASE("Origin has to be ours for sockets and for what is no GET, and wherever it is sent") {
  for (const std::string& other : Texts{
           "null", "", "http://127.0.0.1", "http://127.0.0.1:8081", "https://127.0.0.1:8080",
           "http://localhost:8080", "http://[::1]:8080", "http://127.0.0.1:8080/",
           "http://127.0.0.1:8080.evil.example", "HTTP://127.0.0.1:8080", "http://evil.example", "file://"}) {
    INFO(other);
    CHECK(refuses(with(socket(), "Origin", other)));
    CHECK(refuses(with(good(), "Origin", other)));
  }
  CHECK(refuses(without(socket(), "Origin")));
  for (const std::string& method :
       Texts{"POST", "PUT", "DELETE", "OPTIONS", "PATCH", "get", "CONNECT", "TRACE"}) {
    Request request = good();
    request.method = method;
    INFO(method);
    CHECK(refuses(request));
    CHECK_FALSE(refuses(with(request, "Origin", origin)));  // then it is refused as a method, behind the gate
  }
  Request twice = socket();
  twice.headers.push_back({"Origin", "http://evil.example"});
  CHECK(refuses(twice));
}

TEST_CASE("an upgrade to anything is held to the rules of sockets") {
  for (const std::string& what : Texts{"h2c", "websocket, h2c", "WEBSOCKET"})
    CHECK(refuses(with(without(socket(), "Origin"), "Upgrade", what)));
  CHECK(decide(with(socket(), "Upgrade", "WebSocket"), key).kind == Decision::Kind::upgrade);
}

TEST_CASE("a cookie that is wrong, doubled or of another port lets nobody in") {
  for (const std::string& line :
       Texts{"", "stepwire-8080=", "stepwire-8080=" + key.token.substr(1), "stepwire-8080=" + key.token + "0",
             "stepwire-8081=" + key.token, "Stepwire-8080=" + key.token, "xstepwire-8080=" + key.token,
             "a=stepwire-8080=" + key.token, cookie + "; " + cookie, cookie + "; stepwire-8080=x",
             "stepwire-8080=x; " + cookie, "stepwire-8080=\"" + key.token + "\"", "\t" + cookie}) {
    INFO(line);
    CHECK(refuses(with(good(), "Cookie", line)));
  }
  for (const std::string& line :
       Texts{"a=b; " + cookie, cookie + ";c=d", "stepwire-8081=x; " + cookie + "; e"})
    CHECK_FALSE(refuses(with(good(), "Cookie", line)));
  Request twice = good();
  twice.headers.push_back({"Cookie", cookie});
  CHECK(refuses(twice));
}

TEST_CASE("a target is a path from the root and nothing else; it is not decoded") {
  for (const std::string& target : Texts{"", "*", "http://127.0.0.1:8080/", "index.html", "/a b", "/\x01",
                                         "/\xc3\xa9", "/a#b", "/a\\b", "127.0.0.1:8080"}) {
    INFO(target);
    CHECK(refuses(good(target)));
  }
  for (const std::string& path :
       Texts{"/../etc/passwd", "/%2e%2e/etc/passwd", "//etc/passwd", "/a/./b", "/%00"})
    CHECK(decide(good(path), key) == Decision{Decision::Kind::pass, path});  // no table has such a path
}

TEST_CASE("secrets are the same only where all of them is, and no empty one is") {
  CHECK(same_secret("abc", "abc"));
  for (const std::string& other : Texts{"", "a", "ab", "abd", "bbc", "abcabc", "abcd"})
    CHECK_FALSE(same_secret(other, "abc"));
  CHECK_FALSE(same_secret("", ""));
  CHECK_FALSE(same_secret("abc", ""));
}

TEST_CASE("tokens have 128 bits and never come again") {
  std::set<std::string> seen;
  for (int i = 0; i < 1000; ++i) {
    const std::string token = random_token();
    CHECK(token.size() == 32);
    CHECK(token.find_first_not_of("0123456789abcdef") == std::string::npos);
    seen.insert(token);
  }
  CHECK(seen.size() == 1000);
}

}  // namespace stepwire::http
