// Shows which actions it carries out, for a test that damages the line: pin 5 carries the action's number as a
// duty cycle, then pin 13 changes its level.
//   actions   led: 1, ledOn: 2, stop: 3, speed(N): N, which is 10-250
//   percepts  count(N): how many so far
#include <Javino.h>

Javino javino;
unsigned count = 0;

void note(uint8_t action) {
  count++;
  analogWrite(5, action);
  digitalWrite(LED_BUILTIN, count & 1);
}

void led() { note(1); }
void ledOn() { note(2); }
void stop() { note(3); }
bool speed(const JavinoArguments &arguments) {
  long value = arguments.number(0, -1);
  if (arguments.count() != 1 || value < 10 || value > 250)
    return false;
  note(static_cast<uint8_t>(value));
  return true;
}

void look() {
  javino.percept("count", count);
}

void setup() {
  pinMode(5, OUTPUT);
  pinMode(LED_BUILTIN, OUTPUT);
  javino.act["led"] = led;
  javino.act["ledOn"] = ledOn;
  javino.act["stop"] = stop;
  javino.onAction("speed", speed);
  javino.perceive(look);
  javino.start(115200);
}

void loop() {
  javino.run();
}
