// The board's end of TLS on a WiFiClient. Uses mbedTLS, which is part of the ESP32's core. The core's own WiFiClientSecure supports only
// clients. The cores of the ESP8266 and the Pico W have a WiFiServerSecure, so they do not need this file.

#ifndef TLS_CONNECTION_H
#define TLS_CONNECTION_H

#include <WiFi.h>
#include <mbedtls/ctr_drbg.h>
#include <mbedtls/entropy.h>
#include <mbedtls/net_sockets.h>
#include <mbedtls/pk.h>
#include <mbedtls/ssl.h>
#include <mbedtls/version.h>
#include <mbedtls/x509_crt.h>

// The board's certificate and key, and the certificate of the permitted computer.
class TlsIdentity {
public:
  // Takes the board's certificate and key, and the only permitted computer's certificate, all in PEM. Returns 0, or mbedTLS' error.
  int begin(const char *board, const char *key, const char *computer) {
    mbedtls_x509_crt_init(&board_);
    mbedtls_x509_crt_init(&computer_);
    mbedtls_pk_init(&key_);
    mbedtls_entropy_init(&entropy_);
    mbedtls_ctr_drbg_init(&random_);
    mbedtls_ssl_config_init(&configuration_);
    int error = mbedtls_ctr_drbg_seed(&random_, mbedtls_entropy_func, &entropy_, NULL, 0);
    if (!error)
      error = mbedtls_x509_crt_parse(&board_, bytes(board), strlen(board) + 1);
    if (!error)
      error = mbedtls_x509_crt_parse(&computer_, bytes(computer), strlen(computer) + 1);
    if (!error)
      error = parseKey(key);
    if (!error)
      error = mbedtls_ssl_config_defaults(&configuration_, MBEDTLS_SSL_IS_SERVER, MBEDTLS_SSL_TRANSPORT_STREAM, MBEDTLS_SSL_PRESET_DEFAULT);
    if (!error)
      error = mbedtls_ssl_conf_own_cert(&configuration_, &board_, &key_);
    mbedtls_ssl_conf_ca_chain(&configuration_, &computer_, NULL);
    mbedtls_ssl_conf_authmode(&configuration_, MBEDTLS_SSL_VERIFY_REQUIRED);
    mbedtls_ssl_conf_rng(&configuration_, mbedtls_ctr_drbg_random, &random_);
    return error;
  }

  const mbedtls_ssl_config *configuration() const { return &configuration_; }

private:
  static const unsigned char *bytes(const char *text) { return reinterpret_cast<const unsigned char *>(text); }

  int parseKey(const char *key) {
#if MBEDTLS_VERSION_MAJOR >= 3
    return mbedtls_pk_parse_key(&key_, bytes(key), strlen(key) + 1, NULL, 0, mbedtls_ctr_drbg_random, &random_);
#else
    return mbedtls_pk_parse_key(&key_, bytes(key), strlen(key) + 1, NULL, 0);
#endif
  }

  mbedtls_x509_crt board_;
  mbedtls_x509_crt computer_;
  mbedtls_pk_context key_;
  mbedtls_entropy_context entropy_;
  mbedtls_ctr_drbg_context random_;
  mbedtls_ssl_config configuration_;
};

// A stream over TLS. The handshake comes first, in steps that do not wait for the far end.
class TlsConnection : public Stream {
public:
  TlsConnection() : state_(CLOSED), at_(0), length_(0) {}

  // Begins the handshake on a new connection. Closes the old connection.
  void accept(const WiFiClient &client, const TlsIdentity &identity) {
    close();
    client_ = client;
    began_ = millis();
    mbedtls_ssl_init(&tls_);
    state_ = SHAKING;
    if (mbedtls_ssl_setup(&tls_, identity.configuration()) != 0) {
      Serial.println("TLS: no memory for another connection");
      close();
      return;
    }
    mbedtls_ssl_set_bio(&tls_, this, send, receive, NULL);
  }

  // Continues the handshake. Returns true once, when the far end has proved its identity.
  bool hasOpened() {
    if (state_ != SHAKING)
      return false;
    int result = mbedtls_ssl_handshake(&tls_);
    if (result == 0) {
      state_ = OPEN;
      return true;
    }
    bool waits = result == MBEDTLS_ERR_SSL_WANT_READ || result == MBEDTLS_ERR_SSL_WANT_WRITE;
    if (!waits || millis() - began_ > LIMIT_MS) {
      Serial.print("TLS: refused a connection, error ");
      Serial.println(result);
      close();
    }
    return false;
  }

  void close() {
    if (state_ == CLOSED)
      return;
    if (state_ == OPEN)
      mbedtls_ssl_close_notify(&tls_);
    mbedtls_ssl_free(&tls_);
    client_.stop();
    state_ = CLOSED;
    at_ = length_ = 0;
  }

  int available() {
    fill();
    return static_cast<int>(length_ - at_);
  }
  int read() { return available() ? bytes_[at_++] : -1; }
  int peek() { return available() ? bytes_[at_] : -1; }
  void flush() {}
  size_t write(uint8_t byte) { return write(&byte, 1); }
  size_t write(const uint8_t *bytes, size_t n) {
    size_t written = 0;
    while (state_ == OPEN && written < n) {
      int result = mbedtls_ssl_write(&tls_, bytes + written, n - written);
      if (result <= 0)
        close();  // a far end that takes no more bytes must not block the board
      else
        written += static_cast<size_t>(result);
    }
    return written;
  }

private:
  enum State { CLOSED, SHAKING, OPEN };
  static const unsigned long LIMIT_MS = 5000;

  void fill() {
    if (state_ != OPEN || at_ < length_)
      return;
    int result = mbedtls_ssl_read(&tls_, bytes_, sizeof bytes_);
    at_ = 0;
    length_ = result > 0 ? static_cast<size_t>(result) : 0;
    if (result <= 0 && result != MBEDTLS_ERR_SSL_WANT_READ && result != MBEDTLS_ERR_SSL_WANT_WRITE)
      close();
  }

  static int send(void *connection, const unsigned char *bytes, size_t n) {
    WiFiClient &client = static_cast<TlsConnection *>(connection)->client_;
    size_t sent = client.write(bytes, n);
    if (sent > 0)
      return static_cast<int>(sent);
    return client.connected() ? MBEDTLS_ERR_SSL_WANT_WRITE : MBEDTLS_ERR_NET_CONN_RESET;
  }

  static int receive(void *connection, unsigned char *bytes, size_t n) {
    WiFiClient &client = static_cast<TlsConnection *>(connection)->client_;
    int waiting = client.available();
    if (waiting <= 0)
      return client.connected() ? MBEDTLS_ERR_SSL_WANT_READ : MBEDTLS_ERR_NET_CONN_RESET;
    return client.read(bytes, static_cast<size_t>(waiting) < n ? static_cast<size_t>(waiting) : n);
  }

  State state_;
  WiFiClient client_;
  mbedtls_ssl_context tls_;
  unsigned long began_;
  uint8_t bytes_[128];
  size_t at_;
  size_t length_;
};

#endif
