// The example TlsRobot as a program on this machine, with its TLS. Prints its port, and the motor's power when that changes. Ends when its
// input does.

#include <poll.h>
#include <time.h>

#include "TlsRobot.cpp"

FakeSerial Serial;
unsigned long stub_millis = 0;
int stub_pins[40];
WiFiClass WiFi;

static unsigned long now() {
  timespec time;
  clock_gettime(CLOCK_MONOTONIC, &time);
  return static_cast<unsigned long>(time.tv_sec * 1000 + time.tv_nsec / 1000000);
}

int main() {
  int shown = 0;
  pollfd input = {0, POLLIN, 0};
  stub_millis = now();
  setup();
  while (poll(&input, 1, 1) == 0) {
    stub_millis = now();
    loop();
    if (stub_pins[MOTOR] == shown)
      continue;
    shown = stub_pins[MOTOR];
    printf("motor %d\n", shown);
    fflush(stdout);
  }
  return 0;
}
