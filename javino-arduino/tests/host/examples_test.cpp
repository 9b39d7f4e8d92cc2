// Examples that the simulated Uno cannot run, on stand-ins: Tasks, whose tasks are carried out by hand, and SecondPort.

#include <doctest/doctest.h>

#include <Javino.h>
#include <freertos/FreeRTOS.h>

#include <string>

#include "frames.h"

std::vector<TaskFunction_t> stub_tasks;

namespace tasks {
#include "Tasks.cpp"
}

namespace second {
#include "SecondPort.cpp"
}

namespace {

const std::string REQUEST = "fffe0BgetPercepts";

/** The example after power-on, with its robot's power. */
struct Tasks {
  Tasks() {
    Serial.in.clear();
    Serial.sent();
    stub_pins[tasks::SENSOR] = 512;
    stub_pins[tasks::MOTOR] = 0;
    if (stub_tasks.empty())
      tasks::setup();
    tasks::stop();
    turn();
    Serial.sent();
  }

  /** One turn of each task. */
  void turn() {
    tasks::serve();
    tasks::control(power);
  }

  uint8_t power = 0;
};

}  // namespace

TEST_CASE("the task of the line hands commands to that of the robot, and its readings to the computer") {
  Tasks board;
  CHECK(stub_tasks == std::vector<TaskFunction_t>{tasks::robotTask, tasks::lineTask});
  Serial.receive("fffe0Aspeed(120)");
  board.turn();
  CHECK(stub_pins[tasks::MOTOR] == 120);
  stub_pins[tasks::SENSOR] = 3100;
  board.turn();
  Serial.receive(REQUEST);
  board.turn();
  CHECK(Serial.sent() == "fffe16dist(3100);motor(120);");
  Serial.receive("fffe0Aspeed(256)");
  board.turn();
  CHECK(stub_pins[tasks::MOTOR] == 120);
}

TEST_CASE("of commands that the robot's task has not come to, the newest counts") {
  Tasks board;
  Serial.receive("fffe0Aspeed(120)fffe0Aspeed(200)fffe04stop");
  for (int i = 0; i < 3; i++)
    tasks::serve();
  tasks::control(board.power);
  CHECK(stub_pins[tasks::MOTOR] == 0);
}

TEST_CASE("the robot's task stops the motor when the computer is silent, and when the line's task hangs") {
  Tasks board;
  for (bool hangs : {false, true}) {
    Serial.receive("fffe0Aspeed(120)");
    board.turn();
    REQUIRE(stub_pins[tasks::MOTOR] == 120);
    stub_millis += hangs ? tasks::HANGS_MS : tasks::SILENCE_MS - 1;
    if (hangs)
      tasks::control(board.power);
    else
      board.turn();
    CHECK(stub_pins[tasks::MOTOR] == 120);
    stub_millis += 2;
    if (hangs)
      tasks::control(board.power);
    else
      board.turn();
    CHECK(stub_pins[tasks::MOTOR] == 0);
  }
}

TEST_CASE("the agent's line is the second port, and the first one is for a person") {
  Serial.in.clear();
  second::setup();
  CHECK(Serial1.baud == 115200);
  Serial.receive(REQUEST);
  Serial1.receive("fffe0Aspeed(120)" + REQUEST);
  second::loop();
  CHECK(stub_pins[second::MOTOR] == 120);
  CHECK(Serial1.sent() == "fffe0Bmotor(120);");
  CHECK(Serial.sent() == "");
  stub_millis += 1001;
  second::loop();
  CHECK(stub_pins[second::MOTOR] == 0);
  Serial.in.clear();
}
