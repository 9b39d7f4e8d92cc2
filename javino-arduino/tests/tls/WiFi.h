/** @file The WiFi interface of tests/stub/Network.h on this machine's sockets, for the example TlsRobot. */
#ifndef TLS_WIFI_H
#define TLS_WIFI_H

#include <Arduino.h>
#include <arpa/inet.h>
#include <errno.h>
#include <netinet/tcp.h>
#include <stdio.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <memory>

#define WIFI_STA 1

typedef enum { WL_CONNECTED = 3 } wl_status_t;

struct Socket {
  explicit Socket(int fd) : fd(fd) {}
  ~Socket() { ::close(fd); }
  int fd;
};

class WiFiClient : public Stream {
public:
  WiFiClient() {}
  explicit WiFiClient(int fd) : socket_(std::make_shared<Socket>(fd)) {}
  int available() override {
    int n = 0;
    return socket_ && ioctl(socket_->fd, FIONREAD, &n) == 0 ? n : 0;
  }
  int read() override {
    uint8_t byte;
    return read(&byte, 1) == 1 ? byte : -1;
  }
  int read(uint8_t *bytes, size_t n) { return socket_ ? static_cast<int>(recv(socket_->fd, bytes, n, MSG_DONTWAIT)) : -1; }
  int peek() override { return -1; }
  size_t write(uint8_t byte) override { return write(&byte, 1); }
  size_t write(const uint8_t *bytes, size_t n) override {
    ssize_t sent = socket_ ? send(socket_->fd, bytes, n, MSG_DONTWAIT | MSG_NOSIGNAL) : 0;
    return sent > 0 ? static_cast<size_t>(sent) : 0;
  }
  explicit operator bool() { return socket_ != nullptr; }
  uint8_t connected() {
    char byte;
    return socket_ && (available() || (recv(socket_->fd, &byte, 1, MSG_PEEK | MSG_DONTWAIT) < 0 && errno == EAGAIN));
  }
  void stop() { socket_.reset(); }
  void setNoDelay(bool on) {
    int value = on;
    setsockopt(socket_->fd, IPPROTO_TCP, TCP_NODELAY, &value, sizeof value);
  }

private:
  std::shared_ptr<Socket> socket_;
};

/** Listens on a port of the system's choice, which it prints. */
class WiFiServer {
public:
  explicit WiFiServer(uint16_t) {}
  void begin() {
    sockaddr_in address = {};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    fd_ = ::socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK, 0);
    if (bind(fd_, reinterpret_cast<sockaddr *>(&address), size) != 0 || listen(fd_, 8) != 0 ||
        getsockname(fd_, reinterpret_cast<sockaddr *>(&address), &size) != 0) {
      perror("server");
      exit(1);
    }
    printf("port %d\n", ntohs(address.sin_port));
    fflush(stdout);
  }
  WiFiClient accept() {
    int fd = accept4(fd_, NULL, NULL, SOCK_NONBLOCK);
    return fd < 0 ? WiFiClient() : WiFiClient(fd);
  }

private:
  int fd_ = -1;
};

class WiFiClass {
public:
  void mode(int) {}
  int begin(const char *, const char *) { return 0; }
  wl_status_t status() { return WL_CONNECTED; }
  int localIP() { return 0; }
};

extern WiFiClass WiFi;

#endif
