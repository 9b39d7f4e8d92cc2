// A robot with four driven wheels. Each of its four sides has a distance, a light and a temperature sensor.
//
//   percepts  dist(Side,Cm)  light(Side,Level)  temp(Side,Celsius)   Side is f, b, r or l; Level is 0 (bright) to 1023 (dark)
//   actions   front  back  left  right  stop  speed(0..255)
//             ledLightOn  ledLightOff  ledTempOn  ledTempOff
//   agent     !start.
//             +!start <- argo.port(ttyACM0); argo.percepts(open); argo.act(front).
//             +dist(f,Cm) : Cm < 40 <- argo.act(stop).
//             +light(f,Level) : Level > 100 <- argo.act(ledLightOn).
//
// The robot stops after a second without a message from the computer. The board watches critical rules from the computer, such as "stop
// when dist(f,_) is less than 40".
//
// Wiring for an Uno:
//   A0-A3   analogue outputs of four LV-MaxSonar-EZ: Vcc/512 an inch, which is half an inch a step
//   A4, A5  the two common pins of a 74HC4052, which selects one side's light sensor (A4) and LM35 (A5);
//           its select pins are 2 and 4; a light sensor is a photoresistor to ground and 10 kilohms to 5 V
//   5, 6    speed of the left and the right wheels (PWM); 7, 8 and 9, 10: their directions (L298N)
//   11, 12  the LEDs

#include <Javino.h>

const unsigned long BAUD = 9600;
const unsigned long SILENCE_MS = 1000;

const char *const SIDES[] = {"f", "b", "r", "l"};
const uint8_t DISTANCE_PINS[] = {A0, A1, A2, A3};
const uint8_t LIGHT_PIN = A4;
const uint8_t TEMPERATURE_PIN = A5;
const uint8_t SELECT_LOW = 2;
const uint8_t SELECT_HIGH = 4;

struct Wheels {
  uint8_t speed;
  uint8_t forward;
  uint8_t backward;
};
const Wheels LEFT_WHEELS = {5, 7, 8};
const Wheels RIGHT_WHEELS = {6, 9, 10};
const uint8_t LED_LIGHT = 11;
const uint8_t LED_TEMPERATURE = 12;

Javino javino;
uint8_t power = 200;

void turn(const Wheels &wheels, int direction) {
  digitalWrite(wheels.forward, direction > 0);
  digitalWrite(wheels.backward, direction < 0);
  analogWrite(wheels.speed, direction ? power : 0);
}

void drive(int left, int right) {
  turn(LEFT_WHEELS, left);
  turn(RIGHT_WHEELS, right);
}

void front() { drive(1, 1); }
void back() { drive(-1, -1); }
void left() { drive(-1, 1); }
void right() { drive(1, -1); }
void stop() { drive(0, 0); }

bool speed(const JavinoArguments &arguments) {
  long wanted = arguments.number(0, -1);
  if (wanted < 0 || wanted > 255)
    return false;
  power = static_cast<uint8_t>(wanted);
  return true;
}

void ledLightOn() { digitalWrite(LED_LIGHT, HIGH); }
void ledLightOff() { digitalWrite(LED_LIGHT, LOW); }
void ledTempOn() { digitalWrite(LED_TEMPERATURE, HIGH); }
void ledTempOff() { digitalWrite(LED_TEMPERATURE, LOW); }

int centimetres(uint8_t pin) {
  return static_cast<int>(analogRead(pin) * 127L / 100);
}

int celsius(uint8_t pin) {
  return static_cast<int>(analogRead(pin) * 500L / 1023);
}

void look() {
  javino.describe(F("dist(f|b|r|l, cm 0..650)"));
  javino.describe(F("light(f|b|r|l, 0..1023)"));
  javino.describe(F("temp(f|b|r|l, C 0..150)"));
  // Sensors that the request does not name are not read.
  bool light = javino.wants("light");
  bool temperature = javino.wants("temp");
  for (uint8_t side = 0; side < 4; side++) {
    if (javino.wants("dist"))
      javino.percept("dist", SIDES[side], centimetres(DISTANCE_PINS[side]));
    digitalWrite(SELECT_LOW, side & 1);
    digitalWrite(SELECT_HIGH, side & 2);
    if (light)
      javino.percept("light", SIDES[side], analogRead(LIGHT_PIN));
    if (temperature)
      javino.percept("temp", SIDES[side], celsius(TEMPERATURE_PIN));
  }
}

void setup() {
  const uint8_t outputs[] = {SELECT_LOW, SELECT_HIGH, 5, 6, 7, 8, 9, 10, LED_LIGHT, LED_TEMPERATURE};
  for (uint8_t pin : outputs)
    pinMode(pin, OUTPUT);
  javino.act["front"] = front;
  javino.act["back"] = back;
  javino.act["left"] = left;
  javino.act["right"] = right;
  javino.act["stop"] = stop;
  javino.act["ledLightOn"] = ledLightOn;
  javino.act["ledLightOff"] = ledLightOff;
  javino.act["ledTempOn"] = ledTempOn;
  javino.act["ledTempOff"] = ledTempOff;
  javino.onAction("speed", speed, 1);
  javino.onLinkLost(SILENCE_MS, stop);
  javino.perceive(look);
  javino.watchRules();
  javino.start(BAUD);
}

void loop() {
  javino.run();
}
