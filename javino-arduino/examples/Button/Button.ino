// A button: the board sends a percept by itself when the button is pressed.
//
//   wiring    a button from pin 3 to GND; the LED of the board
//   actions   ledOn, ledOff
//   percepts  pressed(N) when the button is pressed for the Nth time
//   agent     !start.
//             +!start <- argo.port(ttyACM0, [mode(listen)]); argo.percepts(open).
//             +pressed(N) <- .print("pressed ", N, " times"); argo.act(ledOn).
//
// With mode(listen) the computer asks for nothing. Without it the agent asks too, and still perceives each press. A percept is lost if no
// computer listens. To keep it, write it in look(), like the number of presses here.

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
