// The smallest board: an LED that an agent turns on and off and sees.
//
//   actions   ledOn, ledOff
//   percepts  ledStatus(on) or ledStatus(off)
//   agent     !start.
//             +!start <- argo.port(ttyACM0); argo.percepts(open).
//             +ledStatus(off) <- .wait(500); argo.act(ledOn).
//             +ledStatus(on) <- .wait(500); argo.act(ledOff).

#include <Javino.h>

Javino javino;

void ledOn() {
  digitalWrite(LED_BUILTIN, HIGH);
}

void ledOff() {
  digitalWrite(LED_BUILTIN, LOW);
}

void look() {
  javino.addPercept(digitalRead(LED_BUILTIN) ? "ledStatus(on)" : "ledStatus(off)");
}

void setup() {
  pinMode(LED_BUILTIN, OUTPUT);
  javino.act["ledOn"] = ledOn;
  javino.act["ledOff"] = ledOff;
  javino.perceive(look);
  javino.start(9600);
}

void loop() {
  javino.run();
}
