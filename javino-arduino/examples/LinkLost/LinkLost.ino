// A motor that stops after 300 ms without a valid message from the computer.
//
// Only run() notices the silence. If loop() hangs, the motor continues to run. A watchdog stops the motor even then. On AVR #include
// <avr/wdt.h>, call wdt_enable(WDTO_500MS) in setup() and wdt_reset() in loop(). The watchdog restarts a board that has hung for half a
// second, with its motors off. (The boot loaders of some older Megas and Nanos cannot handle such a restart.)
//
//   actions   speed(0..255)
//   percepts  motor(Speed), stopped(linkLost) once after the link was lost
//   agent     !start.
//             +!start <- argo.port(ttyACM0); argo.percepts(open); argo.act(speed(120)).
//             +stopped(linkLost) <- .print("the motor has stopped by itself"); argo.act(speed(120)).

#include <Javino.h>

const uint8_t MOTOR = 5;

Javino javino;
uint8_t power = 0;
bool wasLost = false;

void setMotor(uint8_t value) {
  power = value;
  analogWrite(MOTOR, power);
}

bool speed(const JavinoArguments &arguments) {
  long wanted = arguments.number(0, -1);
  if (wanted < 0 || wanted > 255)
    return false;
  setMotor(static_cast<uint8_t>(wanted));
  return true;
}

void linkLost() {
  wasLost = power > 0;
  setMotor(0);
}

void look() {
  javino.describe(F("motor(0..255)"));
  javino.describe(F("stopped(linkLost)"));
  javino.percept("motor", power);
  // Only a request for this percept clears the flag.
  if (wasLost && javino.wants("stopped")) {
    javino.percept("stopped", "linkLost");
    wasLost = false;
  }
}

void setup() {
  pinMode(MOTOR, OUTPUT);
  javino.onAction("speed", speed, 1);
  javino.onLinkLost(300, linkLost);
  javino.perceive(look);
  javino.start(9600);
}

void loop() {
  javino.run();
}
