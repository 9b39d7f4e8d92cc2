// A button: when it is pressed, the board sends a percept without a request.
//
//   wiring    a button from pin 3 to GND; the LED of the board
//   actions   ledOn, ledOff
//   percepts  pressed(N) when the button is pressed for the Nth time
//   agent     !start.
//             +!start <- argo.port(ttyACM0, [mode(listen)]); argo.percepts(open).
//             +pressed(N) <- .print("pressed ", N, " times"); argo.act(ledOn).
//
// With mode(listen) the computer sends no requests. Without mode(listen) the agent also requests percepts, and still perceives each
// press. If no computer listens, a percept is lost. This sketch keeps the number of presses in look(), so the agent can still learn of
// lost presses.

#include <Javino.h>

const uint8_t BUTTON = 3;
const unsigned long BOUNCE_MS = 20;

Javino javino;
unsigned int presses = 0;
bool isDown = false;
unsigned long changed = 0;

void ledOn() {
  digitalWrite(LED_BUILTIN, HIGH);
}

void ledOff() {
  digitalWrite(LED_BUILTIN, LOW);
}

void look() {
  javino.percept("pressed", presses);
}

void watchButton() {
  bool isDownNow = digitalRead(BUTTON) == LOW;
  if (isDownNow == isDown || millis() - changed < BOUNCE_MS)
    return;
  changed = millis();
  isDown = isDownNow;
  if (!isDown)
    return;
  presses++;
  look();
  javino.sendPercepts();
}

void setup() {
  pinMode(BUTTON, INPUT_PULLUP);
  pinMode(LED_BUILTIN, OUTPUT);
  javino.act["ledOn"] = ledOn;
  javino.act["ledOff"] = ledOff;
  javino.perceive(look);
  javino.start(9600);
}

void loop() {
  watchButton();
  javino.run();
}
