// The robot of the stop measurements, with this library. The values of its twelve sensors all change. Compiled with BAUD and LOOP_MS.
//   percepts  dist(Side,Mm)  light(Side,Percent)  temp(Side,Celsius)   Side is f, b, r or l
//   actions   front  stop  ledLightOn  ledLightOff  ledTempOn  ledTempOff
//   A0        the distance in front, 1 mV for a millimetre
//   8         high while it drives; 9 changes with each action, 10 when the sensors are read, 11 at each start
#include <Javino.h>

const uint8_t DRIVES = 8;
const uint8_t ACTED = 9;
const uint8_t LOOKED = 10;
const uint8_t STARTED = 11;

Javino javino;
uint8_t reading = 0;

void toggle(uint8_t pin) {
  digitalWrite(pin, !digitalRead(pin));
}

void look() {
  const char *const sides[] = {"f", "b", "r", "l"};
  toggle(LOOKED);
  reading = (reading + 1) % 90;
  for (uint8_t side = 0; side < 4; side++) {
    javino.percept("dist", sides[side], side == 0 ? analogRead(A0) * 5000L / 1023 : 300L + reading);
    javino.percept("light", sides[side], 60L + 20 * side + reading);
    javino.percept("temp", sides[side], 10L + (reading + side) % 30);
  }
}

void front() {
  digitalWrite(DRIVES, HIGH);
  toggle(ACTED);
}

void stop() {
  digitalWrite(DRIVES, LOW);
  toggle(ACTED);
}

void lamp() {
  toggle(ACTED);
}

void setup() {
  for (uint8_t pin = DRIVES; pin <= STARTED; pin++)
    pinMode(pin, OUTPUT);
  toggle(STARTED);
  javino.act["front"] = front;
  javino.act["stop"] = stop;
  javino.act["ledLightOn"] = lamp;
  javino.act["ledLightOff"] = lamp;
  javino.act["ledTempOn"] = lamp;
  javino.act["ledTempOff"] = lamp;
  javino.perceive(look);
  javino.watchRules();
  javino.start(BAUD);
}

void loop() {
  javino.run();
  delay(LOOP_MS);
}
