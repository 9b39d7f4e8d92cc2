// A sketch whose loop() or whose action stalls.
//
//   actions   count, slow(Ms), stall(Ms): every loop() from now on
//   percepts  count(N), longest(Microseconds): the longest run() so far, without those that act or answer,
//            which waits for the line

#include <Javino.h>

Javino javino;
unsigned long stall_ms = 0;
unsigned counted = 0;
unsigned long longest_us = 0;
bool acted_or_answered = false;

void count() {
  counted++;
}

void slow(const JavinoArguments &arguments) {
  counted++;
  acted_or_answered = true;
  delay(arguments.number(0));
}

void stall(const JavinoArguments &arguments) {
  stall_ms = arguments.number(0);
}

void look() {
  acted_or_answered = true;
  javino.percept("count", counted);
  javino.percept("longest", longest_us);
}

void setup() {
  javino.act["count"] = count;
  javino.onAction("slow", slow, 1);
  javino.onAction("stall", stall, 1);
  javino.perceive(look);
  javino.start(9600);
}

void loop() {
  unsigned long begin = micros();
  javino.run();
  unsigned long took = micros() - begin;
  if (took > longest_us && !acted_or_answered)
    longest_us = took;
  acted_or_answered = false;
  delay(stall_ms);
}
