// The other style of earlier libraries: messages are taken one by one and compared as text.
#include <Javino.h>
Javino javino = Javino();
String strLamp = "off";

void serialEvent(){javino.readSerial();}

void setup() {
  javino.start(9600);
  pinMode(13, OUTPUT);
}

void loop() {
  if(javino.availableMsg()){
    if(javino.requestPercepts()) getPerceptions();
    else if(javino.requestAction("lampOn")) lamp("on");
    else if(javino.requestAction("lampOff")) lamp("off");
    else information(javino.getMsg());
  }
}

void getPerceptions(){
  javino.addPercept("device(testBoard)");
  javino.percept("firmware", F("test board"));
  javino.addPercept("lamp("+strLamp+")");
  javino.sendPercepts();
}

void lamp(String wanted){
  if(wanted=="on") digitalWrite(13, HIGH);
  else digitalWrite(13, LOW);
  strLamp = wanted;
}

void information(String text){
  String strMsg = javino.getMsg();
  if(strMsg == text) javino.sendMsg("heard("+strMsg+");");
}
