// A gripper that closes slowly while the board continues to work. The agent's argo.act(close) returns when the gripper has closed. If
// nothing is between the fingers, argo.act(close) fails.
//
//   actions   open, close
//   percepts  gripper(open), gripper(closing) or gripper(closed)
//   agent     !start.
//             +!start <- argo.port(ttyACM0); argo.percepts(open); !take.
//             +!take <- argo.act(close); .print("I have it").
//             -!take <- .print("there is nothing between the fingers"); argo.act(open).
//
// Other actions wait for the outcome of an action with later(). An action that another action must be able to stop must not call later().

#include <Javino.h>

const uint8_t MOTOR = 5;
const uint8_t FINGERS = 7;  // high while an object is between the fingers
const unsigned long CLOSING_MS = 800;

Javino javino;
const char *state = "open";
unsigned long begun;
JavinoLater closing;

void open() {
  digitalWrite(MOTOR, LOW);
  state = "open";
}

void close() {
  digitalWrite(MOTOR, HIGH);
  state = "closing";
  begun = millis();
  closing = javino.later();
}

void look() {
  javino.describe(F("gripper(open|closing|closed)"));
  javino.percept("gripper", state);
}

void setup() {
  pinMode(MOTOR, OUTPUT);
  pinMode(FINGERS, INPUT);
  javino.act["open"] = open;
  javino.act["close"] = close;
  javino.perceive(look);
  javino.start(9600);
}

void loop() {
  javino.run();
  if (strcmp(state, "closing") == 0 && millis() - begun >= CLOSING_MS) {
    state = "closed";
    javino.done(closing, digitalRead(FINGERS) == HIGH);
  }
}
