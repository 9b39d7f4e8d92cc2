// Messages one by one, without callbacks: the board answers every action with its own text, and a request with the time since the start.
//
//   actions   any
//   percepts  uptime(Seconds)
//   agent     !start.
//             +!start <- argo.port(ttyACM0); argo.percepts(open).
//             +uptime(S) : S > 60 <- .print("the board has been on for a minute").

#include <Javino.h>

Javino javino;

void setup() {
  javino.start(9600);
}

void loop() {
  if (javino.availableMsg()) {
    if (javino.requestPercepts())
      javino.sendMsg("uptime(" + String(millis() / 1000) + ");");
    else
      javino.sendMsg(javino.getMsg());
  }
}
