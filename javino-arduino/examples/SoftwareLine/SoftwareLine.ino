// An agent's line on two pins of an Uno, for a Bluetooth module HC-05 or a Raspberry Pi. The Uno's only serial port serves the serial
// monitor, which shows events.
//
//   wiring    the far end's TX to pin 10, its RX to pin 11, GND to GND. For a far end of 3.3 V, two resistors divide pin 11's 5 V
//   actions   ledOn, ledOff
//   percepts  led(on) or led(off)
//   agent     !start.
//             +!start <- argo.port(rfcomm0, [baud(9600)]); argo.percepts(open).
//             +led(off) <- argo.act(ledOn).
//             +led(on) <- argo.act(ledOff).
//
// SoftwareSerial cannot receive while it sends. Keep answers short, and use 9600 baud or less. In version 2 the computer repeats lost
// commands and requests. For AVR and ESP8266. Boards with more ports can use SecondPort. On a Mega receive on one of the pins 10-15,
// 50-53, A8-A15.

#include <Javino.h>
#include <SoftwareSerial.h>

SoftwareSerial line(10, 11);  // receive pin, send pin
Javino javino(line);

void setLed(bool on) {
  digitalWrite(LED_BUILTIN, on ? HIGH : LOW);
  Serial.println(on ? "on" : "off");
}

void ledOn() {
  setLed(true);
}

void ledOff() {
  setLed(false);
}

void look() {
  javino.percept("led", digitalRead(LED_BUILTIN) ? "on" : "off");
}

void setup() {
  pinMode(LED_BUILTIN, OUTPUT);
  Serial.begin(115200);
  Serial.println("ready");
  javino.act["ledOn"] = ledOn;
  javino.act["ledOff"] = ledOff;
  javino.perceive(look);
  javino.start(9600);
}

void loop() {
  javino.run();
}
