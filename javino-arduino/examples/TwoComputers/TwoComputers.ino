// One board, two computers: an agent on USB drives the motor, and an agent on a second port watches and may stop it. Each port has its
// own Javino object, with its own actions and percepts.
//
//   wiring    a motor's driver at pin 5, a sensor at A0; the second computer at Serial1. On boards without Serial1: at the pins 10
//             (receives) and 11 (sends)
//   actions   first port: speed(0..255), stop; second port: stop
//   percepts  first port: motor(Speed); second port: motor(Speed), light(0..1023)
//   agent     !start.
//             +!start <- argo.port(ttyACM0); argo.percepts(open); argo.act(speed(120)).
//   watcher   !start.
//             +!start <- argo.port(ttyUSB0); argo.percepts(open).
//             +light(L) : L < 100 <- argo.act(stop).
//
// The motor stops after a second without a message from the first computer. The second computer may come and go.

#include <Javino.h>

#if defined(ARDUINO_AVR_UNO) || defined(ESP8266)
#include <SoftwareSerial.h>
SoftwareSerial second(10, 11);
#else
#define second Serial1
#endif

const uint8_t MOTOR = 5;
const unsigned long SILENCE_MS = 1000;

Javino driver;
Javino watcher(second);
uint8_t power = 0;

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

void stop() {
  setMotor(0);
}

void look(JavinoBoard &board) {
  board.percept("motor", power);
  if (&board == &watcher)
    board.percept("light", analogRead(A0));
}

void setup() {
  pinMode(MOTOR, OUTPUT);
  driver.onAction("speed", speed, 1);
  driver.act["stop"] = stop;
  driver.onLinkLost(SILENCE_MS, stop);
  driver.perceive(look);
  driver.start(9600);
  watcher.act["stop"] = stop;
  watcher.perceive(look);
  watcher.start(9600);
}

void loop() {
  driver.run();
  watcher.run();
}
