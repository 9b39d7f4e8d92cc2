// A board whose agent uses a second serial port. The serial monitor on the first port shows the commands that the board carries out.
//
//   wiring    the far end's TX to the board's RX1 (Mega: 19, Leonardo: 0), its RX to TX1 (Mega: 18, Leonardo: 1), GND to GND. For a far
//             end of 3.3 V, two resistors divide TX1's 5 V
//   actions   speed(0..255)
//   percepts  motor(Speed)
//   agent     !start.
//             +!start <- argo.port(serial0, [baud(115200)]); argo.percepts(open); argo.act(speed(120)).
//             +motor(Speed) <- .print("the motor has ", Speed).
//
// For Mega, Leonardo, ESP32, Pico and others with a Serial1. On a Uno or an ESP8266 Serial1 cannot receive: see SoftwareLine.

#include <Javino.h>

const uint8_t MOTOR = 5;
const unsigned long SILENCE_MS = 1000;

Javino javino(Serial1);
uint8_t power = 0;

// Drops text that the monitor's buffer cannot take at once, so a slow or closed monitor does not delay the robot.
void print(const char *what, long value) {
  if (Serial.availableForWrite() < 24)
    return;
  Serial.print(what);
  Serial.println(value);
}

void setMotor(uint8_t value) {
  power = value;
  analogWrite(MOTOR, power);
}

bool speed(const JavinoArguments &arguments) {
  long wanted = arguments.number(0, -1);
  print("speed ", wanted);
  if (wanted < 0 || wanted > 255)
    return false;
  setMotor(static_cast<uint8_t>(wanted));
  return true;
}

void linkLost() {
  setMotor(0);
  print("link lost at ms ", static_cast<long>(millis()));
}

void look() {
  javino.percept("motor", power);
}

void setup() {
  pinMode(MOTOR, OUTPUT);
  Serial.begin(115200);
  javino.onAction("speed", speed, 1);
  javino.onLinkLost(SILENCE_MS, linkLost);
  javino.perceive(look);
  javino.start(115200);
}

void loop() {
  javino.run();
}
