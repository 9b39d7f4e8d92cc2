// A motor on WiFi, for an ESP32, an ESP8266 or a Raspberry Pi Pico W (core of E. F. Philhower). Set the network's name and password
// below, read the board's address on the serial monitor, and let the agent call argo.port("tcp://192.168.1.20:4000").
//
//   actions   speed(0..255)
//   percepts  motor(Speed), signal(Decibels)
//   agent     !start.
//             +!start <- argo.port("tcp://192.168.1.20:4000"); argo.percepts(open); argo.act(speed(120)).
//             +signal(DB) : DB < -80 <- argo.act(speed(0)).
//
// The motor stops after a second without a message. The computer, the network or the router may have failed. A new connection replaces
// the old one, so a computer can reconnect at any time. Javino has no passwords, so anybody on the network can connect. Use a private
// network, or TlsRobot.

#include <JavinoNetwork.h>

#ifdef ESP8266
#include <ESP8266WiFi.h>
#else
#include <WiFi.h>
#endif

const char NETWORK[] = "the name of your network";
const char PASSWORD[] = "its password";
const uint16_t PORT = 4000;
const uint8_t MOTOR = 4;
const unsigned long SILENCE_MS = 1000;
const unsigned long RETRY_MS = 15000;

WiFiServer server(PORT);
WiFiClient client;
JavinoNetwork javino;
uint8_t power = 0;
bool onNetwork = false;
unsigned long tried = 0;

void setMotor(uint8_t value) {
  power = value;
  analogWrite(MOTOR, power);
}

bool speed(const JavinoArguments &arguments) {
  long wanted = arguments.number(0, -1);
  if (wanted < 0 || wanted > 255)
    return false;
  setMotor(static_cast<uint8_t>(wanted));
  return true;
}

void linkLost() {
  setMotor(0);
}

void look() {
  javino.describe(F("motor(0..255)"));
  javino.describe(F("signal(dBm -127..0)"));
  javino.percept("motor", power);
  javino.percept("signal", static_cast<long>(WiFi.RSSI()));
}

void joinNetwork() {
  tried = millis();
  WiFi.begin(NETWORK, PASSWORD);
}

// Watches the network without waiting, so the motor stops in time.
void watchNetwork() {
  bool connected = WiFi.status() == WL_CONNECTED;
  if (connected && !onNetwork) {
    server.begin();
    Serial.println(WiFi.localIP());
  }
  onNetwork = connected;
  if (!connected && millis() - tried > RETRY_MS)
    joinNetwork();
}

void watchConnections() {
  WiFiClient next = server.accept();
  if (next) {
    client.stop();
    client = next;
    client.setNoDelay(true);
    javino.setStream(client);
  }
}

void setup() {
  Serial.begin(115200);
  pinMode(MOTOR, OUTPUT);
  WiFi.mode(WIFI_STA);
  joinNetwork();
  javino.onAction("speed", speed, 1);
  javino.onLinkLost(SILENCE_MS, linkLost);
  javino.perceive(look);
}

void loop() {
  watchNetwork();
  if (onNetwork)
    watchConnections();
  javino.run();
}
