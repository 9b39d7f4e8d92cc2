// As the first versions were used: the sketch opens Serial itself, and names have no capitals.
#include <Javino.h>
Javino j;
String msg = "";

void setup() {
  pinMode(13, OUTPUT);
  Serial.begin(9600);
}

void loop() {
  if(j.availablemsg()){
    msg = j.getmsg();
    if(msg == "getPercepts") j.sendmsg(getLight() + percept("lamp", digitalRead(13)));
    else if(msg == "lampOn") digitalWrite(13, HIGH);
    else if(msg == "lampOff") digitalWrite(13, LOW);
  }
  msg = "";
}

String getLight () { // a blank stands before the brackets in many sketches
  int light = analogRead(A0);
  return "light("+String(light)+");";
}

  String
  percept(String name, // } a head of several lines, which is not in the first column
          int value)
  {
    return name + "(" + String(value) + ");";
  }
