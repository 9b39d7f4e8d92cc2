/**
 * @file The Javino protocol for Arduino. An agent requests percepts from the board and sends it actions.
 *
 *     #include <Javino.h>
 *
 *     Javino javino;
 *
 *     void ledOn() { digitalWrite(LED_BUILTIN, HIGH); }
 *     void look() { javino.percept("light", analogRead(A0)); }
 *
 *     void setup() {
 *       pinMode(LED_BUILTIN, OUTPUT);
 *       javino.act["ledOn"] = ledOn;
 *       javino.perceive(look);
 *       javino.start(9600);
 *     }
 *
 *     void loop() { javino.run(); }
 */
#ifndef JAVINO_H
#define JAVINO_H

#include "JavinoBoard.h"

/**
 * A board with this many bytes of memory, at least JAVINO_MEMORY_MIN. The memory holds incoming bytes, an answer and the table of
 * actions. The board cannot receive a message that does not fit into the rest of the memory.
 */
template <uint16_t Bytes> class JavinoSized : public JavinoBoard {
public:
  /** A board on Serial. */
  JavinoSized() : JavinoBoard(Serial, NULL, memory_, USED) {}

  /**
   * A board on a port or on a stream. start() opens a port, such as Serial1 or a SoftwareSerial. The sketch opens a stream without a
   * rate, such as a WiFiClient or a BluetoothSerial.
   */
  template <typename Port> explicit JavinoSized(Port &port) : JavinoBoard(port, open<Port>, memory_, USED) {}

  /** Opens the board's port. Does not open a stream without a rate. The far end must use the same rate, in baud. */
  void start(unsigned long baud = 9600) {
    /* Calls Serial directly: for a constant rate, the compiler then computes the port's settings. */
    if (open_)
      open_(stream_, baud);
    else
      Serial.begin(baud);
    setTimeLimit(JAVINO_TIMEOUT_MS(baud));
  }

  /** Does the same as start(). Other libraries use this name. */
  void begin(unsigned long baud = 9600) { start(baud); }

private:
  template <typename Port> static void open(Stream &port, unsigned long baud) { open(static_cast<Port &>(port), baud, 0); }

  /* The compiler uses the first open() if it compiles, otherwise the second. */
  template <typename Port> static auto open(Port &port, unsigned long baud, int) -> decltype(port.begin(baud), void()) { port.begin(baud); }
  template <typename Port> static void open(Port &, unsigned long, long) {}

  static_assert(Bytes >= JAVINO_MEMORY_MIN, "JavinoSized: too few bytes");
  /* The table of actions is at the end. */
  static const uint16_t USED = Bytes / sizeof(void *) * sizeof(void *);
  alignas(void *) uint8_t memory_[Bytes];
};

/** A board on Serial, or on a given port or stream. */
class Javino : public JavinoSized<JAVINO_BYTES> {
public:
  Javino() {}
  template <typename Port> explicit Javino(Port &port) : JavinoSized<JAVINO_BYTES>(port) {}
};

#endif
