// Runs a sketch on a machine of extras/.
#include <Arduino.h>

void setup();
void loop();

MachineSerial Serial;

int main() {
  machine_start();
  setup();
  for (;;) {
    loop();
    pins_poll();
    machine_sleep();
  }
}
