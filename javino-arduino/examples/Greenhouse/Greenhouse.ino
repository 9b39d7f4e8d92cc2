// A greenhouse: three slow sensors, a pump and a vent.
//
//   percepts  temp(Celsius)  soil(Percent)  light(Level)   Level is 0 (dark) to 1023 (bright)
//             state(pump,on) or state(pump,off)  state(vent,open) or state(vent,closed)
//   actions   set(pump,on)  set(pump,off)  set(vent,open)  set(vent,closed)
//   agent     !start.
//             +!start <- argo.port(ttyACM0); argo.limit(60000); argo.percepts(open).
//             +soil(P) : P < 30 & state(pump,off) <- argo.act(set(pump,on)).
//             +soil(P) : P > 45 & state(pump,on) <- argo.act(set(pump,off)).
//
// The agent in samples/greenhouse also airs, rests at night, limits how often it switches, and obeys a person.
//
// The pump stops after three minutes without a message from the computer, because too much water is worse than too little.
//
// Wiring for an Uno:
//   A0     an LM35: 10 mV a degree
//   A1     a capacitive soil sensor: 3.0 V in dry earth, 1.5 V in wet earth
//   A2     a photoresistor to 5 V and 10 kilohms to ground
//   7, 8   relays of the pump and of the vent's motor

#include <Javino.h>

const unsigned long SILENCE_MS = 180000;

const uint8_t TEMPERATURE = A0;
const uint8_t SOIL = A1;
const uint8_t LIGHT = A2;
const uint8_t PUMP = 7;
const uint8_t VENT = 8;

const int DRY = 614;
const int WET = 307;

Javino javino;

bool isOn(uint8_t pin) {
  return digitalRead(pin) == HIGH;
}

float celsius() {
  return analogRead(TEMPERATURE) * 500.0 / 1023;
}

int soilPercent() {
  long percent = (DRY - analogRead(SOIL)) * 100L / (DRY - WET);
  return percent < 0 ? 0 : percent > 100 ? 100 : static_cast<int>(percent);
}

void look() {
  javino.describe(F("temp(C 0..100)"));
  javino.describe(F("soil(% 0..100)"));
  javino.describe(F("light(0..1023)"));
  javino.describe(F("state(pump|vent, on|off|open|closed)"));
  javino.percept("temp", celsius());
  javino.percept("soil", soilPercent());
  javino.percept("light", analogRead(LIGHT));
  javino.percept("state", "pump", isOn(PUMP) ? "on" : "off");
  javino.percept("state", "vent", isOn(VENT) ? "open" : "closed");
}

// Switches a device to one of its two states. Returns false for any other state.
bool turn(uint8_t pin, const JavinoArguments &arguments, const char *high, const char *low) {
  if (!arguments.is(1, high) && !arguments.is(1, low))
    return false;
  digitalWrite(pin, arguments.is(1, high) ? HIGH : LOW);
  return true;
}

bool set(const JavinoArguments &arguments) {
  if (arguments.is(0, "pump"))
    return turn(PUMP, arguments, "on", "off");
  return arguments.is(0, "vent") && turn(VENT, arguments, "open", "closed");
}

void stopPump() {
  digitalWrite(PUMP, LOW);
}

void setup() {
  pinMode(PUMP, OUTPUT);
  pinMode(VENT, OUTPUT);
  javino.perceive(look);
  javino.onAction("set", set, 2);
  javino.onLinkLost(SILENCE_MS, stopPump);
  javino.start(9600);
}

void loop() {
  javino.run();
}
