// Twelve percepts at 115200 baud and a loop that takes 5 ms.
#include <Javino.h>

Javino javino;
unsigned reading = 0;

void look() {
  const char *const sides[] = {"f", "b", "r", "l"};
  for (uint8_t side = 0; side < 4; side++) {
    javino.percept("dist", sides[side], 100 + reading % 100);
    javino.percept("light", sides[side], 100 + reading % 100);
    javino.percept("temp", sides[side], 10 + reading % 10);
  }
  reading++;
}

void setup() {
  javino.perceive(look);
  javino.start(115200);
}

void loop() {
  javino.run();
  delay(5);
}
