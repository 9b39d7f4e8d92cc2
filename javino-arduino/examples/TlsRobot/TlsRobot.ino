// A motor on WiFi that only its owner can use, for an ESP32. The line is encrypted, and the board proves its identity. The board permits
// one certificate. A computer must prove that it has the key of this certificate. Set the network below and make certificates.h.
//
//   wiring    a motor's driver at pin 4
//   actions   speed(0..255)
//   percepts  motor(Speed)
//   agent     !start.
//             +!start <- argo.port("tls://192.168.1.20:4433"); argo.percepts(open); argo.act(speed(120)).
//             +motor(Speed) <- .print("the motor has ", Speed).
//
// A new connection that has proved its identity replaces the connection in use. Any other new connection is refused. An attacker who
// connects repeatedly keeps loop() busy with handshakes, and blocks new connections of the owner. The motor stops after a second without
// a message from the computer. The board has no clock, so it ignores the dates of certificates. WiFiRobot is this robot without TLS.

#include <JavinoNetwork.h>
#include <WiFi.h>

#include "TlsConnection.h"
#include "certificates.h"

const char NETWORK[] = "the name of your network";
const char PASSWORD[] = "its password";
const uint16_t PORT = 4433;
const uint8_t MOTOR = 4;
const unsigned long SILENCE_MS = 1000;
const unsigned long RETRY_MS = 15000;

WiFiServer server(PORT);
TlsIdentity identity;
TlsConnection connections[2];  // the connection in use, and a new connection in its handshake
uint8_t inUse = 0;
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
  javino.percept("motor", power);
}

void joinNetwork() {
  tried = millis();
  WiFi.begin(NETWORK, PASSWORD);
}

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
  TlsConnection &next = connections[1 - inUse];
  WiFiClient client = server.accept();
  if (client) {
    client.setNoDelay(true);
    next.accept(client, identity);
  }
  if (next.hasOpened()) {
    connections[inUse].close();
    inUse = 1 - inUse;
    javino.setStream(next);
  }
}

void setup() {
  Serial.begin(115200);
  pinMode(MOTOR, OUTPUT);
  int error = identity.begin(BOARD_CERTIFICATE, BOARD_KEY, COMPUTER_CERTIFICATE);
  if (error) {
    Serial.print("certificates.h: mbedTLS' error ");
    Serial.println(error);
    while (true)
      delay(1000);
  }
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
