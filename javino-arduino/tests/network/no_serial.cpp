// Compiles on a core that has no Serial.
#include <JavinoNetwork.h>

void setUp(Stream &stream) {
  static JavinoNetwork javino(stream);
  javino.setTimeLimit(500);
  javino.run();
}
