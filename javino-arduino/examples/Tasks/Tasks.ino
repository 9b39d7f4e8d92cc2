// Two tasks of FreeRTOS, which is part of the ESP32's core. The robot's task controls the motor every 10 ms, independent of the line.
// Only the line's task calls the library. One queue carries commands to the robot's task, and another carries readings back. Each queue
// holds only the newest item.
//
//   wiring    a motor's driver at pin 25, a distance sensor with an analogue output at pin 34
//   actions   speed(0..255), stop
//   percepts  dist(Reading), motor(Speed)
//   agent     !start.
//             +!start <- argo.port(ttyUSB0, [baud(115200)]); argo.percepts(open); argo.act(speed(120)).
//             +dist(D) : D > 3000 <- argo.act(stop).
//
// The motor stops after a second without a message from the computer. The robot's task also stops the motor if the line's task has not
// updated `alive` for half a second.

#include <Javino.h>

const uint8_t MOTOR = 25;
const uint8_t SENSOR = 34;
const uint32_t PERIOD_MS = 10;
const uint32_t HANGS_MS = 500;
const unsigned long SILENCE_MS = 1000;
const uint32_t STACK_BYTES = 4096;

struct Reading {
  uint16_t dist;
  uint8_t motor;
};

QueueHandle_t commands;  // holds a uint8_t: the motor's power
QueueHandle_t readings;  // holds a Reading
volatile uint32_t alive; // time in ms at which the line's task last ran

// ---- the robot's task ----

void control(uint8_t &power) {
  xQueueReceive(commands, &power, 0);
  if (millis() - alive > HANGS_MS)
    power = 0;
  analogWrite(MOTOR, power);
  Reading reading = {static_cast<uint16_t>(analogRead(SENSOR)), power};
  xQueueOverwrite(readings, &reading);
}

void robotTask(void *) {
  uint8_t power = 0;
  TickType_t woke = xTaskGetTickCount();
  for (;;) {
    control(power);
    vTaskDelayUntil(&woke, pdMS_TO_TICKS(PERIOD_MS));
  }
}

// ---- the line's task ----

Javino javino;

bool setMotor(uint8_t power) {
  return xQueueOverwrite(commands, &power) == pdPASS;
}

bool speed(const JavinoArguments &arguments) {
  long wanted = arguments.number(0, -1);
  return wanted >= 0 && wanted <= 255 && setMotor(static_cast<uint8_t>(wanted));
}

void stop() {
  setMotor(0);
}

void look() {
  javino.describe(F("dist(0..4095)"));
  javino.describe(F("motor(0..255)"));
  Reading reading;
  if (!xQueuePeek(readings, &reading, 0))
    return;  // no measurement yet
  javino.percept("dist", reading.dist);
  javino.percept("motor", reading.motor);
}

void serve() {
  alive = millis();
  javino.run();
}

void lineTask(void *) {
  for (;;) {
    serve();
    vTaskDelay(1);
  }
}

void setup() {
  pinMode(MOTOR, OUTPUT);
  commands = xQueueCreate(1, sizeof(uint8_t));
  readings = xQueueCreate(1, sizeof(Reading));
  javino.onAction("speed", speed, 1);
  javino.act["stop"] = stop;
  javino.onLinkLost(SILENCE_MS, stop);
  javino.perceive(look);
  javino.start(115200);
  alive = millis();
  xTaskCreatePinnedToCore(robotTask, "robot", STACK_BYTES, NULL, 3, NULL, 1);
  xTaskCreatePinnedToCore(lineTask, "line", STACK_BYTES, NULL, 2, NULL, 1);
}

void loop() {
  vTaskDelete(NULL);
}
