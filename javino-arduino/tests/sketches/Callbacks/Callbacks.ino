// Written as sketches for earlier Javino libraries are: functions are named before they are defined, the serial
// port is read in serialEvent(), percepts are made of Strings.
#include <Javino.h>
#define LAMP 13
#define BUTTON 7
Javino javino;
unsigned long startTime;

void serialEvent(){
  javino.readSerial();
}

void setup() {
  pinMode(LAMP, OUTPUT);
  pinMode(BUTTON, INPUT);
  javino.act["lampOn"]  = lampOn;
  javino.act["lampOff"] = lampOff;
  javino.act["startOver"] = startOver;
  javino.perceive(getPerceptions);
  javino.start(9600);
  startTime = millis();
}

void loop() {
  javino.run();
}

void getPerceptions(){
  float half = analogRead(A0) / 2.0;
  javino.addPercept("uptime("+String((millis()-startTime)/1000)+")");
  javino.addPercept("half("+String(half)+")");
  if(digitalRead(LAMP)==1) javino.addPercept("lamp(on)");
  else javino.addPercept("lamp(off)");
  javino.addPercept("name(\"the board\")");
}

void lampOn(){ digitalWrite(LAMP, HIGH); }

void lampOff(){
  digitalWrite(LAMP, LOW);
}

void startOver(){
  startTime = millis();
  javino.clearPercepts();
}
