// Boards on a network: the example WiFiRobot on stand-ins of its core, and streams of other kinds.

#include <doctest/doctest.h>

#include <BluetoothSerial.h>
#include <Javino.h>
#include <JavinoNetwork.h>
#include <WiFi.h>

#include <string>

#include "frames.h"

WiFiClass WiFi;

namespace sketch {
#include "WiFiRobot.cpp"
}

namespace {

const int MOTOR = 4;
const std::string REQUEST = "fffe0BgetPercepts";

/** The robot as after power-on, on the network. */
struct Robot {
  Robot() {
    stub_millis += 100000;
    stub_pins[MOTOR] = 0;
    if (!isSetUp)
      sketch::setup();
    isSetUp = true;
    sketch::client.stop();
    sketch::javino.removeStream();
    WiFi.state = WL_CONNECTED;
    sketch::loop();
    sketch::speed(JavinoArguments("speed(0)", 8));
  }

  void connect(FakeSerial &computer) {
    sketch::server.next = &computer;
    sketch::loop();
  }

  static bool isSetUp;
};
bool Robot::isSetUp = false;

}  // namespace

TEST_CASE("a computer that connects is answered, each frame in one write") {
  Robot robot;
  FakeSerial computer;
  robot.connect(computer);
  computer.receive(REQUEST);
  sketch::loop();
  CHECK(computer.sent() == "fffe15motor(0);signal(-60);");
  CHECK(computer.writes == 1);
  computer.receive(hello(7));
  sketch::loop();
  computer.receive(command(0, "speed(120)"));
  sketch::loop();
  CHECK(stub_pins[MOTOR] == 120);
  CHECK(computer.writes == 3);
}

TEST_CASE("the newest connection counts") {
  Robot robot;
  FakeSerial first;
  FakeSerial second;
  robot.connect(first);
  first.receive("fffe0Bge");
  sketch::loop();
  robot.connect(second);
  first.receive("tPercepts");
  second.receive(REQUEST);
  sketch::loop();
  CHECK(first.sent() == "");
  CHECK(second.sent() == "fffe15motor(0);signal(-60);");
}

TEST_CASE("the motor stops when the computer is silent, and when the network is gone") {
  Robot robot;
  FakeSerial computer;
  for (bool isGone : {false, true}) {
    WiFi.state = WL_CONNECTED;
    robot.connect(computer);
    computer.receive("fffe0Aspeed(120)" + REQUEST);
    sketch::loop();
    REQUIRE(stub_pins[MOTOR] == 120);
    computer.takes = !isGone;
    if (isGone)
      WiFi.state = WL_DISCONNECTED;
    stub_millis += 999;
    sketch::loop();
    CHECK(stub_pins[MOTOR] == 120);
    stub_millis += 2;
    sketch::loop();
    CHECK(stub_pins[MOTOR] == 0);
  }
}

TEST_CASE("a network that is gone is joined again from time to time, and the server begun anew") {
  Robot robot;
  int tries = WiFi.tries;
  int began = sketch::server.began;
  WiFi.state = WL_DISCONNECTED;
  for (int i = 0; i < 31; i++) {
    stub_millis += 1000;
    sketch::loop();
  }
  CHECK(WiFi.tries - tries >= 2);
  CHECK(WiFi.tries - tries <= 3);
  WiFi.state = WL_CONNECTED;
  sketch::loop();
  CHECK(sketch::server.began == began + 1);
}

TEST_CASE("a message may pause for two seconds, or for as long as is set") {
  stub_millis = 100000;
  FakeSerial far;
  WiFiClient client(&far);
  JavinoNetwork javino(client);
  javino.run();
  for (unsigned long limit : {0, 300}) {
    if (limit)
      javino.setTimeLimit(static_cast<uint16_t>(limit));
    for (unsigned long pause : {limit ? 250 : 1900, limit ? 400 : 2100}) {
      far.receive("fffe0Bget");
      javino.run();
      stub_millis += pause;
      javino.run();
      far.receive("Percepts");
      javino.run();
      CHECK((far.sent() == "fffe00") == (pause == 1900 || pause == 250));
      stub_millis += 5000;
      javino.run();
    }
  }
}

TEST_CASE("an answer that is longer than what is gathered goes out whole, and to nobody if nobody takes it") {
  FakeSerial far;
  WiFiClient client(&far);
  JavinoNetworkSized<1500> javino(client);
  std::string text = "say(" + std::string(640, 'x') + ");";
  far.receive(hello(7));
  javino.run();
  far.sent();
  far.writes = 0;
  CHECK(javino.sendMsg(text.c_str()));
  CHECK(far.out.size() > text.size());
  CHECK(far.writes == 3);
  far.sent();
  far.takes = false;
  CHECK(javino.sendMsg(text.c_str()));
  far.takes = true;
  javino.removeStream();
  CHECK_FALSE(javino.hasStream());
  CHECK(javino.sendMsg(text.c_str()));
  CHECK(far.sent() == "");
}

TEST_CASE("the class for ports takes streams that cannot be opened at a rate") {
  FakeSerial far;
  WiFiClient client(&far);
  BluetoothSerial bluetooth;
  Javino onWiFi(client);
  Javino onBluetooth(bluetooth);
  Javino onPort(far);
  Javino onStream(static_cast<Stream &>(far));
  onWiFi.start();
  onBluetooth.start();
  onStream.begin(1200);
  CHECK(far.baud == 0);
  onPort.begin(19200);
  CHECK(far.baud == 19200);
  far.receive(REQUEST);
  onWiFi.run();
  CHECK(far.sent() == "fffe00");
}

TEST_CASE("a command that is repeated on a new connection is carried out once") {
  static int carried_out;
  struct Counting {
    static void count() { carried_out++; }
  };
  stub_millis += 100000;
  FakeSerial first;
  FakeSerial second;
  JavinoNetwork javino(first);
  javino.act["count"] = Counting::count;
  first.receive(hello(7));
  javino.run();
  first.receive(command(0, "count"));
  javino.run();
  javino.setStream(second);
  second.receive(command(0, "count"));
  javino.run();
  CHECK(carried_out == 1);
  CHECK(second.sent() == ack(1));
}
