// All texts in flash: no heap is linked in.

#include <Javino.h>

Javino javino;
JavinoCounters counters;
uint8_t power;

void ledOn() {
  digitalWrite(LED_BUILTIN, HIGH);
}

void ledOff(JavinoBoard &) {
  digitalWrite(LED_BUILTIN, LOW);
}

bool motor(JavinoBoard &, const JavinoArguments &arguments) {
  if (arguments.is(0, F("full")))
    power = 255;
  else if (arguments.isNumber(0))
    power = static_cast<uint8_t>(arguments.number(0));
  else
    return false;
  return true;
}

void unknown(JavinoBoard &board, const char *) {
  board.addPercept(F("unknown"));
}

void look(JavinoBoard &board) {
  if (board.wants(F("motor")))
    board.percept(F("motor"), F("left"), power);
  board.percept(F("line"), counters.frames, counters.damaged, counters.overruns, counters.longestLoop);
}

void setup() {
  pinMode(LED_BUILTIN, OUTPUT);
  javino.act[F("ledOn")] = ledOn;
  javino.act[F("ledOff")] = ledOff;
  javino.onAction(F("motor"), motor, 1);
  javino.onUnknownAction(unknown);
  javino.countInto(counters);
  javino.perceive(look);
  javino.start(9600);
  javino.sendMsg(F("started;"));
}

void loop() {
  javino.run();
}
