// The smallest sketch, and the feature that a macro FEATURE_... adds to it. tests/features/table measures the difference.

#include <Javino.h>

#ifdef FEATURE_NO_LIBRARY

void setup() { Serial.begin(9600); }

void loop() {
  if (Serial.available() > 0)
    Serial.write(static_cast<uint8_t>(Serial.read()));
}

#else

Javino javino;
volatile int reading;
volatile float value;

void noAction() { reading = 1; }
void boardAction(JavinoBoard &) { reading = 1; }
void withNumber(const JavinoArguments &arguments) { reading = static_cast<int>(arguments.number(0)); }
#ifndef JAVINO_NO_DECIMALS
void withDecimal(const JavinoArguments &arguments) { value = static_cast<float>(arguments.decimal(0)); }
#endif
void unknown(JavinoBoard &, const char *) { reading = 2; }

#if defined(FEATURE_LATER) || defined(FEATURE_RULES)
JavinoLater outcome;
void follows() { outcome = javino.later(); }
#endif

#ifdef FEATURE_COUNTERS
JavinoCounters counters;
#endif

void look() {
#if defined(FEATURE_DESCRIBE)
  javino.describe(F("light(0..1023)"));
#endif
#if defined(FEATURE_WHOLE) || defined(FEATURE_DESCRIBE) || defined(FEATURE_RULES)
  javino.percept("light", static_cast<int>(reading));
#elif defined(FEATURE_TEXT)
  javino.percept("light", "front", static_cast<int>(reading));
#elif defined(FEATURE_FLASH_TEXT)
  javino.percept(F("light"), F("front"), static_cast<int>(reading));
#elif defined(FEATURE_TWO_DECIMALS)
  javino.percept("light", static_cast<double>(value));
#elif defined(FEATURE_SIX_DECIMALS)
  javino.percept("light", decimals(static_cast<double>(value), 6));
#elif defined(FEATURE_WHOLE_64)
  javino.percept("light", static_cast<long long>(reading));
#elif defined(FEATURE_COUNTERS)
  javino.percept("line", counters.frames, counters.damaged, counters.overruns, counters.longestLoop);
#endif
}

void setup() {
  javino.perceive(look);
#if defined(FEATURE_ACTION)
  javino.act["a"] = noAction;
#elif defined(FEATURE_BOARD_ACTION)
  javino.act["a"] = boardAction;
#elif defined(FEATURE_FLASH_ACTION)
  javino.act[F("a")] = noAction;
#elif defined(FEATURE_NUMBER)
  javino.onAction("a", withNumber, 1);
#elif defined(FEATURE_DECIMAL)
  javino.onAction("a", withDecimal, 1);
#elif defined(FEATURE_UNKNOWN)
  javino.act["a"] = noAction;
  javino.onUnknownAction(unknown);
#elif defined(FEATURE_LATER)
  javino.act["a"] = follows;
#elif defined(FEATURE_LOST)
  javino.onLinkLost(300, noAction);
#elif defined(FEATURE_RULES)
  javino.onAction("a", withNumber, 1);
  javino.watchRules();
#elif defined(FEATURE_COUNTERS)
  javino.countInto(counters);
#endif
  javino.start(9600);
}

void loop() {
  javino.run();
#if defined(FEATURE_LATER)
  if (reading)
    javino.done(outcome);
#endif
}

#endif
