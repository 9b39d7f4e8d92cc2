/**
 * @file A board on a network or on Bluetooth. It uses any Stream, such as a WiFiClient, an EthernetClient or a BluetoothSerial. The
 *     sketch may open, replace and lose this stream. Serial is not needed.
 *
 *     #include <JavinoNetwork.h>
 *
 *     WiFiServer server(4000);
 *     WiFiClient client;
 *     JavinoNetwork javino;
 *
 *     void loop() {
 *       WiFiClient next = server.accept();
 *       if (next) {
 *         client = next;
 *         javino.setStream(client);
 *       }
 *       javino.run();
 *     }
 *
 * It has all functions of JavinoBoard. All bytes of a run() go out in one write, so a frame takes one packet.
 */
#ifndef JAVINO_NETWORK_H
#define JAVINO_NETWORK_H

#include "JavinoBoard.h"

/**
 * The number of bytes that are gathered for one write. A longer answer takes several writes. A TCP packet over Ethernet holds 1,460
 * bytes.
 */
#ifndef JAVINO_GATHERED_BYTES
#define JAVINO_GATHERED_BYTES 300
#endif

/** For JavinoNetworkSized: gathers the bytes for a stream. The stream may change or be absent. */
class JavinoGathering : public Stream {
public:
  JavinoGathering() : to_(NULL), length_(0) {}

  /** Sets the stream, and forgets bytes gathered for the previous stream. */
  void setStream(Stream *stream) {
    to_ = stream;
    length_ = 0;
  }

  bool isOn(const Stream *stream) const { return to_ == stream; }

  /** Writes the gathered bytes. Drops bytes that the stream does not take. */
  void send() {
    size_t sent = 0;
    while (to_ && sent < length_) {
      size_t n = to_->write(bytes_ + sent, length_ - sent);
      if (n == 0)
        break;
      sent += n;
    }
    length_ = 0;
  }

  int available() { return to_ ? to_->available() : 0; }
  int read() { return to_ ? to_->read() : -1; }
  int peek() { return to_ ? to_->peek() : -1; }
  void flush() { send(); }
  size_t write(uint8_t byte) {
    if (!to_)
      return 0;
    if (length_ == sizeof bytes_)
      send();
    bytes_[length_++] = byte;
    return 1;
  }

private:
  Stream *to_;
  size_t length_;
  uint8_t bytes_[JAVINO_GATHERED_BYTES];
};

/** A base class of JavinoNetworkSized. The board refers to the member of this class, so the member must be constructed before the board. */
struct JavinoGatheringHolder {
  JavinoGathering gathering_;
};

/** A board on streams with this many bytes of memory, see JavinoSized. */
template <uint16_t Bytes> class JavinoNetworkSized : private JavinoGatheringHolder, public JavinoBoard {
public:
  /** A board without a stream until setStream() is called. */
  JavinoNetworkSized() : JavinoBoard(gathering_, NULL, memory_, USED) { begin(); }

  /** A board on this stream. The stream must stay valid while the board uses it. */
  explicit JavinoNetworkSized(Stream &stream) : JavinoBoard(gathering_, NULL, memory_, USED) {
    begin();
    setStream(stream);
  }

  /** Sets the longest pause within a message to 2 s, for networks. The constructor also does this. See setTimeLimit(). */
  void begin() { setTimeLimit(2000); }

  /**
   * Uses this open stream from now on, for example a computer's new connection. The stream must stay valid until another is set. An
   * incomplete message from the old stream is forgotten. If the old stream loses an outcome, the computer may repeat the command through
   * the new stream. The board still carries the command out only once. Do not call this within a callback.
   */
  void setStream(Stream &stream) {
    gathering_.setStream(&stream);
    forgetPart();
  }

  /** Removes the stream. run() still notices a lost link. */
  void removeStream() { gathering_.setStream(NULL); }

  /** Returns true if a stream has been set. */
  bool hasStream() const { return !gathering_.isOn(NULL); }

  /** @name Like the functions of JavinoBoard. These functions also send the gathered bytes. */
  ///@{
  void run() {
    JavinoBoard::run();
    gathering_.send();
  }
  bool availableMsg() {
    bool found = JavinoBoard::availableMsg();
    gathering_.send();
    return found;
  }
  void sendPercepts() {
    JavinoBoard::sendPercepts();
    gathering_.send();
  }
  template <typename Text> bool sendMsg(const Text &text) {
    bool sent = JavinoBoard::sendMsg(text);
    gathering_.send();
    return sent;
  }
  bool done(JavinoLater later, bool carried_out = true) {
    bool reported = JavinoBoard::done(later, carried_out);
    gathering_.send();
    return reported;
  }
  ///@}

private:
  static_assert(Bytes >= JAVINO_MEMORY_MIN, "JavinoNetworkSized: too few bytes");
  static const uint16_t USED = Bytes / sizeof(void *) * sizeof(void *);
  alignas(void *) uint8_t memory_[Bytes];
};

/** A board on streams. */
class JavinoNetwork : public JavinoNetworkSized<JAVINO_BYTES> {
public:
  JavinoNetwork() {}
  explicit JavinoNetwork(Stream &stream) : JavinoNetworkSized<JAVINO_BYTES>(stream) {}
};

#endif
