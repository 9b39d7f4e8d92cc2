// An arm on a servo that moves slowly while the board continues to work. The agent may set a new angle at any time.
//
//   wiring    the servo's signal to pin 9; its power from a separate supply, because USB gives too little and the board would restart;
//             GND of the supply to GND of the board
//   actions   angle(0..180), hold
//   percepts  angle(Degrees), moving until the arm reaches the angle
//   agent     !start.
//             +!start <- argo.port(ttyACM0); argo.percepts(open); argo.act(angle(120)).
//             -moving : angle(120) <- argo.act(angle(60)).
//             -moving : angle(60) <- argo.act(angle(120)).
//
// After a second without a message from the computer, the arm stops where it is. The library Servo is part of the Arduino IDE. For an
// ESP32 install ESP32Servo.

#include <Javino.h>

#ifdef ESP32
#include <ESP32Servo.h>
#else
#include <Servo.h>
#endif

const uint8_t SIGNAL = 9;
const unsigned long MS_PER_DEGREE = 10;
const unsigned long SILENCE_MS = 1000;

Javino javino;
Servo servo;
int angle = 90;
int wanted = 90;
unsigned long moved = 0;

bool turn(const JavinoArguments &arguments) {
  long degrees = arguments.number(0, -1);
  if (degrees < 0 || degrees > 180)
    return false;
  wanted = static_cast<int>(degrees);
  return true;
}

void hold() {
  wanted = angle;
}

void move() {
  if (angle == wanted || millis() - moved < MS_PER_DEGREE)
    return;
  moved = millis();
  angle += angle < wanted ? 1 : -1;
  servo.write(angle);
}

void look() {
  javino.describe(F("angle(degrees 0..180)"));
  javino.describe(F("moving"));
  javino.percept("angle", angle);
  if (angle != wanted)
    javino.percept("moving");
}

void setup() {
  servo.attach(SIGNAL);
  servo.write(angle);
  javino.onAction("angle", turn, 1);
  javino.act["hold"] = hold;
  javino.onLinkLost(SILENCE_MS, hold);
  javino.perceive(look);
  javino.start(9600);
}

void loop() {
  move();
  javino.run();
}
